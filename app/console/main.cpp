// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QScreen>
#include <QTimer>
#include <cstdio>

#include "app/console/console_application.h"
#include "app/console/end_signals.h"

namespace {

constexpr int kCannotStart = 3;
constexpr int kLiveBeforeScreenshot_ms = 3000;  // so that the live charts have something to show

void printLine(const QString& line) {
    std::fprintf(stdout, "%s\n", qPrintable(line));
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    using namespace kerf;
    int exitCode = 0;
    const auto options = console::parseOptions(argc, argv, exitCode);
    if (!options) {
        return exitCode;
    }
    QApplication application(argc, argv);
    QApplication::setApplicationName(QStringLiteral("kerf"));
    QApplication::setApplicationVersion(QStringLiteral(KERF_VERSION));

    console::ConsoleApplication console(*options);
    const console::EndSignals ended([] { QCoreApplication::exit(0); });
    const auto giveUp = [](const QString& sentence) {
        std::fprintf(stderr, "kerf-console: %s\n", qPrintable(sentence));
        QCoreApplication::exit(kCannotStart);
    };
    QObject::connect(&console, &console::ConsoleApplication::failed, &application, giveUp);
    if (options->printAcceptances) {
        QObject::connect(&console, &console::ConsoleApplication::accepted, &application, printLine);
    }
    QObject::connect(&console, &console::ConsoleApplication::ready, &application, [&console, &options] {
        ui::MainWindow& window = *console.window();
        if (options->size) {
            window.resize(*options->size);
        }
        if (options->screenshotDir.empty()) {
            if (options->fullScreen) {
                // A bare X server (scripts/run --vnc) has no window manager to do it.
                window.setGeometry(window.screen()->geometry());
                window.showFullScreen();
            } else {
                window.show();
            }
            return;
        }
        window.show();
        const auto render = [&console, &options] {
            QTimer::singleShot(kLiveBeforeScreenshot_ms, console.window(), [&console, &options] {
                const QStringList files = console.window()->renderPages(QString::fromStdString(options->screenshotDir));
                for (const QString& file : files) {
                    printLine(file);
                }
                QCoreApplication::exit(files.isEmpty() ? kCannotStart : 0);
            });
        };
        if (console.shift() == nullptr || console.shift()->prepared()) {
            render();
        } else {
            QObject::connect(console.shift(), &console::SimulatedShift::preparationDone, console.window(), render);
        }
    });
    if (const auto started = console.start(); !started) {
        std::fprintf(stderr, "kerf-console: %s\n", started.error().english().c_str());
        return kCannotStart;
    }
    return QApplication::exec();
}
