#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Truth and announcement files for `kerf boring simulate --lots`: a machine's life lot by lot.

Every machine has means of its own: level (ln d at a feed of .17 mm/rev and an overhang of sqrt(40*310) mm) of
ln .1165 + N(0, .3), alpha uniform .4-.8, beta uniform .1-.6. Every insert is drawn normally about them, with the spreads
given. Lots of 30 parts; new inserts with parts 1, 11 and 21, the last two announced.
--unrelated lot: the means are drawn anew for every lot; --unrelated insert: for every insert.
--shop MACHINES LEVEL ALPHA BETA: so many machines after one another form a shop; their means are drawn normally about the
shop's, with the spreads given. --odd: but not those of the last one, which has nothing to do with them.
A draw with alpha below .1 is made again: no tool bends less the harder it is fed. With --feasible one whose best feed at 40
or 310 mm lies outside .005 to 2 mm/rev is made again too: no law could keep its bores.
"""
import argparse
import math
import random

LEVEL_FEED, OVERHANGS, TARGET = 0.17, (40.0, 310.0), 0.1165
LN_S, LN_L = math.log(LEVEL_FEED), 0.5 * sum(math.log(overhang) for overhang in OVERHANGS)
PARTS, CHANGES = 30, (11, 21)


def best_feed(law, overhang):
    level, alpha, beta = law
    return math.exp(LN_S + (math.log(TARGET) - level - beta * (math.log(overhang) - LN_L)) / alpha)


def usable(law, feasible):
    if law[1] < 0.1:
        return False
    return not feasible or all(0.005 <= best_feed(law, overhang) <= 2.0 for overhang in OVERHANGS)


def draw(make, feasible):
    while True:
        law = make()
        if usable(law, feasible):
            return law


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("truth", help="file to write: run,lot,part,alpha,beta,c_mm")
    parser.add_argument("announced", help="file to write: run,lot,part")
    parser.add_argument("--spread", nargs=3, type=float, default=(0.05, 0.04, 0.03), metavar=("LEVEL", "ALPHA", "BETA"))
    parser.add_argument("--machines", type=int, default=60)
    parser.add_argument("--lots", type=int, default=12)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--unrelated", choices=("no", "lot", "insert"), default="no")
    parser.add_argument("--feasible", action="store_true")
    parser.add_argument("--shop", nargs=4, type=float, metavar=("MACHINES", "LEVEL", "ALPHA", "BETA"))
    parser.add_argument("--odd", action="store_true")
    options = parser.parse_args()
    chance = random.Random(options.seed)

    def machine():
        return math.log(TARGET) + chance.gauss(0.0, 0.3), chance.uniform(0.4, 0.8), chance.uniform(0.1, 0.6)

    lost, inserts, machines = 0, 0, set()
    with open(options.truth, "w", encoding="utf-8") as truth, open(options.announced, "w", encoding="utf-8") as announced:
        truth.write("run,lot,part,alpha,beta,c_mm\n")
        announced.write("run,lot,part\n")
        for run in range(1, options.machines + 1):
            means = draw(machine, options.feasible)
            if options.shop:
                size, spreads = int(options.shop[0]), options.shop[1:]
                place = (run - 1) % size
                if place == 0:
                    shop = means
                if not (options.odd and place == size - 1):
                    means = draw(lambda: tuple(chance.gauss(mean, spread) for mean, spread in zip(shop, spreads)),
                                 options.feasible)
            for lot in range(1, options.lots + 1):
                if options.unrelated == "lot":
                    means = draw(machine, options.feasible)
                for part in range(1, PARTS + 1):
                    if part == 1 or part in CHANGES:
                        if options.unrelated == "insert":
                            means = draw(machine, options.feasible)
                        law = draw(lambda: tuple(chance.gauss(mean, spread)
                                                 for mean, spread in zip(means, options.spread)), options.feasible)
                        inserts += 1
                        if not usable(law, True):
                            lost += 1
                            machines.add(run)
                    level, alpha, beta = law
                    c_mm = math.exp(level - alpha * LN_S - beta * LN_L)
                    truth.write(f"{run},{lot},{part},{alpha:.17g},{beta:.17g},{c_mm:.17g}\n")
                for part in CHANGES:
                    announced.write(f"{run},{lot},{part}\n")
    print(f"{lost} of {inserts} inserts, on {len(machines)} machines, have no feed between .005 and 2 mm/rev for both depths")


if __name__ == "__main__":
    main()
