// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "db/shop/pg_connection.h"

namespace kerf::db {

/// The newest step of the shop's schema this program knows.
[[nodiscard]] int newestShopVersion();

struct ShopSchemaReport {
    int fromVersion{0};
    int toVersion{0};
};

/// Makes schema, roles and rights, or brings them up to date; all or nothing. Two at a time wait for each other.
/// @throws PgFailure
ShopSchemaReport prepareShop(PgConnection& server);

/// May consoles that are not enrolled push? A server for tests may say yes.
void allowUnenrolled(PgConnection& server, bool allowed);

struct Enrolment {
    std::string store{};
    std::string role{};     ///< log-in role, also the common name of the certificate
    std::string console{};  ///< what people call it
};

/// The role a console logs in with.
[[nodiscard]] std::string consoleRole(const std::string& store);

/// Makes the console's role and registers it; once more for the same console changes only its name.
void enrolConsole(PgConnection& server, const Enrolment& enrolment);

}  // namespace kerf::db
