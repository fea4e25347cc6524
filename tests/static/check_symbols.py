#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the core's object code asks of its surroundings: nothing but a few symbols, and no state of its own.
This is the proof that nothing allocates, throws or calls libm; the source text cannot give it."""

import argparse
import subprocess
import sys

# Copying, the one function of libm, the port's trap, and what a class with pure virtual functions names.
ALLOWED = {"memcpy", "memmove", "memset", "memcmp", "sqrt", "sqrtf", "batuta_trap", "__cxa_pure_virtual",
           "__stack_chk_fail", "_GLOBAL_OFFSET_TABLE_"}
UNDEFINED = "Uwv"
STATE = "bBdDcC"
DEFINED = "TtWVRrAu" + STATE


def symbols(nm, libraries):
    """(library, kind, name) of every symbol."""
    for library in libraries:
        answer = subprocess.run([nm, "--format=posix", library], check=True, capture_output=True, text=True)
        for line in answer.stdout.splitlines():
            fields = line.split()
            if len(fields) >= 2 and len(fields[1]) == 1:
                yield library, fields[1], fields[0]


def findings(found):
    found = list(found)
    own = {name for _, kind, name in found if kind in DEFINED}
    for library, kind, name in found:
        if kind in UNDEFINED and name not in own and name not in ALLOWED:
            yield name, f"{library}: needs {name}"
        if kind in STATE:
            yield name, f"{library}: keeps state in {name}"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--nm", default="nm")
    parser.add_argument("--must-report", default="", help="comma-separated: fail unless these are reported")
    parser.add_argument("libraries", nargs="+")
    options = parser.parse_args()

    reported = list(findings(symbols(options.nm, options.libraries)))
    print("\n".join(sorted({text for _, text in reported})))
    if options.must_report:
        missing = set(options.must_report.split(",")) - {name for name, _ in reported}
        print("not reported: " + ", ".join(sorted(missing)) if missing else "every planted fault is reported")
        return 1 if missing else 0
    return 1 if reported else 0


if __name__ == "__main__":
    sys.exit(main())
