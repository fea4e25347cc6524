# SPDX-License-Identifier: MIT
"""Haptics: where a simulated stick shakes, and what the passivity controller does about it."""

from markdown import number, table
from plot import Panel, Series, draw

TITLE = "Haptics: how stiff a stick may be"
FILES = ["haptics_onset", "haptics_hands", "haptics_encoder", "haptics_energy"]


def _values(rows, key):
    """What a key is in these rows, in their order."""
    return list(dict.fromkeys(row[key] for row in rows.rows))


def _of_bound(value):
    return "-" if value is None else f"{value:.4f}"


ONSET_HEADER = ["period, ms", "device damping b", "mass", "bound 2 b / T", "onset in time", "by spectral radius", "over the bound"]


def _onset_table(rows):
    return table(ONSET_HEADER, [
        [row["period_ms"], row["damping"], row["mass"], number(row["bound"]), number(row["in_time"] * row["bound"]),
         number(row["by_radius"] * row["bound"]), _of_bound(row["in_time"])] for row in rows.rows])


def _onset_summary(rows):
    seen = [row[way] for row in rows.rows for way in ("in_time", "by_radius")]
    return f"All onsets lie between {min(seen):.4f} and {max(seen):.4f} of the bound.\n"


def _onset_panel(rows):
    series = []
    for look, damping in enumerate(_values(rows, "damping")):
        chosen = rows.where(damping=damping)
        lines = {float(row["period_ms"]): row["bound"] for row in chosen.rows}
        points = [(float(row["period_ms"]), row["in_time"] * row["bound"]) for row in chosen.rows]
        series.append(Series("bound of the advisor", sorted(lines.items()), look, marks=False))
        series.append(Series(f"onset, b = {damping}", points, look, lines=False))
    return Panel("a stick without a hand", "period, ms", "stiffness, N/m", series)


def _hand_panel(rows):
    series = [Series("bound of the advisor", [(0, 1), (0.8, 1)], 6, marks=False)]
    for look, delay in enumerate(_values(rows, "delay")):
        for hand, name in (("mass", "masses on springs"), ("line", "elastic line")):
            points = [(float(row["damper"]), row[hand]) for row in rows.where(delay=delay).rows if row[hand] is not None]
            series.append(Series(f"{name}, delay {delay}", points, look, dashed=hand == "mass"))
    return Panel("the worst hands", "virtual damper B over b", "onset over the bound", series, logs="y", y_range=(0.8, 12))


HAND_HEADER = ["delay, periods", "B over b", "bound on K", "worst of the masses on springs, over the bound", "elastic line, over the bound"]


def _hand_table(rows):
    shown = [row for row in rows.rows if row["damper"] in ("0", "0.2", "0.4", "0.6")]
    return table(HAND_HEADER, [[row["delay"], row["damper"], number(row["bound"]), _of_bound(row["mass"]), _of_bound(row["line"])]
                               for row in shown])


def _encoder_table(rows):
    periods = _values(rows, "period_ms")
    lines = [[share] + [number(rows.where(of_bound=share, period_ms=period).rows[0]["steps_per_second"]) for period in periods]
             for share in _values(rows, "of_bound")]
    return table(["stiffness over 2 f_c / Delta"] + [f"T = {period} ms" for period in periods], lines)


def _energy_panel(rows, controller):
    series = []
    for look, share in enumerate(_values(rows, "of_bound")):
        chosen = rows.where(of_bound=share, controller=controller)
        points = [(float(row["time"]), row["energy"]) for row in chosen.rows if row["energy"]]
        series.append(Series(f"{share} of the bound", points, look, marks=False))
    return Panel(f"controller {controller}", "s", "energy of stick and hand over the first", series, logs="y",
                 x_range=(0, None), y_range=(0.01, 1e4))


def _energy_table(rows):
    lines = []
    for share in _values(rows, "of_bound"):
        cells = [share]
        for controller in _values(rows, "controller"):
            chosen = rows.where(of_bound=share, controller=controller).rows
            most = "above 10^4" if any(row["energy"] is None for row in chosen) else f"{max(row['energy'] for row in chosen):.3f}"
            said = controller != "off" and any(row["cannot"] for row in chosen)
            cells.append(most + (", said that it cannot" if said else ""))
        lines.append(cells)
    return table(["stiffness over the bound", *(f"most energy, controller {name}" for name in _values(rows, "controller"))], lines)


TEXT = """A spring and a damper are sampled, and their force is held on a simulated stick (`port/shared/simulated`: exact between samples). The bound is
that of the gain advisor, K T (n + 1/2) + |B| <= b (`src/haptics/gain_advisor.md`), which holds for whatever passive hand. Onsets are found by bisection, in
simulated time by the growth of the stored energy, and independently as the place where the spectral radius of the exact discrete system passes 1.
"""

HAND_TEXT = """
### Dampers, delays and the worst hand

b = 0.8, T = 1 ms. Masses from 10 g to 10 kg on springs from none to half a swing in a period: the lowest onset. A mass alone likes a damper, and is stable well beyond the bound; the
bound is for the worst hand, an elastic line whose echo comes back turned round after n + 1 periods. None shakes below the bound (1, but for the resolution of the search, 2e-3). With
spring, damper *and* delay the bound is more careful than these hands need.
"""

ENCODER_TEXT = """
### Encoder and Coulomb friction

A stick that is at rest between two steps of its encoder, far below the bound of sampling: how many steps a second it still goes, back and forth, after a while.
Faster sampling does not move the bound. The ways are short, for they end when the encoder tells; what a hand feels is the force, which changes by K Delta at each.
"""

ENERGY_TEXT = """
### The passivity controller

A hand of half a kilogram swings. Energy is the plant's own book, not the observer's. The controller's damper is as large as the device's (more is not passive by itself), so it can hold up to
twice the bound; beyond, it says that it cannot. *Untold*: it does not know what the spring stores, and acts later.
"""


def page(tables, folder):
    onset, hands = tables["haptics_onset"], tables["haptics_hands"]
    energy = tables["haptics_energy"]
    energies = [_energy_panel(energy, controller) for controller in ("off", "on")]
    return "".join([
        TEXT, "\n", _onset_summary(onset), "\n",
        draw(folder, "haptics_onset", "Onset of shaking against the bound", [_onset_panel(onset), _hand_panel(hands)]), "\n",
        _onset_table(onset), HAND_TEXT, "\n", _hand_table(hands), ENCODER_TEXT, "\n", _encoder_table(tables["haptics_encoder"]),
        ENERGY_TEXT, "\n", draw(folder, "haptics_energy", "Energy of a hand on a spring that is too stiff", energies), "\n",
        _energy_table(energy), "\nData: ", ", ".join(f"[{name}.csv]({name}.csv)" for name in FILES), "\n"])
