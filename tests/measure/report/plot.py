# SPDX-License-Identifier: MIT
"""Pictures by gnuplot: a picture is a file .gp that holds its data, and the .svg drawn from it."""

import math
import pathlib
import shutil
import subprocess

# Okabe and Ito's colours, which people with any colour vision can tell apart, each with a mark of its own.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000", "#8C6D31"]
MARKS = [7, 5, 9, 13, 11, 15, 4, 6]
PANEL = (470, 400)
KEY_HEIGHT = 60
SHORT_DECADES = (-3, 5)  # numbers from 0.001 to 100000 are written out along x
MOST_LABELS = 8  # along a logarithmic axis


class Series:
    """Points (x, y) under a label; `look` picks colour and mark, the same number the same look in every picture."""

    def __init__(self, label, points, look, lines=True, dashed=False, marks=True):
        self.label, self.points, self.look = label, points, look
        self.lines, self.dashed, self.marks = lines, dashed, marks

    def style(self):
        look = self.look % len(COLOURS)
        kind = ("linespoints" if self.marks else "lines") if self.lines else "points"
        marks = f" pt {MARKS[look]} ps 0.7" if kind != "lines" else ""
        dash = " dt 2" if self.dashed and self.lines else ""
        return f"with {kind} lc rgb '{COLOURS[look]}'{marks}" + (f" lw 2{dash}" if self.lines else "")


# A panel whose values are all zero, which logarithms do not show. Without ranges gnuplot refuses to draw nothing.
EMPTY = ["set xrange [1:10]; set yrange [1:10]", "set label 1 'all zero' at graph 0.5,0.5 center", "plot NaN notitle",
         "unset label 1"]


class Panel:
    """One pair of axes."""

    def __init__(self, title, x, y, series, logs="xy", x_range=None, y_range=None):
        self.title, self.x, self.y, self.series = title, x, y, [s for s in series if s.points]
        self.logs, self.x_range, self.y_range = logs, x_range, y_range

    def lines(self, number):
        out = [f"set title '{_quoted(self.title)}'",
               f"set xlabel '{_quoted(self.x)}'", f"set ylabel '{_quoted(self.y)}'"]
        out.append("unset logscale")
        for axis in self.logs:
            out.append(f"set logscale {axis}")
        for place, (axis, span) in enumerate((("x", self.x_range), ("y", self.y_range))):
            out.append(f"set {axis}range [{':'.join(_or_star(v) for v in span or (None, None))}]")
            form, tics = self._tics(place, axis, span or (None, None))
            out += [f"set format {axis} '{form}'", f"set {axis}tics {tics}"]
        plots = [f"$p{number}_{i} {s.style()} notitle" for i, s in enumerate(self.series)]
        return out + (["plot " + ", \\\n     ".join(plots)] if plots else EMPTY)


    def _tics(self, place, axis, span):
        """Format and distance of an axis' labels, so that none touches its neighbour."""
        values = [point[place] for series in self.series for point in series.points] + [v for v in span if v is not None]
        logs = [math.log10(value) for value in values if value > 0]
        if axis not in self.logs or not logs:
            return "%g", "autofreq"
        short = axis == "x" and min(logs) >= SHORT_DECADES[0] and max(logs) <= SHORT_DECADES[1]
        decades = -(-(max(logs) - min(logs)) // MOST_LABELS)
        return "%g" if short else "10^{%L}", f"{10 ** int(decades)}" if decades > 1 else "autofreq"


def _or_star(value):
    return "*" if value is None else f"{value:.10g}"


def _quoted(text):
    return text.replace("'", "''")


def _data(panels):
    for number, panel in enumerate(panels):
        for i, series in enumerate(panel.series):
            yield f"$p{number}_{i} << EOD"
            yield from (f"{x:.6g} {y:.6g}" for x, y in series.points)
            yield "EOD"


def _legend(panels):
    """Every label once, over the whole picture."""
    seen = {}
    for panel in panels:
        for series in panel.series:
            seen.setdefault(series.label, series)
    return list(seen.values())


def _script(title, panels, columns):
    rows = -(-len(panels) // columns)
    width, height = PANEL[0] * columns, PANEL[1] * rows + KEY_HEIGHT + 40
    top = 1 - (KEY_HEIGHT + 40) / height
    yield "# SPDX-License-Identifier: MIT"
    yield f"set terminal svg size {width},{height} font 'sans-serif,13' background '#ffffff' enhanced"
    yield "set encoding utf8"
    yield from _data(panels)
    yield "set grid back lc rgb '#dddddd' lw 1"
    yield "set border 3 lc rgb '#444444'"
    yield "set tics nomirror"
    yield f"set multiplot title '{_quoted(title)}' font 'sans-serif,16'"
    yield from _key_lines(panels, height)
    yield "unset key"
    for number, panel in enumerate(panels):
        row, column = divmod(number, columns)
        yield f"set origin {column / columns:.5f},{top * (1 - (row + 1) / rows):.5f}"
        yield f"set size {1 / columns:.5f},{top / rows:.5f}"
        yield from panel.lines(number)
    yield "unset multiplot"


def _key_lines(panels, height):
    """A plot without axes whose key is the legend of the picture."""
    yield "set origin 0,0"
    yield "set size 1,1"
    yield f"set key at screen 0.5,{1 - 36 / height:.5f} center top horizontal samplen 3 width 1 maxrows 3"
    yield "unset border; unset tics; unset xlabel; unset ylabel; unset grid; unset title"
    yield "set xrange [0:1]; set yrange [0:1]"
    entries = [f"NaN {s.style()} title '{_quoted(s.label)}'" for s in _legend(panels)]
    yield "plot " + ", \\\n     ".join(entries or ["NaN notitle"])
    yield "set border 3 lc rgb '#444444'; set tics nomirror; set grid back lc rgb '#dddddd' lw 1"


def draw(folder, name, title, panels, columns=2):
    """Writes name.gp and, if gnuplot is there, name.svg. Returns the Markdown that shows it."""
    folder = pathlib.Path(folder)
    script = folder / f"{name}.gp"
    script.write_text("\n".join(_script(title, panels, min(columns, len(panels)))) + "\n")
    gnuplot = shutil.which("gnuplot")
    if gnuplot is None:
        return f"*gnuplot is not there: `{script.name}` was not drawn.*\n"
    with open(folder / f"{name}.svg", "w") as svg:
        subprocess.run([gnuplot, script.name], check=True, cwd=folder, stdout=svg)
    return f"![{title}]({name}.svg)\n"
