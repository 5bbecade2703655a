// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QProcess>
#include <functional>
#include <memory>
#include <string>

#include "app/console/background.h"
#include "app/service/rights.h"
#include "db/api/store_writer.h"
#include "ui/services/sensor_setup.h"

namespace kerf::console {

/// The sensor file that was chosen on the screen, a setting; and `kerf sensors scan` beside this program.
class SensorChoice final : public QObject, public SensorSetup {
 public:
    static constexpr const char* kSetting = "sensors.file";

    struct Links {
        StoreWriter& writer;
        Rights rights{};
        std::string folder{};  ///< of sensor files
        std::string chosen{};  ///< name in that folder; empty: none
        std::string inUse{};
        bool byCommandLine{false};
    };
    explicit SensorChoice(Links links);
    ~SensorChoice() override;

    [[nodiscard]] const SensorSetupView& view() const override { return m_view; }
    void lookForFiles() override;
    [[nodiscard]] Result<void> choose(const std::string& name, const std::string& author) override;
    [[nodiscard]] Result<void> scan(const std::string& address, const std::string& author) override;

 private:
    void takeFiles(std::vector<SensorFileView> files);
    void scanEnded(bool wellEnded);

    Links m_links;
    SensorSetupView m_view{};
    QProcess m_scan{};
    std::shared_ptr<bool> m_alive{std::make_shared<bool>(true)};  ///< an answer of the writer may come later
    Background m_background;                                      ///< last: waits for its thread before the rest goes
};

}  // namespace kerf::console
