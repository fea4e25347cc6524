# SPDX-License-Identifier: MIT
"""Friction: the closed form against the iterated Newton restitution of engines."""

from markdown import number, percent, share, table, times
from plot import Panel, Series, draw

TITLE = "Friction"
FILES = ["friction_blows", "friction_map", "friction_cases", "friction_chain"]

BILLION = 1e9
WAYS = ["closed form", "Newton 4", "Newton 10", "Newton 50"]
MAP_WAYS = ["closed form", "Newton 50"]
SHOWN_FRICTION = "0.5"
SHOWN_RESTITUTION = "1"
LOWEST_ENERGY = 1e-12  # of a chain that is drawn


def _values(rows, key):
    """What a key is in these rows, in their order."""
    return list(dict.fromkeys(row[key] for row in rows.rows))


BLOW_HEADER = ["computed by", "restitution", "friction", "contacts", "that gain energy", "worst gain", "mean of the gains",
               "energy kept, mean", "error of the rebound, 99 %", "worst", "time"]


def _mean(billionths, count):
    return billionths / BILLION / count if count else None


def _blow_cells(row):
    gain = row["worst_gain"] if row["gains"] else 0
    return [row["way"], row["restitution"], row["friction"], str(row["contacts"]), share(row["gains"], row["contacts"]),
            percent(gain) if gain else "0", percent(_mean(row["gain_billionths"], row["gains"])),
            percent(_mean(row["kept_billionths"], row["contacts"]), 4), number(row["rebound_error"].quantile(0.99)),
            number(row["worst_rebound_error"]), times(row["time_in_plain"])]


def _blow_table(rows):
    return table(BLOW_HEADER, [_blow_cells(row) for row in rows.rows if row["contacts"]])


def _is_shown(row):
    return SHOWN_RESTITUTION == row["restitution"] or SHOWN_FRICTION == row["friction"]


def _closed_form_summary(rows):
    """What all contacts that the closed form answered came to."""
    total = rows.where(way=WAYS[0]).merged(by=["way"]).rows[0]
    return (f"Over all laws the closed form answered {total['contacts']} contacts; {total['gains']} of them gained energy, and "
            f"the worst change was {number(total['worst_gain'])} of the energy before.\n")


def _map_panel(rows, body, title, value, y_range):
    series = []
    for look, friction in enumerate(_values(rows, "friction")):
        for way in MAP_WAYS:
            chosen = rows.where(body=body, friction=friction, way=way)
            points = [(float(row["degrees"]), row[value]) for row in chosen.rows if row[value] is not None]
            series.append(Series(f"friction {friction}, {way}", points, look, dashed=way != WAYS[0], marks=False))
    return Panel(f"{body}: {title}", "direction of approach, degrees from the normal", "", series, logs="",
                 x_range=(-90, 90), y_range=y_range)


def _map_picture(rows, folder):
    bodies = _values(rows, "body")
    panels = [_map_panel(rows, body, "tangential over normal impulse", "tangential_over_normal", (0, 2.5)) for body in bodies]
    panels += [_map_panel(rows, body, "energy after over before", "kept", (0, 1.4)) for body in bodies]
    return draw(folder, "friction_map", "One body on the floor: sticking and sliding, restitution 1", panels)


def _span(rows):
    """From where to where a body sticks."""
    degrees = [float(row["degrees"]) for row in rows.rows if row["sticks"]]
    return f"{min(degrees):.0f} ... {max(degrees):.0f}" if degrees else "-"


def _map_table(rows):
    lines = [[f"{body}, friction {friction}"] + [_span(rows.where(body=body, friction=friction, way=way)) for way in MAP_WAYS]
             for body in _values(rows, "body") for friction in _values(rows, "friction")]
    return table(["sticks where it comes from, degrees", *MAP_WAYS], lines)


def _chain_panel(rows, friction, title, value, logs):
    series = []
    for look, way in enumerate(WAYS):
        points = [(float(row["contacts"]), value(row)) for row in rows.where(way=way, friction=friction).rows if row["rods"]]
        points = [(x, y) for x, y in points if y > LOWEST_ENERGY or "y" not in logs]
        series.append(Series(way, points, look))
    return Panel(f"friction {friction}: {title}", "contacts", "", series, logs=logs, x_range=(0, None))


def _invented(row):
    return _mean(row["invented_billionths"], row["rods"])


def _chain_picture(rows, folder):
    frictions = _values(rows, "friction")
    panels = [_chain_panel(rows, friction, "invented energy, sum of shares", _invented, "") for friction in frictions]
    panels += [_chain_panel(rows, friction, "median energy over the first", lambda row: row["energy"].quantile(0.5), "y")
               for friction in frictions]
    return draw(folder, "friction_chain", "Elastic rods in a room: energy against contacts", panels, columns=len(frictions))


CHAIN_HEADER = ["computed by", "friction", "contacts", "rods", "with more energy than at first", "most energy, of the first",
                "invented, sum of shares, mean", "most"]


def _chain_table(rows):
    """After the first contact, after ten, and at the end."""
    last = max((row["contacts"] for row in rows.rows), key=float)
    return table(CHAIN_HEADER, [
        [row["way"], row["friction"], row["contacts"], str(row["rods"]), share(row["risen"], row["rods"]),
         number(row["most_energy"], 3), number(_invented(row)), number(row["most_invented"])]
        for row in rows.rows if row["rods"] and row["contacts"] in ("1", "10", last)])


CASE_HEADER = ["case", "computed by", "energy after over before, most", "error of the rebound, most",
               "tangential over normal impulse, most"]


def _case_table(rows):
    return table(CASE_HEADER, [[row["case"], row["way"], number(row["kept"], 4), number(row["rebound_error"]),
                                number(row["tangential_over_normal"], 3)] for row in rows.rows])


TEXT = """*Closed form*: `friction_impulse` (src/response/friction.md), which a scene with friction uses; no iteration. *Newton 4, 10,
50*: what most engines do, with so many rounds: normal and tangential impulses one after the other, Newton's restitution as
the target of the normal one, friction as a clamp of each tangent. Both in double on the same contacts. A gain is more than
1e-12 of the energy before, which is above rounding. The error of the rebound is |n.v after + C n.v before| over |n.v before|: at 1 and
above, the bodies may still approach. Times are multiples of one plain segment-segment distance in double.

### Single contacts

Solid capsules of random size, slenderness, density, pose and motion, touching at random places.
"""

MAP_TEXT = """
### Sticking and sliding

A body meets the floor without turning. Where the tangential impulse is flat it slides, at the friction asked for; elsewhere it
sticks. On a ball the two agree. On a leaning rod the normal impulse moves the end sideways too; Newton's rounds stop that as well,
and gain. With much friction they jam where the slip drives the end into the floor: no normal impulse is left, so no point is drawn,
and the rod goes on into the floor. Along one of the two tangents, as here, the clamp of the rounds is the cone; between them it lets
through up to the root of 2 times the friction (the ball of the next table).
"""

CASE_TEXT = """
### Cases known for trouble

Restitution 1. Balls that slide and turn; thin rods that lean (Painlevé's), over velocities and turns to either side. Newton's rounds know no
tangential restitution, which is what turns the slip of a rubber ball round.
"""

CHAIN_TEXT = """
### A sequence of contacts

Elastic rods fly without weight between the walls of a room, so whatever their energy does a contact did. Friction takes energy
by either way, and on the whole it takes more than iteration invents; but single contacts of the iteration go on putting some back, and
what is invented adds up. *Invented*: the sum of all gains, each as a share of the energy before its contact, for nothing here has a
scale of energy: 1 is as much as the rod had.
"""


def page(tables, folder):
    blows, chain = tables["friction_blows"], tables["friction_chain"]
    (folder / "friction_all.md").write_text(f"# {TITLE}: all laws\n\n{_blow_table(blows)}")
    shown = type(blows)(blows.kinds, [row for row in blows.rows if _is_shown(row)])
    return "".join([
        TEXT, "\n", _closed_form_summary(blows), "\nRestitution 1 or friction 0.5 (all: [friction_all.md](friction_all.md), data: "
        "[friction_blows.csv](friction_blows.csv)):\n\n", _blow_table(shown),
        MAP_TEXT, "\n", _map_picture(tables["friction_map"], folder), "\n", _map_table(tables["friction_map"]), "\nData: [friction_map.csv](friction_map.csv)\n",
        CASE_TEXT, "\n", _case_table(tables["friction_cases"]),
        CHAIN_TEXT, "\n", _chain_picture(chain, folder), "\nData: [friction_chain.csv](friction_chain.csv)\n\n", _chain_table(chain)])
