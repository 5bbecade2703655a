// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QTimer>
#include <optional>

#include "ui/services/quality_service.h"
#include "ui/shell/page.h"

namespace kerf::ui {

/// The newest finished part of a process in a word, as the Boring page says it of a bore: good, rework possible, scrap,
/// not judged, and of a bad one the figure that is out. Object name lastVerdict.
class LastVerdict : public QLabel {
    Q_OBJECT
 public:
    LastVerdict(const PageContext& context, ProcessId process, QWidget* parent);
    /// Looks at the newest part, and says it in the present language and unit.
    void refresh();

 protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

 private:
    void look();
    [[nodiscard]] QString words() const;

    PageContext m_context;
    ProcessId m_process;
    std::optional<PartRow> m_part{};
    PartJudgement m_judgement{};
    std::vector<Characteristic> m_characteristics{};
    QTimer m_timer{};
};

}  // namespace kerf::ui
