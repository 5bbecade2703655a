// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/end_signals.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <QSocketNotifier>
#include <array>
#include <csignal>
#include <cstdint>
#include <utility>

namespace kerf::console {
namespace {

constexpr std::array kSignals{SIGTERM, SIGINT, SIGHUP};
volatile int g_event = -1;

void onSignal(int /*signal*/) {
    const std::uint64_t one = 1;
    (void)!::write(g_event, &one, sizeof one);
}

void handle(void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
    for (const int signal : kSignals) {
        (void)::sigaction(signal, &action, nullptr);
    }
}

}  // namespace

EndSignals::EndSignals(std::function<void()> asked) : m_asked(std::move(asked)) {
    g_event = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
    if (g_event < 0) {
        return;  // they end the program as they always did
    }
    auto* notifier = new QSocketNotifier(g_event, QSocketNotifier::Read, this);
    connect(notifier, &QSocketNotifier::activated, this, [this] {
        std::uint64_t count = 0;
        (void)!::read(g_event, &count, sizeof count);
        m_asked();
    });
    handle(onSignal);
}

EndSignals::~EndSignals() {
    handle(SIG_DFL);
    if (g_event >= 0) {
        ::close(g_event);
        g_event = -1;
    }
}

}  // namespace kerf::console
