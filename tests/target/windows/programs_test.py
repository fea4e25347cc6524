#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Programs for Windows give the bytes of those of this machine.
Usage: programs_test.py HOST_TREE WINDOWS_TREE VECTORS GUARD_OBJ GROUP"""

import os
import pathlib
import subprocess
import sys
import tempfile

HOST, WINDOWS, VECTORS, GUARD = (pathlib.Path(word).resolve() for word in sys.argv[1:5])
GROUP = sys.argv[5]
ENVIRONMENT = {**os.environ, "WINEPREFIX": str(WINDOWS / "wine"), "WINEDEBUG": "-all"}
HANG_SECONDS = 600


def check(condition, what):
    if not condition:
        sys.exit(f"FAILED: {what}")


def on_host(program, *words, **more):
    return subprocess.run([HOST / program, *words], capture_output=True, timeout=HANG_SECONDS, check=False, **more)


def on_windows(program, *words, **more):
    return subprocess.run(["wine", WINDOWS / f"{program}.exe", *words], capture_output=True, timeout=HANG_SECONDS, check=False,
                          env=ENVIRONMENT, **more)


def same(program, *words, **more):
    """Exit code and output, but for how a line ends there."""
    ours, theirs = on_host(program, *words, **more), on_windows(program, *words, **more)
    check(theirs.returncode == ours.returncode, (words, ours.returncode, theirs.returncode, theirs.stderr[-500:]))
    for mine, other in ((ours.stdout, theirs.stdout), (ours.stderr, theirs.stderr)):
        check(other.replace(b"\r\n", b"\n").replace(b".exe", b"") == mine, (words, mine[-300:], other[-300:]))
    return ours


def answers(folder):
    """Every vector file, each search and both precisions, from file to file: the same bytes."""
    asked = [("toc", "toc.csv", [f"--method={name}"]) for name in ("advancement", "translation")]
    asked += [("toc", "toc.csv", ["--method=stepping", "--budget=1000"]), ("distance", "dist.csv", []), ("impulse", "resp.csv", [])]
    for kind, file, how in asked:
        for scalar in ("float", "double"):
            files = [folder / f"{name}.csv" for name in ("host", "windows")]
            words = [kind, f"--in={VECTORS / file}", f"--scalar={scalar}", *how]
            ours = on_host("batuta-answer", *words, f"--out={files[0]}")
            theirs = on_windows("batuta-answer", *words, f"--out={files[1]}")
            check(ours.returncode == theirs.returncode, (words, ours.returncode, theirs.returncode, theirs.stderr[-500:]))
            texts = [path.read_bytes() for path in files]
            check(texts[0].count(b"\n") >= 500, f"{kind}: {texts[0][:200]}")
            check(texts[0] == texts[1], f"{kind} {scalar} {how}: answers differ")
            print(f"{kind} {scalar} {' '.join(how)}: {texts[0].count(10) - 1} answers, the same bytes")


def files(folder):
    """What is there is replaced whole; what is read is never written; what is wrong is said in the same words."""
    one, other = folder / "in.csv", folder / "out.csv"
    columns = on_host("batuta-answer", "distance", "--help").stdout.decode().split("Columns of queries")[1].split("\n")[1].split()
    check(len(columns) >= 12, columns)
    one.write_text(",".join(columns) + "\n" + ",".join(f"{i}.5" for i in range(len(columns))) + "\n", encoding="ascii")
    other.write_text("old", encoding="ascii")
    result = on_windows("batuta-answer", "distance", f"--in={one}", f"--out={other}")
    check(result.returncode == 0 and b"old" not in other.read_bytes(), result)
    check(sorted(path.name for path in folder.iterdir()) == ["in.csv", "out.csv"], list(folder.iterdir()))
    before = one.read_bytes()
    result = on_windows("batuta-answer", "distance", f"--in={one}", f"--out={one}")
    check(result.returncode == 2 and one.read_bytes() == before, result)
    same("batuta-answer", "distance", "--in=-", "--out=-", input=before)
    same("batuta-answer", "distance", "--in=-", "--out=-", input=b"a,b\n1.5,2.5\n")
    same("batuta-answer", "distance")
    same("batuta-answer", "--help")


def mass(_):
    for words in ([], ["--json"], ["--scale=0.001", "--mass=0.3"], ["--density=-1"]):
        same("batuta-mass", GUARD, *words)
    same("batuta-mass")


def main():
    with tempfile.TemporaryDirectory(prefix="batuta-windows-") as name:
        {"Answers": answers, "Files": files, "Mass": mass}[GROUP](pathlib.Path(name))


if __name__ == "__main__":
    main()
