// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gateway/console_source.h"

#include <QJsonDocument>
#include <cmath>

#include "db/connection.h"
#include "db/location.h"
#include "db/row_io.h"
#include "db/statement.h"

namespace kerf::gateway {
namespace {

constexpr int kLastParts = 12;

QString number(double value, int digits = 10) {
    return QString::number(value, 'g', digits);
}

Value numberOf(const QJsonValue& value, double scale = 1.0) {
    return value.isDouble() ? Value::of(number(value.toDouble() * scale)) : Value{};
}

QString execution(const QJsonObject& live) {
    const QString program = live[QLatin1String("program")].toString();
    if (program == QLatin1String("running")) {
        return live[QLatin1String("feedhold")].toBool() ? QStringLiteral("FEED_HOLD") : QStringLiteral("ACTIVE");
    }
    return program == QLatin1String("paused")     ? QStringLiteral("INTERRUPTED")
           : program == QLatin1String("finished") ? QStringLiteral("PROGRAM_COMPLETED")
           : program == QLatin1String("aborted")  ? QStringLiteral("STOPPED")
                                                  : QStringLiteral("READY");
}

/// Inside, outside, or too near to a limit for the gauge to say (ISO 14253-1).
const char* characteristicStatus(double value, std::optional<double> lower, std::optional<double> upper,
                                 double uncertainty) {
    if (!lower || !upper) {
        return "NOT_ANALYZED";
    }
    if (value < *lower - uncertainty || value > *upper + uncertainty) {
        return "FAIL";
    }
    return value >= *lower + uncertainty && value <= *upper - uncertainty ? "PASS" : "INDETERMINATE";
}

std::string folderOf(const std::string& folder) {
    return folder.empty() ? db::defaultDataFolder() : folder;
}

}  // namespace

ConsoleSource::ConsoleSource(const std::string& dataFolder)
    : m_file(db::databaseFile(folderOf(dataFolder))), m_page(live::livePagePath(folderOf(dataFolder))) {
    (void)m_korean.load(QStringLiteral(":/translations/kerf_ko.qm"));  // without it alarms are said in English
}

ConsoleSource::~ConsoleSource() = default;

std::int64_t ConsoleSource::age_ms() const {
    return m_lastLive_ms == 0 ? -1 : live::monotonic_ms() - m_lastLive_ms;
}

void ConsoleSource::readLive(Observations& observations) {
    const qint64 now = QDateTime::currentMSecsSinceEpoch();
    const auto snapshot = m_page.read();
    const QJsonObject values =
        snapshot ? QJsonDocument::fromJson(QByteArray::fromStdString(snapshot->text)).object() : QJsonObject();
    if (!values.isEmpty()) {
        m_live = values;
        m_lastLive_ms = live::monotonic_ms() - snapshot->age_ms;
    }
    m_silent = values.isEmpty() || snapshot->age_ms > kSilent_ms;
    if (m_silent) {
        observations.setAllUnavailable(now);
        return;
    }
    takeOver(values, observations);
}

void ConsoleSource::takeOver(const QJsonObject& live, Observations& observations) {
    const qint64 now = QDateTime::currentMSecsSinceEpoch();
    const bool link = live[QLatin1String("link")].toBool();
    const auto set = [&](const char* id, const Value& value) { observations.set(id, value, now); };
    const auto live_ = [&](const char* key, double scale = 1.0) {
        return link ? numberOf(live[QLatin1String(key)], scale) : Value{};
    };
    set("avail", Value::of(QStringLiteral("AVAILABLE")));
    set("estop",
        link ? Value::of(live[QLatin1String("estop")].toBool() ? QStringLiteral("TRIGGERED") : QStringLiteral("ARMED"))
             : Value{});
    set("execution", link ? Value::of(execution(live)) : Value{});
    const QString state = live[QLatin1String("program")].toString();
    const bool automatic = state == QLatin1String("running") || state == QLatin1String("paused");
    set("mode", link && automatic ? Value::of(QStringLiteral("AUTOMATIC")) : Value{});
    set("program", link ? Value::of(live[QLatin1String("process")].toString()) : Value{});
    set("feed", live_("feed_mmPerS"));
    set("feedrev", live_("feed_mmPerRev"));
    set("override", live_("override", 100.0));
    set("Cspeed", live_("speed_rpm"));
    set("force", live_("force_N"));
    const QJsonArray position = live[QLatin1String("position_mm")].toArray();
    const QJsonArray drift = live[QLatin1String("drift_um")].toArray();
    const QJsonArray offset = live[QLatin1String("offset_um")].toArray();
    Value offsets{link && !offset.isEmpty(), {}, {{QStringLiteral("KERF"), {}, {}}}, {}};
    for (int i = 0; i < 3; ++i) {
        static constexpr const char* kPosition[] = {"Xpos", "Ypos", "Zpos"};
        static constexpr const char* kDrift[] = {"Xdrift", "Ydrift", "Zdrift"};
        set(kPosition[i], link ? numberOf(position.at(i)) : Value{});
        set(kDrift[i], numberOf(drift.at(i), 1e-3));  // µm → mm
        offsets.entries.front().cells.emplace_back(QString(QChar(u'X' + i)), number(offset.at(i).toDouble() * 1e-3));
    }
    set("offsets", offsets.available ? offsets : Value{});
    const QJsonArray temps = live[QLatin1String("temp_degC")].toArray();
    static constexpr const char* kTemps[] = {"temp1", "temp2", "temp3", "temp4", "temp5", "temp6", "temp7", "temp8"};
    for (int i = 0; i < 8; ++i) {
        set(kTemps[i], numberOf(temps.at(i)));
    }
    set("alarms", m_alarms);
    set("bore", m_bore);
    set("partcount", m_partCount);
    set("partid", m_partId);
    set("asset_chg", m_assets.empty() ? Value{} : Value::of(m_assets.front().id));
}

bool ConsoleSource::readFile(Observations& observations) {
    try {
        if (!m_connection) {
            m_connection = std::make_unique<db::Connection>(m_file, db::Access::Read);
            db::Statement who(m_connection->database(), "SELECT store FROM shop_epochs ORDER BY id DESC LIMIT 1");
            if (who.run().next()) {
                m_device.uuid = QString::fromStdString(who.text(0));
            }
        }
        db::Statement machine(m_connection->database(), "SELECT name FROM machines ORDER BY id DESC LIMIT 1");
        if (machine.run().next() && !machine.text(0).empty()) {
            m_device.name = QString::fromStdString(machine.text(0));
        }
        readParts(observations);
        readAlarms(observations);
        return true;
    } catch (const db::SqlFailure& failure) {
        qWarning("%s", failure.what());
        m_connection.reset();
        m_alarms = m_bore = m_partCount = m_partId = {};
        return false;
    }
}

void ConsoleSource::readParts(Observations&) {
    db::Statement parts(
        m_connection->database(),
        "SELECT p.id, p.process, p.number, coalesce(p.serial, ''), p.complete, p.ended_utc_ms, "
        "coalesce(l.name, ''), coalesce(t.name, ''), "
        "json_extract(r.parameters, '$.\"boring.lower_tolerance_mm\"'), "
        "json_extract(r.parameters, '$.\"boring.upper_tolerance_mm\"'), "
        "coalesce(json_extract(r.parameters, '$.\"boring.sigma_mm\"'), 0) "
        "FROM parts p LEFT JOIN lots l ON l.id = p.lot_id LEFT JOIN part_types t ON t.id = l.part_type_id "
        "LEFT JOIN recipe_revisions r ON r.id = l.recipe_revision_id ORDER BY p.id DESC LIMIT ?");
    parts.bind(kLastParts).run();
    m_lastParts = {};
    m_assets.clear();
    m_bore = m_partCount = m_partId = {};
    while (parts.next()) {
        const std::int64_t id = parts.integer(0);
        const QString part = QStringLiteral("%1/%2/%3")
                                 .arg(QString::fromStdString(parts.text(7)), QString::fromStdString(parts.text(6)))
                                 .arg(parts.integer(2));
        const QString name = parts.text(3).empty() ? part : QString::fromStdString(parts.text(3));
        if (!m_partCount.available) {
            m_partCount = Value::of(QString::number(id));  // parts are never deleted: the newest number is their count
            m_partId = Value::of(name);
        }
        m_assets.push_back({m_device.uuid + QStringLiteral(".part.%1").arg(id), name, parts.integer(5)});
        const auto lower = parts.maybeReal(8);
        const auto upper = parts.maybeReal(9);
        const double uncertainty_mm = 1.96 * parts.real(10);
        db::Statement bores(
            m_connection->database(),
            "SELECT m.station, m.diameter_mm FROM measurements m WHERE m.part_id = ? AND m.kind <> 'void' AND "
            "NOT EXISTS (SELECT 1 FROM measurements n WHERE n.replaces_id = m.id) ORDER BY m.station");
        bores.bind(id).run();
        Value bore;
        QString verdict;
        QJsonArray diameters;
        while (bores.next()) {
            const double diameter_mm = bores.real(1);
            const char* status = characteristicStatus(diameter_mm, lower, upper, uncertainty_mm);
            const QString key = QStringLiteral("D%1").arg(bores.integer(0) + 1);
            bore.available = true;
            bore.entries.push_back(
                {key,
                 {},
                 {{QStringLiteral("CHARACTERISTIC_PERSISTENT_ID"), QString::fromStdString(parts.text(7)) + u'.' + key},
                  {QStringLiteral("MEASUREMENT_VALUE"), number(diameter_mm)},
                  {QStringLiteral("UNCERTAINTY"), number(uncertainty_mm, 6)},
                  {QStringLiteral("CHARACTERISTIC_STATUS"), QLatin1String(status)}}});
            const QString word = qstrcmp(status, "FAIL") == 0   ? QStringLiteral("outside")
                                 : qstrcmp(status, "PASS") == 0 ? QStringLiteral("inside")
                                                                : QStringLiteral("open");
            if (verdict.isEmpty() || word == QLatin1String("outside") ||
                (word == QLatin1String("open") && verdict == QLatin1String("inside"))) {
                verdict = word;
            }
            diameters.append(diameter_mm);
        }
        if (bore.available && !m_bore.available) {
            m_bore = bore;
        }
        m_lastParts.append(QJsonObject{{QStringLiteral("id"), static_cast<qint64>(id)},
                                       {QStringLiteral("name"), name},
                                       {QStringLiteral("process"), QString::fromStdString(parts.text(1))},
                                       {QStringLiteral("complete"), parts.integer(4) != 0},
                                       {QStringLiteral("ended_utc_ms"), static_cast<qint64>(parts.integer(5))},
                                       {QStringLiteral("verdict"), verdict},
                                       {QStringLiteral("diameters_mm"), diameters}});
    }
}

void ConsoleSource::readAlarms(Observations&) {
    db::Statement open(
        m_connection->database(),
        "SELECT code, min(priority), max(detail_text), max(detail_args), min(raised_utc_ms) FROM alarms WHERE "
        "cleared_utc_ms IS NULL GROUP BY code ORDER BY min(priority), code");
    open.run();
    m_alarms = {true, {}, {}, {}};
    m_openAlarms = {};
    while (open.next()) {
        const std::string pattern = open.text(2);
        Sentence sentence(pattern.c_str());
        for (const SentenceArg& arg : db::unpackArgs(open.text(3))) {
            if (sentence.argCount < sentence.args.size()) {
                sentence.args[sentence.argCount++] = arg;
            }
        }
        const QString text = QString::fromStdString(sentence.english());
        const QByteArray korean = m_korean.translate("engine", pattern.c_str()).toUtf8();
        Sentence inKorean = sentence;
        inKorean.text = korean.isEmpty() ? sentence.text : korean.constData();
        m_alarms.conditions.push_back({open.integer(1) == 1 ? QStringLiteral("Fault") : QStringLiteral("Warning"),
                                       QString::number(open.integer(0)), text});
        m_openAlarms.append(QJsonObject{{QStringLiteral("code"), static_cast<qint64>(open.integer(0))},
                                        {QStringLiteral("priority"), static_cast<qint64>(open.integer(1))},
                                        {QStringLiteral("text"), text},
                                        {QStringLiteral("text_ko"), QString::fromStdString(inKorean.english())},
                                        {QStringLiteral("raised_utc_ms"), static_cast<qint64>(open.integer(4))}});
    }
}

QJsonObject ConsoleSource::board() const {
    return {{QStringLiteral("id"), m_device.uuid}, {QStringLiteral("name"), m_device.name},
            {QStringLiteral("silent"), m_silent},  {QStringLiteral("age_ms"), static_cast<qint64>(age_ms())},
            {QStringLiteral("live"), m_live},      {QStringLiteral("alarms"), m_openAlarms},
            {QStringLiteral("parts"), m_lastParts}};
}

}  // namespace kerf::gateway
