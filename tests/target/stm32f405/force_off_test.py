#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""batuta_board_force_off() in the image is what it is said to be: two stores, no stack, no call, no loop.
usage: force_off_test.py OBJDUMP IMAGE"""

import re
import subprocess
import sys

FUNCTION = "batuta_board_force_off"
ALLOWED = re.compile(r"(ldr|mov|movs|movw|movt|mov\.w|str|str\.w|bx|nop|\.word)$")


def instructions(objdump, image):
    """(mnemonic, operands) of the function, and the words behind it."""
    listing = subprocess.run([objdump, "-d", "--no-show-raw-insn", f"--disassemble={FUNCTION}", image],
                             check=True, capture_output=True, text=True).stdout
    lines = re.findall(r"^\s*[0-9a-f]+:\s+(\S+)\s*(.*)$", listing, re.M)
    return [(mnemonic, operands.split("@")[0].strip()) for mnemonic, operands in lines]


def findings(code):
    stores = [operands for mnemonic, operands in code if mnemonic.startswith("str")]
    if len(stores) != 2:
        yield f"{len(stores)} stores"
    for mnemonic, operands in code:
        if not ALLOWED.match(mnemonic) or re.search(r"\bsp\b", operands):
            yield f"{mnemonic} {operands}"


def main(words):
    if len(words) != 2:
        sys.exit(__doc__)
    code = instructions(*words)
    found = list(findings(code)) if code else [f"there is no {FUNCTION}"]
    print("\n".join(found) or f"{len(code)} lines, two stores")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
