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
DEFINED = "TtWVRrAun" + STATE


def symbols(nm, libraries):
    """(library, kind, name) of every symbol; kind as nm tells it, "r" for constants that hold addresses."""
    for library in libraries:
        answer = subprocess.run([nm, "--format=sysv", library], check=True, capture_output=True, text=True)
        for line in answer.stdout.splitlines():
            fields = [field.strip() for field in line.split("|")]
            if len(fields) == 7 and len(fields[2]) == 1:
                constant = fields[6].startswith(".data.rel.ro")
                yield library, "r" if constant else fields[2], fields[0]


def findings(libraries, found):
    found = list(found)
    yield from ((library, f"{library}: nm tells nothing of it") for library in libraries - {row[0] for row in found})
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

    reported = list(findings(set(options.libraries), symbols(options.nm, options.libraries)))
    print("\n".join(sorted({text for _, text in reported})))
    if options.must_report:
        missing = set(options.must_report.split(",")) - {name for name, _ in reported}
        print("not reported: " + ", ".join(sorted(missing)) if missing else "every planted fault is reported")
        return 1 if missing else 0
    return 1 if reported else 0


if __name__ == "__main__":
    sys.exit(main())
