#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the tests of all targets found, in one place: prices, the digests of the pairs, and how many steps of firmware
and host were compared. Usage: show.py SOURCE_FOLDER; reads what the tests left in build/, and says what is not there."""

import json
import pathlib
import re
import sys

TESTS = pathlib.Path(__file__).resolve().parent.parent.parent
sys.dont_write_bytecode = True  # nothing is left in the source tree
sys.path.insert(0, str(TESTS / "measure" / "price"))
import readme_table  # noqa: E402
from tools import budgets  # noqa: E402

BOUT = re.compile(r"^(\w[\w. ]*): [\d.]+ s, steps_compared (\d+), (.*)$", re.M)
BOARDS = ["stm32f405"]


def aligned(rows):
    """Columns of a console: the first to the left, the others to the right."""
    widths = [max(map(len, column)) for column in zip(*rows)]
    for first, *rest in rows:
        cells = [first.ljust(widths[0]), *(word.rjust(width) for word, width in zip(rest, widths[1:]))]
        print("  ".join(cells).rstrip())


def show_prices(build):
    print("Prices (instructions are counted by QEMU's -icount: they are no cycles)")
    prices = {cpu: readme_table.price_of(build / "target" / cpu) for cpu in readme_table.CPUS}
    measured = [price for price in prices.values() if price["figures"]]
    limits = budgets.read(TESTS / "measure" / "price" / "budgets.csv")
    for rows in readme_table.TABLES.values():
        markdown = readme_table.table(dict(readme_table.column_of(price, rows) for price in measured), limits, rows)
        lines = [[word.strip() for word in line[1:-1].split("|")] for line in markdown.splitlines()]
        aligned([lines[0], *lines[2:]])  # without the line under the head
        print()
    for cpu, price in prices.items():
        if not price["figures"]:
            print(f"{cpu}: not measured")
    for board in BOARDS:
        show_board(board, build / "target" / board)


def show_board(board, tree):
    """The image that is flashed."""
    price = readme_table.price_of(tree)
    sizes = ", ".join(f"{name.split('.')[-1]} {budgets.number(value)} B" for name, value in price["figures"].items())
    print(f"{board}: {sizes or 'not measured'}")
    for finding in price.get("findings", []):
        print(f"  GATE {finding}")


def show_pairs(build):
    print("\nThe same bits: digests of all answers (those of the same queries compare)")
    path = build / "digest" / "results.json"
    results = json.loads(path.read_text()) if path.is_file() else []
    if not results:
        print("not compared: tests/target/pairs/run_pairs.py does it")
    words = "pair", "compiler", "queries", "digest", "verdict"
    if results:
        aligned([words, *([result.get(word, "") for word in words] for result in results)])


def show_bouts(build):
    print("\nThe firmware against the host, bit for bit (tests/target/hil)")
    steps, bouts = 0, 0
    for tree in [*readme_table.CPUS, *BOARDS]:
        log = build / "target" / tree / "Testing" / "Temporary" / "LastTest.log"
        if not log.is_file():
            continue
        for name, compared, counts in BOUT.findall(log.read_text(errors="replace")):
            print(f"{tree}: {name}: {int(compared):,} steps compared, {counts}")
            steps, bouts = steps + int(compared), bouts + 1
    print(f"{steps:,} steps of {bouts} bouts were compared" if bouts else "no bout was fenced")


def main():
    build = pathlib.Path(sys.argv[1]) / "build"
    show_prices(build)
    show_pairs(build)
    show_bouts(build)


if __name__ == "__main__":
    main()
