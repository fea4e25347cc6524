# SPDX-License-Identifier: MIT
"""Queries of two capsules, many at once. Shapes: see the package."""

import ctypes
import enum
import operator
import typing

import numpy as np

from .library import CALLS


class Outcome(enum.IntEnum):
    """What a search says of [0, duration]."""
    FREE = 0  #: no contact, proven
    CONTACT = 1  #: free up to t_free, where the gap is within the tolerance
    TOUCHING = 2  #: in contact at the start
    BUDGET = 3  #: free up to t_free, unknown after: never to be taken for FREE


class Closest(typing.NamedTuple):
    """Where capsules A and B are closest; (...) are the dimensions of the queries."""
    gap: np.ndarray  #: (...) distance of the surfaces, m; negative: depth of the overlap
    distance: np.ndarray  #: (...) of the axes, m, >= 0
    s: np.ndarray  #: (...) place on A's axis, 0 at a ... 1 at b
    u: np.ndarray  #: (...) place on B's axis
    p_A: np.ndarray  #: (..., 3) point of A's axis, m
    p_B: np.ndarray  #: (..., 3) point of B's axis, m
    normal_AB: np.ndarray  #: (..., 3) unit, from p_A to p_B
    arbitrary: np.ndarray  #: (...) bool: the axes meet, and the normal's sign or direction is a convention


class FirstContact(typing.NamedTuple):
    """When moving capsules first touch; (...) are the dimensions of the queries."""
    outcome: np.ndarray  #: (...) int32, values of Outcome
    t_free: np.ndarray  #: (...) s: no contact before it, proven; move there
    t_hit: np.ndarray  #: (...) s: where the gap is foreseen to vanish, much closer to the truth; the duration where none is
    evaluations: np.ndarray  #: (...) uint32, distance evaluations that it took


def calls_for(*arrays):
    """The library's functions for float32 where all arrays are that, else for float64; a RuntimeError where it cannot be trusted."""
    single = all(array.dtype == np.float32 for array in arrays)
    calls = CALLS[np.dtype(np.float32 if single else np.float64)]
    if not calls.arithmetic_is_good():
        raise RuntimeError("batuta: this thread does not round to nearest, or flushes small numbers to zero (a library built with "
                           "-ffast-math may have set it so): nothing would be proven")
    return calls


def is_masked(value):
    """Whether it is a masked array, or a list or tuple that has one somewhere: numpy would take the numbers below the mask."""
    if isinstance(value, (list, tuple)):
        return any(is_masked(item) for item in value)
    return isinstance(value, np.ma.MaskedArray)


def numbers(name, array, width):
    """An array of numbers, float32 where it was of these, else float64, whose last dimension has the width; a ValueError: another
    shape, masked, or not finite."""
    if is_masked(array):
        raise ValueError(f"batuta: {name} is masked: ask for what is not, by array[~mask]")
    array = np.asarray(array)
    if array.dtype.kind not in "fiu":
        raise ValueError(f"batuta: {name} holds {array.dtype}, no real numbers")
    is_single = array.dtype.kind == "f" and array.dtype.itemsize == 4  # of either byte order
    with np.errstate(over="ignore"):  # what is too large for float64 is not finite there
        array = array.astype(np.float32 if is_single else np.float64, copy=False)
    if array.ndim == 0 or array.shape[-1] != width:
        raise ValueError(f"batuta: {name} has shape {array.shape}, not (..., {width})")
    bad = ~np.isfinite(array).all(axis=-1)
    if bad.any():
        raise ValueError(f"batuta: {name} is not finite at {where(int(np.argmax(bad)), bad.shape)}")
    return array


def where(index, shape):
    return f"query {tuple(int(i) for i in np.unravel_index(index, shape))}" if shape else "the query"


def one_number(name, value, is_good, good):
    """A finite number that is_good() takes, also where there is no query that it is for. good: which those are, in words."""
    if is_masked(value):
        raise ValueError(f"batuta: {name} is masked")
    value = np.asarray(value)
    if value.ndim > 0 or value.dtype.kind not in "fiu":
        raise ValueError(f"batuta: {name} is {value.dtype} of shape {value.shape}, not one number")
    value = float(value)
    if not (np.isfinite(value) and is_good(value)):
        raise ValueError(f"batuta: {name} is {value}, not {good}")
    return value


def whole_number(name, value, low, high):
    try:
        value = operator.index(value)
    except TypeError:
        raise ValueError(f"batuta: {name} is {value!r}, not a whole number") from None
    if not low <= value <= high:
        raise ValueError(f"batuta: {name} is {value}, not {low} ... {high}")
    return value


def pairs_of(calls, A, B):
    """Both broadcast against each other, as the library reads them, and the dimensions of the queries. A ValueError: they do not
    fit."""
    try:
        shape = np.broadcast_shapes(A.shape[:-1], B.shape[:-1])
    except ValueError:
        raise ValueError(f"batuta: shapes {A.shape} and {B.shape} do not fit each other") from None
    both = [np.require(np.broadcast_to(array, shape + array.shape[-1:]), calls.scalar, ["C_CONTIGUOUS", "ALIGNED"]) for array in (A, B)]
    return both[0], both[1], shape


def upwards(scalar, value):
    """The least number of that type that is no less: what is proven for it is proven for the value."""
    with np.errstate(over="ignore"):
        rounded = scalar(value)
    return rounded if float(rounded) >= value else np.nextafter(rounded, scalar(np.inf))


def check_all(answered, count, shape, what):
    if answered != count:
        raise ValueError(f"batuta: {where(answered, shape)}: {what}")


def closest_points(A, B):
    """Closest points of capsules A and B, in one frame.

    A, B: capsule (..., 7), broadcast. Returns Closest with the dimensions (...). The distance is within 5 roundings of the
    largest length in the query. ValueError: a shape, a number that is not finite, a radius below 0."""
    A, B = numbers("A", A, 7), numbers("B", B, 7)
    calls = calls_for(A, B)
    A, B, shape = pairs_of(calls, A, B)
    out = np.zeros(shape, calls.closest)
    check_all(calls.closest_points(A.ctypes.data, B.ctypes.data, out.size, out.ctypes.data), out.size, shape,
              "a radius below 0, or a coordinate too large")
    return Closest(out["gap"], out["distance"], out["s"], out["u"], out["p_A"], out["p_B"], out["normal_AB"], out["arbitrary"] != 0)


def moving(capsule, pose, twist=(0, 0, 0, 0, 0, 0)):
    """Capsules in motion, for time_of_contact().

    capsule (..., 7) in its body's frame B; pose (..., 7) of B at the start; twist (..., 6) of B, kept for the duration.
    Returns (..., 20), broadcast; float32 where capsule and pose are."""
    parts = [numbers("capsule", capsule, 7), numbers("pose", pose, 7), numbers("twist", twist, 6)]
    scalar = np.float32 if all(part.dtype == np.float32 for part in parts[:2]) else np.float64
    try:
        shape = np.broadcast_shapes(*(part.shape[:-1] for part in parts))
    except ValueError:
        raise ValueError(f"batuta: shapes {', '.join(str(part.shape) for part in parts)} do not fit each other") from None
    with np.errstate(over="ignore"):  # a twist that is too large for float32 is not finite there
        both = [np.broadcast_to(part, shape + part.shape[-1:]).astype(scalar) for part in parts]
    return numbers("twist, in float32,", np.concatenate(both, axis=-1), 20)


def time_of_contact(A, B, duration, tolerance=1e-6, budget=30):
    """First contact of moving capsules A and B within the duration. None is missed, turning included: up to t_free the true gap is
    above 0, rounding of the search included.

    A, B: moving (..., 20), broadcast. duration: s, >= 0, for float32 arrays the next float32 up where it is none; no body turns by
    more than 2526 rad in it. tolerance: a gap of so much of the query's length (distance + travel + sizes) counts as contact, 0 ... 1;
    float32 raises it to what it can resolve, some 6e-6.
    budget: most distance evaluations of a query, 1 ... 4096; where they do not suffice the outcome is BUDGET.
    Returns FirstContact with the dimensions (...). ValueError: a shape, a number that is not finite or out of its range."""
    A, B = numbers("A", A, 20), numbers("B", B, 20)
    calls = calls_for(A, B)
    A, B, shape = pairs_of(calls, A, B)
    budget = whole_number("budget", budget, 1, 4096)
    duration = one_number("duration", duration, lambda s: s >= 0, "0 or more")
    search = calls.search(upwards(calls.scalar.type, duration),
                          one_number("tolerance", tolerance, lambda share: 0 <= share <= 1, "0 ... 1"), budget)
    out = np.zeros(shape, calls.contact)
    check_all(calls.time_of_contact(A.ctypes.data, B.ctypes.data, out.size, ctypes.byref(search), out.ctypes.data), out.size, shape,
              "a duration or radius below 0, a tolerance outside 0 ... 1, a quaternion of length 0, a turn beyond 2526 rad, or numbers "
              "too large or too small for a search")
    return FirstContact(out["outcome"], out["t_free"], out["t_hit"], out["evaluations"])


def twist_between(start, end, duration):
    """The constant twists that carry poses into others in the duration: origins straight, orientations on the shortest way.

    start, end: pose (..., 7), broadcast. duration: s, > 0. Returns twist (..., 6). ValueError: a shape, a number that is not finite or
    out of its range."""
    start, end = numbers("start", start, 7), numbers("end", end, 7)
    calls = calls_for(start, end)
    start, end, shape = pairs_of(calls, start, end)
    out = np.zeros(shape + (6,), calls.scalar)
    count = start.size // 7
    duration = calls.number(one_number("duration", duration, lambda s: s > 0, "above 0"))
    check_all(calls.twist_between(start.ctypes.data, end.ctypes.data, count, duration, out.ctypes.data), count, shape,
              "a duration not above 0, or a quaternion of length 0")
    return out
