// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>

namespace kerf::ui {
class MainWindow;
}

namespace kerf::console {

/// Watches the first paints of the window: `done` is called once the first page has been painted with its content (a
/// card for each loop of the machine), and says how often it had been painted without before.
class FirstPaint : public QObject {
 public:
    FirstPaint(ui::MainWindow& window, std::function<void(int without)> done);

 protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

 private:
    [[nodiscard]] bool hasContent() const;

    ui::MainWindow& m_window;
    std::function<void(int)> m_done;
    int m_without{0};
    bool m_seen{false};
};

}  // namespace kerf::console
