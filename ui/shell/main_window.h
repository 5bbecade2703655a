// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QMainWindow>
#include <QStackedWidget>
#include <QTimer>
#include <memory>
#include <vector>

#include "ui/shell/page.h"

class QGridLayout;

namespace kerf::ui {

class AlarmBar;
class HeaderBar;
class HeldBand;
class HoldAllButton;
class MachineStrip;
class Navigation;
class ScrollBox;
class TouchKeyboard;

/// The frame around every page: header, navigation, page area, bottom line with HOLD ALL.
///
///     Look look;
///     MainWindow window(look, Services{.engine = engine, .boringService = &service});
///     window.show();
///
/// The frame has its place whatever is on it: long sentences end in an ellipsis, and where the chosen size of text
/// would make it larger than the window it is drawn smaller. Pages scroll inside.
///
/// Look and everything in Services outlive the window. Pages are made when the window is.
class MainWindow : public QMainWindow {
    Q_OBJECT
 public:
    MainWindow(Look& look, Services services, PageList pages, QWidget* parent = nullptr);
    ~MainWindow() override;

    void showPage(const char* key);
    [[nodiscard]] Page* page(const char* key) const;
    [[nodiscard]] const PageList& pages() const { return m_pages; }
    [[nodiscard]] EngineClient& client() { return m_client; }
    [[nodiscard]] OperatorSession& session() { return m_session; }
    [[nodiscard]] SheetHost& sheets() { return *m_sheets; }
    /// What the bottom line says now.
    [[nodiscard]] QString bottomLine() const;

    /// Render every page into `folder` as NN_key.png at the window's present size, theme and language.
    /// Returns the files written; an empty list when the folder cannot be written.
    QStringList renderPages(const QString& folder);

 protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    /// Asks first while finished parts wait for the store, or something is being cut.
    void closeEvent(QCloseEvent* event) override;

 private:
    void setWording();
    void sayStartFindings();
    void buildFrame();
    void buildHeldBand(QGridLayout* grid);
    void refresh();
    void fitPlaces();
    void fitFrame();
    void onStatus(const Status& status);
    void showAlarm();
    void chooseSpeed();
    void withOperator(std::function<void()> action);
    void withRole(Role least, std::function<void()> action);

    Look& m_look;
    Look m_frameLook;  ///< never larger than the frame has room for
    Services m_services;
    PageList m_pages;
    EngineClient m_client;
    OperatorSession m_session;
    AlarmList m_alarms;
    std::unique_ptr<Subscription> m_serviceChanges;
    QTimer m_clock;
    QElapsedTimer m_sinceStart;

    HeaderBar* m_header{nullptr};
    Navigation* m_navigation{nullptr};
    QStackedWidget* m_stack{nullptr};
    SheetHost* m_sheets{nullptr};
    AlarmBar* m_alarmBar{nullptr};
    HoldAllButton* m_holdAll{nullptr};
    QWidget* m_bottom{nullptr};
    QWidget* m_left{nullptr};
    ScrollBox* m_places{nullptr};  ///< the pages, in m_left
    TouchKeyboard* m_keyboard{nullptr};
    HeldBand* m_heldBand{nullptr};
    MachineStrip* m_strip{nullptr};
    bool m_closeAnyway{false};
    std::vector<Page*> m_made;
};

}  // namespace kerf::ui
