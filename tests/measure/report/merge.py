#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Puts the files of all shards of a section together, exactly: what one run over everything would have written, but for
the times. Usage: merge.py --out FILE.csv SHARD.csv...; exit code 1 if the files do not belong together."""

import argparse
import sys

import rows


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", required=True, metavar="FILE.csv")
    parser.add_argument("shards", nargs="+", metavar="SHARD.csv")
    given = parser.parse_args()
    try:
        rows.joined([rows.Rows.read(path) for path in given.shards]).write(given.out)
    except (OSError, ValueError) as error:
        print(f"merge.py: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
