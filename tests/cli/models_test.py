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
        for file in support.report(*sorted(MODELS.glob("m*")))["files"]:
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
