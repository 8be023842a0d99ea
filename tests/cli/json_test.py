#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The JSON reports of all commands: the schema holds, and holds tightly; keys in order; exact numbers; what the report says
is true of the file."""
import copy
import json
import math
import re
import unittest
from fractions import Fraction

import schema
import support
from schema import DEFINITIONS, SCHEMA, keys_of
from support import MODELS, Folder, run


def scientific(value, digits=17):
    """The fraction with so many significant digits, rounded to nearest, ties to even."""
    if value == 0:
        return "0." + "0" * (digits - 1) + "e+00"
    exponent = len(str(abs(value.numerator))) - len(str(value.denominator))
    if abs(value) < Fraction(10) ** exponent:
        exponent -= 1
    whole = round(abs(value) / Fraction(10) ** (exponent - digits + 1))  # ties to even
    if whole == 10**digits:
        whole, exponent = whole // 10, exponent + 1
    text = str(whole)
    return f"{'-' if value < 0 else ''}{text[0]}.{text[1:]}e{exponent:+03d}"


# A square that the cube of tests/models/patches/cube.itd meets in an arc on each of four sides.
TREE = """{"format": "veritope-tree-1", "root": {"op": "glue", "of": [
 {"op": "place", "of": {"op": "sphere", "radius": 1}, "rotate": {"axis": [1, 1, 0], "point": [0, 0, 0], "degrees": 30}},
 {"op": "place", "of": {"op": "torus", "major": 3, "minor": "1/2"}, "matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, -2, 0]]}]}}"""
SQUARE = "[OBJECT S\n[SURFACE BEZIER 2 2 E3\n[-1 -1 0.25] [2 -1 0.5]\n[-1 2 0.5] [2 2 0.75]\n]\n]\n"


class Schema(Folder):
    @unittest.skipIf(schema.jsonschema is None, "python3-jsonschema is not installed")
    def setUp(self):
        super().setUp()
        self.validator = schema.validator()

    def documents(self):
        models = [path for path in sorted(MODELS.iterdir()) if path.is_file() and path.name != "EXPECT.tsv"]
        yield support.report(*models)
        yield support.report("--as-indexed", "--no-check", "--max-defects", 0, *models)
        yield support.report(MODELS / "valid_frame.off", "--certificate", self.folder / "c")
        yield support.report(MODELS / "valid_frame.off", "--certificate", "/dev/full")
        yield support.report(MODELS / "valid_frame.off", program=self.copy_programs("exit 1"))
        yield json.loads(run("info", "--json", "-", *models).stdout)
        splines = sorted((MODELS / "splines").iterdir())
        (self.folder / "bad.itd").write_text("[CURVE BSPLINE 2 2 E1 [KV 0 1 0 1] [0] [1]]")
        yield json.loads(run("info", "--json", "-", *splines, self.folder / "bad.itd", models[0]).stdout)
        patches = sorted((MODELS / "patches").iterdir())
        yield support.report("--collar", "--max-memory", 100, *patches, timeout=900)
        yield support.report("--no-check", *splines, self.folder / "bad.itd")
        yield json.loads(run("cover", MODELS / "patches" / "cube.itd", "--sweep", 1, "--json", "-").stdout)
        yield json.loads(run("project", "1,2,3", MODELS / "patches" / "cube.itd", "--json", "-").stdout)
        (self.folder / "points.txt").write_text("0 0 0\n9 9 9\n")
        yield json.loads(run("boolean", "A", f"A={MODELS / 'patches' / 'knot_multiplicity_nearest_valid.vjson'}", "-o", self.folder / "s.json", "--json", "-").stdout)
        yield json.loads(run("boolean", "!F", f"F={MODELS / 'valid_frame.off'}", "-o", self.folder / "e.json", "--json", "-").stdout)
        (self.folder / "tree.json").write_text(TREE)
        yield json.loads(run("build", self.folder / "tree.json", "-o", self.folder / "t.vjson", "--json", "-").stdout)
        yield json.loads(run("cage", "hull", "--around", MODELS / "valid_frame.off", "-o", self.folder / "h.vjson", "--json", "-").stdout)
        yield json.loads(run("micro", "--cage", self.folder / "h.vjson", "--tile", "jack", "--counts", "8,8,8", "-o", self.folder / "h.vmicro", "--json", "-").stdout)
        yield json.loads(run("micro", "--cage", self.folder / "h.vjson", "--tile", "jack", "--counts", "8,8,8", "--thickness", "9", "-o", self.folder / "g.vmicro", "--json", "-").stdout)
        yield json.loads(run("certify", "--json", "-", self.folder / "h.vmicro").stdout)
        yield json.loads(run("cage", "radial", "--outer", 1, "--height", "0,1", "--sector", 50, "-o", self.folder / "h.vjson", "--json", "-").stdout)
        yield json.loads(run("classify", MODELS / "valid_frame.off", self.folder / "points.txt", "-o", self.folder / "a", "--json", "-", "--certificate", self.folder / "p").stdout)
        yield json.loads(run("inspect", MODELS / "splines" / "two_cubes.mesh", "--json", "-").stdout)
        yield json.loads(run("inspect", MODELS / "splines" / "two_cubes.mesh", "--pair", "0,1", "--json", "-").stdout)
        yield json.loads(run("convert", MODELS / "splines" / "two_cubes.mesh", self.folder / "w.vjson", "--weld", "1e-9", "--json", "-").stdout)
        yield json.loads(run("chain", MODELS / "patches" / "cube.itd", "--origin", "auto", "--json", "-").stdout)
        yield json.loads(run("render", self.folder / "e.json", "-o", self.folder / "e.png", "--grid", 3, "--size", "64,64", "--json", "-").stdout)
        yield json.loads(run("render", self.folder / "t.vjson", "-o", self.folder / "t.gltf", "--explode", "1/3", "--json", "-").stdout)
        dms = MODELS / "dms" / "tetrahedron.vdms"
        yield json.loads(run("info", "--json", "-", dms).stdout)
        folded = self.folder / "folded.vdms"
        folded.write_text(dms.read_text().replace('"value": ["0", "0", "1", "0"]', '"value": ["0", "0", "-5", "0"]'))
        yield support.report(*sorted((MODELS / "dms").iterdir()), folded)
        for options in ((), ("--gradient",), ("--exact", "--gradient")):
            yield json.loads(run("dms", "eval", dms, self.folder / "points.txt", *options, "--json", "-").stdout)
        (self.folder / "flat.vdms").write_text(dms.read_text().replace('["0", "0", "1"]]]', '["0", "0", "0"]]]'))
        yield json.loads(run("dms", "eval", self.folder / "flat.vdms", self.folder / "points.txt", "--json", "-").stdout)
        (self.folder / "segments.txt").write_text("0 0 0 1 1 1\n")
        yield json.loads(run("dms", "xray", dms, self.folder / "segments.txt", "--attribute", "density", "--json", "-").stdout)
        (self.folder / "corners.txt").write_text("0 0 0\n1 0 0\n0 1 0\n0 0 1\n")
        yield json.loads(run("dms", "domain", self.folder / "corners.txt", "-o", self.folder / "d.vdms", "--hull", "--json", "-").stdout)
        data = "".join(f"{x}/8 {y}/8 {z}/8 {x * y}\n" for x in range(4) for y in range(4) for z in range(3))
        fit = ("-o", self.folder / "f.vdms", "--domain", self.folder / "d.vdms", "--degree", 2, "--json", "-")
        yield json.loads(run("dms", "fit", "-", *fit, input=data).stdout)
        surface = ("--attribute", "density", "--level", "1/3", "--within", 1, "-o", self.folder / "f.off", "--json", "-")
        yield json.loads(run("dms", "iso", dms, *surface).stdout)
        for mode in (("--mode", "xray"), ("--mode", "volume"), ("--mode", "slice"), ("--mode", "iso", "--level", "1/3"), ()):
            yield json.loads(run("render", dms, *mode, "--attribute", "density", "-o", self.folder / "e.png", "--size", "64,64", "--json", "-").stdout)
        yield json.loads(run("dms", "refine", dms, "--at", "1/3,1/3,0", "-o", self.folder / "r.vdms", "--json", "-").stdout)
        yield json.loads(run("info", "--json", "-", MODELS / "dms" / "attribute_domain.vdms").stdout)
        curves, square = self.folder / "curves.json", self.folder / "square.itd"
        square.write_text(SQUARE)
        yield json.loads(run("intersect", MODELS / "patches" / "cube.itd", square, "--json", "-", "-o", curves).stdout)
        yield json.loads(curves.read_text())

    def test_the_schema_is_a_schema_and_the_documents_of_all_commands_obey_it(self):
        self.validator.check_schema(SCHEMA)
        seen = set()
        for document in self.documents():
            self.assertEqual([], schema.faults(document))
            self.assertTrue(self.validator.is_valid(document))
            seen.add(document["schema"])
        self.assertEqual(seen, set(schema.kinds()))

    def assert_obeyed(self, *arguments):
        done = run(*arguments, "--json", "-", timeout=900)
        self.assertIn(done.returncode, (0, 1, 3, 4), done.stderr)
        document = json.loads(done.stdout)
        self.assertEqual([], schema.faults(document), arguments)
        return document

    def test_the_documents_of_the_bundled_examples_obey_the_schema(self):
        examples = [path for path in sorted((support.ROOT / "examples").iterdir()) if path.suffix in (".stl", ".off", ".itd")]
        self.assertGreaterEqual(len(examples), 4)
        self.assert_obeyed("certify", *examples)
        self.assert_obeyed("info", *examples)
        pipe = support.ROOT / "examples" / "quarter_pipe.itd"
        self.assert_obeyed("cover", pipe, "--sweep", 0)
        self.assert_obeyed("project", "1/3,0x1p-1,2", pipe)
        self.assert_obeyed("intersect", pipe, MODELS / "patches" / "cube.itd")

    @unittest.skipUnless(support.DATA.is_dir(), "needs VERITOPE_DATA")
    def test_the_documents_of_real_models_obey_the_schema(self):
        for folder in ("cad", "mesh"):
            self.assert_obeyed("certify", "--no-check", "--max-cells", 2000, support.DATA / folder)
            files = [path for path in sorted((support.DATA / folder).rglob("*")) if path.is_file()]
            self.assertGreater(len(self.assert_obeyed("info", *files)["files"]), 50)
        splines = sorted((support.DATA / "cad").glob("irit__*.itd"))[:6] + sorted((support.DATA / "thin").glob("k_*.vjson"))[:3]
        for path in splines:
            done = run("project", "1,2,3", path, "--json", "-", "--max-boxes", 200, timeout=900)
            if done.stdout:  # plane ones are refused
                self.assertEqual([], schema.faults(json.loads(done.stdout)), path)

    @unittest.skipUnless(support.DATA.is_dir(), "needs VERITOPE_DATA")
    def test_the_documents_of_intersections_and_covers_of_real_models_obey_the_schema(self):
        """Each list of an intersection has an entry in one of them, and each answer of a cover occurs."""
        cad, thin = support.DATA / "cad", support.DATA / "thin"
        saddle, pillow = cad / "irit__pl_saddl.itd", thin / "k_pillow_quad.vjson"
        pairs = [(saddle, saddle), (saddle, cad / "irit__ir_eggs.itd"), (pillow, thin / "q_squircle_caps.vjson"), (thin / "q_wedge_0.1.vjson", pillow),
                 (cad / "gotools-data__sf_with_holes.g2", cad / "gotools-data__b25.g2"), (cad / "gismo__egg.xml", cad / "gismo__duck_BRep.xml")]
        found = {"branches": [], "overlaps": [], "unresolved": []}
        for pair in pairs:
            curves = self.folder / "curves.json"
            document = self.assert_obeyed("intersect", *pair, "-o", curves)
            self.assertEqual([], schema.faults(json.loads(curves.read_text())), pair)
            for key, entries in found.items():
                entries += document[key]
        self.assertEqual([key for key, entries in found.items() if not entries], [])
        models = [cad / "iritprim__ns_sphere_rational.itd", cad / "mfem__ball-nurbs.mesh", cad / "gismo__fichera.xml", thin / "m_hole_1e-4.vjson"]
        rows = [row for path in models for row in self.assert_obeyed("cover", path, "--sweep", 1)["rows"]]
        self.assertEqual(len(rows), 2 * len(models))
        answers = {condition["answer"] for row in rows for condition in row["conditions"].values()}
        self.assertLessEqual({"true", "false"}, answers)

    def test_every_command_that_writes_json_has_its_document_here(self):
        """A new --json needs a definition in the schema and a document above."""
        commands = re.findall(r"(?m)^  ([a-z-]+) {2,}", run("--help").stdout.split("Subcommands:")[1])
        self.assertIn("selftest", commands)
        with_json = [name for name in commands if "--json" in run(name, "--help").stdout]
        self.assertEqual(sorted(with_json), ["boolean", "build", "cage", "certify", "chain", "classify", "convert", "cover", "info", "inspect", "intersect", "micro", "project", "render"])

    def test_every_key_is_required_and_no_other_is_allowed(self):
        document = support.report(MODELS / "m2_copied_face.off", MODELS / "valid_frame.off", MODELS / "unreadable_index.off")

        def objects(value, path):
            if isinstance(value, dict):
                yield path
                for key, inner in value.items():
                    yield from objects(inner, path + [key])
            elif isinstance(value, list):
                for i, inner in enumerate(value[:1]):
                    yield from objects(inner, path + [i])

        def at(value, path):
            for step in path:
                value = value[step]
            return value

        for path in objects(document, []):
            spoilt = copy.deepcopy(document)
            at(spoilt, path)["extra"] = 1
            self.assertFalse(self.validator.is_valid(spoilt), f"an extra key in {path}")
            for key in at(document, path):
                spoilt = copy.deepcopy(document)
                del at(spoilt, path)[key]
                self.assertFalse(self.validator.is_valid(spoilt), f"{path} without {key}")

    def test_wrong_values_are_refused(self):
        document = support.report(MODELS / "m2_copied_face.off")
        for path, value in [(["verdict"], "FINE"), (["exit"], 2), (["sha256"], "0"), (["counts", "faces"], -1), (["counts", "faces"], "5"),
                            (["defects", 0, "rule"], "M10"), (["defects", 0, "point", "exact", 0], "0"), (["format"], "step")]:
            spoilt = copy.deepcopy(document)
            place = spoilt["files"][0]
            for step in path[:-1]:
                place = place[step]
            place[path[-1]] = value
            self.assertFalse(self.validator.is_valid(spoilt), path)


def parts_of(value):
    """Every object inside a schema that may describe a value, and itself."""
    if isinstance(value, dict):
        if {"type", "enum", "oneOf"} & set(value) and not isinstance(value.get("type", ""), dict):
            yield value
        for inner in value.values():
            yield from parts_of(inner)
    elif isinstance(value, list):
        for inner in value:
            yield from parts_of(inner)


class Definitions(unittest.TestCase):
    """The schema says each thing once."""

    def test_what_has_a_definition_is_written_nowhere_else(self):
        seen = {}
        for name, definition in DEFINITIONS.items():
            for part in parts_of(definition):
                text = json.dumps({key: inner for key, inner in part.items() if key != "description"}, sort_keys=True)
                if {"properties", "enum", "pattern", "minItems", "oneOf"} & set(part):
                    self.assertFalse(text in seen, f"{name} repeats a part of {seen.get(text)}: {text}")
                    seen[text] = name

    def test_every_definition_is_used_and_every_object_is_closed(self):
        text = json.dumps(SCHEMA)
        for name, definition in DEFINITIONS.items():
            self.assertIn(f'"#/$defs/{name}"', text)
            for part in parts_of(definition):
                if part.get("type") == "object":
                    self.assertIs(part["additionalProperties"], False, name)
                    if "oneOf" not in part:
                        self.assertEqual(part["required"], list(part["properties"]), name)


class Values(Folder):
    def test_keys_stand_in_the_order_of_the_schema(self):
        def check(value, name):
            self.assertEqual(list(value), keys_of(name))
        report = support.report(MODELS / "m9_smallest.off", MODELS / "unreadable_nan.stl")
        info = json.loads(run("info", "--json", "-", MODELS / "valid_strip.ply").stdout)
        for document, kind, file_kind in [(report, "report", "file"), (info, "info", "info_file")]:
            check(document, kind)
            for file in document["files"]:
                check(file, file_kind)
                check(file["counts"], "mesh_counts" if file_kind == "file" else "info_mesh_counts")
                for defect in file.get("defects", []):
                    check(defect, "defect")
                for shell in file.get("shells", []):
                    check(shell, "shell")

    def test_the_decimal_volume_is_the_exact_one_correctly_rounded(self):
        for file in support.report("--no-check", *MODELS.glob("[mv]*.*"))["files"]:
            for volume in [file["volume"], *(shell["volume"] for shell in file["shells"])]:
                if volume is not None:
                    p, q = map(int, volume["exact"].split("/"))
                    self.assertEqual(math.gcd(p, q), 1)
                    self.assertEqual(volume["decimal"], scientific(Fraction(p, q)), file["path"])

    def test_the_rounding_of_the_decimal_volume_at_ties_and_carries(self):
        model = self.folder / "m.obj"
        for scale in ["6", "0.6", "1", "3e-162", "1e150", "6.0000000000000005e10", "599.99999999999995", "6e300", "5e-324", "0.1875"]:
            model.write_text(f"v 0 0 0\nv {scale} 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
            volume = support.only_file(model)["volume"]
            exact = Fraction(float(scale)) / 6
            self.assertEqual(volume, {"exact": f"{exact.numerator}/{exact.denominator}", "decimal": scientific(exact)})
        # 2^57 + 2^3 = 144115188075855880 has 18 digits and ends in 0; halves of such numbers are ties.
        for number in (2**57 + 8, 10**17 + 5, 10**17 + 15, 10**18 - 5):
            model.write_text(f"v 0 0 0\nv 6 0 0\nv 0 1 0\nv 0 0 {number}\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
            self.assertEqual(support.only_file(model)["volume"]["decimal"], scientific(Fraction(float(number))))

    def test_points_are_fractions_and_the_nearest_doubles(self):
        for file in support.report("--no-check", *MODELS.glob("m*.*"))["files"]:
            for defect in file["defects"]:
                point = defect["point"]
                self.assertEqual(point["decimal"], [float(Fraction(c)) for c in point["exact"]])

    def test_floats_are_the_shortest_that_read_back_as_the_same(self):
        numbers = ["0.1", "1.7976931348623157e+308", "5e-324", "0.041536", "9007199254740993.5", "1e+23", "9.5367431640625e-07"]
        for x, y, z in zip(numbers, numbers[1:], numbers[2:]):
            model = self.folder / "m.off"
            model.write_text(f"OFF 4 4\n0 0 0\n{x} 0 0\n0 {y} 0\n0 0 {z}\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n")
            text = run("certify", "--json", "-", model).stdout
            shown = text.split('"max":[')[1].split("]")[0].split(",")
            for number, original in zip(shown, (x, y, z)):
                self.assertEqual(float(number), float(original))
                self.assertLessEqual(len(number), len(repr(float(original))))

    def test_defects_name_the_right_places(self):
        defects = {d["rule"]: d for d in support.only_file(MODELS / "m2_copied_face.off")["defects"]}
        self.assertEqual((defects["M2"]["faces"], sorted(defects["M2"]["vertices"])), ([3, 4], [1, 2, 3]))
        self.assertEqual(sorted(defects["M4"]["faces"])[-2:], [3, 4])
        touch = support.only_file(MODELS / "m7_touching_point.off")["defects"]
        for defect in touch:
            self.assertEqual((defect["point"]["exact"], defect["size"]), (["1/1", "1/1", "0/1"], 0))
        edge = support.only_file(MODELS / "m4_touching_edge.off")["defects"][0]
        self.assertEqual((len(edge["faces"]), edge["point"]["exact"], edge["size"]), (4, ["0/1", "0/1", "1/2"], 1))

    def test_polygons_are_those_of_the_file(self):
        model = self.folder / "m.off"
        cube = (MODELS / "valid_quads.off").read_text()
        model.write_text(cube.replace("4 1 3 7 5\n", "").replace(" 6 0", " 5 0"))
        file = support.only_file(model)
        self.assertEqual((file["counts"]["faces"], file["rules"]["M3"], file["counts"]["polygons_split"]), (10, 4, 5))
        for defect in file["defects"]:
            self.assertEqual(defect["polygons"], [face // 2 for face in defect["faces"]])

    def test_a_name_that_is_no_utf_8_is_reported(self):
        name = bytes(self.folder) + b"/\xff.off"
        support.shutil.copy(support.VALID, name)
        done = support.subprocess.run([support.BIN / "veritope", "certify", "--json", "-", name], capture_output=True)
        self.assertTrue(json.loads(done.stdout)["files"][0]["path"].endswith("/\ufffd.off"))

    def test_what_is_ignored_is_counted(self):
        ignored = support.only_file(MODELS / "valid_quads_crlf.obj")["ignored"]
        self.assertIn({"what": "vn lines", "count": 1}, ignored)

    def binary_stl(self, model):
        path = self.folder / "converted.stl"
        self.assertEqual(support.run("convert", "--to", "stl", model, path).returncode, 0)
        return path.read_bytes()

    def test_facets_behind_the_stated_ones_are_named_and_change_no_verdict(self):
        data = self.binary_stl(MODELS / "valid_frame.off")
        plain, longer = self.folder / "plain.stl", self.folder / "longer.stl"
        plain.write_bytes(data)
        longer.write_bytes(data + 7 * data[84:134])
        stated = int.from_bytes(data[80:84], "little")
        for command in ("certify", "info"):
            files = [json.loads(support.run(command, "--json", "-", path).stdout)["files"][0] for path in (plain, longer)]
            self.assertEqual(files[0]["notices"], [])
            message = f"7 more facets follow the stated {stated}: the count may be wrong"
            self.assertEqual(files[1]["notices"], [{"code": "data-after-end", "message": message}])
            self.assertEqual(files[0]["counts"], files[1]["counts"])
            self.assertRegex(support.run(command, longer).stdout, rf"\n  notice +{message}\n")
            self.assertNotIn("notice", support.run(command, plain).stdout)
        self.assertEqual(support.only_file(longer)["verdict"], "VALID")

    def test_every_shell_is_described(self):
        file = support.only_file(MODELS / "valid_nested_three.off")
        self.assertEqual([(s["depth"], s["outward"], s["genus"], s["euler"]) for s in file["shells"]],
                         [(0, True, 0, 2), (1, False, 0, 2), (2, True, 0, 2)])
        total = sum(Fraction(shell["volume"]["exact"]) for shell in file["shells"])
        self.assertEqual(total, Fraction(file["volume"]["exact"]))


if __name__ == "__main__":
    support.main()
