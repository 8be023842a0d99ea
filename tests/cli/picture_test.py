#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""certify --picture: the model in grey, defects in the colours that the manual lists: in files for viewers tubes and octahedra, in a
PNG lines and discs that are large enough to be seen."""
import base64
import json
import math
import os
import re
import shutil
import struct
import subprocess
import unittest
import xml.etree.ElementTree
import zlib

import support
from support import INVALID, MODELS, UNREADABLE, VALID, Folder, run

GREY = (190, 190, 190)
OF_RULE = {"M1": (0, 0, 0), "M2": (0, 114, 178), "M3": (230, 159, 0), "M4": (86, 180, 233), "M5": (0, 158, 115), "M6": (204, 121, 167),
           "M7": (213, 94, 0), "M8": (240, 228, 66), "M9": (90, 60, 20)}


def read_picture(path):
    """(points, faces, colours)."""
    head, body = path.read_bytes().split(b"end_header\n", 1)
    vertices, faces = (int(line.split()[2]) for line in head.split(b"\n") if line.startswith(b"element"))
    points = [struct.unpack_from("<3d", body, 24 * i) for i in range(vertices)]
    rows = [struct.unpack_from("<B3I3B", body, 24 * vertices + 16 * i) for i in range(faces)]
    assert len(body) == 24 * vertices + 16 * faces and all(row[0] == 3 for row in rows)
    return points, [row[1:4] for row in rows], [row[4:] for row in rows]


def tint(colour):
    return tuple((3 * grey + 2 * c) // 5 for grey, c in zip(GREY, colour))


def components(faces):
    """For each face the least vertex that is connected to it."""
    parent = {}

    def find(v):
        while parent.setdefault(v, v) != v:
            parent[v] = v = parent[parent[v]]
        return v
    for f in faces:
        for v in f[1:]:
            a, b = sorted((find(f[0]), find(v)))
            parent[b] = a
    return [find(f[0]) for f in faces]


def face_colours(defects, faces):
    """Those of the faces of defects, the first one's if there are several; whole shells of M8 and M9."""
    out, shells = {}, components(faces)
    for defect in defects:
        for f in defect["faces"]:
            out.setdefault(f, tint(OF_RULE[defect["rule"]]))
            if defect["rule"] in ("M8", "M9"):
                out.update((g, tint(OF_RULE[defect["rule"]])) for g in range(len(faces)) if shells[g] == shells[f])
    return [out.get(f, GREY) for f in range(len(faces))]


def solids(points, faces, colours):
    """(colour, middle of the box, lower corner, upper corner) of each connected part."""
    parts = {}
    for name, face, colour in zip(components(faces), faces, colours):
        parts.setdefault((name, colour), []).extend(points[v] for v in face)
    out = []
    for (_, colour), corners in parts.items():
        lo, hi = ([f(p[k] for p in corners) for k in range(3)] for f in (min, max))
        out.append((colour, [(a + b) / 2 for a, b in zip(lo, hi)], lo, hi))
    return out


def six_volumes(points, faces):
    def det(a, b, c):
        return (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]))
    return sum(det(*(points[v] for v in face)) for face in faces)


class Picture(Folder):
    def setUp(self):
        super().setUp()
        self.path = self.folder / "p.ply"

    def certify(self, *arguments):
        return run("certify", "--picture", self.path, *arguments, env=self.environment)

    def test_every_rule_has_its_colour_at_the_faces_and_places_that_the_report_lists(self):
        seen = set()
        for row in support.expectations():
            if row["verdict"] != "INVALID":
                continue
            options = row["options"].split() if row["options"] != "-" else []
            with self.subTest(row["file"]):
                done = self.certify("--json", "-", "--max-defects", "20000", *options, MODELS / row["file"])
                file = json.loads(done.stdout)["files"][0]
                points, faces, colours = read_picture(self.path)
                num = file["counts"]["faces"]
                self.assertEqual(colours[:num], face_colours(file["defects"], faces[:num]))
                size = max(max(p[k] for f in faces[:num] for p in [points[v] for v in f]) -
                           min(p[k] for f in faces[:num] for p in [points[v] for v in f]) for k in range(3)) or 1
                marks = solids(points, faces[num:], colours[num:])
                for defect in file["defects"]:
                    ends = [end["decimal"] for end in defect["ends"] or [defect["point"]]]
                    middle = [sum(e[k] for e in ends) / len(ends) for k in range(3)]
                    near = [m for m in marks if m[0] == OF_RULE[defect["rule"]] and
                            all(abs(m[1][k] - middle[k]) <= 1e-9 * size + abs(middle[k]) * 1e-12 for k in range(3))]
                    self.assertTrue(near, defect["message"])
                    reach = max(abs(p - e[k]) for m in near for e in ends for k in range(3) for p in (m[2][k], m[3][k]))
                    self.assertGreaterEqual(reach, size / 400 * (1 - 1e-9))
                    seen.add(defect["rule"])
                self.assertEqual({m[0] for m in marks}, {OF_RULE[d["rule"]] for d in file["defects"]})
        self.assertEqual(seen, set(OF_RULE))

    def test_marks_are_closed_and_outward(self):
        self.certify(INVALID)
        points, faces, _ = read_picture(self.path)
        marks = faces[support.only_file(INVALID)["counts"]["faces"]:]
        self.assertTrue(marks)
        edges = [(f[i], f[(i + 1) % 3]) for f in marks for i in range(3)]
        self.assertEqual(sorted(edges), sorted((b, a) for a, b in edges))
        self.assertEqual(len(set(edges)), len(edges))
        self.assertGreater(six_volumes(points, marks), 0)

    def test_a_valid_model_is_grey_and_reads_back_as_itself(self):
        self.assertEqual(self.certify("-q", VALID).returncode, 0)
        self.assertEqual(set(read_picture(self.path)[2]), {GREY})
        kept = ("verdict", "counts", "volume", "bbox")
        ours, theirs = (support.only_file(path) for path in (self.path, VALID))
        self.assertEqual([ours[k] for k in kept], [theirs[k] for k in kept])

    def test_without_a_verdict_nothing_is_written(self):
        self.assertEqual(self.certify(UNREADABLE).returncode, 4)
        self.assertEqual(self.listing(), [])

    def test_what_cannot_be_is_wrong_usage(self):
        model = support.shutil.copy(VALID, self.folder / "m.off")
        for arguments in ([VALID, INVALID], [VALID, "--json", self.path], [VALID, "--certificate", self.path]):
            done = self.certify(*arguments)
            self.assertEqual((done.returncode, done.stdout), (2, ""), arguments)
        self.assertEqual(run("certify", VALID, "--picture", "-").returncode, 2)
        self.assertEqual(run("certify", model, "--picture", model).returncode, 2)
        self.assertEqual(self.listing(), ["m.off"])

    def test_other_endings_are_refused(self):
        for name in ("p.jpg", "png", "p.obj", "p.gltf.gz", "p."):
            done = run("certify", "--picture", self.folder / name, VALID)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn("--picture writes .png, .ply, .vtu and .gltf, not", done.stderr)
        self.assertEqual(self.listing(), [])

    def test_standard_input_is_drawn_too(self):
        with open(INVALID) as file:
            done = run("certify", "--format", "off", "--picture", self.path, "-", stdin=file)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertGreater(len(read_picture(self.path)[1]), 0)

    def test_a_picture_that_cannot_be_written_does_not_take_the_verdict_back(self):
        os.symlink("/dev/full", self.path)
        done = self.certify(VALID)
        self.assertEqual(done.returncode, 4)
        self.assertTrue(done.stdout.startswith("VALID"))
        self.assertIn(str(self.path), done.stderr)


def read_png(path):
    """(width, height, rows of bytes), decoded independently of the encoder."""
    data, at, body = path.read_bytes(), 8, b""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    while at < len(data):
        size, kind = struct.unpack_from(">I4s", data, at)
        chunk = data[at + 8:at + 8 + size]
        assert struct.unpack_from(">I", data, at + 8 + size)[0] == zlib.crc32(kind + chunk)
        if kind == b"IHDR":
            width, height, depth, colours = struct.unpack_from(">IIBB", chunk)
            assert (depth, colours) == (8, 2)
        body += chunk if kind == b"IDAT" else b""
        at += 12 + size
    raw, rows, stride = zlib.decompress(body), [], 3 * width
    above = bytearray(stride)
    for y in range(height):
        kind, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for x in range(stride) if kind else ():
            left, up, corner = (row[x - 3] if x >= 3 else 0), above[x], (above[x - 3] if x >= 3 else 0)
            p = left + up - corner
            paeth = min((left, up, corner), key=lambda v: abs(p - v))
            row[x] = (row[x] + (0, left, up, (left + up) // 2, paeth)[kind]) % 256
        rows.append(row)
        above = row
    return width, height, rows


def count_colour(rows, colour, least_row, last_row):
    want = bytes(colour)
    return sum(row[x:x + 3] == want for row in map(bytes, rows[least_row:last_row]) for x in range(0, len(row), 3))


def sphere_off(turns, rings, edit=None):
    """A sphere of triangles as OFF; `edit` may change vertices and faces."""
    points = [(0, 0, 1)] + [(math.sin(math.pi * r / rings) * math.cos(2 * math.pi * t / turns), math.sin(math.pi * r / rings) *
                             math.sin(2 * math.pi * t / turns), math.cos(math.pi * r / rings)) for r in range(1, rings) for t in range(turns)]
    points.append((0, 0, -1))
    ring = lambda r, t: 1 + (r - 1) * turns + t % turns
    faces = [(0, ring(1, t), ring(1, t + 1)) for t in range(turns)]
    for r in range(1, rings - 1):
        for t in range(turns):
            faces += [(ring(r, t), ring(r + 1, t), ring(r + 1, t + 1)), (ring(r, t), ring(r + 1, t + 1), ring(r, t + 1))]
    faces += [(ring(rings - 1, t), len(points) - 1, ring(rings - 1, t + 1)) for t in range(turns)]
    if edit:
        edit(points, faces)
    text = f"OFF {len(points)} {len(faces)} 0\n" + "".join("%r %r %r\n" % tuple(map(float, p)) for p in points)
    return text + "".join("3 %d %d %d\n" % f for f in faces)


def crack(points, faces):
    """One corner of one face moves by a few ulps."""
    a, b, c = faces[500]
    points.append((points[a][0] + 2.0 ** -50, points[a][1], points[a][2]))
    faces[500] = (len(points) - 1, b, c)


class Png(Folder):
    LEGEND = 830  # the legend stands below this row

    def marked(self, model, colour, status=1):
        """Pixels of this colour above the legend."""
        path = self.folder / "p.png"
        done = run("certify", "-q", "--picture", path, model)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        width, height, rows = read_png(path)
        self.assertEqual((width, height), (1200, 900))
        return count_colour(rows, colour, 50, self.LEGEND)

    def test_a_crack_of_a_few_ulps_covers_the_pixels_of_a_square_of_12_in_its_colour(self):
        model = self.folder / "model.off"
        model.write_text(sphere_off(40, 30, crack))
        self.assertGreaterEqual(self.marked(model, OF_RULE["M3"]), 144)

    def test_a_sound_model_has_no_marks_and_the_picture_is_named(self):
        path = self.folder / "p.png"
        done = run("certify", "--picture", path, MODELS / "patches" / "cube.itd")
        self.assertEqual(done.returncode, 0)
        self.assertIn(f"  picture      {path}\n", done.stdout)
        rows = read_png(path)[2]
        self.assertEqual([count_colour(rows, colour, 50, 900) for rule, colour in OF_RULE.items() if rule != "M1"], [0] * 8)
        self.assertEqual(support.only_file("--picture", path, VALID)["picture"], str(path))
        self.assertIsNone(support.only_file(VALID)["picture"])

    def test_a_picture_does_not_change_what_the_report_says(self):
        path = self.folder / "p.png"
        for model in (INVALID, MODELS / "patches" / "side_open_smallest.itd", MODELS / "patches" / "patches_crossing_smallest.itd"):
            for options in ([], ["--max-defects", 0], ["--max-defects", 2]):
                with_it, without = run("certify", *options, "--picture", path, model), run("certify", *options, model)
                self.assertEqual(with_it.stdout.replace(f"  picture      {path}\n", ""), without.stdout)

    def test_a_picture_that_cannot_be_drawn_does_not_take_the_verdict_back(self):
        model = self.folder / "huge.off"
        model.write_text("OFF 3 1 0\n0 0 0\n1.7e308 0 0\n0 -1.7e308 1.7e308\n3 0 1 2\n")
        done = run("certify", "-q", "--picture", self.folder / "p.png", model)
        self.assertTrue(done.stdout.startswith("INVALID"), done.stdout)
        self.assertIn(done.returncode, (1, 4))
        plates = self.folder / "plates.off"
        count = 20000
        points = "".join(f"0 0 {i}\n9e6 0 {i}\n0 9e6 {i}\n" for i in range(count))
        plates.write_text(f"OFF {3 * count} {count} 0\n{points}" + "".join(f"3 {3 * i} {3 * i + 1} {3 * i + 2}\n" for i in range(count)))
        done = run("certify", "-q", "--picture", self.folder / "q.png", plates, timeout=600)
        self.assertTrue(done.stdout.startswith("INVALID"), done.stdout)
        if not (self.folder / "q.png").exists():
            self.assertEqual(done.returncode, 1)
            self.assertIn("not drawn", done.stderr)

    def test_a_volume_is_drawn_by_its_boundary_faces(self):
        path = self.folder / "p.PNG"
        self.assertEqual(run("certify", "--picture", path, MODELS / "splines" / "two_cubes.mesh").returncode, 0)
        self.assertGreater(len(path.read_bytes()), 2000)

    def test_the_bytes_do_not_depend_on_the_number_of_threads(self):
        a, b = self.folder / "a.png", self.folder / "b.png"
        run("certify", "-q", "-j", 1, "--picture", a, INVALID)
        run("certify", "-q", "-j", 4, "--picture", b, INVALID)
        self.assertEqual(a.read_bytes(), b.read_bytes())


@unittest.skipIf(os.environ.get("VERITOPE_SANITIZE"), "sanitizers want to be loaded first")
class BugOfOurs(Folder):
    """A process in which zlib fails in a way that it never may: the program meets an internal error while it draws."""

    def test_an_internal_error_of_the_picture_is_status_5_beside_the_verdict(self):
        code, library, path = (self.folder / name for name in ("bug.c", "bug.so", "p.png"))
        code.write_text("int compress2(void* to, unsigned long* size, const void* from, unsigned long n, int level) { return -2; }\n")
        compiler = next(name for name in ("cc", "gcc", "clang") if shutil.which(name))
        subprocess.run([compiler, "-shared", "-fPIC", code, "-o", library], check=True)
        for model, verdict in ((VALID, "VALID"), (INVALID, "INVALID")):
            json_file = self.folder / "r.json"
            done = run("certify", "-q", "--picture", path, "--json", json_file, "--certificate", self.folder / "c", model,
                       env={**self.environment, "LD_PRELOAD": str(library)})
            self.assertEqual((done.returncode, path.exists()), (5, False), done)
            self.assertTrue(done.stdout.startswith(f"{verdict}  "), done.stdout)
            self.assertRegex(done.stderr, r"^veritope: \S+/p\.png: not drawn: .*please report it")
            file = json.loads(json_file.read_text())["files"][0]
            self.assertEqual((file["verdict"], file["exit"], file["picture"]), (verdict, 5, None))
            self.assertEqual(run(model, self.folder / "c", program=support.BIN / "veritope-check").returncode, 0)


def read_vtu(path):
    """(points, triangles, colours, names of the parts, part of each triangle)."""
    grid = xml.etree.ElementTree.parse(path).find("UnstructuredGrid")
    arrays = {a.get("Name"): [float(x) if a.get("type") == "Float64" else int(x) for x in a.text.split()] for a in grid.iter("DataArray")}
    rows = lambda name, n: [tuple(arrays[name][i:i + n]) for i in range(0, len(arrays[name]), n)]
    names = bytes(arrays["parts"]).split(b"\0")[:-1]
    assert set(arrays["types"]) == {5} and arrays["offsets"] == list(range(3, 3 * len(arrays["types"]) + 1, 3))
    return rows("Points", 3), rows("connectivity", 3), rows("colour", 4), [n.decode() for n in names], arrays["part"]


def read_gltf(path):
    """(points in space, triangles, sRGB colours and opacities, names of the nodes, node of each triangle)."""
    gltf = json.loads(path.read_text())
    data = base64.b64decode(gltf["buffers"][0]["uri"].split(",")[1], validate=True)
    assert len(data) == gltf["buffers"][0]["byteLength"]

    def values(number, letter, n):
        accessor = gltf["accessors"][number]
        view = gltf["bufferViews"][accessor["bufferView"]]
        assert view["byteOffset"] % 4 == 0 and view["byteLength"] == 4 * n * accessor["count"]
        flat = struct.unpack_from(f"<{n * accessor['count']}{letter}", data, view["byteOffset"])
        return [flat[i:i + n] for i in range(0, len(flat), n)]
    root = gltf["nodes"][gltf["scenes"][gltf["scene"]]["nodes"][0]]
    points, faces, colours, names, parts = [], [], [], [], []
    for number, child in enumerate(root["children"]):
        node = gltf["nodes"][child]
        names.append(node["name"])
        [primitive] = gltf["meshes"][node["mesh"]]["primitives"]
        material = gltf["materials"][primitive["material"]]
        assert primitive["mode"] == 4 and material["name"] == node["name"] and material["doubleSided"]
        *linear, opacity = material["pbrMetallicRoughness"]["baseColorFactor"]
        assert (material.get("alphaMode") == "BLEND") == (opacity < 1)
        srgb = tuple(round(255 * (12.92 * c if c <= 0.0031308 else 1.055 * c ** (1 / 2.4) - 0.055)) for c in linear)
        corners = values(primitive["attributes"]["POSITION"], "f", 3)
        box = gltf["accessors"][primitive["attributes"]["POSITION"]]
        assert (box["min"], box["max"]) == ([min(c) for c in zip(*corners)], [max(c) for c in zip(*corners)])
        faces += [index + len(points) for (index,) in values(primitive["indices"], "I", 1)]
        points += [tuple(a + b for a, b in zip(p, root["translation"])) for p in corners]
        count = gltf["accessors"][primitive["indices"]]["count"] // 3
        colours += [(*srgb, round(255 * opacity))] * count
        parts += [number] * count
    return points, [tuple(faces[i:i + 3]) for i in range(0, len(faces), 3)], colours, names, parts


class Viewers(Folder):
    """The three files for viewers have one content."""

    def corners(self, points, faces, colours):
        """The coloured triangles."""
        return [(colour[:3], *(x for v in face for x in points[v])) for face, colour in zip(faces, colours)]

    def test_they_show_the_same_triangles_and_name_the_parts_by_the_legend(self):
        for model in (INVALID, MODELS / "m2_smallest.off", MODELS / "patches" / "side_open_crack.itd",
                      MODELS / "patches" / "patches_crossing_smallest.itd", VALID, MODELS / "splines" / "two_cubes.mesh"):
            paths = [self.folder / f"p.{kind}" for kind in ("ply", "vtu", "gltf")]
            for path in paths:
                done = run("certify", "--picture", path, model)
                self.assertIn(done.returncode, (0, 1), done.stderr)
                self.assertIn(f"  picture      {path}\n", done.stdout)
            ply, vtu, gltf = read_picture(paths[0]), read_vtu(paths[1]), read_gltf(paths[2])
            self.assertEqual(sorted(self.corners(*ply)), sorted(self.corners(*vtu[:3])), model)
            size = max(abs(x) for p in vtu[0] for x in p)
            for exact, rounded in zip(self.corners(*vtu[:3]), self.corners(*gltf[:3])):
                self.assertEqual(exact[0], rounded[0])
                self.assertLessEqual(max(abs(a - b) for a, b in zip(exact[1:], rounded[1:])), size * 2.0 ** -22, model)
            self.assertEqual(len(vtu[1]), len(gltf[1]))
            self.assertEqual((vtu[3], vtu[4]), (gltf[3], gltf[4]))
            self.assertEqual(vtu[2], gltf[2])
            is_broken = done.returncode == 1
            self.assertEqual({c[3] for c in vtu[2]}, {170, 255} if is_broken else {255})
            legend = [line.split(b": ", 1)[1].decode() for line in paths[0].read_bytes().split(b"end_header")[0].split(b"\n")
                      if line.startswith(b"comment colour")]
            self.assertEqual(is_broken, bool(legend))
            self.assertEqual([name for name in vtu[3] if name in legend], legend)
            self.assertTrue(all(name.startswith(("model", "entity ")) for name in vtu[3] if name not in legend), vtu[3])

    def test_their_bytes_do_not_depend_on_the_number_of_threads(self):
        for kind in ("ply", "vtu", "gltf"):
            a, b = self.folder / f"a.{kind}", self.folder / f"b.{kind}"
            for jobs, path in ((1, a), (4, b)):
                run("certify", "-q", "-j", jobs, "--picture", path, INVALID)
            self.assertEqual(a.read_bytes(), b.read_bytes())

    def test_trimmed_models_have_no_verdict_and_so_no_picture(self):
        for kind in ("png", "ply", "vtu", "gltf"):
            done = run("certify", "--picture", self.folder / f"p.{kind}", MODELS / "splines" / "trimmed.itd", env=self.environment)
            self.assertEqual(done.returncode, 3, done.stdout)
            self.assertEqual(self.listing(), [])

    def test_what_binary32_cannot_hold_is_refused_as_gltf_beside_the_verdict(self):
        model = self.folder / "huge.off"
        model.write_text("OFF 4 4 0\n0 0 0\n1e40 0 0\n0 1e40 0\n0 0 1e40\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n")
        done = run("certify", "-q", "--picture", self.folder / "p.gltf", model)
        self.assertEqual((done.returncode, done.stdout[:5]), (4, "VALID"))
        self.assertIn("too large for binary32", done.stderr)
        self.assertEqual(run("certify", "-q", "--picture", self.folder / "p.vtu", model).returncode, 0)


try:
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError:
    vtkXMLUnstructuredGridReader = None


class ReadersOfOthers(Folder):
    """Programs that others wrote read the files for viewers, where they are installed (Debian: python3-vtk9, assimp-utils)."""
    MODELS = (INVALID, MODELS / "patches" / "patches_crossing_smallest.itd", MODELS / "splines" / "two_cubes.mesh")

    def picture(self, model, kind):
        path = self.folder / f"p.{kind}"
        self.assertIn(run("certify", "-q", "--picture", path, model).returncode, (0, 1))
        return path

    @unittest.skipUnless(vtkXMLUnstructuredGridReader, "VTK for Python is not installed")
    def test_vtk_reads_the_triangles_their_colours_and_the_names_of_the_parts(self):
        for model in self.MODELS:
            path = self.picture(model, "vtu")
            reader = vtkXMLUnstructuredGridReader()
            reader.SetFileName(str(path))
            reader.Update()
            points, triangles, colours, names, parts = read_vtu(path)
            grid = reader.GetOutput()
            self.assertEqual((reader.GetErrorCode(), grid.GetNumberOfPoints(), grid.GetNumberOfCells()), (0, len(points), len(triangles)))
            self.assertEqual([tuple(grid.GetCell(i).GetPointId(k) for k in range(3)) for i in range(len(triangles))], triangles)
            cells = grid.GetCellData()
            colour = cells.GetArray("colour")
            self.assertEqual([tuple(map(int, colour.GetTuple(i))) for i in range(len(triangles))], colours)
            self.assertEqual([int(cells.GetArray("part").GetTuple1(i)) for i in range(len(triangles))], parts)
            self.assertEqual(grid.GetFieldData().GetNumberOfArrays(), 1)

    @unittest.skipUnless(shutil.which("assimp"), "assimp is not installed")
    def test_assimp_reads_the_triangles_and_the_parts(self):
        for model in self.MODELS:
            path = self.picture(model, "gltf")
            done = run("info", path, program="assimp")
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            points, triangles, _, names, _ = read_gltf(path)
            found = dict(re.findall(r"^(Meshes|Faces|Primitive Types): +(\w+)", done.stdout, re.MULTILINE))
            self.assertEqual(found, {"Meshes": str(len(names)), "Faces": str(len(triangles)), "Primitive Types": "triangles"})


if __name__ == "__main__":
    support.main()
