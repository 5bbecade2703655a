#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A console with a certificate of its own against a server that takes nothing else: docs/shop.md, word for word. Run by pg_virtualenv."""
import json
import os
import pathlib
import shutil
import stat
import subprocess
import sys
import tempfile
import time

import psycopg2

BIN = pathlib.Path(os.environ["KERF_BIN"])
PORT, DATABASE = os.environ["PGPORT"], os.environ["PGDATABASE"]
OWNER = f"dbname={DATABASE} host=127.0.0.1 port={PORT} sslmode=disable"
failures = []


def check(condition, what):
    print(("ok    " if condition else "FAIL  ") + what, flush=True)
    if not condition:
        failures.append(what)


def kerf(*arguments, expect=0):
    done = subprocess.run([BIN / "kerf", "shop", *map(str, arguments)], capture_output=True, text=True, timeout=120)
    check(done.returncode == expect, f"kerf shop {arguments[0]} ends with {expect}" +
          ("" if done.returncode == expect else f", not {done.returncode}: {done.stdout} {done.stderr}"))
    return done


def openssl(work, *arguments):
    subprocess.run(["openssl", *map(str, arguments)], cwd=work, check=True, capture_output=True, timeout=60)


def certificates(work):
    """The plant's authority, and the server's certificate for "localhost"."""
    openssl(work, "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-keyout", "ca.key", "-out", "ca.pem", "-subj", "/CN=plant")
    openssl(work, "req", "-newkey", "rsa:2048", "-nodes", "-keyout", "server.key", "-out", "server.csr", "-subj", "/CN=localhost")
    (work / "names").write_text("subjectAltName=DNS:localhost")
    openssl(work, "x509", "-req", "-in", "server.csr", "-CA", "ca.pem", "-CAkey", "ca.key", "-CAcreateserial", "-out",
            "server.pem", "-extfile", "names")
    (work / "server.key").chmod(0o600)


def guarded(work):
    """The server speaks TLS, and consoles come in by certificate alone."""
    owner = psycopg2.connect(OWNER)
    owner.autocommit = True
    cursor = owner.cursor()
    for setting, file in (("ssl_cert_file", "server.pem"), ("ssl_key_file", "server.key"), ("ssl_ca_file", "ca.pem")):
        cursor.execute(f"ALTER SYSTEM SET {setting} = '{work / file}'")
    cursor.execute("ALTER SYSTEM SET ssl = on")
    cursor.execute("SHOW hba_file")
    rules = pathlib.Path(cursor.fetchone()[0])
    rules.write_text("hostssl all +kerf_console all cert\nhost all +kerf_console all reject\n" + rules.read_text())
    cursor.execute("SELECT pg_reload_conf()")
    for _ in range(100):
        try:
            psycopg2.connect(OWNER.replace("disable", "require").replace("127.0.0.1", "localhost")).close()
            return
        except psycopg2.OperationalError:
            time.sleep(0.1)


def main():
    work = pathlib.Path(tempfile.mkdtemp(prefix="kerf_tls_"))
    folder, other = work / "console", work / "other"
    for place, seed in ((folder, "1"), (other, "2")):
        subprocess.run([BIN / "shop_fixture", place, "4", seed], check=True, timeout=120)
    certificates(work)
    kerf("init", "--database", OWNER)
    asked = json.loads(kerf("enroll", "--data", folder).stdout)
    key, request = folder / "shop" / "console.key", folder / "shop" / "console.csr"
    check(stat.S_IMODE(key.stat().st_mode) == 0o600, "the console's key is the console's alone")
    kerf("enroll", "--data", folder, "--database", OWNER, "--name", "VB-1")
    guarded(work)
    openssl(work, "x509", "-req", "-in", request, "-CA", "ca.pem", "-CAkey", "ca.key", "-CAcreateserial", "-out", "console.crt")
    way = (f"host=localhost port={PORT} dbname={DATABASE} user={asked['role']} sslmode=verify-full sslrootcert={work}/ca.pem "
           f"sslcert={work}/console.crt sslkey={key}")

    def push(conninfo, expect=0, place=folder):
        return kerf("push", "--data", place, "--database", conninfo, "--once", expect=expect)

    check("refuses" in push(way.replace("verify-full", "disable"), 3).stderr, "without TLS the server takes no console")
    check("does not match" in push(way.replace("host=localhost", "host=127.0.0.1"), 3).stderr,
          "a server of another name is not talked to")
    openssl(work, "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-keyout", "stranger.key", "-out", "stranger.pem", "-subj",
            f"/CN={asked['role']}")
    (work / "stranger.key").chmod(0o600)
    push(way.replace(f"{work}/console.crt", f"{work}/stranger.pem").replace(str(key), f"{work}/stranger.key"), 3)
    check(True, "nor is a certificate of somebody else's taken")
    sent = json.loads(push(way).stdout)
    check(sent["unsent"] == 0 and sent["sent"] > 0, f"with its certificate the console sends {sent['sent']} entries")
    check(json.loads(push(way).stdout)["sent"] == 0, "and nothing twice")
    kerf("verify", "--data", folder, "--database", OWNER)
    check("not enrolled" in push(way, 3, other).stderr, "another console does not come in by this one's certificate")
    check("password" in push(way + " password=secret").stderr, "a password on the command line is complained about")
    inside = psycopg2.connect(way)
    inside.autocommit = True
    for statement in ("SELECT * FROM shop.parts", "SELECT * FROM shop.consoles", "DELETE FROM shop.measurements",
                      "CREATE TABLE shop.x (a int)", "CREATE TABLE public.x (a int)", "SET ROLE kerf_reader"):
        try:
            inside.cursor().execute(statement)
            check(False, f"a console may not {statement}")
        except psycopg2.errors.InsufficientPrivilege:
            check(True, f"a console may not {statement}")
    inside.close()
    shutil.rmtree(work)
    print(f"{len(failures)} failures")
    return 1 if failures else 0


if not shutil.which("openssl"):
    print("skipped: openssl is not installed")
    sys.exit(77)
sys.exit(main())
