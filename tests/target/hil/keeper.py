# SPDX-License-Identifier: MIT
"""How long an emulator is waited for: as long as it lives, and in its own time. A busy machine makes it slow, never
silent: an emulator that gets no processor spends no time."""

import os
import subprocess
import threading

SILENCE_S = 1.5  # of the emulator's processor time: that of some hundred steps; 20 s where it only idles
LOOK_S = 0.05  # between two looks
TICKS = os.sysconf("SC_CLK_TCK")


def seconds_of(process):
    """Processor time that it has spent."""
    try:
        with open(f"/proc/{process.pid}/stat", encoding="ascii", errors="replace") as file:
            fields = file.read().rpartition(")")[2].split()
    except OSError:
        return 0.0
    return (int(fields[11]) + int(fields[12])) / TICKS  # utime, stime


class Emulator:
    def __init__(self, command, options):
        environment = dict(os.environ)
        environment["BATUTA_QEMU_OPTIONS"] = f"{environment.get('BATUTA_QEMU_OPTIONS', '')} {options}".strip()
        self.process = subprocess.Popen(command, env=environment)

    def ending(self):
        """None while it lives."""
        return self.process.poll()

    def seconds(self):
        return seconds_of(self.process)

    def kill(self):
        self.process.kill()
        self.process.wait()


class Keeper(threading.Thread):
    """Hangs the cable up as soon as the emulator has ended, or when it has spent SILENCE_S without an intact frame
    although it was asked for one. The host's program then ends at once: its line is gone."""

    def __init__(self, emulator, cable):
        super().__init__(daemon=True)
        self.emulator = emulator
        self.cable = cable
        self.problem = ""
        self.over = threading.Event()
        self.heard = -1  # frames, at the last look that brought one
        self.asked = 0   # bytes to the device by then
        self.since = 0.0

    def run(self):
        while not self.problem and not self.over.wait(LOOK_S):
            self.look()
        if self.problem:
            self.cable.hang_up()

    def look(self):
        if self.emulator.ending() is not None:
            self.problem = f"the emulator has ended by itself, with status {self.emulator.ending()}"
            return
        spent = self.emulator.seconds()
        cable = self.cable
        waited_for = cable.frames.intact == 0 or cable.to_device.passed != self.asked
        if cable.frames.intact != self.heard or cable.is_cut() or not waited_for:
            self.heard, self.asked, self.since = cable.frames.intact, cable.to_device.passed, spent
        elif spent - self.since > SILENCE_S:
            self.problem = f"no intact frame in {SILENCE_S:g} s of the emulator's own time"

    def stop(self):
        self.over.set()
        self.join()
