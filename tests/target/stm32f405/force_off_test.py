#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""batuta_board_force_off() in the image is what it is said to be: two stores, no stack, no call, no loop.
usage: force_off_test.py OBJDUMP IMAGE"""

import re
import subprocess
import sys

FUNCTION = "batuta_board_force_off"
# Address and value, in this order, written down from RM0090 and the wiring in stm32f405.md:
# TIM8_BDTR = BKE, OSSR, OSSI, LOCK 2, no MOE; GPIOC_MODER = 0, 1 analogue, 6 ... 9 and 13 outputs.
STORES = [(0x40010444, 0x00001E00), (0x40020800, 0x0405500F)]


def lines_of(objdump, image):
    """(address, mnemonic, operands, address in the comment or None) of the function and the words behind it."""
    listing = subprocess.run([objdump, "-d", "--no-show-raw-insn", f"--disassemble={FUNCTION}", image],
                             check=True, capture_output=True, text=True).stdout
    for address, mnemonic, operands in re.findall(r"^ *([0-9a-f]+):\s+(\S+)[ \t]*(.*)$", listing, re.M):
        operands, _, comment = operands.partition("@")
        target = re.search(r"\(([0-9a-f]+) ", comment)
        yield int(address, 16), mnemonic, operands.strip(), int(target[1], 16) if target else None


class Processor:
    """As much of one as two stores take; what it does not know it refuses with ValueError."""

    def __init__(self, words):
        self.words = words
        self.registers = {}
        self.stores = []

    def run(self, mnemonic, operands, target):
        name = mnemonic.split(".")[0]
        move = re.fullmatch(r"(r\d+), #(\d+)", operands)
        sum_of = re.fullmatch(r"(r\d+), (r\d+), #(\d+)", operands)
        store = re.fullmatch(r"(r\d+), \[(r\d+)(?:, #(\d+))?\]", operands)
        if name == "ldr" and "[pc" in operands and target in self.words:
            self.registers[operands.split(",")[0]] = self.words[target]
        elif name in ("mov", "movs", "movw") and move:
            self.registers[move[1]] = int(move[2])
        elif name == "movt" and move:
            self.registers[move[1]] = self.registers[move[1]] & 0xFFFF | int(move[2]) << 16
        elif name in ("add", "adds", "addw") and sum_of:
            self.registers[sum_of[1]] = self.registers[sum_of[2]] + int(sum_of[3])
        elif name == "str" and store:
            self.stores.append((self.registers[store[2]] + int(store[3] or 0), self.registers[store[1]]))
        else:
            raise ValueError(f"{mnemonic} {operands}")


def stores_of(lines):
    """What the function stores, from its first instruction to its return."""
    words = {address: int(operands, 16) for address, mnemonic, operands, _ in lines if mnemonic == ".word"}
    processor = Processor(words)
    for _, mnemonic, operands, target in lines:
        if (mnemonic, operands) == ("bx", "lr"):
            return processor.stores
        processor.run(mnemonic, operands, target)
    raise ValueError(f"no return, or no {FUNCTION}")


def main(words):
    if len(words) != 2:
        sys.exit(__doc__)
    try:
        stores = stores_of(list(lines_of(*words)))
    except ValueError as refused:
        sys.exit(f"not two plain stores: {refused}")
    print(", ".join(f"[{address:#x}] = {value:#x}" for address, value in stores))
    return 0 if stores == STORES else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
