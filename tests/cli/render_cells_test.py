# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope render of V-models: one colour a cell, cells moved apart, control nets; .png, .vtu, .gltf and .obj read by parsers of this
file. Also the files for viewers of other solids."""
import base64
import colorsys
import json
import re
import struct
import subprocess
import sys
import unittest
import xml.etree.ElementTree

from render_test import WHITE, pixels
from support import MODELS, ROOT, Folder, run

CUBES = "cubes.vjson"  # two cells, which TWO makes
TWO = {"op": "glue", "of": [{"op": "box", "min": [k, 0, 0], "max": [k + 1, 1, 1]} for k in (0, 1)]}
FOLDED = MODELS / "patches" / "volume_folded_smallest.itd"
PATCHES = MODELS / "patches" / "cube.itd"
BLUE, ORANGE = (86, 140, 200), (242, 150, 50)  # of cells 0 and 1


def read_gltf(path):
    """A list of (name, colour of the material, translated points, triangles, translated net points, net lines), after what the
    specification of glTF 2.0 demands of accessors, views and buffers was asserted."""
    gltf = json.loads(path.read_text())
    assert gltf["asset"]["version"] == "2.0"
    [buffer] = gltf["buffers"]
    head, data = buffer["uri"].split(",", 1)
    assert head == "data:application/octet-stream;base64"
    data = base64.b64decode(data, validate=True)
    assert len(data) == buffer["byteLength"]
    used = []

    def values(number, target):
        accessor = gltf["accessors"][number]
        view = gltf["bufferViews"][accessor["bufferView"]]
        kind, width = {5126: ("f", 3), 5125: ("I", 1)}[accessor["componentType"]]
        assert accessor["type"] == {3: "VEC3", 1: "SCALAR"}[width] and view["target"] == target and view["buffer"] == 0
        assert view["byteOffset"] % 4 == 0 and view["byteLength"] == 4 * width * accessor["count"]
        assert view["byteOffset"] + view["byteLength"] <= len(data)
        used.append((view["byteOffset"], view["byteLength"]))
        flat = struct.unpack_from(f"<{width * accessor['count']}{kind}", data, view["byteOffset"])
        rows = [flat[i:i + width] for i in range(0, len(flat), width)]
        if width == 3:
            assert accessor["min"] == [min(r[k] for r in rows) for k in range(3)]
            assert accessor["max"] == [max(r[k] for r in rows) for k in range(3)]
            return rows
        return list(flat)

    [root] = gltf["scenes"][gltf["scene"]]["nodes"]
    root = gltf["nodes"][root]
    parts = []
    for child in root["children"]:
        node = gltf["nodes"][child]
        row = {"name": node["name"], "triangles": [], "lines": [], "points": [], "net": []}
        for primitive in gltf["meshes"][node["mesh"]]["primitives"]:
            points = [tuple(x + t for x, t in zip(p, root["translation"])) for p in values(primitive["attributes"]["POSITION"], 34962)]
            indices = values(primitive["indices"], 34963)
            assert max(indices) < len(points)
            size = {4: 3, 1: 2}[primitive["mode"]]
            assert len(indices) % size == 0
            groups = [tuple(indices[i:i + size]) for i in range(0, len(indices), size)]
            if size == 3:
                row["points"], row["triangles"] = points, groups
                row["material"] = primitive["material"]
            else:
                row["net"], row["lines"] = points, groups
                assert gltf["materials"][primitive["material"]]["name"] == "nets"
        parts.append(row)
    assert len(gltf["accessors"]) == len(gltf["bufferViews"]) == len(used)
    assert sum(length for _, length in used) == len(data) == max(begin + length for begin, length in used)
    assert len({row["material"] for row in parts}) == len(parts) == len(gltf["meshes"])
    return parts


def read_obj(path):
    """A list of (name, vertices, colours, triangles, lines) for each group; numbers of vertices are those of the file, from 0."""
    parts, vertices, colours = [], [], []
    for line in path.read_text().splitlines():
        word, *rest = line.split()
        if word == "g":
            parts.append({"name": rest[0], "triangles": [], "lines": []})
        elif word == "v":
            assert len(rest) == 6
            vertices.append(tuple(map(float, rest[:3])))
            colours.append(tuple(map(float, rest[3:])))
        else:
            parts[-1][{"f": "triangles", "l": "lines"}[word]].append(tuple(int(i) - 1 for i in rest))
            assert max(parts[-1][{"f": "triangles", "l": "lines"}[word]][-1]) < len(vertices)
    return parts, vertices, colours


def read_vtu(path):
    """The arrays by their names; the lengths agree with the numbers of points and cells."""
    piece = xml.etree.ElementTree.parse(path).getroot().find("UnstructuredGrid/Piece")
    arrays = {}
    for array in piece.iter("DataArray"):
        kind = float if array.get("type") == "Float64" else int
        flat = [kind(x) for x in array.text.split()]
        n = int(array.get("NumberOfComponents") or 1)
        arrays[array.get("Name")] = flat if n == 1 else [tuple(flat[i:i + n]) for i in range(0, len(flat), n)]
    points, cells = int(piece.get("NumberOfPoints")), int(piece.get("NumberOfCells"))
    assert len(arrays["Points"]) == len(arrays["RationalWeights"]) == points
    for name in ("offsets", "types", "cell", "colour", "net", "HigherOrderDegrees"):
        assert len(arrays[name]) == cells, name
    assert arrays["offsets"][-1] == len(arrays["connectivity"]) and max(arrays["connectivity"]) < points
    return arrays


def box_of(points):
    return [tuple(end(p[k] for p in points) for k in range(3)) for end in (min, max)]


def volume(points, triangles):
    """By the divergence theorem: positive if the triangles are counterclockwise from outside."""
    total = 0
    for a, b, c in ([points[i] for i in t] for t in triangles):
        total += a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
    return total / 6


def regions(rows):
    """The connected regions of pixels that are not white: the sets of hues, in sixths of the circle, of their saturated pixels."""
    height, width = len(rows), len(rows[0])
    seen, out = set(), []
    for start in ((y, x) for y in range(height) for x in range(width)):
        if start in seen or rows[start[0]][start[1]] == WHITE:
            continue
        hues, stack = {}, [start]
        seen.add(start)
        while stack:
            y, x = stack.pop()
            hue, saturation, _ = colorsys.rgb_to_hsv(*(c / 255 for c in rows[y][x]))
            if saturation > 0.4:
                hues[int(hue * 6)] = hues.get(int(hue * 6), 0) + 1
            for other in ((y + 1, x), (y - 1, x), (y, x + 1), (y, x - 1)):
                if 0 <= other[0] < height and 0 <= other[1] < width and other not in seen and rows[other[0]][other[1]] != WHITE:
                    seen.add(other)
                    stack.append(other)
        out.append({hue for hue, count in hues.items() if count > 20})
    return out


class Case(Folder):
    def render(self, *arguments, status=0):
        done = run("render", *arguments, cwd=self.folder)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done.stdout if status == 0 else re.sub(r"\s+", " ", done.stderr)

    def build(self, name, root):
        (self.folder / f"{name}.json").write_text(json.dumps({"format": "veritope-tree-1", "root": root}))
        done = run("build", f"{name}.json", "-o", f"{name}.vjson", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return f"{name}.vjson"


class Cells(Case):
    def setUp(self):
        super().setUp()
        self.build("cubes", TWO)

    def test_cells_that_are_moved_apart_are_regions_of_one_colour_each(self):
        view = ("--size", "160,120", "--view", "0,1,-0.3")
        self.render(CUBES, "-o", "p.png", *view)
        self.render(CUBES, "-o", "q.png", "--explode", 1, *view)
        together, apart = (regions(pixels(self.folder / name)[2]) for name in ("p.png", "q.png"))
        blue, orange = (int(colorsys.rgb_to_hsv(*(c / 255 for c in colour))[0] * 6) for colour in (BLUE, ORANGE))
        self.assertEqual(together, [{blue, orange}])
        self.assertEqual(sorted(apart, key=str), sorted([{blue}, {orange}], key=str))

    def test_nets_are_seen_beside_a_curved_cell(self):
        model = self.build("s", {"op": "sphere", "radius": 1, "cells": "one"})
        shown = []
        for options in ([], ["--nets"]):
            self.render(model, "-o", "p.png", "--size", "120,120", "--view", "1,2,-1", *options)
            shown.append(sum(p != WHITE for row in pixels(self.folder / "p.png")[2] for p in row))
        self.render(model, "-o", "p.png", "--size", "120,120", "--view", "1,2,-1", "--nets")
        self.assertLess(shown[1], shown[0], "the net's box makes the ball smaller in the picture")

    def test_where_cells_are_moved(self):
        """Centres 1/2 and 3/2 in x, and 1 between them: by K / 2 each."""
        for k, low, high in (("0", 0, 2), ("1", -0.5, 2.5), ("1/3", -1 / 6, 2 + 1 / 6), ("0.25", -0.125, 2.125)):
            for suffix in ("gltf", "obj", "vtu"):
                self.render(CUBES, "-o", f"p.{suffix}", "--explode", k)
            parts = read_gltf(self.folder / "p.gltf")
            groups, vertices, _ = read_obj(self.folder / "p.obj")
            vtu = read_vtu(self.folder / "p.vtu")
            for cell, box in enumerate(([(low, 0, 0), (low + 1, 1, 1)], [(high - 1, 0, 0), (high, 1, 1)])):
                of_obj = [vertices[i] for t in groups[cell]["triangles"] for i in t]
                of_vtu = [vtu["Points"][i] for i in vtu["connectivity"][8 * cell:8 * cell + 8]]
                for points in (parts[cell]["points"], of_obj, of_vtu):
                    for found, expected in zip(box_of(points), box):
                        for x, y in zip(found, expected):
                            self.assertAlmostEqual(x, y, 6, (k, cell))

    def test_a_gltf_has_a_mesh_and_a_material_for_each_cell(self):
        self.render(CUBES, "-o", "p.gltf")
        parts = read_gltf(self.folder / "p.gltf")
        self.assertEqual([(p["name"], len(p["points"]), len(p["triangles"]), p["lines"]) for p in parts], [("cell_0", 24, 12, []), ("cell_1", 24, 12, [])])
        for part in parts:
            self.assertAlmostEqual(volume(part["points"], part["triangles"]), 1, 6)
        self.assertEqual([m["name"] for m in json.loads((self.folder / "p.gltf").read_text())["materials"]], ["cell_0", "cell_1"])

    def test_nets_are_lines_between_neighbours(self):
        self.render(CUBES, "-o", "p.gltf", "--nets")
        for part in read_gltf(self.folder / "p.gltf"):
            self.assertEqual((len(part["net"]), len(part["lines"])), (8, 12))
            for a, b in part["lines"]:
                self.assertAlmostEqual(sum(abs(x - y) for x, y in zip(part["net"][a], part["net"][b])), 1, 6)
        self.render(CUBES, "-o", "p.obj", "--nets")
        groups, vertices, _ = read_obj(self.folder / "p.obj")
        self.assertEqual([(g["name"], len(g["triangles"]), len(g["lines"])) for g in groups], [("cell_0", 12, 12), ("cell_1", 12, 12)])
        self.assertEqual(len(vertices), 2 * (24 + 8))
        self.render(CUBES, "-o", "p.vtu", "--nets")
        vtu = read_vtu(self.folder / "p.vtu")
        self.assertEqual(vtu["types"], [79] * 2 + [3] * 24)
        self.assertEqual(vtu["cell"], [0, 1] + [0] * 12 + [1] * 12)
        self.assertEqual(vtu["net"], [0] * 2 + [1] * 24)
        self.assertEqual(vtu["offsets"], [8, 16] + [18 + 2 * i for i in range(24)])
        self.assertEqual(vtu["colour"][:2], [(*BLUE, 255), (*ORANGE, 255)])

    def test_a_net_has_the_control_points_of_its_cell(self):
        model = self.build("s", {"op": "sphere", "radius": 1})
        self.render(model, "-o", "p.vtu", "--nets")
        entities = json.loads((self.folder / model).read_text())["entities"]
        vtu = read_vtu(self.folder / "p.vtu")
        at = sum(offset == 79 for offset in vtu["types"])
        expected, lines = [], 0
        for entity in entities:
            shape = entity["shape"]
            for point in shape["points"]:
                x = [float(eval(c, {"__builtins__": {}})) for c in point]  # fractions p/q
                expected.append([c / x[3] for c in x[:3]] if shape["rational"] else x[:3])
            n = [len(k) - p - 1 for k, p in zip(shape["knots"], shape["degrees"])]
            lines += sum((n[a] - 1) * n[(a + 1) % 3] * n[(a + 2) % 3] for a in range(3))
        self.assertEqual(vtu["types"][at:], [3] * lines)
        for found, p in zip(vtu["Points"][-len(expected):], expected):
            for x, y in zip(found, p):
                self.assertAlmostEqual(x, y, 12)

    def test_bezier_cells_keep_weights_and_degrees(self):
        model = self.build("c", {"op": "cylinder", "radius": 1, "height": 2})
        self.render(model, "-o", "p.vtu", "--explode", 2)
        vtu = read_vtu(self.folder / "p.vtu")
        self.assertEqual(vtu["types"], [79] * 5)
        self.assertEqual(vtu["cell"], [0, 1, 2, 3, 4])
        self.assertEqual(len(set(vtu["colour"])), 5)
        self.assertEqual(vtu["HigherOrderDegrees"], [(1, 1, 1)] + [(1, 2, 1)] * 4)
        self.assertEqual({w for w in vtu["RationalWeights"]}, {1, 2})

    def test_an_obj_of_cells_apart_is_a_mesh_of_as_many_bodies(self):
        self.render(CUBES, "-o", "p.obj", "--explode", 1, "--nets")
        done = run("certify", "p.obj", cwd=self.folder)
        self.assertIn("VALID  p.obj  2 bodies, genus 0, volume 2 (checked)", done.stdout)
        _, _, colours = read_obj(self.folder / "p.obj")
        self.assertEqual(colours[0], tuple(round(c / 255, 3) for c in BLUE))

    def test_triangles_are_outward_in_cells_of_either_hand(self):
        mirrored = {"op": "place", "matrix": [[-1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]], "of": {"op": "sphere", "radius": 1}}
        for model in (self.build("s", {"op": "sphere", "radius": 1}), self.build("m", mirrored)):
            self.render(model, "-o", "p.obj")
            groups, vertices, _ = read_obj(self.folder / "p.obj")
            volumes = [volume(vertices, g["triangles"]) for g in groups]
            self.assertEqual(len(volumes), 7)
            self.assertTrue(all(v > 0.1 for v in volumes), volumes)
            self.assertAlmostEqual(sum(volumes), 4.18879, 1)

    def test_a_smaller_chord_comes_closer(self):
        model = self.build("c", {"op": "cylinder", "radius": 1, "height": 1})
        errors = []
        for chord in ("0.1", "0.001"):
            self.render(model, "-o", "p.obj", "--chord", chord)
            groups, vertices, _ = read_obj(self.folder / "p.obj")
            errors.append(3.14159265 - sum(volume(vertices, g["triangles"]) for g in groups))
        self.assertGreater(errors[0], 10 * errors[1])
        self.assertGreater(errors[1], 0)

    def test_collapsed_faces_have_no_triangles_without_area(self):
        model = self.build("s", {"op": "sphere", "radius": 1, "cells": "one"})
        self.render(model, "-o", "p.obj")
        [group], vertices, _ = read_obj(self.folder / "p.obj")
        for t in group["triangles"]:
            self.assertEqual(len({vertices[i] for i in t}), 3, t)

    def test_cells_that_no_certificate_holds_for_are_drawn(self):
        self.assertEqual(run("certify", FOLDED).returncode, 1)
        self.assertRegex(self.render(FOLDED, "-o", "p.png", "--size", "64,64"), "wrote  p.png  64 x 64, 1 cell\n")
        self.assertEqual(len(read_gltf(self.render_to("p.gltf", FOLDED))), 1)
        self.assertEqual(self.render(FOLDED, "-o", "q.png", "--size", "64,64", "--grid", 2, status=1)[:18], "veritope: INVALID ")

    def render_to(self, name, *arguments):
        self.render(*arguments, "-o", name)
        return self.folder / name

    def test_bytes_do_not_depend_on_threads(self):
        for suffix in ("png", "gltf", "obj", "vtu"):
            made = {self.render_to(f"{jobs}.{suffix}", CUBES, "--explode", "1/7", "--nets", "--jobs", jobs).read_bytes() for jobs in (1, 2, 3, 1)}
            self.assertEqual(len(made), 1, suffix)

    def test_the_report(self):
        report = json.loads(self.render(CUBES, "-o", "p.gltf", "--explode", "0.5", "--nets", "--json", "-"))
        self.assertEqual(report["picture"], {"path": "p.gltf", "width": None, "height": None})
        self.assertEqual(report["cells"], {"count": 2, "explode": "1/2", "nets": True})
        self.assertEqual(report["bounds"], ["-1/4", "0", "0", "9/4", "1", "1"])
        self.assertIsNone(report["grid"])
        report = json.loads(self.render(CUBES, "-o", "p.png", "--size", "64,65", "--json", "-"))
        self.assertEqual(report["picture"], {"path": "p.png", "width": 64, "height": 65})
        self.assertEqual(report["cells"], {"count": 2, "explode": "0", "nets": False})
        report = json.loads(self.render(CUBES, "-o", "p.png", "--size", "64,65", "--grid", 2, "--json", "-"))
        self.assertIsNone(report["cells"])
        self.assertEqual(report["grid"]["in"], 8)

    def test_what_is_refused_leaves_the_file_that_is_there(self):
        for name in ("p.png", "p.gltf"):
            (self.folder / name).write_text("old")
        far = self.build("far", {"op": "glue", "of": [{"op": "box", "min": ["-1e308", 0, 0], "max": ["-9e307", 1, 1]}, {"op": "box", "min": ["9e307", 0, 0], "max": ["1e308", 1, 1]}]})
        self.assertIn("far.vjson: entity 0: it would be moved beyond binary64", self.render(far, "-o", "p.png", "--explode", 3, status=4))
        self.render(far, "-o", "q.png", "--nets", "--size", "64,64")
        (self.folder / "q.png").unlink()
        self.assertIn("too large for binary32", self.render(far, "-o", "p.gltf", status=4))
        (self.folder / "mixed.vjson").write_text(self.mixed())
        for option in (["--nets"], ["--explode", 1], ["--chord", 1]):
            self.assertEqual(self.render("mixed.vjson", "-o", "p.png", *option, status=2),
                             f"veritope: {option[0]} is for files of volumes in space; mixed.vjson: entity 2: a surface, not a volume ")
        self.assertIn("UNDECIDED mixed.vjson", self.render("mixed.vjson", "-o", "p.gltf", status=3))
        self.assertIn("valid_frame.off: it is a mesh", self.render(MODELS / "valid_frame.off", "-o", "p.png", "--nets", status=2))
        self.assertIn("a trimmed surface, not a volume", self.render(MODELS / "splines" / "trimmed.itd", "-o", "p.png", "--nets", status=2))
        self.assertEqual({(self.folder / name).read_text() for name in ("p.png", "p.gltf")}, {"old"})
        self.assertEqual(self.listing(), ["cubes.json", "cubes.vjson", "far.json", "far.vjson", "mixed.vjson", "p.gltf", "p.png"])

    def mixed(self):
        document = json.loads((self.folder / CUBES).read_text())
        surface = {"degrees": [1, 1], "periodic": [False, False], "knots": [["0", "0", "1", "1"]] * 2, "rational": False, "components": 3,
                   "points": [[str(x), str(y), "5"] for x in (0, 1) for y in (0, 1)]}
        document["entities"].append({"kind": "surface", "group": None, "attributes": [], "shape": surface})
        return json.dumps(document)

    def test_volumes_in_a_plane_are_refused(self):
        model = self.build("b", {"op": "box", "min": [0, 0, 0], "max": [1, 1, 1]})
        document = json.loads((self.folder / model).read_text())
        shape = document["entities"][0]["shape"]
        shape["components"], shape["points"] = 2, [p[:2] for p in shape["points"]]
        (self.folder / model).write_text(json.dumps(document))
        self.assertIn("entity 0: a volume with 2 coordinates, not in space", self.render(model, "-o", "p.gltf", "--nets", status=2))
        self.render(model, "-o", "p.gltf", status=3)
        self.assertFalse((self.folder / "p.gltf").exists())

    def test_attributes_beside_coordinates_do_not_matter(self):
        model = self.build("b", {"op": "box", "min": [0, 0, 0], "max": [1, 1, 1]})
        self.render(model, "-o", "p.obj", "--nets")
        document = json.loads((self.folder / model).read_text())
        shape = document["entities"][0]["shape"]
        shape["components"], shape["points"] = 5, [p[:3] + ["7", "1/3"] for p in shape["points"]]
        (self.folder / "a.vjson").write_text(json.dumps(document))
        self.render("a.vjson", "-o", "q.obj", "--nets")
        self.assertEqual((self.folder / "p.obj").read_text(), (self.folder / "q.obj").read_text())


class Figures(Case):
    """examples/vrep_figures: tests/paper_examples_test.py compares what its other program prints."""

    def test_the_trees_are_those_of_the_script(self):
        folder = ROOT / "examples" / "vrep_figures"
        subprocess.run([sys.executable, folder / "make_trees.py", self.folder], check=True)
        made = {name: (self.folder / name).read_text() for name in self.listing()}
        self.assertEqual(made, {path.name: path.read_text() for path in folder.glob("figure*.tree")})


class OtherSolids(Case):
    """Meshes, surfaces and expressions in files for viewers."""

    def test_a_mesh(self):
        frame = MODELS / "valid_frame.off"
        self.render(frame, "-o", "p.gltf")
        [part] = read_gltf(self.folder / "p.gltf")
        self.assertEqual((part["name"], len(part["points"]), len(part["triangles"])), ("solid", 16, 32))
        self.assertAlmostEqual(volume(part["points"], part["triangles"]), 8, 6)
        self.render(frame, "-o", "p.obj")
        self.assertIn("VALID  p.obj  1 body, genus 1, volume 8", run("certify", "p.obj", cwd=self.folder).stdout)
        self.render(frame, "-o", "p.vtu")
        self.assertIn('NumberOfPoints="16" NumberOfCells="32"', (self.folder / "p.vtu").read_text())
        report = json.loads(self.render(frame, "-o", "p.obj", "--json", "-"))
        self.assertEqual((report["cells"], report["bounds"]), (None, ["0", "0", "0", "3", "3", "1"]))

    def test_surfaces_are_shown_as_convert_shows_them(self):
        for suffix in ("gltf", "obj", "vtu"):
            self.render(PATCHES, "-o", f"p.{suffix}")
            self.assertEqual(run("convert", PATCHES, f"q.{suffix}", cwd=self.folder).returncode, 0)
            self.assertEqual((self.folder / f"p.{suffix}").read_bytes(), (self.folder / f"q.{suffix}").read_bytes())

    def test_what_is_no_solid_is_refused(self):
        for suffix in ("gltf", "obj", "vtu"):
            self.assertIn("INVALID", self.render(MODELS / "m3_missing_face.off", "-o", f"p.{suffix}", status=1))
            self.assertIn("UNDECIDED", self.render(MODELS / "patches" / "not_certified_smallest.vjson", "-o", f"p.{suffix}", status=3))
        self.assertEqual(self.listing(), [])

    def test_expressions_have_pictures_of_pixels_only(self):
        run("boolean", "!F", f"F={MODELS / 'valid_frame.off'}", "-o", "e.json", cwd=self.folder)
        for suffix in ("gltf", "obj", "vtu"):
            self.assertIn("the picture of an expression is a .png", self.render("e.json", "-o", f"p.{suffix}", status=2))
        self.assertIn("--explode is for files of volumes; e.json is an expression", self.render("e.json", "-o", "p.png", "--explode", 0, status=2))


if __name__ == "__main__":
    unittest.main()
