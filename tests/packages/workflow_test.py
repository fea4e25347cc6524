#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""`cmake --workflow --preset packages` makes everything in build/packages; the Debian package passes lintian, installs into an empty
root, and a project is built against it there. Usage: workflow_test.py SOURCE_FOLDER WORK_FOLDER. Exit code 77: skipped."""

import os
import pathlib
import shutil
import subprocess
import sys

SOURCE, WORK = (pathlib.Path(word).resolve() for word in sys.argv[1:])
SKIPPED = 77
# Where the library stands there is no source package, and no distribution that it is uploaded to.
NOT_OURS = "bad-distribution-in-changes-file"
ARCHIVES = ["*.tar.gz", "*-arduino.zip", "*-platformio.tar.gz", "*-esp-idf.tar.gz", "*-zephyr.tar.gz", "*.pack", "*.deb"]


def run(*words, **more):
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False, **more)
    if done.returncode:
        sys.exit(f"FAILED: {words}\n{done.stdout[-6000:]}")
    return done.stdout


def install(package, root):
    """By dpkg, with a list of packages of its own. What it depends on is not in an empty root."""
    root.mkdir(parents=True)
    needs = run("dpkg-deb", "-f", package, "Depends").strip()
    if not needs.startswith("libeigen3-dev (>= 3.4"):
        sys.exit(f"FAILED: the package depends on: {needs}")
    if os.geteuid() != 0:  # dpkg gives files to root
        print("only unpacked: not root")
        return run("dpkg-deb", "-x", package, root)
    for folder in ("updates", "info"):
        (root / "var/lib/dpkg" / folder).mkdir(parents=True)
    (root / "var/lib/dpkg/status").touch()
    dpkg = ("dpkg", f"--root={root}", "--force-depends", "--log=/dev/null")
    run(*dpkg, "--install", package)
    told = run("dpkg-query", f"--admindir={root}/var/lib/dpkg", "-W", "-f", "${Status}", "libbatuta-dev")
    if told != "install ok installed":
        sys.exit(f"FAILED: {told}")
    return told


def main():
    missing = [tool for tool in ("lintian", "dpkg-deb", "gzip") if shutil.which(tool) is None]
    if missing:
        print(f"LEFT OUT: there is no {', '.join(missing)} (toolchains/setup.sh packages)")
        return SKIPPED
    out = SOURCE / "build/packages"
    for old in out.glob("*.*"):
        old.unlink()
    run("cmake", "--workflow", "--preset", "packages", cwd=SOURCE)
    for pattern in ARCHIVES:
        if not list(out.glob(pattern)):
            sys.exit(f"FAILED: build/packages has no {pattern}")
    package, = out.glob("*.deb")
    told = run("lintian", "--fail-on", "error,warning", "--suppress-tags", NOT_OURS, package)
    print(told.strip() or "lintian has nothing to say")
    shutil.rmtree(WORK, ignore_errors=True)
    root = WORK / "root"
    install(package, root)
    for name in ("copyright", "changelog.gz"):
        if not (root / "usr/share/doc/libbatuta-dev" / name).is_file():
            sys.exit(f"FAILED: the package has no {name}")
    run("cmake", "-S", SOURCE / "tests/consumer/project", "-B", WORK / "build", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
        f"-DCMAKE_PREFIX_PATH={root / 'usr'}")
    run("cmake", "--build", WORK / "build")
    told = run(WORK / "build/consumer_beat")
    if told != "beat at 47 ms, 1.35 N s, 67 % up the first blade\n":  # (0.2 - 0.01) m at 4 m/s
        sys.exit(f"FAILED: {told}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
