// SPDX-License-Identifier: GPL-3.0-or-later
#include <QGridLayout>
#include <QLabel>
#include <array>

#include "engine/core/param_spec.h"
#include "ui/link/texts.h"
#include "ui/pages/thermal/thermal_sheets.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/label.h"
#include "ui/widgets/value_field.h"

namespace kerf::ui {

void ThermalSheets::openPart() {
    static const std::array kSpecs{
        ParamSpec{"thermal.part_x_um", KERF_TEXT("Diameter (X), measured − nominal"), "um", -400.0, 400.0, 0.0, 1, ""},
        ParamSpec{"thermal.part_y_um", KERF_TEXT("Y, measured − nominal"), "um", -200.0, 200.0, 0.0, 1, ""},
        ParamSpec{"thermal.part_z_um", KERF_TEXT("Length (Z), measured − nominal"), "um", -200.0, 200.0, 0.0, 1, ""}};
    static constexpr std::array kNames{"thermalPartX", "thermalPartY", "thermalPartZ"};
    Sheet* sheet = open(tr("The last part as a measurement"),
                        tr("A good part carries what was left of the drift when it was finished. Enter by how much it "
                           "is off, at the temperature it was cut at; leave empty what was not measured. Each part "
                           "counts once."));
    Look& look = m_context.look;
    std::array<ValueField*, kAxisCount> fields{};
    auto* grid = new QGridLayout;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        fields[axis] = new ValueField(look, kSpecs[axis], sheet);
        fields[axis]->setObjectName(QLatin1String(kNames[axis]));
        fields[axis]->setLabel(engineText(kSpecs[axis].label));
        grid->addWidget(fields[axis], 0, static_cast<int>(axis));
    }
    sheet->body()->addLayout(grid);
    QLabel* state = makeLabel(TextRole::Body, sheet, true);
    state->setObjectName(QStringLiteral("thermalPartState"));
    sheet->body()->addWidget(state);
    auto* take = new ActionButton(look);
    take->setObjectName(QStringLiteral("thermalPartTake"));
    take->setText(tr("Take as a measurement"));
    take->setPrimary(true);
    allowOnly(take, m_context.session, Deed::ThermalReference);
    take->setPredicate([this, fields]() -> QString {
        if (!m_status.thermal.partToMeasure) return tr("no part finished since the reference");
        bool any = false;
        for (const ValueField* field : fields) {
            if (field->edit()->text().trimmed().isEmpty()) continue;
            if (!field->value()) return field->whyInvalid();
            any = true;
        }
        return any ? QString() : tr("enter what was measured");
    });
    for (ValueField* field : fields)
        QObject::connect(field, &ValueField::edited, take, [take] { take->reconsider(); });
    sheet->addButton(take, [this, fields] {
        std::array<std::optional<double>, kAxisCount> deviation_um{};
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
            if (!fields[axis]->edit()->text().trimmed().isEmpty()) deviation_um[axis] = fields[axis]->value();
        }
        if (deviation_um[0]) *deviation_um[0] /= 2.0;  // a diameter is off by both sides
        withAuthor(Deed::ThermalReference, [this, deviation_um](const std::string& author) {
            return m_service.measureByPart(deviation_um, author);
        });
    });
    follow([this, state, take] {
        take->reconsider();
        state->setText(m_status.thermal.partToMeasure
                           ? tr("A part is finished that has not been measured yet.")
                           : tr("There is no finished part to measure: cut one, then measure it."));
    });
}

}  // namespace kerf::ui
