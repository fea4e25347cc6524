#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""batuta-duel fences with the firmware in an emulator, over a cable that may be bad.

usage: hil.py SCENARIO --duel PROGRAM --shared FOLDER -- EMULATOR... FIRMWARE
Exit status 77: the host's program or the recordings are not there.
"""

import argparse
import json
import os
import signal
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True  # nothing is left in the source tree
import frames  # noqa: E402
from cable import Cable  # noqa: E402
from keeper import Emulator, Keeper  # noqa: E402

SKIP = 77
# Of the host's program: its longest. Who watches over an emulator is keeper.py, in the emulator's own time.
PATIENCE = ("--patience", "1000")
FREE_RUNS = 20  # of which one has to be followed to its end; one is enough but on a busy machine
# Time by instructions, 8 ns each: a busy machine makes the device's own clock slow, not the device.
BY_INSTRUCTIONS = "-icount shift=3"


class Bench:
    """The emulator with the firmware, the cable, and the host's program."""

    def __init__(self, arguments, options="", **cable):
        self.arguments = arguments
        self.options = options
        self.folder = tempfile.TemporaryDirectory()
        self.cable = Cable(self.folder.name, **cable)
        self.emulator = None
        self.keeper = None

    def __enter__(self):
        self.emulator = Emulator(self.arguments.emulator, f"-serial unix:{self.cable.uart} {self.options}")
        if not self.cable.plug_in(lambda: self.emulator.ending() is None):
            self.give_up(f"the emulator has ended by itself, with status {self.emulator.ending()}")
        self.keeper = Keeper(self.emulator, self.cable)
        self.keeper.start()
        while self.cable.frames.intact == 0:  # Bound: the keeper's
            if self.keeper.problem:
                self.give_up(f"the device does not speak: {self.keeper.problem}")
            time.sleep(0.01)
        return self

    def __exit__(self, *_):
        if self.keeper is not None:
            self.keeper.stop()
        self.emulator.kill()
        self.cable.close()
        self.folder.cleanup()

    def give_up(self, why):
        self.__exit__()
        raise AssertionError(why)

    def fence(self, left, right, *more, patience=PATIENCE):
        """SERIAL in a source becomes the cable's end."""
        here = [word.replace("SERIAL", "serial:" + self.cable.path) for word in (left, right)]
        run = fence(self.arguments.duel, *here, *more, *patience)
        require(not self.keeper.problem, self.keeper.problem, run)
        return run


class Run:
    """What a run of the program left behind."""

    def __init__(self, process, seconds):
        self.status = process.returncode
        self.seconds = seconds
        self.error = process.stderr.strip()
        self.lines = [json.loads(line) for line in process.stdout.splitlines()]

    def link(self):
        return next(line for line in self.lines if line["type"] == "link")

    def summary(self):
        return self.lines[-1]

    def bout(self):
        """Everything that must not depend on where it was computed."""
        kept = [line for line in self.lines if line["type"] != "link"]
        return [{key: value for key, value in line.items() if not key.startswith("host_ns")}
                for line in kept]


def fence(duel, left, right, *more):
    """To one touch, unless there is more to say."""
    touches = [] if "--touches" in more else ["--touches", "1"]
    command = [duel, "--left", left, "--right", right, "--json", *touches, *more]
    begin = time.monotonic()
    process = look_on(command) if "--view" in more else subprocess.run(command, capture_output=True, text=True, check=False)
    return Run(process, time.monotonic() - begin)


def look_on(command):
    """With a window that SDL keeps in memory. What is over stays in sight until somebody has seen enough."""
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                               env=dict(os.environ, SDL_VIDEODRIVER="dummy"))
    lines = []
    while not lines or '"type":"summary"' not in lines[-1]:  # Bound: the bout's steps, and the keeper's patience
        lines.append(process.stdout.readline())
        if not lines[-1]:
            break
    process.send_signal(signal.SIGINT)
    rest, error = process.communicate()
    return subprocess.CompletedProcess(command, process.returncode, "".join(lines) + rest, error)


def require(condition, what, run):
    if not condition:
        raise AssertionError(f"{what}\nexit status {run.status}\n{run.error}\n{run.lines[-2:]}")


def require_same_bout(run, plain):
    require(run.status == 0, "the bout did not come to its end", run)
    require(run.bout() == plain.bout(), "the host's output is not that of a run by itself", run)
    steps = plain.summary()["steps"]
    require(run.link()["steps_compared"] == steps, f"not all {steps} steps were compared", run)


def tell(name, run):
    link = run.link()
    counts = ("steps_compared", "forces_not_zero", "resends", "rejected", "device_rejected", "device_overruns",
              "device_skipped", "device_silences")
    print(f"{name}: {run.seconds:.1f} s,", ", ".join(f"{key} {link[key]}" for key in counts))


def play(arguments, recording, *more, **cable):
    """A bout with a recording in place of the stick, and the same one without a device."""
    recording = os.path.join(arguments.shared, "recordings", recording)
    plain = fence(arguments.duel, recording, "script:parry", *more)
    with Bench(arguments, **cable) as bench:
        run = bench.fence("SERIAL," + recording, "script:parry", *more)
    tell(os.path.basename(recording), run)
    require_same_bout(run, plain)
    return run


def mouse(arguments):
    play(arguments, "ps2_mouse.events")


def pad(arguments):
    """Two dozen beats: events and forces; and a bout that goes on after a touch."""
    run = play(arguments, "madcatz_pad.events", "--touches", "2")
    require(run.summary()["blows"] > 0, "a bout without a blow shows too little", run)
    require(run.link()["forces_not_zero"] > 0, "no force but zero was compared", run)


def seen(arguments):
    """The device's bout in a window: it is no other for that."""
    recording = os.path.join(arguments.shared, "recordings", "ps2_mouse.events")
    plain = fence(arguments.duel, recording, "script:parry")
    with Bench(arguments) as bench:
        run = bench.fence("SERIAL," + recording, "script:parry", "--view")
    if "without SDL2" in run.error:
        print(f"skipped: {run.error}")
        sys.exit(SKIP)
    tell("seen", run)
    require_same_bout(run, plain)


def trackpoint(arguments):
    play(arguments, "trackpoint.events")


def damaged(arguments):
    """Dropped, doubled and flipped bytes: the same bout, and the damage is counted."""
    link = play(arguments, "madcatz_pad.events", damage=5e-5, seed=3).link()
    for count in ("rejected", "device_rejected", "resends", "missing"):
        if link[count] == 0:
            raise AssertionError(f"{count} is 0: the damage was not noticed")


def fence_until_cut(bench, recording):
    """The host's patience is its own clock's. Where the machine is so busy that it gives up a device that was not cut
    off, it is given more."""
    patience = 2.0
    while True:  # Bound: a host that waits for longer than the machine stops the emulator for, or a dead emulator
        bench.cable.cut_in(100_000)
        run = bench.fence("SERIAL," + recording, "script:parry", patience=("--patience", str(patience)))
        if bench.cable.is_cut():
            return run
        require("no whole answer to step" in run.error, "the bout ended before the cable was cut", run)
        print(f"given up before the cable was cut, after {patience:g} s: {run.error}")
        patience = min(4 * patience, 1000.0)


def cut(arguments):
    """The cable is cut in the bout: the host gives up, the device lets go, both begin anew."""
    silences = frames.Silences()
    recording = os.path.join(arguments.shared, "recordings", "madcatz_pad.events")
    with Bench(arguments, rewrite=silences) as bench:
        first = fence_until_cut(bench, recording)
        tell("cut", first)
        require(first.status == 1, "the host did not give up", first)
        require("no whole answer to step" in first.error, "the reason is not told", first)
        require(first.lines[-1]["type"] == "link", "a bout that did not end has no summary", first)
        before = silences.told[-1]
        silences.told.clear()
        bench.cable.mend()
        second = bench.fence("SERIAL," + recording, "script:parry")
    tell("mended", second)
    require_same_bout(second, fence(arguments.duel, recording, "script:parry"))
    # Two seconds without a step are one silence. No stick can have had one yet in the first step.
    after = silences.told[0]
    require(before[0] > 1 and after[0] == 1, f"not before and after: {before}, {after}", second)
    require(after[1] > before[1], f"the silence was not noticed: {before}, {after}", second)


def wrong_bit(arguments):
    """One bit of one pose, under a valid check sum: the host must see it."""
    flip = frames.FlipOneBit(frames.POSE, step=200, side=1, byte=5)
    recording = os.path.join(arguments.shared, "recordings", "ps2_mouse.events")
    with Bench(arguments, rewrite=flip) as bench:
        run = bench.fence("SERIAL," + recording, "script:parry")
    tell("wrong bit", run)
    require(run.status == 1, "a wrong bit went unnoticed", run)
    named = "step 200: right pose: position x differs: 0x" in run.error
    require(named, "the difference is not named", run)
    print(run.error)


def free(arguments):
    """The device steps by its own clock with samples from here; the host follows it. Its clock goes by instructions, so
    that it has time for every step; what is not taken off the line in time is lost all the same. Where the machine left
    the host no time for that, the host says so: such a run is told, and another one tried."""
    for _ in range(FREE_RUNS):
        with Bench(arguments, BY_INSTRUCTIONS) as bench:
            run = bench.fence("script:attack", "SERIAL", "--seconds", "3")
        if run.status == 0 or "lost" not in run.error or run.link()["device_unsent"] == 0:
            break
        print(f"free: the host was kept from reading: {run.error}")
    tell("free", run)
    require(run.status == 0, "the bout did not come to its end", run)
    require(run.link()["mode"] == "free", "not in free mode", run)
    require(run.summary()["left_samples_used"] > 0, "no sample was used", run)
    require(run.link()["steps_compared"] >= run.summary()["steps"] > 0, "not all compared", run)
    return run


def opponent(arguments):
    """The firmware whose right side an opponent plays: the host knows nothing of it, and follows its samples."""
    run = free(arguments)
    require(run.summary()["right_samples_used"] == run.summary()["steps"], "the opponent did not play every step", run)


SCENARIOS = (mouse, pad, seen, trackpoint, damaged, cut, wrong_bit, free, opponent)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scenario", choices=[scenario.__name__ for scenario in SCENARIOS])
    parser.add_argument("--duel", required=True)
    parser.add_argument("--shared", required=True)
    parser.add_argument("emulator", nargs="+", help="after --")
    arguments = parser.parse_args()
    for needed in (arguments.duel, os.path.join(arguments.shared, "recordings")):
        if not os.path.exists(needed):
            print(f"skipped: there is no {needed}")
            return SKIP
    next(s for s in SCENARIOS if s.__name__ == arguments.scenario)(arguments)
    return 0


if __name__ == "__main__":
    sys.exit(main())
