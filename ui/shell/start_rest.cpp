// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/start_rest.h"

#include <QCoreApplication>
#include <utility>

namespace kerf::ui {
namespace {

struct StartRest {
    Q_DECLARE_TR_FUNCTIONS(StartRest)
};

}  // namespace

void restUntilShown(ActionButton* start, const PageContext& context,
                    std::function<std::optional<ProcessId>()> process) {
    const auto rests = [&services = context.services, &client = context.client, process = std::move(process)] {
        const std::optional<ProcessId> id = process();
        if (!id) {
            return false;
        }
        const auto place = static_cast<std::size_t>(*id);
        return (services.underWay && services.underWay(*id)) ||
               client.engine().status().orders[place] != client.status().orders[place];
    };
    start->setRest([rests] { return rests() ? StartRest::tr("Loading what was just stored.") : QString(); });
    QObject::connect(&context.client, &EngineClient::statusChanged, start, [start, rests] {
        if (rests() || !start->isEnabled()) {
            start->reconsider();
        }
    });
}

}  // namespace kerf::ui
