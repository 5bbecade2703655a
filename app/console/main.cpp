// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QScreen>
#include <QTimer>
#include <cstdio>
#include <cstdlib>

#include "app/console/console_application.h"
#include "app/console/end_signals.h"
#include "app/console/first_paint.h"

namespace {

constexpr int kCannotStart = 3;

/// While QApplication is made, a platform that cannot be had is all that ends it: by abort(), after pages about
/// plug-ins.
void noDisplay(QtMsgType type, const QMessageLogContext& /*context*/, const QString& /*message*/) {
    if (type == QtFatalMsg) {
        std::fprintf(stderr,
                     "kerf-console: No display can be reached: start it on a screen, or with QT_QPA_PLATFORM=offscreen "
                     "without one.\n");
        std::_Exit(kCannotStart);
    }
}
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
    qInstallMessageHandler(noDisplay);
    QApplication application(argc, argv);
    qInstallMessageHandler(nullptr);
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
        if (options->timeStart) {
            new console::FirstPaint(window, [](int without) {
                printLine(QStringLiteral("painted, %1 times without content before").arg(without));
                QCoreApplication::exit(0);
            });
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
