#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Modbus modules for tests: pymodbus servers, each behind a line that can be made bad.

Commands on stdin, one JSON object a line; every answer is one JSON object a line.
  {"do": "tcp", "units": {"1": {"input": 64, "holding": 64, "discrete": 64}}}   → {"id": 0, "port": P}
  {"do": "rtu", "device": "/dev/pts/N", "units": {…}}                           → {"id": 1}
  {"do": "set", "id": 0, "unit": 1, "kind": "input", "address": 0, "values": […]} → {"ok": true}
  {"do": "line", "id": 0, "mode": "pass|late|hang|cut|noise|lose", "delay_s": .5}       → {"ok": true}
Modes of the line: late: answers arrive delay_s later; hang: bytes go in and nothing comes out, connections stay
(half-open); cut: connections are closed and none is taken; noise: bytes of the answers are changed; lose: every second
answer never arrives.
"""
import asyncio
import json
import logging
import os
import pty
import sys
import tty

from pymodbus.datastore import ModbusSequentialDataBlock, ModbusServerContext, ModbusSlaveContext
from pymodbus.device import ModbusDeviceIdentification
from pymodbus.server import async_io
from pymodbus.transaction import ModbusRtuFramer

logging.getLogger("pymodbus").setLevel(logging.CRITICAL)

KINDS = {"coil": 1, "discrete": 2, "holding": 3, "input": 4}


def context_of(units):
    slaves = {}
    for unit, sizes in units.items():
        blocks = {name: ModbusSequentialDataBlock(0, [0] * max(1, sizes.get(name, 0))) for name in KINDS}
        slaves[int(unit)] = ModbusSlaveContext(
            di=blocks["discrete"], co=blocks["coil"], hr=blocks["holding"], ir=blocks["input"], zero_mode=True
        )
    return ModbusServerContext(slaves=slaves, single=False)


class Line:
    """What an answer suffers on its way."""

    def __init__(self):
        self.mode = "pass"
        self.delay_s = 0.5
        self.answers = 0
        self.open = set()

    async def carry(self, data, write):
        self.answers += 1
        mode = self.mode
        if mode == "hang" or mode == "cut" or (mode == "lose" and self.answers % 2 == 0):
            return
        if mode == "noise":
            data = b"\xff\x00" + bytes(b ^ 0x55 if i % 3 == 0 else b for i, b in enumerate(data))
        if mode == "late":
            asyncio.get_running_loop().call_later(self.delay_s, write, data)
            return
        write(data)


async def tcp_module(units):
    context = context_of(units)
    identity = ModbusDeviceIdentification()
    identity.VendorName, identity.ProductCode, identity.MajorMinorRevision = "Kerf", b"TH8\xb0", "2.1"
    inner = await async_io.StartAsyncTcpServer(context=context, identity=identity, address=("127.0.0.1", 0), defer_start=True)
    asyncio.create_task(inner.serve_forever())
    await inner.serving
    inner_port = inner.server.sockets[0].getsockname()[1]
    line = Line()

    async def taken(reader, writer):
        if line.mode == "cut":
            writer.close()
            return
        line.open.add(writer)
        to_server = await asyncio.open_connection("127.0.0.1", inner_port)

        def write(data):
            if not writer.is_closing():
                writer.write(data)

        async def back():
            while data := await to_server[0].read(4096):
                await line.carry(data, write)

        answers = asyncio.create_task(back())
        try:
            while data := await reader.read(4096):
                if line.mode != "hang":
                    to_server[1].write(data)
        except ConnectionError:
            pass
        line.open.discard(writer)
        answers.cancel()
        to_server[1].close()
        writer.close()

    server = await asyncio.start_server(taken, "127.0.0.1", 0)
    return context, line, server.sockets[0].getsockname()[1]


async def rtu_module(device, units):
    """kerf ↔ `device` (one end of a socat pair) ↔ this line ↔ a pty of our own ↔ pymodbus."""
    context = context_of(units)
    line = Line()
    ours, theirs = pty.openpty()
    tty.setraw(ours)
    tty.setraw(theirs)
    outside = os.open(device, os.O_RDWR | os.O_NOCTTY)
    tty.setraw(outside)
    server = await async_io.StartAsyncSerialServer(
        context=context, framer=ModbusRtuFramer, port=os.ttyname(theirs), baudrate=19200, timeout=0.01, defer_start=True
    )
    await server.start()
    asyncio.create_task(server.serve_forever())
    loop = asyncio.get_running_loop()

    def asked():
        try:
            data = os.read(outside, 4096)
        except OSError:  # the adapter was pulled out
            loop.remove_reader(outside)
            return
        if line.mode not in ("hang", "cut"):
            os.write(ours, data)

    pending = bytearray()

    def answered():
        # What comes out in pieces goes on as one answer.
        pending.extend(os.read(ours, 4096))
        loop.call_later(0.005, flush)

    def flush():
        if pending:
            data = bytes(pending)
            pending.clear()
            asyncio.create_task(line.carry(data, send))

    def send(data):
        try:
            os.write(outside, data)
        except OSError:  # the adapter was pulled out
            pass

    loop.add_reader(outside, asked)
    loop.add_reader(ours, answered)
    return context, line


async def main():
    modules = []
    reader = asyncio.StreamReader()
    await asyncio.get_running_loop().connect_read_pipe(lambda: asyncio.StreamReaderProtocol(reader), sys.stdin)

    def say(answer):
        print(json.dumps(answer), flush=True)

    while text := await reader.readline():
        order = json.loads(text)
        try:
            if order["do"] == "tcp":
                context, line, port = await tcp_module(order["units"])
                modules.append((context, line))
                say({"id": len(modules) - 1, "port": port})
            elif order["do"] == "rtu":
                modules.append(await rtu_module(order["device"], order["units"]))
                say({"id": len(modules) - 1})
            elif order["do"] == "set":
                slave = modules[order["id"]][0][order["unit"]]
                slave.setValues(KINDS[order["kind"]], order["address"], order["values"])
                say({"ok": True})
            elif order["do"] == "line":
                line = modules[order["id"]][1]
                line.mode = order["mode"]
                line.delay_s = order.get("delay_s", line.delay_s)
                if line.mode == "cut":
                    for writer in list(line.open):
                        writer.close()
                say({"ok": True, "answers": line.answers})
        except Exception as fault:  # the test must see it
            say({"fault": f"{type(fault).__name__}: {fault}"})


asyncio.run(main())
