#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the fuzzer's seeds: the protocol of port/shared/link/link.md in a second language, so that the
seeds are also a check of the first. One seed a message, and one a kind of damage.

usage: make_corpus.py [--compare] FOLDER    --compare: exit 1 unless FOLDER holds these very files
"""
import pathlib
import struct
import sys
import zlib

VERSION = 3
RAW, WRAPPED = b"\x00", b"\x01"  # first byte of a seed: how the fuzz target uses the rest

SAMPLE = struct.pack("<IffffII", 123456, 0.5, -1.0, 0.25, -0.75, 1, 7)
UNIT = struct.pack("<3f", 0.0, 0.6, -0.8)
POINT = struct.pack("<3f", 0.25, -1.5, 1.125)

MESSAGES = {
    "hello": (0x01, struct.pack("<IBB", 0xC0FFEE, 0, 5)),
    "step_none": (0x02, struct.pack("<IB", 1, 0)),
    "step_left": (0x02, struct.pack("<IB", 2, 1) + SAMPLE),
    "step_both": (0x02, struct.pack("<IB", 3, 3) + SAMPLE + SAMPLE),
    "stick_sample": (0x03, b"\x01" + SAMPLE),
    "welcome": (0x81, struct.pack("<IBBIIIII", 0xC0FFEE, VERSION, 1, 1000, 4, 12, 340, 17)),
    "pose": (0x82, struct.pack("<IB", 17, 0) + POINT + struct.pack("<4f", 0.5, -0.5, 0.5, 0.5)),
    "event": (0x83, struct.pack("<IBBBHHf", 17, 2, 1, 0, 0, 1, 0.00025) + POINT + UNIT
              + struct.pack("<5f", 1e-6, -3.5, 0.125, 0.75, 1.0)),
    "force": (0x84, struct.pack("<IBffB", 17, 1, -0.5, 0.25, 3)),
    "touch": (0x85, struct.pack("<IBBBBIf", 17, 0, 1, 2, 1, 16, 0.0005) + POINT + UNIT
              + struct.pack("<2f", 0.0, 1.0)),
    "stick_used": (0x86, struct.pack("<IB", 17, 1) + SAMPLE),
    "step_report": (0x87, struct.pack("<IBBBBBB10I3H", 17, 7, 1, 1, 5, 3, 4, *range(10), 0xFFEE, 2, 3)),
    "refused": (0x88, struct.pack("<BBII", 2, 0x02, 9, 17)),
}


def cobs(data):
    """Each stretch up to a zero, the one put at the end included, as its length and its bytes."""
    return b"".join(bytes([len(part) + 1]) + part for part in data.split(b"\x00"))


def wire(kind, number, payload, version=VERSION, spoil=0):
    inside = struct.pack("<BBH", version, kind, number) + payload
    return b"\x00" + cobs(inside + struct.pack("<I", zlib.crc32(inside) ^ spoil)) + b"\x00"


def record(kind, number, payload):
    return struct.pack("<BHB", kind, number, len(payload)) + payload


def seeds():
    files = {name: RAW + wire(kind, 5, payload) for name, (kind, payload) in MESSAGES.items()}
    hello, step = MESSAGES["hello"], MESSAGES["step_both"]
    frame = wire(*(step[0], 6, step[1]))
    files["session"] = RAW + b"".join(
        wire(kind, i, payload) for i, (kind, payload) in enumerate(MESSAGES.values()))
    files["records"] = WRAPPED + b"".join(
        record(kind, i, payload) for i, (kind, payload) in enumerate(MESSAGES.values()))
    files["number_repeated_old_ahead"] = WRAPPED + b"".join(
        record(*(step[0], number, step[1])) for number in (9, 9, 8, 0x8009, 11, 0x800A, 0xFFFF))
    files["number_wraps"] = WRAPPED + record(*(step[0], 0xFFFF, step[1])) + record(
        *(step[0], 0, step[1]))
    files["session_again_and_another"] = WRAPPED + b"".join(
        record(hello[0], number, struct.pack("<IB", session, 1))
        for number, session in ((3, 1), (2, 1), (4, 1), (0, 2)))
    files["bad_check_sum"] = RAW + wire(step[0], 6, step[1], spoil=1) + frame
    files["bad_version"] = RAW + wire(step[0], 6, step[1], version=VERSION - 1) + frame
    files["bad_type"] = WRAPPED + record(0x7F, 1, b"") + record(0xFF, 2, b"\x00")
    files["bad_payload_nan"] = WRAPPED + record(
        0x84, 1, struct.pack("<IBffB", 17, 1, float("nan"), 0.25, 3))
    files["bad_stuffing"] = RAW + b"\x00\xff\x01\x02\x00" + frame
    files["too_long"] = RAW + b"\x00" + b"\x02\x01" * 100 + b"\x00" + frame
    files["too_short"] = RAW + b"\x00\x01\x00\x02\x05\x00" + frame
    files["torn"] = RAW + frame[:20] + frame[:-1] + frame[1:] + frame
    return files


def main(arguments):
    if not arguments or arguments[-1].startswith("-"):
        print(__doc__)
        return 0 if "--help" in arguments else 2
    folder = pathlib.Path(arguments[-1])
    wanted = seeds()
    if "--compare" not in arguments:
        folder.mkdir(parents=True, exist_ok=True)
        for name, data in wanted.items():
            (folder / name).write_bytes(data)
        return 0
    found = {path.name: path.read_bytes() for path in folder.iterdir()}
    differing = [name for name, data in wanted.items() if found.get(name) != data]
    for name in differing:
        print(f"{name}: is not what this script writes", file=sys.stderr)
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
