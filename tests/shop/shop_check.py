#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Consoles and one PostgreSQL: what is in the shop is what the consoles have, whatever is killed on the way.

Run by pg_virtualenv. Rows are compared here, by sqlite3 and psycopg2, not by Kerf. --long CONSOLES ROWS: the campaign.
--day-off CONSOLES: all of them come back at once after a day without the server.
"""
import json
import os
import pathlib
import random
import shutil
import signal
import socket
import sqlite3
import subprocess
import sys
import tempfile
import threading
import time
import uuid

import psycopg2

BIN = pathlib.Path(os.environ["KERF_BIN"])
HERE = pathlib.Path(__file__).resolve().parent
# What never leaves a console: the sealed PINs.
KEPT = {"settings": "key <> 'operators'", "audit": "object <> 'setting operators'"}
TABLES = {
    "machines": "id", "part_types": "id", "recipe_revisions": "id", "lots": "id", "schedules": "id", "parts": "id",
    "part_results": "part_id", "feed_traces": "part_id", "measurements": "id", "measurement_sources": "measurement_id", "estimator_states": "id", "alarms": "id",
    "settings": "key", "audit": "id", "room_records": "id",
}
failures = []


def check(condition, what):
    print(("ok    " if condition else "FAIL  ") + what, flush=True)
    if not condition:
        failures.append(what)


def conninfo(port=None):
    return f"dbname={os.environ['PGDATABASE']} host=127.0.0.1 port={port or os.environ['PGPORT']} sslmode=disable"


def kerf(*arguments, expect=0):
    run = subprocess.run([BIN / "kerf", "shop", *map(str, arguments)], capture_output=True, text=True, timeout=300)
    if expect is not None and run.returncode != expect:
        check(False, f"kerf shop {arguments} ended with {run.returncode}: {run.stdout} {run.stderr}")
    return run


def push(folder, port=None, expect=0):
    run = kerf("push", "--data", folder, "--database", conninfo(port), "--once", expect=expect)
    return json.loads(run.stdout) if run.returncode == 0 else run


def make(folder, parts, seed):
    subprocess.run([BIN / "shop_fixture", folder, str(parts), str(seed)], check=True, timeout=300)


def connect():
    for _ in range(200):  # a server that was killed comes back after its recovery
        try:
            connection = psycopg2.connect(conninfo())
            connection.autocommit = True
            return connection
        except psycopg2.OperationalError:
            time.sleep(0.1)
    raise RuntimeError("the server does not come back")


def ask(sql, *values):
    connection = connect()
    with connection.cursor() as cursor:
        cursor.execute(sql, values)
        rows = cursor.fetchall() if cursor.description else []
    connection.close()
    return rows


def plain(value):
    return bytes(value) if isinstance(value, memoryview) else value


def rows_here(folder):
    file = sqlite3.connect(f"file:{folder}/kerf.db?mode=ro", uri=True)
    store, epoch = file.execute("SELECT store, epoch FROM shop_epochs ORDER BY id DESC LIMIT 1").fetchone()
    tables = {}
    for table, key in TABLES.items():
        columns = [c[1] for c in file.execute(f"PRAGMA table_info({table})")]
        where = f" WHERE {KEPT[table]}" if table in KEPT else ""
        rows = file.execute(f"SELECT {', '.join(columns)} FROM {table}{where}").fetchall()
        tables[table] = (columns, {row[columns.index(key)]: row for row in rows})
    file.close()
    return store, epoch, tables


def differences(folder, without=()):
    """Rows of this folder's epoch that are not bit for bit in the shop, and rows there that are not here."""
    store, epoch, tables = rows_here(folder)
    found = []
    connection = connect()
    with connection.cursor() as cursor:
        for table, (columns, here) in tables.items():
            cursor.execute(f"SELECT {', '.join(columns)} FROM shop.{table} WHERE store = %s AND epoch = %s", (store, epoch))
            rows = [tuple(plain(v) for v in row) for row in cursor.fetchall()]
            key = columns.index(TABLES[table])
            there = {row[key]: row for row in rows}
            if len(there) != len(rows):
                found.append(f"{table}: {len(rows) - len(there)} rows twice")
            for name in here.keys() | there.keys():
                if (table, name) not in without and here.get(name) != there.get(name):
                    found.append(f"{table} {name}: {here.get(name)} / {there.get(name)}")
    connection.close()
    return found


def kill_server():
    directory = ask("SHOW data_directory")[0][0]
    os.kill(int(pathlib.Path(directory, "postmaster.pid").read_text().split()[0]), signal.SIGKILL)
    cluster = pathlib.Path(directory).name
    version = pathlib.Path(directory).parent.name
    for _ in range(100):  # its children end by themselves; then it can be started again
        if subprocess.run(["pg_ctlcluster", version, cluster, "start"], capture_output=True).returncode == 0:
            break
        time.sleep(0.1)
    connect().close()


class Cut(threading.Thread):
    """A proxy that lets everything through to the server, and cuts the link instead of bringing back answer number `n`."""

    def __init__(self, answers):
        super().__init__(daemon=True)
        self.answers = answers
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.port = self.listener.getsockname()[1]
        self.start()

    def run(self):
        client, _ = self.listener.accept()
        server = socket.create_connection(("127.0.0.1", int(os.environ["PGPORT"])))

        def forward():
            try:
                while data := client.recv(65536):
                    server.sendall(data)
            except OSError:
                pass

        threading.Thread(target=forward, daemon=True).start()
        seen = 0
        try:
            while data := server.recv(65536):
                # "SELECT 1" in an answer's end is the tag of one call of ingest.
                seen += data.count(b"SELECT 1\0")
                if seen > self.answers:
                    break
                client.sendall(data)
        except OSError:
            pass
        for link in (client, server):  # closed alone, it would stay open while the other thread reads it
            link.shutdown(socket.SHUT_RDWR)
            link.close()
        self.listener.close()


def three_consoles(work):
    first = json.loads(kerf("init", "--database", conninfo()).stdout)
    again = json.loads(kerf("init", "--database", conninfo()).stdout)
    check(first["from_version"] == 0 and again["from_version"] == again["schema_version"], "init makes the schema once")
    folders = [work / f"console{i}" for i in range(3)]
    for i, folder in enumerate(folders):
        make(folder, 40, i)
        report = push(folder)
        check(report["unsent"] == 0 and not report["new_epoch"], f"console {i} is pushed whole")
        check(not differences(folder), f"console {i}: rows equal {differences(folder)[:2]}")
        check(push(folder)["sent"] == 0, f"console {i}: a second push sends nothing")
        check(json.loads(kerf("verify", "--data", folder, "--database", conninfo()).stdout)["equal"], f"console {i}: verify")
    check(not ask("SELECT 1 FROM shop.settings WHERE key = 'operators'")
          and not ask("SELECT 1 FROM shop.audit WHERE new_value LIKE '%%sealed%%'"), "sealed PINs stay on the console")
    sources = ask("SELECT DISTINCT source, source_name FROM shop.measurements_that_hold ORDER BY 1")
    check(sources == [("file", "값 1.csv"), ("gauge", "G-07 내경"), ("keypad", "")], f"the view says where each value came from: {sources}")
    status = json.loads(kerf("status", "--database", conninfo(), "--json").stdout)
    check(len(status["stores"]) == 3 and all(s["last_seq"] > 0 and s["age_s"] < 60 and s["quarantined"] == 0
                                             for s in status["stores"]), "status knows three stores")
    return folders


def kills(folders, rounds, seed):
    dice = random.Random(seed)
    for i in range(rounds):
        for n, folder in enumerate(folders):
            make(folder, 8, 100 * i + n)
        running = [subprocess.Popen([BIN / "kerf", "shop", "push", "--data", f, "--database", conninfo(), "--once"],
                                    stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) for f in folders]
        time.sleep(dice.uniform(0.0, 0.12))
        if i % 4 == 3:
            kill_server()
        for sender in running:
            if dice.random() < 0.7:
                sender.kill()
        for sender in running:
            sender.wait(timeout=60)
    for n, folder in enumerate(folders):
        push(folder)
        check(not differences(folder), f"after {rounds} rounds of kills console {n} is equal {differences(folder)[:2]}")


def cut_links(folder):
    for answers in (0, 1, 2, 3):
        make(folder, 60, answers)
        cut = Cut(answers)
        run = push(folder, port=cut.port, expect=None)
        check(not isinstance(run, dict) and run.returncode == 3 and "nothing is lost" in run.stderr,
              f"a link cut after {answers} answers is one sentence and exit 3")
    push(folder)
    check(not differences(folder), "after cut links rows are equal")


def backup_and_clone(work):
    folder = work / "restored"
    make(folder, 10, 5)
    push(folder)
    kept = work / "kept.db"
    source, copy = sqlite3.connect(folder / "kerf.db"), sqlite3.connect(kept)
    source.backup(copy)
    source.close()
    copy.close()
    make(folder, 10, 6)
    old = push(folder)
    before = ask("SELECT count(*) FROM shop.measurements WHERE epoch = %s", old["epoch"])
    for stray in folder.glob("kerf.db*"):
        stray.unlink()
    shutil.copy(kept, folder / "kerf.db")
    restored = push(folder)
    check(restored["new_epoch"] and restored["epoch"] != old["epoch"] and restored["store"] == old["store"],
          "a restored backup begins a new epoch")
    check(not differences(folder), "and is whole under it")
    check(ask("SELECT count(*) FROM shop.measurements WHERE epoch = %s", old["epoch"]) == before,
          "and the history before stays as it was")
    # Restored and worked on beyond where the shop is: longer than what the shop has, but not the same.
    make(folder, 40, 7)
    push(folder)
    for stray in folder.glob("kerf.db*"):
        stray.unlink()
    shutil.copy(kept, folder / "kerf.db")
    make(folder, 60, 8)
    longer = push(folder)
    check(longer["new_epoch"], "a restored backup that has overtaken the shop is told by its marks")
    check(not differences(folder), "and is whole too")
    clone = work / "clone"
    shutil.copytree(folder, clone)
    make(folder, 5, 9)
    make(clone, 5, 10)
    check(not push(folder)["new_epoch"], "the original goes on")
    check(push(clone)["new_epoch"], "a cloned folder begins a new epoch")
    check(not differences(folder) and not differences(clone), "original and clone are both whole")
    make(folder, 3, 11)
    make(clone, 3, 12)
    check(not push(folder)["new_epoch"] and not push(clone)["new_epoch"], "and both go on side by side")
    check(not differences(folder) and not differences(clone), "and stay whole")


def poison(work):
    folder = work / "poison"
    make(folder, 5, 1)
    file = sqlite3.connect(folder / "kerf.db")
    file.execute("INSERT INTO alarms (code, priority, raised_utc_ms, detail_text, detail_args) VALUES (1, 1, 1, ?, '[]')",
                 ("no\0text for PostgreSQL",))
    number = file.execute("SELECT max(id) FROM alarms").fetchone()[0]
    file.commit()
    file.close()
    make(folder, 60, 2)
    report = push(folder)
    check(report["quarantined"] == 1 and report["unsent"] == 0, f"the poison row is put aside, the rest goes on: {report}")
    check(not differences(folder, without={("alarms", number)}), "all others are equal")
    aside = ask("SELECT table_name, row_key, reason, row FROM shop.quarantine")
    check(len(aside) == 1 and aside[0][:2] == ("alarms", str(number)) and aside[0][2] and "text for" in aside[0][3],
          f"it is kept with its reason: {aside}")
    verify = kerf("verify", "--data", folder, "--database", conninfo(), expect=3)
    check("put aside" in verify.stderr, "verify names it")


def newer_console(work):
    folder = work / "newer"
    make(folder, 5, 3)
    push(folder)
    file = sqlite3.connect(folder / "kerf.db")
    file.execute("ALTER TABLE parts ADD COLUMN colour TEXT")
    file.commit()
    file.close()
    make(folder, 5, 4)
    before = ask("SELECT count(*) FROM shop.parts")
    run = push(folder, expect=3)
    check("newer than the shop" in run.stderr and "parts.colour" in run.stderr, "a newer console waits and says so")
    check(ask("SELECT count(*) FROM shop.parts") == before, "and sends nothing")
    ask("ALTER TABLE shop.parts ADD COLUMN colour text; SELECT shop.follow('parts', 'id', true)")
    push(folder)
    check(not differences(folder), "and goes on when the shop has grown")


def clocks_back(work):
    folder = work / "clock"
    make(folder, 5, 3)
    file = sqlite3.connect(folder / "kerf.db")
    for hour in range(20):  # each an hour before the one before, the last ones before 1970
        file.execute("INSERT INTO parts (process, lot_id, number, complete, machine_begin_ns, machine_end_ns, ended_utc_ms) "
                     "VALUES ('milling', NULL, ?, 1, 0, 1, ?)", (hour + 1, 3600_000 * (10 - hour)))
    file.commit()
    file.close()
    push(folder)
    check(not differences(folder), "rows of a clock that was set back are equal")
    order = ask("SELECT number FROM shop.parts WHERE store = %s AND process = 'milling' ORDER BY store, epoch, seq",
                rows_here(folder)[0])
    check([n for (n,) in order] == list(range(1, 21)), "and in the order of their making")


def console_sends(work):
    """The console's own sender, through a killed server and a killed console."""
    program = BIN / "kerf-console"
    if not program.exists():
        print("the console is not built: its sender is not tried")
        return
    folder = work / "console_itself"
    (folder / "shop").mkdir(parents=True)
    (folder / "shop" / "database").write_text(conninfo() + "\n")

    def start():
        return subprocess.Popen([program, "--data", folder, "--auto-operator", "--speed", "200", "--lot-size", "1000", "--prepared-parts", "0"],
                                env=os.environ | {"QT_QPA_PLATFORM": "offscreen"}, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def newest(there):
        if not (folder / "kerf.db").exists():
            return 0
        if there:
            rows = ask("SELECT coalesce(sum(last_seq), 0) FROM shop.streams WHERE store = %s", rows_here(folder)[0])
            return int(rows[0][0])
        file = sqlite3.connect(f"file:{folder}/kerf.db?mode=ro", uri=True)
        count = file.execute("SELECT count(*) FROM parts").fetchone()[0]
        file.close()
        return count

    def wait(condition, seconds=120):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            try:
                if condition():
                    return True
            except (sqlite3.Error, TypeError):
                pass  # the file is being made
            time.sleep(0.2)
        return False

    console = start()
    check(wait(lambda: newest(True) > 50), "a console sends what it stores while it works")
    made = newest(False)
    kill_server()
    check(wait(lambda: newest(False) > made) and console.poll() is None, "a killed server does not stop it")
    sent = newest(True)
    check(wait(lambda: newest(True) > sent), "and sends again when the server is back")
    console.kill()
    console.wait()
    console = start()
    sent = newest(True)
    check(wait(lambda: newest(True) > sent), "a console that was killed goes on")
    console.terminate()
    console.wait(timeout=60)
    push(folder)
    check(not differences(folder), "its rows are equal")


def difference_is_found(folders):
    ask("UPDATE shop.measurements SET diameter_mm = diameter_mm + 1e-15 * 8 WHERE store = %s AND id = 7",
        rows_here(folders[0])[0])
    run = kerf("verify", "--data", folders[0], "--database", conninfo(), expect=3)
    report = json.loads(run.stdout)
    check(report["first_difference"]["table"] == "measurements" and report["first_difference"]["key"] == "7",
          "verify finds the last bit of one diameter")


def rights(work):
    folder = work / "enrolled"
    make(folder, 3, 1)
    report = json.loads(kerf("enroll", "--data", folder, "--database", conninfo(), "--name", "VB-1").stdout)
    check(report["registered"] and os.path.exists(report["certificate_request"]), "enroll registers and writes a request")
    check(os.stat(folder / "shop" / "console.key").st_mode & 0o077 == 0, "the key is nobody else's")
    script = (HERE / "rights.sql").read_text()
    run = subprocess.run(["psql", "-XAtq", "-v", "ON_ERROR_STOP=1", "-v", f"store={report['store']}", "-v", f"role={report['role']}",
                          conninfo()], input=script, capture_output=True, text=True, timeout=120)
    lines = [line for line in run.stdout.splitlines() if line.startswith(("ok", "not ok"))]
    check(run.returncode == 0 and len(lines) >= 15 and all(line.startswith("ok") for line in lines),
          f"pgTAP: {len(lines)} rights\n{run.stdout}{run.stderr}" if run.returncode or any(
              line.startswith("not") for line in lines) else f"pgTAP: {len(lines)} rights")


def bad_input(work):
    check("init" in kerf("push", "--data", work / "console0", "--database", conninfo().replace(os.environ["PGDATABASE"], "template1"),
                         "--once", expect=3).stderr, "a database without a shop is named")
    check(kerf("push", "--data", work / "console0", "--database", "host=127.0.0.1 port=1 dbname=x", "--once", expect=3).stdout == "",
          "no server: exit 3, nothing on stdout")
    kerf("push", "--data", work / "nowhere", "--database", conninfo(), "--once", expect=3)
    kerf("status", "--database", "nonsense", expect=3)
    kerf("status", expect=2)
    kerf("spoon", expect=2)


def another(folder, source, name):
    """A console that has the rows of `source` and an identity and outbox marks of its own."""
    folder.mkdir()
    shutil.copy(source / "kerf.db", folder / "kerf.db")
    file = sqlite3.connect(folder / "kerf.db")
    file.execute("PRAGMA synchronous = OFF")
    file.execute("INSERT INTO shop_epochs (store, epoch, reason, began_utc_ms) VALUES (?, ?, 'a console of the campaign', 0)",
                 (str(uuid.UUID(int=2 * name + 1)), str(uuid.UUID(int=2 * name + 2))))
    for outbox in ("outbox", "outbox_traces"):
        file.execute(f"UPDATE {outbox} SET mark = random()")
    file.commit()
    file.close()


def consoles_of(work, consoles, parts):
    """Data folders of so many consoles with so many parts each: four are worked through, the others are copies of them."""
    made = [work / f"made{i}" for i in range(min(4, consoles))]
    for i, folder in enumerate(made):
        make(folder, parts, i)
        file = sqlite3.connect(folder / "kerf.db")
        file.execute("PRAGMA wal_checkpoint(TRUNCATE)")
        file.close()
    folders = [work / f"console{i:03}" for i in range(consoles)]
    for i, folder in enumerate(folders):
        another(folder, made[i % len(made)], i)
    return folders


def day_off(work, consoles):
    """Every console comes back at once after a day without the server: a part a minute, four senders at a time."""
    kerf("init", "--database", conninfo())
    folders = consoles_of(work, consoles, 1440)
    begin = time.monotonic()
    lag = []
    waiting, running = list(folders), {}
    while waiting or running:
        while waiting and len(running) < 4:
            folder = waiting.pop(0)
            running[subprocess.Popen([BIN / "kerf", "shop", "push", "--data", folder, "--database", conninfo(), "--once"],
                                     stdout=subprocess.DEVNULL)] = folder
        time.sleep(0.01)
        for sender in [s for s in running if s.poll() is not None]:
            running.pop(sender)
            if sender.returncode != 0:
                check(False, "a console is not made up for")
            lag.append(time.monotonic() - begin)
    entries = int(ask("SELECT sum(last_seq) FROM shop.streams")[0][0])
    check(len(lag) == consoles, f"{consoles} consoles are made up for")
    print(f"figures: a day's outage of {consoles} consoles, {entries} entries: half of them after {sorted(lag)[consoles // 2]:.1f} s, "
          f"all after {max(lag):.1f} s: {entries / max(lag):.0f} entries/s", flush=True)


def campaign(work, consoles, rows):
    kerf("init", "--database", conninfo())
    folders = consoles_of(work, consoles, max(1, rows // consoles // 9))
    dice = random.Random(1)
    begin = time.monotonic()
    waiting = list(folders)
    kill_at = begin + 5.0
    running = {}
    killed = 0
    while waiting or running:
        while waiting and len(running) < 4:
            folder = waiting.pop(0)
            running[subprocess.Popen([BIN / "kerf", "shop", "push", "--data", folder, "--database", conninfo(), "--once"],
                                     stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)] = folder
        time.sleep(0.02)
        if dice.random() < 0.02 and running:
            dice.choice(list(running)).kill()
            killed += 1
        if time.monotonic() > kill_at:
            kill_server()
            killed += 1
            kill_at = time.monotonic() + 15.0
        for sender in [s for s in running if s.poll() is not None]:
            folder = running.pop(sender)
            if sender.returncode != 0:
                waiting.append(folder)
    took = time.monotonic() - begin
    unequal = [f.name for f in folders if differences(f)]
    check(not unequal, f"{consoles} consoles equal after {killed} kills {unequal[:3]}")
    entries = int(ask("SELECT sum(last_seq) FROM shop.streams")[0][0])
    print(f"figures: {entries} entries in {took:.1f} s with {killed} kills: {entries / took:.0f} entries/s", flush=True)
    made = int(ask("SELECT count(*) FROM shop.parts")[0][0])
    for table, size, index in ask(
            "SELECT coalesce(i.inhparent::regclass::text, c.oid::regclass::text), sum(pg_table_size(c.oid)), sum(pg_indexes_size(c.oid)) "
            "FROM pg_class c JOIN pg_namespace n ON n.oid = c.relnamespace LEFT JOIN pg_inherits i ON i.inhrelid = c.oid "
            "WHERE n.nspname = 'shop' AND c.relkind = 'r' GROUP BY 1 HAVING sum(pg_total_relation_size(c.oid)) > 1000000 ORDER BY 2 DESC"):
        print(f"figures: {table}: {int(size) / made * 1e6 / 1e9:.2f} GB rows, {int(index) / made * 1e6 / 1e9:.2f} GB indexes per million parts")


def main():
    with tempfile.TemporaryDirectory(prefix="kerf_shop_") as name:
        work = pathlib.Path(name)
        if len(sys.argv) > 1 and sys.argv[1] == "--long":
            campaign(work, int(sys.argv[2]), int(sys.argv[3]))
        elif len(sys.argv) > 1 and sys.argv[1] == "--day-off":
            day_off(work, int(sys.argv[2]))
        else:
            bad = work
            folders = three_consoles(work)
            bad_input(bad)
            rights(work)
            poison(work)
            newer_console(work)
            clocks_back(work)
            backup_and_clone(work)
            cut_links(folders[1])
            kills(folders, int(os.environ.get("KERF_SHOP_ROUNDS", "4")), 1)
            console_sends(work)
            difference_is_found(folders)
    print(f"{len(failures)} failed" if failures else "all held")
    return 1 if failures else 0


sys.exit(main())
