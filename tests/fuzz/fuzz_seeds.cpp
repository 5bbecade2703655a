// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <fstream>
#include <string>

#include "tests/fuzz/seeds.h"

/// fuzz_seeds SOURCE FOLDER: the corpus a campaign begins with, a file each.
int main(int count, char** words) {
    if (count != 3) {
        std::fputs("fuzz_seeds SOURCE FOLDER\n", stderr);
        return 2;
    }
    const auto inputs = kerf::test::seedInputs(words[1]);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        std::ofstream file(std::string(words[2]) + "/seed-" + std::to_string(i), std::ios::binary);
        file << inputs[i];
        if (!file.flush()) return 3;
    }
    return 0;
}
