// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "app/desk/boring_desk.h"

namespace kerf {

/// The desk of whatever lot is current: the pages keep this one while the lots behind it come and go. GUI thread.
///
/// A value still on its way to the disk when the lot changes keeps its old desk alive until it has been answered, so
/// that nothing typed is lost and nobody waits for ever.
class CurrentBoringDesk final : public BoringDesk {
 public:
    CurrentBoringDesk() = default;

    /// Another lot from now on; tell the listeners with notify().
    void replace(std::unique_ptr<StoredBoringDesk> desk);
    void notify() { m_listeners.notify(); }
    /// @pre a lot has been opened
    [[nodiscard]] StoredBoringDesk& stored() noexcept { return *m_desk; }
    [[nodiscard]] bool open() const noexcept { return m_desk != nullptr; }
    void poll();

    [[nodiscard]] const BoringDeskView& view() const override { return m_desk->view(); }
    [[nodiscard]] EntryCheck check(const BoreEntry& entry) const override { return m_desk->check(entry); }
    void enter(const BoreEntry& entry, Done done) override { m_desk->enter(entry, std::move(done)); }
    void correct(MeasurementId id, double diameter_mm, const std::string& author, const std::string& reason,
                 Done done) override {
        m_desk->correct(id, diameter_mm, author, reason, std::move(done));
    }
    void voidMeasurement(MeasurementId id, const std::string& author, const std::string& reason, Done done) override {
        m_desk->voidMeasurement(id, author, reason, std::move(done));
    }
    void undoLast(const std::string& author, Done done) override { m_desk->undoLast(author, std::move(done)); }
    void acceptSchedule(const std::string& author, Done done) override {
        m_desk->acceptSchedule(author, std::move(done));
    }
    [[nodiscard]] std::optional<double> gaugeReading_mm(PartId part, std::uint8_t depth) override {
        return m_desk->gaugeReading_mm(part, depth);
    }
    [[nodiscard]] std::unique_ptr<Subscription> onChanged(std::function<void()> changed) override {
        return m_listeners.add(std::move(changed));
    }

 private:
    std::unique_ptr<StoredBoringDesk> m_desk{};
    std::vector<std::unique_ptr<StoredBoringDesk>> m_retired{};
    DeskListeners m_listeners{};
    std::unique_ptr<Subscription> m_changes{};
};

}  // namespace kerf
