#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""certify --picture: the model in grey, defects in the colours that the manual lists: in a PLY an octahedron around each, in a PNG lines
and discs that are large enough to be seen."""
import json
import math
import os
import shutil
import struct
import subprocess
import unittest
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

    def test_every_rule_has_its_colour_at_the_faces_and_points_that_the_report_lists(self):
        seen = set()
        for row in support.expectations():
            if row["verdict"] != "INVALID":
                continue
            options = row["options"].split() if row["options"] != "-" else []
            with self.subTest(row["file"]):
                done = self.certify("--json", "-", *options, MODELS / row["file"])
                file = support.json.loads(done.stdout)["files"][0]
                points, faces, colours = read_picture(self.path)
                num, last = file["counts"]["faces"], len(faces)
                expected = {}
                for defect in file["defects"]:
                    for f in defect["faces"]:
                        expected.setdefault(f, OF_RULE[defect["rule"]])
                self.assertEqual(colours[:num], [expected.get(f, GREY) for f in range(num)])
                self.assertEqual(last, num + 8 * len(file["defects"]))
                for i, defect in enumerate(file["defects"]):
                    mine = range(num + 8 * i, num + 8 * i + 8)
                    self.assertEqual({colours[f] for f in mine}, {OF_RULE[defect["rule"]]})
                    corners = [points[v] for v in sorted({v for f in mine for v in faces[f]})]
                    self.assertEqual(len(corners), 6)
                    size = max(abs(a) for p in points for a in p)
                    for k, at in enumerate(defect["point"]["decimal"]):
                        self.assertAlmostEqual(sum(p[k] for p in corners) / 6 / size, at / size, places=12)
                    seen.add(defect["rule"])
        self.assertEqual(seen, set(OF_RULE))

    def test_markers_are_closed_and_outward(self):
        self.certify(INVALID)
        points, faces, colours = read_picture(self.path)
        marker = faces[-8:]
        edges = [(f[i], f[(i + 1) % 3]) for f in marker for i in range(3)]
        self.assertEqual(sorted(edges), sorted((b, a) for a, b in edges))
        self.assertEqual(len(set(edges)), 24)
        self.assertGreater(six_volumes(points, marker), 0)

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

    def test_a_folder_that_is_not_there_is_found_before_the_work(self):
        done = run("certify", VALID, "--picture", self.folder / "new" / "p.ply")
        self.assertEqual((done.returncode, done.stdout), (4, ""))

    def test_other_endings_and_plys_of_splines_are_refused(self):
        for name, model, words in [("p.jpg", VALID, "--picture writes .png and .ply"), ("png", VALID, "--picture writes .png and .ply"),
                                   ("p.ply", MODELS / "patches" / "cube.itd", "use .png")]:
            done = run("certify", "--picture", self.folder / name, model)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn(words, done.stderr)
        self.assertEqual(self.listing(), [])

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


if __name__ == "__main__":
    support.main()
