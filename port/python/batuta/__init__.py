# SPDX-License-Identifier: MIT
"""Continuous collision of capsules, in numpy arrays: closest points, times of contact that miss none, all pairs of a chain.

SI units. Frame W is the world's. Arrays end in these shapes; whatever dimensions stand in front of them are those of
many queries at once, and are broadcast against each other:

capsule (..., 7)   ends a and b of the axis, m (x y z each); radius, m, >= 0. Equal ends are a ball.
pose    (..., 7)   origin of frame B in W, m (x y z); orientation q_WB (w x y z), of any length but 0
twist   (..., 6)   velocity of B's origin, m/s; angular velocity, rad/s; both in W
moving  (..., 20)  capsule in B, then pose and twist of B: see moving()

Where all arrays of a call are of float32, the answer is in float32, with the bits that firmware has; anything else in float64. What
cannot be asked is a ValueError, which names the first query that is at fault; then there is no answer to any."""

from .chain import Chain, ChainAnswer
from .queries import (Closest, FirstContact, Outcome, closest_points, moving, time_of_contact, twist_between)

__all__ = ["Chain", "ChainAnswer", "Closest", "FirstContact", "Outcome", "closest_points", "moving", "time_of_contact",
           "twist_between"]
