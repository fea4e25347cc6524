#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What docs/forces.md says that DeviceMeasurement costs is what the images cost, to 2 %.
Usage: cost_test.py BUILD_TREE IMAGE_THAT_MEASURES"""

import os
import pathlib
import re
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parents[3]
sys.dont_write_bytecode = True  # nothing is left in the source tree
sys.path.insert(0, str(SOURCE / "tests/measure/price"))
import price  # noqa: E402

ROOM = 0.02
NUMBER = r"([\d,]+)"
SENTENCE = re.compile(rf"takes {NUMBER} B of flash.*?{NUMBER} B of RAM, {NUMBER} B of stack.*?{NUMBER} instructions a step, {NUMBER} at most", re.S)


def sizes(tree):
    """Flash and RAM beyond those of an empty image, and the stack from the reset on; no gate may find anything."""
    manifest, _ = price.read_manifest(tree)
    collector = price.Collector(manifest)
    collector.take_image("measurement", manifest["images"]["measurement"])
    if collector.findings:
        sys.exit("\n".join(collector.findings))
    empty = price.rooms.by_room(collector.image(manifest["scenes"]["empty"]["image"]), collector.names)["total"]
    whole = [collector.figures[f"measurement.{kind}"] for kind in ("flash", "ram", "stack")]
    return manifest["emulator"], [whole[0] - empty[0], whole[1] - empty[1], whole[2]]


def instructions(emulator, image):
    """Of a step, in the mean and at most."""
    environment = dict(os.environ, BATUTA_QEMU_OPTIONS="-icount shift=6")
    ran = subprocess.run([*emulator, image], check=True, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return [int(re.search(rf"of a step, {word}: (\d+)", ran.stdout).group(1)) for word in ("mean", "most")]


def main():
    stated = SENTENCE.search((SOURCE / "docs/forces.md").read_text(encoding="utf-8"))
    if stated is None:
        sys.exit(f"docs/forces.md: no sentence as {SENTENCE.pattern}")
    emulator, measured = sizes(pathlib.Path(sys.argv[1]))
    measured += instructions(emulator, sys.argv[2])
    numbers = [int(word.replace(",", "")) for word in stated.groups()]
    print(f"stated {numbers}, measured {measured}")
    return 0 if all(abs(is_ - said) <= ROOM * said for is_, said in zip(measured, numbers)) else 1


if __name__ == "__main__":
    sys.exit(main())
