// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QPlainTextEdit>
#include <QPointer>
#include <QTextEdit>
#include <algorithm>
#include <set>

#include "db/readers/database_reader.h"
#include "tests/support/console_bench.h"
#include "tests/support/console_walk.h"
#include "ui/dialogs/sheet.h"
#include "ui/entry/touch_keyboard.h"
#include "ui/widgets/keypad.h"

using namespace kerf;

/// Everything a person must type can be typed by touch: every sheet that a touch opens, from every page, field by
/// field, with the Korean and the Latin page of the keyboard. The machine stands still meanwhile, so that the walk is
/// the same each time.
class TestConsoleTouch : public QObject, test::ConsoleWalk {
    Q_OBJECT

    std::set<QString> m_seen;
    std::set<QString> m_fields;
    QStringList m_unserved;
    int m_sheets{0};

    /// Somebody wants pictures of the sheets.
    [[nodiscard]] static bool looking() { return qEnvironmentVariableIsSet("KERF_SCRATCH"); }
    [[nodiscard]] QList<QLineEdit*> fieldsIn(const QWidget* place) {
        QList<QLineEdit*> fields;
        for (QLineEdit* field : place->findChildren<QLineEdit*>()) {
            if (field->isVisibleTo(window()) && field->isEnabled() && !field->isReadOnly()) {
                fields << field;
            }
        }
        return fields;
    }
    void touchKeys(const QWidget* place, const char* name) {
        for (auto* key : place->findChildren<QPushButton*>(QLatin1String(name))) {
            if (key->isVisibleTo(window()) && key->isEnabled()) {
                QTest::mouseClick(key, Qt::LeftButton);
            }
        }
    }
    /// Why the field cannot be filled by touch; empty: it can.
    /// A form that is made anew meanwhile (an answer came late) took the field from under the finger.
    [[nodiscard]] QString whyUnserved(QLineEdit* field) {
        const QPointer<QLineEdit> alive(field);
        const QString before = field->text();
        QString why;
        QTest::mouseClick(field, Qt::LeftButton);
        settle();
        const QString gone = QStringLiteral("gone while it was touched");
        if (alive.isNull()) {
            return gone;
        }
        field->clear();
        auto* keyboard = window()->findChild<ui::TouchKeyboard*>();
        if (keyboard != nullptr && keyboard->isVisible()) {
            const QRect place(field->mapTo(host(), QPoint()), field->size());
            const bool figures = (field->inputMethodHints() & Qt::ImhFormattedNumbersOnly) != 0 ||
                                 (field->inputMethodHints() & Qt::ImhDigitsOnly) != 0 ||
                                 field->echoMode() != QLineEdit::Normal;
            const QString expected = figures ? QStringLiteral("33") : QStringLiteral("ㄷe");
            touchKeys(keyboard, "touchKey_e");
            if (alive.isNull()) {
                return gone;
            }
            const QString first = field->text();
            if (!figures) {
                touchKeys(keyboard, "touchLanguage");
            }
            touchKeys(keyboard, "touchKey_e");
            if (alive.isNull()) {
                return gone;
            }
            if (keyboard->field() != field) {
                why = QStringLiteral("the keyboard types elsewhere");
            } else if (keyboard->geometry().intersects(place & host()->rect())) {
                why = QStringLiteral("beneath the keyboard");
            } else if (first != expected.first(1) || field->text() != expected) {
                why = QStringLiteral("has “%1”, then “%2” after the keys of “%3”").arg(first, field->text(), expected);
            }
            keyboard->hide();
        } else {
            QWidget* const room = host()->current() != nullptr ? static_cast<QWidget*>(host()->current()) : window();
            for (auto* pad : room->findChildren<ui::Keypad*>()) {
                if (pad->isVisibleTo(window())) {
                    touchKeys(pad, "key3");
                    break;
                }
            }
            if (alive.isNull()) {
                return gone;
            }
            if (field->text() != QLatin1String("3")) {
                why = QStringLiteral("no keyboard, and “%1” from a pad").arg(field->text());
            }
        }
        field->setText(before);
        return why;
    }
    /// A sheet may be made anew or closed by its own news while its fields are touched.
    void check(const QWidget* const place, const QString& where) {
        const QPointer<const QWidget> alive(place);
        QList<QPointer<QLineEdit>> fields;
        for (QLineEdit* field : fieldsIn(place)) {
            fields << field;
        }
        for (const QPointer<QLineEdit>& kept : fields) {
            QLineEdit* const field = kept.data();
            if (field == nullptr) {
                m_unserved << where + QStringLiteral(": its form was made anew meanwhile");
                return;
            }
            const QString name =
                where + u' ' +
                (field->objectName().isEmpty() ? field->parentWidget()->objectName() : field->objectName());
            if (!m_fields.insert(name).second) {
                continue;
            }
            if (const QString why = whyUnserved(field); !why.isEmpty()) {
                m_unserved << name + QStringLiteral(": ") + why;
            }
        }
        if (alive.isNull()) {
            return;
        }
        for (const auto* area : place->findChildren<QAbstractScrollArea*>()) {
            const auto* plain = qobject_cast<const QPlainTextEdit*>(area);
            const auto* rich = qobject_cast<const QTextEdit*>(area);
            if (area->isVisibleTo(window()) &&
                ((plain != nullptr && !plain->isReadOnly()) || (rich != nullptr && !rich->isReadOnly()))) {
                m_unserved << where + u' ' + area->objectName() + QStringLiteral(": an area of text");
            }
        }
    }
    void explore(const QString& page, const QStringList& path) {
        goTo(page, path);
        const ui::Sheet* sheet = host()->current();
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
        if (looking()) {
            qInfo("%s: %s", qPrintable(path.join(u'/')), qPrintable(buttons.join(u' ')));
            window()->grab().save(page + u'_' + path.join(u'_') + QStringLiteral(".png"));
        }
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
        begin("ko", looking());
        if (QTest::currentTestFailed()) return;
        settle();
    }
    void aFileOfDiametersIsTakenByTouch() {
        m_bench.goOn();
        goTo(QStringLiteral("boring"), {});
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
        QTRY_VERIFY2(m_bench.text("importPlan").contains(QStringLiteral("지름 2개")),
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
        QTRY_VERIFY_WITH_TIMEOUT(m_bench.service().awaiting.has_value(), 120'000);  // the walk finds one waiting
        m_bench.pause();
    }
    void everyFieldIsServed_data() { pageRows(); }
    /// What the frame opens is looked at once, from the first page.
    void everyFieldIsServed() {
        QFETCH(QString, page);
        m_unserved.clear();
        goTo(page, {});
        const QWidget* place = placeOf(page);
        QVERIFY(place != nullptr);
        check(place, page);
        for (const QString& name : buttonsIn(place)) {
            explore(page, {name});
        }
        qInfo("%s: %d sheets, %d fields so far", qPrintable(page), m_sheets, static_cast<int>(m_fields.size()));
        QVERIFY2(m_unserved.isEmpty(), qPrintable(m_unserved.join(QStringLiteral("\n"))));
    }
    void somethingWasLookedAt() {
        QVERIFY2(m_sheets >= 36, qPrintable(QString::number(m_sheets)));
        QVERIFY2(m_fields.size() >= 145, qPrintable(QString::number(m_fields.size())));
    }
    /// A bore that waits gets its diameter from a file: touched, looked into, confirmed.
    void cleanupTestCase() { m_bench.stop(); }
};

QTEST_MAIN(TestConsoleTouch)
#include "tst_console_touch.moc"
