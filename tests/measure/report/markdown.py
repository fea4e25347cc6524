# SPDX-License-Identifier: MIT
"""Markdown tables, and numbers as people write them."""


def table(header, lines):
    """A table; the first column is text, the others are numbers."""
    rule = ["---"] + ["---:"] * (len(header) - 1)
    return "\n".join("| " + " | ".join(cells) + " |" for cells in [header, rule, *lines]) + "\n"


def number(value, digits=2):
    """Short: 3 significant digits in the middle, a power of ten at either end."""
    if value is None:
        return "-"
    if value == 0:
        return "0"
    if 0.01 <= abs(value) < 10000:
        return f"{value:.{digits}f}".rstrip("0").rstrip(".") if abs(value) < 10 else f"{value:.0f}"
    return f"{value:.1e}"


def percent(fraction, digits=2):
    """With so many significant digits, and every digit before the point."""
    if fraction is None:
        return "-"
    value = 100 * fraction
    return f"{value:.0f} %" if abs(value) >= 10 ** (digits - 1) else f"{value:.{digits}g} %"


def share(part, whole):
    """As a percentage."""
    if not whole:
        return "-"
    return "0" if part == 0 else percent(part / whole)


def times(value):
    """A ratio of times: what differs from run to run is always written with this sign."""
    return "-" if value is None else (f"{value:.1f} ×" if value < 10 else f"{value:.0f} ×")


def shown(picture, title):
    """A picture of the report in a block that goes into a page of the repository; readme.py sets the folder."""
    return f"![{title}]({picture}.svg)\n\n"
