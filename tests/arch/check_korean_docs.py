#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The Korean documents stand beside the English ones: the same headings, tables, code, links, pictures and figures."""
import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
PAIRS = {"README.md": "README.ko.md", "docs/operator.md": "docs/ko/operator.md"}
COUNTERPARTS = {"docs/operator.md": "docs/ko/operator.md", "README.ko.md": "README.md"}  # a Korean reader is sent to the Korean page


def parts(file, korean):
    text = (ROOT / file).read_text(encoding="utf-8")
    code = re.findall(r"```\n(.*?)```", text, re.S)
    code = [re.sub(r"#.*", "", block).split() for block in code]
    prose = re.sub(r"```\n.*?```", "", text, flags=re.S)
    links = []
    for link in re.findall(r"\]\(([^)]+)\)", prose):
        link = re.sub(r"^\.\./", "", link) if korean else link
        links.append(COUNTERPARTS.get(link, link))
    words = re.sub(r"\]\([^)]*\)", "]", prose)
    words = re.sub(r"`[^`]*`", "", words)
    figures = re.findall(r"(?<![0-9A-Za-z_.])\d+(?:\.\d+)?(?![0-9A-Za-z_])", words)
    return {"headings": [len(h) for h in re.findall(r"^(#+) ", prose, re.M)], "table rows": len(re.findall(r"^\|", prose, re.M)),
            "numbered steps": re.findall(r"^(\d+)\. ", prose, re.M), "code": code, "links": sorted(links),
            "commands": sorted(re.findall(r"`([^`]*)`", prose))}, figures


def main():
    wrong = 0
    for english, korean in PAIRS.items():
        (a, figures_a), (b, figures_b) = parts(english, False), parts(korean, True)
        for what, value in a.items():
            if value != b[what]:
                print(f"{korean}: other {what} than {english}: {b[what]} for {value}")
                wrong += 1
        missing = [f for f in set(figures_a) if f not in figures_b and float(f) > 9]
        if missing:
            print(f"{korean}: figures of {english} that are missing: {sorted(missing)}")
            wrong += 1
    return 1 if wrong else 0


sys.exit(main())
