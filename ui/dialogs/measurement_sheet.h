// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <functional>
#include <string>

#include "ui/dialogs/sheet.h"
#include "ui/entry/diameter_field.h"
#include "ui/entry/gauge_reading.h"
#include "ui/services/boring_service.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/keypad.h"

class QButtonGroup;
class QLineEdit;

namespace kerf::ui {

/// A stored measurement that somebody wants to correct or take out.
struct MeasurementSubject {
    MeasurementId id{0};
    QString place{};  ///< "part 7, top", translated
    double diameter_mm{0.0};
    double expected_mm{0.0};     ///< for the completion of the last two figures
    double settingRing_mm{0.0};  ///< of a comparator gauge; 0: the gauge shows diameters
};

/// Form of the correct / take out sheet: new value, reason (one touch, or words), who signs. The service keeps the old
/// value on record and computes everything after it again.
///
/// Object names: measurementCorrect, measurementVoid (switch), measurementField, measurementKeypad, measurementReason
/// (words), measurementReason0…3 (one touch), measurementMessage; buttons of the sheet: measurementCancel,
/// measurementApply.
class MeasurementForm : public FaceWidget {
    Q_OBJECT
 public:
    enum class Start { Correct, Void };
    using Author = std::function<std::string()>;
    /// Called with a translated sentence when the change is on disk.
    using OnDone = std::function<void(const QString& sentence)>;

    /// Opens the sheet; it closes itself when the change is on disk, and stays with the reason when it is not.
    static MeasurementForm* open(SheetHost& host, Look& look, BoringService& service, Author author,
                                 const MeasurementSubject& subject, Start start, OnDone onDone);

    /// A gauge was read while the form is open. It fills the field; it decides nothing.
    /// `gauge`: which one it was, kept with the value.
    void takeGauge(const GaugeReading& reading, const std::string& gauge = {});
    /// What is said in the form.
    [[nodiscard]] QString message() const;
    [[nodiscard]] double expected_mm() const { return m_subject.expected_mm; }

 protected:
    void refresh() override;

 private:
    MeasurementForm(Look& look, BoringService& service, Author author, MeasurementSubject subject, Start start,
                    OnDone onDone, Sheet* sheet);
    void reconsider();
    void apply();
    void answered(const Result<void>& result);
    void onTyped();
    [[nodiscard]] bool correcting() const;
    [[nodiscard]] QString reason() const;
    [[nodiscard]] QString whyNot() const;

    BoringService& m_service;
    Author m_author;
    MeasurementSubject m_subject;
    OnDone m_onDone;
    QPointer<Sheet> m_sheet;
    QButtonGroup* m_kind;
    QPushButton* m_correct;
    QPushButton* m_void;
    DiameterField* m_field;
    QLabel* m_unit;
    Keypad* m_keypad;
    QLabel* m_why;
    QButtonGroup* m_reasons;
    QLineEdit* m_words;
    QLabel* m_message;
    QLabel* m_signed;
    QPushButton* m_cancel;
    ActionButton* m_apply;
    QHBoxLayout* m_columns;
    QHBoxLayout* m_kindRow;
    QHBoxLayout* m_reasonRow;
    Sentence m_refusal{};
    Sentence m_question{};  ///< the value is far from the one expected: the button says "Yes, …"
    QString m_said{};       ///< about a reading that is not used
    bool m_pending{false};
    bool m_fromGauge{false};
    std::string m_gauge{};
};

}  // namespace kerf::ui
