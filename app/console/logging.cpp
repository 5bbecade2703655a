// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/logging.h"

#include <spdlog/sinks/rotating_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <QtGlobal>
#include <memory>

namespace kerf::console {
namespace {

constexpr std::size_t kFileSize_bytes = 4U << 20U;
constexpr std::size_t kFiles = 5;

void qtMessage(QtMsgType type, const QMessageLogContext& /*context*/, const QString& message) {
    const std::string text = message.toStdString();
    switch (type) {
        case QtDebugMsg:
            spdlog::debug("{}", text);
            break;
        case QtInfoMsg:
            spdlog::info("{}", text);
            break;
        case QtWarningMsg:
            spdlog::warn("{}", text);
            break;
        case QtCriticalMsg:
        case QtFatalMsg:
            spdlog::critical("{}", text);
            break;
    }
}

}  // namespace

Result<void> startLogging(const std::string& dataDir) {
    std::shared_ptr<spdlog::sinks::rotating_file_sink_mt> file;
    try {
        file = std::make_shared<spdlog::sinks::rotating_file_sink_mt>(dataDir + "/kerf.log", kFileSize_bytes, kFiles);
    } catch (const spdlog::spdlog_ex&) {
        return fail(KERF_TEXT("The log file (kerf.log) cannot be written: check the data folder and its permissions."));
    }
    auto console = std::make_shared<spdlog::sinks::stderr_sink_mt>();
    console->set_level(spdlog::level::warn);
    spdlog::set_default_logger(std::make_shared<spdlog::logger>("kerf", spdlog::sinks_init_list{file, console}));
    spdlog::flush_on(spdlog::level::info);
    qInstallMessageHandler(qtMessage);
    return {};
}

}  // namespace kerf::console
