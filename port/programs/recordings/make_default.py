#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes default.events, the recording that batuta-duel plays when it is told nothing else.

The motion is made up, not recorded: an attacker on a two-axis stick who beats, feints, parries and lunges, with a hand's
tremor and a stick's noise of a few counts. Deterministic: the same file from every run on every machine.

    python3 make_default.py > default.events
    python3 make_default.py --compare default.events    fails if the file is not what would be written
"""

import sys

PERIOD_US = 4000  # a stick that reports 250 times a second
RANGE = 32767
FLAT = 128

# Seconds, x, y: to the stick position (x right, y up, -1 ... 1) within so long, starting and ending at rest.
MOVES = [
    (0.60, 0.00, -0.04),  # on guard
    (0.50, 0.04, 0.00),
    (0.70, 0.00, 0.00),
    (0.30, 0.05, 0.03),
    (0.14, 0.00, 0.50),   # beats
    (0.20, -0.05, 0.05),
    (0.50, 0.03, 0.02),
    (0.15, 0.00, 0.52),   # beats again
    (0.22, 0.02, 0.00),
    (0.40, -0.03, 0.04),
    (0.22, -0.45, 0.45),  # feint inside, cut over, feint outside
    (0.20, 0.45, 0.40),
    (0.35, 0.00, 0.05),
    (0.45, 0.02, 0.00),
    (0.13, -0.85, 0.00),  # quarte, twice
    (0.12, -0.15, 0.00),
    (0.13, -0.85, 0.00),
    (0.30, 0.00, 0.04),
    (0.60, -0.03, 0.00),  # breathes
    (0.50, 0.02, 0.02),
    (0.25, 0.40, 0.50),   # feint outside
    (0.30, 0.05, 0.00),
    (0.50, 0.00, -0.02),
    (0.30, 0.03, 0.00),
    (0.12, 0.85, 0.00),   # sixte
    (0.25, 0.00, 0.05),
    (0.60, 0.04, 0.00),
    (0.40, -0.02, 0.00),
    (0.20, 0.35, 0.30),   # feint outside
    (0.16, -0.20, 0.15),  # disengages
    (0.26, -0.97, 1.00),  # lunge, high inside
    (0.50, -0.97, 1.00),
    (0.50, 0.00, 0.00),
]

HEADER = """\
# EVEMU 1.3
# Synthetic recording, made for batuta by make_default.py beside it; no device and no person was recorded.
# Two absolute axes, 250 reports a second: beats, feints, parries and a lunge at the end.
N: batuta synthetic stick
I: 0003 0000 0000 0001
P: 00 00 00 00 00 00 00 00
B: 00 0b 00 00 00 00 00 00 00
B: 01 00 00 00 00 00 00 00 00
B: 02 00 00 00 00 00 00 00 00
B: 03 03 00 00 00 00 00 00 00
A: 00 {low} {high} 16 {flat} 0
A: 01 {low} {high} 16 {flat} 0
"""


class Noise:
    """A linear congruential generator: the same numbers everywhere."""

    def __init__(self):
        self.state = 20120101

    def counts(self, size):
        self.state = (1103515245 * self.state + 12345) % 2**31
        return (self.state >> 16) % (2 * size + 1) - size


def eased(share):
    return share**3 * (10 - 15 * share + 6 * share**2)


def path(moves):
    """The stick's position, sample by sample."""
    x, y = 0.0, 0.0
    for seconds, to_x, to_y in moves:
        steps = round(seconds * 1e6 / PERIOD_US)
        for step in range(1, steps + 1):
            share = eased(step / steps)
            yield x + (to_x - x) * share, y + (to_y - y) * share
        x, y = to_x, to_y


def recording():
    """The whole file, line by line."""
    yield from HEADER.format(low=-RANGE - 1, high=RANGE, flat=FLAT).splitlines()
    noise = Noise()
    last = [None, None]
    for sample, position in enumerate(path(MOVES)):
        time = "%d.%06d" % divmod((sample + 1) * PERIOD_US, 1000000)
        changed = False
        for axis, share in enumerate((position[0], -position[1])):  # down is positive in the input stack
            counts = max(-RANGE - 1, min(RANGE, round(share * RANGE) + noise.counts(24)))
            if counts != last[axis]:
                yield "E: %s 0003 %04x %04d" % (time, axis, counts)
                last[axis] = counts
                changed = True
        if changed:
            yield "E: %s 0000 0000 0000" % time


def main():
    text = "\n".join(recording()) + "\n"
    if len(sys.argv) == 3 and sys.argv[1] == "--compare":
        with open(sys.argv[2], encoding="ascii") as file:
            if file.read() != text:
                sys.exit(sys.argv[2] + " is not what " + sys.argv[0] + " writes")
        return
    sys.stdout.write(text)


main()
