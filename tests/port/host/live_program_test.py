#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs batuta-duel in real time, with a stick of a fake kernel plugged in: live_program_test.py PROGRAM PROGRAM_WITH_STICK GROUP."""

import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import time

PROGRAM, WITH_STICK, GROUP = sys.argv[1:4]
STICK = "device:/dev/input/fake0"
PATIENCE = 600  # s; against hanging: no verdict
UP_TO_THE_SECOND_BEAT = 5  # lines


def check(condition, what):
    if not condition:
        sys.exit("FAILED: %s" % (what,))


def environment(stick):
    return dict(os.environ, BATUTA_TEST_STICK=stick)


def interrupted(program, words, number, enough, stick="", later=0):
    """Starts a bout without an end, sends the signal once there is enough output, or so many seconds later, and returns what came
    of it."""
    bout = subprocess.Popen([program, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                            env=environment(stick))
    lines = []
    while len(lines) < enough:
        line = bout.stdout.readline()
        check(line, "the bout ended by itself: %s" % (lines,))
        lines.append(line)
    time.sleep(later)
    bout.send_signal(number)
    try:
        rest, errors = bout.communicate(timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        bout.kill()
        raise
    return bout.returncode, "".join(lines) + rest, errors


def at_rest(errors):
    """What the stick told at the end: nothing is left on it, and each effect was at zero before it was taken back."""
    check("still open 0, effects left 0" in errors, errors)
    removed = re.findall(r"removed an effect of type (\S+), at (\d+)", errors)
    check(removed and all(strength == "0" for _, strength in removed), errors)
    return [kind for kind, _ in removed]


def interrupt(folder):
    """Ctrl-C, SIGTERM, a hang-up: the summary is told, the exit code is 0, the recording is whole, no force is left."""
    for number in signal.SIGINT, signal.SIGTERM, signal.SIGHUP:
        path = os.path.join(folder, "bout.batuta")
        words = ["--left", "script:guard", "--right", "script:guard", "--seconds", "1000", "--realtime", "--json"]
        code, out, errors = interrupted(PROGRAM, [*words, "--record", path], number, 1)
        check(code == 0 and errors == "", (number, code, errors))
        summary = json.loads(out.splitlines()[-1])
        check(summary["type"] == "summary" and summary["result"] == "open", summary)
        check(summary["simulated_seconds"] < 1000, summary)
        again = subprocess.run([PROGRAM, "--replay", path], capture_output=True, text=True, timeout=PATIENCE, check=False)
        check(again.returncode == 0 and "%d steps" % summary["steps"] in again.stdout, (again.stdout, again.stderr))
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # as a shell has it for a job in the background
    try:
        words[words.index("1000")] = "1.5"
        code, out, errors = interrupted(PROGRAM, words, signal.SIGINT, 1)
    finally:
        signal.signal(signal.SIGINT, signal.default_int_handler)
    check(code == 0, (code, errors))
    check(json.loads(out.splitlines()[-1])["simulated_seconds"] == 1.5, "an ignored signal stays ignored")


def forces(_):
    """With a stick in a hand: the force is at zero, and taken back, before the program ends."""
    words = ["--left", STICK, "--right", "script:parry", "--spring", "0.5", "--seconds", "1000"]
    for number in signal.SIGINT, signal.SIGTERM, signal.SIGHUP:
        for later in 0, 1, 4, 16:  # s; on a busy machine the beat is told long before its force is sent
            code, out, errors = interrupted(WITH_STICK, words, number, UP_TO_THE_SECOND_BEAT, later=later)
            check(code == 0, (number, code, errors))
            check("left   force: force; effects sent" in out, out)
            check(len(at_rest(errors)) == 3, errors)
            strongest = re.search(r"the strongest force was (\d+), spring (\d+)", errors)
            if all(int(force) > 0 for force in strongest.groups()):
                break
        else:
            check(False, "what was never there proves nothing")


def weak(_):
    """Sticks that give less than they say: read on, told once, not opened over and over."""
    words = ["--left", STICK, "--right", "script:guard", "--spring", "0.5", "--seconds", "1.2"]
    bouts = {}
    for stick in "read-only", "no-effects", "no-spring":
        bouts[stick] = subprocess.Popen([WITH_STICK, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                        env=environment(stick))
    told = {}
    for stick, bout in bouts.items():
        out, errors = bout.communicate(timeout=PATIENCE)
        check(bout.returncode == 0, (stick, errors))
        check(re.search(r"left   samples used [1-9]", out), (stick, out))
        check("unplugged" not in out, (stick, out))
        told[stick] = out + errors
    refusal = "batuta-duel: /dev/input/fake0 (Test Stick): no force: "
    check(told["read-only"].count(refusal + "no permission to write to it") == 1, told["read-only"])
    check(told["no-effects"].count(refusal + "it takes none of its effects (constant)\n") == 1, told["no-effects"])
    check(told["no-spring"].count("not taken by the device: spring\n") == 1, told["no-spring"])
    check("left   force: force; effects sent" in told["no-spring"], told["no-spring"])
    for stick, words in told.items():
        check("opened 2 times" in words, (stick, words))


def twice(_):
    """One stick is not in two hands."""
    for other in STICK, "device:/dev/input/by-id/fake0":
        bout = subprocess.run([WITH_STICK, "--left", STICK, "--right", other], capture_output=True, text=True,
                              timeout=PATIENCE, check=False)
        check(bout.returncode == 2 and bout.stdout == "", (other, bout))
        check(bout.stderr.startswith("batuta-duel: %s: Test Stick is the other fencer's already; found" % other), bout.stderr)


def view(folder):
    """A stick in a hand and a window, which SDL keeps in memory: the bout is seen, recorded, and ends with no force left."""
    path = os.path.join(folder, "seen.batuta")
    words = ["--left", STICK, "--right", "script:parry", "--seconds", "1000", "--view", "--record", path]
    os.environ["SDL_VIDEODRIVER"] = "dummy"
    code, out, errors = interrupted(WITH_STICK, words, signal.SIGINT, UP_TO_THE_SECOND_BEAT)
    check(code == 0, (code, errors))
    check(re.search(r"^view   pictures [1-9]", out, re.M), out)
    check(re.search(r"left   samples used [1-9]", out), out)
    check(at_rest(errors), errors)
    again = subprocess.run([PROGRAM, "--replay", path], capture_output=True, text=True, timeout=PATIENCE, check=False)
    check(again.returncode == 0, (again.stdout, again.stderr))


GROUPS = {"Interrupt": interrupt, "Forces": forces, "Weak": weak, "Twice": twice, "View": view}
with tempfile.TemporaryDirectory() as scratch:
    GROUPS[GROUP](scratch)
