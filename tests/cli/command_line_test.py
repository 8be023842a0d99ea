#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The command line itself: usage, help, exit statuses and their order, standard input, limits, what is printed where."""
import fractions
import os
import pty
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

import support
sys.path[:0] = [str(support.ROOT / "tests" / "support"), str(support.ROOT / "tests")]
import wording_test  # noqa: E402
from edge_gaps import squared_distance  # noqa: E402
from support import BIN, COMMANDS, INVALID, MODELS, UNREADABLE, VALID, Folder, run
from terminal import read_terminal, run_on_terminal


class Usage(unittest.TestCase):
    def test_wrong_usage_is_exit_2_with_a_word_on_standard_error_and_nothing_else(self):
        wrong = [["nonsense"], ["certify"], ["certify", "--jobs", "0", VALID], ["certify", "--jobs", "-1", VALID],
                 ["certify", "--jobs=-1", VALID], ["certify", "--jobs", "two", VALID], ["certify", "--jobs", "0x2", VALID],
                 ["certify", "--jobs", "", VALID], ["certify", "--jobs", "99999999999999999999", VALID],
                 ["certify", "--max-defects", "-1", VALID], ["certify", "--format", "step", VALID], ["certify", "-"],
                 ["certify", "--format", "off", "-", "-"], ["certify", "--unknown", VALID], ["certify", "--json", "", VALID],
                 ["certify", "--certificate", "-", VALID], ["certify", "--max-bytes", "1k", VALID], ["certify", ""],
                 ["info"], ["convert", VALID], ["convert", VALID, "-"], ["convert", VALID, "out.xyz"],
                 ["convert", "--to", "step", VALID, "out.stl"], ["convert", "--float", VALID, "out.obj"], ["explain", "M0"],
                 ["explain", "M10"], ["explain", "closed"], ["explain-certificate"], ["--json", "-"],
                 ["predicate"], ["predicate", "orient2d"], ["predicate", "orient4d", "-"], ["predicate", "orient2d", ""],
                 ["predicate", "orient2d", "-", "-"], ["selftest", "--cases", "0"],
                 ["selftest", "--cases", "1e3"], ["selftest", "--seed", "-1"], ["selftest", "x"],
                 ["corpus", "--cases", "0"], ["corpus", "x"]]
        for arguments in wrong:
            with self.subTest(arguments):
                done = run(*arguments)
                self.assertEqual((done.returncode, done.stdout), (2, ""))
                self.assertTrue(done.stderr.startswith("veritope: "), done.stderr)

    def test_no_argument_and_help_print_what_help_prints(self):
        self.assertEqual(run().stdout, run("--help").stdout)
        self.assertEqual(run("help").stdout, run("--help").stdout)
        self.assertEqual(run("help", "certify").stdout, run("certify", "--help").stdout)
        self.assertEqual(run("-V").stdout, run("--version").stdout)
        self.assertEqual([run(*a).returncode for a in ([], ["help"], ["help", "info"], ["-V"])], [0] * 4)

    def test_the_name_that_was_probably_meant_is_named(self):
        for arguments, words in [(["certif", "x"], "unknown command: certif; did you mean certify?"),
                                 (["help", "ifno"], "unknown command: ifno; did you mean info?"),
                                 (["nonsense"], "unknown command: nonsense"),
                                 (["--hlep"], "veritope has no option --hlep; did you mean --help?"),
                                 (["certify", "--quite", "x"], "certify has no option --quite; did you mean --quiet?"),
                                 (["certify", "--Jobs=2", "x"], "certify has no option --Jobs; did you mean --jobs?"),
                                 (["certify", "--unknown", "x"], "certify has no option --unknown"),
                                 (["certify", "--json"], "--json needs a value: --json F"),
                                 (["certify", "--format", "stpl", "x"], "not stpl; did you mean stl?"),
                                 (["predicate", "orient3", "x"], "there is no predicate orient3; did you mean orient3d?"),
                                 (["explain", "side-opne"], "there is no page about side-opne; did you mean side-open?"),
                                 (["explain", "m10"], "there is no rule m10; the rules are M1 to M9")]:
            with self.subTest(arguments):
                done = run(*arguments)
                self.assertEqual((done.returncode, done.stdout), (2, ""))
                self.assertTrue(done.stderr.splitlines()[0].endswith(words), done.stderr)

    def test_explain_takes_verdicts_words_and_names_in_any_case(self):
        self.assertEqual(run("explain", "VALID").stdout, run("explain").stdout)
        self.assertEqual(run("explain", "UNDECIDED").stdout, run("explain", "undecided").stdout)
        self.assertEqual(run("explain", "Boundary").stdout, run("explain", "M3").stdout)
        self.assertEqual(run("explain", "Side-Open").stdout, run("explain", "side-open").stdout)
        several = run("explain", "face")
        self.assertEqual(several.returncode, 0)
        self.assertIn("M1  degenerate face\n", several.stdout)
        self.assertIn("M2  duplicate face\n", several.stdout)

    def test_frequent_slips_are_named(self):
        with support.tempfile.TemporaryDirectory() as folder:
            comma = Path(folder) / "comma.obj"
            comma.write_text("v 0,5 1 2\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
            self.assertIn("'0,5' (a decimal comma?)", run("certify", "-q", comma).stdout)
            self.assertIn("no file matches this pattern?", run("certify", "-q", Path(folder) / "*.nothing").stdout)
        self.assertIn("write x,y,z", run("project", "0 0 0", VALID).stderr)

    def test_help_fits_on_one_screen_and_names_every_option(self):
        for command in [None, *COMMANDS]:
            with self.subTest(command):
                done = run(*([command] if command else []), "--help")
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                lines = done.stdout.rstrip("\n").split("\n")
                self.assertLessEqual(len(lines), 25 if command else 27)  # twenty commands
                self.assertLessEqual(max(map(len, lines)), 80)
        for option in ("--json", "--certificate", "--max-defects", "--jobs", "--no-check", "--as-indexed", "--format", "--max-bytes",
                       "--max-faces", "--max-digits", "--max-exponent", "--max-cells", "--max-memory", "--quiet"):
            self.assertIn(option, run("certify", "--help").stdout)
        self.assertEqual(re.findall(r"(?m)^  (\w[\w-]*)", run("--help").stdout), COMMANDS)

    def test_help_is_plain(self):
        """A summary is an imperative; no explanation opens as tests/wording_test.py forbids, or with a preposition that has no subject."""
        for command in COMMANDS:
            with self.subTest(command):
                summary, options = run(command, "--help").stdout.split("Usage:", 1)
                self.assertRegex(summary, r"^(decide|list|write|find|explain|print) ")
                for text in re.findall(r"(?m)^(?:  -.*?  +|  -.*\n +)(\S.*)$", options):
                    self.assertNotRegex(text, r"(?i)^(of|about|as many|none|back|behind|wanted)\b")
                    for name, pattern, better in wording_test.BANNED:
                        self.assertIsNone(pattern.search(text), f"{name}: {better}: {text}")

    def test_the_version_is_one_line(self):
        done = run("--version")
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stdout, r"^veritope \d+\.\d+\.\d+\n$")
        self.assertEqual(support.report(VALID)["tool"] + "\n", done.stdout)

    def test_the_page_of_a_command_names_each_of_its_options_in_a_table(self):
        def named_on(name):
            lines = (support.ROOT / "docs" / "cli" / f"{name}.md").read_text().splitlines()
            return set(re.findall(r"--[a-z-]+", " ".join(line.split(" | ")[0] for line in lines if line.startswith("| "))))

        limits = {option for option in named_on("README") if option.startswith("--max-")} - {"--max-"}
        for command in COMMANDS:
            named = named_on(command)
            if "--max-" in named:  # `--max-...`: all limits
                named |= limits
            found = set(re.findall(r"--[a-z-]+", run(command, "--help").stdout.split("Options:")[1]))
            self.assertLessEqual(found - {"--help"}, named, command)

    def test_the_overview_names_every_command_and_its_page(self):
        page = (support.ROOT / "docs" / "cli" / "README.md").read_text()
        self.assertEqual(re.findall(r"(?m)^\| \[`veritope ([\w-]+)[^`]*`\]\(\1\.md\)", page), COMMANDS)


class Rooms(unittest.TestCase):
    def test_every_command_has_a_file_of_its_own_and_one_file_alone_includes_the_parser(self):
        sources = sorted((support.ROOT / "cli").glob("*.*"))
        names = {path.name for path in sources}
        for command in COMMANDS:
            self.assertIn(f"command_{command.replace('-', '_')}.cc", names)
        self.assertEqual(sum(name.startswith("command_") for name in names), len(COMMANDS))
        self.assertEqual([path.name for path in sources if "#include <CLI/" in path.read_text()], ["option_set.cc"])

    def test_of_several_mistakes_in_the_options_the_first_of_a_fixed_order_is_named(self):
        for arguments, words in [(["certify", "-", "-"], "- is standard input and needs --format"),
                                 (["certify", "--format", "off", "-", "-"], "standard input can be read once only"),
                                 (["certify", "", "-"], "- is standard input and needs --format"),
                                 (["certify", "", "x.off"], "a file name must not be empty"),
                                 (["certify", "--picture", "-", ""], "a file name must not be empty"),
                                 (["certify", "--picture", "-", "x.off"], "--picture needs a file name, not -"),
                                 (["certify", "--picture", "p", "x.off", "y.off"], "--picture takes exactly one input"),
                                 (["certify", "--certificate", "-", "x.off"], "--certificate needs a file name, not -"),
                                 (["convert", "x.off", "-"], "- is standard output and needs --to"),
                                 (["cover", "x.itd"], "-o,--output is required"),
                                 (["cover", "x.itd", "-o", "-"], "--output needs a file name, not -"),
                                 (["cover", "x.itd", "--eps", "1"], "--eps requires --sweep"),
                                 (["cover", "x.itd", "--sweep", "1", "--what", "boxes"], "--what excludes --sweep"),
                                 (["certify", "-j", "0", "x.off"], "--jobs: must be a number from 1 to 1024, not 0"),
                                 (["certify", "--orient", "x", "x.off"], "--orient: must be auto or keep, not x"),
                                 (["intersect", "-o", "", "a", "b"], "-o,--output: needs a name")]:
            with self.subTest(arguments):
                done = run(*arguments)
                self.assertEqual((done.returncode, done.stdout), (2, ""))
                self.assertEqual(done.stderr.splitlines(), ["veritope: " + words, f"veritope {arguments[0]} --help says more"])


class Folders(unittest.TestCase):
    """certify DIR, the totals and the table."""

    def setUp(self):
        self.temporary = support.tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = Path(self.temporary.name)

    def copy(self, source, name):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(Path(source).read_bytes())

    def paths(self, done):
        lines = done.stdout.splitlines()
        return [str(Path(re.split("  +", line)[1]).relative_to(self.folder)) for line in lines[:-1]]

    def test_a_folder_stands_for_the_models_in_it_sorted_by_their_paths(self):
        for name in ("b.off", "a/z.OFF", "a/.hidden.off", ".git/x.off", "notes.txt", "a-c.off"):
            self.copy(VALID, name)
        os.symlink(self.folder, self.folder / "a" / "loop")
        done = run("certify", "-q", self.folder)
        self.assertEqual((done.returncode, self.paths(done)), (0, ["a-c.off", "a/z.OFF", "b.off"]))
        self.assertEqual(done.stdout.splitlines()[-1], "3 files: 3 valid")
        self.assertEqual(run("certify", "-q", f"{self.folder}/").returncode, 0)

    def test_glob_selects_by_name_whatever_the_ending(self):
        for name in ("part.off", "part.model", "other.model"):
            self.copy(VALID, name)
        done = run("certify", "-q", "--format", "off", "--glob", "p*.model", self.folder)
        self.assertEqual([Path(re.split("  +", line)[1]).name for line in done.stdout.splitlines()], ["part.model"])

    def test_a_folder_without_models_is_wrong_usage_and_says_what_it_looked_for(self):
        for options, words in [([], "has a known extension (stl, obj"), (["--glob", "*.zzz"], "has a name that matches *.zzz")]:
            done = run("certify", *options, self.folder)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn(words, done.stderr)

    @unittest.skipIf(os.geteuid() == 0, "root reads every folder")
    def test_a_subfolder_that_cannot_be_read_is_listed(self):
        self.copy(VALID, "a.off")
        (self.folder / "closed").mkdir(mode=0)
        done = run("certify", "-q", self.folder)
        self.assertEqual((done.returncode, self.paths(done)), (4, ["a.off", "closed"]))

    def test_totals_count_the_verdicts_and_columns_are_aligned(self):
        for source, name in [(VALID, "a.off"), (INVALID, "long_name.off"), (UNREADABLE, "u.off")]:
            self.copy(source, name)
        lines = run("certify", "-q", self.folder).stdout.splitlines()
        self.assertEqual(lines[-1], "3 files: 1 valid, 1 invalid, 1 unreadable")
        starts = {re.match(r"(\w+ +)(\S+ +)", line).span(2) for line in lines[:-1]}
        self.assertEqual(len(starts), 1, lines)

    def test_the_table_has_a_row_for_each_file_and_the_values_of_the_report(self):
        for source, name in [(VALID, "a\tb.off"), (INVALID, "i.off"), (UNREADABLE, "u.off")]:
            self.copy(source, name)
        done = run("certify", "--tsv", "-", self.folder)
        rows = [line.split("\t") for line in done.stdout.splitlines()]
        self.assertEqual({len(row) for row in rows}, {12})
        table = [dict(zip(rows[0], row)) for row in rows[1:]]
        self.assertEqual([row["verdict"] for row in table], ["VALID", "INVALID", "UNREADABLE"])
        self.assertEqual([row["codes"] for row in table][:2], ["", "M3:3"])
        self.assertEqual([row["checked"] for row in table], ["yes", "yes", "no"])
        self.assertTrue(table[0]["file"].endswith("a\\x09b.off"))
        self.assertEqual((table[0]["bodies"], table[0]["genus"]), ("1", "0"))

    def test_a_table_never_overwrites_an_input_or_another_output(self):
        self.copy(VALID, "a.off")
        path, out = self.folder / "a.off", self.folder / "out"
        for arguments in (["--tsv", path, path], ["--tsv", out, "--json", out, path], ["--tsv", out, "--certificate", out, path],
                          ["--tsv", out, "--picture", out, path], ["--tsv", "-", "--json", "-", path]):
            done = run("certify", *arguments)
            self.assertEqual((done.returncode, done.stdout), (2, ""), arguments)
        volume, kept = MODELS / "splines" / "two_cubes.mesh", self.folder / "v.cert"
        self.assertEqual(run("certify", "--certificate", kept, "--tsv", f"{kept}.vjson", volume).returncode, 2)
        self.assertFalse(out.exists() or kept.exists())
        self.assertEqual(path.read_bytes(), Path(VALID).read_bytes())

    def test_a_table_may_lie_in_the_new_folder_of_the_certificates(self):
        self.copy(VALID, "in/a.off")
        new = self.folder / "new"
        self.assertEqual(run("certify", "--certificate", new, "--tsv", new / "t.tsv", self.folder / "in").returncode, 0)
        self.assertEqual(sorted(os.listdir(new)), ["a.off.cert", "t.tsv"])
        taken = self.folder / "taken"
        done = run("certify", "--certificate", taken, "--tsv", taken / "a.off.cert", self.folder / "in")
        self.assertEqual((done.returncode, taken.exists()), (2, False))

    def test_what_needs_a_folder_or_a_file_says_so(self):
        self.copy(VALID, "a.off")
        for arguments, words in [(["--glob", "*.off", self.folder / "a.off"], "no folder is given"),
                                 (["--picture", self.folder / "p.png", self.folder], "--picture takes exactly one input, not a folder")]:
            done = run("certify", *arguments)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn(words, done.stderr)


class Widths(unittest.TestCase):
    """Reports keep to the width of the terminal, and to 100 columns elsewhere."""

    def reports(self):
        models = support.ROOT / "tests" / "models"
        return sorted(models.glob("m*_smallest.*")) + sorted((models / "patches").glob("*_smallest.*"))

    def test_lines_fit_the_terminal(self):
        for columns in (80, 120):
            output = run_on_terminal("certify", "--max-defects", "3", *self.reports(), environment={"NO_COLOR": "1"}, columns=columns)
            for line in output.replace("\r\n", "\n").splitlines():
                if "/models/" not in line:
                    self.assertLessEqual(len(line.split("\r\033[K")[-1]), columns, line)

    def test_details_elsewhere_have_at_most_100_columns(self):
        for line in run("certify", *self.reports()).stdout.splitlines():
            if line.startswith(" "):
                self.assertLessEqual(len(line), 100, line)


class ExitStatus(unittest.TestCase):
    def test_of_several_files_the_first_of_5_1_4_3_0_decides(self):
        for files, status in [([VALID], 0), ([INVALID], 1), ([UNREADABLE], 4), ([VALID, UNREADABLE], 4), ([UNREADABLE, INVALID], 1),
                              ([INVALID, UNREADABLE, VALID], 1), ([VALID, VALID], 0)]:
            done = run("certify", "-q", *files)
            self.assertEqual(done.returncode, status, files)
            self.assertEqual(len(done.stdout.splitlines()), len(files) + (len(files) > 1))  # and the totals

    def test_what_is_no_file_is_exit_4_with_its_name(self):
        for path, word in [("/nonexistent/a.stl", "No such file"), ("/dev/null", "device")]:
            done = run("certify", path)
            self.assertEqual(done.returncode, 4)
            self.assertRegex(done.stdout, rf"^UNREADABLE  {path}  .*{word}")

    def test_a_fifo_without_a_writer_is_refused_at_once(self):
        with support.tempfile.TemporaryDirectory() as folder:
            for name in ("fifo", "fifo.stl", "fifo.itd"):
                fifo = support.os.path.join(folder, name)
                support.os.mkfifo(fifo)
                for command in (["certify"], ["info"], ["project", "0,0,0"], ["cover", "--sweep", "0"]):
                    done = run(*command, fifo, timeout=60)
                    self.assertEqual(done.returncode, 4, (command, done))
                    self.assertIn("it is a FIFO", done.stdout + done.stderr)

    def test_files_of_formats_that_are_not_read_are_named_by_every_command(self):
        with support.tempfile.TemporaryDirectory() as folder:
            part = support.os.path.join(folder, "part.step")
            with open(part, "w") as file:
                file.write("ISO-10303-21;\nHEADER;\nENDSEC;\n")
            output = support.os.path.join(folder, "out.stl")
            for command in (["certify", part], ["info", part], ["convert", part, output], ["project", "0,0,0", part],
                            ["cover", part, "-o", output], ["intersect", part, part]):
                done = run(*command)
                self.assertEqual(done.returncode, 4, done)
                self.assertRegex(done.stdout + done.stderr,
                                 r"byte 0: this is a STEP file: not read yet; the formats that are read are stl, obj, ply, off, "
                                 r"itd, g2, mfem, gismo, vjson, vmicro and vdms\n", command)

    def test_an_unknown_file_gets_the_list_of_all_formats(self):
        with support.tempfile.TemporaryDirectory() as folder:
            part = support.os.path.join(folder, "part.txt")
            with open(part, "w") as file:
                file.write("hello\n")
            done = run("certify", part)
            self.assertEqual(done.returncode, 4)
            self.assertIn("says whether this is stl, obj, ply, off, itd, g2, mfem, gismo, vjson, vmicro or vdms (--format)", done.stdout)

    def test_a_mesh_where_splines_are_needed_is_named(self):
        done = run("project", "0,0,0", VALID)
        self.assertEqual(done.returncode, 4)
        self.assertIn("this is a mesh (off); needed is a file of splines: itd, g2, mfem, gismo or vjson", done.stderr)

    def test_the_first_line_is_the_verdict(self):
        self.assertEqual(run("certify", MODELS / "valid_frame.off").stdout.split("\n")[0],
                         f"VALID  {MODELS / 'valid_frame.off'}  1 body, genus 1, volume 8 (checked)")
        self.assertEqual(run("certify", INVALID).stdout.split("\n")[0], f"INVALID  {INVALID}  3 boundary edges (checked)")
        self.assertEqual(run("certify", "-q", UNREADABLE).stdout, f"UNREADABLE  {UNREADABLE}  byte 0: the file is empty\n")

    def test_no_check_says_so(self):
        self.assertIn("(not checked)\n", run("certify", "-q", "--no-check", VALID).stdout)
        self.assertIn("not checked (--no-check)", run("certify", "--no-check", VALID).stdout)
        file = support.only_file("--no-check", VALID)
        self.assertEqual((file["certificate"]["checked"], file["seconds"]["check"]), (False, None))


class StandardInput(unittest.TestCase):
    def test_a_model_from_standard_input_is_certified_and_checked(self):
        for model in ("valid_solid_header.stl", "valid_quads_crlf.obj", "valid_big_endian.ply", "m7_flat.off"):
            data = (MODELS / model).read_bytes()
            done = run("certify", "--json", "-", "--format", model[-3:], "-", input=data, text=False)
            file = support.json.loads(done.stdout)["files"][0]
            named = support.only_file(MODELS / model)
            self.assertEqual((file["path"], file["sha256"], file["verdict"]), ("-", named["sha256"], named["verdict"]))
            self.assertEqual(file["certificate"], named["certificate"])

    def test_a_certificate_of_standard_input_can_be_kept(self):
        with support.tempfile.TemporaryDirectory() as folder:
            certificate = os.path.join(folder, "c")
            run("certify", "--format", "off", "-", "--certificate", certificate, input=VALID.read_text())
            done = run(VALID, certificate, program=BIN / "veritope-check")
            self.assertEqual(done.returncode, 0, done.stdout)

    def test_a_bad_model_from_standard_input_names_the_line(self):
        done = run("certify", "--format", "off", "-", input="OFF\nx\n")
        self.assertEqual(done.returncode, 4)
        self.assertRegex(done.stdout, r"^UNREADABLE  standard input  line 2: ")

    def test_names_that_look_like_options_are_files_behind_two_hyphens(self):
        with support.tempfile.TemporaryDirectory() as folder:
            support.shutil.copy(VALID, os.path.join(folder, "--odd.off"))
            done = run("certify", "-q", "--", "--odd.off", cwd=folder)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn("(checked)", done.stdout)


class Limits(Folder):
    def assert_limit(self, path, flag, limit):
        """`limit` is enough, one less is refused with the flag's name."""
        self.assertEqual(run("certify", "-q", flag, limit, path).returncode, 0, flag)
        done = run("certify", "--json", "-", flag, limit - 1, path)
        error = support.json.loads(done.stdout)["files"][0]["error"]
        self.assertEqual((done.returncode, error["code"]), (4, "over-limit"), flag)
        self.assertIn(f"{flag} {limit - 1}", error["message"])

    def test_each_limit_holds_at_n_and_refuses_at_n_plus_1(self):
        self.assert_limit(VALID, "--max-bytes", VALID.stat().st_size)
        for model, faces in [("valid_frame.off", 32), ("valid_strip.ply", 4), ("valid_capitals.stl", 4), ("valid_solid_header.stl", 4),
                             ("valid_quads_crlf.obj", 12), ("valid_big_endian.ply", 12)]:
            self.assert_limit(MODELS / model, "--max-faces", faces)
        number = self.folder / "number.off"
        number.write_text(VALID.read_text().replace("\n1 0 0", "\n1.2500e-07 0 0", 1))
        self.assert_limit(number, "--max-digits", 5)
        self.assert_limit(number, "--max-exponent", 7)

    def test_the_byte_limit_holds_for_standard_input(self):
        text = VALID.read_text()
        for limit, status in [(len(text), 0), (len(text) - 1, 4)]:
            done = run("certify", "-q", "--format", "off", "--max-bytes", limit, "-", input=text)
            self.assertEqual(done.returncode, status)

    def test_the_limits_hold_for_info_and_convert_too(self):
        self.assertEqual(run("info", "--max-faces", 3, VALID).returncode, 4)
        self.assertEqual(run("convert", "--max-faces", 3, VALID, self.folder / "x.off").returncode, 4)
        self.assertEqual(self.listing(), [])

    def test_max_defects_lists_so_many_and_counts_all(self):
        model = MODELS / "m2_copied_face.off"  # one M2, three M4, one M7
        for most, listed in [(0, []), (1, ["M2", "M4", "M7"]), (2, ["M2", "M4", "M4", "M7"]), (100, ["M2", "M4", "M4", "M4", "M7"])]:
            file = support.only_file("--max-defects", most, model)
            self.assertEqual([defect["rule"] for defect in file["defects"]], listed)
            self.assertEqual((file["defects_total"], file["certificate"]["checked"]), (5, True))
        self.assertIn("... 2 more", run("certify", "--max-defects", 1, model).stdout)

    def test_the_largest_defects_are_listed_first(self):
        file = support.only_file("--max-defects", 2, MODELS / "m3_crack.stl")
        every = support.only_file("--max-defects", 9, MODELS / "m3_crack.stl")["defects"]
        sizes = [defect["size"] for defect in every]
        self.assertEqual(sizes, sorted(sizes, reverse=True))
        self.assertEqual(file["defects"], every[:2])

    def test_an_open_edge_has_its_ends_and_the_gap_to_the_nearest_one(self):
        defects = support.only_file(MODELS / "m3_crack.stl")["defects"]
        ends = {tuple(d["edges"][0]): [[fractions.Fraction(c) for c in end["exact"]] for end in d["ends"]] for d in defects}
        for defect in defects:
            mine, other = ends[tuple(defect["edges"][0])], ends[tuple(defect["near_edge"])]
            gap = min(squared_distance(mine, other), squared_distance(other, mine))
            self.assertEqual(fractions.Fraction(defect["gap"]["squared"]), gap)
            self.assertLess(abs(fractions.Fraction(defect["gap"]["decimal"]) ** 2 / gap - 1), 2 ** -50)
            self.assertEqual([(a + b) / 2 for a, b in zip(*mine)], [fractions.Fraction(c) for c in defect["point"]["exact"]])
        counts = support.only_file(MODELS / "m3_crack.stl")["counts"]
        self.assertEqual((counts["borders"], counts["near_edges"]), (1, 4))
        gaps = [d["gap"]["decimal"] for d in defects]
        self.assertEqual(counts["near_distance"], {"least": min(gaps), "greatest": max(gaps)})
        hole = support.only_file(MODELS / "m3_missing_face.off")["counts"]
        self.assertEqual((hole["borders"], hole["near_edges"], hole["near_distance"]), (1, 0, None))
        closed = support.only_file(VALID)["counts"]
        self.assertEqual((closed["borders"], closed["near_edges"], closed["near_distance"]), (0, 0, None))


@unittest.skipIf(os.environ.get("VERITOPE_SANITIZE"), "sanitizers want to be loaded first")
@unittest.skipIf((os.cpu_count() or 1) < 2, "needs two processors")
class Threads(Folder):
    COUNTING = """#define _GNU_SOURCE
#include <dlfcn.h>
#include <pthread.h>
#include <unistd.h>
int pthread_create(pthread_t* thread, const pthread_attr_t* how, void* (*start)(void*), void* argument) {
  if (write(2, "t", 1) != 1) _exit(9);
  int (*create)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*) = dlsym(RTLD_NEXT, "pthread_create");
  return create(thread, how, start, argument);
}
"""

    def test_a_small_mesh_takes_one_thread_unless_more_are_asked_for(self):
        code, library = self.folder / "count.c", self.folder / "count.so"
        code.write_text(self.COUNTING)
        compiler = next(name for name in ("cc", "gcc", "clang") if shutil.which(name))
        subprocess.run([compiler, "-shared", "-fPIC", code, "-o", library, "-ldl"], check=True)
        small = support.write_off(self.folder / "small.off", *support.grid(10))
        large = support.write_off(self.folder / "large.off", *support.grid(40))
        for model, jobs, are_started in [(small, [], False), (small, ["-j", 2], True), (large, [], True), (large, ["-j", 1], False)]:
            kept = self.folder / "c"
            done = run("certify", "-q", *jobs, "--certificate", kept, model, env={**os.environ, "LD_PRELOAD": str(library)})
            self.assertEqual((done.returncode, bool(done.stderr)), (0, are_started), (model, jobs, done))
            with_jobs = kept.read_bytes()
            run("certify", "-q", "-j", 3, "--certificate", kept, model)
            self.assertEqual(kept.read_bytes(), with_jobs)


class Cracks(Folder):
    def test_edges_of_cracks_without_a_gap_are_counted(self):
        touching = [[(0, 0), (2, 0), (1, 1)], [(1, 0), (0, 0), (0, -1)], [(2, 0), (1, 0), (2, -1)]]  # two edges on one
        apart = [[(10, 0), (12, 0), (11, 1)], [(12, -1e-9), (10, -1e-9), (11, -1)]]
        for faces, words in [(touching, "3 edges lie on another open edge: cracks without a gap"),
                             (apart, "2 edges lie within 1e-09 of another open edge: cracks\n"),
                             (touching + apart, "5 edges lie within 0 to 1e-09 of another open edge: cracks, 3 of these edges without a gap\n")]:
            model = self.folder / "m.off"
            points = [point for face in faces for point in face]
            model.write_text(f"OFF\n{len(points)} {len(faces)} 0\n" + "".join(f"{x} {y} 0\n" for x, y in points) +
                             "".join(f"3 {3 * i} {3 * i + 1} {3 * i + 2}\n" for i in range(len(faces))))
            text = re.sub(r"\n +", " ", run("certify", model).stdout.replace("\n    ", " ", 1))
            self.assertIn(words.rstrip("\n"), text)
            self.assertEqual("without a gap" in text, "without a gap" in words)


class Terminal(Folder):
    def test_colours_only_on_a_terminal_and_unless_no_color(self):
        self.assertNotIn("\033", run("certify", VALID).stdout)
        environment = {key: value for key, value in os.environ.items() if key != "NO_COLOR"}
        os.environ.pop("NO_COLOR", None)
        self.assertIn("\033[1;32mVALID\033[0m", run_on_terminal("certify", VALID))
        self.assertNotIn("\033[1", run_on_terminal("certify", VALID, environment={"NO_COLOR": "1"}))
        self.assertNotIn("\033[1", run_on_terminal("certify", VALID, environment={"TERM": "dumb"}))
        os.environ.update(environment)

    def test_progress_shows_on_a_terminal_and_is_erased(self):
        veritope = self.copy_programs("sleep 1; echo ACCEPT mesh-valid-1")
        ours, theirs = pty.openpty()
        done = subprocess.run([veritope, "certify", VALID], stdout=subprocess.PIPE, stderr=theirs, text=True)
        os.close(theirs)
        shown = read_terminal(ours)
        self.assertIn("m3_nearest_valid.off: checking, ", shown)
        self.assertTrue(shown.endswith("\r\033[K"), shown)
        self.assertNotIn("checking", done.stdout)

    def test_nothing_shows_where_no_terminal_is(self):
        veritope = self.copy_programs("sleep 1; echo ACCEPT mesh-valid-1")
        self.assertEqual(run("certify", VALID, program=veritope).stderr, "")

    def test_a_file_cannot_drive_the_terminal(self):
        name = bytes(self.folder) + "/Gr\u00fc\u00dfe\x1b[31m\nVALID \x9b".encode() + b"\x9b.off"
        with open(name, "w"):
            pass
        done = subprocess.run([BIN / "veritope", "certify", "-q", name], capture_output=True)
        self.assertEqual(done.stdout.count(b"\n"), 1)
        self.assertIn("/Gr\u00fc\u00dfe\\x1b[31m\\x0aVALID \\xc2\\x9b\\x9b.off  byte 0", done.stdout.decode())


class Explain(unittest.TestCase):
    def test_every_rule_is_explained_on_one_screen(self):
        listed = run("explain").stdout
        for i in range(1, 10):
            page = run("explain", f"M{i}")
            self.assertEqual((page.returncode, page.stderr), (0, ""))
            lines = page.stdout.rstrip("\n").split("\n")
            self.assertLessEqual(len(lines), 25)
            self.assertLessEqual(max(map(len, lines)), 80)
            self.assertIn(lines[0], listed)
            self.assertEqual(run("explain", f"m{i}").stdout, page.stdout)

    def test_the_catalogue_has_a_page_for_each_with_the_same_picture_and_its_models(self):
        for i in range(1, 10):
            page = (support.ROOT / "docs" / "rules" / f"M{i}.md").read_text()
            explained = run("explain", f"M{i}").stdout
            name = explained.split("\n")[0].split("  ", 1)[1]
            self.assertTrue(page.startswith(f"# M{i}: {name}\n"), f"M{i}")
            picture = re.search(r"(?ms)^```\n(.*?)^```$", page)[1]
            self.assertIn("".join(f"  {line}\n" for line in picture.splitlines()), explained)
            for model in (f"m{i}_smallest.off", f"m{i}_nearest_valid.off"):
                self.assertIn(f"(../../tests/models/{model})", page)

    def test_every_answer_about_patches_is_explained_as_its_page_says(self):
        page = (support.ROOT / "docs" / "rules" / "patches.md").read_text()
        codes = re.findall(r"(?m)^## (.*)$", page)
        self.assertEqual(len(codes), 22)
        listed = run("explain").stdout
        for code in codes:
            explained = run("explain", code)
            self.assertEqual((explained.returncode, explained.stderr), (0, ""))
            lines = explained.stdout.rstrip("\n").split("\n")
            self.assertLessEqual(len(lines), 25)
            self.assertLessEqual(max(map(len, lines)), 80)
            self.assertIn(lines[0], listed)
            picture = re.search(rf"(?ms)^## {code}\n.*?^```\n(.*?)^```$", page)[1]
            self.assertIn("".join(f"  {line}\n" for line in picture.splitlines()), explained.stdout)

    def test_a_certificate_is_explained_and_another_file_is_refused(self):
        with support.tempfile.TemporaryDirectory() as folder:
            for model, words in [("valid_nested_three.off", ["mesh-valid-1", "nesting rays: 3"]),
                                 ("m7_flat.off", ["mesh-invalid-1", "M7: faces"])]:
                certificate = os.path.join(folder, "c")
                run("certify", MODELS / model, "--certificate", certificate)
                done = run("explain-certificate", certificate)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                for word in words:
                    self.assertIn(word, done.stdout)
            shorter = run("explain-certificate", "--max-items", "1", certificate).stdout
            self.assertLess(len(shorter), len(done.stdout) + 1)
            arc = bytes([0, 1, 0, 0, 1])                      # patch 0, side 1, [0, 1]
            body = b"VTPI" + bytes([1, 0, 0, 0, 0, 1, 1, 0, 0, 0]) + arc + bytes([2, 1, 1])
            line = b'{"claim":"patch-invalid-1","patches":1}\n'
            for text, code, word in ((line + body, 0, "monotone along: z"), (line + body + b"x", 4, ""), (line + body[:-1], 4, "")):
                Path(certificate).write_bytes(text)
                done = run("explain-certificate", certificate)
                self.assertEqual((done.returncode, done.stderr == ""), (code, code == 0), done)
                self.assertIn(word, done.stdout)
        for path in (VALID, UNREADABLE, "/nonexistent"):
            done = run("explain-certificate", path)
            self.assertEqual((done.returncode, done.stdout), (4, ""))


class Info(Folder):
    def test_info_says_what_is_in_the_file(self):
        done = run("info", MODELS / "valid_quads_crlf.obj")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for words in ("obj, ", "12 faces, 8 vertices", "6 cut into triangles", "1 mtllib lines", "(0, 0, 0) to (1, 1, 1)",
                      "every format"):
            self.assertIn(words, done.stdout)

    def test_info_gives_no_verdict_and_reads_all_files(self):
        done = run("info", INVALID, UNREADABLE, VALID)
        self.assertEqual(done.returncode, 4)
        self.assertNotIn("INVALID", done.stdout)
        self.assertRegex(done.stdout, rf"(?m)^UNREADABLE  {UNREADABLE}  byte 0: the file is empty$")

    def test_lossless_names_what_convert_writes(self):
        names = {"stl-binary": "stl", "ply-binary-little-endian": "ply", "ply-binary-big-endian": "ply-be"}
        for model in ("valid_frame.off", "valid_tiny.off", "m3_crack.stl"):
            lossless = support.json.loads(run("info", "--json", "-", MODELS / model).stdout)["files"][0]["lossless"]
            for variant in ("stl-binary", "stl-ascii", "obj", "ply-ascii", "ply-binary-little-endian", "ply-binary-big-endian", "off"):
                done = run("convert", "--to", names.get(variant, variant), MODELS / model, self.folder / "x")
                self.assertEqual(done.returncode == 0, variant in lossless, (model, variant))


if __name__ == "__main__":
    support.main()
