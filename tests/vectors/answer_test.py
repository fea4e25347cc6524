# SPDX-License-Identifier: MIT
"""The program batuta-answer from the outside: a good file, bad lines, a missing file, wrong usage.

usage: answer_test.py PROGRAM
"""
import csv
import math
import os
import resource
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = sys.argv.pop()
METHODS = ["advancement", "translation", "stepping"]


def bits(x):
    """The float32 bits of x, as the query files write them."""
    return struct.pack(">f", x).hex().rstrip("0") or "0"


def vec(name):
    return [name + axis for axis in "xyz"]


def body_columns(b, ends):
    columns = vec(b + "c") + [b + "qw"] + vec(b + "q") + vec(b + "v") + vec(b + "w")
    return columns + (vec(b + "e0") + vec(b + "e1") + [b + "r"] if ends else [])


def toc_file(speed, radius=0.1, turn=0):
    """T01: two parallel capsules, B comes from x = 3 and turns about z."""
    header = ["family", "T"] + body_columns("A", True) + body_columns("B", True)
    pose = [1, 0, 0, 0]
    ends = [0, -1, 0, 0, 1, 0, radius]
    A = [0, 0, 0] + pose + [0, 0, 0, 0, 0, 0] + ends
    B = [3, 0, 0] + pose + [speed, 0, 0, 0, 0, turn] + ends
    return [header, ["made"] + [bits(x) for x in [1] + A + B]]


def clear(row):
    """A row of bits that decimal numbers may stand beside."""
    return row[:1] + ["0x" + word for word in row[1:]]


def distance_file():
    header = ["family"] + vec("A0") + vec("A1") + vec("B0") + vec("B1")
    return [header, ["made"] + [bits(x) for x in [0, 0, 0, 1, 0, 0, 0.5, 2, -1, 0.5, 2, 1]]]


def impulse_file():
    """Equal balls head on; then one against a wall of infinite mass."""
    header = ["family"]
    for b in "AB":
        header += [b + "m"] + vec(b + "J") + body_columns(b, False)
    header += vec("p") + vec("n") + ["e"]
    pose = [1, 0, 0, 0]
    A = [2, 1, 1, 1, -1, 0, 0] + pose + [3, 0, 0, 0, 0, 0]
    B = [2, 1, 1, 1, 1, 0, 0] + pose + [-1, 0, 0, 0, 0, 0]
    wall = [math.inf] * 4 + [1, 0, 0] + pose + [0, 0, 0, 0, 0, 0]
    contact = [0, 0, 0, -1, 0, 0, 1]
    rows = [A + B + contact, A + wall + contact]
    return [header] + [["made"] + [bits(x) for x in row] for row in rows]


class Answer(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def run_program(self, *arguments, text=None, stdin=None):
        return subprocess.run([PROGRAM, *arguments], input=text, stdin=stdin, capture_output=True,
                              text=True, check=False, timeout=600)

    def ask(self, kind, rows, *options, status=0):
        with open(self.path("in.csv"), "w", encoding="ascii") as file:
            file.writelines(",".join(row) + "\n" for row in rows)
        done = self.run_program(kind, "--in", self.path("in.csv"), "--out", self.path("out.csv"),
                                *options)
        self.assertEqual(done.returncode, status, done.stderr)
        with open(self.path("out.csv"), encoding="ascii") as file:
            return list(csv.reader(file)), done.stderr

    def test_toc(self):
        radius = struct.unpack(">f", struct.pack(">f", 0.1))[0]
        truth = (3 - 2 * radius) / 4
        for method in METHODS:
            for scalar, tolerance in (("double", 1e-5), ("float", 2e-5)):
                rows, _ = self.ask("toc", toc_file(-4), "--scalar", scalar, "--method", method)
                self.assertEqual(rows[0], ["line", "outcome", "t_free", "t_hit", "steps"])
                self.assertEqual(rows[1][:2], ["1", "CONTACT"])
                t_free, t_hit = float(rows[1][2]), float(rows[1][3])
                self.assertLessEqual(t_free, truth + 1e-7)
                self.assertLessEqual(t_free, t_hit)
                self.assertAlmostEqual(t_free, truth, delta=tolerance)
                self.assertAlmostEqual(t_hit, truth, delta=tolerance)

    def test_stepping_is_as_fine_as_time_itself(self):
        radius = struct.unpack(">f", struct.pack(">f", 0.1))[0]
        rows, _ = self.ask("toc", toc_file(-4), "--method", "stepping")
        for time in rows[1][2:4]:
            self.assertAlmostEqual(float(time), (3 - 2 * radius) / 4, delta=1e-14)

    def test_no_contact_is_free_and_contact_at_the_start_is_told(self):
        for method in METHODS:
            self.assertEqual(self.ask("toc", toc_file(-1), "--method", method)[0][1][1], "FREE")
            rows, _ = self.ask("toc", toc_file(-1, radius=2), "--method", method)
            self.assertEqual(rows[1][:4], ["1", "TOUCHING", "0", "0"])

    def test_default_method_is_advancement(self):
        for turn in (0, 2):
            rows, _ = self.ask("toc", toc_file(-2.5, turn=turn))
            same, _ = self.ask("toc", toc_file(-2.5, turn=turn), "--method", "advancement")
            self.assertEqual(rows, same)
            self.assertLess(int(rows[1][4]), 40)

    def test_budget(self):
        rows, _ = self.ask("toc", toc_file(-4), "--method", "stepping", "--budget", "4")
        self.assertEqual(rows[1][1], "BUDGET")
        self.assertGreater(float(rows[1][2]), 0)
        self.assertEqual(rows[1][3:], ["1", "5"])
        turning = toc_file(-2.5, turn=8)
        whole, _ = self.ask("toc", turning)
        self.assertEqual(whole[1][1], "CONTACT")
        rows, _ = self.ask("toc", turning, "--budget", "1")
        self.assertEqual(rows[1][1], "BUDGET")
        self.assertGreater(float(rows[1][2]), 0)
        self.assertLessEqual(float(rows[1][2]), float(whole[1][2]))
        self.assertEqual(rows[1][3:], ["1", "1"])

    def test_tolerance_sets_the_steps(self):
        how = ["--method", "stepping", "--tolerance"]
        coarse, _ = self.ask("toc", toc_file(-1), *how, "1")
        fine, _ = self.ask("toc", toc_file(-1), *how, "0.01")
        self.assertLess(int(coarse[1][4]) * 50, int(fine[1][4]))

    def test_tolerance_sets_the_contact_tolerance(self):
        """Over S, which no gap of the query exceeds."""
        for method in ("advancement", "translation"):
            coarse, _ = self.ask("toc", toc_file(-1), "--method", method, "--tolerance", "1")
            fine, _ = self.ask("toc", toc_file(-1), "--method", method, "--tolerance", "1e-9")
            self.assertEqual([coarse[1][1], fine[1][1]], ["TOUCHING", "FREE"])

    def test_zero_radius_is_explained(self):
        rows, errors = self.ask("toc", toc_file(-4, radius=0), "--method", "stepping", status=1)
        self.assertEqual(rows[1], ["1", "INVALID"])
        self.assertIn("line 1", errors)
        self.assertIn("radius", errors)
        rows, _ = self.ask("toc", toc_file(-4, radius=0))
        self.assertEqual(rows[1][1], "CONTACT")

    def test_turning_line_of_translation_is_explained(self):
        good, turning = toc_file(-4), toc_file(-4, turn=1)
        rows, errors = self.ask("toc", good + turning[1:], "--method", "translation", status=1)
        self.assertEqual(rows[1][1], "CONTACT")
        self.assertEqual(rows[2], ["2", "INVALID"])
        self.assertIn("line 2: a capsule turns", errors)

    def test_distance(self):
        rows, _ = self.ask("distance", distance_file())
        self.assertEqual(rows[0], ["line", "d", "s", "u", "nx", "ny", "nz"])
        self.assertEqual([float(x) for x in rows[1]], [1, 2, 0.5, 0.5, 0, 1, 0])

    def test_decimal_is_the_same_as_bits(self):
        header = distance_file()[0]
        numbers = [0, 0, 0, 1, 0, 0, 0.5, 2, -1, 0.5, 2, 1]
        by_bits = [bits(x) for x in numbers]
        for line in ([str(float(x)) for x in numbers], ["0x" + x for x in by_bits]):
            rows, _ = self.ask("distance", [header, ["made"] + by_bits, ["made"] + line])
            self.assertEqual(rows[2][1:], rows[1][1:])

    def test_a_number_that_may_be_meant_either_way_is_refused(self):
        header = distance_file()[0]
        line = ["made", "0", "0", "0", "2", "0", "0", "0", "3", "0", "2", "3", "0"]
        rows, errors = self.ask("distance", [header, line], status=1)
        self.assertEqual(rows[1], ["1", "INVALID"])
        self.assertIn("line 1, column A1x: 2 is not clear: 0x2 for bits, 2.0 for a number", errors)

    def test_all_missing_columns_are_named_at_once(self):
        header = distance_file()[0]
        with open(self.path("in.csv"), "w", encoding="ascii") as file:
            file.write(",".join(header[:-3] + [header[1]]) + "\n")
        done = self.run_program("distance", "--in", self.path("in.csv"), "--out", self.path("out.csv"))
        self.assertEqual(done.returncode, 2)
        self.assertIn("two columns A0x; there is no column B1x, B1y, B1z", done.stderr)

    def test_help_lists_the_columns(self):
        for kind, file in (("toc", toc_file(1)), ("distance", distance_file()), ("impulse", impulse_file())):
            words = self.run_program(kind, "--help").stdout.split()
            for column in file[0][1:]:
                self.assertIn(column, words)

    def test_impulse(self):
        rows, _ = self.ask("impulse", impulse_file())
        self.assertEqual(len(rows[0]), 15)
        self.assertEqual([float(x) for x in rows[1]], [1, 8, -1] + [0] * 5 + [3] + [0] * 5 + [10])
        self.assertEqual([float(x) for x in rows[2]], [2, 12, -3] + [0] * 11 + [9])

    def test_what_points_nowhere_is_refused(self):
        """An orientation or a normal of no length, or that is not finite, has no direction: none is made up."""
        for kind, rows, columns in (("toc", toc_file(-2), body_columns("A", False)[3:7]),
                                    ("impulse", impulse_file()[:2], body_columns("B", False)[3:7]),
                                    ("impulse", impulse_file()[:2], vec("n"))):
            places = [rows[0].index(column) for column in columns]
            bad = [["0.0"] * len(places)]
            for at in range(len(places)):
                bad += [["1.0"] * at + [word] + ["1.0"] * (len(places) - at - 1) for word in ("nan", "inf", "-inf")]
            lines = []
            for words in bad:
                lines.append(clear(rows[1]))
                for place, word in zip(places, words):
                    lines[-1][place] = word
            for scalar in "float", "double":
                answers, errors = self.ask(kind, [rows[0], *lines], "--scalar", scalar, status=1)
                self.assertEqual([row[1] for row in answers[1:]], ["INVALID"] * len(lines), columns)
                self.assertEqual(errors.count("not finite"), len(lines), errors)
            self.ask(kind, [rows[0], clear(rows[1])])

    def test_normals_of_any_length_are_directions(self):
        rows = impulse_file()[:2]
        at = rows[0].index("nx")
        for scalar in "float", "double":
            lines = [clear(rows[1]) for _ in range(5)]
            for line, length in zip(lines, ("-1.0", "-3e38", "-1e25", "-1e-25", "-1e-40")):
                line[at] = length
            answers, _ = self.ask("impulse", [rows[0], *lines], "--scalar", scalar)
            self.assertEqual([row[1] for row in answers[1:]], ["8"] * 5)

    def test_what_is_too_far_for_the_scalar_is_refused(self):
        rows = distance_file()
        far = ["made"] + [word + ".0" if word[-1].isdigit() and "e" not in word else word
                          for word in ("-3e+38", "0", "0", "3e+38", "0", "0", "0", "2", "-1", "0", "2", "1")]
        answers, errors = self.ask("distance", [rows[0], far], "--scalar", "float", status=1)
        self.assertEqual(answers[1], ["1", "INVALID"])
        self.assertIn("line 1: not finite, or too far", errors)
        self.assertEqual([float(x) for x in self.ask("distance", [rows[0], far])[0][1][:2]], [1, 2])

    def test_a_file_that_cannot_be_read_to_its_end_is_told(self):
        if not os.path.exists("/proc/self/mem"):
            self.skipTest("there is nothing that reads like one")
        out = self.path("out.csv")
        done = self.run_program("distance", "--in", "/proc/self/mem", "--out", out)
        self.assertEqual(done.returncode, 2)
        self.assertIn("cannot read /proc/self/mem", done.stderr)
        with open("/proc/self/mem", "rb") as broken:
            done = self.run_program("distance", "--in", "-", "--out", out, stdin=broken)
        self.assertEqual(done.returncode, 2)
        self.assertIn("cannot read -", done.stderr)
        self.assertEqual(os.listdir(self.folder.name), [])

    def test_who_owns_a_file_owns_what_takes_its_place(self):
        if os.getuid() != 0:
            self.skipTest("only root gives files away")
        out = self.path("out.csv")
        text = "".join(",".join(row) + "\n" for row in distance_file())
        with open(out, "w", encoding="ascii") as file:
            file.write("old")
        os.chmod(out, 0o640)
        try:
            os.chown(out, 65534, 65533)
        except OSError:
            self.skipTest("this root gives nothing away")
        done = self.run_program("distance", "--in", "-", "--out", out, text=text)
        self.assertEqual(done.returncode, 0, done.stderr)
        kept = os.stat(out)
        self.assertEqual((kept.st_uid, kept.st_gid, kept.st_mode & 0o777), (65534, 65533, 0o640))

    def test_who_may_read_a_new_file_the_user_has_said(self):
        text = "".join(",".join(row) + "\n" for row in distance_file())
        for mask, mode in (0o022, 0o644), (0o027, 0o640), (0o077, 0o600), (0, 0o666):
            out = self.path("%o.csv" % mask)
            done = subprocess.run([PROGRAM, "distance", "--in", "-", "--out", out], input=text, capture_output=True, text=True,
                                  timeout=60, check=False, preexec_fn=lambda mask=mask: os.umask(mask))
            self.assertEqual((done.returncode, os.stat(out).st_mode & 0o777), (0, mode), done.stderr)

    def test_a_name_is_asked_for(self):
        text = "".join(",".join(row) + "\n" for row in distance_file())
        done = self.run_program("distance", "--in", "-", "--out", "", text=text)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("--out", done.stderr)

    def test_what_somebody_has_put_beside_is_not_written_to(self):
        """A link that has the name of the file to be written beside: the program's number is known, as it is the shell's."""
        text = "".join(",".join(row) + "\n" for row in distance_file())
        queries, out = self.path("queries.csv"), self.path("out.csv")
        with open(queries, "w", encoding="ascii") as file:
            file.write(text)
        done = subprocess.run(["sh", "-c", 'ln -s "$1" "$2.$$.part"; exec "$0" distance --in "$1" --out "$2"', PROGRAM, queries,
                               out], capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("cannot write", done.stderr)
        with open(queries, encoding="ascii") as file:
            self.assertEqual(file.read(), text)

    def test_bad_lines_are_named_and_the_others_answered(self):
        good = distance_file()
        bad = ["made"] + ["xyz"] * 12
        nan = ["made"] + ["7fc"] + good[1][2:]
        rows, errors = self.ask("distance", [good[0], bad, good[1], ["short"], nan, good[1]],
                                status=1)
        self.assertEqual([row[0] for row in rows[1:]], ["1", "2", "3", "4", "5"])
        self.assertEqual([row[1:] == ["INVALID"] for row in rows[1:]],
                         [True, False, True, True, False])
        self.assertEqual([line.split(":")[0].split(",")[0] for line in errors.splitlines()],
                         ["line 1", "line 3", "line 4"])

    def test_standard_streams(self):
        text = "\n".join(",".join(row) for row in distance_file()) + "\n"
        done = self.run_program("distance", "--in", "-", "--out", "-", text=text)
        self.assertEqual(done.returncode, 0)
        self.assertEqual(done.stdout.splitlines()[1], "1,2,0.5,0.5,0,1,0")

    def test_questions_are_not_written_over(self):
        rows = distance_file()
        text = "".join(",".join(row) + "\n" for row in rows)
        queries, link = self.path("queries.csv"), self.path("link.csv")
        with open(queries, "w", encoding="ascii") as file:
            file.write(text)
        os.symlink(queries, link)
        for out in queries, link, self.path("./queries.csv"):
            done = self.run_program("distance", "--in", queries, "--out", out)
            self.assertEqual(done.returncode, 2)
            self.assertIn("is read by --in", done.stderr)
        with open(queries, encoding="ascii") as file:
            self.assertEqual(file.read(), text)
        self.assertEqual(sorted(os.listdir(self.folder.name)), ["link.csv", "queries.csv"])

    def test_answers_are_not_appended_to_their_questions(self):
        text = "".join(",".join(row) + "\n" for row in distance_file())
        queries = self.path("queries.csv")
        with open(queries, "w", encoding="ascii") as file:
            file.write(text)
        for read in queries, "-":
            with open(queries, encoding="ascii") as asked, open(queries, "a", encoding="ascii") as answered:
                done = subprocess.run([PROGRAM, "distance", "--in", read, "--out", "-"], stdin=asked, stdout=answered,
                                      stderr=subprocess.PIPE, text=True, timeout=60, check=False)
            self.assertEqual(done.returncode, 2)
            self.assertIn("what is printed goes to what --in reads", done.stderr)
            with open(queries, encoding="ascii") as asked, open(queries, "a", encoding="ascii") as told:
                done = subprocess.run([PROGRAM, "distance", "--in", read, "--out", "-"], stdin=asked, stderr=told,
                                      stdout=subprocess.PIPE, text=True, timeout=60, check=False)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            with open(queries, encoding="ascii") as file:
                said = file.read()
            self.assertEqual(said, text)

    def test_questions_from_standard_input_are_not_written_over(self):
        text = "".join(",".join(row) + "\n" for row in distance_file())
        queries, link = self.path("queries.csv"), self.path("link.csv")
        with open(queries, "w", encoding="ascii") as file:
            file.write(text)
        os.symlink(queries, link)
        for out in queries, link:
            with open(queries, encoding="ascii") as asked:
                done = self.run_program("distance", "--in", "-", "--out", out, stdin=asked)
            self.assertEqual(done.returncode, 2)
            self.assertIn("is read by --in", done.stderr)
        with open(queries, encoding="ascii") as file:
            self.assertEqual(file.read(), text)
        copy = self.path("copy.csv")
        shutil.copy(queries, copy)
        with open(queries, encoding="ascii") as asked:
            done = self.run_program("distance", "--in", "-", "--out", copy, stdin=asked)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_a_signal_leaves_nothing_beside_the_answers(self):
        out = self.path("out.csv")
        with open(out, "w", encoding="ascii") as file:
            file.write("older answers")
        for number in (signal.SIGHUP, signal.SIGINT, signal.SIGTERM, signal.SIGQUIT, signal.SIGALRM, signal.SIGUSR1,
                       signal.SIGXCPU, signal.SIGABRT):
            with subprocess.Popen([PROGRAM, "distance", "--in", "-", "--out", out], stdin=subprocess.PIPE, text=True) as asking:
                asking.stdin.write(",".join(distance_file()[0]) + "\n")
                asking.stdin.flush()
                while len(os.listdir(self.folder.name)) < 2:  # until it is begun; ends with the test's own time
                    self.assertIsNone(asking.poll())
                    time.sleep(0.01)
                asking.send_signal(number)
                self.assertEqual(asking.wait(timeout=60), -number)
            self.assertEqual(os.listdir(self.folder.name), ["out.csv"])
        with open(out, encoding="ascii") as file:
            self.assertEqual(file.read(), "older answers")

    def test_messages_are_not_replaced_by_answers(self):
        text = "".join(",".join(row) + "\n" for row in distance_file())
        out = self.path("out.csv")
        with open(out, "a", encoding="ascii") as messages:
            done = subprocess.run([PROGRAM, "distance", "--in", "-", "--out", out], input=text, stdout=subprocess.PIPE,
                                  stderr=messages, text=True, timeout=60, check=False)
        self.assertEqual(done.returncode, 2)
        with open(out, encoding="ascii") as file:
            self.assertIn("is what is printed to", file.read())

    def test_a_pipe_may_have_the_name_of_a_device(self):
        text = "".join(",".join(row) + "\n" for row in distance_file())
        plain = self.run_program("distance", "--in", "-", "--out", "-", text=text)
        for name in "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1":
            done = self.run_program("distance", "--in", "-", "--out", name, text=text)
            self.assertEqual((done.returncode, done.stdout, done.stderr), (0, plain.stdout, ""), name)

    def test_an_output_that_cannot_be_made_is_no_wrong_usage(self):
        text = "".join(",".join(row) + "\n" for row in distance_file())
        for name in self.path("no folder/out.csv"), self.folder.name:
            done = self.run_program("distance", "--in", "-", "--out", name, text=text)
            self.assertEqual((done.returncode, done.stdout), (1, ""), name)
            self.assertIn("cannot write", done.stderr)

    def test_a_file_beyond_what_the_user_may_write_is_told(self):
        out = self.path("out.csv")
        with open(out, "w", encoding="ascii") as file:
            file.write("old")
        text = "".join(",".join(row) + "\n" for row in distance_file())
        done = subprocess.run([PROGRAM, "distance", "--in", "-", "--out", out], input=text, capture_output=True, text=True,
                              timeout=60, check=False, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (10, 10)))
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("cannot write", done.stderr)
        self.assertEqual(os.listdir(self.folder.name), ["out.csv"])
        with open(out, encoding="ascii") as file:
            self.assertEqual(file.read(), "old")

    def test_a_full_device_is_told(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("there is none")
        with open(self.path("in.csv"), "w", encoding="ascii") as file:
            file.writelines(",".join(row) + "\n" for row in distance_file())
        done = self.run_program("distance", "--in", self.path("in.csv"), "--out", "/dev/full")
        self.assertEqual(done.returncode, 1)
        self.assertIn("/dev/full", done.stderr)

    def test_wrong_usage_is_one_line(self):
        out = self.path("out.csv")
        with open(self.path("in.csv"), "w", encoding="ascii") as file:
            file.write("a,b\n1,2\n")
        files = ["--in", self.path("in.csv"), "--out", out]
        wrong = [
            [], ["nonsense"], ["toc"], ["toc", "--in", "x"],
            ["toc", "--in", self.path("none.csv"), "--out", out],
            ["toc", "--in", self.path("in.csv"), "--out", self.path("no/such/folder.csv")],
            ["toc", *files],
            ["toc", "--in", self.path("."), "--out", out],
            ["toc", *files, "--method", "magic"],
            ["toc", *files, "--budget", "4097"],
            ["toc", *files, "--method", "translation", "--budget", "4097"],
            ["toc", *files, "--tolerance", "1.5"],
            ["toc", *files, "--tolerance", "0"],
            ["toc", *files, "--method", "stepping", "--budget", "-1"],
            ["toc", *files, "--scalar", "half"],
            ["toc", *files, "--budget", "0"],
            ["toc", *files, "--tolerance", "-1"],
            ["toc", *files, "--tolerance", "nan"],
        ]
        for arguments in wrong:
            with self.subTest(arguments=arguments):
                done = self.run_program(*arguments)
                self.assertEqual(done.returncode, 2)
                self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
                self.assertEqual(done.stdout, "")
        self.assertIn("nonsense", self.run_program("nonsense").stderr)
        self.assertIn("toc, distance or impulse", self.run_program().stderr)

    def test_help(self):
        self.assertEqual(self.run_program("--help").returncode, 0)
        done = self.run_program("toc", "--help")
        self.assertEqual(done.returncode, 0)
        for word in METHODS + ["BUDGET", "4096"]:
            self.assertIn(word, done.stdout)


if __name__ == "__main__":
    unittest.main()
