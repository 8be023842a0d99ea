#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The house is open: a kind of model that the product does not know is added by new files and by rows of tables alone.

tests/support/dummy_kind has the kind, a ball given by its centre and radius: its new files (the folder files) and the rows (rows.patch).
Rows: every line that the patch changes lies in a table where docs/how-to/add-a-solid.md asks for a row. Built: a copy of the tree with the
rows and files is built; certify, both checkers, the reports and explain-certificate speak of balls, and the tests of the tree pass in it.

usage: dummy_kind_test.py [BUILD] [Rows | Built]      BUILD: the copy is made in BUILD/dummy_kind; the default is build
       dummy_kind_test.py --rows                      prints which lines the patch changes, and the new files
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

try:
    import jsonschema
except ImportError:
    jsonschema = None

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT / "tests" / "infra")]
import tree  # noqa: E402

KIND = ROOT / "tests" / "support" / "dummy_kind"
BUILD = pathlib.Path(sys.argv.pop(1)).resolve() if len(sys.argv) > 1 and pathlib.Path(sys.argv[1]).is_dir() else ROOT / "build"
NOTE, HOW_TO = ROOT / "docs" / "design" / "0030-a-new-kind.md", ROOT / "docs" / "how-to" / "add-a-solid.md"

INCLUDE = r"#include "
LAYER = r"[a-z_/]+ +\|.*\|.*|veritope_layer\(.*"
# Where rows may stand: {file: [(first line of the table, its last line), ...]}; one line can be both. "" is a whole file of rows.
TABLES = {
    "io/model_file.h": [("enum class ModelKind", "};"), ("using ModelFile =", ";"), ("using FormatId =", ";")],
    "io/formats.cc": [("const std::vector<ModelFormat>& rows() {", "}")],
    "verify/certify/certify_kinds_internal.h": [("// As certify, for one kind.", "inline void enter")],
    "verify/format/claims.h": [("using AnyBody =", ";")],
    "verify/format/claims.cc": [("constexpr auto kClaims =", "});")],
    "verify/checker/claims.cc": [("const std::vector<Claim>& all_claims() {", "}")],
    "verify/checker/veritope_checker/claims.py": [("CLAIMS = {", "def lines")],
    "docs/layers.txt": [],
    "io/CMakeLists.txt": [],
    "solids/CMakeLists.txt": [],
    "tests/support/every_claim.py": [("COMMANDS = {", "}")],
    "tests/claims_table_test.py": [("import attacks", "BIN ="), ("LIARS = {", "}")],
}
# Where new files may stand.
FOLDERS = r"(solids/ball|io/balls|verify/checker/ball|verify/checker/veritope_checker/ball|tests/models/balls)/[\w.]+"
FILES = r"verify/certify/certify_ball\.cc|verify/format/ball_certificate\.(h|cc)|docs/certificates/ball\.md|tests/mutation/ball_liars\.py"


def hunks(patch):
    """[(file, [(mark, line), ...]), ...]; a mark is a blank, + or -."""
    found, name = [], None
    for line in patch.splitlines():
        if line.startswith("+++ "):
            name = line[4:]
        elif line.startswith("@@"):
            found.append((name, []))
        elif not line.startswith("--- "):
            found[-1][1].append((line[:1] or " ", line[1:]))
    return found


def position(lines, block):
    """The one place where a list of lines has a block of lines."""
    places = [i for i in range(len(lines) - len(block) + 1) if lines[i:i + len(block)] == block]
    if len(places) != 1:
        raise ValueError(f"{len(places)} places fit, not one:\n" + "\n".join(block))
    return places[0]


def applied(patch, read):
    """{file: (new lines, {number of a changed line, from 0}, [removed lines])}. read(file): its lines."""
    files = {}
    for name, hunk in hunks(patch):
        lines, changed, removed = files.setdefault(name, (read(name), set(), []))
        at = position(lines, [text for mark, text in hunk if mark != "+"])
        new = [(mark, text) for mark, text in hunk if mark != "-"]
        grown = len(new) - sum(mark != "+" for mark, _ in hunk)
        moved = {i + grown if i >= at else i for i in changed}
        changed.clear()
        changed |= moved | {at + i for i, (mark, _) in enumerate(new) if mark == "+"}
        removed += [text for mark, text in hunk if mark == "-"]
        lines[at:at + len(hunk) - sum(mark == "+" for mark, _ in hunk)] = [text for _, text in new]
    return files


def inside(lines, i, first, last):
    """Whether line i lies between the line that starts with `first` and the next one that starts or ends with `last`, these two included."""
    begins = [k for k, line in enumerate(lines) if line.startswith(first)]
    if len(begins) != 1:
        return False
    ends = (k for k in range(begins[0], len(lines)) if lines[k].startswith(last) or lines[k].endswith(last))
    return begins[0] <= i <= next(ends, -1)


def outside_of_tables(patch, read):
    """The changed lines that are no rows: ["file:line: text", ...]."""
    wrong = []
    for name, (lines, changed, removed) in applied(patch, read).items():
        for i in sorted(changed):
            is_row = name in TABLES and (
                any(inside(lines, i, *table) for table in TABLES[name]) or
                (not TABLES[name] and re.fullmatch(LAYER, lines[i])) or
                re.match(INCLUDE + r'"[\w/]*ball\w*(/\w+)?\.h"$', lines[i]))
            if not is_row:
                wrong.append(f"{name}:{i + 1}: {lines[i]}")
        # What is in a removed line must come back: something is added to a list, nothing is taken away.
        words = {word for i in changed for word in re.findall(r"\w+", lines[i])}
        wrong += [f"{name}: removed: {old}" for old in removed if not set(re.findall(r"\w+", old)) <= words]
    return wrong


def lines_of(name):
    return (ROOT / name).read_text().splitlines()


def patch_text():
    return (KIND / "rows.patch").read_text()


def new_files():
    return sorted(path.relative_to(KIND / "files").as_posix() for path in (KIND / "files").rglob("*")
                  if path.is_file() and "__pycache__" not in path.parts)


def evidence():
    """What the patch changes, and the new files with their lines."""
    for name, (lines, changed, _) in sorted(applied(patch_text(), lines_of).items()):
        for i in sorted(changed):
            yield f"{name}:{i + 1}: {lines[i].strip()}"
    for name in new_files():
        yield f"new: {name}, {len((KIND / 'files' / name).read_text().splitlines())} lines"


class Rows(unittest.TestCase):
    def test_every_line_that_changes_is_a_row_of_a_table(self):
        self.assertEqual(outside_of_tables(patch_text(), lines_of), [])
        changed = applied(patch_text(), lines_of)
        self.assertEqual(sorted(changed), sorted(TABLES))
        for name in changed:
            self.assertNotRegex(name, r"^(cli|report|render|robust)/|^io/read_model")
        print("\n" + "\n".join(evidence()))

    def test_the_new_files_lie_in_folders_of_their_own(self):
        for name in new_files():
            self.assertFalse((ROOT / name).exists(), name)
            self.assertRegex(name, rf"^({FOLDERS}|{FILES})$")

    def test_lines_outside_of_the_tables_are_noticed(self):
        def patch(name, before, line, after):
            return f"--- {name}\n+++ {name}\n@@\n {before}\n+{line}\n {after}\n"

        main = lines_of("cli/main.cc")
        formats = lines_of("io/formats.cc")
        at = formats.index("namespace veritope {")
        layers = lines_of("docs/layers.txt")
        for bad in (patch("cli/main.cc", main[3], "// ball", main[4]),
                    patch("io/formats.cc", formats[at], "int ball = 1;", formats[at + 1]),
                    patch("docs/layers.txt", layers[0], "# a ball", layers[1])):
            self.assertEqual(len(outside_of_tables(bad, lines_of)), 1, bad)
        row = next(line for line in formats if "SplineFormat::kJson>(" in line)
        taken = f"--- io/formats.cc\n+++ io/formats.cc\n@@\n-{row}\n+      ball(),\n"
        self.assertEqual(outside_of_tables(taken, lines_of), [f"io/formats.cc: removed: {row}"])

    def test_the_note_shows_the_rows_and_the_page_names_every_table(self):
        self.assertIn("```diff\n" + patch_text() + "```\n", NOTE.read_text())
        page = HOW_TO.read_text()
        section = page[page.index("## A new kind of model: the rows and folders"):]
        for name in TABLES:
            self.assertIn(f"`{name}`", section)


class Built(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        # The folders lie to each other as they do in a build of the tree, so that a compiler cache knows what did not change.
        cls.copy = BUILD / "dummy_kind"
        cls.build = cls.copy / "build"
        wanted = {path.as_posix(): (ROOT / path).read_bytes() for path in tree.files(ROOT)}
        for name, (lines, _, _) in applied(patch_text(), lines_of).items():
            wanted[name] = "".join(line + "\n" for line in lines).encode()
        wanted.update({name: (KIND / "files" / name).read_bytes() for name in new_files()})
        wanted[tree.OTHER_TREE.parent.joinpath("rows.patch").as_posix()] = patch_text().encode()
        for name in [".clang-format", "CMakePresets.json"]:
            wanted[name] = (ROOT / name).read_bytes()
        cls.copy.mkdir(parents=True, exist_ok=True)
        for old in tree.files(cls.copy):
            if old.as_posix() not in wanted:
                (cls.copy / old).unlink()
        for name, data in wanted.items():
            path = cls.copy / name
            if not path.is_file() or path.read_bytes() != data:     # what did not change is not built again
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(data)
                shutil.copymode(ROOT / name, path) if (ROOT / name).is_file() else None
        cls.run_there("cmake", "--preset", "release", "-DVERITOPE_TESTS=OFF")
        cls.run_there("cmake", "--build", "build", "--parallel", "2", "--target", "veritope", "veritope-check")
        cls.veritope = cls.build / "bin" / "veritope"
        cls.checkers = [(cls.build / "bin" / "veritope-check",),
                        (sys.executable, "-B", cls.copy / "verify" / "checker" / "veritope_check.py")]
        cls.balls = cls.copy / "tests" / "models" / "balls"
        cls.work = cls.build / "balls"
        shutil.rmtree(cls.work, ignore_errors=True)
        cls.work.mkdir()

    @classmethod
    def run_there(cls, *command, status=0, **more):
        env = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1", "VERITOPE_BIN": str(cls.build / "bin"), **more}
        done = subprocess.run([str(part) for part in command], cwd=cls.copy, env=env, capture_output=True, text=True, check=False)
        if done.returncode != status:
            raise AssertionError(f"{command}: {done.returncode}, not {status}\n{done.stdout[-4000:]}{done.stderr[-4000:]}")
        return done.stdout + done.stderr

    def certify(self, model, status, *options):
        return self.run_there(self.veritope, "certify", self.balls / model, *options, status=status)

    def obeys_schema(self, document):
        if jsonschema is not None:
            schema = json.loads((self.copy / "docs" / "report.schema.json").read_text())
            jsonschema.validate(document, schema)

    def test_a_ball_is_certified_and_both_checkers_accept(self):
        for model, claim, verdict in (("ball", "ball-1", "VALID"), ("point", "ball-invalid-1", "INVALID"),
                                      ("empty", "ball-invalid-1", "INVALID")):
            with self.subTest(model):
                certificate = self.work / (model + ".cert")
                text = self.certify(model + ".txt", int(verdict == "INVALID"), "--certificate", certificate)
                self.assertTrue(text.startswith(verdict + "  "), text)
                self.assertIn("accepted by veritope-check", " ".join(text.split()))
                self.assertIn("ball, ", text)
                for checker in self.checkers:
                    said = self.run_there(*checker, self.balls / (model + ".txt"), certificate)
                    self.assertRegex(said, rf"^ACCEPT {claim}(:|\n)")
                    damaged = self.work / "damaged.cert"
                    damaged.write_bytes(certificate.read_bytes()[:-1])
                    self.run_there(*checker, self.balls / (model + ".txt"), damaged, status=1)
                explained = self.run_there(self.veritope, "explain-certificate", certificate)
                self.assertIn(f"claim: {claim}\n", explained)
                self.assertIn(f"{claim}: the ball with the centre (1.5, -2, 0) and the radius ", explained)

    def test_the_reports_say_what_is_wrong_and_where(self):
        text = self.certify("point.txt", 1)
        self.assertIn("radius-not-positive: line 3: the radius is 0: the ball is a single point", text)
        report = json.loads(self.certify("empty.txt", 1, "--json", "-"))
        self.obeys_schema(report)
        (file,) = report["files"]
        self.assertEqual((file["verdict"], file["exit"], file["format"], file["certificate"]["checked"]), ("INVALID", 1, "ball", True))
        (defect,) = file["defects"]
        self.assertEqual(defect, {"code": "radius-not-positive", "message": "the radius is -0.75: the ball is empty", "line": 3,
                                  "byte": None, "entity": None, "point": [1.5, -2.0, 0.0], "box": None})
        report = json.loads(self.certify("ball.txt", 0, "--json", "-"))
        self.obeys_schema(report)
        self.assertEqual((report["files"][0]["verdict"], report["files"][0]["defects"]), ("VALID", []))

    def test_a_bad_file_is_refused_with_its_line(self):
        for text, why in (("ball\ncentre 0 0\nradius 1\n", "line 2: "), ("ball\ncentre 0 0 0\nradius one\n", "line 3: "),
                          ("ball\ncentre 0 0 0\nradius 1" + 18 * "0" + "\n", "more than 18 digits"),
                          ("ball\ncentre 0 0 0\nradius 1\n2\n", "goes on behind the radius")):
            bad = self.work / "bad.txt"
            bad.write_text(text)
            said = self.run_there(self.veritope, "certify", bad, status=4)
            self.assertTrue(said.startswith("UNREADABLE  "), said)
            self.assertIn(why, said)
            for checker in self.checkers:
                certificate = self.work / "other.cert"
                self.certify("ball.txt", 0, "--certificate", certificate)
                self.run_there(*checker, bad, certificate, status=1)  # S3: another model

    def test_the_other_commands_know_the_kind(self):
        said = self.run_there(self.veritope, "info", self.balls / "ball.txt")
        self.assertIn("a ball", said)
        report = json.loads(self.run_there(self.veritope, "info", "--json", "-", self.balls / "ball.txt"))
        self.obeys_schema(report)
        self.assertEqual(report["files"][0]["format"], "ball")
        for command in (("convert", self.balls / "ball.txt", self.work / "x.stl"),
                        ("certify", "--picture", self.work / "x.ply", self.balls / "ball.txt")):
            self.assertIn("ball.txt is a ball", self.run_there(self.veritope, *command, status=2))
        self.assertIn("needed is a file of splines", self.run_there(self.veritope, "cover", self.balls / "ball.txt", "-o",
                                                                    self.work / "x.vtu", status=4))
        bad = self.work / "unknown.step2"
        bad.write_text("something else\n")
        self.assertRegex(self.run_there(self.veritope, "certify", bad, status=4), r"stl, .*\bor ball\b")

    def test_lies_are_rejected_by_both_checkers_for_the_condition_that_fails(self):
        sys.path.insert(0, str(KIND / "files" / "tests" / "mutation"))
        import ball_liars
        conditions = set()
        for claim in ("ball-1", "ball-invalid-1"):
            for condition, model, lie in ball_liars.lies(claim):
                conditions.add(condition)
                (self.work / "model.txt").write_bytes(model)
                (self.work / "lie.cert").write_bytes(lie)
                for checker in self.checkers:
                    said = self.run_there(*checker, self.work / "model.txt", self.work / "lie.cert", status=1)
                    self.assertTrue(said.startswith(f"REJECT {condition}: "), f"{checker}: {claim}: {said}")
        self.assertEqual(conditions, {"B1", "P1", "P2", "P3"})

    def test_the_tests_of_the_tree_pass_with_the_new_kind(self):
        for test in ("layering_test.py", "licence_test.py", "includes_test.py", "doc_links_test.py"):
            self.run_there(sys.executable, "tests/" + test)
        self.run_there(sys.executable, "tests/claims_table_test.py", self.build / "bin")
        self.run_there(sys.executable, "tests/cli/claims_test.py")


if __name__ == "__main__":
    if sys.argv[1:] == ["--rows"]:
        print(*evidence(), sep="\n")
    else:
        unittest.main()
