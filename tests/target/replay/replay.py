#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""batuta-duel records a bout on this machine; a part in the emulator replays it, with the same hash after every step.
Then the recording is changed where only a hash can tell, and the part has to notice.

usage: replay.py --duel PROGRAM -- EMULATOR... PROGRAM
Exit status 77: the host's program is not there.
"""
import argparse
import os
import re
import struct
import subprocess
import sys
import tempfile
import zlib

SKIP = 77
LEAST_STEPS = 100
RECORD_HEAD = 3
CHECK_SUM = 4
SNAPSHOT_HEAD = 20


def record(duel, path):
    words = [duel, "--left", "script:attack", "--right", "script:parry", "--touches", "2", "--record", path]
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL)


def replay(program, path):
    """What the part answers: its exit status, and steps and hashes in words."""
    run = subprocess.run([*program, path], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                         check=False)
    found = re.search(r"answer (\d+) steps (\d+) hashes (\d+)", run.stdout)
    if found is None:
        sys.exit(f"no answer: status {run.returncode}, {run.stdout!r}")
    return run.returncode, int(found[2]), int(found[3])


def with_other_bit(recording):
    """One bit of a stick's position is another, under a good check sum."""
    bytes_ = bytearray(recording)
    at = SNAPSHOT_HEAD + struct.unpack_from("<I", bytes_, 16)[0] + CHECK_SUM
    while at < len(bytes_):
        size = struct.unpack_from("<H", bytes_, at + 1)[0]
        body = at + RECORD_HEAD
        if bytes_[at] == ord("S") and size > 6:
            bytes_[body + 6 + 4] ^= 1  # behind step, whose, and time: the last bit of x
            check = zlib.crc32(bytes_[at:body + size])
            struct.pack_into("<I", bytes_, body + size, check)
            return bytes_, struct.unpack_from("<I", bytes_, body)[0]
        at = body + size + CHECK_SUM
    sys.exit("the recording has no sample")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--duel", required=True)
    parser.add_argument("program", nargs="+")
    options = parser.parse_args()
    if not os.path.exists(options.duel):
        print(f"skipped: there is no {options.duel}; build the host's tree first")
        return SKIP
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "bout.batuta")
        record(options.duel, path)
        status, steps, hashes = replay(options.program, path)
        print(f"{os.path.getsize(path)} bytes, {steps} steps, {hashes} hashes agreed")
        if status != 0 or steps < LEAST_STEPS or hashes != steps + 1:
            return 1
        with open(path, "rb") as file:
            spoilt, step = with_other_bit(file.read())
        with open(path, "wb") as file:
            file.write(spoilt)
        status, steps, _ = replay(options.program, path)
        print(f"with another bit in step {step}: parted in step {steps - 1}")
        return 0 if status == 1 and steps == step + 1 else 1


if __name__ == "__main__":
    sys.exit(main())
