#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What pushing costs a console, side by side; and how long an outage takes to be made up for.

tests/shop/with_postgresql tests/bench/shop_cost.py [SECONDS [PER_SECOND]], with KERF_BIN at the folder of the programs.
"""
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

BIN = pathlib.Path(os.environ["KERF_BIN"])
SECONDS = int(sys.argv[1]) if len(sys.argv) > 1 else 30
PER_SECOND = int(sys.argv[2]) if len(sys.argv) > 2 else 5
DAY_PARTS = 1440  # a part a minute
CONNINFO = f"dbname={os.environ['PGDATABASE']} host=127.0.0.1 port={os.environ['PGPORT']} sslmode=disable"


def load(folder, *server):
    run = subprocess.run([BIN / "kerf_shop_load", folder, str(SECONDS), str(PER_SECOND), *server], capture_output=True, text=True,
                         check=True, timeout=20 * SECONDS + 120)
    return json.loads(run.stdout)


with tempfile.TemporaryDirectory(prefix="kerf_shop_cost_") as name:
    work = pathlib.Path(name)
    subprocess.run([BIN / "kerf", "shop", "init", "--database", CONNINFO, "--allow-unenrolled"], check=True, stdout=subprocess.DEVNULL)
    alone, pushing = [], []
    for i in range(3):
        alone.append(load(work / f"alone{i}"))
        pushing.append(load(work / f"pushing{i}", CONNINFO))
    for what, runs in (("alone", alone), ("pushing", pushing)):
        print(what, json.dumps(runs))
    share = [run["processor_s"] / run["wall_s"] for run in pushing]
    base = [run["processor_s"] / run["wall_s"] for run in alone]
    print(f"{PER_SECOND} acceptances a second for {SECONDS} s, three times: pushing costs "
          f"{100 * (statistics.median(share) - statistics.median(base)):.2f} % of a core; median acceptance "
          f"{statistics.median(r['median_ms'] for r in alone):.2f} ms alone, {statistics.median(r['median_ms'] for r in pushing):.2f} ms pushing")
    folder = work / "day"
    subprocess.run([BIN / "shop_fixture", folder, str(DAY_PARTS), "1"], check=True, timeout=600)
    begin = time.monotonic()
    run = subprocess.run([BIN / "kerf", "shop", "push", "--data", folder, "--database", CONNINFO, "--once"], capture_output=True, text=True,
                         check=True, timeout=600)
    print(f"a day's outage of one console, {DAY_PARTS} parts of three measurements: made up for in {time.monotonic() - begin:.2f} s: {run.stdout.strip()}")
