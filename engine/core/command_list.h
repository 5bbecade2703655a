// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>

namespace kerf {

/// Commands by their types; lists of several processes join to the one variant that crosses the ring.
template <class... Commands>
struct CommandList {
    using Variant = std::variant<Commands...>;

    template <class... Others>
    static CommandList<Commands..., Others...> joined(CommandList<Others...>);
    template <class List>
    using And = decltype(joined(List{}));
};

}  // namespace kerf
