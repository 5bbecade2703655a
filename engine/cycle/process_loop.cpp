// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/cycle/process_loop.h"

#include "engine/api/status.h"
#include "engine/cycle/event_sink.h"

namespace kerf {

void ProcessLoop::nameOrder(const WorkOrder& order) noexcept {
    if (m_inPart && !m_named) {
        m_partOrder = order;
    }
    m_order = order;
    m_named = true;
}

void ProcessLoop::beginOrder() noexcept {
    m_partOrder = m_order;
    m_inPart = true;
}

PartRecord ProcessLoop::beginRecord(const MachineInputs& inputs) noexcept {
    beginOrder();
    PartRecord part;
    part.process = id();
    part.partSequence = inputs.partSequence;
    part.begin_ns = inputs.time_ns;
    return part;
}

void ProcessLoop::finishRecord(PartRecord& part, std::int64_t now_ns, bool complete, EventSink& events) noexcept {
    m_inPart = false;
    part.order = m_partOrder;
    part.complete = complete;
    part.end_ns = now_ns;
    events.finishPart(part);
}

}  // namespace kerf
