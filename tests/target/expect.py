#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs a command and holds its exit status and its text against what is expected. Exit status: 0 as expected, 1 not,
2 wrong use. An emulator that does not end is killed after so much of its own processor time, which a busy machine
does not spend. usage: expect.py --status N [--text REGULAR_EXPRESSION] -- COMMAND..."""

import argparse
import re
import resource
import subprocess
import sys

PROCESSOR_SECONDS = 120


def parse(words):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--status", type=int, required=True, help="exit status")
    parser.add_argument("--text", default="", help="to be found in what the command writes")
    parser.add_argument("command", nargs="+")
    return parser.parse_args(words)


def limit_processor_time():
    resource.setrlimit(resource.RLIMIT_CPU, (PROCESSOR_SECONDS, PROCESSOR_SECONDS))


def main(words):
    options = parse(words)
    ran = subprocess.run(options.command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT, check=False, preexec_fn=limit_processor_time)
    text = ran.stdout.decode(errors="replace")
    print(text, end="")
    found = re.search(options.text, text) is not None
    if ran.returncode != options.status:
        print(f"expect: exit status {ran.returncode}, not {options.status}")
    if not found:
        print(f"expect: nothing above matches {options.text!r}")
    return 0 if found and ran.returncode == options.status else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
