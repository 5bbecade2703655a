// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

/// Korean on the two-set layout: letters are named by the Latin keys they lie on ("r" is ㄱ, "R" ㄲ, "k" ㅏ).
namespace kerf::ui {

/// Keys of a Korean layout as the Latin ones they lie on, so that "01ㅁ" is "01a"; everything else as it is.
[[nodiscard]] QString latinKeys(const QString& text);

/// What one syllable's keys make: "rks" 간, "r" ㄱ, "hk" ㅘ. Empty when they are no syllable.
[[nodiscard]] QString hangulOf(const QString& keys);

/// Letters typed one by one become syllables.
class HangulComposer {
 public:
    struct Step {
        QString commit{};   ///< finished by this key
        QString preedit{};  ///< the syllable in the making
    };
    /// @param key a letter a … z, or one of Q W E R T O P
    Step type(QChar key);
    /// Takes the last letter back; false: nothing is in the making.
    bool backspace(Step& step);
    /// Ends the syllable.
    QString finish();

 private:
    QString m_keys;
};

}  // namespace kerf::ui
