# SPDX-License-Identifier: MIT
"""The whole simulation: one beat and one phrase against the length of the step."""

from fit import slope
from markdown import number, percent, shown, table, times
from plot import Panel, Series, draw

TITLE = "The whole simulation: error against the length of a step"
FILES = ["simulation_beat", "simulation_phrase", "simulation_runs", "simulation_blows"]

PLAYS = [("advancement", "double"), ("advancement", "float"), ("stepping", "double"), ("stepping", "float")]
ERRORS = [("contact_s", "instant of the contact, s"), ("impulse_share", "impulse, share"), ("tip_m", "place of a tip, m")]
ORDER_STEPS_US = (200, 4000)  # over which the order is fitted: below, float and contact tolerance show; above, a step is a tenth of the beat
PARTED_M = 0.01
CLOSE_M = 0.001
SAME_BLOW_S = 0.003  # a quarter of the time between the blows of a close exchange
LEAST_M = 1e-9  # a zero on a logarithmic axis
BEAT_S = 0.1


def _steps(rows):
    return sorted({row["step_us"] for row in rows.rows}, key=float)


def _ms(step_us):
    return float(step_us) / 1000


def _of_play(rows, play, **keys):
    return rows.where(search=play[0], scalar=play[1], **keys)


def _label(play):
    return f"{play[0]}, {play[1]}"


# One beat.

def _beat_rows(rows, play):
    return sorted((row for row in _of_play(rows, play).rows if row["tip_m"].count), key=lambda row: float(row["step_us"]))


def _beat_time(row):
    """Host time of a simulated second."""
    time = row["time_in_plain"].quantile(0.5)
    return time / BEAT_S if time else None


def _beat_series(rows, x, y, dashed=False):
    return [Series(_label(play), [(x(row), y(row)) for row in _beat_rows(rows, play) if y(row)], look, dashed=dashed and look % 2 == 1)
            for look, play in enumerate(PLAYS)]


def _guide(rows, name, order):
    """A line of this order through the middle of the points in double."""
    points = [(_ms(row["step_us"]), row[f"worst_{name}"]) for row in _beat_rows(rows, PLAYS[0])]
    if not points:
        return Series("", [], 6)
    middle = points[len(points) // 2]
    return Series("first order" if order == 1 else "second order",
                  [(x, middle[1] * (x / middle[0]) ** order) for x, _ in points], 6 if order == 1 else 7, marks=False, dashed=True)


def _span(rows):
    """Of the axis of steps, ms."""
    steps = [_ms(step) for step in _steps(rows)]
    return min(steps), max(steps)


def _beat_picture(rows, folder):
    orders = {"contact_s": 2, "impulse_share": 1, "tip_m": 1}
    span = _span(rows)
    panels = [Panel(f"largest error: {title}", "step, ms", "",
                    _beat_series(rows, lambda row: _ms(row["step_us"]), lambda row, name=name: row[f"worst_{name}"])
                    + [_guide(rows, name, orders[name])], x_range=span) for name, title in ERRORS]
    panels.append(Panel("largest error of a tip, m, against cost", "host time of a second over one plain segment distance", "",
                        _beat_series(rows, _beat_time, lambda row: row["worst_tip_m"])))
    return draw(folder, "simulation_beat", "One beat: error against the length of the step", panels)


def _beat_order(rows, play, name):
    low, high = ORDER_STEPS_US
    return slope([(_ms(row["step_us"]), row[f"worst_{name}"]) for row in _beat_rows(rows, play)
                  if low <= float(row["step_us"]) <= high])


def _order_table(rows):
    lines = [[_label(play)] + [number(_beat_order(rows, play, name)) for name, _ in ERRORS] for play in PLAYS if play[1] == "double"]
    return table(["order, by the largest error", *(title.rpartition(",")[0] or title for _, title in ERRORS)], lines)


BEAT_HEADER = ["search, scalar", "step, ms", "beats", "not one contact", "contact, median, µs", "largest", "impulse, median", "largest",
               "tip, median, µm", "largest", "evaluations of a beat", "time of a second"]


def thousands(value):
    """A time that is many plain distances long, in thousands of them."""
    return "-" if value is None else times(value / 1000)


def _beat_line(play, row):
    return [_label(play), f"{_ms(row['step_us']):g}", str(row["beats"]), str(row["others"]),
            number(1e6 * row["contact_s"].quantile(0.5)), number(1e6 * row["worst_contact_s"]),
            percent(row["impulse_share"].quantile(0.5)), percent(row["worst_impulse_share"]),
            number(1e6 * row["tip_m"].quantile(0.5)), number(1e6 * row["worst_tip_m"]), number(row["evaluations"] / row["beats"]),
            thousands(_beat_time(row))]


def _beat_table(rows, plays):
    return table(BEAT_HEADER, [_beat_line(play, row) for play in plays for row in _beat_rows(rows, play)])


# A phrase.

def _curve(rows, play, step_us):
    """[(s, m)] of the larger distance of the two tips from the reference."""
    chosen = _of_play(rows, play, step_us=step_us).rows
    return sorted((float(row["at_ms"]) / 1000, row["tip_m"]) for row in chosen if row["tip_m"] is not None)


def _drawn(label, curve, look):
    return Series(label, [(t, max(error, LEAST_M)) for t, error in curve], look, marks=False)


def _blow_marks(blows):
    return Series("blows at the shortest step", [(t, 2 * LEAST_M) for t, _ in blows], 6, lines=False)


def _phrase_picture(tables, folder):
    rows, blows = tables["simulation_phrase"], tables["simulation_blows"]
    steps = _steps(rows)
    panels = [Panel(_label(play), "s", "distance of a tip from the reference, m",
                    [_drawn(f"step {_ms(step):g} ms", _curve(rows, play, step), look) for look, step in enumerate(steps)]
                    + [_blow_marks(_blows(blows, play, steps[0]))],
                    logs="y", y_range=(LEAST_M, 1)) for play in PLAYS]
    return draw(folder, "simulation_phrase", "One phrase: how far a tip is from where it should be", panels)


def _first_above(curve, limit):
    return next((t for t, error in curve if error > limit), None)


def _share_above(curve, limit):
    return sum(error > limit for _, error in curve) / len(curve)


def _until(curve, limit):
    above = _first_above(curve, limit)
    return "to the end" if above is None else f"{above:.2f}"


PHRASE_HEADER = ["search, scalar", "step, ms", "within 1 mm until, s", "within 1 cm until, s", "of the time beyond 1 cm", "median, mm",
                 "largest, mm", "blows", "evaluations a second", "time of a second"]


def _phrase_line(tables, play, row):
    curve = _curve(tables["simulation_phrase"], play, row["step_us"])
    if not curve:
        return None
    errors = sorted(error for _, error in curve)
    seconds = curve[-1][0]
    return [_label(play), f"{_ms(row['step_us']):g}", _until(curve, CLOSE_M), _until(curve, PARTED_M),
            percent(_share_above(curve, PARTED_M)), number(1000 * errors[len(errors) // 2]), number(1000 * errors[-1]),
            str(row["blows"]), number(row["evaluations"] / seconds), thousands(row["time_in_plain"] / seconds)]


def _phrase_table(tables, plays):
    lines = [_phrase_line(tables, play, row) for play in plays
             for row in sorted(_of_play(tables["simulation_runs"], play).rows, key=lambda row: float(row["step_us"]))]
    return table(PHRASE_HEADER, [line for line in lines if line])


def _blows(rows, play, step_us):
    """[(s, N s)] in order."""
    chosen = sorted(_of_play(rows, play, step_us=step_us).rows, key=lambda row: float(row["number"]))
    return [(row["at_s"], row["impulse"]) for row in chosen if row["at_s"] is not None]


def _parting(a, b):
    """Of two plays, how many blows from the first on are the same, and the instant of the first that is not."""
    for place, (one, other) in enumerate(zip(a, b)):
        if abs(one[0] - other[0]) > SAME_BLOW_S:
            return place, min(one[0], other[0])
    same = min(len(a), len(b))
    more = (a if len(a) > len(b) else b)[same:]
    return same, more[0][0] if more else None


def _blow_table(rows, play, steps, shown_blows=10):
    columns = [_blows(rows, play, step) for step in steps]
    lines = []
    for place in range(shown_blows):
        cells = [f"{blows[place][0]:.4f} s, {blows[place][1]:.3f} N s" if place < len(blows) else "-" for blows in columns]
        lines.append([str(place + 1)] + cells)
    return table(["blow"] + [f"step {_ms(step):g} ms" for step in steps], [line for line in lines if any(c != "-" for c in line[1:])])


def _parting_lines(tables):
    """Steps of neighbouring lengths: up to where they tell the same story."""
    blows, steps = tables["simulation_blows"], _steps(tables["simulation_blows"])
    for short, long in zip(steps, steps[1:]):
        cells = []
        for play in PLAYS:
            same, at = _parting(_blows(blows, play, short), _blows(blows, play, long))
            cells.append(f"{same}" + (f", then not at {at:.3f} s" if at is not None else ""))
        yield [f"{_ms(short):g} and {_ms(long):g}", *cells]


def _parting_table(tables):
    return table([f"blows that are the same, to {1000 * SAME_BLOW_S:g} ms, at steps of ... ms", *map(_label, PLAYS)], list(_parting_lines(tables)))


CONVERGENCE_TIMES = 3  # marks after the first blow that the table of convergence shows


def _convergence_table(tables):
    """Richardson's check: error at twice, four, ten times the shortest step."""
    rows, steps = tables["simulation_phrase"], _steps(tables["simulation_phrase"])
    first = _blows(tables["simulation_blows"], PLAYS[0], steps[0])
    curves = [dict(_curve(rows, PLAYS[0], step)) for step in steps]
    begin = first[0][0] if first else 0
    marks = [t for t in sorted(curves[0]) if t > begin][1:1 + CONVERGENCE_TIMES]
    lines = [[f"{t:.2f}"] + [number(1e6 * curve[t]) for curve in curves[:4]] + [number(slope(_errors_at(curves, steps, t)))]
             for t in marks]
    return table(["s", *(f"step {_ms(step):g} ms: off by, µm" for step in steps[:4]), "order"], lines)


def _errors_at(curves, steps, t):
    return [(_ms(step), curve[t]) for step, curve in list(zip(steps, curves))[:4]]


BEAT_TEXT = """### One beat converges

The left fencer's stick goes out to the left and back, the right fencer keeps the guard, and the blades meet once; the beat ends after
0.1 s, while both grips regain their blades. The beats differ in how far the stick goes, so that the contact comes at
different places within a step. The sticks report every 20 ms, so that all steps are told the same. The truth knows no steps: the instant
of contact, the impulse, the flight and the hand that takes the blade back are computed from the equations in long double
(`beat_truth.cpp`); only the fencers' data, the surface through the key poses and the mass of a weapon come from the library.
Errors: of the instant of contact; of the impulse, as a share; of the place of a tip at 80 and 100 ms, the larger of the two blades'.
"""

BEAT_ORDERS = """
**The instant of contact is of second order in the step, the impulse and all that follows from it of first order.** Over a step a
blade moves with the constant twist between its poses at both ends. Such a chord is off the hand's way by a second order, but its velocity
is the mean over the step, not that of the instant of contact: a first order, and the impulse is proportional to it. The orders below
are fitted to the largest errors in double, steps of {low:g} to {high:g} ms. In float, Advancement stops ahead of the contact by its
contact tolerance, which is raised to what float can resolve: at short steps that is its error in the instant.
"""

PHRASE_TEXT = """
### One phrase bifurcates

The recording that comes with the program against the script that parries, {seconds:g} s, as `batuta-duel` plays them. Sticks report every
4 ms and every 1 ms, a step sees the latest report, and a stick is one report or one step late, whichever is longer. Steps that are
longer than a report, or no whole part of it (0.4 ms), err by that alone, also before any contact. The reference is double with Advancement at the two
shortest steps, extrapolated to none (Richardson): its own error is about what the table tells of the shortest step.

**A phrase does not converge as a whole, and no step is short enough to make it.** Small errors decide whether blades that nearly meet do
meet, and from such a blow on there are two stories, both of them right. What does converge is the time up to there. Then the hands take
hold of their blades again and forget: the stories come together until the next exchange. (What is below 1 nm is drawn at 1 nm: there, plays differ by rounding.) So the error of a phrase is not a number that
falls with the step, and a replay on another step length is another bout; on the same step length it is the same bit for bit.
"""

CONVERGENCE_TEXT = """
Just after the first blow the plays in double still converge, as the beat does. With the extrapolated reference, the errors of the two
shortest steps are in the ratio 1 : 2 by construction; the others are the check:

"""


def _parted_sentence(tables):
    """Where even the two shortest steps part, in words."""
    steps = _steps(tables["simulation_blows"])
    play = PLAYS[0]
    finest = _blows(tables["simulation_blows"], play, steps[0])
    same, at = _parting(finest, _blows(tables["simulation_blows"], play, steps[1]))
    curve = _curve(tables["simulation_phrase"], play, steps[1])
    above = _first_above(curve, PARTED_M)
    told = f"In double with Advancement, steps of {_ms(steps[0]):g} and {_ms(steps[1]):g} ms give the same {same} blows first"
    told += f", but not the one at {at:.3f} s" if at is not None else ""
    told += f"; their tips are more than 1 cm apart from {above:.2f} s on" if above is not None else "; their tips stay within 1 cm"
    return told + ".\n"


def _phrase_text(tables):
    curve = _curve(tables["simulation_phrase"], PLAYS[0], _steps(tables["simulation_phrase"])[0])
    return PHRASE_TEXT.format(seconds=curve[-1][0] if curve else 0)


def _orders_text():
    return BEAT_ORDERS.format(low=_ms(ORDER_STEPS_US[0]), high=_ms(ORDER_STEPS_US[1]))


COST_TEXT = """Times are those of a simulated second, in thousands of plain segment-segment distances in double; evaluations are distance
evaluations of all searches.

"""


def page(tables, folder):
    beat, blows = tables["simulation_beat"], tables["simulation_blows"]
    parts = [BEAT_TEXT, "\n", _beat_picture(beat, folder), _orders_text(), "\n", _order_table(beat), "\n", COST_TEXT,
             _beat_table(beat, PLAYS), "\nData: [simulation_beat.csv](simulation_beat.csv)\n"]
    parts += [_phrase_text(tables), "\n", _parted_sentence(tables), "\n", _phrase_picture(tables, folder), "\n"]
    parts += [_parting_table(tables), CONVERGENCE_TEXT, _convergence_table(tables), "\n", COST_TEXT, _phrase_table(tables, PLAYS)]
    for play in PLAYS[:2]:
        parts += [f"\nThe first blows, {_label(play)}:\n\n", _blow_table(blows, play, _steps(blows)[:5])]
    parts += ["\nData: [simulation_phrase.csv](simulation_phrase.csv), [simulation_runs.csv](simulation_runs.csv), "
              "[simulation_blows.csv](simulation_blows.csv)\n"]
    return "".join(parts)


def blocks(tables):
    """What docs/error.md shows: both pictures, the default search in both scalars."""
    beat, plays = tables["simulation_beat"], [play for play in PLAYS if play[0] == "advancement"]
    return {"beat": shown("simulation_beat", "One beat: error against the length of the step") + _order_table(beat) + "\n"
                    + _beat_table(beat, plays),
            "phrase": shown("simulation_phrase", "One phrase: how far a tip is from where it should be")
                      + _parted_sentence(tables) + "\n" + _parting_table(tables) + "\n" + _phrase_table(tables, plays)}
