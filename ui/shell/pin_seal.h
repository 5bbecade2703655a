// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

/// What is kept of a PIN instead of the PIN: a password hash made for it (argon2id of libsodium, 16 MiB, 3 passes),
/// some tens of milliseconds for each try.
namespace kerf::ui {

[[nodiscard]] QString sealPin(const QString& pin);
/// No PIN, no seal: an empty seal opens.
[[nodiscard]] bool opensSeal(const QString& seal, const QString& pin);
/// A seal of the first versions ("old:salt:digest", a bare SHA-256) inside a seal of today's; others come back as they
/// are.
[[nodiscard]] QString wrappedSeal(const QString& seal);

/// How long after the last of so many wrong PINs in a row none is looked at, ms: three are free, then 5 s doubling to 5
/// min.
[[nodiscard]] qint64 pinWait_ms(unsigned wrongTries);

}  // namespace kerf::ui
