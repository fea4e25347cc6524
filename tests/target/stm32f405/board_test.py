#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Boots an image for the board in QEMU and talks to it over its first serial line.
usage: board_test.py MACHINE IMAGE Alone|Opponent|Session|Noise|Restarts"""

import os
import pathlib
import select
import struct
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "hil"))
import frames  # noqa: E402 (of the tests with the host's program)
import keeper  # noqa: E402

PATIENCE = 2.0  # s of the emulator's processor time, which a busy machine does not spend; 25 s of an idle board
VERSION = 3
ALONE_STEPS = 300
HELLO, STEP = 0x01, 0x02
WELCOME, POSE, EVENT, FORCE, TOUCH, STICK_USED, STEP_REPORT, REFUSED = range(0x81, 0x89)
PACED = 0
REPORT = struct.Struct("<IBBBBBB9II")  # as it begins: step; frames, bout state, touches, flags, score; counts
OVERRUNS, SKIPPED = 7, 8  # in REPORT
# Time by instructions, 8 ns each: 125,000 a tick; a processor that sleeps takes no time. By the host's clock a busy
# host would be the one that leaves ticks out.
BY_INSTRUCTIONS = ["-icount", "shift=3,sleep=off"]


def encode(kind, sequence, payload):
    body = struct.pack("<BBH", VERSION, kind, sequence & 0xFFFF) + payload
    return b"\0" + frames.stuff(frames.signed(body)) + b"\0"


def decode(stretch):
    """(type, payload) of what stood between two zeros, or None."""
    raw = frames.unstuff(stretch)
    if len(raw) < frames.HEADER + 4 or frames.signed(raw[:-4]) != raw or raw[0] != VERSION:
        return None
    return raw[1], raw[frames.HEADER:-4]


def split(data):
    """The frames in data, None for each stretch that is none, and the rest without its end."""
    *stretches, rest = data.split(b"\0")
    return [decode(stretch) for stretch in stretches if stretch], rest


class Board:
    """QEMU with the board's serial line as a pipe each way."""

    def __init__(self, machine, image, options=()):
        command = ["qemu-system-arm", "-machine", machine, "-display", "none", "-monitor", "none",
                   "-serial", "stdio", "-kernel", image, *options]
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0)
        self.sequence = 0
        self.pending = b""

    def patience(self):
        """Goes on until the emulator has ended, or has spent PATIENCE."""
        begun = keeper.seconds_of(self.process)
        while keeper.seconds_of(self.process) - begun < PATIENCE:
            if self.process.poll() is not None:
                fail(f"the emulator has ended, with status {self.process.returncode}")
            yield

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()

    def receive(self, seconds):
        """What comes within the time, or b"" where nothing does."""
        ready, _, _ = select.select([self.process.stdout], [], [], seconds)
        return os.read(self.process.stdout.fileno(), 65536) if ready else b""

    def send_bytes(self, data):
        self.process.stdin.write(data)

    def send(self, kind, payload):
        self.send_bytes(encode(kind, self.sequence, payload))
        self.sequence += 1

    def frames(self):
        """Frames as they come (None: a damaged one), until PATIENCE is over."""
        for _ in self.patience():
            found, self.pending = split(self.pending + self.receive(0.1))
            yield from found

    def ask(self, kind, payload, answer):
        """The payload of the first answer of that type; asks again where none comes."""
        for _ in self.patience():
            self.send(kind, payload)
            until = time.monotonic() + 1.0
            while time.monotonic() < until:
                found, self.pending = split(self.pending + self.receive(0.1))
                for frame in found:
                    if frame and frame[0] == answer:
                        return frame[1]
        return fail(f"no answer of type {answer:#x}")


def fail(text):
    sys.exit(f"board_test: {text}")


def expect(condition, text):
    if not condition:
        fail(text)


def hello(session, mode):
    return struct.pack("<IBB", session, mode, 1)


def step_number(payload):
    return struct.unpack("<I", payload[:4])[0]


def test_alone(board):
    """Without a host the board fences by itself: whole frames, step after step, a tick and a millisecond each."""
    fence_alone(board)


def fence_alone(board):
    """@returns the samples that it told"""
    reports, used = [], []
    for number, frame in enumerate(board.frames()):
        expect(frame is not None, f"frame {number} is damaged")
        if frame[0] == STICK_USED:
            used.append(frame[1])
        if frame[0] == STEP_REPORT:
            reports.append(REPORT.unpack_from(frame[1]))
        if len(reports) == ALONE_STEPS:
            break
    expect(len(reports) == ALONE_STEPS, f"{len(reports)} steps in {PATIENCE} s of the emulator's")
    steps = [report[0] for report in reports]
    expect(steps == list(range(steps[0], steps[0] + ALONE_STEPS)), "a step is missing")
    last = reports[-1]
    expect(last[SKIPPED] == 0, f"{last[SKIPPED]} ticks went by unused")
    expect(last[OVERRUNS] == 0, f"{last[OVERRUNS]} steps took longer than a tick")
    return used


def test_opponent(board):
    """The same with an opponent on the right side: it plays every step, within its tick, and its stick moves."""
    used = fence_alone(board)
    steps = [step_number(payload) for payload in used if payload[4] == 1]
    expect(len(steps) >= ALONE_STEPS and steps == list(range(steps[0], steps[0] + len(steps))), "it missed a step")
    expect(len({payload[9:25] for payload in used}) > 1, "its stick stands still")


def check_welcome(board, session):
    welcome = board.ask(HELLO, hello(session, PACED), WELCOME)
    got, version, mode, step_us, fault = struct.unpack("<IBBII", welcome[:14])
    expect((got, version, mode) == (session, VERSION, PACED), f"welcome {welcome.hex()}")
    expect(step_us == 1000, f"a step of {step_us} us")
    expect(fault == 0, f"fault {fault}")


def paced_steps(board, first, last):
    """Poses and forces of both sides for each step."""
    told = []
    for step in range(first, last + 1):
        board.send(STEP, struct.pack("<IB", step, 0))
        for frame in board.frames():
            if frame is None or step_number(frame[1]) != step:
                continue
            told.append((frame[0], frame[1]))
            if frame[0] == STEP_REPORT:
                break
        else:
            fail(f"step {step} is not answered")
    return told


def count_of(told, kind):
    return sum(1 for got, _ in told if got == kind)


def test_session(board):
    """The host's pace: every Step is answered; the same bout again gives the same bits."""
    check_welcome(board, 4711)
    first = paced_steps(board, 1, 200)
    for kind in (POSE, FORCE):
        expect(count_of(first, kind) == 400, f"{count_of(first, kind)} of type {kind:#x}")
    check_welcome(board, 4712)
    again = paced_steps(board, 1, 200)
    poses = [[payload for kind, payload in told if kind == POSE] for told in (first, again)]
    expect(poses[0] == poses[1], "the same bout gave other poses")


def test_noise(board):
    """Noise on the line costs frames, never the session."""
    noise = bytes((i * 73 + i * i * 5) & 0xFF for i in range(4000))
    board.send_bytes(noise)
    check_welcome(board, 99)
    board.send_bytes(noise[:500])
    board.send_bytes(b"\0")
    told = paced_steps(board, 1, 20)
    expect(count_of(told, STEP_REPORT) == 20, "a step got lost in noise")


def test_restarts(board):
    """A program that always fails starts four times, tells the assert (4) three times, and is parked."""
    text = b""
    for _ in board.patience():
        if text.count(b"\n") >= 4:
            break
        text += board.receive(0.1)
    quiet = time.monotonic() + 1.0
    while time.monotonic() < quiet:
        text += board.receive(0.1)
    expect(text == b"start 0\n" + 3 * b"start 4\n", f"the board said {text!r}")
    expect(board.process.poll() is None, "the emulator has ended")


TESTS = {"Alone": test_alone, "Opponent": test_opponent, "Session": test_session, "Noise": test_noise, "Restarts": test_restarts}


def main(words):
    if len(words) != 3 or words[2] not in TESTS:
        fail(__doc__)
    options = BY_INSTRUCTIONS if words[2] in ("Alone", "Opponent") else []
    with Board(words[0], words[1], options) as board:
        TESTS[words[2]](board)


if __name__ == "__main__":
    main(sys.argv[1:])
