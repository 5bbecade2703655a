// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QFile>
#include <QPlainTextEdit>
#include <QTextEdit>
#include <algorithm>
#include <set>

#include "db/readers/database_reader.h"
#include "tests/support/console_bench.h"
#include "ui/dialogs/sheet.h"
#include "ui/entry/touch_keyboard.h"
#include "ui/widgets/keypad.h"

using namespace kerf;

/// Everything a person must type can be typed by touch: every sheet that a touch opens, from every page, field by
/// field.
class TestConsoleTouch : public QObject {
    Q_OBJECT

    test::ConsoleBench m_bench;
    std::set<QString> m_seen;
    std::set<QString> m_fields;
    QStringList m_unserved;
    int m_sheets{0};

    static constexpr int kDeepest = 4;

    [[nodiscard]] ui::MainWindow* window() { return m_bench.console().window(); }
    [[nodiscard]] ui::SheetHost* host() { return window()->findChild<ui::SheetHost*>(); }

    static void settle() {
        for (int i = 0; i < 3; ++i) {
            QCoreApplication::sendPostedEvents();
            QCoreApplication::processEvents();
        }
    }
    /// What starts or ends something outside the pages, leads away, or only types.
    [[nodiscard]] static bool leftAlone(const QString& name) {
        static const QStringList kBegins{"nav_", "key", "touch", "holdAll", "band", "help", "qt_"};
        static const QStringList kNames{"quit", "restart", "millingStart", "tappingStart", "turningStart"};
        return name.isEmpty() || kNames.contains(name) ||
               std::ranges::any_of(kBegins, [&](const QString& begin) { return name.startsWith(begin); });
    }
    [[nodiscard]] QStringList buttonsIn(QWidget* place) {
        QStringList names;
        for (const auto* button : place->findChildren<QAbstractButton*>()) {
            if (button->isVisibleTo(window()) && button->isEnabled() && !leftAlone(button->objectName()) &&
                !names.contains(button->objectName())) {
                names << button->objectName();
            }
        }
        return names;
    }
    [[nodiscard]] QList<QLineEdit*> fieldsIn(QWidget* place) {
        QList<QLineEdit*> fields;
        for (QLineEdit* field : place->findChildren<QLineEdit*>()) {
            if (field->isVisibleTo(window()) && field->isEnabled() && !field->isReadOnly()) {
                fields << field;
            }
        }
        return fields;
    }
    void pressNow(const QString& name) {
        for (auto* button : window()->findChildren<QAbstractButton*>(name)) {
            if (button->isVisibleTo(window()) && button->isEnabled()) {
                QTest::mouseClick(button, Qt::LeftButton);
                settle();
                return;
            }
        }
    }
    /// Page and buttons, from a page without a sheet.
    void goTo(const QString& page, const QStringList& path) {
        if (ui::Sheet* sheet = host()->current()) {
            sheet->close();
            settle();
        }
        window()->showPage(page.toLatin1().constData());
        settle();
        for (const QString& name : path) {
            pressNow(name);
        }
    }
    /// One figure by touch, wherever it can be touched.
    [[nodiscard]] bool served(QLineEdit* field) {
        const QString before = field->text();
        QTest::mouseClick(field, Qt::LeftButton);
        settle();
        auto* keyboard = window()->findChild<ui::TouchKeyboard*>();
        const auto touch = [&](const QWidget* place, const char* name) {
            for (auto* key : place->findChildren<QPushButton*>(QLatin1String(name))) {
                if (key->isVisibleTo(window()) && key->isEnabled()) {
                    QTest::mouseClick(key, Qt::LeftButton);
                }
            }
        };
        field->selectAll();
        if (keyboard != nullptr && keyboard->isVisible()) {
            const QRect covered(field->mapTo(host(), QPoint()), field->size());
            if (keyboard->field() != field || keyboard->geometry().intersects(covered & host()->rect())) {
                return false;
            }
            touch(keyboard, "touchKey_e");  // e, 3 or ㄷ
        } else {
            QWidget* const room = host()->current() != nullptr ? static_cast<QWidget*>(host()->current()) : window();
            for (auto* pad : room->findChildren<ui::Keypad*>()) {
                if (pad->isVisibleTo(window())) {
                    touch(pad, "key3");
                    break;
                }
            }
        }
        settle();
        const QString now = field->text();
        field->setText(before);
        if (keyboard != nullptr) {
            keyboard->hide();
        }
        return now != before || before == QStringLiteral("3");
    }
    void check(QWidget* place, const QString& where) {
        for (QLineEdit* field : fieldsIn(place)) {
            const QString name =
                where + u' ' +
                (field->objectName().isEmpty() ? field->parentWidget()->objectName() : field->objectName());
            if (!m_fields.insert(name).second) {
                continue;
            }
            if (!served(field)) {
                m_unserved << name;
            }
        }
        for (const auto* area : place->findChildren<QPlainTextEdit*>()) {
            if (area->isVisibleTo(window()) && !area->isReadOnly()) {
                m_unserved << where + u' ' + area->objectName();
            }
        }
        for (const auto* area : place->findChildren<QTextEdit*>()) {
            if (area->isVisibleTo(window()) && !area->isReadOnly()) {
                m_unserved << where + u' ' + area->objectName();
            }
        }
    }
    void explore(const QString& page, const QStringList& path) {
        goTo(page, path);
        ui::Sheet* sheet = host()->current();
        if (sheet == nullptr) {
            return;
        }
        QStringList names;
        for (const QLineEdit* field : fieldsIn(sheet)) {
            names << field->objectName() + field->parentWidget()->objectName();
        }
        const QStringList buttons = buttonsIn(sheet);
        const QString key = names.join(u',') + u'|' + buttons.join(u',');
        if (!m_seen.insert(key).second) {
            return;
        }
        ++m_sheets;
        check(sheet, path.last());
        if (path.size() >= kDeepest) {
            return;
        }
        for (const QString& name : buttons) {
            explore(page, path + QStringList{name});
        }
    }

 private slots:
    void initTestCase() {
        console::Options options;
        options.preparedParts = 3;
        m_bench.start(options);
        QTRY_VERIFY2_WITH_TIMEOUT(m_bench.up(), qPrintable(m_bench.failure()), 30'000);
        QTRY_VERIFY_WITH_TIMEOUT(m_bench.console().shift()->prepared(), 240'000);
        QVERIFY(window()->session().signOn(QStringLiteral("Kim"), ui::Role::Engineer));
        settle();
    }
    void everyFieldIsServed_data() {
        QTest::addColumn<QString>("page");
        for (const ui::PageEntry& page : ui::standardPages()) {
            QTest::newRow(page.key) << QString::fromLatin1(page.key);
        }
    }
    void everyFieldIsServed() {
        QFETCH(QString, page);
        m_seen.clear();
        m_unserved.clear();
        goTo(page, {});
        check(window(), page);
        for (const QString& name : buttonsIn(window())) {
            explore(page, {name});
        }
        qInfo("%s: %d sheets, %d fields so far", qPrintable(page), m_sheets, static_cast<int>(m_fields.size()));
        QVERIFY2(m_unserved.isEmpty(), qPrintable(m_unserved.join(QStringLiteral("\n"))));
    }
    void somethingWasLookedAt() {
        QVERIFY2(m_sheets > 20, qPrintable(QString::number(m_sheets)));
        QVERIFY2(m_fields.size() > 40, qPrintable(QString::number(m_fields.size())));
    }
    /// A bore that waits gets its diameter from a file: touched, looked into, confirmed.
    void aFileOfDiametersIsTakenByTouch() {
        goTo(QStringLiteral("boring"), {});
        QTRY_VERIFY_WITH_TIMEOUT(m_bench.service().awaiting.has_value(), 120'000);
        const BoringServiceView view = m_bench.service();
        const auto part = std::ranges::find(view.parts, *view.awaiting, &BorePartView::id);
        QVERIFY(part != view.parts.end());
        QFile file(m_bench.folder() + QStringLiteral("/station 3.csv"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("part;overhang [mm];diameter [mm]\r\n");
        for (std::uint8_t depth = 0; depth < 2; ++depth) {
            const double read_mm = m_bench.console().boringService().gaugeReading_mm(part->id, depth).value_or(0.0);
            file.write(QStringLiteral("%1;%2;%3\r\n")
                           .arg(part->number)
                           .arg(view.depths[depth].overhang_mm)
                           .arg(QString::number(read_mm, 'f', 3).replace(u'.', u','))
                           .toUtf8());
        }
        file.close();
        QVERIFY(m_bench.press("boringCorrect"));
        QVERIFY(m_bench.press("measurementListImport"));
        QTRY_VERIFY(m_bench.find<QLineEdit>("importPath") != nullptr);
        QVERIFY(!m_bench.find<QAbstractButton>("importTake")->isEnabled());
        m_bench.find<QLineEdit>("importPath")->setText(file.fileName());
        QVERIFY(m_bench.press("importLook"));
        QTRY_VERIFY2(m_bench.text("importPlan").contains(QStringLiteral("2 diameters")),
                     qPrintable(m_bench.text("importPlan")));
        QVERIFY(m_bench.service().awaiting.has_value());  // saying it takes nothing
        QVERIFY(m_bench.press("importTake"));
        QTRY_VERIFY(m_bench.service().awaiting != view.awaiting);
        const auto reader = db::DatabaseReader::open((m_bench.folder() + QStringLiteral("/kerf.db")).toStdString());
        QVERIFY(reader.has_value());
        const auto stored = (*reader)->part(part->id);
        QVERIFY(stored && *stored && (*stored)->part.measurements.size() == 2);
        QCOMPARE((*stored)->part.measurements[1].sourceName, std::string("station 3.csv"));
        QVERIFY((*stored)->part.measurements[1].source == MeasurementSource::File);
        QCOMPARE((*stored)->part.measurements[1].author, std::string("Kim"));
        m_bench.stop();
    }
};

QTEST_MAIN(TestConsoleTouch)
#include "tst_console_touch.moc"
