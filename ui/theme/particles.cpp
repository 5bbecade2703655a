// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theme/particles.h"

#include <array>

namespace kerf::ui {
namespace {

enum class Ending { Vowel, Rieul, Consonant };

struct Particle {
    QStringView written;
    QStringView afterConsonant;
    QStringView afterVowel;
    QStringView afterRieul;
};
constexpr std::array<Particle, 5> kParticles{{
    {u"이(가)", u"이", u"가", u"이"},
    {u"을(를)", u"을", u"를", u"을"},
    {u"은(는)", u"은", u"는", u"은"},
    {u"와(과)", u"과", u"와", u"과"},
    {u"(으)로", u"으로", u"로", u"로"},
}};

constexpr char16_t kFirstSyllable = 0xAC00;
constexpr char16_t kLastSyllable = 0xD7A3;
constexpr int kFinals = 28;
constexpr int kRieul = 8;

Ending endingOfDigit(char16_t digit) {
    switch (digit) {
        case u'1':
        case u'7':
        case u'8':
            return Ending::Rieul;  // 일 칠 팔
        case u'0':
        case u'3':
        case u'6':
            return Ending::Consonant;  // 영 삼 육
        default:
            return Ending::Vowel;  // 이 사 오 구
    }
}

/// What the text before a particle ends in when it is read aloud.
Ending endingOf(QStringView text) {
    while (!text.isEmpty() && !text.back().isLetterOrNumber() && text.back() != u'%') {
        text.chop(1);  // quotes, brackets, blanks
    }
    if (text.isEmpty()) {
        return Ending::Vowel;
    }
    const char16_t last = text.back().toLower().unicode();
    if (last >= kFirstSyllable && last <= kLastSyllable) {
        const int final = (last - kFirstSyllable) % kFinals;
        return final == 0 ? Ending::Vowel : final == kRieul ? Ending::Rieul : Ending::Consonant;
    }
    if (last >= u'0' && last <= u'9') {
        return endingOfDigit(last);
    }
    switch (last) {
        case u'l':
        case u'r':
            return Ending::Rieul;  // 엘 알
        case u'm':
            return text.endsWith(u"mm") || text.endsWith(u"µm") ? Ending::Vowel : Ending::Consonant;
        case u'n':
            return Ending::Consonant;  // 엔
        default:
            return Ending::Vowel;
    }
}

}  // namespace

QString withParticles(const QString& text) {
    if (!text.contains(u'(')) {
        return text;
    }
    QString out;
    out.reserve(text.size());
    for (qsizetype i = 0; i < text.size();) {
        const QStringView rest = QStringView(text).mid(i);
        const Particle* found = nullptr;
        for (const Particle& particle : kParticles) {
            found = rest.startsWith(particle.written) ? &particle : found;
        }
        if (found == nullptr) {
            out += text[i++];
            continue;
        }
        const Ending ending = endingOf(out);
        out += ending == Ending::Vowel   ? found->afterVowel
               : ending == Ending::Rieul ? found->afterRieul
                                         : found->afterConsonant;
        i += found->written.size();
    }
    return out;
}

}  // namespace kerf::ui
