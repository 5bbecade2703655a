// SPDX-License-Identifier: GPL-3.0-or-later
#include <QInputMethodEvent>
#include <QPointer>
#include <QSignalSpy>
#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "tests/support/console_bench.h"
#include "tests/support/console_walk.h"
#include "ui/dialogs/sheet.h"
#include "ui/entry/gauge_wedge.h"

using namespace kerf;

/// Keys of a gauge on every page and every sheet of the real console, whatever has the focus: none of them presses a
/// button or stays in a text, a frame is one reading, and what a person types goes where it was meant to. The machine
/// stands still meanwhile; the clock of the keys is the test's own.
class TestConsoleWedge : public QObject, test::ConsoleWalk {
    Q_OBJECT

    std::set<QString> m_seen;
    QStringList m_wrong;
    std::mt19937 m_random{14};
    qint64 m_now_ms{1'000'000};
    int m_frames{0};
    int m_places{0};

    static constexpr int kFocusPerPlace = 8;

    [[nodiscard]] ui::GaugeWedge* wedge() { return window()->findChild<ui::GaugeWedge*>(); }

    // ── keys
    int pace(bool radio) {
        if (!radio) return std::uniform_int_distribution(1, 30)(m_random);
        return std::uniform_int_distribution(35, 90)(m_random);
    }
    void key(QWidget* target, QChar c, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        if (target != nullptr) QTest::keyClick(target, c.toLatin1(), modifiers);
    }
    /// One pause of 150 ms where the frame is long enough for one.
    void send(const QPointer<QWidget>& target, const QString& frame, bool radio) {
        const auto slow = radio ? std::uniform_int_distribution<qsizetype>(1, frame.size())(m_random) : -1;
        for (qsizetype k = 0; k < frame.size(); ++k) {
            key(target, frame[k]);
            m_now_ms += k == slow ? 150 : pace(radio);
        }
    }
    void end(const QPointer<QWidget>& target, int form) {
        if (target.isNull()) return;
        switch (form) {
            case 0:
                QTest::keyClick(target, Qt::Key_Return);
                break;
            case 1:
                QTest::keyClick(target, Qt::Key_Return);
                m_now_ms += 8;
                if (target) QTest::keyClick(target, Qt::Key_Return);
                break;
            case 2:
                QTest::keyClick(target, Qt::Key_Enter, Qt::KeypadModifier);
                break;
            default:
                QTest::keyClick(target, Qt::Key_Tab);
                m_now_ms += 40;
                if (target) QTest::keyClick(target, Qt::Key_Return);
                break;
        }
    }

    // ── what must stay as it is
    struct Look {
        QPointer<ui::Sheet> sheet;
        std::map<QLineEdit*, QString> texts;
    };
    [[nodiscard]] Look look() {
        Look now{host()->current(), {}};
        for (auto* field : window()->findChildren<QLineEdit*>()) {
            if (!field->property("gaugeTarget").toBool()) now.texts[field] = field->text();
        }
        return now;
    }
    void compare(const Look& before, const QString& where) {
        if (before.sheet != host()->current()) {
            m_wrong << where + QStringLiteral(": another sheet");
        }
        for (auto* field : window()->findChildren<QLineEdit*>()) {
            const auto was = before.texts.find(field);
            if (was != before.texts.end() && was->second != field->text()) {
                m_wrong << where + QStringLiteral(": %1 holds “%2”").arg(field->objectName(), field->text());
            }
        }
    }
    /// Buttons pressed while keys came.
    class Presses {
     public:
        explicit Presses(QWidget* place) {
            for (auto* button : place->findChildren<QAbstractButton*>()) {
                m_links << QObject::connect(button, &QAbstractButton::pressed,
                                            [this, button] { m_names << button->objectName(); });
            }
        }
        ~Presses() {
            for (const auto& link : m_links)
                QObject::disconnect(link);
        }
        Presses(const Presses&) = delete;
        Presses& operator=(const Presses&) = delete;
        [[nodiscard]] const QStringList& names() const { return m_names; }

     private:
        QList<QMetaObject::Connection> m_links;
        QStringList m_names;
    };

    [[nodiscard]] QList<QPointer<QWidget>> focusIn(QWidget* place) {
        QList<QPointer<QWidget>> all;
        for (auto* widget : place->findChildren<QWidget*>()) {
            if (widget->isVisibleTo(window()) && widget->isEnabled() && widget->focusPolicy() != Qt::NoFocus) {
                all << widget;
            }
        }
        std::shuffle(all.begin(), all.end(), m_random);
        QList<QPointer<QWidget>> some = all.first(std::min<qsizetype>(all.size(), kFocusPerPlace));
        some << place;
        return some;
    }
    void aFrame(const QPointer<QWidget>& target, const QString& where) {
        // Nothing here is a diameter of the part that waits: what is read is asked about, and the place stays.
        static const QStringList kFrames{"12.011",       "   12.011",         "+00012.011",     "01A+00012.011",
                                         "D=12.011",     "12,011 mm",         "OD 12.011mm OK", "#2 12.011",
                                         "  -0.004 mm ", "DT10003+00012.011M"};
        const QString& frame = kFrames[std::uniform_int_distribution<qsizetype>(0, kFrames.size() - 1)(m_random)];
        const int form = std::uniform_int_distribution(0, 3)(m_random);
        const bool radio = std::uniform_int_distribution(0, 1)(m_random) == 1;
        int told = 0;
        const auto one = connect(wedge(), &ui::GaugeWedge::reading, this, [&] { ++told; });
        const auto two = connect(wedge(), &ui::GaugeWedge::repeated, this, [&] { ++told; });
        const Look before = look();
        const Presses presses(window());
        const QString name =
            where + QStringLiteral(" [%1] “%2” %3%4")
                        .arg(target->objectName().isEmpty() ? QString::fromLatin1(target->metaObject()->className())
                                                            : target->objectName(),
                             frame)
                        .arg(form)
                        .arg(radio ? QStringLiteral(" radio") : QString());
        target->setFocus();
        send(target, frame, radio);
        end(target, form);
        m_now_ms += 6000;
        settle();
        disconnect(one);
        disconnect(two);
        ++m_frames;
        if (told != 1) m_wrong << name + QStringLiteral(": %1 readings").arg(told);
        if (!presses.names().isEmpty()) m_wrong << name + QStringLiteral(": pressed ") + presses.names().join(u',');
        compare(before, name);
    }
    /// The end of a frame is lost: on anything but a field for text nothing happens.
    void halfAFrame(const QPointer<QWidget>& target, const QString& where) {
        QWidget* const widget = target.data();
        if (widget == nullptr || qobject_cast<QLineEdit*>(widget) != nullptr) return;
        const Look before = look();
        const Presses presses(window());
        int told = 0;
        const auto one = connect(wedge(), &ui::GaugeWedge::reading, this, [&] { ++told; });
        widget->setFocus();
        send(target, QStringLiteral(" 50."), true);
        m_now_ms += 600;
        send(target, QStringLiteral("011"), true);
        end(target, 0);
        m_now_ms += 6000;
        settle();
        disconnect(one);
        if (told != 0) m_wrong << where + QStringLiteral(": half a frame was a reading");
        if (!presses.names().isEmpty())
            m_wrong << where + QStringLiteral(": half pressed ") + presses.names().join(u',');
        compare(before, where + QStringLiteral(" half"));
    }
    /// A person's words, key by key and slower than a sender, arrive in a field for text.
    void words(QLineEdit* field, const QString& where) {
        if (field == nullptr || field->isReadOnly() || field->property("gaugeTarget").toBool() ||
            field->validator() != nullptr || field->maxLength() < 8 || field->inputMethodHints() != Qt::ImhNone) {
            return;
        }
        const QPointer<QLineEdit> alive(field);
        const QString before = field->text();
        field->clear();
        field->setFocus();
        for (const QChar c : QStringLiteral("T1.5 b2")) {
            key(alive, c);
            m_now_ms += 140;
        }
        m_now_ms += 1000;
        if (alive) QTest::keyClick(alive, Qt::Key_End);
        if (alive && alive->text() != QStringLiteral("T1.5 b2")) {
            m_wrong << where +
                           QStringLiteral(": “%1” of a person's words in %2").arg(alive->text(), alive->objectName());
        }
        if (alive) alive->setText(before);
    }
    void place(QWidget* here, const QString& where) {
        ++m_places;
        for (const QPointer<QWidget>& target : focusIn(here)) {
            if (target) aFrame(target, where);
            if (target) halfAFrame(target, where);
            if (target) words(qobject_cast<QLineEdit*>(target.data()), where);
        }
    }
    void explore(const QString& page, const QStringList& path) {
        goTo(page, path);
        ui::Sheet* sheet = host()->current();
        if (sheet == nullptr) {
            return;
        }
        const QStringList buttons = buttonsIn(sheet);
        if (!m_seen.insert(path.last() + u'|' + buttons.join(u',')).second) {
            return;
        }
        place(sheet, page + u'/' + path.join(u'/'));
        if (path.size() >= kDeepest) {
            return;
        }
        for (const QString& name : buttons) {
            explore(page, path + QStringList{name});
        }
    }

 private slots:
    void initTestCase() {
        begin("", false);
        if (QTest::currentTestFailed()) return;
        QVERIFY(wedge() != nullptr);
        wedge()->setClock([this] { return m_now_ms; });
        settle();
    }
    void everyPageAndSheet_data() { pageRows(); }
    void everyPageAndSheet() {
        QFETCH(QString, page);
        m_wrong.clear();
        goTo(page, {});
        QWidget* here = placeOf(page);
        QVERIFY(here != nullptr);
        place(here, page);
        for (const QString& name : buttonsIn(here)) {
            explore(page, {name});
        }
        qInfo("%s: %d places, %d frames so far", qPrintable(page), m_places, m_frames);
        QVERIFY2(m_wrong.isEmpty(), qPrintable(m_wrong.join(QStringLiteral("\n"))));
    }
    void somethingWasLookedAt() {
        QVERIFY2(m_places >= 30 && m_frames >= 240, qPrintable(QStringLiteral("%1 %2").arg(m_places).arg(m_frames)));
    }
    void cleanupTestCase() { m_bench.stop(); }
};

QTEST_MAIN(TestConsoleWedge)
#include "tst_console_wedge.moc"
