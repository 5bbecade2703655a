// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QTableWidget>
#include <cstdint>

#include "ui/services/sensor_setup.h"
#include "ui/shell/page.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/card.h"

namespace kerf::ui {

/// Which sensor file this console reads, and what answers on the machine's network: what the Sensors page shows where
/// there is no sensor file, and in a sheet where there is one. By touch.
class SensorSetupPanel : public FaceWidget {
    Q_OBJECT
 public:
    SensorSetupPanel(const PageContext& context, SensorSetup& setup, QWidget* parent);

 protected:
    void refresh() override;
    void showEvent(QShowEvent* event) override;

 private:
    void build();
    void show();
    void showFiles(const SensorSetupView& view);
    void showFound(const SensorSetupView& view);
    void choose(const QString& name);
    void scan();
    [[nodiscard]] const SensorFileView* selected() const;
    [[nodiscard]] QString whyNotChosen() const;

    PageContext m_context;
    SensorSetup& m_setup;
    std::uint64_t m_shown{0};
    Card* m_fileCard;
    Card* m_scanCard;
    QLabel* m_what;
    QLabel* m_now;
    QTableWidget* m_files;
    ActionButton* m_choose;
    ActionButton* m_none;
    ActionButton* m_again;
    QLabel* m_ask;
    QLineEdit* m_address;
    ActionButton* m_scan;
    QTableWidget* m_found;
    QLabel* m_answer;
};

}  // namespace kerf::ui
