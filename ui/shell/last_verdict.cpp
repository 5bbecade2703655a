// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/last_verdict.h"

#include <QEvent>
#include <QPointer>
#include <algorithm>

#include "db/api/part_reader.h"
#include "ui/link/texts.h"
#include "ui/link/verdict_text.h"

namespace kerf::ui {
namespace {
constexpr int kLook_ms = 500;  // a part comes every few seconds at most
}  // namespace

LastVerdict::LastVerdict(const PageContext& context, ProcessId process, QWidget* parent)
    : QLabel(parent), m_context(context), m_process(process) {
    setObjectName(QStringLiteral("lastVerdict"));
    setVisible(m_context.services.qualityService != nullptr && m_context.services.parts != nullptr);
    m_timer.setInterval(kLook_ms);
    connect(&m_timer, &QTimer::timeout, this, [this] {
        if (isVisible()) {
            look();
        }
    });
    m_timer.start();
    if (m_context.services.qualityService != nullptr) {
        m_context.services.qualityService->onChanged([label = QPointer<LastVerdict>(this)] {
            if (LastVerdict* const shown = label.data(); shown != nullptr && shown->isVisible()) {
                shown->refresh();  // other limits
            }
        });
    }
    connect(&m_context.look, &Look::changed, this, [this] { setText(words()); });
}

void LastVerdict::showEvent(QShowEvent* event) {
    QLabel::showEvent(event);
    refresh();
}

void LastVerdict::changeEvent(QEvent* event) {
    QLabel::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        setText(words());
    }
}

void LastVerdict::refresh() {
    m_part.reset();
    look();
}

void LastVerdict::look() {
    const Services& services = m_context.services;
    if (services.qualityService == nullptr || services.parts == nullptr) {
        return;
    }
    PartQuery query;
    query.process = m_process;
    query.limit = 1;
    const auto newest = services.parts->parts(query);
    if (!newest || newest->empty()) {
        m_part.reset();
    } else if (!m_part || m_part->id != newest->front().id) {
        m_part = newest->front();
        m_judgement = services.qualityService->judge(*m_part);
        m_characteristics = services.qualityService->characteristics(*m_part);
    } else {
        return;
    }
    setText(words());
}

QString LastVerdict::words() const {
    if (!m_part) {
        return {};
    }
    const QString verdict = verdictText(m_judgement.verdict);
    if (m_characteristics.empty()) {
        return tr("Part %1: %2, no limits are set").arg(m_part->number).arg(verdict);
    }
    for (std::size_t i = 0; i < m_characteristics.size() && i < m_judgement.values.size(); ++i) {
        const auto figure = std::ranges::find(m_part->figures, m_characteristics[i].key, &PartFigure::key);
        if (isBad(m_judgement.values[i].verdict) && figure != m_part->figures.end()) {
            return tr("Part %1: %2, %3", "verdict, figure")
                .arg(m_part->number)
                .arg(verdict, figureText(m_process, *figure, m_context.look.units()));
        }
    }
    return tr("Part %1: %2").arg(m_part->number).arg(verdict);
}

}  // namespace kerf::ui
