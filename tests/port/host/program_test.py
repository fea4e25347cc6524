#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs batuta-duel as a user would: program_test.py PROGRAM SHARED_DIR GROUP. Exit code 77: skipped."""

import json
import math
import os
import pty
import signal
import subprocess
import sys
import tempfile
import tty
import xml.etree.ElementTree
import zlib

PROGRAM, SHARED, GROUP = sys.argv[1:4]
DOCS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "docs")
STICK = "E: 0.000000 0003 0000 %d\nE: 0.000000 0000 0000 0\nE: 0.300000 0003 0000 0\nE: 0.300000 0000 0000 0\n"


def run(*words):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True, timeout=600, check=False)


def check(condition, what):
    if not condition:
        sys.exit("FAILED: %s" % (what,))


def write(folder, name, text):
    path = os.path.join(folder, name)
    with open(path, "w", encoding="utf-8", newline="") as file:
        file.write(text)
    return path


def refuses(words, exit_code, *parts, before=0):
    """The program leaves with the code, nothing on standard output, and one line that holds all parts; before it as many
    lines as a library of others has to say."""
    result = run(*words)
    check(result.returncode == exit_code, (words, result.returncode, result.stderr))
    check(result.stdout == "", (words, result.stdout))
    lines = result.stderr.splitlines()
    check(len(lines) == before + 1 and lines[-1].startswith("batuta-duel: "), (words, result.stderr))
    for part in parts:
        check(part in result.stderr, (words, part, result.stderr))


def objects(result):
    """The lines of --json, each a valid object of finite numbers; the last, and only the last, is the summary."""

    def no_constant(name):
        raise ValueError(name)

    check(result.returncode == 0, result.stderr)
    lines = [json.loads(line, parse_constant=no_constant) for line in result.stdout.splitlines()]
    check([line["type"] for line in lines].index("summary") == len(lines) - 1, "the last line is the summary")
    check(lines[0]["type"] == "start", lines[0])
    return lines


def without_timing(line):
    return {key: value for key, value in line.items() if not key.startswith("host_ns")}


def usage(folder):
    told = run("--help")
    check(told.returncode == 0 and told.stderr == "", told.stderr)
    for word in ("--left", "--right", "--json", "--svg", "--figure", "--view", "--realtime", "--seconds", "--force", "--patience", "script:",
                 "device:/dev/input/", "device:sdl", "Exit codes"):
        check(word in told.stdout, word)
    check(max(map(len, told.stdout.splitlines())) <= 120, "help fits a terminal")
    version = run("--version")
    check(version.returncode == 0 and version.stdout.startswith("batuta-duel "), version)
    refuses(["--nonsense"], 2, "--nonsense")
    refuses(["stray"], 2, "stray")
    refuses(["--left"], 2, "--left")
    for number in ("0", "-1", "x", "nan", "inf", "1e999", "1e300", "4000001", ""):
        refuses(["--seconds", number], 2)
    for seconds, steps in ("0.007", 7), ("1.1", 1100), ("7", 7000):
        waited = run("--left", "script:guard", "--right", "script:guard", "--seconds", seconds, "--json")
        check('"steps":%d,' % steps in waited.stdout, "%s s are %d steps" % (seconds, steps))
    for number in ("0", "-1", "100", "1.5", "x", "nan", "", "010", "0x5"):
        refuses(["--touches=%s" % number], 2, "--touches")
    for number in ("0", "1.4", "10.1", "-4", "x", "nan", "inf", ""):
        refuses(["--distance=%s" % number], 2, "--distance")
    refuses(["--search", "bisection"], 2, "--search")
    refuses(["--left", "banana"], 2, "banana", "unknown source")
    refuses(["--right", "script:riposte"], 2, "script:riposte")
    refuses(["--left", "device:/nonexistent"], 2, "device:/nonexistent: no such device; found: ")
    refuses(["--left", "device:/dev/null"], 2, "not an event device")
    refuses(["--right", "device:sdl:no stick of this name"], 2, "device:sdl:no stick of this name: ")
    refuses(["--force", "perhaps"], 2, "--force")
    for option in "--spring", "--damper":
        for number in ("1.5", "-0.1", "x", "nan", "inf", ""):
            refuses(["%s=%s" % (option, number)], 2, option)
        told = run(option, "0.5", "--seconds", "0.1")
        check(told.returncode == 0 and told.stderr.count("\n") == 1 and option in told.stderr, told.stderr)
    for number in ("0", "0.09", "1001", "-1", "x", "nan", "inf", ""):
        refuses(["--patience=%s" % number], 2, "--patience")
    master, slave = os.openpty()
    refuses(["--left", "serial:" + os.ttyname(slave), "--patience", "5.1"], 1, "no answer to Hello within 5100 ms")
    os.close(slave)
    os.close(master)
    refuses(["--left", "serial:/dev/null"], 2, "/dev/null")
    refuses(["--left", "serial:" + os.path.join(folder, "none")], 2, "none")
    refuses(["--left", "serial:/dev/null@12"], 2, "unknown rate of 12 baud")
    refuses(["--left", "serial:a", "--right", "serial:b"], 2, "one device at a time")
    refuses(["--left", "none.events"], 2, "none.events: no such file")
    refuses(["--left", folder], 2, "cannot be read")
    refuses(["--left", "/dev/zero"], 2, "/dev/zero: a device and no recording; write device:/dev/zero or serial:")
    for option in "--svg", "--figure":
        refuses([option, os.path.join(folder, "none", "bout.svg")], 1, "cannot be written")
        if os.path.exists("/dev/full"):
            full = run("--seconds", "0.1", option, "/dev/full")
            check(full.returncode == 1 and "/dev/full" in full.stderr, full)


def recordings(folder):
    bad = write(folder, "bad.events", STICK % 5 + "E: 0.4 0003 0000 1\n")
    refuses(["--left", bad], 2, "bad.events:5: ")
    refuses(["--left", write(folder, "empty.events", "")], 2, "holds no events")
    keys = "E: 0.000000 0001 001e 1\nE: 0.000000 0000 0000 0\n"
    refuses(["--left", write(folder, "keys.events", keys)], 2, "no motion")
    refuses(["--left", write(folder, "odd.events", "N: x\nI: y\n" + STICK % 5)], 2, "description", before=1)
    guessed = run("--left", write(folder, "guess.evemu", (STICK % 5).replace("\n", "\r\n")), "--right", "script:guard")
    check(guessed.returncode == 0, guessed.stderr)
    check("guess.evemu: " in guessed.stderr and guessed.stderr.count("\n") == 1, guessed.stderr)
    short = write(folder, "short.events", STICK % 5)
    two = objects(run("--left", short, "--right", "script:guard", "--seconds", "1", "--json"))[-1]
    check(two["result"] == "draw" and two["left_source_ended"] is True, two)
    check(two["simulated_seconds"] == 1, two)
    check(two["left_unplugs"] == 0, two)
    paced = run("--left", short, "--right", "script:guard", "--realtime", "--json")
    objects(paced)


def json_lines(_):
    first = objects(run("--json"))
    second = objects(run("--json"))
    check(list(map(without_timing, first)) == list(map(without_timing, second)), "two runs differ")
    summary = first[-1]
    for key in ("steps", "simulated_seconds", "left_samples_used", "right_samples_rejected", "beats", "rests", "begin",
                "persist", "end", "smallest_gap", "deepest_overlap", "events_not_recorded", "budget_outs",
                "host_ns_per_step_mean", "host_ns_per_step_max", "result", "touch_by", "touch_part", "touch_time"):
        check(key in summary, key)
    check(objects(run("--json", "--seconds", "0.1"))[0]["touches"] == 5, "a bout is to five touches")
    contacts = [line for line in first if line["type"] == "contact"]
    count = {event: sum(line["event"] == event for line in contacts) for event in ("begin", "persist", "end")}
    check(summary["begin"] == count["begin"] and summary["end"] == count["end"], count)
    check(summary["persist"] >= count["persist"], count)
    colliding = sum(line["kind"] == "colliding" and line["event"] != "end" for line in contacts)
    check(summary["blows"] == colliding + summary["events_not_recorded"], (summary["blows"], colliding))
    times = [line["time"] for line in contacts]
    check(times == sorted(times), "contacts are in the order of time")
    check(all(abs(math.hypot(*line["normal"]) - 1) < 1e-6 for line in contacts), "normals are unit")
    touch = [line for line in first if line["type"] == "touch"]
    check(len(touch) == 1 and touch[0]["by"] == summary["touch_by"] == summary["result"] == "left", touch)
    # A lunge of who stays bridges 2.3 m; with an opponent that sees, both start further off.
    for more, distance, score in (([], 2.25, 1), (["--distance", "1.8"], 1.8, 1), (["--distance", "2.9"], 2.9, 0)):
        told = objects(run("--json", "--left", "script:attack", "--right", "script:guard", "--touches", "1",
                           "--seconds", "5", *more))
        check(abs(told[0]["distance"] - distance) < 1e-6 and told[-1]["score_left"] == score, told[-1])
    told = objects(run("--json", "--left", "script:attack", "--right", "script:club", "--seconds", "0.1"))
    check(told[0]["distance"] == 4, told[0])
    for search in ("advancement", "stepping"):
        told = objects(run("--json", "--left", "script:attack", "--right", "script:guard", "--touches", "3", "--search", search))
        check(told[0]["search"] == search and told[0]["touches"] == 3, told[0])
        check([line["exchange"] for line in told if line["type"] == "touch"] == [1, 2, 3], told)
        check([line["score_left"] for line in told if line["type"] == "halt"] == [1, 2], told)
        check(told[-1]["score_left"] == 3 and told[-1]["exchanges"] == 3 and told[-1]["result"] == "left", told[-1])


def picture(folder):
    sizes = []
    for words in ([], ["--left", "script:guard", "--right", "script:parry"], ["--seconds", "0.001"]):
        path = os.path.join(folder, "bout.svg")
        check(run("--svg", path, *words).returncode == 0, words)
        root = xml.etree.ElementTree.parse(path).getroot()
        check(root.tag == "{http://www.w3.org/2000/svg}svg", root.tag)
        sizes.append(os.path.getsize(path))
    check(max(sizes) < 400000, sizes)
    beat = max((line for line in objects(run("--json", "--figure", path)) if line["type"] == "contact"
                and line["event"] == "begin" and line["kind"] == "colliding"), key=lambda line: line["impulse"])
    with open(path, "rb") as made, open(os.path.join(DOCS, "hardest_beat.svg"), "rb") as shown:
        check(made.read() == shown.read(), "docs/hardest_beat.svg is made anew by: batuta-duel --figure docs/hardest_beat.svg")
    attack = ["--touches", "1", "--left", "script:attack", "--right", "script:guard"]
    check(run(*attack, "--strip", path).returncode == 0, "--strip")
    with open(path, "rb") as made, open(os.path.join(DOCS, "touch_strip.svg"), "rb") as shown:
        check(made.read() == shown.read(), "docs/touch_strip.svg is made anew by: batuta-duel --strip, as docs/programs.md says")
    check(run("--json", "--figure", path).returncode == 0, "--figure")
    told = "".join(xml.etree.ElementTree.parse(path).getroot().itertext())
    check("at %.3f s, %.3f N s, blades closing at %.2f m/s" %
          (beat["time"], beat["impulse"], -beat["relative_velocity"]) in told, told)
    hard = run("--left", "script:club", "--right", "script:master@3", "--touches", "2", "--figure", path)
    check(hard.returncode == 0, hard)
    for line in xml.etree.ElementTree.parse(path).getroot().iter("{http://www.w3.org/2000/svg}line"):
        ends = [float(line.get(key)) for key in ("x1", "y1", "x2", "y2")]
        check(all(0 <= x <= 1280 for x in ends[::2]) and all(0 <= y <= 760 for y in ends[1::2]), "%s leaves the figure" % ends)
    name = write(folder, "a<b>&'\"\u00fc.events", STICK % 5)
    check(run("--left", name, "--svg", path).returncode == 0, name)
    xml.etree.ElementTree.parse(path)


def replay(folder):
    """A recorded bout is the same when it is gone through again; what is not, is told from it."""
    path = os.path.join(folder, "bout.batuta")
    bout = run("--left", "script:attack", "--right", "script:parry", "--json", "--record", path)
    steps = objects(bout)[-1]["steps"]
    again = run("--replay", path)
    check(again.returncode == 0, again.stderr)
    with open(path, "rb") as file:
        whole = file.read()
    told = "%d steps, %d hashes agreed, search advancement, hash %016x\n" % (steps, steps + 1, int.from_bytes(whole[-16:-8], "little"))
    check(again.stdout.endswith(told), again.stdout)

    def altered(name, content):
        other = os.path.join(folder, name)
        with open(other, "wb") as file:
            file.write(content)
        return other

    refuses(["--replay", altered("cut", whole[:-1])], 1, "%d steps" % steps, "end mark")
    for more in (b"\0", whole):
        refuses(["--replay", altered("longer", whole + more)], 1, "%d steps" % steps, "goes on behind its end mark")
    middle = len(whole) // 2
    spoilt = whole[:middle] + bytes([whole[middle] ^ 1]) + whole[middle + 1:]
    refuses(["--replay", altered("damaged", spoilt)], 1, "damaged")
    refuses(["--replay", altered("foreign", b"x" * 1000)], 2, "not a recording")
    scene = bytes([whole[8] ^ 1])
    refuses(["--replay", altered("other", whole[:8] + scene + whole[9:])], 2, "another scene")
    run_at = 20 + int.from_bytes(whole[16:20], "little") + 4  # behind the state at the start
    check(whole[run_at:run_at + 1] == b"R", whole[run_at:run_at + 8])
    body = whole[run_at:run_at + 3] + b"\1" + whole[run_at + 4:run_at + 17]
    older = body + zlib.crc32(body).to_bytes(4, "little") + whole[run_at + 21:]
    refuses(["--replay", altered("older", whole[:run_at] + older)], 2, "version 1", "version 2")
    for version in (0, 2, 513):
        state = whole[:4] + version.to_bytes(2, "little") + whole[6:]
        refuses(["--replay", altered("state", state)], 2, "version %d of the format of states" % version, "reads version 1")
    refuses(["--replay", altered("word", whole[:4] + b"\7\0\0\7" + whole[8:])], 2, "version 7 ", "reads version 1")
    refuses(["--replay", altered("zero", whole[:7] + b"\1" + whole[8:])], 1, "damaged before its first step")
    for name in "foreign", "other", "older", "state", "word":
        told = run("--replay", os.path.join(folder, name)).stderr
        check("hashes" not in told and "steps" not in told, told)
    refuses(["--replay", altered("head", whole[:run_at])], 1, "ends before its first step")
    spoilt_start = whole[:run_at - 5] + bytes([whole[run_at - 5] ^ 1]) + whole[run_at - 4:]
    refuses(["--replay", altered("start", spoilt_start)], 1, "damaged before its first step")
    paper = os.path.join(folder, "paper.batuta")
    check(run("--search", "stepping", "--touches", "2", "--seconds", "3", "--record", paper).returncode == 0, "stepping")
    again = run("--replay", paper)
    check(again.returncode == 0 and "3000 steps, 3001 hashes agreed, search stepping" in again.stdout, again)
    refuses(["--replay", os.path.join(folder, "absent")], 2, "absent")
    refuses(["--replay", path, "--left", "default"], 2, "--left")
    refuses(["--replay", path, "--record", path], 2, "--record")
    failed = run("--record", os.path.join(folder, "no", "such", "folder"))
    check(failed.returncode == 1, failed.returncode)
    refuses(["--replay", folder], 2, folder)
    refuses(["--replay", altered("nothing", b"")], 2, "is empty")
    refuses(["--replay", path, "--figure", path], 2, "--figure")
    for option in "--record", "--replay", "--svg", "--figure":
        refuses([option, ""], 2, option)


def contents(path):
    with open(path, "rb") as file:
        return file.read()


def files(folder):
    """Nothing that is read is written over, no output is written over another, and none is ever half there."""
    short = write(folder, "short.events", STICK % 5)
    described = write(folder, "short.desc", "# EVEMU 1.3\nN: a stick\nI: 0003 0001 0002 0003\nP: 00 00 00 00 00 00 00 00\n"
                      "B: 00 0b 00 00 00 00 00 00 00\nB: 03 03 00 00 00 00 00 00 00\n"
                      "A: 00 -100 100 0 0 0\nA: 01 -100 100 0 20 0\n")
    soft, hard = os.path.join(folder, "short.soft.events"), os.path.join(folder, "hard")
    os.symlink(short, soft)
    os.link(short, hard)
    before = contents(short), contents(described)
    roundabout = os.path.join(folder, "..", os.path.basename(folder), "short.events")
    for option in "--record", "--svg", "--figure", "--strip":
        for name in short, soft, hard, roundabout, described:
            for side in "--left", "--right":
                refuses([side, short, option, name], 2, option, "is read by " + side)
        refuses(["--left", soft, option, short], 2, option, "is read by --left")
        refuses(["--left", "serial:/dev/null," + short, option, short], 2, option, "is read by --left")
    check((contents(short), contents(described)) == before, "the recording is what it was")

    out = os.path.join(folder, "out")
    for one, other in ("--svg", "--record"), ("--figure", "--strip"), ("--svg", "--strip"):
        refuses([one, out, other, os.path.join(folder, ".", "out")], 2, "is what --", " writes")
    check(not os.path.exists(out), "nothing was begun")
    check(run("--seconds", "0.1", "--svg", "/dev/null", "--record", "/dev/null").returncode == 0, "/dev/null holds both")

    old = write(folder, "old.svg", "an older picture")
    link = os.path.join(folder, "link.svg")
    os.symlink(old, link)
    refuses(["--svg", old, "--record", os.path.join(folder, "no", "such")], 1, "no")
    check(contents(old) == b"an older picture", "what was not made does not replace it")
    running = subprocess.Popen([PROGRAM, "--realtime", "--svg", old, "--record", out], stdout=subprocess.PIPE)
    running.stdout.readline()
    running.kill()
    running.wait()
    running.stdout.close()
    check(contents(old) == b"an older picture" and not os.path.exists(out), "nor does half of one")
    for name in os.listdir(folder):
        if name.endswith(".part"):
            os.remove(os.path.join(folder, name))
    check(run("--seconds", "0.1", "--svg", link).returncode == 0, "through a link")
    check(os.path.islink(link) and contents(old).startswith(b"<"), "the link stays, its file is new")
    check(not any(name.endswith(".part") for name in os.listdir(folder)), os.listdir(folder))


def refused_with(stream, mode, path, option, name):
    """Where the shell has opened an output for what is printed."""
    with open(path, mode) as opened:
        result = subprocess.run([PROGRAM, "--seconds", "0.1", option, name], timeout=600, check=False,
                                **{"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, stream: opened})
    check(result.returncode == 2, (stream, mode, option, name, result))
    return result.stderr or b""


def printed(folder):
    """No output takes the place of what is printed, and what was in its file stays."""
    both = write(folder, "both", "older lines\n")
    for option in "--record", "--svg", "--figure", "--strip":
        for name in both, "/dev/stdout", "/proc/self/fd/1":
            said = refused_with("stdout", "a", both, option, name)
            check(b"is what is printed to" in said, said)
        refused_with("stderr", "a", both, option, both)
    check(contents(both).startswith(b"older lines\nbatuta-duel: --record"), contents(both))
    refused_with("stdout", "w", both, "--svg", both)
    check(contents(both) == b"" and os.listdir(folder) == ["both"], os.listdir(folder))


def permissions_and_links(folder):
    """Who may not read an output may not read the next one; a link to what is not there yet is followed."""
    private = write(folder, "private.svg", "an older picture")
    for mode in 0o600, 0o640, 0o400:
        os.chmod(private, mode)
        check(run("--seconds", "0.1", "--svg", private).returncode == 0, oct(mode))
        check(os.stat(private).st_mode & 0o777 == mode and contents(private).startswith(b"<"), oct(mode))
    os.makedirs(os.path.join(folder, "deep"))
    new, first, second = (os.path.join(folder, name) for name in ("new.svg", "first", "deep/second"))
    os.symlink("new.svg", first)
    os.symlink("../first", second)
    refuses(["--svg", first, "--figure", second], 2, "is what --", " writes")
    check(run("--seconds", "0.1", "--svg", second).returncode == 0, "links to what is not there")
    check(os.path.islink(first) and os.path.islink(second) and contents(new).startswith(b"<"), os.listdir(folder))
    round_ = os.path.join(folder, "round")
    os.symlink("round", round_)
    refuses(["--seconds", "0.1", "--svg", round_], 1, "round", "symbolic link")
    check(os.path.islink(round_), "it is what it was")


def second_signal(folder):
    """The first signal ends the bout; the second one the program, and then nothing is left beside an output."""
    out = os.path.join(folder, "out.svg")
    for numbers in (signal.SIGHUP, signal.SIGINT), (signal.SIGTERM, signal.SIGTERM), (signal.SIGINT, signal.SIGTERM):
        running = subprocess.Popen([PROGRAM, "--realtime", "--svg", out], stdout=subprocess.PIPE)
        running.stdout.readline()
        check(any(name.endswith(".part") for name in os.listdir(folder)), "it is begun")
        running.send_signal(signal.SIGSTOP)  # so that it cannot end by the first one
        for number in numbers:
            running.send_signal(number)
        running.send_signal(signal.SIGCONT)
        running.communicate(timeout=600)
        check(not any(name.endswith(".part") for name in os.listdir(folder)), os.listdir(folder))


def each_is_ended(folder):
    """An output that cannot be written takes no other one with it; a bout is not printed over its recording; who waits for
    the other end of a pipe ends by the first signal."""
    record = os.path.join(folder, "bout")
    if os.path.exists("/dev/full"):
        refused = run("--seconds", "0.2", "--record", record, "--svg", "/dev/full")
        check(refused.returncode == 1 and "/dev/full: cannot be written: No space" in refused.stderr, refused)
        check(run("--replay", record).returncode == 0, "what was recorded is kept")
        refused = run("--seconds", "0.2", "--record", "/dev/full")
        check(refused.returncode == 1 and "/dev/full: cannot be written: No space" in refused.stderr, refused)
    else:
        check(run("--seconds", "0.2", "--record", record).returncode == 0, "recorded")
    before = contents(record)
    with open(record, "r+b") as opened:
        result = subprocess.run([PROGRAM, "--replay", record], stdout=opened, stderr=subprocess.PIPE, check=False, timeout=600)
    check(result.returncode == 2 and b"what --replay reads" in result.stderr, result)
    check(contents(record) == before, "it is what it was")
    pipe = os.path.join(folder, "pipe")
    os.mkfifo(pipe)
    for number in signal.SIGHUP, signal.SIGTERM:
        waiting = subprocess.Popen([PROGRAM, "--seconds", "0.1", "--svg", pipe], stdout=subprocess.PIPE)
        try:
            waiting.wait(timeout=1)
        except subprocess.TimeoutExpired:
            waiting.send_signal(number)
        check(waiting.wait(timeout=60) == -number, waiting.returncode)
        waiting.stdout.close()


def silent_board(folder):
    """A board that says nothing: what was recorded before stays, and the first signal ends who waits for it."""
    record = write(folder, "bout", "an older recording")
    board, port = pty.openpty()
    tty.setraw(port)
    words = [PROGRAM, "--left", "serial:" + os.ttyname(port), "--record", record]
    failed = subprocess.run([*words, "--patience", "0.5"], capture_output=True, timeout=600, check=False)
    check(failed.returncode == 1, failed)
    check(contents(record) == b"an older recording" and os.listdir(folder) == ["bout"], os.listdir(folder))
    for number in signal.SIGINT, signal.SIGTERM:
        waiting = subprocess.Popen([*words, "--patience", "1000"])
        while len(os.listdir(folder)) < 2:
            check(waiting.poll() is None, "it waits")
        waiting.send_signal(number)
        check(waiting.wait(timeout=60) == -number, waiting.returncode)
        check(os.listdir(folder) == ["bout"], os.listdir(folder))
    os.close(board)
    os.close(port)


def outputs(folder):
    for index, part in enumerate((printed, permissions_and_links, second_signal, each_is_ended, silent_board)):
        own = os.path.join(folder, str(index))
        os.makedirs(own)
        part(own)


def real(_):
    folder = os.path.join(SHARED, "recordings")
    if not os.path.isdir(folder):
        print("skipped: there is no", folder)
        sys.exit(77)
    names = sorted(name for name in os.listdir(folder) if name.endswith((".events", ".evemu")))
    check(names, "no recordings")
    for name in names:
        for right in ("script:guard", "script:parry", "script:attack"):
            result = run("--left", os.path.join(folder, name), "--right", right, "--json")
            check(result.stderr == "", result.stderr)
            summary = objects(result)[-1]
            check(summary["left_samples_used"] > 10, summary)
            check(summary["left_samples_rejected"] == 0, summary)


GROUPS = {"Usage": usage, "Recordings": recordings, "Json": json_lines, "Picture": picture, "Replay": replay, "Files": files,
          "Outputs": outputs,
          "RealDevices": real}
with tempfile.TemporaryDirectory() as scratch:
    GROUPS[GROUP](scratch)
