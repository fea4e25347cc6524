#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Talks to the program `uart` over the emulated UART. usage: uart_test.py echo|flood COMMAND... (emulator and program)"""

import os
import random
import resource
import socket
import subprocess
import sys
import tempfile

PROCESSOR_SECONDS = 60  # of the emulator: a busy machine does not spend them
ECHO_BYTES = 20000
FLOOD_BYTES = 3000
WINDOW = 400  # less than the receive ring


def start(command, path, words):
    environment = dict(os.environ, BATUTA_QEMU_OPTIONS=f"-serial unix:{path}")
    return subprocess.Popen(command + words, env=environment, stdin=subprocess.DEVNULL, preexec_fn=limit_processor_time)


def limit_processor_time():
    resource.setrlimit(resource.RLIMIT_CPU, (PROCESSOR_SECONDS, PROCESSOR_SECONDS))


def accept(server, emulator):
    """The emulator's end of the line, as long as it lives; where it has died the line ends."""
    server.settimeout(0.1)
    while True:
        try:
            connection, _ = server.accept()
            connection.settimeout(None)
            return connection
        except TimeoutError:
            if emulator.poll() is not None:
                raise EOFError(f"the emulator has ended, with status {emulator.poll()}") from None


def receive(connection, count):
    data = b""
    while len(data) < count:
        more = connection.recv(count - len(data))
        if not more:
            raise EOFError(f"the line ended after {len(data)} of {count} bytes")
        data += more
    return data


def echo(connection):
    """Every value of a byte, in an order that a mistake cannot reproduce."""
    data = random.Random(1).randbytes(ECHO_BYTES)
    for begin in range(0, ECHO_BYTES, WINDOW):
        part = data[begin:begin + WINDOW]
        connection.sendall(part)
        if receive(connection, len(part)) != part:
            raise ValueError(f"other bytes came back from byte {begin} on")
    connection.sendall(b".")  # the program ends when all has been seen


def main(mode, command):
    with tempfile.TemporaryDirectory() as folder, socket.socket(socket.AF_UNIX) as server:
        path = os.path.join(folder, "uart")
        server.bind(path)
        server.listen(1)
        count = ECHO_BYTES + 1 if mode == "echo" else FLOOD_BYTES
        with start(command, path, [mode, str(count)]) as emulator:
            try:
                connection = accept(server, emulator)
                echo(connection) if mode == "echo" else connection.sendall(bytes(FLOOD_BYTES))
                return emulator.wait()
            finally:
                emulator.kill()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
