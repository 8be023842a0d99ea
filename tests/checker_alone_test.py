#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The checkers stand alone: their files, copied into an empty folder, build as C++11 with every compiler there is, run, and use the
standard library only, and are short enough to read.
"""
import ast
import concurrent.futures
import hashlib
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
CHECKER = ROOT / "verify" / "checker"
COMPILERS = [name for name in ("g++", "clang++", "clang++-14") if shutil.which(name)]
MOST_LINES_OF_A_FILE, MOST_COMMON_LINES = 300, 600
COMMON = ("mesh_reader.cc", "numbers.h", "sha256.h", "statement.cc")  # what every kind of certificate needs


def lines(path):
    return len(path.read_text().splitlines())


class Alone(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.alone = pathlib.Path(folder.name)
        for path in CHECKER.iterdir():
            if path.suffix in (".h", ".cc", ".py"):
                shutil.copy(path, self.alone)

    def run_here(self, *command):
        return subprocess.run(command, cwd=self.alone, capture_output=True, text=True)


class CheckerBuilds(Alone):
    def test_it_builds_as_strict_cpp11_and_runs(self):
        self.assertIn("g++", COMPILERS)
        sources = sorted(path.name for path in self.alone.glob("*.cc"))
        for compiler in COMPILERS:
            # Two at a time, then as one program: what `g++ -std=c++11 *.cc` does.
            def compiled(source):
                return self.run_here(compiler, "-std=c++11", "-pedantic-errors", "-Wall", "-Wextra", "-Werror", "-c", source)

            with concurrent.futures.ThreadPoolExecutor(2) as pool:
                for source, build in zip(sources, pool.map(compiled, sources)):
                    self.assertEqual(build.returncode, 0, f"{compiler}, {source}: {build.stderr}")
            build = self.run_here(compiler, *(source.replace(".cc", ".o") for source in sources), "-o", "check")
            self.assertEqual(build.returncode, 0, f"{compiler}: {build.stderr}")
            version = self.run_here("./check", "--version")
            self.assertEqual(version.returncode, 0, version.stderr)
            self.assertRegex(version.stdout, r"^veritope-check .*\d")
            self.assertEqual(self.run_here("./check").returncode, 2)


class CheckerAlone(Alone):
    def test_the_python_one_runs_without_any_installed_package(self):
        command = (sys.executable, "-I", "-S", "veritope_check.py")
        version = self.run_here(*command, "--version")
        self.assertEqual(version.returncode, 0, version.stderr)
        self.assertRegex(version.stdout, r"^veritope.check.* .*\d")
        self.assertEqual(self.run_here(*command).returncode, 2)

    def test_the_python_one_imports_the_standard_library_only(self):
        own = {path.stem for path in self.alone.glob("*.py")}
        for path in self.alone.glob("*.py"):
            for node in ast.walk(ast.parse(path.read_text())):
                names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
                names += [node.module or ""] if isinstance(node, ast.ImportFrom) else []
                for name in names:
                    self.assertIn(name.split(".")[0], own | sys.stdlib_module_names, path.name)

    def test_the_python_one_says_which_file_a_claim_needs(self):
        model, certificate = self.alone / "m.vjson", self.alone / "m.cert"
        model.write_bytes(b"{}")
        digest = hashlib.sha256
        statement = {"certificate": "veritope-certificate-1", "tool": "", "claim": "star-box-1", "subject_format": "vjson",
                     "subject_sha256": digest(b"{}").hexdigest(), "subject_bytes": 2, "body_sha256": digest(b"").hexdigest(),
                     **dict.fromkeys(("patches", "edges", "vertices", "shells", "bodies", "genus", "boxes", "flipped"), 0)}
        certificate.write_text(json.dumps(statement, separators=(",", ":")) + "\n")
        command = (sys.executable, "-I", "-S", "veritope_check.py", model.name, certificate.name)
        there = self.run_here(*command)
        self.assertEqual((there.returncode, "keys" in there.stderr), (4, True), there)       # it read the model
        (self.alone / "star_box_read.py").unlink()
        gone = self.run_here(*command)
        self.assertEqual((gone.returncode, "beside" in gone.stderr), (4, True), gone)

    def test_the_cpp_one_includes_its_own_files_and_the_standard_library_only(self):
        for path in [*self.alone.glob("*.h"), *self.alone.glob("*.cc")]:
            for mark, header in re.findall(r'(?m)^\s*#\s*include\s*([<"])([^>"]+)', path.read_text()):
                if mark == '"':
                    self.assertTrue((self.alone / header).is_file(), f"{path.name}: {header}")
                else:
                    self.assertRegex(header, r"^[a-z_0-9]+$", f"{path.name}: {header} is no header of the C++ library")

    def test_it_is_short_enough_to_read(self):
        sizes = {path.name: lines(path) for pattern in ("*.h", "*.cc") for path in self.alone.glob(pattern)}
        for name, size in sizes.items():
            self.assertLessEqual(size, MOST_LINES_OF_A_FILE, name)
        common = {name: sizes[name] for name in COMMON}
        self.assertLessEqual(sum(common.values()), MOST_COMMON_LINES, common)


if __name__ == "__main__":
    unittest.main()
