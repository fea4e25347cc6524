# SPDX-License-Identifier: MIT
"""batuta beside Bullet, FCL and ODE on the same queries."""

from markdown import number, share, table, times
from plot import Panel, Series, draw

TITLE = "Side by side with Bullet, FCL and ODE"
FILES = ["peers"]

# Label and name in the data; the place gives the look.
PEERS = [
    ("batuta advancement, double", "advancement_double"),
    ("batuta advancement, float", "advancement_float"),
    ("batuta stepping, double", "stepping_double"),
    ("Bullet, one call", "bullet"),
    ("Bullet, one call per 44°", "bullet_divided"),
    ("FCL", "fcl"),
    ("ODE, 16 steps", "ode"),
]
ONLY_STILL = [  # where nothing turns, besides
    ("batuta translation, double", "translation_double"),
    ("batuta translation, float", "translation_float"),
    ("Bullet, sub-simplex cast", "bullet_subsimplex"),
]
STILL = ["translation", "sphere"]  # families in which nothing turns
ABSOLUTE = ["scaled"]  # not in the main picture: an engine whose contact is 1 mm says little about scenes of micrometres
LEAST_SHARE = 1e-6  # a zero on a logarithmic axis
LEAST_ERROR = 1e-12


def _asked(rows):
    return rows.where(status="asked")


def _families(rows):
    return list(dict.fromkeys(row["family"] for row in _asked(rows).rows))


def _error(row, at):
    return row["early"].plus(row["late"]).quantile(at)


def _unsafe(row, depth):
    """Contacts of at least this depth that were answered with "none", or with an instant after it was reached."""
    return row[f"missed_{depth}"] + row[f"late_{depth}"]


def _unsafe_share(row, depth):
    return max(_unsafe(row, depth) / row[depth], LEAST_SHARE) if row[depth] else None


def _ratio(row, at=0.5):
    return row["time_ratio"].quantile(at)


def _dots(rows, y):
    """One dot a peer, over the families together."""
    merged = rows.merged(by=["peer"])
    series = []
    for look, (label, name) in enumerate(PEERS):
        points = [(_ratio(row), y(row)) for row in merged.where(peer=name).rows if row["queries"]]
        series.append(Series(label, [p for p in points if None not in p], look, lines=False))
    return series


def _main_picture(rows, folder):
    turning = type(rows)(rows.kinds, [row for row in _asked(rows).rows if row["family"] not in STILL + ABSOLUTE])
    x = "time over one plain segment distance, median"
    error = _dots(turning, lambda row: max(_error(row, 0.99) or 0, LEAST_ERROR))
    unsafe = _dots(turning, lambda row: _unsafe_share(row, "touching"))
    panels = [
        Panel("error", x, "99 % error of the time of contact", error),
        Panel("safety (none: at the bottom)", x, "share of contacts missed or late", unsafe),
    ]
    return draw(folder, "peers", "Error and safety against cost, families that turn, in metres", panels)


def _time_picture(rows, folder):
    """Families along x, by their number in the tables."""
    families = _families(rows)
    panels = []
    for at, title in ((0.5, "median"), (0.99, "99 %")):
        series = []
        for look, (label, name) in enumerate(PEERS):
            found = {row["family"]: row for row in _asked(rows).where(peer=name).rows}
            points = [(i, _ratio(found[f], at)) for i, f in enumerate(families, 1) if f in found]
            series.append(Series(label, [p for p in points if p[1]], look))
        panels.append(Panel(title, "family (number in the tables below)", "time over one plain segment distance", series, logs="y"))
    return draw(folder, "peers_time", "Time of a query by family", panels)


HEADER = ["peer", "missed deeper than 1e-3 S", "late", "missed deeper than 1e-6 S", "late", "false by 1e-3 S", "by 1e-5 S",
          "gave up", "error: median", "99 %", "time: median", "99 %", "blocks of heap per query"]


def _cells(label, row):
    seen = [f"{row[kind + '_' + depth]} of {row[depth]}" for depth in ("deep", "touching") for kind in ("missed", "late")]
    return [label] + seen + [
        str(row["false_far"]), str(row["false_near"]), share(row["gave_up"], row["queries"]),
        number(_error(row, 0.5)), number(_error(row, 0.99)), times(_ratio(row)), times(_ratio(row, 0.99)),
        number(row["allocations"] / row["queries"] if row["queries"] else None)]


def _tables(rows):
    for index, family in enumerate(_families(rows), 1):
        chosen = _asked(rows).where(family=family)
        lines = [_cells(label, row) for label, name in PEERS + ONLY_STILL for row in chosen.where(peer=name).rows]
        first = chosen.rows[0]
        yield f"\n#### {index}. {family.replace('_', ' ')}\n\n"
        yield f"{first['queries']} queries; left out: {first['touching_at_start']} that touch at the start, "
        yield f"{first['truth_unknown']} whose truth the reference could not tell.\n\n"
        yield table(HEADER, lines)


def _speed_table(rows):
    """How many times the library's time the others take."""
    header = ["family", "Bullet: median", "99 %", "Bullet in pieces: median", "99 %", "FCL: median", "99 %"]
    lines = []
    for family in _families(rows):
        found = {row["peer"]: row for row in _asked(rows).where(family=family).rows}
        own = found["translation_float" if family in STILL else "advancement_float"]
        cells = [family.replace("_", " ")]
        for name in ("bullet", "bullet_divided", "fcl"):
            cells += [_over(found.get(name), own, at) for at in (0.5, 0.99)]
        lines.append(cells)
    return table(header, lines)


def _over(row, own, at):
    if row is None or not _ratio(row, at) or not _ratio(own, at):
        return times(None)
    return times(_ratio(row, at) / _ratio(own, at))


def _settings(rows):
    lines = [[label, row["setting"]] for label, name in PEERS + ONLY_STILL for row in _asked(rows).merged(
        by=["peer", "setting"]).where(peer=name).rows]
    lines += [[row["peer"], f"skipped: {row['setting']}"] for row in rows.where(status="skipped").rows]
    return table(["peer", "as it was asked"], lines)


TEXT = """Every engine gets the same capsules, poses and velocities, turning about the centre of mass, through a small
adapter that is itself held against known answers (`batuta_report_peers --check`). The truth is an independent reference
in double. *Missed*: a contact at least so deep, over S, the largest length in the query, was answered with "none".
*Late*: the instant that was answered lies after that depth was reached. *False*: contact was answered though the gap
stays above that part of S; Bullet's 1 mm is absolute, so small scenes show here. *Gave up*: the engine said that it does
not know, and is not counted as missed; batuta then says until when the pair is free. The error is over the length of the
step. Shapes are made before the clock starts; a time is the median of batches of one query, as a multiple of one plain
segment-segment distance in double in the same run.

Bullet integrates poses with a turn of at most 45°, so it is also asked piece by piece, as a careful caller would. Where
nothing turns, FCL's step can land on the contact to the last bit; its witnesses then stand the wrong way round and it
answers "none". ODE has no continuous collision and is asked at 17 instants."""


def page(tables, folder):
    rows = tables["peers"]
    if not _families(rows):
        return TEXT + "\n\nNothing was asked.\n"
    return "".join([TEXT, "\n\n", _settings(rows), "\n", _main_picture(rows, folder), "\n", _time_picture(rows, folder),
                    "\nTime over that of batuta in float (advancement; translation where nothing turns):\n\n",
                    _speed_table(rows), "\nData: [peers.csv](peers.csv).\n", *_tables(rows)])
