#!/usr/bin/env python3
"""How long kerf-console takes until its first page is painted with its content, and how its memory grows over a day.

  start_and_day.py [--starts 7] [--hours 24] [--speed 200] [--console build/release/bin/kerf-console]

The day's data file is made first: the demonstration's day, or with --hours one that is worked through here, bores measured by
themselves. Both sides of a start are wall time: from the call to the line that follows the paint (--time-start), offscreen.
"""
import argparse
import os
import pathlib
import statistics
import subprocess
import tempfile
import time


def memory_mb(process):
    for line in pathlib.Path(f"/proc/{process.pid}/status").read_text().splitlines():
        if line.startswith("VmRSS:"):
            return int(line.split()[1]) / 1024
    return 0.0


def begin(arguments, options, **more):
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "LC_ALL": "C.UTF-8"}
    return subprocess.Popen([arguments.console, *options], env=environment, stderr=subprocess.DEVNULL, text=True, **more)


def starts(arguments, data):
    times_s, without = [], 0
    for _ in range(arguments.starts):
        began = time.monotonic()
        process = begin(arguments, ["--data", data, "--size", "1280x800", "--time-start"], stdout=subprocess.PIPE)
        line = process.stdout.readline()
        times_s.append(time.monotonic() - began)
        without += int(line.split()[1]) if line.startswith("painted, ") else 0
        process.communicate(timeout=30)
    print(f"{data_of(data)} start: median {statistics.median(times_s):.2f} s, "
          f"smallest {min(times_s):.2f}, largest {max(times_s):.2f}; painted without content before: {without}")


def data_of(data):
    return f"{os.path.getsize(os.path.join(data, 'kerf.db')) / 1e6:.1f} MB of data,"


def day(arguments, data):
    if arguments.hours <= 0:
        return
    process = begin(arguments, ["--data", data, "--size", "1280x800", "--speed", str(arguments.speed), "--auto-operator"], stdout=subprocess.DEVNULL)
    steps = 12
    try:
        time.sleep(10)
        print(f"memory at the beginning: {memory_mb(process):.0f} MB", flush=True)
        for step in range(1, steps + 1):
            time.sleep(arguments.hours * 3600 / arguments.speed / steps)
            print(f"after {arguments.hours * step / steps:.0f} h of machine time: {memory_mb(process):.0f} MB", flush=True)
    finally:
        process.terminate()
        process.wait(timeout=30)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--starts", type=int, default=7)
    parser.add_argument("--hours", type=float, default=0)
    parser.add_argument("--speed", type=float, default=200)
    parser.add_argument("--console", default=str(pathlib.Path(__file__).parents[2] / "build/release/bin/kerf-console"))
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="kerf_start_") as folder:
        data = os.path.join(folder, "data")
        begin(arguments, ["--data", data, "--lot-size", "1000", "--screenshots", os.path.join(folder, "pages")],
              stdout=subprocess.DEVNULL).wait(timeout=300)
        starts(arguments, data)
        day(arguments, data)
        if arguments.hours > 0:
            starts(arguments, data)


if __name__ == "__main__":
    main()
