#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Microstructures on the command line: info, convert and certify of files .vmicro, and the schema of the format."""
import copy
import json
import pathlib
import sys
import tempfile
import unittest

import schema
from support import MODELS, ROOT, run

sys.path.insert(0, str(ROOT / "tests" / "support"))
import micro_models  # noqa: E402

MICRO = MODELS / "micro"
SOUND = MICRO / "three_cells.vmicro"


class Micro(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def files(self, done):
        document = json.loads(done.stdout)
        self.assertEqual(schema.faults(document), [])
        return document["files"]

    def test_the_models_are_as_the_script_writes_them(self):
        self.assertEqual({path.name: path.read_text() for path in MICRO.iterdir()}, micro_models.MODELS)

    def test_info_counts(self):
        done = run("info", SOUND)
        self.assertEqual(done.returncode, 0, done)
        for line in ("  model        a microstructure\n", "  cage         1 volume, 1 grid, 3 cells\n", "  tiles        3 tiles, 2 different\n",
                     "  range        numbers of walls from 0/2^20 to 1048576/2^20\n"):
            self.assertIn(line, done.stdout)
        (file,) = self.files(run("info", SOUND, "--json", "-"))
        self.assertEqual(file["counts"], {"volumes": 1, "grids": 1, "cells": 3, "tiles": 3, "different_tiles": 2, "bridges": 0})
        self.assertEqual((file["format"], file["range"], file["exit"]), ("vmicro", [0, 2**20], 0))

    def test_certify_decides(self):
        done = run("certify", SOUND, "--json", "-")
        self.assertEqual(done.returncode, 0, done)
        (file,) = self.files(done)
        self.assertEqual((file["verdict"], file["format"], file["certificate"]["checked"]), ("VALID", "vmicro", True))
        # Two posts, joined at their common wall or not, and a cube.
        self.assertEqual([file["counts"][key] for key in ("volumes", "kinds", "cells", "tiles", "glued_caps", "components", "shells", "genus")],
                         [1, 2, 3, 3, 1, 2, 2, 0])

    def test_a_file_that_breaks_a_rule_is_refused_with_its_line(self):
        bad = MICRO / "two_tiles_in_a_cell.vmicro"
        for command in (["certify"], ["info"]):
            done = run(*command, bad)
            self.assertEqual(done.returncode, 4, done)
            self.assertIn("line 29: grid 0: cell 1 holds the tiles 0 and 1\n", done.stdout)
        done = run("convert", bad, self.folder / "out.vmicro")
        self.assertEqual((done.returncode, list(self.folder.iterdir())), (4, []), done)
        self.assertIn("line 29: grid 0: cell 1 holds the tiles 0 and 1", done.stderr)

    def test_convert_writes_the_canonical_form(self):
        text = SOUND.read_text()
        other = self.folder / "other"
        other.write_text(text.replace('"1/4"', '"0.25"').replace("[1,1]", "[ 1, 1 ]").replace(",\n\"grids\"", ", \"grids\""))
        done = run("convert", other, self.folder / "out.vmicro")
        self.assertEqual((done.returncode, done.stdout.split("  ")[2]), (0, "1 grid, nothing lost\n"), done)
        self.assertEqual((self.folder / "out.vmicro").read_text(), text)
        self.assertEqual(run("convert", SOUND, "-", "--to", "vmicro").stdout, text)
        other.write_text(text.replace('"attributes": []', '"attributes": ["a"]'))
        done = run("convert", other, self.folder / "out.vmicro")
        self.assertIn("dropped: groups and attributes of the cage\n", done.stdout)
        self.assertEqual((self.folder / "out.vmicro").read_text(), text)

    def test_convert_refuses_what_is_for_other_kinds(self):
        out = self.folder / "out.vmicro"
        for arguments, why in ((["--to", "stl", out], "for a microstructure, --to must be vmicro, not stl"),
                               ([self.folder / "out.stl"], "does not end in vmicro, the formats for a microstructure"),
                               (["--chord", "1", out], "--chord is for splines"), (["--faces", out], "--faces is for splines"),
                               (["--rejoin", out], "--rejoin is for splines"), (["--weld", "1", out], "--weld is for spline volumes"),
                               (["--float", out], "--float is for binary PLY"), (["--pn", out], "--pn is for meshes"),
                               ([SOUND], "")):
            done = run("convert", SOUND, *arguments)
            self.assertEqual(done.returncode, 2, done)
            self.assertIn(why, " ".join(done.stderr.split()))
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_commands_about_surfaces_say_that_it_is_a_microstructure(self):
        for command, status, why in ((["classify", SOUND, SOUND, "--winding"], 4, "this is a microstructure; needed is a mesh or a file of splines"),
                                     (["inspect", SOUND], 3, "it is a microstructure"), (["project", "0,0,0", SOUND], 4, "this is a microstructure"),
                                     (["intersect", SOUND, SOUND], 4, "this is a microstructure"),
                                     (["certify", SOUND, "--picture", self.folder / "a.png"], 2, "is a microstructure")):
            done = run(*command)
            self.assertEqual(done.returncode, status, done)
            self.assertIn(why, " ".join((done.stdout + done.stderr).split()))

    @unittest.skipIf(schema.jsonschema is None, "python3-jsonschema is not installed")
    def test_files_obey_the_schema_and_the_schema_is_tight(self):
        micro_schema = json.loads((ROOT / "docs" / "formats" / "micro.schema.json").read_text())
        spline_schema = json.loads((ROOT / "docs" / "formats" / "spline.schema.json").read_text())
        validator = schema.jsonschema.Draft202012Validator(micro_schema)
        validator.check_schema(micro_schema)
        self.assertEqual(micro_schema["$defs"]["number"], spline_schema["$defs"]["number"])
        document = json.loads(SOUND.read_text())
        self.assertEqual([], [e.message for e in validator.iter_errors(document)])
        self.assertTrue(schema.jsonschema.Draft202012Validator(spline_schema).is_valid(document["cage"]))
        for place, value in ((["format"], "veritope-micro-2"), (["extra"], 0), (["model"], {}), (["model", "sha256"], "0"),
                             (["cage", "entities", 0, "kind"], "curve"), (["cage", "entities"], []), (["grids", 0, "volume"], -1),
                             (["grids", 0, "breaks", 0], ["0"]), (["grids", 0, "breaks", 0], [0, 1]), (["tiles"], []),
                             (["tiles", 0, "range"], [0, 2**20 + 1]), (["tiles", 0, "range"], [0]), (["tiles", 0, "patches"], []),
                             (["tiles", 0, "patches", 0, "wall"], 6), (["tiles", 0, "patches", 0, "degrees"], [1, 8]),
                             (["tiles", 0, "patches", 0, "points"], []), (["tiles", 0, "patches", 0, "points", 0, 0], ["0", "0"]),
                             (["cells", 0, 0], "C"), (["cells", 0], []), (["walls", 0], [[0, 0]]), (["walls", 0, 0, 0], -1)):
            broken = copy.deepcopy(document)
            part = broken
            for key in place[:-1]:
                part = part[key]
            part[place[-1]] = value
            self.assertFalse(validator.is_valid(broken), place)


if __name__ == "__main__":
    unittest.main()
