// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/machine/linuxcnc/port_exposure.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>

namespace kerf::linuxcnc {
namespace {

constexpr int kPatience_ms = 200;

bool answers(sockaddr_in address, std::uint16_t port) {
    address.sin_port = htons(port);
    const int file = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (file < 0) {
        return false;
    }
    bool open = ::connect(file, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    if (!open && errno == EINPROGRESS) {
        pollfd wait{file, POLLOUT, 0};
        int error = 0;
        socklen_t size = sizeof error;
        open = ::poll(&wait, 1, kPatience_ms) == 1 && ::getsockopt(file, SOL_SOCKET, SO_ERROR, &error, &size) == 0 &&
               error == 0;
    }
    ::close(file);
    return open;
}

}  // namespace

std::string openAddress(std::uint16_t port) {
    ifaddrs* list = nullptr;
    if (::getifaddrs(&list) != 0) {
        return {};
    }
    std::string found;
    for (const ifaddrs* each = list; each != nullptr && found.empty(); each = each->ifa_next) {
        const bool usable = each->ifa_addr != nullptr && each->ifa_addr->sa_family == AF_INET &&
                            (each->ifa_flags & IFF_LOOPBACK) == 0 && (each->ifa_flags & IFF_UP) != 0;
        if (!usable) {
            continue;
        }
        const auto address = *reinterpret_cast<const sockaddr_in*>(each->ifa_addr);
        if (answers(address, port)) {
            std::array<char, INET_ADDRSTRLEN> text{};
            (void)inet_ntop(AF_INET, &address.sin_addr, text.data(), text.size());
            found = text.data();
        }
    }
    ::freeifaddrs(list);
    return found;
}

}  // namespace kerf::linuxcnc
