// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/main_window.h"

#include <QAbstractButton>
#include <QApplication>
#include <QCloseEvent>
#include <QDateTime>
#include <QDir>
#include <QElapsedTimer>
#include <QEvent>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QResizeEvent>
#include <QScrollBar>
#include <cstring>

#include "ui/dialogs/first_engineer_sheet.h"
#include "ui/dialogs/operator_chooser.h"
#include "ui/dialogs/settings_sheet.h"
#include "ui/dialogs/tool_sheet.h"
#include "ui/entry/touch_keyboard.h"
#include "ui/help/help_mode.h"
#include "ui/link/release_stop.h"
#include "ui/link/texts.h"
#include "ui/pages/boring/lot_form.h"
#include "ui/services/command_deeds.h"
#include "ui/services/shift_service.h"
#include "ui/shell/header_bar.h"
#include "ui/shell/held_band.h"
#include "ui/shell/machine_strip.h"
#include "ui/shell/navigation.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/alarm_bar.h"
#include "ui/widgets/hold_all_button.h"
#include "ui/widgets/scroll_box.h"

namespace kerf::ui {
namespace {
constexpr int kSettling_ms = 400;  // before a page is rendered to a file
constexpr double kFrameDpi = 96.0;
constexpr QSize kFrameSize{1280, 800};  // the frame is drawn for this at 96 dpi, and grows with the window
constexpr QSize kSmallFrame{1024, 700};
constexpr double kSmallestFrame = 0.6;
}  // namespace

MainWindow::MainWindow(Look& look, Services services, PageList pages, QWidget* parent)
    : QMainWindow(parent),
      m_look(look),
      m_frameLook(look),
      m_services(std::move(services)),
      m_pages(std::move(pages)),
      m_client(m_services.engine),
      m_session(m_services.signOn),
      m_alarms(m_services.engine) {
    setObjectName(QStringLiteral("mainWindow"));
    m_sinceStart.start();
    qApp->installEventFilter(this);  // before the first widget is polished
    buildFrame();
    connect(&m_look, &Look::changed, this, [this] {
        refresh();
        if (m_services.savePreferences) {
            m_services.savePreferences(m_look.preferences());
        }
    });
    connect(&m_client, &EngineClient::statusChanged, this, &MainWindow::onStatus);
    connect(&m_client, &EngineClient::alarmArrived, this,
            [this](const AlarmEvent& event) { m_alarms.take(event, QDateTime::currentDateTime()); });
    connect(&m_client, &EngineClient::refused, this, [this](const Sentence& reason) {
        m_alarmBar->notify(tr("Not done: %1").arg(sentenceText(reason, m_look.units())));
    });
    connect(&m_alarms, &AlarmList::changed, this, &MainWindow::showAlarm);
    connect(&m_alarms, &AlarmList::acknowledgedByOperator, this, [this](AlarmCode code, const QString& author) {
        if (m_services.acknowledgeAlarm) {
            m_services.acknowledgeAlarm(code, author);
        }
    });
    connect(&m_session, &OperatorSession::settingsChanged, this, [this](const SignOnSettings& settings) {
        if (m_services.saveSignOn) {
            m_services.saveSignOn(settings);
        }
    });
    connect(&m_session, &OperatorSession::changed, this, [this] { setWording(); });
    connect(&m_session, &OperatorSession::audited, this,
            [this](const QString& author, const QString& action, const QString& detail) {
                if (m_services.recordSession) {
                    m_services.recordSession(author, action, detail);
                }
            });
    connect(&m_session, &OperatorSession::wrongPins, this, [this](const QString& name, unsigned tries, qint64 last_ms) {
        if (m_services.saveWrongPins) {
            m_services.saveWrongPins(name, tries, last_ms);
        }
    });
    // One place for all pages: what somebody may not do is not even sent.
    m_client.setGuard([this](const Command& command) {
        const auto deed = deedOf(command);
        if (!deed || m_session.may(permissionOf(*deed).least)) {
            return Sentence();
        }
        return m_session.signedOn() ? onlyWho(permissionOf(*deed).least)
                                    : Sentence(KERF_TEXT("Sign on first: a change needs a name."));
    });
    if (m_services.boringService != nullptr) {
        m_serviceChanges = m_services.boringService->onChanged([this] { onStatus(m_client.status()); });
    }
    m_clock.setInterval(1000);
    connect(&m_clock, &QTimer::timeout, this, [this] {
        m_header->setTime(QDateTime::currentDateTime().toString(QStringLiteral("HH:mm")));
        m_session.tick(m_sinceStart.elapsed());
    });
    m_clock.start();
    m_header->setTime(QDateTime::currentDateTime().toString(QStringLiteral("HH:mm")));
    setWording();
    refresh();
    m_client.tick();
    m_client.start();
    sayStartFindings();
}

// Figures are named as the one who is signed on wants them.
void MainWindow::setWording() {
    m_look.setRole(static_cast<std::size_t>(m_session.role().value_or(Role::Operator)));
}

void MainWindow::sayStartFindings() {
    QStringList lines;
    for (const Sentence& finding : m_services.startFindings) {
        lines << sentenceText(finding, m_look.units());
    }
    if (!lines.isEmpty()) {
        m_sheets->tell(tr("The data file"), lines.join(QStringLiteral("\n")));
        m_sheets->current()->followLanguage([this] { sayStartFindings(); });
    } else if (m_session.firstEngineerMissing()) {
        askFirstEngineer(m_look, *m_sheets, m_session);
    }
}

void MainWindow::closeEvent(QCloseEvent* event) {
    const std::size_t waiting = m_services.partsWaiting ? m_services.partsWaiting() : 0;
    const ProgramState program = m_client.status().program;
    const bool cutting = program == ProgramState::Running || program == ProgramState::Paused;
    if (m_closeAnyway || (waiting == 0 && !cutting)) {
        QMainWindow::closeEvent(event);
        return;
    }
    event->ignore();
    if (waiting == 0) {
        m_sheets->ask(tr("A part is being cut"),
                      tr("Ending Kerf lets go of it: the machine goes on at or below its planned feed, with its last "
                         "offset, and what is cut from now on is not recorded."),
                      tr("Stay"), tr("End Kerf"), [this] {
                          m_closeAnyway = true;
                          close();
                      });
        m_sheets->current()->followLanguage([this] { close(); });
        return;
    }
    m_sheets->ask(tr("Finished parts wait"),
                  tr("The store does not take %1 finished parts. Ending Kerf keeps them beside the data file; the next "
                     "start stores them.")
                      .arg(waiting),
                  tr("Stay"), tr("End Kerf"), [this] {
                      m_closeAnyway = true;
                      close();
                  });
    m_sheets->current()->followLanguage([this] { close(); });
}

MainWindow::~MainWindow() {
    m_client.stop();
}

void MainWindow::buildFrame() {
    auto* central = new QWidget(this);
    setCentralWidget(central);
    auto* grid = new QGridLayout(central);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(0);

    auto* top = new QFrame(central);
    top->setObjectName(QStringLiteral("topLine"));
    top->setProperty("role", QStringLiteral("bar"));
    auto* topRow = new QHBoxLayout(top);
    m_header = new HeaderBar(m_frameLook, m_session, top);
    topRow->addWidget(m_header);
    grid->addWidget(top, 0, 0, 1, 2);

    auto* left = new QFrame(central);
    left->setProperty("role", QStringLiteral("bar"));
    auto* leftColumn = new QVBoxLayout(left);
    leftColumn->setContentsMargins(0, 0, 0, 0);
    m_navigation = new Navigation(m_frameLook, m_pages, left);
    m_places = new ScrollBox(left);
    m_places->setContent(m_navigation);
    leftColumn->addWidget(m_places);
    m_left = left;
    // Later: the range changes in the midst of the list's own fitting.
    connect(m_places->verticalScrollBar(), &QScrollBar::rangeChanged, this, &MainWindow::fitPlaces,
            Qt::QueuedConnection);
    grid->addWidget(left, 2, 0);

    auto* work = new QWidget(central);
    auto* workColumn = new QVBoxLayout(work);
    workColumn->setContentsMargins(0, 0, 0, 0);
    workColumn->setSpacing(0);
    m_strip = new MachineStrip(m_frameLook, work);
    workColumn->addWidget(m_strip);
    m_sheets = new SheetHost(m_look, work);
    workColumn->addWidget(m_sheets, 1);
    auto* pageArea = new QVBoxLayout(m_sheets);
    pageArea->setContentsMargins(0, 0, 0, 0);
    m_stack = new QStackedWidget(m_sheets);
    pageArea->addWidget(m_stack);
    grid->addWidget(work, 2, 1);
    grid->setRowStretch(2, 1);
    grid->setColumnStretch(1, 1);

    auto* bottom = new QFrame(central);
    bottom->setObjectName(QStringLiteral("bottomLine"));
    bottom->setProperty("role", QStringLiteral("bar"));
    auto* bottomRow = new QHBoxLayout(bottom);
    m_alarmBar = new AlarmBar(m_frameLook, bottom);
    m_holdAll = new HoldAllButton(m_frameLook, m_services.engine, bottom);
    bottomRow->addWidget(m_alarmBar, 1);
    bottomRow->addWidget(m_holdAll);
    m_bottom = bottom;
    grid->addWidget(bottom, 3, 0, 1, 2);
    buildHeldBand(grid);

    const PageContext context{m_look,
                              m_services,
                              m_client,
                              m_session,
                              m_alarms,
                              *m_sheets,
                              [this](const char* key) { showPage(key); },
                              [this](const QString& sentence) { m_alarmBar->notify(sentence); },
                              [this](std::function<void()> action) { withOperator(std::move(action)); },
                              [this](Role least, std::function<void()> action) { withRole(least, std::move(action)); },
                              &m_pages};
    for (const PageEntry& entry : m_pages) {
        Page* made = entry.make(context);
        made->setProperty("pageKey", QLatin1String(entry.key));
        auto* room = new ScrollBox(m_stack);
        room->setContent(made);
        m_stack->addWidget(room);
        m_made.push_back(made);
    }
    connect(m_navigation, &Navigation::chosen, this, [this](std::size_t index) { showPage(m_pages[index].key); });
    m_header->setLots(m_services.boringLots != nullptr && m_services.boringService != nullptr);
    connect(m_header, &HeaderBar::lotsRequested, this, [context] { LotForm::open(context); });
    if (m_services.shiftService != nullptr) {
        connect(m_strip, &MachineStrip::touched, this, [context] { openTools(context); });
    }
    connect(m_header, &HeaderBar::operatorRequested, this, [this] { chooseOperator(m_look, *m_sheets, m_session); });
    connect(m_header, &HeaderBar::settingsRequested, this, [this] { openSettings(m_look, *m_sheets); });
    connect(m_header, &HeaderBar::languageRequested, this, [this] {
        if (!m_sheets->languageMayChange()) {
            m_alarmBar->notify(tr("Close what is open first: it keeps the language it was opened in."));
            return;
        }
        Preferences preferences = m_look.preferences();
        preferences.language = preferences.language == Language::Korean ? Language::English : Language::Korean;
        m_look.apply(preferences);
    });
    connect(m_header, &HeaderBar::speedRequested, this, &MainWindow::chooseSpeed);
    auto* help = new HelpMode(m_look, *m_sheets, this);
    connect(m_header, &HeaderBar::helpRequested, this, [this, help](bool on) {
        help->setActive(on);
        if (on) {
            m_alarmBar->notify(tr("Touch what you want explained."));
        }
    });
    connect(help, &HelpMode::changed, m_header, &HeaderBar::setHelp);
    connect(m_alarmBar, &AlarmBar::showRequested, this, [this] { showPage("alarms"); });
    if (!m_pages.empty()) {
        showPage(m_pages.front().key);
    }
    m_keyboard = new TouchKeyboard(m_frameLook, m_sheets);
    m_sheets->setFocusPolicy(Qt::ClickFocus);
    m_sheets->setFocus();  // no button has the focus before somebody wants it
}

void MainWindow::buildHeldBand(QGridLayout* grid) {
    m_heldBand = new HeldBand(m_frameLook, m_client, centralWidget());
    grid->addWidget(m_heldBand, 1, 0, 1, 2);
    connect(m_holdAll, &QPushButton::pressed, this, [this] { m_heldBand->pressedBy(m_session.name()); });
    connect(m_heldBand, &HeldBand::releaseHoldRequested, this, [this] { m_client.sendAction(ReleaseHold{}); });
    connect(m_heldBand, &HeldBand::releaseStopRequested, this, [this](const Status& shown, ProcessId process) {
        // As shown: what comes while somebody signs on is looked at anew.
        withOperator([this, shown, process] { m_client.sendAction(releaseOf(shown, process, m_session.author())); });
    });
    connect(m_heldBand, &HeldBand::showRequested, this, [this](ProcessId process) { showPage(processKey(process)); });
}

void MainWindow::showPage(const char* key) {
    for (std::size_t i = 0; i < m_pages.size(); ++i) {
        if (std::strcmp(m_pages[i].key, key) == 0) {
            m_stack->setCurrentIndex(static_cast<int>(i));
            m_navigation->setCurrent(i);
            return;
        }
    }
}

Page* MainWindow::page(const char* key) const {
    for (std::size_t i = 0; i < m_pages.size(); ++i) {
        if (std::strcmp(m_pages[i].key, key) == 0) {
            return m_made[i];
        }
    }
    return nullptr;
}

QString MainWindow::bottomLine() const {
    return m_alarmBar->text();
}

QStringList MainWindow::renderPages(const QString& folder) {
    QStringList written;
    if (!QDir().mkpath(folder)) {
        return written;
    }
    const int before = m_stack->currentIndex();
    for (std::size_t i = 0; i < m_pages.size(); ++i) {
        showPage(m_pages[i].key);
        m_client.tick();
        QElapsedTimer settling;  // layouts, and numbers that show themselves five times a second
        for (settling.start(); settling.elapsed() < kSettling_ms;) {
            QCoreApplication::processEvents(QEventLoop::AllEvents, kSettling_ms);
        }
        const QString name =
            QStringLiteral("%1_%2.png").arg(i + 1, 2, 10, QLatin1Char('0')).arg(QLatin1String(m_pages[i].key));
        const QString path = QDir(folder).filePath(name);
        if (grab().save(path)) {
            written << path;
        }
    }
    if (before >= 0) {
        showPage(m_pages[static_cast<std::size_t>(before)].key);
    }
    return written;
}

void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::LanguageChange && m_header != nullptr) {
        refresh();
    }
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::KeyPress:
        case QEvent::MouseButtonPress:
        case QEvent::TouchBegin:
        case QEvent::Wheel:
            m_session.touched(m_sinceStart.elapsed());
            break;
        case QEvent::Polish:
            // A touch on a button leaves the keys with the field that waits; Tab reaches buttons all the same.
            if (auto* button = qobject_cast<QAbstractButton*>(watched);
                button != nullptr && (button->focusPolicy() & Qt::ClickFocus) != 0) {
                button->setFocusPolicy(Qt::TabFocus);
            }
            if (auto* button = qobject_cast<QAbstractButton*>(watched)) {
                static_cast<QObject*>(button)->event(event);  // polished first
                forgetStyledWidth(*button);
                return true;
            }
            break;
        case QEvent::StyleChange:
            if (auto* button = qobject_cast<QAbstractButton*>(watched)) {
                forgetStyledWidth(*button);
            }
            break;
        default:
            break;
    }
    return QMainWindow::eventFilter(watched, event);
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
    // Keys that nobody wanted go to the field for diameters, if one waits on this page.
    QWidget* room =
        m_sheets->current() != nullptr ? static_cast<QWidget*>(m_sheets->current()) : m_stack->currentWidget();
    for (QLineEdit* field : room->findChildren<QLineEdit*>()) {
        if (field->property("gaugeTarget").toBool() && field->isVisible() && field->isEnabled() && !field->hasFocus() &&
            !event->text().isEmpty() && event->text().front().isDigit()) {
            field->setFocus();
            QApplication::sendEvent(field, event);
            return;
        }
    }
    QMainWindow::keyPressEvent(event);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    fitFrame();
}

void MainWindow::fitFrame() {
    const double dots = m_look.dpi() / kFrameDpi;
    const auto share = [this, dots](const QSize& screen) {
        return qMin(width() / (dots * screen.width()), height() / (dots * screen.height()));
    };
    m_frameLook.limitScale(qBound(kSmallestFrame, qMax(share(kFrameSize), qMin(1.0, share(kSmallFrame))), 2.5));
    const bool own = m_frameLook.metrics().scale() != m_look.metrics().scale();
    const QString sheet = own ? ui::styleSheet(m_frameLook) : QString();
    for (QWidget* part :
         std::initializer_list<QWidget*>{m_header->parentWidget(), m_left, m_bottom, m_heldBand, m_keyboard}) {
        if (part->styleSheet() != sheet) {
            part->setStyleSheet(sheet);
        }
        part->setFont(own ? m_frameLook.font(TextSize::Body) : QFont());
    }
    const int medium = m_frameLook.space(Space::Medium);
    for (QWidget* bar : {m_header->parentWidget(), m_bottom}) {
        bar->layout()->setContentsMargins(2 * medium, medium / 2, 2 * medium, medium / 2);
        bar->layout()->setSpacing(m_frameLook.metrics().touchGap());
    }
    fitPlaces();
    setMinimumSize(qRound(dots * 640), qRound(dots * 480));
}

// Where the pages do not all stand below each other (the held band takes its place), the bar stands beside their names.
void MainWindow::fitPlaces() {
    const QScrollBar* bar = m_places->verticalScrollBar();
    const int width = m_frameLook.metrics().navWidth() + (bar->maximum() > 0 ? bar->sizeHint().width() : 0);
    if (width != m_left->width()) {
        m_left->setFixedWidth(width);
        QCoreApplication::postEvent(m_navigation, new QEvent(QEvent::LayoutRequest));  // then the list takes its place
    }
}

void MainWindow::refresh() {
    setWindowTitle(tr("Kerf – operator console"));
    fitFrame();
    showAlarm();
    onStatus(m_client.status());
}

void MainWindow::onStatus(const Status& status) {
    m_header->setStatus(status, m_services.engine.capabilities());
    m_header->setWork(m_services.boringService != nullptr ? &m_services.boringService->view() : nullptr, status);
    m_navigation->setStatus(status);
    StripTool tool;
    if (m_services.shiftService != nullptr) {
        for (const ToolLife& life : m_services.shiftService->tools()) {
            if (life.process == status.programProcess) {
                tool = {life.parts, {}, true};
                if (life.life > 0) {
                    tool.partsLeft = life.life - qMin(life.life, life.parts);
                }
            }
        }
    }
    m_strip->setStatus(status, tool);
    m_holdAll->setHeld(status.held);
    m_heldBand->setStatus(status);
}

void MainWindow::showAlarm() {
    m_navigation->setAlarmCount(m_alarms.unacknowledged());
    const AlarmEntry* first = m_alarms.firstUnacknowledged();
    if (first == nullptr) {
        m_alarmBar->clearAlarm();
        return;
    }
    const AlarmText text = alarmText(m_alarms.spec(first->code), first->code);
    QStringList words{text.title};
    const QString detail = sentenceText(first->detail, m_look.units());
    if (!detail.isEmpty()) {
        words << detail;
    }
    if (!first->active()) {
        words << tr("gone since %1, not seen yet").arg(first->cleared->toString(QStringLiteral("HH:mm:ss")));
    } else if (!text.action.isEmpty()) {
        words << text.action;
    }
    m_alarmBar->setAlarm(first->priority, words.join(QStringLiteral(" – ")), m_alarms.unacknowledged() - 1);
}

void MainWindow::chooseSpeed() {
    Sheet* sheet = m_sheets->open(tr("Simulator speed"), tr("Machine time per second on the clock."));
    auto* grid = new QGridLayout;
    grid->setSpacing(m_look.metrics().touchGap());
    int column = 0;
    for (const double factor : {1.0, 5.0, 20.0, 100.0, 1000.0}) {
        auto* button = new QPushButton(QStringLiteral("×%1").arg(factor), sheet);
        button->setObjectName(QStringLiteral("speed%1").arg(factor));
        connect(button, &QPushButton::clicked, sheet, [this, sheet, factor] {
            m_client.sendAction(SetSimulationSpeed{factor});
            sheet->close();
        });
        grid->addWidget(button, 0, column++);
    }
    sheet->body()->addLayout(grid);
    sheet->addButton(tr("Cancel"), {})->setObjectName(QStringLiteral("sheetSafe"));
}

void MainWindow::withOperator(std::function<void()> action) {
    if (m_session.signedOn()) {
        action();
    } else {
        chooseOperator(m_look, *m_sheets, m_session, std::move(action));
    }
}

void MainWindow::withRole(Role least, std::function<void()> action) {
    withOperator([this, least, action = std::move(action)] {
        if (const QString why = m_session.whyNot(least); why.isEmpty()) {
            action();
        } else {
            m_alarmBar->notify(why);
        }
    });
}

}  // namespace kerf::ui
