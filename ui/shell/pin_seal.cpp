// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/pin_seal.h"

#include <sodium.h>

#include <QCryptographicHash>
#include <algorithm>
#include <array>

namespace kerf::ui {
namespace {

constexpr unsigned long long kPasses = 3;
constexpr std::size_t kMemory_bytes = 16U << 20U;
constexpr int kOldRounds = 5000;
constexpr unsigned kFreeTries = 3;
constexpr qint64 kFirstWait_ms = 5'000;
constexpr qint64 kLongestWait_ms = 300'000;
const QLatin1String kOld("old:");
const QLatin1String kWrapped("wrapped:");

bool ready() {
    static const bool done = sodium_init() >= 0;
    return done;
}

QString hashed(const QByteArray& secret) {
    std::array<char, crypto_pwhash_STRBYTES> text{};
    const bool made =
        ready() && crypto_pwhash_str(text.data(), secret.constData(), static_cast<unsigned long long>(secret.size()),
                                     kPasses, kMemory_bytes) == 0;
    return made ? QString::fromLatin1(text.data()) : QString();
}

bool fits(const QString& hash, const QByteArray& secret) {
    const QByteArray text = hash.toLatin1();
    return ready() && text.size() < static_cast<qsizetype>(crypto_pwhash_STRBYTES) &&
           crypto_pwhash_str_verify(text.constData(), secret.constData(),
                                    static_cast<unsigned long long>(secret.size())) == 0;
}

/// As the first versions made it.
QByteArray oldDigest(const QString& salt, const QString& pin) {
    QByteArray bytes = (salt + u':' + pin).toUtf8();
    for (int i = 0; i < kOldRounds; ++i) {
        bytes = QCryptographicHash::hash(bytes, QCryptographicHash::Sha256);
    }
    return bytes.toHex();
}

}  // namespace

QString sealPin(const QString& pin) {
    return hashed(pin.toUtf8());
}

bool opensSeal(const QString& seal, const QString& pin) {
    if (seal.isEmpty()) {
        return true;
    }
    if (seal.startsWith(kOld)) {
        return oldDigest(seal.section(u':', 1, 1), pin) == seal.section(u':', 2).toLatin1();
    }
    if (seal.startsWith(kWrapped)) {
        return fits(seal.section(u':', 2), oldDigest(seal.section(u':', 1, 1), pin));
    }
    return fits(seal, pin.toUtf8());
}

QString wrappedSeal(const QString& seal) {
    if (!seal.startsWith(kOld)) {
        return seal;
    }
    return kWrapped + seal.section(u':', 1, 1) + u':' + hashed(seal.section(u':', 2).toLatin1());
}

qint64 pinWait_ms(unsigned wrongTries) {
    if (wrongTries < kFreeTries) {
        return 0;
    }
    const unsigned doublings = std::min(wrongTries - kFreeTries, 10U);
    return std::min(kFirstWait_ms << doublings, kLongestWait_ms);
}

}  // namespace kerf::ui
