#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs batuta-duel --view as a user would, on a display in memory: view_program_test.py PROGRAM GROUP. Exit code 77: skipped,
there is no Xvfb or no libX11."""

import ctypes
import ctypes.util
import json
import mmap
import os
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time

PROGRAM, GROUP = sys.argv[1:3]
PATIENCE = 300  # s, of a test that fails
SIZE = (1280, 1200)
WINDOW = (1060, 1086)  # of ViewScreen: the screen has room for it
RED = (215, 0, 30)


def check(condition, what):
    if not condition:
        sys.exit("FAILED: %s" % (what,))


def soon(condition, what):
    """Waits until something is there and returns it."""
    deadline = time.monotonic() + PATIENCE
    while time.monotonic() < deadline:
        found = condition()
        if found:
            return found
        time.sleep(0.02)
    return check(False, what)


class Display:
    """Xvfb, whose screen is a file, and a keyboard for its window."""

    def __init__(self, folder):
        read, write = os.pipe()
        self.process = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", "%dx%dx24" % SIZE, "-fbdir", folder, "-nolisten", "tcp"],
            pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as number:
            self.name = ":" + number.readline().strip()
        check(self.name != ":", "Xvfb does not start")
        with open(os.path.join(folder, "Xvfb_screen0"), "rb") as file:
            self.screen = mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)
        head = struct.unpack(">25I", self.screen[:100])  # XWDFileHeader
        self.pitch, self.start = head[12], head[0] + 12 * head[19]

    def close(self):
        self.process.terminate()
        self.process.wait()

    def die(self):
        self.process.kill()
        self.process.wait()

    def pixel(self, x, y):
        at = self.start + int(y) * self.pitch + 4 * int(x)
        blue, green, red = self.screen[at:at + 3]
        return red, green, blue

    def origin(self):
        """Upper left corner of the window, which is the only thing on a black screen; None: it is not there."""
        x, y = (SIZE[0] - WINDOW[0]) // 2, (SIZE[1] - WINDOW[1]) // 2
        inside = [self.pixel(x + 3, y + 3), self.pixel(x + WINDOW[0] - 4, y + WINDOW[1] - 4)]
        outside = [self.pixel(x - 3, y + 3), self.pixel(x + WINDOW[0] + 3, y + 3)]
        return (x, y) if inside == [(255, 255, 255)] * 2 and outside == [(0, 0, 0)] * 2 else None

    def part(self, left, top, width, height):
        x, y = self.origin()
        rows = range(y + top, y + top + height)
        return [self.screen[self.start + row * self.pitch + 4 * (x + left):][:4 * width] for row in rows]

    def for_each_window(self, call):
        """Calls with libX11, this display, its root and a window of it."""
        x11 = ctypes.CDLL(ctypes.util.find_library("X11") or "libX11.so.6")
        x11.XOpenDisplay.restype = ctypes.c_void_p
        display = ctypes.c_void_p(x11.XOpenDisplay(self.name.encode()))
        root = ctypes.c_ulong(x11.XDefaultRootWindow(display))
        ids, windows = [ctypes.c_ulong(), ctypes.c_ulong()], ctypes.POINTER(ctypes.c_ulong)()
        count = ctypes.c_uint()
        x11.XQueryTree(display, root, ctypes.byref(ids[0]), ctypes.byref(ids[1]), ctypes.byref(windows), ctypes.byref(count))
        for window in windows[:count.value]:
            call(x11, display, root, window)
        x11.XSync(display, 0)
        x11.XCloseDisplay(display)

    def press(self, key):
        """Sends a key to the window, as XSendEvent(3) does."""
        def send(x11, display, root, window):
            code = x11.XKeysymToKeycode(display, ctypes.c_ulong(ord(key)))
            for kind, mask in ((2, 1), (3, 2)):  # KeyPress, KeyRelease
                # XKeyEvent: type, serial, send_event, display, window, root, subwindow, time, 4 coordinates, state, code, same
                event = struct.pack("@iLiPLLLLiiiiIIi", kind, 0, 1, display.value, window, root.value, 0, 0, 1, 1, 1, 1, 0,
                                    code, 1)
                x11.XSendEvent(display, ctypes.c_ulong(window), 1, ctypes.c_long(mask), event + bytes(192 - len(event)))
        self.for_each_window(send)

    def take_window(self):
        """Destroys the window, as only its program should: an error to that, but no loss of the display."""
        self.for_each_window(lambda x11, display, root, window: x11.XDestroyWindow(display, ctypes.c_ulong(window)))


def environment(display=None, folder=None):
    more = {"XDG_RUNTIME_DIR": folder} if folder else {}
    if display:
        more["DISPLAY"] = display
    kept = {key: value for key, value in os.environ.items()
            if key not in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER")}
    return {**kept, **more}


def start(display, folder, *words):
    return subprocess.Popen([PROGRAM, "--view", *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                            env=environment(display.name, folder))


def lines_until(bout, word):
    lines = []
    while not lines or word not in lines[-1]:
        line = bout.stdout.readline()
        check(line, (word, lines))
        lines.append(line)
    return lines


def leave(bout, display=None):
    """With the key, or an interrupt. @returns the rest of what it said"""
    if display:
        display.press("q")
    else:
        bout.send_signal(signal.SIGINT)
    try:
        rest, errors = bout.communicate(timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        bout.kill()
        raise
    check(bout.returncode == 0 and errors == "", (bout.returncode, errors))
    return rest


def no_display(folder):
    for words in ([], ["--replay", os.path.join(folder, "none")]):
        result = subprocess.run([PROGRAM, "--view", *words], capture_output=True, text=True, timeout=PATIENCE, check=False,
                                env=environment(folder=folder))
        check(result.returncode == 2 and result.stdout == "", result)
        last = result.stderr.splitlines()[-1]
        check(last.startswith("batuta-duel: --view: ") and ("no window" in last or "without SDL2" in last), result.stderr)


def on_pixels(point):
    """From the salle to the window: from the side, from above."""
    return [(30 + 250 * (2 + point[0]), 96 + 250 * (2 - point[2])), (30 + 250 * (2 + point[0]), 628 + 250 * (0.7 - point[1]))]


def bout_in_sight(folder, display):
    """The same bout as without the window; it stays in sight, with its star and its score."""
    words = ["--left", "script:attack", "--right", "script:guard", "--json"]
    plain = subprocess.run([PROGRAM, *words], capture_output=True, text=True, timeout=PATIENCE, check=False)
    bout = start(display, folder, *words)
    lines = lines_until(bout, '"start"')
    origin = soon(display.origin, "there is no window")
    left, right = (440, 990, 70, 62), (550, 990, 70, 62)
    score = [display.part(*left), display.part(*right)]
    lines += lines_until(bout, '"summary"')
    told, wanted = ([{key: value for key, value in json.loads(line).items() if not key.startswith("host_ns")} for line in text]
                    for text in (lines, plain.stdout.splitlines()))
    check(told == wanted, "the window changes the bout")
    touch = [line for line in told if line["type"] == "touch"][0]
    for x, y in on_pixels(touch["point"]):
        soon(lambda x=x, y=y: display.pixel(origin[0] + x, origin[1] + y) == RED, ("no star at", x, y))
    check(touch["by"] == "left", touch)
    check(display.part(*left) != score[0] and display.part(*right) == score[1], "the score is not 1 : 0")
    check(leave(bout, display) == "", "something came after the summary")


def restart(folder, display):
    """R begins again, with files of their own; the second bout is the first one once more."""
    svg, record = os.path.join(folder, "bout.svg"), os.path.join(folder, "bout.batuta")
    bout = start(display, folder, "--left", "script:attack", "--right", "script:guard", "--json", "--svg", svg, "--record", record)
    summaries = []
    for _ in range(2):
        lines = lines_until(bout, '"summary"')
        summaries.append({key: value for key, value in json.loads(lines[-1]).items() if not key.startswith("host_ns")})
        if len(summaries) < 2:
            soon(display.origin, "there is no window")
            display.press("r")
    check(summaries[0] == summaries[1], summaries)
    check(leave(bout) == "", "something came after the summary")
    with open(svg, encoding="utf-8") as file:
        check(file.read().count("</svg>") == 1, "two pictures in one file")
    again = subprocess.run([PROGRAM, "--replay", record], capture_output=True, text=True, timeout=PATIENCE, check=False)
    check(again.returncode == 0, again)


def replayed(folder, display):
    """A recording in the window; paused before its end, it says how far it came."""
    record = os.path.join(folder, "bout.batuta")
    words = ["--left", "script:attack", "--right", "script:guard", "--touches", "1", "--json", "--record", record]
    plain = subprocess.run([PROGRAM, *words], capture_output=True, text=True, timeout=PATIENCE, check=False)
    lines = [json.loads(line) for line in plain.stdout.splitlines()]
    touch = [line for line in lines if line["type"] == "touch"][0]
    bout = start(display, folder, "--replay", record)
    origin = soon(display.origin, "there is no window")
    for x, y in on_pixels(touch["point"]):
        soon(lambda x=x, y=y: display.pixel(origin[0] + x, origin[1] + y) == RED, ("no star at", x, y))
    time.sleep(0.5)  # a bout ends a moment after its touch
    check("%d steps" % lines[-1]["steps"] in leave(bout, display), "not all of it was shown")
    bout = start(display, folder, "--replay", record)
    soon(display.origin, "there is no window")
    display.press(" ")
    check("broken off" in leave(bout, display), "it was left before its end")


def skip_without_xvfb():
    if shutil.which("Xvfb") is None or not (ctypes.util.find_library("X11") or os.path.exists("/usr/lib/libX11.so.6")):
        print("skipped: Xvfb or libX11 is not installed")
        sys.exit(77)


def lost(folder):
    """Its window goes, with the display or alone: what is written is finished all the same, and it is told."""
    skip_without_xvfb()
    svg, record = os.path.join(folder, "bout.svg"), os.path.join(folder, "bout.batuta")
    fencers = ["--left", "script:guard", "--right", "script:guard"]

    def lose(words, lose_it):
        display = Display(folder)
        try:
            bout = start(display, folder, *words)
            soon(display.origin, "there is no window")
            time.sleep(0.3)  # some steps of the bout
            lose_it(display)
            said, errors = bout.communicate(timeout=PATIENCE)
        finally:
            display.close()
        check(bout.returncode == 1 and "--view: the window is lost" in errors.splitlines()[-1], (bout.returncode, errors))
        return said

    for lose_it in (Display.die, Display.take_window):
        said = lose([*fencers, "--json", "--svg", svg, "--record", record], lose_it)
        steps = json.loads(said.splitlines()[-1])["steps"]
        with open(svg, encoding="utf-8") as file:
            check(file.read().rstrip().endswith("</svg>"), "the picture is not whole")
        again = subprocess.run([PROGRAM, "--replay", record], capture_output=True, text=True, timeout=PATIENCE, check=False)
        check(again.returncode == 0 and "%d steps" % steps in again.stdout, (again, steps))
        check(not [name for name in os.listdir(folder) if name.endswith(".part")], "something is left beside its place")
        for file in svg, record:
            os.remove(file)
    over = ["--seconds", "0.1", "--record", record]
    lose([*fencers, *over], Display.die)  # a bout that is over, and in sight
    check(os.path.exists(record), "the recording of a bout that is over is lost")
    longer = subprocess.run([PROGRAM, *fencers, "--seconds", "100", "--record", record], capture_output=True, timeout=PATIENCE,
                            check=False)
    check(longer.returncode == 0, longer)
    check("broken off" in lose(["--replay", record], Display.die), "a replay whose window is lost goes on")


def on_a_display(group):
    def with_display(folder):
        skip_without_xvfb()
        display = Display(folder)
        try:
            group(folder, display)
        finally:
            display.close()
    return with_display


GROUPS = {"NoDisplay": no_display, "InSight": on_a_display(bout_in_sight), "Restart": on_a_display(restart),
          "Replay": on_a_display(replayed),
          "Lost": lost}
with tempfile.TemporaryDirectory() as scratch:
    GROUPS[GROUP](scratch)
