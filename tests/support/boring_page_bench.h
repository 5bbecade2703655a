// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

#include "tests/support/fake_boring_service.h"
#include "tests/support/page_bench.h"
#include "ui/pages/boring/boring_page.h"

namespace kerf::test {

/// The boring page on a lot of the fake service, in a mode that only advises. A test is one, beside being a QObject,
/// and makes it anew for each of its functions.
class BoringPageBench {
 protected:
    BoringPageBench() = default;
    ~BoringPageBench() = default;

    void open() {
        m_service = std::make_unique<FakeBoringService>();
        m_bench = std::make_unique<PageBench>();
        m_bench->services.boringService = m_service.get();
        m_bench->engine.loop(ProcessId::Boring).mode = LoopMode::Advise;
        m_bench->engine.loop(ProcessId::Boring).state = LoopState::Advising;
    }
    void close() {
        m_bench.reset();
        m_service.reset();
    }
    void show() { m_bench->show<ui::BoringPage>(); }
    [[nodiscard]] ui::EntryPanel* entry() { return static_cast<ui::BoringPage*>(m_bench->page)->entry(); }
    [[nodiscard]] ui::DiameterField* field() { return entry()->field(); }
    [[nodiscard]] QString text(const char* name) {
        auto* label = m_bench->find<QLabel>(name);
        return label != nullptr ? label->text() : QString();
    }
    [[nodiscard]] bool visible(const char* name) {
        auto* widget = m_bench->find<QWidget>(name);
        return widget != nullptr && widget->isVisible();
    }

    std::unique_ptr<FakeBoringService> m_service;
    std::unique_ptr<PageBench> m_bench;
};

}  // namespace kerf::test
