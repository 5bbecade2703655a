// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>

#include "ui/link/texts.h"

namespace kerf::ui {
namespace {

struct SourceTexts {
    Q_DECLARE_TR_FUNCTIONS(SourceTexts)
};

}  // namespace

QString sourceText(MeasurementSource source, const std::string& name) {
    const QString which = QString::fromStdString(name);
    switch (source) {
        case MeasurementSource::Keypad:
            return SourceTexts::tr("typed");
        case MeasurementSource::Gauge:
            return which.isEmpty() ? SourceTexts::tr("gauge") : SourceTexts::tr("gauge %1").arg(which);
        case MeasurementSource::File:
            break;
    }
    return SourceTexts::tr("file %1").arg(which);
}

}  // namespace kerf::ui
