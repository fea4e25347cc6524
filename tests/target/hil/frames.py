# SPDX-License-Identifier: MIT
"""Frames of the serial link (port/shared/link/link.md), written down a second time."""

import struct
import zlib

POSE = 0x82
STEP_REPORT = 0x87
HEADER = 4  # version, type, sequence number


def unstuff(wire):
    """COBS, without its delimiter."""
    raw = bytearray()
    at = 0
    while at < len(wire):
        length = wire[at]
        raw += wire[at + 1:at + length]
        at += length
        if at < len(wire):
            raw.append(0)
    return bytes(raw)


def stuff(raw):
    """COBS of less than 254 bytes."""
    return b"".join(bytes([len(piece) + 1]) + piece for piece in raw.split(b"\0"))


def signed(body):
    return body + struct.pack("<I", zlib.crc32(body))


def is_intact(raw):
    return len(raw) >= HEADER + 4 and signed(raw[:-4]) == raw


class IntactFrames:
    """Counts them as they go by."""

    def __init__(self):
        self.intact = 0
        self.rest = b""

    def take(self, data):
        *wires, self.rest = (self.rest + data).split(b"\0")
        self.rest = self.rest[-256:]  # longer than any frame: noise without an end
        self.intact += sum(map(is_intact, map(unstuff, wires)))


class Silences:
    """Passes bytes on, and keeps what each step report says: [(step, silences), ...]."""

    def __init__(self):
        self.told = []
        self.rest = b""

    def __call__(self, data):
        *wires, self.rest = (self.rest + data).split(b"\0")
        for raw in map(unstuff, wires):
            if len(raw) > HEADER + 22 and raw[1] == STEP_REPORT and signed(raw[:-4]) == raw:
                step, silences = struct.unpack_from("<I14xI", raw, HEADER)
                self.told.append((step, silences))
        return data


class FlipOneBit:
    """Passes bytes on, but for one bit: bit 0 of a byte of the payload in all frames of a type and
    a step on one side, whose check sums are made to fit."""

    def __init__(self, frame_type, step, side, byte):
        self.frame_type = frame_type
        self.beginning = struct.pack("<IB", step, side)
        self.byte = byte
        self.rest = b""

    def __call__(self, data):
        *wires, self.rest = (self.rest + data).split(b"\0")
        return b"".join(self.changed(wire) + b"\0" for wire in wires)

    def changed(self, wire):
        raw = unstuff(wire)
        if len(raw) < HEADER or raw[1] != self.frame_type:
            return wire
        body = bytearray(raw[:-4])
        if not body[HEADER:].startswith(self.beginning):
            return wire
        assert signed(bytes(body)) == raw, "the frame was not intact"
        body[HEADER + self.byte] ^= 1
        return stuff(signed(bytes(body)))
