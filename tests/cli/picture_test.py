#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""certify --picture: the model in grey, defects in the colours that the manual lists, an octahedron around each."""
import struct
import unittest

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

    def test_a_picture_that_cannot_be_written_does_not_take_the_verdict_back(self):
        done = run("certify", VALID, "--picture", "/dev/full")
        self.assertEqual(done.returncode, 4)
        self.assertTrue(done.stdout.startswith("VALID"))
        self.assertIn("/dev/full", done.stderr)


if __name__ == "__main__":
    support.main()
