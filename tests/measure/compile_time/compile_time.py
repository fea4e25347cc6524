# SPDX-License-Identifier: MIT
"""How much longer a user's file takes to compile than one that includes Eigen alone.

    compile_time.py COMPILER FLAG_FILE [PAIRS] [--bound RATIO] [--at-most RATIO]

The user's file is user.cpp, without optimization; each of its runs is paired with one of eigen.cpp right after it, and what counts is
the processor's time of the compiler, so that other work on the machine slows both alike. Printed is the ratio of the shortest
runs, which other work can only lengthen, and the median of the pairs."""
import argparse
import pathlib
import resource
import statistics
import subprocess

FOLDER = pathlib.Path(__file__).resolve().parent


def seconds(command):
    """Processor time of a command."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def measured(command, pairs):
    """Seconds of the user's file and of Eigen's, pair by pair. The first pair fills the caches and is left out."""
    both = [[seconds(command + [str(FOLDER / name)]) for name in ("user.cpp", "eigen.cpp")] for _ in range(pairs + 1)]
    return both[1:]


def ratios(both):
    """Ratio of the shortest runs, and the median of the pairs' ratios."""
    shortest = min(user for user, _ in both) / min(eigen for _, eigen in both)
    return shortest, statistics.median(user / eigen for user, eigen in both)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("compiler")
    parser.add_argument("flag_file", help="options, one a line, in a form that the compiler reads with @")
    parser.add_argument("pairs", nargs="?", type=int, default=25, help="so many that one run of each is undisturbed")
    parser.add_argument("--at-most", type=float, help="fail where the ratio of the shortest runs is larger")
    parser.add_argument("--bound", type=float, help="what was promised: said where it is missed")
    arguments = parser.parse_args()
    command = [arguments.compiler, "@" + arguments.flag_file, "-O0", "-fsyntax-only"]
    shortest, median = ratios(measured(command, arguments.pairs))
    print(f"a user's file takes {shortest:.3f} times as long as Eigen alone (median of {arguments.pairs} pairs: {median:.3f})")
    if arguments.bound is not None and min(shortest, median) > arguments.bound:
        print(f"the bound of {arguments.bound} is missed")
    if arguments.at_most is not None and min(shortest, median) > arguments.at_most:
        raise SystemExit(f"that is more than {arguments.at_most}: look with clang++ -ftime-trace at what a World instantiates")


if __name__ == "__main__":
    main()
