// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <optional>

#include "engine/core/param_spec.h"
#include "ui/widgets/face_widget.h"

namespace kerf::ui {

/// A number a person types: label, edit, unit, and below it the sentence that says why it is not accepted.
///
/// Values go in and out in the stored unit of the ParamSpec; what is shown and typed is the operator's unit. Switching
/// the unit never changes the stored value. Range and decimals come from the spec.
class ValueField : public FaceWidget {
    Q_OBJECT
 public:
    ValueField(Look& look, const ParamSpec& spec, QWidget* parent = nullptr);

    /// Other limits for the same field (a diameter's plausible range depends on the part type).
    void setSpec(const ParamSpec& spec);
    /// Label instead of the spec's translated one.
    void setLabel(const QString& label);
    void setValue(double stored);
    void clear();
    /// The value typed, in the stored unit; empty when it is missing, not a number or out of range.
    [[nodiscard]] std::optional<double> value() const;
    /// Why value() is empty (translated); empty when all is well.
    [[nodiscard]] QString whyInvalid() const;
    /// Show a sentence of your own under the field (a question of the entry gate); empty removes it.
    void setComplaint(const QString& sentence);
    /// The editor, for a keypad or focus.
    [[nodiscard]] QLineEdit* edit() const { return m_edit; }

 signals:
    void edited();
    /// Return or the keypad's enter. Only with a valid value; else the field shows why not.
    void committed(double stored);

 protected:
    void refresh() override;

 private:
    void onCommit();
    void onEdited();
    void showStored();

    ParamSpec m_spec;
    QString m_labelText;
    QLabel* m_label;
    QLineEdit* m_edit;
    QLabel* m_unit;
    QLabel* m_complaint;
    std::optional<double> m_stored;  ///< set by program and not edited since: survives any unit switch exactly
    UnitSystem m_typedIn;            ///< the unit the text is in
};

}  // namespace kerf::ui
