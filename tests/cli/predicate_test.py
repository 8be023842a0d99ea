#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope predicate: signs of cases in text against fractions, the text format to its edges, --expect, --tiers, streaming, failures."""
import os
import pathlib
import random
import re
import select
import subprocess
import unittest
from decimal import Decimal

import predicate_oracle
import support
from predicate_oracle import IMPLICIT_OPERANDS, NUM_OPERANDS
from support import BIN, INVALID, MODELS, Folder, run

SEED = 1
NUMBERS = "1 2 3 4 5"  # an orient2d case lacks one
MAX_LINE = 1 << 20
HEAP = 50 << 20

KNOWN = {  # name: [(operands, sign)]
    "orient2d": [
        ("0 0 1 0 0 1", 1), ("0 0 0 1 1 0", -1), ("0 0 1 1 2 2", 0), ("5 5 5 5 1 2", 0),
        ("0 0 1 0 0 0x1p-1074", 1), ("0 0 1 0 0 -5e-324", -1),
        ("0x1p-1074 0 0 0x1p-1074 0 0", 1),  # the product underflows
        ("0 0 1.7976931348623157e308 0 -1.7976931348623157e308 1.7976931348623157e308", 1),  # it overflows
        ("-0x1.fffffffffffffp1023 -0x1.fffffffffffffp1023 0 0 0x1.fffffffffffffp1023 0x1.fffffffffffffp1023", 0),
        ("0.5 0.5 12 12 24 24", 0), ("0.5 0.5000000000000001 12 12 24 24", 1), ("0.5 0.49999999999999994 12 12 24 24", -1)],
    "orient3d": [
        ("0 0 0 1 0 0 0 1 0 0 0 1", 1), ("0 0 0 0 1 0 1 0 0 0 0 1", -1), ("0 0 0 1 0 0 0 1 0 1 1 0", 0),
        ("0 0 0 1 0 0 0 1 0 0 0 4.9406564584124654e-324", 1), ("0 0 0 1 0 0 0 1 0 7 7 -0x1p-1074", -1),
        ("0 0 0 0x1p1023 0 0 0 0x1p1023 0 0 0 0x1p1023", 1), ("0 0 0 0x1p-1074 0 0 0 0x1p-1074 0 0 0 0x1p-1074", 1)],
    "in_circle": [
        ("1 0 0 1 -1 0 0 0", 1), ("1 0 0 1 -1 0 0 -1", 0), ("1 0 0 1 -1 0 0 -2", -1), ("-1 0 0 1 1 0 0 0", -1),
        ("1 0 0 1 -1 0 0 -0.99999999999999989", 1), ("1 0 0 1 -1 0 0 -1.0000000000000002", -1),
        ("0x1p1000 0 0 0x1p1000 -0x1p1000 0 0 0x1p-1074", 1), ("0x1p-1074 0 0 0x1p-1074 -0x1p-1074 0 0 -0x1p-1074", 0)],
    "in_sphere": [
        ("1 0 0 0 1 0 0 0 1 -1 0 0 0 0 0", -1), ("0 1 0 1 0 0 0 0 1 -1 0 0 0 0 0", 1), ("1 0 0 0 1 0 0 0 1 -1 0 0 0 -1 0", 0),
        ("0 1 0 1 0 0 0 0 1 -1 0 0 0 0 -1.0000000000000002", -1), ("0 1 0 1 0 0 0 0 1 -1 0 0 0 0 -0.99999999999999989", 1),
        ("0 0x1p-1074 0 0x1p-1074 0 0 0 0 0x1p-1074 -0x1p-1074 0 0 0 0 0", 1)],
    "side_of_plane": [
        ("0 0 1 -3 9 9 4", 1), ("0 0 1 -3 9 9 3", 0), ("0 0 1 -3 9 9 2", -1), ("0 0 0 -5e-324 1 2 3", -1),
        ("0x1p-1074 0 0 0 0x1p-1074 0 0", 1)],
    "compare_along": [
        ("1 0 0 2 0 0 1 0 0", 1), ("1 0 0 1 7 7 1 0 0", 0), ("-1 0 0 2 0 0 1 0 0", -1), ("0 0 0 1 2 3 4 5 6", 0),
        ("0x1p-1074 0 0 0x1p-1074 0 0 0 0 0", 1)],
}

KNOWN["order_on_circle"] = [
    ("0 0 1 0 0 1 -1 0", 1), ("0 0 1 0 -1 0 0 1", -1), ("0 0 1 0 0 1 0 7", 0), ("0 0 1 0 1 0 0 1", 1), ("0 0 1 0 0 -1 0 1", -1), ("5 5 5 5 1 2 3 4", 0),
    ("0 0 1 0 1.7976931348623157e308 5e-324 1 5e-324", 1), ("0 0 1 0 -1 5e-324 -1 -5e-324", 1)]
KNOWN["side_of_bisector2d"] = [
    ("0 0 2 0 0.5 9", 1), ("0 0 2 0 1 9", 0), ("0 0 2 0 1.0000000000000002 9", -1), ("5 5 5 5 1 2", 0), ("0 0 0x1p-1074 0 0 0", 1)]
KNOWN["side_of_bisector3d"] = [
    ("0 0 0 0 0 2 7 -7 0x1.fffffffffffffp-1", 1), ("0 0 0 0 0 2 7 -7 1", 0), ("0 0 2 0 0 0 7 -7 0", -1), ("5 5 5 5 5 5 1 2 3", 0),
    ("0 0 0 0x1p1023 0 0 0x1p-1074 0 0", 1)]
for path in (pathlib.Path(__file__).resolve().parents[2] / "predicates" / "generated").glob("*.formula"):
    KNOWN[path.stem] = [(" ".join(numbers.replace(",", " ").split()), int(sign))
                        for numbers, sign in re.findall(r"(?m)^example +(.*?) +-> +(\S+)$", path.read_text())]


def decide(name, lines, *options, **how):
    return run("predicate", name, "-", *options, input=lines, **how)


def complaint(done):
    """The status, and the one line on standard error behind "veritope: "."""
    assert done.stderr.startswith("veritope: ") and done.stderr.count("\n") == 1, done.stderr
    return done.returncode, done.stderr[len("veritope: "):-1]


def written(value, draw):
    """The number in one of the ways in which programs write it."""
    return draw.choice([repr, float.hex, lambda v: "%.17g" % v, lambda v: "%.16E" % v, lambda v: format(Decimal(v), "f"),
                        lambda v: str(Decimal(v)), lambda v: float.hex(v).upper()])(value)


class Signs(unittest.TestCase):
    def test_known_signs(self):
        self.assertEqual(set(KNOWN), set(NUM_OPERANDS))
        for name, cases in KNOWN.items():
            done = decide(name, "".join(operands + "\n" for operands, _ in cases))
            self.assertEqual((done.returncode, done.stderr), (0, ""), name)
            self.assertEqual(done.stdout, "".join(f"{sign}\n" for _, sign in cases), name)

    def test_the_oracle_knows_them_too(self):
        for name, cases in KNOWN.items():
            for text, sign in cases:
                operands = [float.fromhex(t) if "x" in t else float(t) for t in text.split()]
                self.assertEqual(predicate_oracle.sign(name, operands), sign, (name, text))

    def test_random_hard_cases_in_every_notation_have_the_sign_of_the_fractions(self):
        for name in NUM_OPERANDS:
            draw = random.Random(SEED)
            cases = predicate_oracle.cases(name, SEED, 400)
            lines = [" ".join(written(v, draw) for v in operands) for operands in cases]
            done = decide(name, "\n".join(lines) + "\n")
            self.assertEqual((done.returncode, done.stderr), (0, ""), f"{name}, seed {SEED}")
            found = [int(sign) for sign in done.stdout.split()]
            self.assertEqual(len(found), len(cases))
            signs = [predicate_oracle.sign(name, operands) for operands in cases]
            for line, sign, exact in zip(lines, found, signs):
                self.assertEqual(sign, exact, f"{name}, seed {SEED}: {line}")
            self.assertTrue(all(signs.count(s) >= 5 for s in (-1, 0, 1)), f"{name}: the cases are too easy")


class Numbers(unittest.TestCase):
    """compare_along with the direction x is the sign of the difference of two numbers."""

    def assert_equal_numbers(self, pairs):
        done = decide("compare_along", "".join(f"1 0 0 {text} 0 0 {value.hex()} 0 0\n" for text, value in pairs))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(len(done.stdout.split()), len(pairs))
        for (text, value), sign in zip(pairs, done.stdout.split()):
            self.assertEqual(sign, "0", f"{text[:60]} is not {value.hex()}")

    def test_decimals_are_rounded_to_the_nearest_ties_to_even(self):
        tie = format(Decimal(2) ** -1075, "f")  # half of the least number
        texts = ["0", "-0", "+1", "1.", ".5", "1e3", "1E+3", "1e-3", "0.1", "9007199254740993", "9007199254740995", "1e-400", "5e-324",
                 "2.4703282292062327e-324", "2.4703282292062328e-324", tie, tie + "1", "1.7976931348623158e308",
                 "179769313486231580793728971405301e276", "0." + "0" * 400 + "1e401", "1" + "0" * 400 + "e-400", "1" + "0" * 5000 + "e-5000",
                 "0.1" + "0" * 2000 + "1", "1e-4294967295"]
        texts += [f"{random.Random(i).randrange(10**30)}e{random.Random(i).randint(-340, 270)}" for i in range(200)]
        self.assert_equal_numbers([(text, float(text)) for text in texts])

    def test_hexadecimals_stand_for_themselves(self):
        texts = ["0x1.8p-3", "0X1.8P-3", "-0x1.8p+3", "+0x.8", "0x8.", "0x10", "0xABCDEF", "0xabcdef", "0x1p-1074", "0x0.0000000000001p-1022",
                 "0x1.fffffffffffffp1023", "0x0p0", "-0x0", "0x1fffffffffffffp0", "0x3ffffffffffffep970", "0x1.00000000000000000000p0",
                 "0x" + "0" * 100 + "1", "0x0." + "0" * 300 + "1p1204", "0x1" + "0" * 300 + "p-1200", "0x10000000000000000", "0x80p-1081"]
        self.assert_equal_numbers([(text, float.fromhex(text)) for text in texts])
        self.assert_equal_numbers([("0x0p99999999999999999999", 0.0), ("0x0.0p-99999999999999999999", 0.0)])

    def test_neighbours_are_told_apart(self):
        for text, other in [("1", "1.0000000000000002"), ("0", "5e-324"), ("0x1.ffffffffffffep1023", "1.7976931348623157e308")]:
            done = decide("compare_along", f"1 0 0 {text} 0 0 {other} 0 0\n1 0 0 {other} 0 0 {text} 0 0\n")
            self.assertEqual(done.stdout, "-1\n1\n")

    def assert_refused(self, tokens, words):
        for token in tokens:
            for column in (1, 6):
                numbers = NUMBERS.split()
                numbers.insert(column - 1, token)
                done = decide("orient2d", "# first\n" + " ".join(numbers) + "\n")
                shown = token if len(token) <= 40 else token[:40] + "..."
                self.assertEqual(complaint(done), (4, f"standard input:2: column {column}: " + words.replace("@", f"'{shown}'")), token)
                self.assertEqual(done.stdout, "")

    def test_what_is_no_number_is_refused_with_line_column_and_token(self):
        self.assert_refused(["x", "1x", "1e", "1e+", "e5", ".", "+", "-", "--1", "+-1", "1.2.3", "1,5", "1_0", "1e5.0", "1d5", "0x", "0x.", "0x.p1",
                             "0x1p", "0x1p+", "0x1p1x", "0x1g", "0x1.8.1", "0x-1", "0x1p1.0", "0x1e+3", "x1", "1#", "infinit", "nan(1)"], "a number expected, but there is @")

    def test_what_is_not_finite_is_refused(self):
        self.assert_refused(["nan", "NaN", "-nan", "inf", "+Inf", "-INFINITY", "infinity"], "@ is not finite")
        threshold = 2**1024 - 2**970  # the largest number and half a unit
        self.assert_refused(["1e309", "-1e309", "1.797693134862315808e308", "0x1p1024", "-0x1.0p1024", "0x0.8p1025", f"0x1p{2**64}", "1e4294967295",
                             str(threshold), "0x1p99999999999999999999"], "@ is beyond the largest binary64 number")
        self.assertEqual(decide("orient2d", f"0 0 1 0 0 {threshold - 1}\n").stdout, "1\n")

    def test_hexadecimals_that_binary64_does_not_hold_are_refused_and_not_rounded(self):
        self.assert_refused(["0x1.00000000000008p0", "-0x1.00000000000008p0", "0x1p-1075", "0x1.8p-1074", "0x3p-1075", "0x20000000000001",
                             "0x1.0000000000000000000000000001", "0x1.fffffffffffff8p1023", "0x1p-99999999999999999999",
                             f"0x1p-{2**64}"],
                            "@ has more bits than a binary64 number holds")

    def test_a_decimal_exponent_without_end_is_refused(self):
        self.assert_refused(["1e4294967296", "1e-4294967296", "1e99999999999999999999"], "the exponent of @ is out of range")

    def test_control_characters_and_bytes_beyond_ascii_are_refused_and_shown_harmlessly(self):
        for token, shown in [(b"\x1b[31m1", r"\x1b[31m1"), (b"\xff", r"\xff"), (b"1\x00", r"1\x00"), (b"\xef\xbb\xbf1", r"\xef\xbb\xbf1"), (b"1\x0b2", r"1\x0b2"),
                             (b"1\r2", r"1\x0d2")]:
            done = decide("orient2d", b"1 2 3 4 5 " + token + b"\n", text=False)
            self.assertEqual(done.stderr.decode(), f"veritope: standard input:1: column 6: a number expected, but there is '{shown}'\n")
            self.assertEqual(done.returncode, 4)


class Lines(Folder):
    def test_blanks_empty_lines_comments_and_line_ends(self):
        text = "# 1 2 3\n\n0 0 1 0 0 1\n  # blanks in front\n \t \n\t0  0\t1 0 0 -1  \r\n\r\n#\r\n#x\n0 0 1 1 2 2"
        done = decide("orient2d", text.encode(), text=False)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, b"1\n-1\n0\n", b""))

    def test_comments_and_empty_lines_count_as_lines(self):
        done = decide("orient2d", b"#\r\n\r\n\n0 0 1 0 0 1\n# c\n1 2 x 4 5 6\n", text=False)
        self.assertEqual(done.stderr, b"veritope: standard input:6: column 3: a number expected, but there is 'x'\n")

    def test_a_comment_has_no_place_behind_the_numbers(self):
        self.assertEqual(complaint(decide("orient2d", "0 0 1 0 0 1 # one\n")), (4, "standard input:1: 6 numbers expected, but there are 8 columns"))

    def test_the_number_of_columns_is_that_of_the_predicate(self):
        for name, count in NUM_OPERANDS.items():
            for columns in (1, count - 1, count + 1, 40):
                there = "is 1 column" if columns == 1 else f"are {columns} columns"
                done = decide(name, "1 " * columns + "\n")
                self.assertEqual(complaint(done), (4, f"standard input:1: {count} numbers expected, but there {there}"))
                done = decide(name, "1 " * (columns + 1) + "\n", "--expect")
                there = f"are {columns + 1} columns"
                self.assertEqual(complaint(done), (4, f"standard input:1: {count} numbers and a sign expected, but there {there}"))

    def test_the_signs_before_a_bad_line_are_printed(self):
        done = decide("orient2d", "0 0 1 0 0 1\n0 0 1 0 0 -1\nx\n0 0 1 0 0 1\n")
        self.assertEqual((done.returncode, done.stdout), (4, "1\n-1\n"))

    def test_a_line_may_have_so_many_bytes_and_no_more(self):
        case = "0 0 1 0 0 1"
        for end in ("\n", "\r\n", ""):
            for filler in (case + " " * (MAX_LINE - len(case)), "#" * MAX_LINE):
                longest = (filler + end).encode()
                with self.subTest((end, filler[0])):
                    done = decide("orient2d", b"0 0 1 1 2 2\n" + longest, text=False)
                    self.assertEqual((done.returncode, done.stdout, done.stderr), (0, b"0\n" + (b"1\n" if filler[0] == "0" else b""), b""))
                    done = decide("orient2d", b"0 0 1 1 2 2\n#" + longest, text=False)
                    self.assertEqual((done.returncode, done.stdout), (4, b"0\n"))
                    self.assertEqual(done.stderr, b"veritope: standard input:2: more than 1048576 bytes in a line\n")

    def test_a_number_as_long_as_a_line_is_read(self):
        zeros = "0" * (MAX_LINE - 40)
        self.assertEqual(decide("orient2d", f"0 0 1 0 0 -.{zeros}1\n").stdout, "0\n")  # rounds to zero
        self.assertEqual(decide("orient2d", f"0 0 1 0 0 -0x.{zeros}1p{4 * len(zeros)}\n").stdout, "-1\n")

    def test_the_lines_of_a_model_are_no_cases(self):
        self.assertEqual(complaint(run("predicate", "orient2d", INVALID)), (4, f"{INVALID}:1: 6 numbers expected, but there is 1 column"))


def limit_memory():
    """Sanitizers need more for themselves."""
    if not os.environ.get("VERITOPE_SANITIZE"):
        support.resource.setrlimit(support.resource.RLIMIT_DATA, (HEAP, HEAP))


class Streaming(Folder):
    def test_an_endless_line_and_a_long_file_need_no_memory(self):
        done = decide("orient2d", b"1 " * HEAP, text=False, preexec_fn=limit_memory)
        self.assertEqual((done.returncode, done.stderr), (4, b"veritope: standard input:1: more than 1048576 bytes in a line\n"))
        comments = b"# " + b"c" * 997 + b"\n"
        done = decide("orient2d", comments * (2 * HEAP // 1000) + b"0 0 1 0 0 1\n", text=False, preexec_fn=limit_memory)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, b"1\n", b""))

    def test_lines_across_the_pieces_in_which_a_file_is_read(self):
        signs = []
        path = self.folder / "long"
        with open(path, "w") as file:
            for i in range(60000):
                signs.append(i * 7919 % 3 - 1)
                file.write(" " * (i % 61) + f"0 0 1 0 {i} {signs[-1]}\n")
        self.assertGreater(path.stat().st_size, 2 * MAX_LINE)
        done = run("predicate", "orient2d", path)
        self.assertEqual((done.returncode, done.stdout), (0, "".join(f"{sign}\n" for sign in signs)))

    def test_a_case_is_answered_before_the_next_is_sent(self):
        with subprocess.Popen([BIN / "veritope", "predicate", "orient2d", "-"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as child:
            for y, sign in [(1, "1\n"), (-1, "-1\n"), (0, "0\n")]:
                child.stdin.write(f"0 0 1 0 0 {y}\n")
                child.stdin.flush()
                readable, _, _ = select.select([child.stdout], [], [], 60)
                self.assertTrue(readable, "no answer")
                self.assertEqual(child.stdout.readline(), sign)
            child.stdin.close()
        self.assertEqual(child.returncode, 0)

    def test_the_longest_line_may_arrive_in_two_pieces_between_cr_and_lf(self):
        with subprocess.Popen([BIN / "veritope", "predicate", "orient2d", "-"], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE) as child:
            for piece in (b"#" * MAX_LINE + b"\r", b"\nx\n"):
                child.stdin.write(piece)
                child.stdin.flush()
                support.time.sleep(0.3)  # so that it is read alone; if not, the test proves less
            child.stdin.close()
            self.assertEqual(child.stderr.read(), b"veritope: standard input:2: 6 numbers expected, but there is 1 column\n")

    def test_a_file_a_pipe_by_name_and_an_empty_input(self):
        path = self.folder / "cases"
        path.write_text("0 0 1 0 0 1\n")
        self.assertEqual(run("predicate", "orient2d", path).stdout, "1\n")
        script = f'"{BIN}/veritope" predicate orient2d <(cat "{path}" "{path}")'
        self.assertEqual(subprocess.run(["bash", "-c", script], capture_output=True, text=True).stdout, "1\n1\n")
        for options, text in [((), ""), (("--expect",), "0 cases, 0 disagreements\n")]:
            done = run("predicate", "orient2d", "/dev/null", *options)
            self.assertEqual((done.returncode, done.stdout, done.stderr), (0, text, ""))


class Expect(Folder):
    def test_agreement_is_silent_but_for_the_count(self):
        for name, cases in KNOWN.items():
            done = decide(name, "# all right\n" + "".join(f"{operands} {sign}\n" for operands, sign in cases), "--expect")
            self.assertEqual((done.returncode, done.stdout, done.stderr), (0, f"{len(cases)} cases, 0 disagreements\n", ""))

    def test_each_disagreement_has_its_place(self):
        path = self.folder / "cases"
        path.write_text("# a comment\n0 0 1 0 0 1 -1\n0 0 1 0 0 1 1\n\n0 0 1 1 2 2 1\r\n0 0 1 0 0 -1 0\n")
        done = run("predicate", "--expect", "orient2d", path)
        self.assertEqual((done.returncode, done.stderr), (1, ""))
        self.assertEqual(done.stdout, f"{path}:2: expected -1, found 1\n{path}:5: expected 1, found 0\n{path}:6: expected 0, found -1\n"
                                      "4 cases, 3 disagreements\n")
        done = decide("orient2d", "0 0 1 0 0 1 0\n", "--expect")
        self.assertEqual((done.returncode, done.stdout), (1, "standard input:1: expected 0, found 1\n1 cases, 1 disagreements\n"))

    def test_a_sign_is_minus_one_zero_or_one(self):
        for token in ("2", "+1", "-0", "1.0", "-2", "x", "0x1", "01"):
            done = decide("orient2d", f"0 0 1 0 0 1 {token}\n", "--expect")
            self.assertEqual(complaint(done), (4, f"standard input:1: column 7: -1, 0 or 1 expected, but there is '{token}'"))

    def test_a_file_that_cannot_be_read_to_its_end_has_no_count(self):
        done = decide("orient2d", "0 0 1 0 0 1 0\n0 0 1 0 0 1 1\nx\n", "--expect")
        self.assertEqual((done.returncode, done.stdout), (4, "standard input:1: expected 0, found 1\n"))

    def test_a_file_name_cannot_drive_the_terminal(self):
        name = self.folder / "a\x1b[31m"
        name.write_text("0 0 1 0 0 1 0\nx\n")
        done = run("predicate", "--expect", "orient2d", name)
        self.assertNotIn("\x1b", done.stdout + done.stderr)
        self.assertIn(r"a\x1b[31m:1: ", done.stdout)
        self.assertIn(r"a\x1b[31m:2: ", done.stderr)


class Tiers(unittest.TestCase):
    def test_each_tier_counts_its_cases(self):
        decided = {"filter": "0 0 1 0 0 1", "lattice": "0 0 1 1 2 2", "interval": "0 0 1 0 0 0x1p-1074",
                   "exact": "1e-300 1e300 3e-300 3e300 5e-300 5e300"}
        lines = "".join(f"{line}\n" * (i + 1) for i, line in enumerate(decided.values()))
        done = decide("orient2d", lines, "--tiers")
        self.assertEqual(complaint(done), (0, "decided by filter 1, lattice 2, interval 3, exact 4"))
        self.assertEqual(done.stdout, "1\n0\n0\n1\n1\n1\n1\n1\n1\n1\n")
        self.assertEqual(decide("orient2d", lines).stderr, "")


class Failures(Folder):
    def test_what_cannot_be_read_is_exit_4_with_its_name(self):
        for path, words in [("/nonexistent/cases", "No such file or directory"), (MODELS, "it is a directory")]:
            done = run("predicate", "orient2d", path)
            self.assertEqual(complaint(done), (4, f"{path}: cannot be read: {words}"))
            self.assertEqual(done.stdout, "")
        done = subprocess.run(["bash", "-c", f'"{BIN}/veritope" predicate orient2d - < "{MODELS}"'], capture_output=True, text=True)
        self.assertEqual(complaint(done), (4, "standard input: cannot be read: it is a directory"))

    def test_an_unknown_name_is_wrong_usage_and_the_one_that_was_meant_is_named(self):
        for name in ("orient4d", "ORIENT2D"):
            done = decide(name, "")
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn(f"NAME: there is no predicate {name}; did you mean orient2d?\n", done.stderr)
        for name, words in [("", "must not be empty"), ("area", "there is no predicate area; veritope selftest --verbose lists all"),
                            ("orient2d_filter", "there is no predicate orient2d_filter; veritope selftest --verbose lists all")]:
            done = decide(name, "")
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn(f"NAME: {words}\n", done.stderr)
        listed = [line.split()[0] for line in run("selftest", "--verbose", "--cases", 1).stdout.splitlines()[1:-1]]
        self.assertEqual(listed, [*NUM_OPERANDS, *IMPLICIT_OPERANDS])

    def test_output_that_cannot_be_written_is_exit_4(self):
        cases = self.folder / "cases"
        cases.write_text("0 0 1 0 0 1\n")
        done = subprocess.run(["bash", "-c", f'"{BIN}/veritope" predicate orient2d "{cases}" >&-'], capture_output=True, text=True)
        self.assertEqual(complaint(done), (4, "standard output: cannot be written: Bad file descriptor"))
        for expected, status in [(1, 4), (0, 1)]:
            cases.write_text(f"0 0 1 0 0 1 {expected}\n")
            with open("/dev/full", "w") as full:
                done = subprocess.run([BIN / "veritope", "predicate", "--expect", "orient2d", cases], stdout=full, stderr=subprocess.PIPE, text=True)
            self.assertEqual(complaint(done), (status, "standard output: cannot be written: No space left on device"))

    def test_a_reader_that_goes_away_is_no_error(self):
        cases = self.folder / "cases"
        cases.write_text("0 0 1 0 0 1\n" * 500000)
        script = f'"{BIN}/veritope" predicate orient2d "{cases}" | head -1; echo "${{PIPESTATUS[0]}}"'
        self.assertEqual(subprocess.run(["bash", "-c", script], capture_output=True, text=True).stdout, "1\n0\n")


if __name__ == "__main__":
    support.main()
