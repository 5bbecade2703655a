// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/boring/boring_service.h"

namespace kerf {

void openBoringLot(StoreWriter& writer, const BoringLotRequest& request,
                   std::function<void(const Result<LotId>&)> done) {
    using Answer = const Result<Receipt>&;
    const auto failed = [done](Answer receipt) { done(tl::unexpected(receipt.error())); };
    writer.submit(EnsureMachine{request.machineName, request.machineKind}, [&writer, request, done,
                                                                            failed](Answer machine) {
        if (!machine) {
            return failed(machine);
        }
        const EnsurePartType type{ProcessId::Boring, request.partTypeName, recipeJson(request.recipe), request.author};
        writer.submit(type, [&writer, request, done, failed, machineId = machine->id](Answer partType) {
            if (!partType) {
                return failed(partType);
            }
            const EnsureLot lot{machineId,       partType->id,    partType->second,
                                request.lotName, request.lotSize, boring::estimatorKey(request.estimator),
                                request.author};
            writer.submit(lot, [&writer, request, done, failed](Answer opened) {
                if (!opened) {
                    return failed(opened);
                }
                writer.submit(SetActiveLot{ProcessId::Boring, opened->id, request.author},
                              [done, failed, id = opened->id](Answer active) { active ? done(id) : failed(active); });
            });
        });
    });
}

}  // namespace kerf
