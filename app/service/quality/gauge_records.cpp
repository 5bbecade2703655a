// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/quality/gauge_records.h"

#include <cstdlib>
#include <nlohmann/json.hpp>

namespace kerf {
namespace {

constexpr double kMostOfTolerance_percent = 30.0;
constexpr double kLargestGauge_mm = 10'000.0;

struct OptionalFigure {
    const char* key;
    std::optional<double> StudyFigures::*member;
};
constexpr OptionalFigure kOptionalFigures[] = {{"cg", &StudyFigures::cg},
                                               {"cgk", &StudyFigures::cgk},
                                               {"grr_percent", &StudyFigures::grr_percent},
                                               {"grr_of_tolerance_percent", &StudyFigures::grrOfTolerance_percent}};

}  // namespace

std::string gaugeJson(const Gauge& gauge) {
    nlohmann::ordered_json json{{"description", gauge.description}, {"range_from_mm", gauge.rangeFrom_mm},
                                {"range_to_mm", gauge.rangeTo_mm},  {"resolution_mm", gauge.resolution_mm},
                                {"ring_mm", gauge.ring_mm},         {"due_utc_ms", gauge.dueUtc_ms},
                                {"identity", gauge.identity}};
    if (gauge.sigma_mm) {
        json["sigma_mm"] = *gauge.sigma_mm;
        json["sigma_low_mm"] = gauge.sigmaLow_mm;
        json["sigma_high_mm"] = gauge.sigmaHigh_mm;
        json["pass"] = gauge.pass;
        json["sigma_from"] = gauge.sigmaFrom;
    }
    if (gauge.study) {
        nlohmann::ordered_json study{{"method", gauge.study->method},
                                     {"readings", gauge.study->readings},
                                     {"tolerance_mm", gauge.study->tolerance_mm},
                                     {"ndc", gauge.study->ndc},
                                     {"author", gauge.study->author},
                                     {"utc_ms", gauge.study->utc_ms}};
        for (const auto& [key, member] : kOptionalFigures) {
            if (const auto& figure = (*gauge.study).*member) {
                study[key] = *figure;
            }
        }
        json["study"] = std::move(study);
    }
    return json.dump();
}

std::optional<Gauge> gaugeFromJson(const std::string& text) {
    try {
        const auto json = nlohmann::json::parse(text);
        Gauge gauge;
        gauge.identity = json.at("identity").get<std::string>();
        gauge.description = json.value("description", "");
        gauge.rangeFrom_mm = json.value("range_from_mm", 0.0);
        gauge.rangeTo_mm = json.value("range_to_mm", 0.0);
        gauge.resolution_mm = json.value("resolution_mm", gauge.resolution_mm);
        gauge.ring_mm = json.value("ring_mm", 0.0);
        gauge.dueUtc_ms = json.value("due_utc_ms", std::int64_t{0});
        if (json.contains("sigma_mm")) {
            gauge.sigma_mm = json.at("sigma_mm").get<double>();
            gauge.sigmaLow_mm = json.value("sigma_low_mm", 0.0);
            gauge.sigmaHigh_mm = json.value("sigma_high_mm", 0.0);
            gauge.pass = json.value("pass", false);
            gauge.sigmaFrom = json.value("sigma_from", "");
        }
        if (json.contains("study")) {
            const auto& study = json.at("study");
            StudyFigures& figures = gauge.study.emplace();
            figures.method = study.value("method", "");
            figures.readings = study.value("readings", 0U);
            figures.tolerance_mm = study.value("tolerance_mm", 0.0);
            figures.ndc = study.value("ndc", 0U);
            figures.author = study.value("author", "");
            figures.utc_ms = study.value("utc_ms", std::int64_t{0});
            for (const auto& [key, member] : kOptionalFigures) {
                if (study.contains(key)) {
                    figures.*member = study.at(key).get<double>();
                }
            }
        }
        return gauge;
    } catch (const nlohmann::json::exception&) {
        return std::nullopt;
    }
}

std::optional<Sentence> whyInvalid(const Gauge& gauge) {
    if (gauge.identity.empty()) {
        return Sentence(KERF_TEXT("A gauge needs an identity."));
    }
    if (!(gauge.resolution_mm > 0.0 && gauge.resolution_mm <= 1.0)) {
        return Sentence(KERF_TEXT("The resolution of a gauge lies above 0 and at most 1 mm."));
    }
    const bool inRange = gauge.rangeFrom_mm >= 0.0 && gauge.rangeTo_mm <= kLargestGauge_mm;
    if (!inRange || !(gauge.rangeFrom_mm < gauge.rangeTo_mm)) {
        return Sentence(KERF_TEXT("The range of a gauge must begin below its end, between 0 and 10000 mm."));
    }
    if (gauge.ring_mm != 0.0 && (gauge.ring_mm < gauge.rangeFrom_mm || gauge.ring_mm > gauge.rangeTo_mm)) {
        return Sentence(KERF_TEXT("The setting ring must lie in the range of the gauge."));
    }
    return std::nullopt;
}

void takeOver(const GaugeStudyRecord& study, const StudyFinding& finding, Gauge& gauge) {
    gauge.sigma_mm = finding.sigma_mm;
    gauge.sigmaLow_mm = finding.low_mm;
    gauge.sigmaHigh_mm = finding.high_mm;
    gauge.pass = finding.pass;
    gauge.sigmaFrom = study.method;
    StudyFigures& figures = gauge.study.emplace();
    figures.method = study.method;
    figures.readings = static_cast<std::uint32_t>(study.readings.size());
    figures.tolerance_mm = study.tolerance_mm;
    figures.author = study.author;
    figures.utc_ms = study.utc_ms;
    if (finding.typeOne) {
        figures.cg = finding.typeOne->cg;
        figures.cgk = finding.typeOne->cgk;
    }
    if (finding.crossed) {
        figures.grr_percent = finding.crossed->grrPercent;
        figures.grrOfTolerance_percent = finding.crossed->grrPercentOfTolerance;
        figures.ndc = finding.crossed->ndc;
    }
}

Result<StudyFinding> findingOf(const GaugeStudyRecord& study, double ring_mm) {
    StudyFinding finding;
    if (study.method == "type1") {
        std::vector<double> readings;
        for (const quality::StudyReading& reading : study.readings) {
            readings.push_back(reading.value);
        }
        const auto result =
            quality::typeOneStudy(readings, study.tolerance_mm, ring_mm > 0.0 ? std::optional(ring_mm) : std::nullopt);
        if (!result) {
            return tl::unexpected(result.error());
        }
        finding = {result->deviation, result->deviationLow, result->deviationHigh, result->pass, *result, {}};
        return finding;
    }
    const auto method = study.method == "anova" ? quality::StudyMethod::Anova : quality::StudyMethod::AverageRange;
    const auto result = quality::crossedStudy(study.readings, method, study.tolerance_mm);
    if (!result) {
        return tl::unexpected(result.error());
    }
    if (!(result->ev > 0.0)) {
        return fail(KERF_TEXT("All repeated readings are alike: the gauge is stuck, or too coarse for a study."));
    }
    finding = {result->ev,
               result->evLow,
               result->evHigh,
               result->grrPercentOfTolerance.value_or(result->grrPercent) <= kMostOfTolerance_percent,
               {},
               *result};
    return finding;
}

std::string studyJson(const GaugeStudyRecord& study, const StudyFinding& finding) {
    nlohmann::ordered_json json{
        {"gauge", study.gauge},         {"method", study.method},         {"tolerance_mm", study.tolerance_mm},
        {"sigma_mm", finding.sigma_mm}, {"sigma_low_mm", finding.low_mm}, {"sigma_high_mm", finding.high_mm},
        {"pass", finding.pass}};
    if (finding.typeOne) {
        json["cg"] = finding.typeOne->cg;
        if (finding.typeOne->cgk) {
            json["cgk"] = *finding.typeOne->cgk;
        }
    }
    if (finding.crossed) {
        json["ev_mm"] = finding.crossed->ev;
        json["av_mm"] = finding.crossed->av;
        json["interaction_mm"] = finding.crossed->interaction;
        json["pv_mm"] = finding.crossed->pv;
        json["tv_mm"] = finding.crossed->tv;
        json["grr_mm"] = finding.crossed->grr;
        json["grr_percent"] = finding.crossed->grrPercent;
        json["ndc"] = finding.crossed->ndc;
    }
    json["readings"] = nlohmann::ordered_json::array();
    for (const quality::StudyReading& reading : study.readings) {
        json["readings"].push_back({reading.part, reading.person, reading.trial, reading.value});
    }
    return json.dump();
}

std::map<PartId, Disposition> dispositionsIn(RoomRecordReader& records) {
    std::map<PartId, Disposition> decided;
    for (const ProcessId process : allProcesses()) {
        const auto rows = records.newestRoomRecords(process, kDispositionRecord);
        for (const RoomRecordRow& row : rows ? *rows : std::vector<RoomRecordRow>{}) {
            const auto json = nlohmann::json::parse(row.bodyJson, nullptr, false);
            if (json.is_object() && json.contains("what")) {
                decided.insert_or_assign(std::atoll(row.subject.c_str()),
                                         Disposition{json.value("what", ""), row.author, row.createdUtc_ms});
            }
        }
    }
    return decided;
}

}  // namespace kerf
