// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QPushButton>

#include "engine/api/engine_api.h"
#include "ui/services/boring_service.h"
#include "ui/shell/operator_session.h"
#include "ui/widgets/face_widget.h"
#include "ui/widgets/lamp.h"

namespace kerf::ui {

/// The top line: machine ▸ part type ▸ lot ▸ part, link, simulator speed, clock, operator, language, settings.
class HeaderBar : public FaceWidget {
    Q_OBJECT
 public:
    HeaderBar(Look& look, OperatorSession& session, QWidget* parent = nullptr);

    void setStatus(const Status& status, const Capabilities& capabilities);
    void setWork(const BoringServiceView* view, const Status& status);
    void setTime(const QString& clock);
    /// Lots can be opened and closed here.
    void setLots(bool there) { m_lots->setVisible(there); }
    void setHelp(bool on) { m_help->setChecked(on); }

 signals:
    void lotsRequested();
    void operatorRequested();
    void speedRequested();
    void settingsRequested();
    void languageRequested();
    /// The next touch is to be explained, or not after all.
    void helpRequested(bool on);

 protected:
    void refresh() override;

 private:
    void rebuild();

    OperatorSession& m_session;
    QLabel* m_path;
    QPushButton* m_lots;
    Lamp* m_link;
    QPushButton* m_speed;
    QLabel* m_clock;
    QPushButton* m_operator;
    QPushButton* m_language;
    QPushButton* m_help;
    QPushButton* m_settings;
    QString m_machine;
    QStringList m_work;
    LinkState m_linkState{LinkState::Down};
    bool m_machineOn{false};
    bool m_emergencyStop{false};
    bool m_simulated{false};
    double m_factor{1.0};
};

}  // namespace kerf::ui
