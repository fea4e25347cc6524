#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""One bout of batuta-duel with the firmware in the emulator: the recording that is built in is its stick.
Usage: run_firmware.py DUEL BUILD_TREE; exit code: that of batuta-duel."""

import argparse
import pathlib
import subprocess
import sys

TARGET = pathlib.Path(__file__).resolve().parent.parent
sys.dont_write_bytecode = True  # nothing is left in the source tree
sys.path[:0] = [str(TARGET / "hil"), str(TARGET / "price")]
import hil  # noqa: E402
import price  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("duel")
    parser.add_argument("tree", type=pathlib.Path)
    arguments = parser.parse_args()
    manifest, _ = price.read_manifest(arguments.tree)
    arguments.emulator = [*manifest["emulator"], manifest["images"]["firmware"]]
    with hil.Bench(arguments) as bench:
        words = ["--left", f"serial:{bench.cable.path},default", "--right", "script:parry", *hil.PATIENCE]
        print("batuta-duel", *words, f"  # {manifest['part']} in the emulator", flush=True)
        status = subprocess.run([arguments.duel, *words], check=False).returncode
        if bench.keeper.problem:
            print(bench.keeper.problem, file=sys.stderr)
        return status


if __name__ == "__main__":
    sys.exit(main())
