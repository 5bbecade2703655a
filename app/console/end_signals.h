// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>

namespace kerf::console {

/// SIGTERM, SIGINT and SIGHUP (the computer is shut down, the session or the terminal ends) end the program in its
/// event loop, where everything that has been made is stored and the machine is given back. Nobody is asked: nobody may
/// be there. A second signal ends it as it always did. One object per program.
class EndSignals : public QObject {
 public:
    explicit EndSignals(std::function<void()> asked);
    ~EndSignals() override;

 private:
    std::function<void()> m_asked;
};

}  // namespace kerf::console
