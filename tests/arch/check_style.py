#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""No literal colour outside ui/theme/palette.cpp, no literal size outside ui/theme/metrics.cpp: pages ask by name.
And no file of the product is longer than one can read in one sitting."""
import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1]).resolve()

LONGEST_LINES = 600
PRODUCT = ("app", "db", "engine", "ui")

RULES = {
    "literal colour": (
        re.compile(
            r"QColor\(\s*[\d\"]|QColor::from(Rgb|Hsv|Hsl|String)|qRgba?\(|\b0x[0-9A-Fa-f]{8}\b|#[0-9A-Fa-f]{6}\b"
            r"|Qt::(red|green|blue|yellow|cyan|magenta|black|white|gray|dark\w+|light\w+)\b"
        ),
        {"ui/theme/palette.cpp"},
    ),
    "literal size": (
        re.compile(
            # one pixel (a rule) and nothing are no sizes; "2 * step" is a named one, "%1px" a placeholder
            r"set(Fixed|Minimum|Maximum)(Width|Height|Size)\(\s*([2-9]|\d\d+)\s*[,)]|set(Pixel|Point)Size\(\s*\d"
            r"|(?<!%)\b\d+(px|pt)\b|setSpacing\(\s*[1-9]\d*\s*\)|setContentsMargins\(\s*[1-9]\d*\s*,"
        ),
        {"ui/theme/metrics.cpp"},
    ),
}


def offences(text: str, name: str) -> list[str]:
    found = []
    for number, line in enumerate(text.splitlines(), 1):
        code = re.sub(r"//.*", "", line)
        for what, (pattern, allowed) in RULES.items():
            if name not in allowed and pattern.search(code):
                found.append(f"{name}:{number}: {what}: {line.strip()}")
    return found


def too_long(text: str, name: str) -> list[str]:
    lines = len(text.splitlines())
    return [f"{name}: {lines} lines, at most {LONGEST_LINES}: split it along what it is made of"] if lines > LONGEST_LINES else []


def main() -> int:
    # The check itself must be able to fail.
    for bad in ('setPen(QColor("red"))', "c = 0xFFE6E8E9;", 'css("#A0B1C2")', "setFixedWidth(120)", '"font-size: 12px"'):
        if not offences(bad, "ui/probe.cpp"):
            print(f"the check does not see {bad}")
            return 1
    if not too_long("x\n" * (LONGEST_LINES + 1), "ui/probe.cpp") or too_long("x\n" * LONGEST_LINES, "ui/probe.cpp"):
        print("the check does not see a file that is too long")
        return 1
    files = [f for f in sorted((ROOT / "ui").rglob("*")) if f.suffix in {".h", ".cpp"}]
    found = [o for f in files for o in offences(f.read_text(encoding="utf-8"), f.relative_to(ROOT).as_posix())]
    product = [f for folder in PRODUCT for f in sorted((ROOT / folder).rglob("*")) if f.suffix in {".h", ".cpp", ".sql"}]
    found += [o for f in product for o in too_long(f.read_text(encoding="utf-8"), f.relative_to(ROOT).as_posix())]
    if len(files) < 20 or len(product) < 200:
        found.append(f"only {len(files)} files looked at: is {ROOT} the source folder?")
    print("\n".join(found) if found else f"{len(files)} files ask the palette and the metrics by name, none of {len(product)} is too long")
    return 1 if found else 0


sys.exit(main())
