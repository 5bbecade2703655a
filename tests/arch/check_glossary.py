#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The Korean translation keeps to docs/glossary.md."""
import pathlib
import re
import sys
import xml.etree.ElementTree

ROOT = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
# Short and everyday words are checked for what must not stand for them only.
LOOSE = {"part", "lot", "gain", "trim", "bore", "alarm", "advise", "controller", "diameter"}


def rows():
    for line in (ROOT / "docs/glossary.md").read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if line.startswith("|") and len(cells) == 4 and cells[0] != "English" and not cells[0].startswith("-"):
            yield cells[0], cells[1], [word.strip() for word in cells[2].split(",") if word.strip()]


def main():
    glossary = list(rows())
    wrong = 0 if glossary else 1
    tree = xml.etree.ElementTree.parse(ROOT / "resources/translations/kerf_ko.ts")
    for message in tree.getroot().iter("message"):
        source, korean = message.findtext("source") or "", "".join(message.find("translation").itertext())
        for english, word, never in glossary:
            bad = [other for other in never if other in korean]
            if bad:
                print(f"“{source}”: {bad[0]} stands for {word}: {korean}")
                wrong += 1
            elif english not in LOOSE and re.search(rf"\b{english}s?\b", source, re.I) and word not in korean:
                print(f"“{source}”: {word} is missing ({english}): {korean}")
                wrong += 1
    documents = [ROOT / "README.ko.md", ROOT / "docs/ko/operator.md"]
    for file in documents:
        text = file.read_text(encoding="utf-8")
        for english, word, never in glossary:
            for other in never:
                if other in text:
                    print(f"{file.name}: {other} stands for {word}")
                    wrong += 1
    return 1 if wrong else 0


sys.exit(main())
