// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/setup_keys.h"

#include <fmt/format.h>

#include <QLoggingCategory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

namespace kerf {
namespace {

Q_LOGGING_CATEGORY(kerfSetups, "kerf.setups", QtInfoMsg)

void sayOnce(const std::string& sentence) {
    static std::mutex guard;
    static std::set<std::string> said;
    const std::scoped_lock lock(guard);
    if (said.insert(sentence).second) {
        qCInfo(kerfSetups, "%s", sentence.c_str());
    }
}

}  // namespace

double numberOr(const nlohmann::json& setup, const char* key, double fallback, const char* what) {
    const auto found = setup.find(key);
    if (!setup.is_object()) {
        return setup.at(key).get<double>();  // throws
    }
    if (found == setup.end()) {
        sayOnce(fmt::format("a stored {} has no {}: its default {} holds", what, key, fallback));
        return fallback;
    }
    return found->get<double>();
}

}  // namespace kerf
