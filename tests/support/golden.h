// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace kerf::test {

/// Path of a file under tests/fixtures.
inline std::string fixture(const std::string& name) {
    const char* folder = std::getenv("KERF_FIXTURES");
    return std::string(folder != nullptr ? folder : "tests/fixtures") + "/" + name;
}

inline nlohmann::json loadGolden(const std::string& name) {
    std::ifstream file(fixture("golden/" + name));
    return nlohmann::json::parse(file);
}

/// |actual − expected| ≤ tolerance·max(1, |expected|): how the reference vectors are compared.
inline bool closeTo(double actual, double expected, double tolerance = 1e-9) {
    return std::abs(actual - expected) <= tolerance * std::max(1.0, std::abs(expected));
}

}  // namespace kerf::test

/// QVERIFY with both numbers in the message.
#define KERF_CLOSE(actual, expected, tolerance)                                      \
    do {                                                                             \
        const double kerfActual = (actual);                                          \
        const double kerfExpected = (expected);                                      \
        if (!kerf::test::closeTo(kerfActual, kerfExpected, tolerance)) {             \
            QFAIL(qPrintable(QStringLiteral("%1 is %2, expected %3 (difference %4)") \
                                 .arg(QStringLiteral(#actual))                       \
                                 .arg(kerfActual, 0, 'g', 17)                        \
                                 .arg(kerfExpected, 0, 'g', 17)                      \
                                 .arg(kerfActual - kerfExpected)));                  \
        }                                                                            \
    } while (false)
