#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope info and convert on spline files: what they say, what they refuse, and that JSON documents obey their schemas."""
import base64
import json
import struct
import unittest
import xml.etree.ElementTree

import schema
import support
from support import MODELS, ROOT, Folder, run

SPLINES = MODELS / "splines"
SAMPLES = sorted(SPLINES.iterdir())
TRIANGLES = SPLINES / "triangles.vjson"


def info(*paths):
    done = run("info", "--json", "-", *paths)
    return json.loads(done.stdout)["files"]


class Info(Folder):
    def test_entities_are_described(self):
        file = info(SPLINES / "groups.itd")[0]
        self.assertEqual(list(file), schema.keys_of("info_spline_file"))
        self.assertEqual(file["counts"], {"entities": 5, "curves": 3, "surfaces": 1, "volumes": 1, "trimmed": 0, "models": 0, "triangles": 0})
        self.assertEqual([e["kind"] for e in file["entities"]], ["curve", "surface", "curve", "curve", "volume"])
        for entity in file["entities"]:
            self.assertEqual(list(entity), schema.keys_of("spline_entity"))
        arc, closed = file["entities"][0], file["entities"][2]
        self.assertEqual((arc["name"], arc["rational"], arc["dimension"], arc["line"]), ("ARC", True, 2, 4))
        self.assertEqual(arc["bbox"]["min"], [0.5, 0])
        self.assertTrue(2 / 3 <= arc["bbox"]["max"][1] <= 2 / 3 + 1e-15)  # 0.5 / 0.75, rounded up
        self.assertEqual(closed["axes"], [{"degree": 2, "control_points": 6, "spans": 4, "periodic": True, "domain": ["2/1", "6/1"]}])
        self.assertIn({"what": "polygons", "reason": "", "geometry": True, "count": 1}, file["left_out"])
        self.assertEqual(file["lossless"], ["itd", "vjson"])

    def test_triangles_are_described(self):
        file = info(TRIANGLES)[0]
        self.assertEqual((file["counts"]["entities"], file["counts"]["triangles"], file["counts"]["surfaces"]), (4, 4, 0))
        entities = [(e["kind"], e["name"], e["degree"], e["rational"], e["dimension"], e["axes"]) for e in file["entities"]]
        self.assertEqual(entities, [("triangle", "FLAT", 1, False, 3, None), ("triangle", "BENT", 3, False, 3, None),
                                    ("triangle", "BENT", 2, True, 3, None), ("triangle", "", 1, False, 2, None)])
        self.assertEqual(file["entities"][2]["bbox"], {"min": [0, 0, 0], "max": [1, 1, 1]})  # divided by the weights
        self.assertEqual(file["lossless"], ["vjson"])
        self.assertIn("4 Bezier triangles", run("info", TRIANGLES).stdout)
        self.assertIn("triangle, BENT, degree 2, 6 control points, rational, dimension 3", run("info", TRIANGLES).stdout)

    def test_text_names_every_entity(self):
        done = run("info", *SAMPLES)
        self.assertEqual(done.returncode, 0, done.stderr)
        for word in ("groups.itd", "CLOSED, degree 2, 6 control points, periodic", "1 loop", "left out", "model, BODY"):
            self.assertIn(word, done.stdout)

    def test_a_bad_file_is_status_4_with_line_and_entity(self):
        bad = self.folder / "bad.itd"
        bad.write_text("[CURVE BEZIER 2 E1 [0] [1]]\n[CURVE BSPLINE 2 2 E1\n [KV 0 1 0 1] [0] [1]]\n")
        done = run("info", bad)
        self.assertEqual(done.returncode, 4)
        self.assertRegex(done.stdout, r"^UNREADABLE  \S+  line 2: entity 1: knot 2, 0, is less than the one before it, 1\n$")
        error = info(bad)[0]["error"]
        self.assertEqual((error["code"], error["line"], error["entity"]), ("bad-spline", 2, 1))
        self.assertEqual(run("convert", bad, self.folder / "x.vjson").returncode, 4)
        self.assertEqual(self.listing(), ["bad.itd"])

    def test_format_is_found_by_option_and_content(self):
        text = (SPLINES / "objects.g2").read_text()
        done = run("info", "--format", "g2", "--json", "-", "-", input=text)
        self.assertEqual(json.loads(done.stdout)["files"][0]["counts"]["trimmed"], 1)
        plain = self.folder / "plain"
        plain.write_text(text)
        self.assertEqual(info(plain)[0]["spline_format"], "g2")
        self.assertEqual(run("info", "--format", "step", plain).returncode, 2)
        self.assertEqual(run("certify", "--format", "g2", plain).returncode, 3)  # certificates do not speak of .g2
        self.assertEqual(run("certify", "--format", "step", plain).returncode, 2)
        self.assertEqual(run("info", "--max-digits", "1", SPLINES / "groups.itd").returncode, 4)


class Ignored(Folder):
    """intersect and project look at curves and surfaces, and say what else there was."""

    def setUp(self):
        super().setUp()
        document = json.loads(TRIANGLES.read_text())
        flat = {"degrees": [1, 1], "periodic": [False, False], "knots": [["0", "0", "1", "1"]] * 2, "rational": False, "components": 3,
                "points": [["0", "0", "0"], ["0", "1", "0"], ["1", "0", "0"], ["1", "1", "0"]]}
        document["entities"] = document["entities"][:2] + [{"kind": "surface", "group": None, "attributes": [], "shape": flat}]
        self.mixed = self.folder / "mixed.vjson"
        self.mixed.write_text(json.dumps(document))

    def test_intersect_counts_the_triangles_of_both_files(self):
        done = run("intersect", self.mixed, self.mixed)
        self.assertIn("Not looked at: 4 Bezier triangles.", done.stdout)
        report = json.loads(run("intersect", "--json", "-", self.mixed, self.mixed).stdout)
        self.assertEqual((report["triangles_ignored"], report["pairs_of_surfaces"]), (4, 1))
        done = run("intersect", TRIANGLES, self.mixed)
        self.assertEqual(done.returncode, 4)
        self.assertIn("there is no surface in it", done.stderr)

    def test_project_counts_the_triangles(self):
        done = run("project", "1/2,1/2,1", self.mixed)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("Not looked at: 2 Bezier triangles.", done.stdout)
        report = json.loads(run("project", "--json", "-", "1/2,1/2,1", self.mixed).stdout)
        self.assertEqual((report["skipped_triangles"], report["skipped_volumes"], len(report["targets"])), (2, 0, 1))
        self.assertEqual(run("project", "0,0,0", TRIANGLES).returncode, 4)


class Convert(Folder):
    def test_json_is_canonical_and_comes_back_the_same_from_itd(self):
        for sample in SAMPLES:
            if sample == TRIANGLES:  # .itd has none
                continue
            first, itd, second = self.folder / "1.vjson", self.folder / "2.itd", self.folder / "3.vjson"
            for source, target in [(sample, first), (first, itd), (itd, second)]:
                done = run("convert", "--lossy", source, target)
                self.assertEqual(done.returncode, 0, done.stderr)
            # The remark about curves that were left out is no part of the model.
            strip = lambda text: "".join(line.split('"omitted"')[0] for line in text.splitlines(True))
            self.assertEqual(strip(first.read_text()), strip(second.read_text()), sample)
            self.assertEqual(run("convert", first, "--to", "vjson", "-").stdout, first.read_text())

    @unittest.skipIf(schema.jsonschema is None, "python3-jsonschema is not installed")
    def test_json_obeys_its_schema_and_the_schema_is_tight(self):
        spline_schema = json.loads((ROOT / "docs" / "formats" / "spline.schema.json").read_text())
        validator = schema.jsonschema.Draft202012Validator(spline_schema)
        validator.check_schema(spline_schema)
        for sample in SAMPLES:
            document = json.loads(run("convert", "--lossy", sample, "--to", "vjson", "-").stdout)
            self.assertEqual([], [e.message for e in validator.iter_errors(document)], sample)
            for entity in document["entities"]:
                for spoil in ({"kind": "sphere"}, {"extra": 1}, {"shape": {}}):
                    broken = {**document, "entities": [{**entity, **spoil}]}
                    self.assertFalse(validator.is_valid(broken), spoil)
        for number in ("1", "-1/3", "0.5", ".5", "1e-3", "0x1.8p-3"):
            self.assertRegex(number, spline_schema["$defs"]["number"]["pattern"])
        for number in ("", "1/0", "nan", "1/-2", "e5", "0x"):
            self.assertNotRegex(number, spline_schema["$defs"]["number"]["pattern"])

    def test_losses_are_refused_unless_allowed(self):
        out = self.folder / "out.g2"
        done = run("convert", SPLINES / "trimmed.itd", out)
        self.assertEqual(done.returncode, 1)
        self.assertIn("it would lose something", done.stderr)
        self.assertFalse(out.exists())
        done = run("convert", "--lossy", SPLINES / "trimmed.itd", out)
        self.assertEqual((done.returncode, out.exists()), (0, True))
        self.assertIn("lossy: 1 of 2 entities", done.stdout)
        third = self.folder / "third.vjson"
        run("convert", "--lossy", SPLINES / "groups.itd", third)
        third.write_text(third.read_text().replace('"1/4"', '"1/3"'))
        self.assertEqual(run("convert", third, self.folder / "third.itd").returncode, 1)
        # Triangles: nothing is left of this file, of the next one a surface.
        for target in ("x.itd", "x.g2"):
            self.assertEqual(run("convert", "--lossy", TRIANGLES, self.folder / target).returncode, 4)
        mixed, document = self.folder / "mixed.vjson", json.loads(TRIANGLES.read_text())
        surface = json.loads(run("convert", "--lossy", SPLINES / "surface.xml", "--to", "vjson", "-").stdout)["entities"][0]
        document["entities"].append({**surface, "group": None})
        mixed.write_text(json.dumps(document))
        done = run("convert", mixed, self.folder / "mixed.itd")
        self.assertEqual(done.returncode, 1)
        self.assertIn("4 of 5 entities are rounded or left out", done.stderr)
        self.assertEqual(run("convert", "--lossy", mixed, self.folder / "mixed.itd").returncode, 0)
        self.assertEqual(info(self.folder / "mixed.itd")[0]["counts"]["surfaces"], 1)
        # Polygons are geometry of the file that the model lacks.
        self.assertEqual(run("convert", SPLINES / "groups.itd", self.folder / "x.vjson").returncode, 1)

    def test_nothing_is_no_file(self):
        empty = self.folder / "empty.itd"
        empty.write_text("[OBJECT A [NUMBER 1]]\n")
        for target in ("a.itd", "a.g2", "a.obj"):
            done = run("convert", "--lossy", empty, self.folder / target)
            self.assertEqual(done.returncode, 4, target)
            self.assertIn("not written", done.stderr)
        done = run("convert", empty, self.folder / "a.vjson")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("dropped: 1 numbers, 1 groups without splines", done.stdout)
        self.assertEqual(self.listing(), ["a.vjson", "empty.itd"])
        self.assertEqual(info(self.folder / "a.vjson")[0]["lossless"], ["vjson"])
        # A model of faces is all that there is, and .g2 has none.
        text = (SPLINES / "trimmed.itd").read_text()
        model = self.folder / "model.itd"
        model.write_text(text[text.index("[MODEL"):text.rindex("]")])
        done = run("convert", "--lossy", model, self.folder / "model.g2")
        self.assertEqual((done.returncode, (self.folder / "model.g2").exists()), (4, False), done.stderr)

    def test_what_would_not_be_read_back_is_not_written(self):
        source = self.folder / "power.itd"
        source.write_text("[CURVE POWER 3 E1 [1e4096] [1e-4096] [1]]\n")
        done = run("convert", source, self.folder / "p.vjson")  # numbers of 8192 digits
        self.assertEqual(done.returncode, 4)
        self.assertIn("would not be read back", done.stderr)
        self.assertIn("--max-digits", done.stderr)
        done = run("convert", "--max-digits", "9000", source, self.folder / "p.vjson")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(run("info", self.folder / "p.vjson").returncode, 4)
        self.assertEqual(run("info", "--max-digits", "9000", self.folder / "p.vjson").returncode, 0)

    def test_wrong_usage_is_status_2(self):
        sample = SPLINES / "groups.itd"
        for arguments in ([sample, self.folder / "x.stl"], [sample, self.folder / "x"], [sample, "--to", "mfem", self.folder / "x.mesh"],
                          [sample, "--chord", "-1", self.folder / "x.obj"], [sample, "--chord", "1", self.folder / "x.vtu"],
                          [sample, "--float", self.folder / "x.itd"], [support.VALID, "--chord", "1", self.folder / "x.obj"]):
            self.assertEqual(run("convert", *arguments).returncode, 2, arguments)
        self.assertEqual(self.listing(), [])
        copy = self.folder / "a.itd"
        copy.write_bytes(sample.read_bytes())
        self.assertEqual(run("convert", copy, copy).returncode, 2)

    def test_pictures_are_well_formed(self):
        for sample in SAMPLES:
            for kind in ("vtu", "obj", "gltf"):
                target = self.folder / f"p.{kind}"
                done = run("convert", "--lossy", sample, target)
                self.assertEqual(done.returncode, 0, done.stderr)
            piece = xml.etree.ElementTree.parse(self.folder / "p.vtu").find(".//Piece")
            arrays = {a.get("Name"): a.text.split() for a in piece.iter("DataArray")}
            num_points, num_cells = int(piece.get("NumberOfPoints")), int(piece.get("NumberOfCells"))
            self.assertEqual((len(arrays["Points"]), len(arrays["RationalWeights"])), (3 * num_points, num_points))
            self.assertEqual((len(arrays["types"]), len(arrays["HigherOrderDegrees"])), (num_cells, 3 * num_cells))
            start = 0
            for cell, end in enumerate(map(int, arrays["offsets"])):
                degrees = list(map(int, arrays["HigherOrderDegrees"][3 * cell:3 * cell + 3]))
                if arrays["types"][cell] == "76":
                    self.assertEqual(end - start, (degrees[0] + 1) * (degrees[0] + 2) // 2)
                    start = end
                    continue
                axes = {"75": 1, "77": 2, "79": 3}[arrays["types"][cell]]
                count = 1
                for degree in degrees[:axes]:
                    count *= degree + 1
                self.assertEqual(end - start, count)
                start = end
            gltf = json.loads((self.folder / "p.gltf").read_text())
            data = base64.b64decode(gltf["buffers"][0]["uri"].split(",")[1], validate=True)
            self.assertEqual(len(data), gltf["buffers"][0]["byteLength"])
            for mesh in gltf["meshes"]:
                for primitive in mesh["primitives"]:
                    position, index = gltf["accessors"][primitive["attributes"]["POSITION"]], gltf["accessors"][primitive["indices"]]
                    view = gltf["bufferViews"][index["bufferView"]]
                    ids = struct.unpack_from(f"<{index['count']}I", data, view["byteOffset"])
                    self.assertLess(max(ids), position["count"])

    def test_a_picture_that_would_lack_or_falsify_a_shape_is_refused_unless_that_is_wanted(self):
        for sample, words in [("objects.g2", "1 cylinders"), ("trimmed.itd", "the trimming of 2 surfaces, shown whole"),
                              ("groups.itd", "1 polygons")]:
            for kind in ("vtu", "obj", "gltf"):
                target = self.folder / f"p.{kind}"
                done = run("convert", SPLINES / sample, target)
                self.assertEqual((done.returncode, done.stdout, target.exists()), (1, "", False), sample)
                self.assertIn(words, done.stderr)
                done = run("convert", "--lossy", SPLINES / sample, target)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn(f"lossy: {words}", done.stdout)
                target.unlink()

    def test_coordinates_beyond_the_third_are_not_dropped_in_silence(self):
        sample = self.folder / "four.itd"
        sample.write_text("[OBJECT O [SURFACE BEZIER 2 2 E4 [0 0 0 1] [1 0 0 1] [0 1 0 2] [1 1 0 3]]]\n"
                          "[OBJECT P [CURVE BEZIER 2 E5 [0 0 0 1 1] [1 0 0 1 1]]]\n")
        for kind in ("vtu", "obj", "gltf"):
            target = self.folder / f"p.{kind}"
            done = run("convert", sample, target)
            self.assertEqual((done.returncode, target.exists()), (1, False), done.stderr)
            self.assertIn("the coordinates beyond the third of 2 entities", done.stderr)
            self.assertEqual(run("convert", "--lossy", sample, target).returncode, 0)

    def test_curves_beside_surfaces_and_in_the_plane_are_drawn(self):
        sample = self.folder / "both.itd"
        sample.write_text("[OBJECT O [SURFACE BEZIER 2 2 E3 [0 0 0] [1 0 0] [0 1 0] [1 1 0]]]\n"
                          "[OBJECT P [CURVE BEZIER 3 E2 [0 0] [1 1] [2 0]]]\n")
        for kind in ("vtu", "obj", "gltf"):
            done = run("convert", sample, self.folder / f"p.{kind}")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertNotIn("lossy", done.stdout)
        lines = (self.folder / "p.obj").read_text().splitlines()
        self.assertTrue({"l", "f"} <= {line.split()[0] for line in lines})
        types = xml.etree.ElementTree.parse(self.folder / "p.vtu").find(".//DataArray[@Name='types']").text.split()
        self.assertEqual(sorted(types), ["75", "77"])
        modes = {p["mode"] for m in json.loads((self.folder / "p.gltf").read_text())["meshes"] for p in m["primitives"]}
        self.assertEqual(modes, {3, 4})

    def test_a_picture_of_nothing_is_an_error(self):
        sample = self.folder / "cylinder.g2"
        lines = (SPLINES / "objects.g2").read_text().split("\n")
        start, end = (next(i for i, line in enumerate(lines) if line.startswith(kind)) for kind in ("260 ", "210 "))
        sample.write_text("\n".join(lines[start:end]) + "\n")  # a cylinder alone
        for kind in ("vtu", "obj", "gltf"):
            for options in ([], ["--lossy"]):
                done = run("convert", *options, sample, self.folder / f"p.{kind}")
                self.assertEqual((done.returncode, done.stdout), (4, ""), done.stderr)
                self.assertFalse((self.folder / f"p.{kind}").exists())

    def test_a_smaller_chord_gives_more_points(self):
        sizes = []
        for chord in ("1", "0.01", "0.0001"):
            run("convert", "--lossy", "--chord", chord, SPLINES / "groups.itd", self.folder / "p.obj")
            sizes.append((self.folder / "p.obj").stat().st_size)
        self.assertTrue(sizes[0] < sizes[1] < sizes[2], sizes)


if __name__ == "__main__":
    support.main()
