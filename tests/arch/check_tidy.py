#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""clang-tidy with the checks of .clang-tidy: any finding fails. check_tidy.py ROOT [FOLDER …]; all folders when none is
named, which takes most of an hour on two cores. Ends with 77 (skipped) where clang-tidy is not installed."""
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(sys.argv[1]).resolve()
FOLDERS = sys.argv[2:] or ["engine", "db", "ui", "app"]
QT = ["Qt6Core", "Qt6Gui", "Qt6Widgets", "Qt6Charts", "Qt6Sql", "Qt6Network", "Qt6PrintSupport", "Qt6SerialBus", "Qt6SerialPort"]
FINDING = re.compile(r"^(.*?):(\d+):\d+: (?:warning|error): (.*)$", re.M)


def flags() -> list[str]:
    found = subprocess.run(["pkg-config", "--cflags", *QT, "libpq"], capture_output=True, text=True)
    system = [word.replace("-I", "-isystem", 1) for word in found.stdout.split()]
    return ["-std=c++20", "-fPIC", f"-I{ROOT}", "-isystem/usr/include/eigen3", '-DKERF_VERSION="0"', *system]


def findings(file: pathlib.Path, arguments: list[str]) -> list[str]:
    run = subprocess.run(["clang-tidy", "--quiet", str(file), "--", *arguments], cwd=ROOT, capture_output=True, text=True)
    return [f"{os.path.relpath(os.path.join(ROOT, path), ROOT)}:{line}: {text}" for path, line, text in FINDING.findall(run.stdout)]


def main() -> int:
    if shutil.which("clang-tidy") is None:
        print("clang-tidy is not installed")
        return 77
    files = sorted(file for folder in FOLDERS for file in (ROOT / folder).rglob("*.cpp"))
    arguments = flags()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        seen = sorted({line for lines in pool.map(lambda file: findings(file, arguments), files) for line in lines})
    print("\n".join(seen))
    print(f"{len(files)} files, {len(seen)} findings")
    return 1 if seen or not files else 0


sys.exit(main())
