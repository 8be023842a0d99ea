#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Every file of tests/models: verdict, exit status, counts and volume as EXPECT.tsv says; certificates that both checkers accept."""
import contextlib
import io
import pathlib
import runpy
import subprocess
import sys
import tempfile
import unittest

import support
from support import BIN, CHECKER_PY, MODELS, ROOT, as_written, expectations, run


def options_of(row):
    return [] if row["options"] == "-" else row["options"].split()


def as_expected(row, file):
    """What the report says, in the words of EXPECT.tsv."""
    counts, volume, error = file["counts"], file["volume"], file["error"]
    said = {**{rule: as_written(count) for rule, count in file["rules"].items()},
            **{name: as_written(counts[name]) for name in ("vertices", "faces", "edges", "shells", "bodies", "genus")}}
    said.update(file=row["file"], options=row["options"], verdict=file["verdict"], exit=str(file["exit"]),
                volume="-" if volume is None else volume["exact"], error="-" if error is None else error["code"])
    return said


def readable():
    return [row for row in expectations() if row["verdict"] != "UNREADABLE"]


class Models(unittest.TestCase):
    def test_every_model_gets_the_expected_verdict_and_counts(self):
        for options in sorted({row["options"] for row in expectations()}):
            rows = [row for row in expectations() if row["options"] == options]
            files = support.report(*options_of(rows[0]), *(MODELS / row["file"] for row in rows))["files"]
            for row, file in zip(rows, files, strict=True):
                with self.subTest(row["file"], options=options):
                    self.assertEqual(as_expected(row, file), row)

    def test_one_model_alone_decides_the_exit_status(self):
        for name in ("m1_smallest.off", "m8_smallest.off", "valid_torus.off", "valid_whole_range.off", "unreadable_gzip.obj"):
            row = next(row for row in expectations() if row["file"] == name)
            done = run("certify", MODELS / name)
            self.assertEqual((done.returncode, done.stderr), (int(row["exit"]), ""))

    def test_a_rule_and_the_count_of_its_name_are_one_number(self):
        names = {"M1": "degenerate_faces", "M2": "duplicate_faces", "M3": "boundary_edges", "M4": "nonmanifold_edges",
                 "M5": "misoriented_edges", "M6": "nonmanifold_vertices", "M7": "selfint_pairs"}
        for file in support.report(*sorted(MODELS.glob("m[0-9]*")))["files"]:
            for rule, name in names.items():
                self.assertEqual(file["rules"][rule], file["counts"][name], file["path"])
            self.assertEqual(file["defects_total"], sum(count or 0 for count in file["rules"].values()))

    def test_both_checkers_accept_every_certificate(self):
        check_in_python = runpy.run_path(str(CHECKER_PY))["main"]
        with tempfile.TemporaryDirectory() as folder:
            for options in sorted({row["options"] for row in readable()}):
                rows = [row for row in readable() if row["options"] == options]
                run("certify", *options_of(rows[0]), *(MODELS / row["file"] for row in rows), "--certificate", f"{folder}/{options}/")
                for row in rows:
                    pair = [str(MODELS / row["file"]), f"{folder}/{options}/{row['file']}.cert"]
                    claim = f"ACCEPT mesh-{row['verdict'].lower()}-1"
                    with self.subTest(row["file"], options=options):
                        done = run(*pair, program=BIN / "veritope-check")
                        self.assertEqual((done.returncode, done.stdout[:len(claim)]), (0, claim), done.stdout + done.stderr)
                        said = io.StringIO()
                        with contextlib.redirect_stdout(said):
                            status = check_in_python(["veritope_check.py", *pair])
                        self.assertEqual((status, said.getvalue()[:len(claim)]), (0, claim), said.getvalue())

    def test_orient_auto_makes_valid_what_only_faces_the_wrong_way_and_nothing_else(self):
        rows = [row for row in readable() if row["options"] == "-"]
        models = [MODELS / row["file"] for row in rows]
        as_is, reversed_ = (support.report("--orient", how, *models)["files"] for how in ("keep", "auto"))
        helped = 0
        for row, before, after in zip(rows, as_is, reversed_, strict=True):
            with self.subTest(row["file"]):
                broken = {rule for rule, count in before["rules"].items() if count}
                helps = bool(broken) and broken <= {"M5", "M8", "M9"}
                self.assertEqual(before["valid_once_reversed"], helps)
                self.assertIsNone(before["reversed"])
                if not helps:
                    self.assertEqual({**after, "seconds": None}, {**before, "seconds": None})
                    continue
                helped += 1
                self.assertEqual((after["verdict"], after["certificate"]["checked"], after["exit"]), ("VALID", True, 0))
                self.assertEqual({rule for rule, count in after["rules"].items() if count}, set())
                faces = [shell["reversed_faces"] for shell in after["shells"]]
                self.assertEqual((sum(faces), after["valid_once_reversed"]), (after["reversed"]["faces"], False))
                self.assertEqual(sum(map(bool, faces)), after["reversed"]["whole_shells"] + after["reversed"]["mixed_shells"])
                wrong = before["rules"]["M8"], before["rules"]["M9"]
                if "M5" not in broken:
                    self.assertEqual((after["reversed"]["whole_shells"], after["reversed"]["mixed_shells"]), (sum(wrong), 0))
        self.assertGreaterEqual(helped, 5)

    def test_reports_say_where_orient_auto_helps_and_what_it_reversed(self):
        text = run("certify", MODELS / "m9_inside_out.off").stdout
        self.assertIn("veritope certify --orient auto FILE", text)
        self.assertNotIn("--orient", run("certify", MODELS / "m5_one_sided.off").stdout)
        text = run("certify", "--orient", "auto", MODELS / "m9_inside_out.off").stdout
        self.assertIn(", once 2 shells are reversed (checked)", text)
        self.assertIn("2 shells of 2 were inside out; 8 faces are taken reversed", text)
        self.assertIn("shell 1      inward, depth 1, genus 0, volume -0.166667, taken reversed", text)
        text = run("certify", "--orient", "auto", MODELS / "m5_smallest.off").stdout
        self.assertIn(", once 1 face is reversed (checked)", text)
        self.assertIn("faces of 1 shell disagreed; 1 face is taken reversed", text)
        for rule in ("M5", "M8", "M9"):
            self.assertIn("veritope certify --orient auto", " ".join(run("explain", rule).stdout.split()))

    def test_reports_and_certificates_do_not_depend_on_the_number_of_jobs(self):
        models = [MODELS / row["file"] for row in readable() if row["options"] == "-"]
        with tempfile.TemporaryDirectory() as folder:
            seen = []
            for jobs in (1, 2, 5):
                place = pathlib.Path(folder) / str(jobs)
                files = support.report("--jobs", jobs, "--certificate", place, *models)["files"]
                for file in files:
                    file["seconds"] = None
                    file["certificate"]["path"] = None
                seen.append((files, [(path.name, path.read_bytes()) for path in sorted(place.iterdir())]))
        self.assertEqual(len(seen[0][1]), len(models))
        self.assertTrue(seen[0] == seen[1] == seen[2])

    def test_the_generator_writes_the_committed_bytes(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, ROOT / "tools" / "make_models.py", folder], check=True)
            made = {path.name: path.read_bytes() for path in pathlib.Path(folder).iterdir()}
        committed = {path.name: path.read_bytes() for path in MODELS.iterdir() if path.is_file()}
        self.assertEqual(sorted(made), sorted(committed))
        for name, data in made.items():
            self.assertTrue(data == committed[name], f"tests/models/{name} differs from what tools/make_models.py writes")

    def test_every_rule_has_a_smallest_and_a_nearest_valid_model(self):
        rows = {row["file"].split(".")[0]: row for row in expectations()}
        for i in range(1, 10):
            smallest, nearest = rows[f"m{i}_smallest"], rows[f"m{i}_nearest_valid"]
            self.assertNotIn(smallest[f"M{i}"], ("0", "-"))
            self.assertEqual(nearest["verdict"], "VALID")


if __name__ == "__main__":
    support.main()
