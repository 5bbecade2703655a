// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>

/// A step of a walk that checks things itself: nothing goes on after one that has failed.
#define KERF_STEP(call)                   \
    do {                                  \
        call;                             \
        if (QTest::currentTestFailed()) { \
            return;                       \
        }                                 \
    } while (false)
