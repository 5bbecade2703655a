// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "app/service/boring/boring_service.h"

namespace kerf {

/// The service of whatever lot is current: the pages keep this one while the lots behind it come and go. GUI thread.
///
/// A value still on its way to the disk when the lot changes keeps its old service alive until it has been answered, so
/// that nothing typed is lost and nobody waits for ever.
class CurrentBoringService final : public BoringService {
 public:
    CurrentBoringService() = default;

    /// Another lot from now on; tell the listeners with notify().
    void replace(std::unique_ptr<StoredBoringService> service);
    void notify() { m_listeners.tell(); }
    /// @pre a lot has been opened
    [[nodiscard]] StoredBoringService& stored() noexcept { return *m_service; }
    [[nodiscard]] bool open() const noexcept { return m_service != nullptr; }
    void poll();

    [[nodiscard]] const BoringServiceView& view() const override { return m_service->view(); }
    [[nodiscard]] EntryCheck check(const BoreEntry& entry) const override { return m_service->check(entry); }
    [[nodiscard]] BoreImportPlan planImport(const ReadBores& read) const override {
        return m_service->planImport(read);
    }
    void importBores(const ReadBores& read, const std::string& author, bool confirmed, Done done) override {
        m_service->importBores(read, author, confirmed, std::move(done));
    }
    void enter(const BoreEntry& entry, Done done) override { m_service->enter(entry, std::move(done)); }
    void correct(MeasurementId id, double diameter_mm, const std::string& author, const std::string& reason,
                 Done done) override {
        m_service->correct(id, diameter_mm, author, reason, std::move(done));
    }
    [[nodiscard]] EntryCheck checkCorrection(MeasurementId id, double diameter_mm) const override {
        return m_service->checkCorrection(id, diameter_mm);
    }
    void correctValue(const BoreCorrection& correction, Done done) override {
        m_service->correctValue(correction, std::move(done));
    }
    void voidMeasurement(MeasurementId id, const std::string& author, const std::string& reason, Done done) override {
        m_service->voidMeasurement(id, author, reason, std::move(done));
    }
    void undoLast(const std::string& author, Done done) override { m_service->undoLast(author, std::move(done)); }
    void acceptSchedule(const std::string& author, Done done) override {
        m_service->acceptSchedule(author, std::move(done));
    }
    void announceChange(BoringChange change, const std::string& author, Done done) override {
        m_service->announceChange(change, author, std::move(done));
    }
    void withdrawChange(const std::string& author, Done done) override {
        m_service->withdrawChange(author, std::move(done));
    }
    [[nodiscard]] std::optional<double> gaugeReading_mm(PartId part, std::uint8_t depth) override {
        return m_service->gaugeReading_mm(part, depth);
    }
    [[nodiscard]] std::unique_ptr<Subscription> onChanged(std::function<void()> changed) override {
        return m_listeners.add(std::move(changed));
    }

 private:
    std::unique_ptr<StoredBoringService> m_service{};
    std::vector<std::unique_ptr<StoredBoringService>> m_retired{};
    Listeners<> m_listeners{};
    std::unique_ptr<Subscription> m_changes{};
};

}  // namespace kerf
