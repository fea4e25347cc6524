# SPDX-License-Identifier: MIT
"""The shared library beside this file, as batuta/c.h declares it."""

import ctypes
import pathlib

import numpy as np

OK, UNAVAILABLE = 0, 5  # BATUTA_OK, BATUTA_UNAVAILABLE


class SearchF(ctypes.Structure):
    """batuta_search_f"""
    _fields_ = [("duration", ctypes.c_float), ("tolerance", ctypes.c_float), ("budget", ctypes.c_uint32)]


class SearchD(ctypes.Structure):
    """batuta_search_d"""
    _fields_ = [("duration", ctypes.c_double), ("tolerance", ctypes.c_double), ("budget", ctypes.c_uint32)]


def closest_type(scalar):
    """batuta_closest_f or batuta_closest_d"""
    return np.dtype([("gap", scalar), ("distance", scalar), ("s", scalar), ("u", scalar), ("p_A", scalar, 3), ("p_B", scalar, 3),
                     ("normal_AB", scalar, 3), ("arbitrary", np.int32)], align=True)


def contact_type(scalar):
    """batuta_contact_f or batuta_contact_d"""
    return np.dtype([("outcome", np.int32), ("evaluations", np.uint32), ("t_free", scalar), ("t_hit", scalar)], align=True)


class Calls:
    """The functions for one scalar."""

    def __init__(self, library, suffix, scalar, number, search):
        self.scalar, self.number, self.search = np.dtype(scalar), number, search
        self.closest, self.contact = closest_type(scalar), contact_type(scalar)
        pointer, count = ctypes.c_void_p, ctypes.c_size_t
        self.closest_points = self.declare(library, "batuta_closest_points_many_" + suffix, pointer, pointer, count, pointer)
        self.time_of_contact = self.declare(library, "batuta_time_of_contact_many_" + suffix, pointer, pointer, count,
                                            ctypes.POINTER(search), pointer)
        self.twist_between = self.declare(library, "batuta_twist_between_many_" + suffix, pointer, pointer, count, number, pointer)
        self.one = self.declare(library, "batuta_closest_points_" + suffix, pointer, pointer, pointer, result=ctypes.c_int32)

    @staticmethod
    def declare(library, name, *arguments, result=ctypes.c_size_t):
        function = getattr(library, name)
        function.argtypes, function.restype = arguments, result
        return function

    def arithmetic_is_good(self):
        """Whether this thread computes as the library's proofs ask: it rounds to nearest and keeps small numbers."""
        ball, out = np.zeros(7, self.scalar), np.zeros(1, self.closest)
        return self.one(ball.ctypes.data, ball.ctypes.data, out.ctypes.data) != UNAVAILABLE


def load():
    found = sorted(pathlib.Path(__file__).parent.glob("libbatuta_queries.*"))
    if not found:
        raise ImportError("batuta: the shared library is not beside its modules; install the package (docs/python.md)")
    library = ctypes.CDLL(str(found[0]))
    return {np.dtype(np.float32): Calls(library, "f", np.float32, ctypes.c_float, SearchF),
            np.dtype(np.float64): Calls(library, "d", np.float64, ctypes.c_double, SearchD)}


CALLS = load()
