#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every alarm code stands in a table, once, with title, cause, consequence and action: nobody is told a bare number."""
import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1]).resolve()
CODE = re.compile(r"\bAlarmCode\s+(k\w+)\s*(?:=|\{)\s*(\d+)")
ROW = re.compile(r"AlarmSpec\s*\{\s*(k\w+)\s*,\s*(\d)\s*,(.*?)\}\s*,?\s*(?=AlarmSpec\s*\{|\};)", re.S)
TEXT = re.compile(r'KERF_TEXT\(\s*((?:"(?:[^"\\]|\\.)*"\s*)+)\)')
PARTS = 4  # title, cause, consequence, action


def faults(files: dict[str, str]) -> list[str]:
    """What is wrong with the alarms declared in these files (name: source)."""
    found = []
    numbers: dict[int, str] = {}
    for name, source in files.items():
        table = source.find("std::array kSpecs")
        rows = {row[1]: row for row in ROW.finditer(source, max(table, 0))} if table >= 0 else {}
        for code in CODE.finditer(source):
            label = f"{name}: {code[1]}"
            number = int(code[2])
            if number == 0:
                continue  # "none"
            if number in numbers:
                found.append(f"{label}: {number} is {numbers[number]} too")
            numbers[number] = label
            if code[1] not in rows:
                found.append(f"{label}: stands in no table of alarms (kSpecs)")
                continue
            texts = ["".join(re.findall(r'"((?:[^"\\]|\\.)*)"', text)) for text in TEXT.findall(rows[code[1]][3])]
            if len(texts) != PARTS or not all(text.strip() for text in texts):
                found.append(f"{label}: needs title, cause, consequence and action")
    return found


def main() -> int:
    # The check itself must be able to fail.
    row = 'AlarmSpec{kA, 2, KERF_TEXT("t"), KERF_TEXT("c"), KERF_TEXT("w"), KERF_TEXT("d")},'
    good = "constexpr AlarmCode kA = 7; constexpr std::array kSpecs{" + row + "};"
    bad = [good.replace("kSpecs{" + row, "kSpecs{"), good.replace('"w"', '""'), good + "AlarmCode kB = 8;",
           good + "AlarmCode kB = 7;", good.replace("std::array kSpecs{" + row, "AlarmSpec kSingle{kA")]
    if faults({"good": good}) or not all(faults({"bad": one}) for one in bad):
        print("the check does not see what it is for")
        return 1
    files = {str(path.relative_to(ROOT)): path.read_text(encoding="utf-8")
             for folder in ("engine", "app", "ui") for path in sorted((ROOT / folder).rglob("*.h"))
             if "AlarmCode k" in path.read_text(encoding="utf-8")}
    count = sum(len(CODE.findall(source)) for source in files.values())
    if count < 40:
        print(f"only {count} alarm codes found: is {ROOT} the source folder?")
        return 1
    found = faults(files)
    for fault in found:
        print(fault)
    print(f"{count} alarm codes in {len(files)} files, {len(found)} faults")
    return 1 if found else 0


sys.exit(main())
