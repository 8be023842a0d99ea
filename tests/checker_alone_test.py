#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The checkers stand alone: their files, copied into an empty folder, build as C++11 with every compiler there is, run, and use the
standard library only, and are short enough to read.

With the word --lines it prints how many lines each claim's part has, the table of README.md.
"""
import ast
import collections
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
STRICT = ("-std=c++11", "-pedantic-errors", "-Wall", "-Wextra", "-Werror")
MOST_LINES_OF_A_FILE, MOST_COMMON_LINES = 300, 610  # three lines a claim are its row of the table
PARTS = ("common", "mesh", "points", "patches", "collar", "vmodel", "micro", "dms")  # the folders; what lies beside them serves every claim, as common does
LANGUAGES = {"C++": (".h", ".cc"), "Python": (".py",)}


def lines(path):
    return len(path.read_text().splitlines())


def lines_by_part():
    """{(language, part): lines}"""
    found = collections.Counter()
    for language, suffixes in LANGUAGES.items():
        for path in CHECKER.rglob("*"):
            if path.suffix in suffixes:
                part = path.parent.name if path.parent.name in PARTS else "common"
                found[language, part] += lines(path)
    return found


def table_of_lines():
    """The rows of the table in README.md."""
    found = lines_by_part()
    rows = [[language, *(found[language, part] for part in PARTS)] for language in LANGUAGES]
    return ["| " + " | ".join(map(str, [*row, sum(row[1:])])) + " |" for row in rows]


class Alone(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.alone = pathlib.Path(folder.name)
        shutil.copytree(CHECKER, self.alone, dirs_exist_ok=True, ignore=shutil.ignore_patterns("__pycache__", "CMakeLists.txt"))

    def run_here(self, *command):
        return subprocess.run(command, cwd=self.alone, capture_output=True, text=True)


class CheckerBuilds(Alone):
    def test_it_builds_as_strict_cpp11_and_runs(self):
        self.assertIn("g++", COMPILERS)
        sources = sorted(str(path.relative_to(self.alone)) for path in self.alone.rglob("*.cc"))
        for compiler in COMPILERS:
            # Two at a time, then as one program: what `g++ -std=c++11 *.cc` does.
            def compiled(source):
                return self.run_here(compiler, *STRICT, "-c", source, "-o", source.replace(".cc", ".o"))

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
        package = self.alone / "veritope_checker"
        may_see = {"common": {"common"}, "mesh": {"common", "mesh"}, "patches": {"common", "patches"}, "collar": {"common", "patches", "collar"},
                   "vmodel": {"common", "patches", "vmodel"}, "micro": {"common", "patches", "vmodel", "mesh", "points", "micro"}}
        for path in self.alone.rglob("*.py"):
            part = path.parent.name
            for node in ast.walk(ast.parse(path.read_text())):
                names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
                names += [node.module or ""] if isinstance(node, ast.ImportFrom) and node.level == 0 else []
                for name in names:
                    self.assertIn(name.split(".")[0], {"veritope_checker"} | sys.stdlib_module_names, path.name)
                if isinstance(node, ast.ImportFrom) and node.level > 0:
                    seen = package if path.parent == package or node.level == 2 else path.parent
                    target = seen.joinpath(*(node.module or "").split(".")) if node.module else seen
                    self.assertTrue(target.is_dir() or target.with_suffix(".py").is_file(), f"{path.name}: {target}")
                    if part in may_see:
                        self.assertIn(target.relative_to(package).parts[0], may_see[part], path.name)

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
        (self.alone / "veritope_checker" / "patches" / "star_box_read.py").unlink()
        gone = self.run_here(*command)
        self.assertEqual((gone.returncode, "beside" in gone.stderr), (4, True), gone)
        shutil.rmtree(self.alone / "veritope_checker")
        gone = self.run_here(*command)
        self.assertEqual((gone.returncode, "beside" in gone.stderr), (4, True), gone)

    def test_the_cpp_one_includes_its_own_files_and_the_standard_library_only(self):
        for path in [*self.alone.rglob("*.h"), *self.alone.rglob("*.cc")]:
            for mark, header in re.findall(r'(?m)^\s*#\s*include\s*([<"])([^>"]+)', path.read_text()):
                if mark == '"':
                    self.assertTrue((path.parent / header).resolve().is_relative_to(self.alone.resolve()), f"{path.name}: {header}")
                    self.assertTrue((path.parent / header).is_file(), f"{path.name}: {header}")
                elif (path.name, header) == ("main.cc", "sys/stat.h"):
                    continue  # what kind of file a name is of: docs/design/0020-one-front-door.md
                else:
                    self.assertRegex(header, r"^[a-z_0-9]+$", f"{path.name}: {header} is no header of the C++ library")

    def test_it_is_short_enough_to_read(self):
        for path in [*CHECKER.rglob("*.h"), *CHECKER.rglob("*.cc")]:
            self.assertLessEqual(lines(path), MOST_LINES_OF_A_FILE, path.name)
        found = lines_by_part()
        for language in LANGUAGES:
            self.assertLessEqual(found[language, "common"], MOST_COMMON_LINES, found)

    def test_the_readme_says_how_many_lines_each_part_has(self):
        found, readme = lines_by_part(), (ROOT / "README.md").read_text()
        for language in LANGUAGES:
            row = re.search(r"(?m)^\| %s \|([ 0-9|]+)\|$" % re.escape(language), readme)
            self.assertIsNotNone(row, f"README.md has no row for {language}; python3 tests/checker_alone_test.py --lines prints it")
            stated = [int(number) for number in row[1].split("|")]
            counted = [found[language, part] for part in PARTS]
            for said, counted_lines in zip(stated, [*counted, sum(counted)], strict=True):
                self.assertLessEqual(abs(said - counted_lines), 0.05 * counted_lines, f"{language}: the rows are now\n" + "\n".join(table_of_lines()))


if __name__ == "__main__":
    if sys.argv[1:] == ["--lines"]:
        print(*table_of_lines(), sep="\n")
    else:
        unittest.main()
