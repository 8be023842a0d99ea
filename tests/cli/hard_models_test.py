#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope corpus --meshes and --patches: each model gets the verdict of its index, which a second opinion confirms for
meshes (tools/mesh_oracle.py); both checkers accept the certificates; folders appear complete or not at all.
HARD_MODELS_ALL=1: without it the Python checker is spared the long certificates and the images of meshes."""
import collections
import contextlib
import csv
import hashlib
import io
import json
import os
import pathlib
import resource
import runpy
import signal
import subprocess
import sys
import tempfile
import unittest

from support import BIN, CHECKER_PY, ROOT, Folder, main, run

sys.path.insert(0, str(ROOT / "tools"))
from mesh_oracle import Oracle  # noqa: E402

SHA256 = ROOT / "tests" / "cli" / "hard_models.sha256"
HEAD = ["file", "verdict", "exit", "codes", "bodies", "genus", "what"]
ALL = "HARD_MODELS_ALL" in os.environ
LONG = 12000  # bytes of a certificate that the Python checker takes seconds for
PARTS = ("_huge", "_tiny", "_oblique", "_shuffled")


def index_of(folder):
    with open(folder / "index.tsv", newline="") as file:
        reader = csv.DictReader(file, delimiter="\t", quoting=csv.QUOTE_NONE)
        rows = list(reader)
    assert reader.fieldnames == HEAD
    return rows


def read_off(path):
    words = path.read_text().split()
    assert words[0] == "OFF"
    vertices, faces = int(words[1]), int(words[2])
    numbers, rest = [float(word) for word in words[4:4 + 3 * vertices]], [int(word) for word in words[4 + 3 * vertices:]]
    assert rest[::4] == [3] * faces and len(rest) == 4 * faces
    return [tuple(numbers[3 * i:3 * i + 3]) for i in range(vertices)], [tuple(rest[4 * i + 1:4 * i + 4]) for i in range(faces)]


def digest(folder):
    all_bytes = hashlib.sha256()
    for path in sorted(folder.iterdir()):
        all_bytes.update(path.name.encode() + b"\0" + path.read_bytes() + b"\0")
    return all_bytes.hexdigest()


class Written(unittest.TestCase):
    """A folder of the corpus, and what certify says of its models."""
    OPTION = ""

    @classmethod
    def setUpClass(cls):
        if not cls.OPTION:
            raise unittest.SkipTest("the base of the others")
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.models, cls.certificates = cls.folder / "models", cls.folder / "certificates"
        cls.written = run("corpus", cls.OPTION, cls.models)
        cls.index = index_of(cls.models)
        paths = [cls.models / row["file"] for row in cls.index]
        cls.certified = run("certify", "--json", "-", "--certificate", cls.certificates, *paths, timeout=600)
        cls.reports = json.loads(cls.certified.stdout)["files"]

    def check_folder(self, least):
        valid = sum(row["verdict"] == "VALID" for row in self.index)
        self.assertEqual((self.written.returncode, self.written.stderr), (0, ""))
        self.assertEqual(self.written.stdout, f"wrote  {self.models}  {len(self.index)} models: {valid} valid, {len(self.index) - valid} "
                         "invalid; index.tsv says which\n")
        self.assertEqual(sorted(path.name for path in self.models.iterdir()), sorted([row["file"] for row in self.index] + ["index.tsv"]))
        self.assertGreater(min(valid, len(self.index) - valid), least)
        umask = os.umask(0)
        os.umask(umask)
        self.assertEqual(self.models.stat().st_mode & 0o777, 0o777 & ~umask)

    def check_bytes(self, name):
        expected = dict(reversed(line.split("  ")) for line in SHA256.read_text().splitlines())
        self.assertEqual(digest(self.models), expected[name])

    def check_certificates(self):
        check_in_python = runpy.run_path(str(CHECKER_PY))["main"]
        for row in self.index:
            pair = [str(self.models / row["file"]), str(self.certificates / (row["file"] + ".cert"))]
            if row["exit"] == "3":
                with self.subTest(row["file"]):
                    self.assertFalse(pathlib.Path(pair[1]).exists())
                continue
            with self.subTest(row["file"]):
                done = run(*pair, program=BIN / "veritope-check")
                self.assertEqual((done.returncode, done.stdout[:7]), (0, "ACCEPT "), done.stdout + done.stderr)
                is_image = pathlib.PurePath(row["file"]).stem.endswith(PARTS)
                if not ALL and (is_image or os.path.getsize(pair[1]) > LONG):
                    continue
                said = io.StringIO()
                with contextlib.redirect_stdout(said):
                    status = check_in_python(["veritope_check.py", *pair])
                self.assertEqual((status, said.getvalue().split(":")[0].split()[:2]), (0, done.stdout.split(":")[0].split()[:2]))

    def check_verdicts(self, codes_of):
        for row, report in zip(self.index, self.reports, strict=True):
            with self.subTest(row["file"]):
                verdict = "UNDECIDED" if row["exit"] == "3" else row["verdict"]
                self.assertEqual((report["verdict"], str(report["exit"])), (verdict, row["exit"]))
                self.assertEqual(codes_of(report) or "-", row["codes"])
                if verdict == "VALID":
                    genus = report["counts"].get("genus", sum(shell["genus"] for shell in report["shells"]))
                    self.assertEqual((str(report["counts"]["bodies"]), str(genus)), (row["bodies"], row["genus"]))
                if row["verdict"] == "INVALID":
                    self.assertEqual((row["bodies"], row["genus"]), ("-", "-"))


class Meshes(Written):
    OPTION = "--meshes"

    def test_the_folder_holds_the_models_of_its_index(self):
        self.check_folder(100)

    def test_the_bytes_are_as_published(self):
        self.check_bytes("--meshes")

    def test_certify_answers_what_the_index_says(self):
        self.check_verdicts(lambda report: " ".join(f"{rule}:{count}" for rule, count in report["rules"].items() if count))

    def test_both_checkers_accept_the_certificates(self):
        self.check_certificates()

    def test_vertices_are_distinct_so_that_merging_them_changes_nothing(self):
        for row in self.index:
            vertices, _ = read_off(self.models / row["file"])
            self.assertEqual(len(set(vertices)), len(vertices), row["file"])

    def test_fractions_agree_with_the_index(self):
        for row in self.index:
            vertices, faces = read_off(self.models / row["file"])
            if len(faces) > (40 if ALL else 30) and pathlib.PurePath(row["file"]).stem.endswith(PARTS):
                continue  # all pairs of faces: a second each
            oracle = Oracle(vertices, faces)
            with self.subTest(row["file"]):
                self.assertEqual(" ".join(f"{rule}:{count}" for rule, count in oracle.rules.items() if count) or "-", row["codes"])
                self.assertEqual(oracle.is_valid(), row["verdict"] == "VALID")
                if oracle.is_valid():
                    self.assertEqual((str(oracle.bodies), str(oracle.genus)), (row["bodies"], row["genus"]))

    def test_every_rule_is_broken_alone_or_in_its_smallest_model_and_every_contact_has_its_neighbours(self):
        broken = collections.Counter(code.split(":")[0] for row in self.index for code in row["codes"].split() if code != "-")
        self.assertEqual(sorted(broken), [f"M{i}" for i in range(1, 10)])
        names = {row["file"]: row["verdict"] for row in self.index}
        for name, verdict in names.items():
            stem = name.removesuffix(".off")
            if stem.endswith("_nearest_valid"):
                self.assertEqual((verdict, names[stem.removesuffix("_nearest_valid") + ".off"]), ("VALID", "INVALID"))
            if stem.endswith("_touching") and stem.removesuffix("_touching") + "_apart.off" in names:
                self.assertEqual((verdict, names[stem.removesuffix("_touching") + "_apart.off"]), ("INVALID", "VALID"))

    def test_the_seed_changes_the_shuffled_models_only(self):
        other = self.folder / "other"
        run("corpus", "--meshes", other, "--seed", 7)
        changed = {path.name for path in other.iterdir() if path.read_bytes() != (self.models / path.name).read_bytes()}
        shuffled = {row["file"] for row in self.index if "_shuffled" in row["file"]}
        self.assertLessEqual(changed, shuffled)
        self.assertGreater(len(changed), 0.9 * len(shuffled))


class Patches(Written):
    OPTION = "--patches"

    def test_the_folder_holds_the_models_of_its_index(self):
        self.check_folder(40)

    def test_the_bytes_are_as_published(self):
        self.check_bytes("--patches")

    def test_certify_answers_what_the_index_says_and_never_the_opposite_of_the_truth(self):
        self.check_verdicts(lambda report: report["error"]["code"] if report["error"] else
                            " ".join(sorted({defect["code"] for defect in report["defects"]})))

    def test_both_checkers_accept_the_certificates(self):
        self.check_certificates()


class Only(Folder):
    def lines(self, *arguments):
        done = run("corpus", *arguments)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout.splitlines()

    def test_only_the_predicates_that_are_named_are_printed_and_counted(self):
        head, _, *cases = self.lines("--only", "orient3d,in_circle", "--cases", "500")
        self.assertEqual(head, "# veritope corpus --cases 500 --seed 1 --only orient3d,in_circle")
        self.assertEqual(collections.Counter(line.split()[0] for line in cases), {"orient3d": 250, "in_circle": 250})
        self.assertGreater(len(set(cases)), 400)
        done = run("predicate", "any", "--expect", "-", input="\n".join(cases))
        self.assertEqual((done.returncode, done.stdout), (0, "500 cases, 0 disagreements\n"))

    def test_order_and_repetition_of_names_do_not_matter(self):
        self.assertEqual(self.lines("--only", "in_circle,orient3d,in_circle", "--cases", 99), self.lines("--only", "orient3d,in_circle", "--cases", 99))

    def test_selftest_has_the_option_too(self):
        done = run("selftest", "--verbose", "--only", "orient2d", "--cases", 200)
        self.assertEqual(done.returncode, 0)
        self.assertIn("200 cases, 0 disagreements; seed 1\n", done.stdout)
        self.assertRegex(done.stdout, r"(?m)^orient2d  +200 cases, ")
        self.assertNotIn("orient3d", done.stdout)

    def test_other_names_are_refused_with_the_one_that_was_meant(self):
        for text, words in (("orient3", "not orient3; did you mean orient3d?"), ("orient3d,", "not an empty name"),
                            ("orient2d, orient3d", "not  orient3d"), (",", "not an empty name")):
            done = run("corpus", "--only", text)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn("--only: must be names of predicates with commas between them, " + words, done.stderr)


class Folders(Folder):
    def assert_refused(self, path, status, words, **how):
        done = run("corpus", "--meshes", path, **how)
        self.assertEqual((done.returncode, done.stdout), (status, ""))
        self.assertIn(words, done.stderr)
        self.assertEqual([path.name for path in self.folder.iterdir() if path.name.startswith(".veritope")], [])

    def test_a_folder_that_is_not_empty_and_a_file_are_left_alone(self):
        full, file = self.folder / "full", self.folder / "file"
        full.mkdir()
        (full / "mine").write_text("1")
        file.write_text("2")
        self.assert_refused(full, 2, "full: the folder is not empty: name a new one")
        self.assert_refused(file, 2, "file: it exists and is not a folder")
        self.assertEqual([path.name for path in full.iterdir()], ["mine"])
        self.assertEqual(file.read_text(), "2")

    def test_a_folder_without_a_parent_or_a_name_and_a_link_to_nowhere_are_refused(self):
        (self.folder / "link").symlink_to(self.folder / "none")
        self.assert_refused(self.folder / "none" / "new", 4, "cannot be written: No such file or directory")
        self.assert_refused("", 2, "--meshes")
        self.assert_refused(self.folder / "link", 2, "link: it is a link to nowhere")

    def test_the_current_folder_is_not_replaced(self):
        done = run("corpus", "--meshes", ".", cwd=self.folder)
        self.assertEqual((done.returncode, done.stderr), (2, "veritope: .: it is the current folder: name a new one\n"))
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_an_empty_folder_is_filled_and_keeps_its_permissions(self):
        empty = self.folder / "empty"
        empty.mkdir()
        empty.chmod(0o750)
        (self.folder / "link").symlink_to("empty")
        self.assertEqual(run("corpus", "--meshes", f"{self.folder}/link/").returncode, 0)
        self.assertTrue((empty / "index.tsv").is_file() and (self.folder / "link").is_symlink())
        self.assertEqual(empty.stat().st_mode & 0o777, 0o750)

    def test_a_folder_that_cannot_be_completed_is_not_there(self):
        def little_space():
            resource.setrlimit(resource.RLIMIT_FSIZE, (4000, 4000))
        self.assert_refused(self.folder / "new", 4, "cannot be written", preexec_fn=little_space)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_an_interrupted_run_leaves_the_whole_folder_or_nothing(self):
        for number in range(6):
            path = self.folder / f"new{number}"
            process = subprocess.Popen([BIN / "veritope", "corpus", "--meshes", path], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            with contextlib.suppress(subprocess.TimeoutExpired):
                process.wait(0.02 * number)
            process.send_signal(signal.SIGINT)
            process.wait(120)
            self.assertEqual([other for other in self.folder.iterdir() if other.name.startswith(".veritope")], [])
            if path.exists():
                self.assertEqual(len(list(path.iterdir())), len(index_of(path)) + 1)

    def test_two_outputs_in_one_folder_and_options_of_cases_are_wrong_usage(self):
        for path in ("new", "new/"):
            done = run("corpus", "--meshes", "new", "--patches", path, cwd=self.folder)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn("--meshes and --patches name the same folder", done.stderr)
        for option in (("--cases", "5"), ("--only", "orient2d")):
            done = run("corpus", "--patches", self.folder / "new", *option)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn("excludes", done.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    main()
