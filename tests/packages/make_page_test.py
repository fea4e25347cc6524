#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Builds for a Cortex-M4F, with make, what docs/porting.md has: its files as they stand there, none of its CMake.
(For the machine itself the page is followed in tests/consumer.) Usage: make_page_test.py SOURCE_FOLDER. Exit code 77: skipped."""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(sys.argv[1]).resolve()
sys.path.insert(0, str(SOURCE / "tests/consumer"))
import follow_page  # noqa: E402

SKIPPED, ROOMS = 77, "core port haptics"
COMPILER, READER = "arm-none-eabi-g++", "arm-none-eabi-readelf"


def run(folder, *words):
    done = subprocess.run(words, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode:
        sys.exit(f"FAILED: {' '.join(words)}\n{done.stdout[-6000:]}")
    return done.stdout


def main():
    missing = [tool for tool in (COMPILER, "make") if shutil.which(tool) is None]
    if missing:
        print(f"LEFT OUT: there is no {', '.join(missing)} (toolchains/setup.sh target)")
        return SKIPPED
    text = (SOURCE / "docs/porting.md").read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory(prefix="batuta-make-") as name:
        folder = pathlib.Path(name)
        (folder / "batuta").symlink_to(SOURCE)
        for line, language, content in follow_page.blocks(text, []):
            if language == "sh" and re.search(r"\b(?:cmake|make)\b", content):
                continue  # it is the cross build that is run here
            fault = follow_page.follow(folder, line, language, content)
            if fault:
                sys.exit(f"FAILED: docs/porting.md:{line}: {fault}")
        command = re.search(r"`(make -C my_firmware -f cortex-m4f\.mk [^`]*)`", text)
        if not command:
            sys.exit("FAILED: the page says no command for a part")
        run(folder, "sh", "-euc", command.group(1))
        attributes = run(folder, READER, "-A", "build-cortex-m4f/my_firmware")
        for word in ("v7E-M", "VFPv4-D16", "VFP registers"):
            if word not in attributes:
                sys.exit(f"FAILED: the program is for another part, without '{word}':\n{attributes}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
