#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The installed Python package: exact answers, pencil and paper, properties, bad input, and the page.
Usage: package_test.py SOURCE VECTORS, with the package on the path."""

import ctypes
import doctest
import pathlib
import platform
import sys
import unittest

import numpy as np

import batuta
from batuta import Outcome

SOURCE, VECTORS = map(pathlib.Path, sys.argv[1:3])
WIDE = np.longdouble
ROUND_OFF = {np.float32: 2.0**-24, np.float64: 2.0**-53}  # u
UP = np.array([1.0, 0, 0, 0])  # no turn


def files(name):
    """The committed part of a file with exact answers, and the whole of it where it is there."""
    found = [SOURCE / "tests/vectors/committed" / name, VECTORS / name]
    return [path for path in found if path.is_file()]


def columns(path):
    """Name of a column: its words."""
    lines = path.read_text(encoding="ascii").splitlines()
    return dict(zip(lines[0].split(","), zip(*(line.split(",") for line in lines[1:]))))


def bits(table, *names):
    """float32 (N, len(names)) of columns with hexadecimal bits whose trailing zeros are left out."""
    found = [np.array([int(word.ljust(8, "0"), 16) for word in table[name]], np.uint32).view(np.float32) for name in names]
    return np.stack(found, axis=-1)


def decimals(table, name):
    return np.array(table[name], WIDE)


def norm(x):
    return np.sqrt((x * x).sum(axis=-1))


def xyz(*names):
    return [name + axis for name in names for axis in "xyz"]


def ball(radius, dtype=np.float64):
    return np.array([0, 0, 0, 0, 0, 0, radius], dtype)


def pose(x=0.0, y=0.0, z=0.0, q=UP):
    return np.concatenate([[x, y, z], q])


AMPLE = 64  # evaluations: the worst queries that climbing found, which are among these, take more than the default


class Vectors(unittest.TestCase):
    def test_closest_points(self):
        for path in files("dist.csv"):
            for scalar in (np.float32, np.float64):
                with self.subTest(path=path, scalar=scalar):
                    self.judge_distances(columns(path), scalar)

    def judge_distances(self, table, scalar):
        ends = [bits(table, *xyz(name)) for name in ("A0", "A1", "B0", "B1")]
        none = np.zeros((len(ends[0]), 1), np.float32)
        A = np.concatenate([ends[0], ends[1], none], axis=-1).astype(scalar)
        B = np.concatenate([ends[2], ends[3], none], axis=-1).astype(scalar)
        self.assertGreaterEqual(len(A), 2000)
        told = batuta.closest_points(A, B)
        self.assertEqual(told.distance.dtype, scalar)
        a, b, c, d = (end.astype(WIDE) for end in ends)
        unit = ROUND_OFF[scalar] * np.max([norm(b - a), norm(d - c), norm(c - a), norm(d - b)], axis=0)
        truth = decimals(table, "d")
        self.assertTrue((np.abs(told.distance - truth) <= 4 * unit).all())
        s, u = told.s.astype(WIDE)[:, None], told.u.astype(WIDE)[:, None]
        self.assertTrue(((s >= 0) & (s <= 1) & (u >= 0) & (u <= 1)).all())
        self.assertTrue((norm((c - a) + u * (d - c) - s * (b - a)) - truth <= 4 * unit).all())
        self.assertTrue((np.abs(norm(told.normal_AB.astype(WIDE)) - 1) <= 4 * ROUND_OFF[scalar]).all())
        np.testing.assert_array_equal(told.gap, told.distance)

    def test_time_of_contact(self):
        for path in files("toc.csv"):
            for scalar in (np.float32, np.float64):
                with self.subTest(path=path, scalar=scalar):
                    self.judge_times(columns(path), scalar)

    def judge_times(self, table, scalar):
        both, reach, turn, T = {}, {}, {}, bits(table, "T")[:, 0]
        for body in "AB":
            capsule = bits(table, *xyz(body + "e0", body + "e1"), body + "r")
            place = bits(table, *xyz(body + "c"), *(body + "q" + axis for axis in "wxyz"))
            twist = bits(table, *xyz(body + "v", body + "w"))
            both[body] = batuta.moving(capsule, place, twist).astype(scalar)
            ends = capsule.astype(WIDE)
            reach[body] = np.maximum(norm(ends[:, :3]), norm(ends[:, 3:6]))
            turn[body] = norm(twist[:, 3:].astype(WIDE)) * T
        told = self.ask_by_duration(both["A"], both["B"], T, scalar)
        kind, t, rate = decimals(table, "kind"), decimals(table, "t"), np.abs(decimals(table, "rate"))
        outcome = told["outcome"]
        self.assertGreaterEqual((kind == 1).sum(), 1000)
        self.assertFalse((outcome == Outcome.BUDGET).any())
        self.assertTrue((outcome[kind == 2] == Outcome.TOUCHING).all())
        on_the_way = kind == 1
        self.assertFalse((outcome[on_the_way] == Outcome.FREE).any())
        self.assertTrue((told["t_free"].astype(WIDE)[on_the_way] <= t[on_the_way]).all())
        # What counts as contact: src/detection/advancement.md.
        A, B = both["A"].astype(WIDE), both["B"].astype(WIDE)
        S = norm(B[:, 7:10] - A[:, 7:10]) + norm(B[:, 14:17] - A[:, 14:17]) * T + reach["A"] + reach["B"] + A[:, 6] + B[:, 6]
        L = S + turn["A"] * reach["A"] + turn["B"] * reach["B"]
        u = ROUND_OFF[scalar]
        contact_gap = np.maximum(1e-6 * S, 96 * u * L) + 72 * u * L
        met = on_the_way & (outcome == Outcome.CONTACT)
        error = np.abs(told["t_hit"].astype(WIDE) - t)
        self.assertTrue((error[met] * rate[met] <= contact_gap[met] * (1 + 1e-6)).all())
        least = decimals(table, "gmin") - decimals(table, "gerr")
        said = (outcome == Outcome.CONTACT) | (outcome == Outcome.TOUCHING)
        self.assertTrue((least[said] <= contact_gap[said] * (1 + 1e-6)).all())

    @staticmethod
    def ask_by_duration(A, B, T, scalar):
        """One call for each duration: a call has one."""
        told = {"outcome": np.zeros(len(A), np.int32), "t_free": np.zeros(len(A), scalar), "t_hit": np.zeros(len(A), scalar)}
        for duration in np.unique(T):
            rows = T == duration
            found = batuta.time_of_contact(A[rows], B[rows], duration, budget=AMPLE)
            for name in told:
                told[name][rows] = getattr(found, name)
        return told


class Queries(unittest.TestCase):
    def test_dimensions_are_broadcast(self):
        A = np.zeros((4, 1, 7))
        B = np.zeros((3, 7))
        A[:, 0, 6] = 0.25
        B[:, [0, 3]] = np.arange(3)[:, None]
        told = batuta.closest_points(A, B)
        self.assertEqual(told.gap.shape, (4, 3))
        self.assertEqual(told.p_B.shape, (4, 3, 3))
        np.testing.assert_allclose(told.gap, np.broadcast_to(np.arange(3) - 0.25, (4, 3)), atol=1e-15)
        np.testing.assert_array_equal(told.arbitrary, np.broadcast_to([True, False, False], (4, 3)))
        self.assertEqual(batuta.closest_points(A[0, 0], B[2]).gap.shape, ())
        self.assertEqual(batuta.closest_points(np.zeros((0, 7)), B[0]).gap.shape, (0,))

    def test_float32_has_bits_of_its_own(self):
        A, B = ball(0.1, np.float32), ball(0.2, np.float32)
        B[[0, 3]] = 1 / 3
        self.assertEqual(batuta.closest_points(A, B).gap.dtype, np.float32)
        self.assertEqual(batuta.closest_points(A.astype(float), B).gap.dtype, np.float64)
        self.assertEqual(batuta.time_of_contact(batuta.moving(A, pose().astype(np.float32)),
                                                batuta.moving(B, pose().astype(np.float32)), 1).t_free.dtype, np.float32)

    def test_arrays_need_not_be_contiguous(self):
        rng = np.random.default_rng(1)
        A, B = np.abs(rng.normal(size=(2, 40, 7)))
        told = batuta.closest_points(A[::2], np.asfortranarray(B)[::2])
        np.testing.assert_array_equal(told.gap, batuta.closest_points(A, B).gap[::2])

    def test_arrays_may_stand_anywhere_in_any_order_of_bytes(self):
        A, B = np.arange(14.0).reshape(2, 7), np.arange(14.0, 28.0).reshape(2, 7)
        for scalar in np.float32, np.float64:
            right = batuta.closest_points(A.astype(scalar), B.astype(scalar))
            bytes_of_A = bytes(1) + A.astype(scalar).tobytes()
            misplaced = np.frombuffer(bytes_of_A, scalar, offset=1).reshape(2, 7)
            self.assertFalse(misplaced.flags.aligned)
            swapped = B.astype(np.dtype(scalar).newbyteorder())
            told = batuta.closest_points(misplaced, swapped)
            self.assertEqual(told.gap.dtype, scalar)
            np.testing.assert_array_equal(told.gap, right.gap)

    def test_balls_by_pencil(self):
        speed = np.array([0.0, 1, 2, 4])  # the gap of 2 is over after 2 / speed
        twist = np.zeros((4, 6))
        twist[:, 0] = -speed
        told = batuta.time_of_contact(batuta.moving(ball(0.5), pose()), batuta.moving(ball(0.5), pose(3), twist), 1.5)
        np.testing.assert_array_equal(told.outcome, [Outcome.FREE, Outcome.FREE, Outcome.CONTACT, Outcome.CONTACT])
        np.testing.assert_allclose(told.t_hit, [1.5, 1.5, 1, 0.5], rtol=1e-9)
        self.assertTrue((told.t_free[2:] < told.t_hit[2:]).all())

    def test_twist_between_by_pencil(self):
        quarter = [np.sqrt(0.5), 0, 0, np.sqrt(0.5)]
        twist = batuta.twist_between([pose(1, 2, 3), pose()], pose(1, 4, 3, quarter), 0.5)
        np.testing.assert_allclose(twist[0], [0, 4, 0, 0, 0, np.pi], atol=1e-14)
        self.assertEqual(twist.shape, (2, 6))


class Chains(unittest.TestCase):
    """An arm of three links, the third of which is led past the first one."""

    capsules = np.stack([[0, 0, 0, 1, 0, 0, 0.05], ball(0.05), ball(0.05)])

    def poses(self, height):
        return np.stack([pose(), pose(0, 0, 9), pose(0.5, 0, height)])

    def test_what_two_ticks_do_not_show(self):
        chain = batuta.Chain(self.capsules)
        np.testing.assert_array_equal(chain.pairs, [[0, 2]])
        start, end = self.poses(1), self.poses(-1)
        for tick in (start, end):
            link = tick[2].copy()
            self.assertGreater(batuta.closest_points(self.capsules[0], np.concatenate([link[:3], link[:3], [0.05]])).gap, 0.8)
        told = chain.all_pairs(start, end, 0.5)
        self.assertFalse(told.is_free())
        self.assertEqual(told.outcome[0], Outcome.CONTACT)
        self.assertAlmostEqual(told.t_hit[0], 0.5 * 0.9 / 2, places=9)  # from 1 m down to 0.1 m, at 4 m/s
        self.assertEqual(told.free_until(), told.t_free[0])
        np.testing.assert_array_equal(told.first(), [0, 2])
        self.assertTrue(chain.all_pairs(start, self.poses(0.2), 0.5).is_free())

    def test_a_link_that_turns(self):
        # A rod of 2 m turns by a right angle; a ball lies in its way at 30 degrees, 1.5 m out.
        rod = np.array([0, 0, 0, 2, 0, 0, 0.01])
        chain = batuta.Chain([rod, ball(0.1)], [(1, 0)])
        there = pose(1.5 * np.cos(np.pi / 6), 1.5 * np.sin(np.pi / 6))
        told = chain.all_pairs([pose(), there], [pose(q=[np.sqrt(0.5), 0, 0, np.sqrt(0.5)]), there], 1)
        angle = np.pi / 6 - np.arcsin(0.11 / 1.5)  # of the rod, where it touches
        self.assertAlmostEqual(told.t_hit[0], angle / (np.pi / 2), places=6)

    def test_what_was_checked_stays(self):
        """Neither the caller's arrays nor an answer lead into the chain."""
        capsules, pairs, still = Chains.capsules.copy(), np.array([[0, 2]]), np.stack([pose()] * 3)
        chain = batuta.Chain(capsules, pairs)
        pairs[0], capsules[0, 6] = (1, -1), 99
        answer = chain.all_pairs(still, still, 1)
        self.assertEqual(answer.pairs.tolist(), [[0, 2]])
        self.assertEqual(chain.capsules.tolist(), Chains.capsules.tolist())
        for array in (answer.pairs, chain.pairs, chain.capsules):
            with self.assertRaises(ValueError):
                array[0] = 1

    def test_margin_is_kept(self):
        chain = batuta.Chain(self.capsules)
        start, end = self.poses(0.2), self.poses(0.15)  # gaps of 0.1 and 0.05 m
        self.assertTrue(chain.all_pairs(start, end, 1).is_free())
        self.assertTrue(chain.all_pairs(start, end, 1, margin=0.049).is_free())
        told = chain.all_pairs(start, end, 1, margin=0.075)
        self.assertAlmostEqual(told.t_hit[0], 0.5, places=5)
        self.assertEqual(chain.capsules[0, 6], 0.05)

    def test_margin_is_kept_in_every_type_of_numbers(self):
        """Two balls of 2 m whose gap is half the margin, or less by roundings of what is summed."""
        for capsules, places in ((np.float16, np.float64), (np.float32, np.float32), (np.float32, np.float64), (np.int64, np.int64)):
            chain = batuta.Chain(np.stack([ball(2), ball(2)]).astype(capsules), [(0, 1)])
            for gap, margin in (5e-4, 1e-3), (1e-3, 1e-3), (2.0**-20, 2.0**-20 + 2.0**-40):
                still = np.stack([pose(), pose(4 + (0 if places is np.int64 else gap))]).astype(places)
                told = chain.all_pairs(still, still, 1, margin=margin)
                self.assertFalse(told.is_free(), (capsules, places, gap, margin))
                both = np.float32 if capsules is np.float32 and places is np.float32 else np.float64
                self.assertEqual(told.t_free.dtype, both)

    def test_a_path_is_one_call(self):
        rng = np.random.default_rng(2)
        path = np.concatenate([rng.uniform(-1, 1, (9, 3, 3)), rng.normal(size=(9, 3, 4))], axis=-1)
        chain = batuta.Chain(self.capsules, [(0, 1), (0, 2), (1, 2)])
        whole = chain.all_pairs(path[:-1], path[1:], 0.1)
        self.assertEqual(whole.outcome.shape, (8, 3))
        self.assertEqual(whole.free_until().shape, (8,))
        self.assertEqual(whole.first().shape, (8, 2))
        for i in range(8):
            one = chain.all_pairs(path[i], path[i + 1], 0.1)
            np.testing.assert_array_equal(one.t_free, whole.t_free[i])
            np.testing.assert_array_equal(one.outcome, whole.outcome[i])
        self.assertGreater(len(np.unique(whole.outcome)), 1)

    def test_up_to_t_free_no_instant_shows_a_contact(self):
        """Against poses that are turned here, by the formula of slerp."""
        rng = np.random.default_rng(3)
        links = 6
        capsules = np.concatenate([rng.uniform(-0.5, 0.5, (links, 6)), np.full((links, 1), 0.05)], axis=-1)
        chain = batuta.Chain(capsules)
        met = 0
        for _ in range(40):
            start, end = np.concatenate([rng.uniform(-1.5, 1.5, (2, links, 3)), rng.normal(size=(2, links, 4))], axis=-1)
            told = chain.all_pairs(start, end, 1)
            met += (told.outcome == Outcome.CONTACT).sum()
            for share in np.linspace(0, 1, 33):
                ends = [placed(capsules, slerped(start, end, share * told.t_free[k])) for k in range(len(chain.pairs))]
                gaps = [batuta.closest_points(ends[k][i], ends[k][j]).gap for k, (i, j) in enumerate(chain.pairs)]
                apart = told.outcome != Outcome.TOUCHING
                self.assertGreater(np.array(gaps)[apart].min(initial=1), -1e-12)
        self.assertGreater(met, 20)


def slerped(start, end, share):
    """Poses on the way: origins straight, orientations by slerp on the shortest way."""
    p, q = start[:, 3:] / norm(start[:, 3:])[:, None], end[:, 3:] / norm(end[:, 3:])[:, None]
    cosine = (p * q).sum(axis=-1, keepdims=True)
    q, angle = np.where(cosine < 0, -q, q), np.arccos(np.minimum(np.abs(cosine), 1))
    turned = (np.sin((1 - share) * angle) * p + np.sin(share * angle) * q) / np.sin(angle)
    return np.concatenate([start[:, :3] + share * (end[:, :3] - start[:, :3]), turned], axis=-1)


def placed(capsules, poses):
    """Capsules in W."""
    w, v = poses[:, 3:4], poses[:, 4:]
    ends = [poses[:, :3] + e + 2 * np.cross(v, np.cross(v, e) + w * e) for e in (capsules[:, :3], capsules[:, 3:6])]
    return np.concatenate([*ends, capsules[:, 6:]], axis=-1)


class BadInput(unittest.TestCase):
    def refuses(self, words, function, *arguments, **more):
        with self.assertRaisesRegex(ValueError, words):
            function(*arguments, **more)

    def test_shapes(self):
        good = np.zeros((2, 7))
        for bad in (np.zeros(6), np.zeros((7, 2)), 1.0, np.zeros((0,))):
            self.refuses("shape", batuta.closest_points, bad, good)
            self.refuses("shape", batuta.closest_points, good, bad)
        self.refuses("do not fit", batuta.closest_points, good, np.zeros((3, 7)))
        self.refuses("shape", batuta.time_of_contact, good, good, 1)
        self.refuses("shape", batuta.moving, good, np.zeros(6))
        self.refuses("shape", batuta.Chain, ball(1))
        chain = batuta.Chain(Chains.capsules)
        self.refuses("shape", chain.all_pairs, np.zeros((2, 7)), np.zeros((3, 7)), 1)

    def test_numbers(self):
        good = np.zeros((2, 3, 7))
        for bad in (np.nan, np.inf):
            for column in range(7):
                spoilt = good.copy()
                spoilt[1, 2, column] = bad
                self.refuses(r"not finite at query \(1, 2\)", batuta.closest_points, spoilt, good)
        spoilt = good.copy()
        spoilt[1, 0, 6] = -1
        self.refuses(r"query \(1, 0\): a radius", batuta.closest_points, good, spoilt)
        self.refuses("holds", batuta.closest_points, good.astype(complex), good)
        self.refuses("holds", batuta.closest_points, good.astype(str), good)
        self.refuses("masked", batuta.closest_points, good, np.ma.masked_array(good, good > 0))
        self.refuses("masked", batuta.closest_points, good, [np.ma.masked_array(good, good > 0)])
        self.refuses("timedelta", batuta.closest_points, good, np.array(good, "timedelta64[s]"))
        self.refuses("not finite", batuta.closest_points, good, np.full(7, WIDE(np.inf)))
        if np.finfo(WIDE).max > np.finfo(np.float64).max:
            self.refuses("not finite", batuta.closest_points, good, np.full(7, np.finfo(WIDE).max))

    def test_searches(self):
        A = batuta.moving(ball(1), [pose(), pose(9)])
        for duration, tolerance, budget in ((-1, 1e-6, 64), (np.nan, 1e-6, 64), (np.inf, 1e-6, 64), (1, -1, 64), (1, 2, 64),
                                            (1, np.nan, 64), (1, 1e-6, 0), (1, 1e-6, 4097), (1, 1e-6, -1)):
            self.refuses("batuta: ", batuta.time_of_contact, A, A[0], duration, tolerance, budget)
        self.refuses("budget is 1.5", batuta.time_of_contact, A, A, 1, budget=1.5)
        for duration in np.array([1.0, 2.0]), "1", None, 1j, [1]:
            self.refuses("duration is .* not one number", batuta.time_of_contact, A, A, duration)
        spoilt = A.copy()
        spoilt[1, 10:14] = 0
        self.refuses(r"query \(1,\)", batuta.time_of_contact, spoilt, A, 1)
        spoilt = A.copy()
        spoilt[1, 17:] = 2000
        self.refuses(r"query \(1,\)", batuta.time_of_contact, A, spoilt, 1)
        self.refuses("duration", batuta.twist_between, pose(), pose(), 0)

    def test_whole_duration_is_proven(self):
        """float32 holds none of these; what is free is so for no less than was asked."""
        far = batuta.moving(np.float32(ball(1)), np.float32([pose(), pose(9)]))
        for duration in 0.1, 1 / 3, 0.7:
            found = batuta.time_of_contact(far[0], far[1], duration)
            self.assertEqual((found.outcome, found.t_free.dtype), (Outcome.FREE, np.float32))
            self.assertGreaterEqual(float(found.t_free), duration)
        self.refuses("too small", batuta.time_of_contact, far[0], far[1], 1e-60)

    def test_masked_numbers(self):
        """Below a mask stands a number that nobody means: as a duration it would be proven free for none."""
        A, chain, still = batuta.moving(ball(1), pose()), batuta.Chain(Chains.capsules), np.stack([pose()] * 3)
        for masked in np.ma.masked, np.ma.array(1.0, mask=True):
            self.refuses("duration is masked", batuta.time_of_contact, A, A, masked)
            self.refuses("margin is masked", chain.all_pairs, still, still, 1, masked)
        self.refuses("pairs is masked", batuta.Chain, Chains.capsules, np.ma.array([[0, 2]], mask=True))

    def test_motions(self):
        self.refuses(r"batuta: shapes \(2, 7\), \(3, 7\), \(6,\) do not fit", batuta.moving, [ball(1)] * 2, [pose()] * 3)
        single = [np.float32(ball(1)), np.float32(pose())]
        self.refuses("twist, in float32, is not finite", batuta.moving, *single, [1e300, 0, 0, 0, 0, 0])

    def test_no_queries(self):
        """What is out of range is told also where there is nothing to ask for."""
        none = np.zeros((0, 20))
        self.assertEqual(batuta.time_of_contact(none, none, 1).t_hit.shape, (0,))
        for duration, tolerance in (-1, 1e-6), (np.nan, 1e-6), (1, -1e-6), (1, 5), (1, np.inf):
            self.refuses("batuta: (duration|tolerance) is", batuta.time_of_contact, none, none, duration, tolerance)
        for duration in 0, -1, np.nan:
            self.refuses("duration", batuta.twist_between, np.zeros((0, 7)), np.zeros((0, 7)), duration)
            self.refuses("duration", batuta.Chain(Chains.capsules).all_pairs, np.zeros((0, 3, 7)), np.zeros((0, 3, 7)), duration)

    def test_chains(self):
        for pairs in ([(0, 3)], [(0, 0)], [(-1, 1)], [(0.0, 1.0)], [(0, 1, 2)], [], [0, 1]):
            self.refuses("pair", batuta.Chain, Chains.capsules, pairs)
        self.refuses("pair", batuta.Chain, Chains.capsules, np.array([[0, 2]], "timedelta64[s]"))
        self.refuses("pair", batuta.Chain, Chains.capsules[:2])
        self.refuses("radius", batuta.Chain, -Chains.capsules)
        chain = batuta.Chain(Chains.capsules)
        still = np.stack([pose()] * 3)
        for margin in (-1, np.nan):
            self.refuses("margin", chain.all_pairs, still, still, 1, margin)

    @unittest.skipUnless(platform.machine() == "x86_64" and sys.platform == "linux", "the number of a rounding mode")
    def test_arithmetic(self):
        nearest, upward = 0, 0x800
        libm = ctypes.CDLL("libm.so.6")
        for scalar in (np.float32, np.float64):
            A = ball(1, scalar)
            libm.fesetround(upward)
            try:
                with self.assertRaisesRegex(RuntimeError, "round"):
                    batuta.closest_points(A, A)
            finally:
                libm.fesetround(nearest)
            batuta.closest_points(A, A)


class Page(unittest.TestCase):
    def test_what_it_shows_is_so(self):
        failed, tried = doctest.testfile(str(SOURCE / "docs/python.md"), module_relative=False)
        self.assertGreater(tried, 5)
        self.assertEqual(failed, 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
