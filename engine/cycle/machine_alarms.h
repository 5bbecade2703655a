// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "engine/core/alarm.h"

/// Alarms of engine and machine, codes 1-99.
namespace kerf::machine_alarm {

inline constexpr AlarmCode kLinkDown = 1;
inline constexpr AlarmCode kEmergencyStop = 2;
inline constexpr AlarmCode kPartStoreFull = 3;
inline constexpr AlarmCode kOverruns = 4;
inline constexpr AlarmCode kPartUnrecorded = 9;
inline constexpr AlarmCode kNotCarriedOut = 11;
inline constexpr AlarmCode kShopOutOfReach = 90;   ///< raised by the console
inline constexpr AlarmCode kCommandPortOpen = 10;  ///< raised by the console, not by the cycle

inline constexpr std::array kSpecs{
    AlarmSpec{
        kLinkDown, 1, KERF_TEXT("No connection to the machine"),
        KERF_TEXT("The control no longer answers: cable, network or the control itself."),
        KERF_TEXT(
            "All loops are held. The control goes on with its last offset, at most at the planned feed; a program "
            "without one is held."),
        KERF_TEXT(
            "Check the control and the cable. Kerf connects again by itself; look at the machine, then release the "
            "hold.")},
    AlarmSpec{
        kEmergencyStop, 1, KERF_TEXT("Emergency stop"), KERF_TEXT("The emergency stop of the machine is pressed."),
        KERF_TEXT("The control has ended the program. All loops are held until a person has looked; stops stay."),
        KERF_TEXT("Make the machine safe, reset the emergency stop at the control, look, then release the hold.")},
    AlarmSpec{kPartStoreFull, 1, KERF_TEXT("Finished parts are not being stored"),
              KERF_TEXT("The database does not take records: disk full, or the file is locked."),
              KERF_TEXT("The finished part is kept in memory. No new part can be started."),
              KERF_TEXT("Free disk space or end the program that locks the file. Storing goes on by itself.")},
    AlarmSpec{
        kPartUnrecorded, 1, KERF_TEXT("A finished part was not recorded"),
        KERF_TEXT("A part was begun at the control while finished parts could not be stored, and there is no place "
                  "left to keep them."),
        KERF_TEXT("This part and those after it stand nowhere: neither figures nor feed of them are kept."),
        KERF_TEXT("Begin no part at the control until storing goes on. Note these parts down by hand.")},
    AlarmSpec{kOverruns, 3, KERF_TEXT("The engine misses its deadlines"),
              KERF_TEXT("This computer is too busy, or real-time scheduling is not allowed."),
              KERF_TEXT("Loops react later than designed. Feed and offsets stay inside their limits."),
              KERF_TEXT("End other programs. See Diagnostics for cycle times and how to allow real-time scheduling.")},
    AlarmSpec{kNotCarriedOut, 2, KERF_TEXT("A command was not carried out"),
              KERF_TEXT("The control or a rule of Kerf's has refused it, or nothing came of it."),
              KERF_TEXT("What was asked for has not happened. The machine stands as it stood before."),
              KERF_TEXT("Read the reason beside it, look at the control's own message, put it right and ask again.")},
    AlarmSpec{kShopOutOfReach, 3, KERF_TEXT("The shop's store is out of reach"),
              KERF_TEXT("Network, server or sign-on: the Diagnostics page says what it answered last."),
              KERF_TEXT("Nothing is lost: parts and values wait here and travel when it answers again."),
              KERF_TEXT("Nothing to do at the machine. Tell whoever looks after the server when it stays.")},
    AlarmSpec{kCommandPortOpen, 2, KERF_TEXT("The control's command port is open to the network"),
              KERF_TEXT("linuxcncrsh answers on an address that other computers reach, with passwords that everybody "
                        "knows."),
              KERF_TEXT("Whoever reaches this computer may move the machine."),
              KERF_TEXT("Close the port in the firewall and give it passwords of your own: see the LinuxCNC guide, "
                        "\"Close the port\". Then start the console anew.")},
};

}  // namespace kerf::machine_alarm
