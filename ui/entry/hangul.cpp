// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/entry/hangul.h"

#include <algorithm>
#include <array>

namespace kerf::ui {
namespace {

// The 33 keys of the two-set layout, compound letters as the keys that make them.
constexpr std::array<const char*, 51> kJamo{"r",  "R",  "rt", "s",  "sw", "sg", "e", "E", "f",  "fr", "fa",
                                            "fq", "ft", "fx", "fv", "fg", "a",  "q", "Q", "qt", "t",  "T",
                                            "d",  "w",  "W",  "c",  "z",  "x",  "v", "g",  // U+3131 …
                                            "k",  "o",  "i",  "O",  "j",  "p",  "u", "P", "h",  "hk", "ho",
                                            "hl", "y",  "n",  "nj", "np", "nl", "b", "m", "ml", "l"};
constexpr std::array<const char*, 19> kInitial{"r", "R", "s", "e", "E", "f", "a", "q", "Q", "t",
                                               "T", "d", "w", "W", "c", "z", "x", "v", "g"};
constexpr std::array<const char*, 21> kVowel{"k",  "o", "i", "O",  "j",  "p",  "u", "P", "h",  "hk", "ho",
                                             "hl", "y", "n", "nj", "np", "nl", "b", "m", "ml", "l"};
constexpr std::array<const char*, 28> kFinal{"",   "r",  "R",  "rt", "s",  "sw", "sg", "e", "f",  "fr",
                                             "fa", "fq", "ft", "fx", "fv", "fg", "a",  "q", "qt", "t",
                                             "T",  "d",  "w",  "c",  "z",  "x",  "v",  "g"};

constexpr char16_t kFirstJamo = 0x3131;
constexpr char16_t kFirstSyllable = 0xAC00;

template <class Table>
int indexOf(const Table& table, const QString& keys) {
    const auto found =
        std::find_if(table.begin(), table.end(), [&](const char* one) { return keys == QLatin1String(one); });
    return found == table.end() ? -1 : static_cast<int>(found - table.begin());
}

/// Keys without a meaning of their own with Shift are as without.
QChar plainKey(QChar key) {
    return QStringLiteral("QWERTOP").contains(key) ? key : key.toLower();
}

bool isVowel(QChar key) {
    return indexOf(kVowel, QString(key)) >= 0;
}

}  // namespace

QString latinKeys(const QString& text) {
    QString out;
    for (const QChar c : text) {
        const char16_t code = c.unicode();
        QString keys;
        if (code >= 0x3131 && code < 0x3131 + kJamo.size()) {
            keys = QLatin1String(kJamo[code - 0x3131U]);
        } else if (code >= 0xAC00 && code <= 0xD7A3) {
            const unsigned at = code - 0xAC00U;
            keys = QLatin1String(kInitial[at / 588U]) + QLatin1String(kVowel[at % 588U / 28U]) +
                   QLatin1String(kFinal[at % 28U]);
        } else {
            out += c;
            continue;
        }
        out += keys;
    }
    return out;
}

QString hangulOf(const QString& keys) {
    const int initial = indexOf(kInitial, keys.left(1));
    if (initial < 0 || keys.size() == 1) {  // a letter alone, or two that make one
        const int jamo = indexOf(kJamo, keys);
        return jamo < 0 ? QString() : QString(QChar(static_cast<char16_t>(kFirstJamo + jamo)));
    }
    for (const qsizetype length : {2, 1}) {
        const int vowel = indexOf(kVowel, keys.mid(1, length));
        if (vowel < 0 || keys.mid(1, length).size() != length) {
            continue;
        }
        const int last = indexOf(kFinal, keys.mid(1 + length));
        if (last >= 0) {
            return QString(QChar(static_cast<char16_t>(kFirstSyllable + (initial * 21 + vowel) * 28 + last)));
        }
    }
    return {};
}

HangulComposer::Step HangulComposer::type(QChar key) {
    const QChar plain = plainKey(key);
    const QString longer = m_keys + plain;
    if (const QString whole = hangulOf(longer); !whole.isEmpty()) {
        m_keys = longer;
        return {{}, whole};
    }
    Step step;
    // A vowel takes the consonant before it along: 간 and ㅏ are 가나.
    if (isVowel(plain) && m_keys.size() > 2 && !isVowel(m_keys.back())) {
        step.commit = hangulOf(m_keys.chopped(1));
        m_keys = m_keys.right(1) + plain;
    } else {
        step.commit = hangulOf(m_keys);
        m_keys = plain;
    }
    step.preedit = hangulOf(m_keys);
    return step;
}

bool HangulComposer::backspace(Step& step) {
    if (m_keys.isEmpty()) {
        return false;
    }
    m_keys.chop(1);
    step = {{}, hangulOf(m_keys)};
    return true;
}

QString HangulComposer::finish() {
    const QString whole = hangulOf(m_keys);
    m_keys.clear();
    return whole;
}

}  // namespace kerf::ui
