#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the sections of the report one after the other, for their times need the machine, and draws it. A section that ends
with an error, such as a claim found untrue, does not keep the others from being drawn, but is the exit code.
Usage: run.py FOLDER quick|full PROGRAM..."""

import pathlib
import subprocess
import sys
import time

import render


def main():
    folder, mode, *programs = sys.argv[1:]
    start = time.monotonic()
    failed = [program for program in programs
              if subprocess.run([program, "--out", folder, "--mode", mode], check=False).returncode != 0]
    drawn = render.draw_report(pathlib.Path(folder))
    print(f"report: {time.monotonic() - start:.0f} s", flush=True)
    for program in failed:
        print(f"report: {pathlib.Path(program).name} ended with an error, see above", file=sys.stderr)
    return 1 if failed else drawn


if __name__ == "__main__":
    sys.exit(main())
