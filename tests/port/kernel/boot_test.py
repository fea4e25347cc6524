#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What boot.py makes of a run in which something is missing or wrong."""

import unittest

import boot

GOOD = "".join(f"ok {group}: look: 1: 1\n" * count for group, count in boot.CHECKS.items())
GOOD += "the end\nthe guest ended with 0\nthe kernel says\n" + "\n".join(boot.WORDS) + "\nthe kernel has said it\n"


class Judge(unittest.TestCase):
    def wrong(self, text):
        sentences = boot.judge(text, boot.CHECKS)
        self.assertEqual(len(sentences), 1, sentences)
        return sentences[0]

    def test_nothing_is_wrong(self):
        self.assertEqual(boot.judge(GOOD, boot.CHECKS), [])

    def test_a_check_is_wrong(self):
        self.assertIn("look", self.wrong(GOOD.replace("ok spring", "WRONG spring", 1)))

    def test_a_check_is_not_made(self):
        self.assertIn("28 checks", self.wrong(GOOD.replace("ok constant: look: 1: 1\n", "", 1)))

    def test_a_group_is_not_made(self):
        self.assertIn("0 checks", self.wrong(GOOD.replace("ok rumble: look: 1: 1\n", "")))

    def test_a_check_too_many(self):
        self.assertIn("not in the list", self.wrong("ok other: look: 1: 1\n" + GOOD))

    def test_the_program_stops_early(self):
        self.assertIn("gave up", self.wrong("gave up: a gain does not come\n" + GOOD))
        self.assertIn("the end", self.wrong(GOOD.replace("the end\n", "")))
        self.assertIn("ended with 0", self.wrong(GOOD.replace("ended with 0", "ended with 139")))

    def test_an_effect_of_sdl_is_not_played(self):
        good = "ok SDL: look: 1: 1\n" * 23 + GOOD[GOOD.index("the end"):]
        self.assertEqual(boot.judge(good, boot.CHECKS_OF_SDL), [])
        self.assertIn("22 checks", boot.judge(good[good.index("\n") + 1:], boot.CHECKS_OF_SDL)[0])

    def test_the_kernel_is_in_trouble(self):
        self.assertIn("Oops", self.wrong(GOOD + "[ 5.1] Oops: 0002 [#1] PREEMPT SMP\n"))

    def test_the_driver_has_not_found_it(self):
        self.assertIn(boot.WORDS[0], self.wrong(GOOD.replace(boot.WORDS[0], "input: joystick")))


if __name__ == "__main__":
    unittest.main()
