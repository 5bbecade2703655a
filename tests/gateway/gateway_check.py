#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""kerf-gateway from outside: its documents against the official schemas, its clients of every kind, its board in a browser.

The console is played here: this writes the live page as app/live does, and falls silent when it is told to.
"""
import json
import mmap
import os
import pathlib
import re
import shutil
import socket
import ssl
import struct
import subprocess
import sys
import tempfile
import threading
import time
import urllib.error
import urllib.request

BIN = pathlib.Path(os.environ["KERF_BIN"])
SCHEMAS = pathlib.Path(os.environ["KERF_FIXTURES"]) / "mtconnect"
CAPACITY = 64 * 1024
failures = []


def check(condition, what):
    print(("ok    " if condition else "FAIL  ") + what, flush=True)
    if not condition:
        failures.append(what)


class Console(threading.Thread):
    """Writes the live page every `period` seconds until it is killed."""

    def __init__(self, folder, period=0.05):
        super().__init__(daemon=True)
        self.period, self.alive, self.turn = period, True, 0
        path = pathlib.Path(folder, "live.page")
        path.write_bytes(bytes(32 + CAPACITY))
        self.file = open(path, "r+b")
        self.page = mmap.mmap(self.file.fileno(), 32 + CAPACITY)
        self.page[0:8] = b"KRFLIVE1"
        self.start()

    def run(self):
        step = 0
        while self.alive:
            step += 1
            live = {"utc_ms": int(time.time() * 1000), "machine": "VB-1", "simulated": True, "link": True, "on": True,
                    "estop": False, "feedhold": False, "held": False, "program": "running", "process": "boring", "part": 7,
                    "override": 1.0, "scale": 1.0, "feed_mmPerS": 2 + step % 997 / 1000, "feed_mmPerRev": 0.2 + step % 991 / 1e5,
                    "speed_rpm": 500 + step % 89 / 10, "force_N": 100 + step % 983 / 10, "temp_degC": [21 + step % 83 / 100, None, 22.5],
                    "position_mm": [step % 977 / 10, step % 971 / 10, step % 967 / 10],
                    "offset_um": [1.5, -2.25, step % 79], "drift_um": [step % 73 / 7, step % 71 / 7, None], "loops": []}
            text = json.dumps(live).encode()
            self.turn += 2
            self.page[8:16] = struct.pack("<Q", self.turn - 1)
            self.page[32:32 + len(text)] = text
            self.page[16:32] = struct.pack("<qQ", int(time.monotonic() * 1000), len(text))
            self.page[8:16] = struct.pack("<Q", self.turn)
            time.sleep(self.period)

    def kill(self):
        self.alive = False
        self.join()


class Gateway:
    def __init__(self, folder, *options):
        self.process = subprocess.Popen([BIN / "kerf-gateway", "--data", folder, "--http", "0", "--shdr", "0", *options],
                                        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        self.http = int(self.process.stdout.readline().split()[1])
        self.shdr = int(self.process.stdout.readline().split()[1])

    def get(self, path, timeout=30):
        try:
            with urllib.request.urlopen(f"http://127.0.0.1:{self.http}{path}", timeout=timeout) as answer:
                return answer.status, answer.read().decode()
        except urllib.error.HTTPError as error:
            return error.code, error.read().decode()

    def keeps_what_is_freed(self):
        """A sanitizer does, for a while: memory then says nothing."""
        return re.search(r"lib[at]san", pathlib.Path(f"/proc/{self.process.pid}/maps").read_text()) is not None

    def memory_kB(self):
        return int(re.search(r"VmRSS:\s+(\d+)", pathlib.Path(f"/proc/{self.process.pid}/status").read_text()).group(1))

    def descriptors(self):
        return len(os.listdir(f"/proc/{self.process.pid}/fd"))

    def end(self):
        self.process.terminate()
        self.process.wait()


def invalid(text, kind):
    """Why a document is not valid; empty when it is."""
    run = subprocess.run(["xmllint", "--nonet", "--noout", "--schema", SCHEMAS / f"MTConnect{kind}_2.7_1.0.xsd", "-"],
                         input=text, capture_output=True, text=True)
    return "" if run.returncode == 0 else run.stderr[:600]


def wait_for(condition, seconds=10):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if condition():
            return True
        time.sleep(0.02)
    return False


def documents(gateway):
    check(wait_for(lambda: 'dataItemId="avail"' in gateway.get("/current")[1] and ">AVAILABLE<" in gateway.get("/current")[1]),
          "values come")
    wait_for(lambda: "FeatureMeasurementTable" in gateway.get("/current")[1] and "MEASUREMENT_VALUE" in gateway.get("/current")[1])
    uuid = re.search(r'assetId="([^"]+)"', gateway.get("/assets")[1]).group(1)
    good = {"/probe": "Devices", "/current": "Streams", "/sample": "Streams", "/sample?from=1&count=500": "Streams",
            "/sample?count=1": "Streams", "/current?path=//DataItem[@type=%22POSITION%22]": "Streams", "/current?path=//Axes": "Streams",
            "/sample?path=//Path": "Streams", "/current?at=30": "Streams", "/assets": "Assets", "/assets/": "Assets", f"/assets/{uuid}": "Assets",
            "/VB-1/current": "Streams"}
    for path, kind in good.items():
        status, text = gateway.get(path)
        check(status == 200 and not invalid(text, kind), f"{path} is a valid {kind} document {invalid(text, kind)}")
    bad = {"/nothing": 404, "/sample?from=999999999999": 404, "/sample?from=-1": 404, "/sample?from=0": 404, "/sample?from=x": 404,
           "/sample?count=0": 404, "/sample?count=99999999999999999999": 404, "/sample?count=-5": 404, "/current?at=0": 404,
           "/sample?interval=-1": 400, "/sample?interval=x": 400, "/sample?heartbeat=1&interval=100": 400, "/current?path=//[": 400,
           "/current?path=//Nothing": 400, "/current?path=" + "/" * 500: 400, "/assets/none": 404, "/../../etc/passwd": 404,
           "/probe/%00": 404}
    for path, expected in bad.items():
        status, text = gateway.get(path)
        check(status == expected and not invalid(text, "Error"), f"{path[:60]} is {status} and a valid error {invalid(text, 'Error')}")
    check('name="heartbeat"' in gateway.get("/sample?heartbeat=1&interval=100")[1], "the parameter that is wrong is named")
    check(gateway.get("/current?path=//DataItem[@id='a/b[::']")[0] == 400 and gateway.get("/current?path=//*[@id='avail']")[0] == 200,
          "an attribute may be asked for")
    text = gateway.get("/current")[1]
    check("CHARACTERISTIC_STATUS" in text and "UNCERTAINTY" in text, "bores with their interval")
    check(re.search(r"<(Warning|Fault)[^>]*nativeCode", text) is not None, "a standing alarm is a condition")
    check(">25.0" not in text and 'subType="ACTUAL"' in text, "subtypes")


def silence(gateway, console):
    console.kill()
    begin = time.monotonic()
    gone = wait_for(lambda: 'dataItemId="avail"' in gateway.get("/current")[1] and ">AVAILABLE<" not in gateway.get("/current")[1], 5)
    took = time.monotonic() - begin
    text = gateway.get("/current")[1]
    check(gone and took < 2.0, f"everything is unavailable {took:.2f} s after the console went silent")
    values = re.findall(r'dataItemId="(\w+)"[^>]*>([^<]*)<', text)
    check(all(v in ("UNAVAILABLE", "") for _, v in values), f"values left: {[v for v in values if v[1] not in ('UNAVAILABLE', '')][:4]}")
    check(not invalid(text, "Streams") and "<Unavailable" in text,
          "no value is left")


def shdr(gateway):
    link = socket.create_connection(("127.0.0.1", gateway.shdr), timeout=10)
    link.sendall(b"* PING\n")
    text = b""
    end = time.monotonic() + 10
    while time.monotonic() < end and not (b"* PONG 10000\n" in text and text.count(b"|Xpos|") > 2):
        text += link.recv(65536)
    link.close()
    check(b"* PONG 10000\n" in text, "SHDR: a ping is answered")
    check(re.search(rb"\d\d\d\d-\d\d-\d\dT[\d:.]+Z\|Xpos\|[\d.]+\n", text) is not None, "SHDR: values")
    check(re.search(rb"\|alarms\|(WARNING|FAULT)\|101\|\|\|", text) is not None, "SHDR: conditions")


def follow(gateway, numbers):
    """A client that goes from sequence to sequence while the buffer turns over."""
    begin = time.monotonic()
    answer = urllib.request.urlopen(f"http://127.0.0.1:{gateway.http}/sample?interval=20&count=5000", timeout=30)
    seen, expected, text, checked = 0, None, b"", 0
    gap = ""
    first_of_buffer = 1
    while seen < numbers and not gap and time.monotonic() - begin < 300:
        text += answer.read1(262144)
        while True:
            head = re.search(rb"Content-length: (\d+)\r\n\r\n", text)
            if not head or len(text) < head.end() + int(head.group(1)):
                break
            document = text[head.end():head.end() + int(head.group(1))]
            text = text[head.end() + int(head.group(1)):]
            if b"MTConnectError" in document:
                gap = document.decode()[:300]
                break
            sequences = sorted(int(s) for s in re.findall(rb' sequence="(\d+)"', document))
            if expected is not None and sequences and sequences[0] != expected:
                gap = f"{expected} was next, {sequences[0]} came"
            if sequences and sequences != list(range(sequences[0], sequences[-1] + 1)):
                gap = f"a gap within {sequences[0]}…{sequences[-1]}"
            if sequences:
                expected = sequences[-1] + 1
                seen += len(sequences)
            first_of_buffer = int(re.search(rb'firstSequence="(\d+)"', document).group(1))
            if checked < 3:
                checked += 1
                if invalid(document.decode(), "Streams"):
                    gap = invalid(document.decode(), "Streams")
    took = time.monotonic() - begin
    answer.close()
    check(seen >= numbers and not gap and first_of_buffer > 1,
          f"{seen} sequence numbers without gap in {took:.0f} s; the buffer began at {first_of_buffer} at the end {gap}")


def hostile(gateway):
    gateway.get("/current")
    memory, descriptors = gateway.memory_kB(), gateway.descriptors()
    results = []
    threads = [threading.Thread(target=lambda: results.append(gateway.get("/current", 120)[0])) for _ in range(200)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    check(results == [200] * 200, f"200 clients at once are served: {len(results)}")
    idle = [socket.create_connection(("127.0.0.1", gateway.http)) for _ in range(60)]  # half open: they say nothing
    dribbling = [socket.create_connection(("127.0.0.1", gateway.http)) for _ in range(20)]
    greedy = [socket.create_connection(("127.0.0.1", gateway.http)) for _ in range(20)]
    for link in greedy:  # ask for a stream and never read it
        link.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        link.sendall(b"GET /sample?interval=10&count=10000 HTTP/1.1\r\nHost: x\r\n\r\n")
    long_head = socket.create_connection(("127.0.0.1", gateway.http))
    long_head.sendall(b"GET / HTTP/1.1\r\nX: " + b"x" * 20000)
    check(b"431" in long_head.recv(100), "a head of 20 kB is refused")
    post = socket.create_connection(("127.0.0.1", gateway.http))
    post.sendall(b"POST /current HTTP/1.1\r\nContent-Length: 1000000\r\n\r\n" + b"x" * 1000)
    check(b"405" in post.recv(100), "nothing can be written")
    noise = socket.create_connection(("127.0.0.1", gateway.http))
    noise.sendall(bytes(range(256)) + b"\r\n\r\n")
    check(b"400" in noise.recv(100), "noise is refused")
    begin = time.monotonic()
    slowest = 0.0
    while time.monotonic() - begin < 8:
        for link in dribbling:
            try:
                link.send(b"G")
            except OSError:
                pass
        asked = time.monotonic()
        gateway.get("/probe")
        slowest = max(slowest, time.monotonic() - asked)
        time.sleep(0.2)

    def cut(link):
        link.setblocking(False)
        try:
            return link.recv(1) == b""
        except BlockingIOError:
            return False
        except OSError:
            return True

    check(all(cut(link) for link in idle + dribbling), "silent and dribbling clients are let go")
    for link in idle + dribbling + greedy + [long_head, post, noise]:
        link.close()
    back = wait_for(lambda: gateway.descriptors() <= descriptors + 3, 15)
    grown = gateway.memory_kB() - memory
    check(back and (grown < 150_000 or gateway.keeps_what_is_freed()), f"no growth: {gateway.descriptors() - descriptors} descriptors, {grown / 1000:.0f} MB after {slowest:.2f} s at most")


def guarded(folder, work):
    run = subprocess.run([BIN / "kerf-gateway", "--data", folder, "--http", "0", "--listen", "0.0.0.0"], capture_output=True, text=True, timeout=20)
    check(run.returncode == 3 and "only with" in run.stderr, "beyond 127.0.0.1 not without TLS and tokens")
    key, certificate, tokens = work / "key.pem", work / "certificate.pem", work / "tokens"
    subprocess.run(["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:P-256", "-nodes", "-keyout", key, "-out",
                    certificate, "-days", "2", "-subj", "/CN=localhost"], check=True, capture_output=True)
    made = subprocess.run([BIN / "kerf-gateway", "--new-token", "wall"], capture_output=True, text=True, timeout=20)
    tokens.write_text(made.stdout)
    token = made.stderr.strip().split(": ")[1]
    check(token not in made.stdout, "the file holds the token's hash only")
    process = subprocess.Popen([BIN / "kerf-gateway", "--data", folder, "--http", "0", "--listen", "0.0.0.0", "--certificate", certificate,
                                "--key", key, "--tokens", tokens], stdout=subprocess.PIPE, text=True)
    port = int(process.stdout.readline().split()[1])
    context = ssl.create_default_context(cafile=certificate)
    context.check_hostname = False

    def get(headers):
        try:
            request = urllib.request.Request(f"https://127.0.0.1:{port}/current", headers=headers)
            with urllib.request.urlopen(request, context=context, timeout=20) as answer:
                return answer.status
        except urllib.error.HTTPError as error:
            return error.code

    check(get({}) == 401, "TLS without a token: 401")
    check(get({"Authorization": "Bearer wrong"}) == 401, "with a wrong one: 401")
    check(get({"Authorization": f"Bearer {token}"}) == 200, "with the token: 200")
    process.terminate()
    process.wait()


class Browser:
    """Chromium without a screen, led by the pipe of its developer tools."""

    def __init__(self, work):
        to_child, self.out = os.pipe()
        self.into, from_child = os.pipe()
        os.set_inheritable(to_child, True)
        os.set_inheritable(from_child, True)

        def place():  # Chromium reads descriptor 3 and writes 4
            os.dup2(to_child, 103)
            os.dup2(from_child, 104)
            os.dup2(103, 3)
            os.dup2(104, 4)

        self.process = subprocess.Popen(["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--remote-debugging-pipe",
                                         "--force-color-profile=srgb", f"--user-data-dir={work / 'browser'}", "about:blank"],
                                        preexec_fn=place, close_fds=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_child)
        os.close(from_child)
        self.number, self.rest, self.session = 0, b"", None

    def ask(self, method, **params):
        self.number += 1
        message = {"id": self.number, "method": method, "params": params}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.out, json.dumps(message).encode() + b"\0")
        while True:
            while b"\0" not in self.rest:
                block = os.read(self.into, 1 << 20)
                if not block:
                    raise RuntimeError("the browser has ended")
                self.rest += block
            text, self.rest = self.rest.split(b"\0", 1)
            answer = json.loads(text)
            if answer.get("id") == self.number:
                return answer.get("result", {})

    def open(self, page, width, height):
        self.session = None
        target = self.ask("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=width < 600)
        self.ask("Page.navigate", url=page)

    def value(self, script):
        return self.ask("Runtime.evaluate", expression=script, returnByValue=True).get("result", {}).get("value")

    def picture(self, file):
        import base64
        pathlib.Path(file).write_bytes(base64.b64decode(self.ask("Page.captureScreenshot")["data"]))

    def end(self):
        self.session = None
        self.ask("Browser.close")
        self.process.wait(30)


def board(gateway, console, work):
    if not shutil.which("chromium"):
        print("skipped: chromium is not installed")
        return
    pictures = os.environ.get("KERF_BOARD_PICTURES", "")
    browser = Browser(work)
    values = '[...document.querySelectorAll("dd.value")].map(e => e.textContent).join("|")'
    text = "document.body.innerText"
    grey = '!!document.querySelector("article.stale")'
    for width, height, language, cutting, name in ((390, 844, "en", "Cutting", "board_phone"), (1920, 1080, "ko", "가공 중", "board_wall")):
        browser.open(f"http://127.0.0.1:{gateway.http}/?lang={language}", width, height)
        check(wait_for(lambda: (browser.value(values) or "").count("|") >= 5), f"the board shows the machine at {width} × {height}")
        check("VB-1" in browser.value(text) and cutting in browser.value(text), f"what it does is said in {language}")
        first = browser.value(values)
        check(wait_for(lambda: browser.value(values) != first), "its values change")
        check(browser.value('[...document.querySelectorAll("dd.value")].every(e => /[0-9]/.test(e.nextSibling.textContent))'),
              "every value has its age beside it")
        check(browser.value("document.documentElement.scrollWidth") <= width, "nothing is wider than the screen")
        check(browser.value(grey) is False, "and is not grey while the console lives")
        if pictures:
            browser.picture(f"{pictures}/{name}.png")
    browser.open(f"http://127.0.0.1:{gateway.http}/?lang=en", 390, 844)
    wait_for(lambda: browser.value("!!document.querySelector('article')"))
    few = browser.value("document.querySelectorAll('tr').length")
    browser.value("document.querySelector('article').click()")
    check(wait_for(lambda: browser.value("document.querySelectorAll('tr').length") > few), "a tap opens the machine")
    browser.value("document.getElementById('language').click()")
    check(wait_for(lambda: "가공 중" in browser.value(text)), "the other language is one touch away")
    browser.value("document.getElementById('language').click()")
    console.kill()
    began = time.monotonic()
    check(wait_for(lambda: browser.value(grey) and "Console is silent" in browser.value(text)) and time.monotonic() - began < 3.5,
          f"it goes grey when the console dies, and says so, after {time.monotonic() - began:.1f} s")
    if pictures:
        browser.picture(f"{pictures}/board_silent.png")
    gateway.end()
    check(wait_for(lambda: "no connection to the gateway" in browser.value(text)), "and says when the gateway is gone")
    browser.end()


def main():
    with tempfile.TemporaryDirectory(prefix="kerf_gateway_") as name:
        work = pathlib.Path(name)
        folder = work / "console"
        subprocess.run([BIN / "shop_fixture", folder, "12", "1"], check=True, timeout=120)
        import sqlite3
        file = sqlite3.connect(folder / "kerf.db")
        file.execute("INSERT INTO alarms (code, priority, raised_utc_ms, detail_text, detail_args) VALUES (101, 2, ?, 'Bore %1 mm outside', "
                     "'[{\"v\":50.125,\"d\":3}]')", (int(time.time() * 1000),))
        file.commit()
        file.close()
        console = Console(folder)
        gateway = Gateway(folder)
        documents(gateway)
        shdr(gateway)
        silence(gateway, console)
        gateway.end()
        guarded(folder, work)
        console = Console(folder)
        gateway = Gateway(folder)
        board(gateway, console, work)
        console.kill()
        gateway.end()
        console = Console(folder, 0.002)
        gateway = Gateway(folder, "--period", "2", "--buffer", "20000")
        follow(gateway, int(os.environ.get("KERF_GATEWAY_NUMBERS", "20000")) )
        hostile(gateway)
        console.kill()
        gateway.end()
    print(f"{len(failures)} failed" if failures else "all held")
    return 1 if failures else 0


for needed in ("xmllint", "openssl"):
    if not shutil.which(needed):
        print(f"skipped: {needed} is not installed")
        sys.exit(77)
sys.exit(main())
