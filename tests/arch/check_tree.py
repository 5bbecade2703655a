#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The front door: nothing tracked at the root but what belongs there, and nothing left lying about by the tests."""
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(sys.argv[1]).resolve()
FILES = {"CMakeLists.txt", "CMakePresets.json", "README.md", "README.ko.md", "LICENSE", "CHANGELOG.md", "CONTRIBUTING.md"}
FOLDERS = {"app", "cmake", "db", "docs", "engine", "resources", "scripts", "tests", "ui"}


def strangers(tracked: list[str]) -> list[str]:
    """Tracked paths that do not belong where they are."""
    found = []
    for path in tracked:
        top, _, rest = path.partition("/")
        belongs = top.startswith(".") or (top in FOLDERS if rest else top in FILES)
        if not belongs:
            found.append(path)
    return found


def git(*arguments: str) -> list[str]:
    run = subprocess.run(["git", "-C", str(ROOT), *arguments], capture_output=True, text=True, check=True)
    return [line for line in run.stdout.split("\0") if line]


def main() -> int:
    # The check itself must be able to fail.
    for bad in ("page.png", "pages/boring.png", "soak.log"):
        if not strangers([bad]):
            print(f"the check does not see {bad}")
            return 1
    if not (ROOT / ".git").exists():
        print("no git here: skipped")
        return 77
    tracked = git("ls-files", "-z")
    if len(tracked) < 100:
        print(f"only {len(tracked)} tracked files: is {ROOT} the source folder?")
        return 1
    problems = [f"tracked, but does not belong there: {path}" for path in strangers(tracked)]
    problems += [f"untracked: {path}" for path in git("ls-files", "-z", "--others", "--exclude-standard")]
    print("\n".join(problems) if problems else f"{len(tracked)} tracked files stand where they belong, nothing else lies about")
    return 1 if problems else 0


sys.exit(main())
