#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What is newer than CMake 3.16 is found, and what is not is let through."""

import unittest

from check_cmake import findings_in


class CheckCMake(unittest.TestCase):
    def found(self, text):
        return list(findings_in("CMakeLists.txt", text))

    def test_what_3_16_has_is_let_through(self):
        self.assertEqual(self.found("cmake_minimum_required(VERSION 3.16...3.25)\nlist(TRANSFORM a PREPEND b)\nadd_library(a b.cpp)\n"), [])

    def test_a_newer_command_is_found_with_its_line(self):
        self.assertEqual(self.found("\ncmake_path(SET a b)\n"), ["CMakeLists.txt:2: cmake_path() came with CMake 3.20"])

    def test_a_command_that_nobody_looked_up_is_found(self):
        self.assertEqual(len(self.found("mystery(a)\n")), 1)

    def test_newer_words_are_found(self):
        for text in ("if(PROJECT_IS_TOP_LEVEL)\n", "set(a ${PROJECT_IS_TOP_LEVEL})\n", 'file(CONFIGURE OUTPUT a CONTENT "")\n',
                     "execute_process(COMMAND a COMMAND_ERROR_IS_FATAL ANY)\n", "find_program(A a\n  REQUIRED)\n",
                     "cmake_minimum_required(VERSION 3.20)\n", 'string(JSON a GET "${b}" c)\n'):
            self.assertEqual(len(self.found(text)), 1, text)

    def test_comments_are_not_code(self):
        self.assertEqual(self.found("# cmake_path(SET a b): PROJECT_IS_TOP_LEVEL\n"), [])


if __name__ == "__main__":
    unittest.main()
