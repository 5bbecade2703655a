#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""clang-tidy with the checks of .clang-tidy: any finding fails. check_tidy.py ROOT [FOLDER …]; all folders when none is
named, which takes most of an hour on two cores. Ends with 77 (skipped) where clang-tidy is not installed.

A file that was clean is not looked at again while nothing that it is made of has changed: KERF_TIDY_CLEAN names the folder
that remembers; without it every file is looked at."""
import concurrent.futures
import functools
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(sys.argv[1]).resolve()
FOLDERS = sys.argv[2:] or ["engine", "db", "ui", "app"]
QT = ["Qt6Core", "Qt6Gui", "Qt6Widgets", "Qt6Charts", "Qt6Sql", "Qt6Network", "Qt6PrintSupport", "Qt6SerialBus", "Qt6SerialPort"]
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.M)
CLEAN = os.environ.get("KERF_TIDY_CLEAN")
FINDING = re.compile(r"^(.*?):(\d+):\d+: (?:warning|error): (.*)$", re.M)


def flags() -> list[str]:
    found = subprocess.run(["pkg-config", "--cflags", *QT, "libpq"], capture_output=True, text=True)
    system = [word.replace("-I", "-isystem", 1) for word in found.stdout.split()]
    return ["-std=c++20", "-fPIC", f"-I{ROOT}", "-isystem/usr/include/eigen3", '-DKERF_VERSION="0"', *system]


def included(file: pathlib.Path, seen: set[pathlib.Path]) -> set[pathlib.Path]:
    """The file and every file of the project that it includes, directly or not."""
    if file not in seen:
        seen.add(file)
        for name in INCLUDE.findall(file.read_text("utf-8")):
            for header in (ROOT / name, file.parent / name):
                if header.is_file():
                    included(header.resolve(), seen)
                    break
    return seen


@functools.cache
def checker() -> bytes:
    """What else a verdict rests on: the tool, its checks, this script, the headers of the system's packages."""
    version = subprocess.run(["clang-tidy", "--version"], capture_output=True).stdout
    packages = pathlib.Path("/var/lib/dpkg/status")
    stamp = str(packages.stat().st_mtime_ns).encode() if packages.is_file() else b""
    return version + (ROOT / ".clang-tidy").read_bytes() + pathlib.Path(__file__).read_bytes() + stamp


def mark_of(file: pathlib.Path, arguments: list[str]) -> pathlib.Path | None:
    if not CLEAN:
        return None
    told = hashlib.sha256(checker() + "\0".join(arguments).encode())
    for part in sorted(included(file, set())):
        told.update(str(part).encode() + b"\0" + part.read_bytes())
    return pathlib.Path(CLEAN) / told.hexdigest()


def findings(file: pathlib.Path, arguments: list[str]) -> list[str]:
    mark = mark_of(file, arguments)
    if mark is not None and mark.exists():
        return []
    run = subprocess.run(["clang-tidy", "--quiet", str(file), "--", *arguments], cwd=ROOT, capture_output=True, text=True)
    found = [f"{os.path.relpath(os.path.join(ROOT, path), ROOT)}:{line}: {text}" for path, line, text in FINDING.findall(run.stdout)]
    if mark is not None and run.returncode == 0 and not found:
        mark.parent.mkdir(parents=True, exist_ok=True)
        mark.touch()
    return found


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
