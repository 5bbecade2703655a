// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QTemporaryDir>
#include <QTest>
#include <memory>

#include "tests/support/fake_milling_service.h"
#include "tests/support/page_bench.h"
#include "ui/dialogs/operator_chooser.h"
#include "ui/dialogs/restore_sheet.h"
#include "ui/dialogs/tool_sheet.h"
#include "ui/help/help_mode.h"
#include "ui/pages/milling/tool_memory_sheet.h"
#include "ui/services/shift_service.h"

using namespace kerf;
using namespace kerf::ui;
using kerf::test::FakeMillingService;
using kerf::test::PageBench;

namespace {

/// Tools whose changes are answered when the test wants it.
class SlowTools final : public ShiftService {
 public:
    void read(int, Read) override {}
    void nameStop(std::int64_t, const std::string&, const std::string&, Done) override {}
    void note(const std::string&, const std::string&, Done) override {}
    void handOver(const std::string&, const std::string&, Done) override {}
    void writePdf(const ShiftView&, const std::string&, Done) override {}
    [[nodiscard]] const std::vector<ToolLife>& tools() const override { return m_tools; }
    void newTool(ProcessId, const std::string&, Done done) override { answer = std::move(done); }
    void setToolLife(ProcessId, std::uint32_t, const std::string&, Done done) override { kept = std::move(done); }
    void putIn() {
        m_tools.front().parts = 0;
        answer({});
    }

    Done answer{};
    Done kept{};

 private:
    std::vector<ToolLife> m_tools{{ProcessId::Boring, 41, 0, 0, {}}};
};

class PlainPage final : public Page {
 public:
    using Page::context;
    using Page::Page;
};

}  // namespace

/// An answer that comes later takes no form from under somebody's fingers: the field in which he types is the same, has
/// the keys, and keeps what he typed.
class TestLateAnswers : public QObject {
    Q_OBJECT

    std::unique_ptr<PageBench> m_bench;
    PlainPage* m_page{};

    /// A form of somebody's, with his half typed name in it.
    QPointer<QLineEdit> openForm() {
        Sheet* sheet = m_bench->sheets->open(QStringLiteral("A form"));
        auto* field = new QLineEdit(sheet);
        sheet->body()->addWidget(field);
        QPushButton* cancel = sheet->addButton(QStringLiteral("Cancel"), {});
        cancel->setObjectName(QStringLiteral("formCancel"));
        cancel->setFocusPolicy(Qt::TabFocus);  // as the console's frame makes every button
        field->setFocus();
        typeInto(field);
        return field;
    }
    static void typeInto(QLineEdit* field) {
        QApplication::processEvents();
        QApplication::processEvents();  // once more: what the sheet does after it is laid out
        QVERIFY(field != nullptr && field->isVisible());
        QTest::mouseClick(field, Qt::LeftButton);
        field->clear();
        QTest::keyClicks(field, "12");
    }
    /// The button of the sheet that is open, not of one that has just been closed.
    bool press(const char* name) {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        return m_bench->press(name);
    }
    /// Of the sheet on top, which others may lie beneath.
    bool pressOnTop(const char* name) {
        QApplication::processEvents();
        const Sheet* sheet = m_bench->sheets->current();
        auto* button = sheet != nullptr ? sheet->findChild<QAbstractButton*>(QLatin1String(name)) : nullptr;
        if (button == nullptr || !button->isVisible() || !button->isEnabled()) {
            return false;
        }
        QTest::mouseClick(button, Qt::LeftButton);
        return true;
    }
    static bool stillThere(const QPointer<QLineEdit>& field, const char* typed = "12") {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QApplication::processEvents();
        const QLineEdit* const alive = field.data();
        return alive != nullptr && alive->isVisible() && alive->window()->focusWidget() == alive &&
               alive->text() == QLatin1String(typed);
    }

 private slots:
    void init() {
        m_bench = std::make_unique<PageBench>();
        (void)m_bench->session.signOn(QStringLiteral("Lee"), Role::Engineer);
        m_bench->engine.loop(ProcessId::Boring).fitted = true;
    }
    void cleanup() { m_bench.reset(); }

    void aNewToolsAnswerLeavesTheLifeThatIsTyped() {
        SlowTools tools;
        m_bench->services.shiftService = &tools;
        m_page = m_bench->show<PlainPage>();
        openTools(m_page->context());
        QVERIFY(press("toolNew_boring"));
        QVERIFY(press("toolLife_boring"));
        const QPointer<QLineEdit> field = m_bench->find<QLineEdit>("toolLifeField");
        typeInto(field);
        tools.putIn();
        QVERIFY(stillThere(field));
        QVERIFY(!m_bench->notices.empty());
        m_bench->sheets->current()->close();
        openTools(m_page->context());
        QVERIFY(press("toolNew_boring"));
        const QPointer<Sheet> sheet = m_bench->sheets->current();
        tools.putIn();
        QVERIFY(m_bench->sheets->isOpen(sheet));  // the same one, with the new count in it
        QVERIFY(m_bench->find<QLabel>("tool_boring")->text().startsWith(QStringLiteral("0 ")));
    }
    /// What is typed closes with the sheet only when it, and nothing else, has been stored.
    void whatIsTypedOutlivesItsAnswer() {
        SlowTools tools;
        m_bench->services.shiftService = &tools;
        m_page = m_bench->show<PlainPage>();
        openTools(m_page->context());
        QVERIFY(press("toolLife_boring"));
        const QPointer<QLineEdit> field = m_bench->find<QLineEdit>("toolLifeField");
        typeInto(field);
        m_bench->find<QPushButton>("toolLifeSave")->setFocusPolicy(Qt::TabFocus);  // as the console's frame does
        QVERIFY(press("toolLifeSave"));
        const Result<void> full = tl::unexpected(Sentence(KERF_TEXT("The file is damaged.")));
        tools.kept(full);
        QVERIFY(stillThere(field));  // refused: it can be sent again
        QVERIFY(m_bench->notices.back().contains(QStringLiteral("damaged")));
        QVERIFY(press("toolLifeSave"));
        QVERIFY(!m_bench->find<QPushButton>("toolLifeSave")->isEnabled());  // and not twice
        field->setFocus();
        QTest::keyClicks(field, "3");
        tools.kept({});
        QVERIFY(stillThere(field, "123"));  // typed since
        QVERIFY(press("toolLifeSave"));
        tools.kept({});
        QVERIFY(m_bench->sheets->current() == nullptr);
    }
    /// Who is there is asked over the form, which comes back with what was typed.
    void theQuestionWhoIsThereGivesTheFormBack() {
        m_page = m_bench->show<PlainPage>();
        const QPointer<QLineEdit> field = openForm();
        chooseOperator(m_bench->look, *m_bench->sheets, m_bench->session);
        QTest::keyClicks(m_bench->find<QLineEdit>("operatorName"), "Park");
        QVERIFY(press("signOn"));
        QVERIFY(stillThere(field));
        QCOMPARE(m_bench->session.name(), QStringLiteral("Park"));
        chooseOperator(m_bench->look, *m_bench->sheets, m_bench->session);
        QVERIFY(press("sheetSafe"));
        QVERIFY(stillThere(field));
    }
    void aReasonForTheNextToolStays() {
        FakeMillingService service;
        service.edit().memory.tools = {{7, 5, "Rail", 7.9, 5200.0, false, {}, {}},
                                       {2, 9, "Rail", 8.1, 5100.0, false, {}, {}}};
        service.keepAnswers = true;
        m_page = m_bench->show<PlainPage>();
        openToolMemory(m_page->context(), service);
        const QPointer<QLineEdit> field = m_bench->find<QLineEdit>("millingToolReason");
        typeInto(field);
        QVERIFY(press("millingLeaveOut_7"));
        field->setFocus();  // as the console's frame leaves it
        QTest::keyClicks(field, " more");
        service.answerAll();
        QVERIFY(stillThere(field, "12 more"));
        QVERIFY(service.view().memory.tools[0].leftOut);
        QCOMPARE(m_bench->find<QPushButton>("millingLeaveOut_7")->text(), QStringLiteral("Take in again"));
        QVERIFY(press("millingLeaveOut_2"));
        service.answerAll();
        const QLineEdit* const reason = field.data();
        QVERIFY(reason != nullptr && reason->text().isEmpty());  // it was for this one and has been used
        QVERIFY(press("millingLeaveOut_2"));
        const QPointer<QLineEdit> other = openForm();
        service.answerAll();
        QVERIFY(stillThere(other));
    }
    void aCheckedBackupIsSaidWhereSomebodyTypes_data() {
        QTest::addColumn<bool>("good");
        QTest::newRow("whole") << true;
        QTest::newRow("damaged") << false;
    }
    void aCheckedBackupIsSaidWhereSomebodyTypes() {
        QFETCH(bool, good);
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("kerf.db"));
        QVERIFY(QFile(file).open(QIODevice::WriteOnly));
        std::function<void(const Result<void>&)> answer;
        m_bench->services.filesThere = [&](const QString&) { return QStringList{file}; };
        m_bench->services.restore = [&](const QString&, const QString&, const QString&, auto done) {
            answer = std::move(done);
        };
        const Result<void> result =
            good ? Result<void>() : Result<void>(tl::unexpected(Sentence(KERF_TEXT("The file is damaged."))));
        m_page = m_bench->show<PlainPage>();
        openRestore(m_page->context());
        QVERIFY(press("restoreFile0"));
        QVERIFY(press("restoreGo"));
        QVERIFY(press("sheetSafe"));
        const QPointer<QLineEdit> field = openForm();
        answer(result);
        QVERIFY(stillThere(field));
        QVERIFY(!m_bench->notices.empty());
        m_bench->sheets->current()->close();
        openRestore(m_page->context());
        QVERIFY(press("restoreFile0"));
        QVERIFY(press("restoreGo"));
        const QPointer<Sheet> asked = m_bench->sheets->current();
        answer(result);
        QVERIFY(m_bench->sheets->current() != nullptr && !m_bench->sheets->isOpen(asked));
    }
    /// Sign on, and from there whatever it offers: the form beneath comes back as it was left.
    void whatIsOpenedFromSigningOnGivesTheFormBack() {
        m_page = m_bench->show<PlainPage>();
        ui::OperatorSession& session = m_bench->session;
        QVERIFY(session.setPin(QStringLiteral("Lee"), QStringLiteral("2468")));
        const QPointer<QLineEdit> field = openForm();
        chooseOperator(m_bench->look, *m_bench->sheets, session, {});
        QVERIFY(pressOnTop("people"));
        QVERIFY(pressOnTop("peoplePermissions"));
        QVERIFY(m_bench->find<QWidget>("permissions") != nullptr);
        QVERIFY(pressOnTop("sheetSafe"));
        QVERIFY(pressOnTop("personPin0"));  // the list is where it was
        auto* pin = m_bench->sheets->current()->findChild<QLineEdit*>(QStringLiteral("pinField"));
        QVERIFY(pin != nullptr);
        pin->setText(QStringLiteral("1357"));
        emit pin->returnPressed();
        QVERIFY(pressOnTop("personRemove0"));
        QVERIFY(pressOnTop("sheetProceed"));
        QVERIFY(!session.known().contains(QStringLiteral("Kim")));
        QVERIFY(pressOnTop("personOperator0"));  // the list, without him
        QVERIFY(pressOnTop("sheetSafe"));
        QVERIFY(stillThere(field));
    }
    void whoSaysYesAsWellGivesTheFormBack() {
        m_page = m_bench->show<PlainPage>();
        ui::OperatorSession& session = m_bench->session;
        session.setRole(QStringLiteral("Kim"), Role::Setter);
        QVERIFY(session.setPin(QStringLiteral("Kim"), QStringLiteral("1357")));
        const QPointer<QLineEdit> field = openForm();
        chooseOperator(m_bench->look, *m_bench->sheets, session, {});
        QVERIFY(pressOnTop("secondPerson"));
        QVERIFY(pressOnTop("second0"));
        auto* pin = m_bench->sheets->current()->findChild<QLineEdit*>(QStringLiteral("pinField"));
        QVERIFY(pin != nullptr);
        pin->setText(QStringLiteral("1357"));
        emit pin->returnPressed();
        QCOMPARE(session.second(), QStringLiteral("Kim"));
        QVERIFY(pressOnTop("sheetSafe"));
        QVERIFY(stillThere(field));
    }
    /// The chooser alone changes its language by being made anew: once, not over itself.
    void theLanguageChangesTheChooserAndNothingStaysBeneath() {
        m_page = m_bench->show<PlainPage>();
        chooseOperator(m_bench->look, *m_bench->sheets, m_bench->session, {});
        for (const Language language : {Language::Korean, Language::English}) {
            QVERIFY(m_bench->sheets->languageMayChange());
            Preferences preferences = m_bench->look.preferences();
            preferences.language = language;
            m_bench->look.apply(preferences);
        }
        QVERIFY(pressOnTop("sheetSafe"));
        QVERIFY(m_bench->sheets->current() == nullptr);
    }
    void helpGivesTheFormBack() {
        m_page = m_bench->show<PlainPage>();
        HelpMode help(m_bench->look, *m_bench->sheets, &m_bench->window);
        const QPointer<QLineEdit> field = openForm();
        for (int time = 0; time < 2; ++time) {
            help.setActive(true);
            QTest::mouseClick(m_bench->find<QPushButton>("formCancel"), Qt::LeftButton);
            const QLineEdit* const beneath = field.data();
            QVERIFY(beneath != nullptr && !beneath->isVisible());
            if (time == 1 && m_bench->find<QPushButton>("helpGuide") != nullptr) {
                QVERIFY(press("helpGuide"));  // help on help
            }
            QVERIFY(press("sheetSafe"));
            QVERIFY(stillThere(field));
        }
        QTest::keyClicks(field, "3");
        QVERIFY(stillThere(field, "123"));
    }
};

QTEST_MAIN(TestLateAnswers)
#include "tst_late_answers.moc"
