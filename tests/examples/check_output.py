#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs a program of examples/ and checks what it prints against mechanics, geometry or its own other half, never
against an earlier output. Usage: check_output.py NAME PROGRAM; exit code 1: it failed, or prints what cannot
be right."""

import math
import re
import subprocess
import sys

NUMBER = r"-?\d+(?:\.\d+)?"


class Wrong(Exception):
    """What a program prints is not right."""


def need(holds, what):
    if not holds:
        raise Wrong(what)


def near(value, truth, tolerance, what):
    need(abs(value - truth) <= tolerance, f"{what}: {value}, not {truth} within {tolerance}")


def lines_like(text, pattern):
    """The numbers of each place that is like the pattern: @ is a number, the rest is taken as it is."""
    found = re.finditer(re.escape(pattern).replace("@", f"({NUMBER})"), text)
    return [[float(number) for number in place.groups()] for place in found]


def numbers(text, pattern):
    """Those of the only such place."""
    found = lines_like(text, pattern)
    need(len(found) == 1, f"'{pattern}' is there {len(found)} times, not once")
    return found[0]


def two_blades(text):
    """The blades have 0.19 m between them at 4 m/s; a blow keeps momentum and takes energy; C is 0.6."""
    totals = "{}: momentum @ @ @, about the origin @ @ @, energy @ J"
    before, after = numbers(text, totals.format("before")), numbers(text, totals.format("after"))
    for i in range(6):
        near(after[i], before[i], 2e-5, "momentum")
    steel = 7850 * math.pi * 0.005 ** 2 * (0.9 + 4 / 3 * 0.005)  # kg
    near(before[0], 4 * steel, 1e-5, "momentum of the first blade")
    near(before[6], 8 * steel, 1e-4, "energy of the first blade")
    time, approach, parting, impulse, share = numbers(
        text, "beat at @ ms: approach @ m/s, parting @ m/s, @ N s, @ % up")
    near(time, 0.19 / 4 * 1000, 0.01, "time of the beat")
    near(approach, 4, 1e-3, "approach")
    near(parting, 0.6 * approach, 2e-3, "restitution")
    # The height of the contact is not unique, the axes are parallel; what the impulse does to the energy is.
    near(after[6] - before[6], -impulse * (approach - parting) / 2, 2e-3, "energy lost in the blow")
    need(0.3 / 0.9 * 100 <= share <= 100, "the blades lie beside each other from a third of the first one on")


def distance(p, q):
    """Of two segments, by golden section along the one and projection onto the other; the distance is convex."""
    def onto(x, segment):
        a, b = segment
        ab = [v - u for u, v in zip(a, b)]
        t = sum((w - u) * d for u, w, d in zip(a, x, ab)) / sum(d * d for d in ab)
        t = min(1.0, max(0.0, t))
        return math.dist(x, [u + t * d for u, d in zip(a, ab)])

    def at(t):
        return onto([u + t * (v - u) for u, v in zip(*p)], q)

    low, high, ratio = 0.0, 1.0, (math.sqrt(5) - 1) / 2
    for _ in range(60):
        inner, outer = high - ratio * (high - low), low + ratio * (high - low)
        low, high = (low, outer) if at(inner) < at(outer) else (inner, high)
    return min(at(low), at(0.0), at(1.0))


def is_balanced(rod, logs):
    """Whether a rod of 0.3 m lies across one log along y, its middle on it but for the lever of its rolling resistance, 1 mm, and D."""
    if len(logs) != 1:
        return False
    (ax, _, az), (bx, _, bz) = rod
    (cx, _, cz), _ = logs[0]
    on_log = ((cx - ax) * (bx - ax) + (cz - az) * (bz - az)) / ((bx - ax) ** 2 + (bz - az) ** 2)
    return abs(on_log - 0.5) * 0.3 < 1.2e-3


def heap(text):
    """All sleep; none is in a log or in another one; each keeps its length, and lies on two things or across one."""
    rods = lines_like(text, "from (@ @ @) to (@ @ @), asleep")
    asleep, of, seconds = numbers(text, "@ of @ rods are asleep after @ s")
    need(len(rods) == asleep == of >= 10, f"{len(rods)} rods sleep")
    need(0.25 < seconds < 20, "they sleep after 250 still steps, and not before")
    rods = [(rod[:3], rod[3:]) for rod in rods]
    logs = [((x, -4.0, z), (x, 4.0, z)) for x, z in ((-1.3, 0.1), (-0.5, -0.5), (0.5, -0.5), (1.3, 0.1))]
    for i, rod in enumerate(rods):
        near(math.dist(*rod), 0.3, 2e-4, f"length of rod {i + 1}")
        gaps = [distance(rod, log) - 0.53 for log in logs]
        gaps += [distance(rod, other) - 0.06 for j, other in enumerate(rods) if j != i]
        need(min(gaps) > -2e-3, f"rod {i + 1} is {-min(gaps)} m deep in something")
        under = sum(gap < 2e-3 for gap in gaps)
        need(under >= 2 or is_balanced(rod, [log for log, gap in zip(logs, gaps) if gap < 2e-3]), f"rod {i + 1} lies on {under} things")
    need(max(max(a[2], b[2]) for a, b in rods) < 1, "they have fallen: the highest began at 2.4 m")


def own_controller(text):
    """The bat, r = 0.02 m thick, meets the ball of 0.05 m at 0.6 m where sin = 0.07 / 0.6; C is 0.5."""
    time, *velocity = numbers(text, "strikes the ball at @ s\nthe ball flies at (@ @ @) m/s")
    ahead = math.asin(0.07 / 0.6)
    near(time, (math.pi / 2 - ahead) / 3, 2e-4, "time of the blow")
    angle = 3 * time  # of the bat, which pushes across itself at the speed of its point 0.6 cos(ahead) from the hinge
    speed = 1.5 * 3 * 0.6 * math.cos(ahead)
    for got, truth in zip(velocity, (-speed * math.sin(angle), speed * math.cos(angle), 0)):
        near(got, truth, 5e-3, "velocity of the ball")
    blows, place = numbers(text, "after 1 s and @ blow the bat is at @ rad")
    need(blows == 1, "one blow")
    near(place, 3, 1e-3, "angle of the bat")


def detection_only(text):
    """The axes cross 0.5 m apart, the radii are 0.1 and 0.15 m; the rod meets the ball where sin = 0.07 / 0.8."""
    gap, *points = numbers(text, "gap @ m, from (@ @ @) to (@ @ @)")
    near(gap, 0.25, 1e-6, "gap")
    for got, truth in zip(points, (0.25, 0, 0.1, 0.25, 0, 0.35)):
        near(got, truth, 1e-6, "closest points")
    contact = (math.pi / 2 - math.asin(0.07 / 0.8)) / 2
    need(0.5 < contact, "nothing meets in the first half second")
    near(numbers(text, "free for all of @ s")[0], 0.5, 0, "time without contact")
    free, hit, _ = numbers(text, "contact: free up to @ s, hit at @ s, @ evaluations")
    need(free <= contact + 1e-6, "what is called free is free")  # of six printed digits
    near(free, contact, 1e-4, "time that is called free")
    near(hit, contact, 2e-6, "time of contact")
    unknown, used = numbers(text, "unknown after @ s, for @ evaluations were not enough")
    need(used == 2 and 0 < unknown <= contact, "with too small a budget it stops before the contact")


def force_feedback(text):
    """Against the post, where the ball stops at 0.1 m (half a unit), the arm's spring of 5 and the post's of
    0.2^2 200 N m for each unit hold each other; without force the arm has its will, 0.8."""
    lines = lines_like(text, "stick at @, ball at @ m, force @ N m for each unit")
    need(len(lines) == 4, "four lines")
    (free, carried, none), (pressing, stopped, force), (_, _, at_once), (at_will, held, off) = lines
    near(carried, 0.2 * free, 5e-4, "before the post the ball goes where the stick is, one sample late")
    near(none, 0, 0.02, "force before the post")
    near(stopped, 0.1, 3e-4, "place of the ball at the post")
    near(pressing, (8 * 0.5 + 5 * 0.8) / 13, 2e-3, "stick between arm and post")
    near(force, -5 * (0.8 - pressing), 5e-3, "force that holds the arm")
    need(at_once == 0 and off == 0, "no force from the emergency stop on")
    near(at_will, 0.8, 1e-3, "stick after the emergency stop")
    near(held, 0.1, 3e-4, "the ball stays out of the post")


def record_and_replay(text):
    """Both halves of the output tell of the same run."""
    first = re.findall(r"^recorded (\d+) steps with (\d+) blows in (\d+) bytes, hash ([0-9a-f]{16})$", text, re.M)
    second = re.findall(r"^replayed (\d+) steps, (\d+) hashes agreed, hash ([0-9a-f]{16})$", text, re.M)
    need(len(first) == 1 and len(second) == 1, "two lines")
    steps, blows, size, recorded = first[0]
    again, agreed, replayed = second[0]
    need(steps == again == "500", f"{steps} steps recorded, {again} replayed, of 500")
    need(recorded == replayed and int(recorded, 16) != 0, "the same bits")
    need(int(agreed) == 500 // 100 + 1, "a hash each 100 steps, and at the end")
    need(int(blows) >= 2, "there is something to replay")
    need(int(size) >= 500 * (3 + 4 + 12 + 4), "each step takes its head, number, force and check sum")


CHECKS = {check.__name__: check for check in (two_blades, heap, own_controller, detection_only, force_feedback,
                                              record_and_replay)}


def main():
    name, program = sys.argv[1:]
    done = subprocess.run([program], stdout=subprocess.PIPE, text=True, check=False)
    print(done.stdout)
    try:
        need(done.returncode == 0, f"it ended with {done.returncode}")
        CHECKS[name](done.stdout)
    except Wrong as wrong:
        print(f"{name}: {wrong}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
