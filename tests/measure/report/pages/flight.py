# SPDX-License-Identifier: MIT
"""Free flight of bodies with three unlike moments: error against step length and cost."""

from fit import slope
from markdown import number, percent, shown, table
from plot import Panel, Series, draw
from pages.simulation import thousands

TITLE = "Free flight of bodies with three unlike moments"
FILES = ["flight"]

METHODS = [("batuta", "double"), ("batuta", "float"), ("velocity held", "double")]
ORDER_STEPS_US = (1000, 10000)  # shorter ones reach rounding in double


def _shapes(rows):
    return list(dict.fromkeys(row["shape"] for row in rows.rows))


def _of(rows, shape, method):
    chosen = rows.where(shape=shape, method=method[0], scalar=method[1]).rows
    return sorted(chosen, key=lambda row: float(row["step_us"]))


def _ms(row):
    return float(row["step_us"]) / 1000


def _time(row):
    return row["time_in_plain"].quantile(0.5)


def _median(row):
    return row["turn_rad"].quantile(0.5)


def _series(rows, shape, x, y):
    """Of the settings in which no flight was held."""
    whole = [[row for row in _of(rows, shape, method) if row["flights"] and not row["held"]] for method in METHODS]
    return [Series(", ".join(method), [(x(row), y(row)) for row in whole[look] if x(row) and y(row)], look)
            for look, method in enumerate(METHODS)]


def _picture(rows, folder):
    panels = [Panel(f"{shape}: turned wrong, median, rad", "step, ms", "", _series(rows, shape, _ms, _median),
                    x_range=(0.1, 20)) for shape in _shapes(rows)]
    panels += [Panel(f"{shape}: the same against cost", "time of a second over one plain segment distance", "",
                     _series(rows, shape, _time, _median)) for shape in _shapes(rows)]
    return draw(folder, "flight", "A second of free flight, three unlike moments", panels, columns=3)


def _order(rows, shape, method):
    low, high = ORDER_STEPS_US
    return slope([(_ms(row), row["worst_turn_rad"]) for row in _of(rows, shape, method)
                  if row["flights"] and low <= float(row["step_us"]) <= high])


def _order_table(rows):
    lines = [[", ".join(method)] + [number(_order(rows, shape, method)) for shape in _shapes(rows)]
             for method in METHODS if method[1] == "double"]
    return table([f"order, steps of {ORDER_STEPS_US[0] / 1000:g} to {ORDER_STEPS_US[1] / 1000:g} ms", *_shapes(rows)], lines)


HEADER = ["body", "method, scalar", "step, ms", "flights", "held", "turned wrong, median, rad", "largest", "energy, largest error",
          "time of a second"]


def _line(shape, method, row):
    start = [shape, ", ".join(method), f"{_ms(row):g}", str(row["flights"]), str(row["held"])]
    if not row["flights"]:
        return start + ["-"] * (len(HEADER) - len(start))
    return start + [number(row["turn_rad"].quantile(0.5)), number(row["worst_turn_rad"]), percent(row["worst_energy_share"]),
                    thousands(_time(row))]


def _table(rows, methods):
    return table(HEADER, [_line(shape, method, row) for shape in _shapes(rows) for method in methods
                          for row in _of(rows, shape, method)])


TEXT = """A body of revolution flies exactly, whatever the step (src/mechanics/motion.md). A body with three unlike moments does not: each step
is a product of turns about its axes, of fourth order. Here such bodies turn freely for a second at 8 to 12 rad/s, in a world of their own, and
their orientation at the end is held against Euler's equations, integrated in long double by Runge and Kutta's method in steps of 20 µs
(`euler_reference.cpp`, itself held against Jacobi's elliptic functions). *Brick* and *plank* turn about any axis; *racket* about its
middle axis, but for a hundredth, so that it tumbles. *Velocity held*: the angular velocity of the beginning is held over the step,
as engines do that leave the gyroscopic term out: what the turns buy.

- *Turned wrong*: the angle between the orientation and the true one, after a second.
- *Held*: flights in which a step would have turned the body by half a turn or more. The world keeps such a body where it is, and counts it;
  these flights have no error here, and settings with such flights no point in the picture.
- *Energy*: of the turning, as a share of the first. What is left of its error is rounding; the angular momentum is exact.
- *Time*: of a simulated second, in thousands of plain segment-segment distances in double.

**In double the error is of fourth order in the step, down to rounding. In float there is a best step**: shorter ones round more often than the
method gains.
"""


def _best_sentence(rows):
    """The step of the least median error in float, for each shape."""
    best = []
    for shape in _shapes(rows):
        whole = [row for row in _of(rows, shape, ("batuta", "float")) if row["flights"] and not row["held"]]
        if whole:
            least = min(whole, key=_median)
            best.append(f"{_ms(least):g} ms for the {shape} (at {_ms(whole[0]):g} ms: {number(_median(whole[0]) / _median(least))} times the error)")
    return "In float the best step is " + ", ".join(best) + ".\n"


def page(tables, folder):
    rows = tables["flight"]
    return "".join([TEXT, _best_sentence(rows), "\n", _picture(rows, folder), "\n", _order_table(rows), "\n", _table(rows, METHODS),
                    "\nData: [flight.csv](flight.csv)\n"])


def blocks(tables):
    """What docs/error.md shows: the picture and the library's rows."""
    rows = tables["flight"]
    return {"flight": shown("flight", "A second of free flight, three unlike moments") + _order_table(rows) + "\n"
                      + _best_sentence(rows) + "\n" + _table(rows, METHODS[:2])}
