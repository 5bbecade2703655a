#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Who may include whom. Fails on an include the table does not allow, and on an exception that is no longer needed."""
import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1]).resolve()

# folder -> prefixes it may include; the longest matching folder counts
PROCESSES = sorted(p.name for p in (ROOT / "engine/process").iterdir() if p.is_dir())
TYPES = [f"engine/process/{p}/{p}_{kind}.h" for p in PROCESSES for kind in ("types", "fields", "commands")]
ALLOWED = {
    "engine/core": ["engine/core/"],
    "engine/port": ["engine/core/", "engine/port/"],
    "engine/limits": ["engine/core/", "engine/port/", "engine/limits/"],
    "engine/quality": ["engine/core/", "engine/quality/"],
    "engine/api": ["engine/core/", "engine/api/", "engine/port/machine_port.h", *TYPES],
    "engine/cycle": ["engine/core/", "engine/port/", "engine/limits/", "engine/api/", "engine/cycle/"],
    "engine/machine": ["engine/core/", "engine/port/", "engine/machine/", "engine/process/"],
    "db": ["db/", "engine/core/", "engine/api/", *TYPES],
    "ui": ["ui/", "db/api/", "engine/core/", "engine/api/", "engine/quality/", *TYPES],
    "app/files": ["app/files/", "engine/"],
    "app/service": ["app/service/", "app/files/", "engine/", "db/", "ui/services/"],
    "app/machines": ["app/machines/", "app/sensors/", "engine/"],
    "app/sensors": ["app/sensors/", "engine/core/", "engine/machine/"],
    "app/rehearsal": ["app/rehearsal/", "app/files/", "engine/"],
    "app/headless": ["app/headless/", "app/files/", "app/rehearsal/", "app/service/", "app/machines/", "app/sensors/", "engine/", "db/"],
    "app": ["app/", "engine/", "db/", "ui/"],
}
# a process knows its own folder, never another one's
ALLOWED |= {
    f"engine/process/{p}": [f"engine/process/{p}/", "engine/core/", "engine/port/", "engine/limits/", "engine/api/", "engine/cycle/"]
    for p in PROCESSES
}
# headers of libraries a folder must not see
FORBIDDEN_LIBRARIES = {
    "engine": r"^(Q[A-Z]|Qt|sqlite3|fstream|filesystem|iostream|spdlog|nlohmann|CLI)",
    "ui": r"^(QSql|sqlite3|fstream|CLI)",
}
# (file, include): shrinks only
EXCEPTIONS: set[tuple[str, str]] = set()

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.M)


def rule_for(path: str) -> str | None:
    matches = [folder for folder in ALLOWED if path.startswith(folder + "/")]
    return max(matches, key=len) if matches else None


def main() -> int:
    problems: list[str] = []
    used: set[tuple[str, str]] = set()
    files = 0
    for folder in ("engine", "db", "ui", "app"):
        for file in sorted((ROOT / folder).rglob("*")):
            if file.suffix not in {".h", ".cpp", ".cc"}:
                continue
            files += 1
            name = file.relative_to(ROOT).as_posix()
            rule = rule_for(name)
            for target in INCLUDE.findall(file.read_text(encoding="utf-8")):
                if (name, target) in EXCEPTIONS:
                    used.add((name, target))
                    continue
                ours = target.split("/")[0] in {"engine", "db", "ui", "app", "tests"}
                if ours and not any(target.startswith(prefix) for prefix in ALLOWED[rule]):
                    problems.append(f"{name}: must not include {target}")
                forbidden = FORBIDDEN_LIBRARIES.get(folder)
                if not ours and forbidden and re.match(forbidden, target):
                    problems.append(f"{name}: {folder}/ must not include {target}")
    problems += [f"exception no longer needed: {file} includes {target}" for file, target in sorted(EXCEPTIONS - used)]
    if files < 20:
        problems.append(f"only {files} files looked at: is {ROOT} the source folder?")
    print("\n".join(problems) if problems else f"{files} files include only what they may")
    return 1 if problems else 0


sys.exit(main())
