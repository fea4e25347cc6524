# SPDX-License-Identifier: MIT
"""A cable between a program's pseudo-terminal and an emulator's UART, as bad as a test wants it."""

import os
import random
import selectors
import socket
import threading
import tty

from frames import IntactFrames


class Wire:
    """One direction: drops, doubles and flips bytes at given rates, by a seed."""

    def __init__(self, damage, seed):
        self.damage = damage
        self.random = random.Random(seed)
        self.passed = 0

    def carry(self, data):
        self.passed += len(data)
        if self.damage == 0:
            return data
        out = bytearray()
        for byte in data:
            chance = self.random.random() / self.damage
            if chance < 1:  # dropped
                continue
            if chance < 2:  # one bit flipped
                byte ^= 1 << self.random.randrange(8)
            out.append(byte)
            if 2 <= chance < 3:  # doubled
                out.append(byte)
        return bytes(out)


class Cable:
    """Forwards between .path, a tty for the program, and .uart, a Unix socket for the emulator.

    damage: the rate of each kind of damage, per byte. cut_after: bytes from the device after which
    the cable is cut until mend(). rewrite: what becomes of the bytes from the device.
    """

    def __init__(self, folder, damage=0.0, seed=1, cut_after=None, rewrite=None):
        self.uart = os.path.join(folder, "uart")
        self.server = socket.socket(socket.AF_UNIX)
        self.server.bind(self.uart)
        self.server.listen(1)
        self.master, self.slave = os.openpty()
        tty.setraw(self.slave)
        os.set_blocking(self.master, False)
        self.path = os.ttyname(self.slave)
        self.to_device = Wire(damage, seed)
        self.to_host = Wire(damage, seed + 1)
        self.cut_after = cut_after
        self.rewrite = rewrite
        self.frames = IntactFrames()  # from the device, as they reach the host
        self.device = None
        self.stop = threading.Event()
        self.threads = []

    def plug_in(self, is_alive):
        """Once the emulator has been started: as long as it lives. @returns whether it has taken the cable"""
        self.server.settimeout(0.1)
        while self.device is None:
            try:
                self.device, _ = self.server.accept()
            except TimeoutError:
                if not is_alive():
                    return False
        self.device.setblocking(False)
        for direction in ((self.master, self.from_host), (self.device, self.from_device)):
            self.threads.append(threading.Thread(target=self.run, args=direction, daemon=True))
            self.threads[-1].start()
        return True

    def cut_in(self, count):
        """After so many more bytes from the device."""
        self.cut_after = self.to_host.passed + count

    def mend(self):
        self.cut_after = None

    def is_cut(self):
        return self.cut_after is not None and self.to_host.passed >= self.cut_after

    def hang_up(self):
        """The program's line is gone, once and for all."""
        self.stop.set()
        for thread in self.threads:
            thread.join()
        self.threads.clear()
        if self.master is not None:
            os.close(self.master)
        self.master = None

    def close(self):
        self.hang_up()
        for thing in (self.device, self.server):
            if thing is not None:
                thing.close()
        os.close(self.slave)

    def run(self, end, forward):
        """One direction, in a thread of its own: some emulated UARTs stop their processor until
        what it sends is taken, and take nothing themselves meanwhile."""
        with selectors.DefaultSelector() as ready:
            ready.register(end, selectors.EVENT_READ)
            while not self.stop.is_set():
                if ready.select(0.05) and not forward():
                    return

    def from_host(self):
        data = read_some(lambda: os.read(self.master, 65536))
        if data and not self.is_cut():
            write_all(self.device.fileno(), self.to_device.carry(data), self.stop)
        return data is not None

    def from_device(self):
        data = read_some(lambda: self.device.recv(65536))
        if data and not self.is_cut():
            data = self.to_host.carry(data)
            data = self.rewrite(data) if self.rewrite else data
            self.frames.take(data)
            write_all(self.master, data, self.stop)
        return data is not None


def read_some(read):
    """The bytes, maybe none; None where the other side has gone."""
    try:
        return read() or None
    except BlockingIOError:
        return b""
    except OSError:
        return None


def write_all(descriptor, data, stop):
    while data and not stop.is_set():
        try:
            data = data[os.write(descriptor, data):]
        except BlockingIOError:
            stop.wait(0.001)
        except OSError:
            return
