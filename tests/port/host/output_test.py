#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What a program prints and loses, it tells, and ends with 1: output_test.py MESH DUEL ANSWER FEEL MASS."""

import os
import subprocess
import sys
import tempfile
import unittest

MESH, DUEL, ANSWER, FEEL, MASS = sys.argv[1:6]
HEADER = "A0x,A0y,A0z,A1x,A1y,A1z,B0x,B0y,B0z,B1x,B1y,B1z\n"
LINE = "0.0,0.0,0.0,1.0,0.0,0.0,0.0,2.0,-1.0,0.0,2.0,1.0\n"
HANG = 120  # s; what works needs no tenth of them


def ways(folder):
    """Each program and what it is told: all that print something, and each path through a program once."""
    queries, bout = os.path.join(folder, "queries.csv"), os.path.join(folder, "bout.batuta")
    return [
        (DUEL, "--seconds", "0.1"),
        (DUEL, "--seconds", "0.1", "--json"),
        (DUEL, "--help"),
        (DUEL, "--version"),
        (DUEL, "--replay", bout),
        (ANSWER, "distance", "--in", queries, "--out", "-"),
        (ANSWER, "--help"),
        (ANSWER, "toc", "--help"),
        (FEEL,),
        (FEEL, "--help"),
        (FEEL, "--measure"),
        (MASS, MESH),
        (MASS, MESH, "--json"),
        (MASS, "--help"),
    ]


def run_into(sink, words, **options):
    """Runs a program whose standard output is lost: on a full device, in a pipe that nobody reads, or closed."""
    common = {"stderr": subprocess.PIPE, "text": True, "timeout": HANG, "check": False, **options}
    if sink == "full":
        with open("/dev/full", "wb") as full:
            return subprocess.run(words, stdout=full, **common)
    if sink == "closed":
        return subprocess.run(words, preexec_fn=lambda: os.close(1), **common)
    reading, writing = os.pipe()
    os.close(reading)
    try:
        return subprocess.run(words, stdout=writing, **common)
    finally:
        os.close(writing)


SINKS = [sink for sink in ("full", "pipe", "closed") if sink != "full" or os.path.exists("/dev/full")]


class LostOutputTest(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = scratch.name
        with open(os.path.join(self.folder, "queries.csv"), "w", encoding="ascii") as file:
            file.write(HEADER + LINE)
        bout = os.path.join(self.folder, "bout.batuta")
        subprocess.run([DUEL, "--seconds", "0.1", "--record", bout], stdout=subprocess.DEVNULL, timeout=HANG, check=True)

    def assert_told(self, words, done):
        told = "%s: the output cannot be written" % os.path.basename(words[0])
        self.assertEqual((done.returncode, done.stderr.splitlines()), (1, [told]))

    def test_it_is_told(self):
        for words in ways(self.folder):
            good = subprocess.run(words, capture_output=True, timeout=HANG, check=False)
            self.assertEqual(good.returncode, 0, words)
            self.assertNotEqual(good.stdout, b"", words)
            for sink in SINKS:
                with self.subTest(sink=sink, words=words):
                    self.assert_told(words, run_into(sink, words))

    def test_a_bout_whose_log_is_lost_draws_nothing_and_leaves_nothing_half_made(self):
        old = os.path.join(self.folder, "old.svg")
        with open(old, "w", encoding="ascii") as file:
            file.write("an older picture")
        before = sorted(os.listdir(self.folder))
        for sink in SINKS:
            with self.subTest(sink=sink):
                words = (DUEL, "--seconds", "0.1", "--svg", old, "--figure", os.path.join(self.folder, "new.svg"))
                self.assert_told(words, run_into(sink, words))
                self.assertEqual(sorted(os.listdir(self.folder)), before)
                with open(old, encoding="ascii") as file:
                    self.assertEqual(file.read(), "an older picture")

    def test_nothing_is_printed_over_what_is_read(self):
        bout, mesh = os.path.join(self.folder, "bout.batuta"), os.path.join(self.folder, "mesh.obj")
        with open(MESH, "rb") as file, open(mesh, "wb") as copy:
            copy.write(file.read())
        for words, path in (((DUEL, "--replay", bout), bout), ((MASS, mesh), mesh)):
            with open(path, "rb") as file:
                before = file.read()
            for mode in "ab", "r+b":
                with open(path, mode) as printed:
                    done = subprocess.run(words, stdout=printed, stderr=subprocess.PIPE, text=True, timeout=HANG, check=False)
                self.assertEqual((done.returncode, "what is printed goes to" in done.stderr), (2, True), (words, done.stderr))
                with open(path, "rb") as file:
                    self.assertEqual(file.read(), before, words)
            with open(path, "ab") as told:  # the message itself would be written into it
                done = subprocess.run(words, stdout=subprocess.PIPE, stderr=told, timeout=HANG, check=False)
            with open(path, "rb") as file:
                self.assertEqual((done.returncode, done.stdout, file.read()), (2, b"", before), words)

    def test_no_number_is_no_stiffness(self):
        for word in "", " ", "1x", "N":
            done = subprocess.run((FEEL, word), capture_output=True, text=True, timeout=HANG, check=False)
            self.assertEqual((done.returncode, done.stdout), (2, ""), repr(word))

    def test_what_is_not_read_is_not_gone_on_with(self):
        """A bout to 99 touches in real time takes minutes, and questions without end take for ever."""
        words = (DUEL, "--left", "script:attack", "--right", "script:guard", "--touches", "99", "--realtime")
        self.assert_told(words, run_into("pipe", words))
        asking, asked = os.pipe()
        with subprocess.Popen(["sh", "-c", "echo '%s'; exec yes '%s'" % (HEADER.strip(), LINE.strip())], stdout=asked) as endless:
            os.close(asked)
            words = (ANSWER, "distance", "--in", "-", "--out", "-")
            try:
                self.assert_told(words, run_into("pipe", words, stdin=asking))
            finally:
                os.close(asking)
                endless.kill()


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
