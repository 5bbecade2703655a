#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Memory that draws on the shop: consoles that bore the same part type, one PostgreSQL. Run by pg_virtualenv."""
import json
import math
import os
import pathlib
import shutil
import sqlite3
import subprocess
import sys
import tempfile

import psycopg2

BIN = pathlib.Path(os.environ["KERF_BIN"])
failures = []


def check(condition, what):
    print(("ok    " if condition else "FAIL  ") + what, flush=True)
    if not condition:
        failures.append(what)


def conninfo(user=None, port=None):
    who = f" user={user}" if user else ""
    return f"dbname={os.environ['PGDATABASE']} host=127.0.0.1 port={port or os.environ['PGPORT']} sslmode=disable{who}"


def run(program, *arguments, expect=0):
    done = subprocess.run([BIN / program, *map(str, arguments)], capture_output=True, text=True, timeout=120)
    if done.returncode != expect:
        check(False, f"{program} {arguments} ended with {done.returncode}: {done.stdout} {done.stderr}")
    return done


def fixture(*arguments):
    return run("memory_fixture", *arguments).stdout


def push(folder):
    run("kerf", "shop", "push", "--data", folder, "--database", conninfo(), "--once")


def memory(folder, *more):
    return json.loads(run("kerf", "boring", "memory", "--data", folder, "--json", *more).stdout)


def ask(sql, *values):
    connection = psycopg2.connect(conninfo())
    connection.autocommit = True
    with connection.cursor() as cursor:
        cursor.execute(sql, values)
        rows = cursor.fetchall() if cursor.description else []
    connection.close()
    return rows


def store_of(folder):
    file = sqlite3.connect(f"file:{folder}/kerf.db?mode=ro", uri=True)
    row = file.execute("SELECT store FROM shop_epochs ORDER BY id DESC LIMIT 1").fetchone()
    file.close()
    return row[0]


def running_console(work, lots):
    """A console with a screen, told by its recipe, touched as an operator does (console_draws.cpp); what it kept."""
    ask("CREATE ROLE stranger LOGIN")
    ask("ALTER ROLE stranger PASSWORD %s", os.environ["PGPASSWORD"])
    kept = work / "kept"
    environment = dict(os.environ, QT_QPA_PLATFORM="offscreen", XDG_RUNTIME_DIR=str(work), KERF_SHOP_READER=conninfo(),
                       KERF_SHOP_SENDER=conninfo(), KERF_SHOP_STRANGER=conninfo("stranger"), KERF_SHOP_LOTS=str(lots),
                       KERF_SHOP_KEEP=str(kept))
    log = work / "console.log"
    with open(log, "w", encoding="utf-8") as out:
        done = subprocess.run([BIN / "console_draws"], env=environment, stdout=out, stderr=subprocess.STDOUT,
                              cwd=work, timeout=280)
    lines = log.read_text(encoding="utf-8", errors="replace").splitlines()
    for line in lines:
        if line.startswith("PASS") or line.startswith("FAIL") or "   Loc:" in line:
            print("      " + line)
    check(done.returncode == 0, "a running console draws on the shop, and does without it")
    if done.returncode != 0:
        print("\n".join(lines[-40:]))
        return
    file = sqlite3.connect(f"file:{kept}/kerf.db?mode=ro", uri=True)
    names = dict(file.execute("SELECT id, name FROM lots"))
    rows = file.execute("SELECT subject, body FROM room_records WHERE kind = 'boring.shop_lots'").fetchall()
    file.close()
    drew = {names[int(subject)]: json.loads(body) for subject, body in rows}
    check(set(drew) == {"s1", "s5"}, "evidence is kept with the lots that drew, and with no other: " + str(sorted(drew)))
    run("kerf", "shop", "verify", "--data", kept, "--database", conninfo())
    check(True, "every row of that console is in the shop, evidence included")


def main():
    work = pathlib.Path(tempfile.mkdtemp(prefix="kerf_memory_"))
    run("kerf", "shop", "init", "--database", conninfo(), "--allow-unenrolled")
    ours, b, c, real = work / "ours", work / "b", work / "c", work / "real"
    fixture("lots", ours, "VB-1", "simulator", 0.2, 1, 0, 1)  # a lot that nothing is measured of yet
    fixture("lots", b, "VB-1", "simulator", 0.25, 8, 12, 2)  # another machine, called the same
    fixture("lots", c, "VB-3", "simulator", 0.15, 3, 12, 3)
    fixture("lots", real, "VB-9", "linuxcnc", -0.5, 3, 12, 4)
    for folder in (ours, b, c, real):
        push(folder)

    alone = memory(ours)
    check(not alone["begins_from_memory"] and alone["shop_lots"] == [] and "shop" not in alone, "not told: nothing of the shop")
    told = memory(ours, "--shop", conninfo())
    check(told["begins_from_memory"] and told["shop"]["reached"], "told: the first lot of a console begins from the shop")
    stores = {store_of(b): 6, store_of(c): 3}
    counts = {}
    for lot in told["shop_lots"]:
        counts[lot["console"]] = counts.get(lot["console"], 0) + 1
    check(counts == stores, "the newest six lots of one machine, all three of another, none of a real one: " + str(counts))
    newest = ask("SELECT id FROM shop.lots WHERE store = %s ORDER BY id DESC LIMIT 6", store_of(b))
    check({row[0] for row in newest} == {lot["lot"] for lot in told["shop_lots"] if lot["console"] == store_of(b)},
          "the newest six are those")
    total = told["prior_share"] + sum(lot["share"] for lot in told["shop_lots"])
    check(math.isclose(total, 1.0, abs_tol=1e-9) and all(lot["share"] > 0 for lot in told["shop_lots"]),
          "what each counts adds up to one with the wide prior")
    machine = next(step for step in told["spreads"] if step["between"] == "machine")
    check(machine["branches"] == 2, "two machines to estimate their spread from")
    expected = math.log(0.1165) + 0.2
    at = expected + 0.55 * math.log(told["level_at_feed_mm_per_rev"] / 0.17)
    at += 0.3 * math.log(told["level_at_overhang_mm"] / math.sqrt(40 * 310))
    check(abs(told["level"] - at) < 0.1 and told["spread"]["level"] < 0.6,
          f"the level expected is that of the others: {told['level']:.3f} for {at:.3f} ± {told['spread']['level']:.3f}")
    text = run("kerf", "boring", "memory", "--data", ours, "--shop", conninfo()).stdout
    check("machine VB-3, lot" in text and "9 of other machines" in text, "in words, too")

    compared = json.loads(fixture("compare", b, conninfo(), store_of(ours), "1"))
    check(compared == {"lots": 6, "equal": 6}, "every digit of the evidence is what the other console has: " + str(compared))

    # Own lots count more than others'.
    fixture("lots", ours, "VB-1", "simulator", 0.2, 2, 12, 5)
    own = memory(ours, "--shop", conninfo())
    mine = sum(lot["share"] for lot in own["lots"])
    others = sum(lot["share"] for lot in own["shop_lots"])
    check(len(own["lots"]) == 2 and mine > 4 * others, f"two own lots count {mine:.3f}, nine of others {others:.3f}")
    check(own["spread"]["level"] <= memory(ours)["spread"]["level"] * 1.05, "and the interval is no wider for the others")

    # Left out: here, and at the lot's own console.
    lot = told["shop_lots"][0]
    fixture("leave-out", ours, f"{lot['console']}/{lot['lot']}")
    left = memory(ours, "--shop", conninfo())
    one = next(x for x in left["shop_lots"] if (x["console"], x["lot"]) == (lot["console"], lot["lot"]))
    check(one["left_out"] and one["share"] == 0 and one["reason"] == "wrong insert", "a lot is left out for a reason")
    check(left["level"] != own["level"], "and all is computed again without it")
    oldest = ask("SELECT min(id) FROM shop.lots WHERE store = %s", store_of(c))[0][0]
    fixture("leave-out", c, oldest)
    push(c)
    theirs = memory(ours, "--shop", conninfo())
    one = next(x for x in theirs["shop_lots"] if (x["console"], x["lot"]) == (store_of(c), oldest))
    check(one["left_out"] and one["share"] == 0, "what its own console has left out is not drawn on")

    # A correction on the other machine.
    fixture("correct", c, 50.004)
    push(c)
    check(json.loads(fixture("compare", c, conninfo(), store_of(ours), "1")) == {"lots": 3, "equal": 3},
          "a correction there is the same evidence here")

    # A clone of this console's folder is this console's own history, not another machine.
    clone = work / "clone"
    shutil.copytree(ours, clone)
    push(ours)
    fixture("lots", clone, "VB-1", "simulator", 0.9, 2, 12, 6)
    push(clone)
    check({x["console"] for x in memory(ours, "--shop", conninfo())["shop_lots"]} == set(stores), "a clone is not drawn on")

    running_console(work, 6 + 3 + 4)  # six of VB-1's, three of VB-3's with the one left out, four of the clone's

    # A reader that sees one store only.
    ask("CREATE ROLE one_reader LOGIN IN ROLE kerf_reader")
    ask("INSERT INTO shop.reader_stores VALUES ('one_reader', %s)", store_of(c))
    ask("ALTER ROLE one_reader PASSWORD %s", os.environ["PGPASSWORD"])
    seen = memory(ours, "--shop", conninfo("one_reader"))
    check({x["console"] for x in seen["shop_lots"]} == {store_of(c)}, "row security holds")

    # Out of reach, no shop, no connection string.
    gone = run("kerf", "boring", "memory", "--data", ours, "--json", "--shop", conninfo(port=1))
    report = json.loads(gone.stdout)
    check("cannot be read" in gone.stderr and not report["shop"]["reached"] and report["shop_lots"] == [],
          "out of reach: a sentence")
    without = memory(ours)
    check({k: v for k, v in report.items() if k != "shop"} == without, "and memory without it, to the last digit")
    empty = memory(ours, "--shop", conninfo().replace(os.environ["PGDATABASE"], "template1"))
    check("no shop" in empty["shop"]["why"], "a database without a shop is named")
    run("kerf", "boring", "memory", "--data", ours, "--shop", "nonsense", expect=3)
    run("kerf", "boring", "memory", "--data", ours, "--shop", conninfo(), "--lot", "1", expect=2)

    # A poisoned row of another console costs that console's lot, nothing else.
    worst = ask("SELECT max(id) FROM shop.lots WHERE store = %s", store_of(c))[0][0]
    ask("UPDATE shop.measurements m SET diameter_mm = 'NaN' FROM shop.parts p WHERE p.store = m.store AND p.id = m.part_id "
        "AND m.store = %s AND p.lot_id = %s", store_of(c), worst)
    after = memory(ours, "--shop", conninfo())
    drawn = [(x["console"], x["lot"]) for x in after["shop_lots"] if x["console"] in stores]
    check((store_of(c), worst) not in drawn and len(drawn) == 8,
          "a lot that cannot be read is not drawn on, the others are")
    shutil.rmtree(work)
    print(f"{len(failures)} failures")
    return 1 if failures else 0


sys.exit(main())
