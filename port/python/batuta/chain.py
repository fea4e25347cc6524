# SPDX-License-Identifier: MIT
"""All pairs of the links of a robot between control ticks."""

import typing

import numpy as np

from .queries import Outcome, calls_for, is_masked, moving, numbers, one_number, time_of_contact, twist_between, upwards


class ChainAnswer(typing.NamedTuple):
    """What all_pairs() says; (...) are the dimensions of the stretches asked about, P the pairs of the chain."""
    pairs: np.ndarray  #: (P, 2) int: numbers of the links
    outcome: np.ndarray  #: (..., P) int32, values of Outcome
    t_free: np.ndarray  #: (..., P) s: the pair is proven free before it
    t_hit: np.ndarray  #: (..., P) s: where its gap is foreseen to vanish; the duration where none is

    def is_free(self):
        """(...) bool: every pair is proven free for the whole stretch."""
        return (self.outcome == Outcome.FREE).all(axis=-1)

    def free_until(self):
        """(...) s: up to here every pair is proven free."""
        return self.t_free.min(axis=-1)

    def first(self):
        """(..., 2) int: the pair that is free for the shortest time."""
        return self.pairs[self.t_free.argmin(axis=-1)]


class Chain:
    """Links of a robot, each a capsule that is fixed in a frame of its own."""

    def __init__(self, capsules, pairs=None):
        """capsules: capsule (L, 7), each in the frame of its link. pairs: (P, 2) numbers of links that must not touch; where nothing
        is said, all but neighbours, which share a joint: i and j with i + 1 < j. ValueError: a shape, a number that is not finite, a
        negative radius, a pair that there is not, no pair."""
        self.capsules = np.array(numbers("capsules", capsules, 7))  # its own: what was checked stays
        if self.capsules.ndim != 2:
            raise ValueError(f"batuta: capsules has shape {self.capsules.shape}, not (L, 7)")
        if (self.capsules[:, 6] < 0).any():
            raise ValueError("batuta: a radius below 0")
        links = len(self.capsules)
        if pairs is None:
            pairs = [(i, j) for i in range(links) for j in range(i + 2, links)]
        if is_masked(pairs):
            raise ValueError("batuta: pairs is masked")
        pairs = np.array(pairs)
        if pairs.size == 0:
            raise ValueError("batuta: a chain of which no pair is looked at")
        good = pairs.ndim == 2 and pairs.shape[1] == 2 and pairs.dtype.kind in "iu"
        if not good or (pairs < 0).any() or (pairs >= links).any() or (pairs[:, 0] == pairs[:, 1]).any():
            raise ValueError(f"batuta: pairs is not (P, 2) numbers of two links, 0 ... {links - 1}")
        self.pairs = pairs
        for array in (self.capsules, self.pairs):
            array.setflags(write=False)

    def all_pairs(self, start, end, duration, margin=0.0, tolerance=1e-6, budget=30):
        """Whether any pair touches while every link goes from one pose to another, and when first: proven, not sampled.

        start, end: pose (..., L, 7) of the links' frames at two control ticks. A whole path is one call: start = poses[:-1] and
        end = poses[1:] of poses (T, L, 7). duration: s between the ticks, > 0. tolerance, budget: those of time_of_contact().
        Returns ChainAnswer; ValueError as there.

        What is proven is the motion between the ticks in which each origin goes straight and each orientation turns steadily on the
        shortest way. A link that a joint swings goes on an arc: about l (1 - cos(turn / 2)) beside that straight line, l the distance
        of its origin from the joint. margin, m, >= 0, is kept between the surfaces of every pair; twice that deviation covers it."""
        start, end = numbers("start", start, 7), numbers("end", end, 7)
        links = len(self.capsules)
        for name, poses in (("start", start), ("end", end)):
            if poses.ndim < 2 or poses.shape[-2] != links:
                raise ValueError(f"batuta: {name} has shape {poses.shape}, not (..., {links}, 7)")
        margin = one_number("margin", margin, lambda m: m >= 0, "0 or more")
        scalar = calls_for(self.capsules, start, end).scalar.type
        capsules, start, end = (array.astype(scalar) for array in (self.capsules, start, end))
        if margin > 0:  # upwards: so much is promised
            capsules[:, 6] = np.nextafter(capsules[:, 6] + upwards(scalar, margin / 2), scalar(np.inf))
        bodies = moving(capsules, start, twist_between(start, end, duration))
        found = time_of_contact(bodies[..., self.pairs[:, 0], :], bodies[..., self.pairs[:, 1], :], duration, tolerance, budget)
        return ChainAnswer(self.pairs, found.outcome, found.t_free, found.t_hit)
