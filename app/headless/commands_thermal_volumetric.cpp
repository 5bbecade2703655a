// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>

#include "app/files/json_document.h"
#include "app/files/output.h"
#include "app/files/table.h"
#include "app/headless/thermal_commands.h"
#include "engine/process/thermal/volumetric.h"

namespace kerf::headless {
namespace {

using Json = nlohmann::ordered_json;
using namespace thermal;

/// Reads one cases file and complains with file and place inside it.
class CaseReader {
 public:
    explicit CaseReader(std::string path) : m_path(std::move(path)) {}

    [[noreturn]] void complain(const std::string& where, const char* expected) const {
        throw BadInput(fmt::format("{}, {}: expected {}.", m_path, where, expected));
    }
    Eigen::Vector3d vector(const Json& parent, const char* key, const std::string& where) const {
        const std::string place = where + "." + key;
        if (!parent.is_object() || !parent.contains(key)) {
            complain(place, "three numbers");
        }
        const Json& value = parent[key];
        if (!value.is_array() || value.size() != 3) {
            complain(place, "three numbers");
        }
        Eigen::Vector3d out;
        for (int axis = 0; axis < 3; ++axis) {
            const Json& number = value[static_cast<std::size_t>(axis)];
            if (!number.is_number() || !std::isfinite(number.get<double>())) {
                complain(place, "three finite numbers");
            }
            out[axis] = number.get<double>();
        }
        return out;
    }
    VolumetricChain chain(const Json& input, const std::string& where) const {
        VolumetricChain out;
        out.position_mm = vector(input, "xyz", where);
        for (const auto& [key, count] : {std::pair("shape", 4U), std::pair("joint", 3U)}) {
            if (!input.contains(key) || !input[key].is_array() || input[key].size() != count) {
                complain(where + "." + key, count == 4U ? "four shape links" : "three joint links, Z Y X");
            }
        }
        for (std::size_t link = 0; link < 4; ++link) {
            const std::string place = fmt::format("{}.shape[{}]", where, link);
            out.shape_mm[link] = vector(input["shape"][link], "d", place);
            out.shapeError[link] = {vector(input["shape"][link], "e", place), vector(input["shape"][link], "w", place)};
        }
        for (std::size_t link = 0; link < 3; ++link) {
            const std::string place = fmt::format("{}.joint[{}]", where, link);
            out.jointError[link] = {vector(input["joint"][link], "e", place), vector(input["joint"][link], "w", place)};
        }
        return out;
    }

 private:
    std::string m_path;
};

void volumetric(const std::string& path, const std::string& mode) {
    const Json file =
        files::readJsonFile(path, "a list of cases, or an object with the list 'cases' or 'random_cases'");
    const char* key = file.is_object() && file.contains("cases") ? "cases" : "random_cases";
    const bool bare = file.is_array();
    if (!bare && (!file.is_object() || !file.contains(key) || !file[key].is_array())) {
        throw BadInput(
            fmt::format("{}: expected a list of cases, or an object with the list 'cases' or 'random_cases'.", path));
    }
    const Json& cases = bare ? file : file[key];
    const CaseReader reader(path);
    Json errors = Json::array();
    for (std::size_t k = 0; k < cases.size(); ++k) {
        const std::string where = fmt::format("{}[{}]", bare ? "case" : key, k);
        const bool wrapped = cases[k].is_object() && cases[k].contains("input");
        const VolumetricChain chain = reader.chain(wrapped ? cases[k]["input"] : cases[k], where);
        const Eigen::Vector3d error = mode == "exact" ? exactError_mm(chain) : firstOrderError_mm(chain);
        errors.push_back({{"e", {error.x(), error.y(), error.z()}}});
    }
    printJson({{"mode", mode}, {"unit", "mm"}, {"cases", std::move(errors)}});
}

}  // namespace

void addThermalVolumetric(CLI::App& thermal) {
    auto* command =
        thermal.add_subcommand("volumetric", "Error of the cutting point from error elements of the axes, as JSON.");
    auto arguments = std::make_shared<std::array<std::string, 2>>();
    (*arguments)[1] = "exact";
    command->add_option("--cases", (*arguments)[0], "JSON: list of {xyz, shape[4]{d,e,w}, joint[3]{e,w}} in mm and rad")
        ->required();
    command->add_option("--mode", (*arguments)[1], "exact transforms, or first order in the errors")
        ->check(CLI::IsMember({"exact", "first-order"}))
        ->capture_default_str();
    command->callback([arguments] { volumetric((*arguments)[0], (*arguments)[1]); });
}

}  // namespace kerf::headless
