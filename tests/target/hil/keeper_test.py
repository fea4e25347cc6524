# SPDX-License-Identifier: MIT
"""The keeper against processes that stand for emulators: one that dies, one that works and says nothing, one that says
what is no frame, and one that the machine gives no processor."""

import os
import signal
import socket
import sys
import tempfile
import threading
import time
import unittest

import frames
import keeper
from cable import Cable

DIES = "import sys; sys.exit(3)"
WORKS = "while True: pass"
FRAME = frames.stuff(frames.signed(b"\x02\x87\0\0")) + b"\0"


class KeeperTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.cable = Cable(self.folder.name)
        self.addCleanup(self.cable.close)
        self.device = socket.socket(socket.AF_UNIX)
        self.addCleanup(self.device.close)
        self.device.connect(self.cable.uart)
        self.assertTrue(self.cable.plug_in(lambda: True))
        self.device.setblocking(False)
        os.set_blocking(self.cable.slave, False)
        silence, keeper.SILENCE_S = keeper.SILENCE_S, 0.3
        self.addCleanup(setattr, keeper, "SILENCE_S", silence)

    def watch(self, program):
        self.emulator = keeper.Emulator([sys.executable, "-c", program], "")
        self.addCleanup(self.emulator.kill)
        watching = keeper.Keeper(self.emulator, self.cable)
        watching.start()
        self.addCleanup(watching.stop)
        return watching

    def say(self, data):
        end = self.cable.to_host.passed + len(data)  # before it is said: the cable may be quick
        self.device.sendall(data)
        while self.cable.to_host.passed < end:
            time.sleep(0.001)

    def speak(self, data):
        """Goes on saying it, and being asked, until the test is over."""
        over = threading.Event()

        def turns():
            while not over.wait(0.002) and not self.cable.stop.is_set():
                try:
                    self.device.sendall(data)
                    os.write(self.cable.slave, b"?")
                    os.read(self.cable.slave, 65536)  # or the line would be full one day
                    self.device.recv(65536)
                except OSError:  # nothing there, or hung up meanwhile
                    pass

        thread = threading.Thread(target=turns, daemon=True)
        thread.start()
        self.addCleanup(thread.join)
        self.addCleanup(over.set)

    def assert_hung_up(self, watching, why):
        watching.join()  # Bound: ctest's limit, where the keeper sees nothing
        self.assertIn(why, watching.problem)
        self.assertEqual(self.line_of_the_program(), b"")

    def line_of_the_program(self):
        """b"" where it is gone; BlockingIOError where it is only silent."""
        try:
            while os.read(self.cable.slave, 65536):
                pass
        except BlockingIOError:
            raise
        except OSError:
            pass
        return b""

    def test_one_that_dies_is_noticed_at_once(self):
        watching = self.watch(DIES)
        self.assert_hung_up(watching, "ended by itself, with status 3")

    def test_one_that_works_and_never_speaks_is_given_up(self):
        self.assert_hung_up(self.watch(WORKS), "no intact frame in 0.3 s of the emulator's own time")

    def test_noise_is_no_answer(self):
        self.say(FRAME)
        self.speak(b"noise\0" + FRAME[:-2] + b"\0")
        self.assert_hung_up(self.watch(WORKS), "no intact frame")

    def test_frames_are_an_answer(self):
        self.speak(FRAME)
        watching = self.watch(WORKS)
        while self.emulator.seconds() < 1.5:
            self.assertEqual(watching.problem, "")
            time.sleep(0.01)

    def test_who_is_not_asked_need_not_answer(self):
        self.say(FRAME)
        watching = self.watch(WORKS)
        while self.emulator.seconds() < 1.5:
            self.assertEqual(watching.problem, "")
            time.sleep(0.01)

    def test_one_that_gets_no_processor_is_waited_for(self):
        self.say(FRAME)
        self.speak(b"?")
        watching = self.watch(WORKS)
        os.kill(self.emulator.process.pid, signal.SIGSTOP)
        time.sleep(1.5)  # five times its own
        self.assertEqual(watching.problem, "")
        os.kill(self.emulator.process.pid, signal.SIGCONT)
        self.assert_hung_up(watching, "no intact frame")

    def test_behind_a_cut_cable_nobody_can_answer(self):
        self.say(FRAME)
        self.cable.cut_in(0)
        self.speak(FRAME)
        watching = self.watch(WORKS)
        while self.emulator.seconds() < 1.5:
            self.assertEqual(watching.problem, "")
            time.sleep(0.01)
        self.cable.mend()
        while self.cable.frames.intact < 2:
            time.sleep(0.01)


if __name__ == "__main__":
    unittest.main()
