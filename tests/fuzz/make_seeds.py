#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the seeds of the fuzzers that draw numbers: cases that are known to be hard, in the bytes
that bytes.hpp reads. Findings (found_*) are kept beside them and are not made here.

usage: make_seeds.py [--compare] FOLDER    --compare: exit 1 unless FOLDER/<fuzzer> holds these
"""
import hashlib
import math
import pathlib
import struct
import sys

GRID = b"\x00"  # numbers: multiples of 1/4096 in [-8, 8)
ANY = b"\x03"  # numbers: 32 bits
STEP = 4096
HOSTILE = 17  # numbers of tests/support/hostile_numbers.hpp


def number(x):
    return struct.pack("<h", max(-32768, min(32767, round(x * STEP))))


def vector(v):
    return b"".join(number(x) for x in v)


def share(x):
    return bytes([round(x * 255)])


def hostile(index):
    """As Bytes::bits() reads it: not a number, with the index as its payload."""
    return struct.pack("<I", 0x7FC00000 + index)


def with_hostile(numbers, index):
    """Ordinary numbers in 32 bits, but one of them hostile; which one, differs from index to index."""
    packed = [struct.pack("<f", x) for x in numbers]
    packed[5 * index % len(packed)] = hostile(index)
    return packed


def segment(a, b):
    return vector(a) + b"\x02" + vector(b)


def turn(w=1, x=0, y=0, z=0):
    """A quaternion of small integers; the reader adds one to w."""
    return struct.pack("<4b", w - 1, x, y, z)


ORIGIN = (0, 0, 0)
X, Y, Z = (1, 0, 0), (0, 1, 0), (0, 0, 1)


def both_ways(v, by=1):
    return tuple(-by * x for x in v), tuple(by * x for x in v)


def distance(A, B, r_A=0.1, r_B=0.1):
    return GRID + segment(*A) + segment(*B) + number(r_A) + number(r_B) + share(0.5)


def distance_seeds():
    """Segments that divide by zero, tie, or lose all digits (crossing, parallel, collinear)."""
    files = {
        "both_points_at_one_place": distance((ORIGIN, ORIGIN), (ORIGIN, ORIGIN)),
        "point_and_segment": distance((Y, Y), both_ways(X)),
        "point_on_segment": distance((ORIGIN, ORIGIN), both_ways(X)),
        "the_same_twice": distance(both_ways(X), both_ways(X)),
        "side_by_side": distance(both_ways(X), ((-1, 1, 0), (1, 1, 0))),
        "side_by_side_by_half": distance(both_ways(X), ((0, 1, 0), (2, 1, 0))),
        "end_to_end": distance(((0, 0, 0), X), (X, (2, 0, 0))),
        "in_line_apart": distance(((0, 0, 0), X), ((2, 0, 0), (3, 0, 0))),
        "one_in_the_other": distance(((0, 0, 0), (4, 0, 0)), (X, (2, 0, 0))),
        "crossing": distance(both_ways(X), both_ways(Y)),
        "crossing_at_an_end": distance(both_ways(X), (X, (1, 1, 0))),
        "unequal_lengths": distance(((0, 0, 0), (7, 7, 7)), (X, (1 + 1 / STEP, 0, 0))),
        "no_radius_touching": distance(both_ways(X), both_ways(Y), 0, 0),
    }
    for k in range(1, 4):
        angle = 10.0 ** -k
        other = (4 * math.cos(angle), 4 * math.sin(angle), 0)
        files[f"crossing_by_1e-{k}"] = distance(both_ways(X, 4), both_ways(other))
        lifted = tuple(tuple(p[i] + (0, 0, 0.001)[i] for i in range(3)) for p in both_ways(other))
        files[f"skew_by_1e-{k}"] = distance(both_ways(X, 4), lifted)
    for index in range(HOSTILE):
        n = with_hostile((-1, 0, 0, 1, 0, 0, 0, -1, 0.5, 0, 1, 0.5, 0.1, 0.1), index)
        ends = [b"".join(n[k:k + 3]) for k in (0, 3, 6, 9)]
        files[f"hostile_{index}"] = (ANY + ends[0] + b"\x02" + ends[1] + ends[2] + b"\x02" + ends[3] + n[12] + n[13]
                                     + share(0.5))
    return files


def moving(ends, r, place=ORIGIN, v=ORIGIN, w=None):
    head = segment(*ends) + number(r) + vector(place) + turn() + vector(v)
    return head if w is None else head + vector(w)


def query(A, B, turns):
    """Both as moving() takes them; A, and B if it has one, with an angular velocity."""
    end = b"\x00" + b"\x3f" + b"\x00" + b"\x00"  # 1 s, 64 evaluations, default contact tolerance, no seed
    flags = bytes([turns]) + moving(*A) + (bytes([len(B) == 5]) if turns else b"")
    return GRID + flags + moving(*B) + end


def search_seeds():
    """Courses that meet late, briefly, twice, at a graze, at a constant distance, or not at all."""
    bar, upright = both_ways(X), both_ways(Z)
    dip = (-math.sin(math.radians(20)), 0, -math.cos(math.radians(20)))
    return {
        "head_on": query((both_ways(Y), 0.1), (both_ways(Y), 0.1, (3, 0, 0), (-4, 0, 0)), False),
        "head_on_crossed": query((both_ways(Y), 0.1), (upright, 0.1, (3, 0, 0), (-4, 0, 0)), False),
        "in_line": query((bar, 0.1), (bar, 0.1, (5, 0, 0), (-4, 0, 0)), False),
        "graze": query((upright, 0.1), ((ORIGIN, ORIGIN), 0.1, (-2, 0.2, 0), (4, 0, 0)), False),
        "in_step": query((upright, 0.1, ORIGIN, X), (upright, 0.1, (0.21, 0, 0), X), False),
        "no_radius": query((bar, 0), (both_ways(Y), 0, (0, 0, 2), (0, 0, -4)), False),
        "touching": query((bar, 0.5), (bar, 0.5, (0, 1, 0), ORIGIN), False),
        "half_turn": query((bar, 0.05, ORIGIN, ORIGIN, (0, 0, math.pi)),
                           (upright, 0.05, (0, 0.8, 0)), True),
        "just_beyond_the_tip": query((bar, 0.05, ORIGIN, ORIGIN, (0, 0, math.pi)),
                                     (upright, 0.05, (0, 1.1003, 0)), True),
        "flipper": query(((ORIGIN, X), 0.03, ORIGIN, ORIGIN, (0, 0, -2)),
                         ((ORIGIN, ORIGIN), 0.1, (0.6, -0.7, 0)), True),
        "parry": query((((-0.3, 0, 0), (0.7, 0, 0)), 0.01, ORIGIN, (0.2, 0, 0), (0, 0, 1.8)),
                       (((-0.6, 0, 0), (0.4, 0, 0)), 0.01, (0.5, 0.6, 0.015), (-0.1, -0.5, 0),
                        (0, 0, -1)), True),
        "scissors": query((bar, 0.05, ORIGIN, ORIGIN, (0, 0, math.pi)),
                          (((0.9, -0.3, 0), (-0.9, 0.3, 0)), 0.05, (0, 0, 0.102), ORIGIN,
                           (0, 0, -2.2)), True),
        "along_each_other_close": query((upright, 0.9),
                                        (((1.002, 0, -1), (1.002, 0, 1)), 0.1, ORIGIN, ORIGIN,
                                         (0, 0, math.pi)), True),
        "dip": query((both_ways(X, 2), 0.05, ORIGIN, ORIGIN, ORIGIN),
                     ((tuple(0.5 * x for x in dip), dip), 0.05, (0, 0, 1.05), ORIGIN,
                      (0, math.radians(-40), 0)), True),
        "generic": query((((-0.8, 0.3, 0.1), (0.5, -0.2, -0.1)), 0.07, ORIGIN, (0.3, -0.1, 0.2),
                          (2.1, -1.3, 0.7)),
                         (((-0.2, 0.6, 0.5), (0.3, -0.7, -0.4)), 0.05, (0.85, 0.6, -0.3),
                          (-1.1, -0.8, 0.6), (-1.7, 0.4, 2.3)), True),
        "own_axis": query((both_ways(Y), 0.1, ORIGIN, ORIGIN, ORIGIN),
                          (both_ways(Y), 0.1, (0.21, 0, 0), ORIGIN, (0, 7, 0)), True),
    }


def collider(place=ORIGIN, v=ORIGIN, w=ORIGIN, mass=1.0, moments=(1, 1, 1)):
    """Inverse mass and inverse moments."""
    return vector(place) + turn() + vector(v) + vector(w) + number(mass) + b"\x02" + vector(moments)


def blow(kind, A, B, point, normal, C, mu, e_t=0.0):
    return (GRID + bytes([kind]) + A + B + vector(point) + vector(normal) + share(C) + number(mu)
            + share((1 + e_t) / 2))


def impulse_seeds():
    """Blows whose answer is known, and those that divide by what may vanish."""
    left, right = collider((-1, 0, 0), X), collider((1, 0, 0), (-1, 0, 0))
    fixed = collider((1, 0, 0), mass=0, moments=ORIGIN)
    back, rod = (-1, 0, 0), collider((0, 0, 1), (0, 0, -1), X, 1, (4, 4, 0.01))
    files = {}
    for kind, name in ((1, "smooth"), (2, "rough")):
        files[f"{name}_head_on"] = blow(kind, left, right, ORIGIN, back, 1, 0.5)
        files[f"{name}_without_rebound"] = blow(kind, left, right, ORIGIN, back, 0, 0.5)
        files[f"{name}_on_a_wall"] = blow(kind, left, fixed, ORIGIN, back, 0.5, 0.5)
        files[f"{name}_both_fixed"] = blow(kind, fixed, fixed, ORIGIN, back, 0.5, 0.5)
        files[f"{name}_receding"] = blow(kind, right, left, ORIGIN, back, 0.5, 0.5)
        files[f"{name}_unequal_masses"] = blow(
            kind, collider((-1, 0, 0), X, ORIGIN, 7, (7, 7, 7)),
            collider((1, 0, 0), mass=1 / STEP, moments=(1 / STEP,) * 3), ORIGIN, back, 1, 7)
        files[f"{name}_needle_at_its_tip"] = blow(kind, rod, fixed, (0, 0.5, 0), Z, 0.5, 2)
        files[f"{name}_grazing"] = blow(
            kind, collider((-1, 0, 0), (1 / STEP, 7, 0)), right, ORIGIN, back, 1, 0.01)
    flat = blow(3, collider((0, 0, 1), (0, 0, -1), ORIGIN, 1, (4, 4, 0)), fixed, ORIGIN, Z, 0, 0.5)
    files["line_flat_landing"] = (flat + segment((-1, 0, 1), (1, 0, 1)) + share(0.5)
                                  + segment(*both_ways(X, 4)) + share(0.5) + share(0.01))
    files["separation_of_equals"] = (GRID + b"\x00" + vector(X) + number(-0.1) + number(0.5)
                                     + number(0.1) + number(0.1) + b"\x00\x00" + number(0)
                                     + b"\x00" + number(1) + b"\x00" + number(1))
    return files


def body(half, radius, place, v, fixed=False, w=ORIGIN, second=b""):
    """As draw_actor() takes it, up to what the scene adds; w None: nothing turns."""
    shape = share(half) + share(4 * radius) + second
    matter = b"\x00" + vector(place) + turn() + bytes([10, 0]) + vector(v) + bytes([3 * fixed])
    return shape + matter + (b"" if w is None else bytes([128, 64]) + vector(w))


def world(scene, bodies, features, steps):
    return bytes([scene, len(bodies) - 2]) + b"".join(b + features for b in bodies) + steps


def world_seeds():
    """Rows that hit each other at once, heaps, bodies between two walls."""
    bounces, rubs, owner, met = share(1), share(0.1), b"\x00", b"\x00"
    long, short = bytes([0, 5, 0]) * 8, bytes([0, 5, 5]) * 8  # whom, nothing, 1/2 s or 1/64 s
    fast, still = (7, 0, 0), ORIGIN
    row = [body(0.2, 0.1, (0.25 * i, 0, 0), still if i else fast) for i in range(4)]
    between = [body(1, 0.1, (0.5 * i, 0, 0), fast if i == 1 else still, i != 1) for i in range(3)]
    heap = [body(0.5, 0.1, (0, 0, 0.25 * i), still, i == 0, second=b"\x00") for i in range(3)]
    straight = [body(0.2, 0.1, (0.5 * i, 0, 0), (1 - i, 0, 0), w=None) for i in range(3)]
    pair = [body(0.5, 0.02, ORIGIN, (4, 0, 0), w=Z), body(0.5, 0.02, (0.2, 0, 0.3), still)]
    rods = bounces + rubs + owner + met
    return {
        "rods_in_a_row": world(0, row, rods, long),
        "rods_between_walls": world(0, between, rods, short),
        "rods_that_lose_nothing": world(0, row, bounces + share(0) + owner + met, short),
        "rods_overlapping": world(0, [row[0], row[0]], rods, short),
        "heap": world(1, heap, share(0) + rubs + owner, short),
        "sliders": world(2, straight, bounces + owner, short),
        "blades": world(3, pair, bounces + owner, short),
        "balls": world(4, straight, bounces, short),
    }


def keyframes_seeds():
    """Grids that are flat, bent, and turned nearly too far from key to key."""
    files = {}
    for index, (columns, rows) in enumerate(((2, 2), (3, 3), (5, 4))):
        flat = bent = turned = b""
        for k in range(columns * rows):
            x, y = k % columns, k // columns
            flat += vector((x, y, 0)) + turn()
            bent += vector((x, y, x * y % 3)) + turn(1, x, y, 0)
            turned += vector((0, 0, x)) + turn(5 - 4 * (x % 2), 0, 0, 12 * (x % 2))
        size = f"{columns}x{rows}"
        for name, keys in (("flat", flat), ("bent", bent), ("turned", turned)):
            files[f"{name}_{size}"] = GRID + bytes([index]) + keys + b"\x01" + number(1.5)
    square = [x for place in ((0, 0), (1, 0), (0, 1), (1, 1)) for x in (*place, 0, 0, 0, 0, 1)]
    for index in range(HOSTILE):
        files[f"hostile_{index}"] = ANY + b"\x00" + b"".join(with_hostile(square, index)) + share(0.5) * 2
    return files


TEXT, EVENTS = b"\x01", b"\x00"


def recording_seeds():
    """Devices of three kinds, lines that end otherwise, and what is no recording."""
    mouse = "".join(f"E: 0.{8000 * i:06d} 0002 {i % 2:04x} {i - 5:04d}\nE: 0.{8000 * i:06d} "
                    "0000 0000 0000\n" for i in range(9))
    stick = "N: a stick\nI: 0003 0000 0000 0001\nA: 00 -512 511 0 15 0\nA: 01 -512 511 0 15 0\n"
    moved = "E: 0.000000 0003 0000 0100\nE: 0.000000 0003 0001 -100\nE: 0.000000 0000 0000 0000\n"
    fingers = "".join(f"E: {i}.000000 0003 {code:04x} {i}\n" for i, code in
                      enumerate((0x2F, 0x39, 0x35, 0x36))) + "E: 4.000000 0000 0000 0\n"
    files = {
        "mouse": mouse, "stick": "# EVEMU 1.3\n" + stick + moved, "fingers": fingers,
        "lost": moved + "E: 0.004000 0000 0003 0\n" + moved.replace("0.000", "0.008"),
        "carriage_returns": mouse.replace("\n", "\r\n"), "no_end_of_line": mouse[:-1],
        "leap": moved + "E: 9999.000000 0000 0000 0\n", "backward": moved.replace("0.0", "5.0", 1),
        "half_a_microsecond": "E: 1.5 0003 0000 0000\n", "words": "12abc\n", "nothing": "\n",
        "range_the_wrong_way": stick.replace("-512 511", "511 -512") + moved,
    }
    seeds = {name: TEXT + text.encode() for name, text in files.items()}
    seeds["events_of_all_kinds"] = EVENTS + b"\x01\x00\x00\x00" + bytes(range(1, 200))
    return seeds


def pid_record(what, *parts):
    data = b"".join(parts)
    return bytes([what, len(data)]) + data


def pid_life(kind):
    """An effect of the USB device class for force feedback: made, shaped, started, felt, freed."""
    block, words = b"\x01", struct.pack
    report = pid_record
    made = report(0x80 | 0x21, bytes([kind]), words("<H", 0))
    effect = report(0x11, block, bytes([kind]), words("<HHHH", 500, 0, 0, 10), b"\xff\x00\x07",
                    words("<HH", 9000, 0))
    envelope = report(0x12, block, words("<HHHH", 2000, 1000, 100, 100))
    conditions = b"".join(report(0x13, block, bytes([axis]), words("<hhh", 0, 5000, -5000),
                                 words("<HHH", 9000, 9000, 100)) for axis in (0, 1))
    shape = (report(0x14, block, words("<HhHH", 5000, 100, 9000, 40))
             + report(0x15, block, words("<h", -5000))
             + report(0x16, block, words("<hh", -9, 9000)))
    felt = report(0, words("<I", 4000), words("<6f", 0.5, -0.5, 1, -1, 0, 0)) + report(1)
    ends = report(0x1A, block, b"\x03\x00") + felt + report(0x1B, block) + report(1)
    return (made + effect + envelope + conditions + shape + report(0x1D, b"\x80")
            + report(0x1A, block, b"\x01\x02") + felt * 3 + ends)


def pid_seeds():
    """The life of each kind of effect, devices that are controlled, and a pool that overflows."""
    files = {f"life_of_kind_{kind}": pid_life(kind) for kind in range(1, 12)}
    files["nothing"] = b""
    files["controls"] = pid_life(1)[:-9] + b"".join(
        pid_record(0x1C, bytes([control])) + pid_record(1) for control in range(1, 7))
    files["pool_overflows"] = (pid_record(0x80 | 0x21, b"\x01\x00\x00") + pid_record(1)) * 6
    files["unplugged_while_it_plays"] = pid_life(4)[:-9] + pid_record(2) + pid_record(1)
    files["time_wraps"] = pid_record(0, struct.pack("<I", 0xFFFFFFFF) + bytes(24)) * 3
    files["cut_short"] = b"".join(pid_record(kind, b"\x01") for kind in range(0x11, 0x22))
    return files


CONTROL, PACKET, TIME, BUS, INPUT = range(5)
PLUG, UNPLUG, SUSPEND, RESUME, ENUMERATE = (bytes([what]) for what in range(5))


def usb_control(kind, request, value, index, length, data=b""):
    return pid_record(CONTROL, struct.pack("<BBHHH", kind, request, value, index, length), data)


def usb_report(kind, *parts):
    """A SET_REPORT by control, with the report's number in its data as a driver sends it."""
    data = b"".join(parts)
    return usb_control(0x21, 9, kind << 8 | data[0], 0, len(data), data)


def usb_time(milliseconds, x=128, y=128):
    return pid_record(TIME, bytes([milliseconds, 1, x, y]))


def usb_effect(kind, by_control):
    """A host's effect of a kind from its making on, by control transfers or by packets; it plays."""
    words = struct.pack
    made = usb_report(3, b"\x21", bytes([kind]), words("<H", 0)) + usb_control(0xA1, 1, 0x0322, 0, 5)
    parts = [b"\x11\x01" + bytes([kind]) + words("<HHHH", 0, 0, 0, 0) + b"\xff\x00\x04" + words("<HH", 4500, 0),
             b"\x13\x01\x00" + words("<hhhHHH", 0, 9000, 9000, 9000, 9000, 0),
             b"\x14\x01" + words("<HhHH", 9000, 0, 0, 40), b"\x15\x01" + words("<h", 9000),
             b"\x16\x01" + words("<hh", -9000, 9000), b"\x1a\x01\x01\x01"]
    return made + b"".join(usb_report(2, part) if by_control else pid_record(PACKET, part) for part in parts)


def usb_seeds():
    """Effects that are felt, a bus that comes and goes while they play, and requests of every kind."""
    felt = usb_time(255) * 2 + pid_record(INPUT) + usb_time(9, 255, 0)
    files = {f"effect_of_kind_{kind}": usb_effect(kind, kind % 2 == 0) + felt for kind in range(1, 12)}
    plays = usb_effect(1, True) + felt
    files["nothing"] = b""
    files["unplugged"] = plays + pid_record(BUS, UNPLUG) + felt + pid_record(BUS, ENUMERATE) + plays
    files["asleep"] = plays + pid_record(BUS, SUSPEND) + felt + pid_record(BUS, RESUME) + felt
    files["reset"] = plays + pid_record(BUS, PLUG) + felt + pid_record(BUS, ENUMERATE) + felt
    files["unconfigured"] = plays + usb_control(0, 9, 0, 0, 0) + felt + usb_control(0, 9, 1, 0, 0) + felt
    files["descriptors"] = b"".join(usb_control(kind, 6, value, 0, 255) for kind, value in (
        (0x80, 0x0100), (0x80, 0x0200), (0x80, 0x0300), (0x80, 0x0303), (0x80, 0x03EE), (0x80, 0x0600), (0x81, 0x2100), (0x81, 0x2200)))
    files["every_request"] = b"".join(usb_control(kind | 0x80 * (request % 2), request, 0x0101, 0x81 if kind == 2 else 0, 64)
                                      for kind in (0, 1, 2, 0x21, 0x40) for request in range(12))
    files["short_of_data"] = usb_control(0x21, 9, 0x0211, 0, 64, b"\x11") + usb_control(0x21, 9, 0x0211, 0, 65, b"\x11")
    files["halted"] = plays + usb_control(2, 3, 0, 1, 0) + plays + usb_control(2, 1, 0, 1, 0) + plays
    files["silent_stick"] = plays + pid_record(TIME, b"\xff\x00")
    return files


def stick(x, y):
    return b"\x00" + share((1 + x) / 2) + share((1 + y) / 2)


def exchange(left, right, steps=32, reload=0):
    """Both sticks say something, then nothing for the rest of the steps."""
    return bytes([reload, 3]) + left + right + bytes([steps - 1])


def duel_seeds():
    """Blades that beat, lean and miss, lunges, and devices that fail; a millisecond a step."""
    guard, back, lunge = stick(0, 0), stick(0, -1), stick(0, 1)
    left, right = stick(-1, 0), stick(1, 0)
    corner = b"\x04\x00\x02"  # exactly in the corner
    again, behind = b"\x05\x00\xff", b"\x06\x80\x40" + struct.pack("<h", -9000) + b"\x05"
    bits = b"\x07\x00\x00" + struct.pack("<ffI", math.nan, -math.inf, 0x80000000)
    head = b"\x00" * 4  # 1 ms, as far apart as usual, as fast as usual; the first and the second
    bouts = {
        "lunge": exchange(guard, back) + exchange(lunge, back) * 8,
        "both_lunge": exchange(guard, guard) + exchange(lunge, lunge) * 8,
        "beats": (exchange(left, back) + exchange(right, left, reload=7)) * 8,
        "leaning": exchange(left, left) * 12,
        "jumping": (exchange(corner, left, 1) + exchange(right, corner, 2)) * 16,
        "failing": exchange(left, back) + exchange(again, behind) * 4 + exchange(bits, bits) * 3,
        "silent": exchange(left, left) + b"\x00\x00\x1f" * 16,
    }
    files = {name: b"\x00" + head + acts for name, acts in bouts.items()}
    files.update({f"drill_{name}": b"\x01" + head + bouts[name] for name in ("beats", "leaning")})
    files["coarse_steps"] = b"\x00\x03" + head[1:] + bouts["beats"]
    return files


def laws_seeds():
    """Two random scenes of each kind: digests, as unlike each other as the seeds of tests/laws."""
    kinds = ("straight", "small_balls", "small_cramped", "heap", "drift", "cramped", "hands", "paper", "paper_led",
             "paper_cramped", "blows", "blows_cramped", "blows_led")
    return {f"{kind}_{i}": bytes([index]) + b"".join(
                hashlib.sha256(f"{kind}/{i}/{part}".encode()).digest() for part in range(4))
            for index, kind in enumerate(kinds) for i in range(2)}


def c_moving(place, v=ORIGIN, w=ORIGIN, half=0.5, r=0.1, q=(1, 0, 0, 0)):
    """moving[20] of batuta/c.h."""
    return (*both_ways(X, half)[0], *both_ways(X, half)[1], r, *place, *q, *v, *w)


def c_seeds():
    """Calls from C: queries that are answered, worlds in which bodies meet and go, bouts, and each hostile number in its turn."""
    queries, acts, bout = b"\x00", b"\x01", b"\x02"
    long_step = b"\x03\x00" + number(0.25)

    def query(numbers, duration=1, tolerance=0, budget=64):
        return GRID + queries + b"".join(number(x) for x in (*numbers, duration, tolerance)) + struct.pack("<H", budget)

    def add(numbers, density=2, restitution=0.5, friction=0.25):
        return b"\x00" + b"".join(number(x) for x in numbers) + number(density) + share(restitution) + number(friction)

    def begin(step_us=2000, touches=1):
        return bout + struct.pack("<HB", step_us, touches + 2)

    def sticks(left, right, again=31):
        return b"\x03" + b"".join(share((1 + x) / 2) for x in (*left, *right)) + bytes([again])

    guard, lunge, beat = (0, 0, 0, 0), (0, 1, 0, 1), (-1, 0, 0, 0)
    here, there = c_moving(ORIGIN), c_moving((2, 0, 0), (-4, 0, 0))
    steps = b"\x03\x01" * 40
    files = {
        "query_head_on": query(here + there),
        "query_turning": query(here + c_moving((0, 0, 2), (0, 0, -3), (0, 0, 3))),
        "query_no_budget": query(here + there, budget=0),
        "query_no_turn": query(here + c_moving(X, q=(0, 0, 0, 0))),
        "world_beat": GRID + acts + b"\x02" + vector(ORIGIN) + add(here) + add(there) + long_step + steps,
        "world_falls": GRID + acts + add(c_moving(Z)) + add(c_moving((0, 0, 1.3))) + steps + b"\x01\x02" + steps + b"\x01\x02",
        "world_full": GRID + acts + b"".join(add(c_moving((0, i % 5, i // 5 - 2))) for i in range(18)) + steps[:8],
        "world_refuses": GRID + acts + add(c_moving(ORIGIN, r=-1)) + add(here, density=0) + add(here, friction=-1) + b"\x03\x00" + number(0),
        "duel_lunges": GRID + begin() + sticks(guard, guard) + sticks(lunge, guard) * 10,
        "duel_beats": GRID + begin(1000, 5) + (sticks(beat, (1, 0, 0, 0)) + sticks(guard, guard)) * 6,
        "duel_goes_on": GRID + begin(20000, 3) + sticks(lunge, lunge) * 12,
        "duel_beyond": ANY + begin() + (b"\x01" + struct.pack("<4f", 1, -1, 1, 0) + b"\x00") + b"\x02" + struct.pack("<4f", 0, 0, 0, 1.5) + b"\x00",
        "duel_no_step": GRID + begin(99) + sticks(lunge, guard),
        "duel_no_touches": GRID + begin(touches=100) + sticks(lunge, guard) + b"\x00\x05",
    }
    for index in range(HOSTILE):
        n = with_hostile((*here, *there, 1, 1e-6), index)
        files[f"hostile_{index}"] = ANY + queries + b"".join(n) + struct.pack("<H", 64)
        n = with_hostile((*here, 2), index)
        files[f"hostile_world_{index}"] = (ANY + acts + b"\x00" + b"".join(n) + share(0.5) + struct.pack("<f", 0.25) + steps[:8]
                                           + b"\x03\x00" + hostile(index))
        axes = with_hostile((*guard, *lunge), index)
        files[f"hostile_duel_{index}"] = ANY + begin() + b"\x03" + b"".join(axes) + b"\x03\x00\x07"
    return files


def c_recording_seeds():
    """Bouts from C that are recorded and played: whole, fetched too slowly, changed, in small pieces and in large ones."""
    def bout(steps, skill=1, hash_every=1, taken=255, edits=(), piece=255):
        sample = b"".join(share(x) for x in (0.5, 0.9)) + b"\x10\x00\x03" + b"\x01" + bytes([taken])
        changed = bytes([len(edits)]) + b"".join(struct.pack("<HB", at, by) for at, by in edits)
        return struct.pack("<BHBB", skill, 7, hash_every, steps) + sample * steps + changed + bytes([piece])
    return {"whole": bout(39), "nothing": bout(0), "no_hash": bout(20, hash_every=0), "slow": bout(39, hash_every=4, taken=0),
            "small_pieces": bout(10, piece=0), "changed_start": bout(10, edits=[(700, 1)]),
            "changed_mark": bout(10, edits=[(0, 255)]), "changed_step": bout(10, edits=[(6800, 16)]),
            "changed_back": bout(10, edits=[(3000, 5), (3000, 5)]), "master": bout(30, skill=2), "novice": bout(30, skill=0)}


FUZZERS = {"c": c_seeds, "c_recording": c_recording_seeds, "distance": distance_seeds, "duel": duel_seeds, "search": search_seeds,
           "impulse": impulse_seeds, "world": world_seeds, "keyframes": keyframes_seeds,
           "recording": recording_seeds, "pid": pid_seeds, "usb": usb_seeds, "laws": laws_seeds}


def differing(folder, files):
    found = {path.name: path.read_bytes() for path in folder.iterdir()} if folder.is_dir() else {}
    strangers = [name for name in found if name not in files and not name.startswith("found_")]
    return [name for name, data in files.items() if found.get(name) != data] + strangers


def main(arguments):
    if not arguments or arguments[-1].startswith("-"):
        print(__doc__)
        return 0 if "--help" in arguments else 2
    corpus = pathlib.Path(arguments[-1])
    wrong = []
    for fuzzer, seeds in FUZZERS.items():
        folder, files = corpus / fuzzer, seeds()
        if "--compare" in arguments:
            wrong += [f"{fuzzer}/{name}" for name in differing(folder, files)]
            continue
        folder.mkdir(parents=True, exist_ok=True)
        for name, data in files.items():
            (folder / name).write_bytes(data)
    for name in wrong:
        print(f"{name}: is not what this script writes", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
