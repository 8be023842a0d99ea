#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""README.md and the pages in docs/ show what happens: their transcripts are run and compared; their C++ is that
of the programs that the install test builds.

usage: readme_test.py BIN_FOLDER

A fenced block tagged `console` is a transcript: lines that begin with "$ " are commands, the lines after each are its standard
output and standard error. The commands of a block run in one bash, in a fresh folder where examples/, docs/, verify/ and tests/ are
those of the tree and build/bin/ is BIN_FOLDER, so what they write is gone afterwards. Times compare as equal: a number with its
unit (0.31 s, 12 ms), and all numbers of a JSON object "seconds". A line of three dots stands for any lines.
The recipes of docs/cli/README.md, blocks tagged `sh`, run in the same way and succeed.
A block tagged `cpp` in README.md or docs/library.md must occur, apart from blank lines at its ends, in a program of
tests/install/consumer.
"""
import gzip
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
MARK = "--- next command ---"


def fenced_blocks(text, tag):
    return re.findall(rf"(?ms)^```{tag}\n(.*?)^```$", text)


def split_transcript(block):
    """[(command, output)] of a console block."""
    pieces = re.split(r"(?m)^\$ (.*)\n", block if block.endswith("\n") else block + "\n")
    return list(zip(pieces[1::2], pieces[2::2]))


def run_block(commands, folder):
    """The output of each command; all run in one shell, $? is that of the command before."""
    script = "status=0\n"
    for command in commands:
        script += f"printf '%s\\n' '{MARK}'\n(exit $status)\n{command}\nstatus=$?\n"
    done = subprocess.run(["bash", "-c", script], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return done.stdout.split(MARK + "\n")[1:]


def normalise(output):
    """The lines without what differs from run to run."""
    output = re.sub(r'("seconds": ?)\{[^}]*\}', r"\1{}", output)
    output = re.sub(r"\b\d+(\.\d+)? ?(s|ms|us|min|seconds)\b", "<time>", output)
    return [line.rstrip() for line in output.strip("\n").splitlines()]


def matches(shown, actual):
    """Whether the lines agree; a line "..." of the first stands for any lines."""
    if not shown:
        return not actual
    if shown[0] == "...":
        return any(matches(shown[1:], actual[skip:]) for skip in range(len(actual) + 1))
    return bool(actual) and shown[0] == actual[0] and matches(shown[1:], actual[1:])


class Readme(unittest.TestCase):
    BIN_FOLDER = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        for name in ("examples", "docs", "verify", "tests"):
            (self.folder / name).symlink_to(ROOT / name)
        (self.folder / "build").mkdir()
        (self.folder / "build" / "bin").symlink_to(self.BIN_FOLDER)
        self.text = (ROOT / "README.md").read_text()

    def test_the_transcripts_are_what_happens(self):
        pages = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
        with_transcripts = {str(page.relative_to(ROOT)) for page in pages if self.check_transcripts(page)}
        self.assertLessEqual({"README.md", "docs/rules/M7.md"}, with_transcripts)

    def check_transcripts(self, page):
        """Runs them; returns how many there are."""
        blocks = fenced_blocks(page.read_text(), "console")
        for block in blocks:
            transcript = split_transcript(block)
            self.assertTrue(transcript, f"a console block without a command:\n{block}")
            outputs = run_block([command for command, _ in transcript], self.folder)
            for (command, shown), actual in zip(transcript, outputs, strict=True):
                if not matches(normalise(shown), normalise(actual)):
                    self.fail(f"$ {command}\n--- {page.relative_to(ROOT)} shows\n{shown}--- it prints\n{actual}")
        return len(blocks)

    def test_the_cpp_examples_are_compiled_by_the_install_test(self):
        consumers = [path.read_text() for path in (ROOT / "tests" / "install" / "consumer").glob("*.cc")]
        blocks = [block for page in ("README.md", "docs/library.md") for block in fenced_blocks((ROOT / page).read_text(), "cpp")]
        self.assertGreater(len(blocks), 1)
        for block in blocks:
            self.assertTrue(any(block.strip("\n") in text for text in consumers), block)

    def test_the_two_commands_come_first(self):
        commands = re.findall(r"\./dev \w+", self.text)
        self.assertEqual(commands[:2], ["./dev demo", "./dev test"])


class Recipes(unittest.TestCase):
    """The recipes of docs/cli/README.md, with models under the names that they use."""

    MODELS = {"part.stl": "examples/sound_part.stl", "pipe.itd": "examples/quarter_pipe.itd",
              "block.mesh": "tests/models/splines/two_cubes.mesh", "parts/part.stl": "examples/sound_part.stl"}

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "parts").mkdir()
        for name, model in self.MODELS.items():
            shutil.copy(ROOT / model, self.folder / name)
        (self.folder / "points.txt").write_text("0 0 0\n1e3 0 0\n")
        (self.folder / "part.stl.gz").write_bytes(gzip.compress((self.folder / "part.stl").read_bytes()))
        for name, points in (("level", "[0 0 0] [4 0 0] [0 4 0] [4 4 0]"), ("upright", "[1 1 -1] [3 2 -1] [1 1 1] [3 2 1]")):
            (self.folder / f"{name}.itd").write_text(f"[OBJECT A\n [SURFACE BEZIER 2 2 E3\n  {points}]]\n")
        shutil.copy(ROOT / "tests" / "cli" / "trees" / "parts.json", self.folder / "flange.json")
        programs = self.folder / "programs"
        programs.mkdir()
        (programs / "your_program").write_text("#!/bin/sh\necho 0 0 0 1 0 0 0 1 0 0 0 1 1\n")
        (programs / "your_program").chmod(0o755)
        self.path = f"{Readme.BIN_FOLDER}:{programs}:/usr/bin:/bin"

    def run_recipe(self, block):
        """The status of a block, whose commands run one after the other until one fails, and its output."""
        if shutil.which("jq", path=self.path) is None:
            block = re.sub(r"(?m)^jq .*$", "true", block)
        block = block.replace("veritope corpus >", "veritope corpus --cases 1000 >")
        done = subprocess.run(["bash", "-ec", block], cwd=self.folder, env={"PATH": self.path, "PYTHONDONTWRITEBYTECODE": "1"},
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        return done.returncode, done.stdout

    def blocks(self):
        text = (ROOT / "docs" / "cli" / "README.md").read_text()
        return fenced_blocks(text[text.index("## Recipes"):text.index("## Models and formats")], "sh")

    def test_they_run(self):
        self.assertGreater(len(self.blocks()), 4)
        for block in self.blocks():
            status, output = self.run_recipe(block)
            self.assertEqual(status, 0, block + output)

    def test_the_job_fails_if_a_model_is_invalid(self):
        (job,) = [block for block in self.blocks() if "report.json" in block]
        shutil.copy(ROOT / "examples" / "part_with_hole.stl", self.folder / "parts")
        status, output = self.run_recipe(job)
        self.assertEqual(status, 1, output)
        if shutil.which("jq", path=self.path) is not None:
            self.assertRegex(output, r"(?m)^parts/part_with_hole.stl\tM3\tedge ")


class TheComparison(unittest.TestCase):
    def test_a_block_runs_in_one_shell_and_keeps_the_status(self):
        with tempfile.TemporaryDirectory() as folder:
            outputs = run_block(["x=3; false", "echo $? $x", "echo oops >&2"], folder)
        self.assertEqual(outputs, ["", "1 3\n", "oops\n"])

    def test_a_transcript_splits_into_commands_and_outputs(self):
        self.assertEqual(split_transcript("$ a\n1\n2\n$ b\n"), [("a", "1\n2\n"), ("b", "")])

    def test_times_are_equal_and_other_numbers_are_not(self):
        self.assertEqual(normalise("12 faces, 0.31 s"), normalise("12 faces, 4 s"))
        self.assertNotEqual(normalise("12 faces"), normalise("13 faces"))
        self.assertEqual(normalise('{"seconds":{"read":0.1}}'), normalise('{"seconds":{"read":0.2}}'))

    def test_three_dots_stand_for_lines_and_nothing_else_does(self):
        self.assertTrue(matches(["a", "...", "d"], ["a", "b", "c", "d"]))
        self.assertTrue(matches(["a", "..."], ["a"]))
        self.assertFalse(matches(["a", "...", "d"], ["a", "b"]))
        self.assertFalse(matches(["a"], ["a", "b"]))


if __name__ == "__main__":
    Readme.BIN_FOLDER = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
