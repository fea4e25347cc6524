# SPDX-License-Identifier: MIT
"""How much more a compiler works on a user's file than on one that includes Eigen alone.

    compile_time.py VALGRIND COMPILER FLAG_FILE [--at-most RATIO]

The user's file is user.cpp, without optimization. Compared are the instructions of the compiler, which are the same each
time, whatever else the machine does; its time is not: 1.17 to 1.38 were seen for the same files. On an idle machine the
ratio of the times is larger than that of the instructions by 0.03."""
import argparse
import pathlib
import re
import subprocess

FOLDER = pathlib.Path(__file__).resolve().parent
COUNT = re.compile(r"^==\d+== I +refs: +([\d,]+)$", re.MULTILINE)  # of one process: the driver, and the compiler that it calls
COUNTER = ["--trace-children=yes", "--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null"]


def instructions(valgrind, compiler, flag_file, name):
    """Those that the compiler executes for a file of this folder."""
    command = [valgrind, *COUNTER, compiler, "@" + flag_file, "-O0", "-fsyntax-only", str(FOLDER / name)]
    told = subprocess.run(command, check=True, capture_output=True, text=True).stderr
    counts = [int(count.replace(",", "")) for count in COUNT.findall(told)]
    if len(counts) < 2:
        raise SystemExit(f"compile_time: {valgrind} does not tell the instructions of the driver and of the compiler:\n{told}")
    return sum(counts)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("valgrind")
    parser.add_argument("compiler")
    parser.add_argument("flag_file", help="options, one a line, in a form that the compiler reads with @")
    parser.add_argument("--at-most", type=float, help="fail where the ratio is larger")
    arguments = parser.parse_args()
    user, eigen = (instructions(arguments.valgrind, arguments.compiler, arguments.flag_file, name)
                   for name in ("user.cpp", "eigen.cpp"))
    ratio = user / eigen
    print(f"a user's file takes {ratio:.3f} times the instructions of Eigen alone: {user / 1e9:.2f} and {eigen / 1e9:.2f} thousand million")
    if arguments.at_most is not None and ratio > arguments.at_most:
        raise SystemExit(f"that is more than {arguments.at_most}: look with clang++ -ftime-trace at what a World instantiates")


if __name__ == "__main__":
    main()
