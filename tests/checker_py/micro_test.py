#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The Python checker of microstructure-1: microstructures of known numbers, files that the page of the format forbids, limits.
tests/mutation/micro_liars.py has a lie for every condition."""
import json
import pathlib
import sys
import unittest
from fractions import Fraction as Q

import vmodel_models as models

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests" / "support"), str(ROOT / "verify" / "checker")]
import micro_examples as examples                         # noqa: E402
from veritope_checker import program                      # noqa: E402

UNIT = examples.UNIT


def grid_of(counts):
    return 0, [[Q(i, n) for i in range(n + 1)] for n in counts]


def same_walls(counts, number):
    size = counts[0] * counts[1] * counts[2]
    return [[number] * (size // n * (n + 1)) for n in counts]


def micro(counts=(2, 1, 1), cells=None, number=7, tiles=None, cage="cube"):
    size = counts[0] * counts[1] * counts[2]
    tiles = tiles or [examples.jack()]
    walls = [same_walls(counts, number)] if any(tile.extent for tile in tiles) else None
    return examples.Micro(models.honest(cage), [grid_of(counts)], tiles, [cells or [0] * size], walls)


class MicroTest(unittest.TestCase):
    def says(self, expected, text, certificate, skip=()):
        code, line = program._check(text, certificate, frozenset(skip))
        self.assertEqual(line.split(":")[0].replace("REJECT ", "").replace("ACCEPT microstructure-1", "ACCEPT"), expected, line)
        self.assertEqual(code, {"ACCEPT": 0, "ERROR": 4}.get(expected, 1), line)

    def judged(self, expected, plan, **values):
        plan = plan if plan.values else plan.settled()
        self.says(expected, plan.text(), plan.certificate(**values))

    # ------------------------------------------------------------ numbers

    def test_numbers_that_are_known(self):
        for counts, numbers in (((1, 1, 1), (1, 1, 0, 1, 1, 0, 0)), ((2, 1, 1), (2, 2, 1, 1, 1, 0, 0)), ((2, 2, 1), (4, 4, 4, 1, 1, 1, 0)),
                                ((2, 2, 2), (8, 8, 12, 1, 1, 5, 0))):
            plan = micro(counts).settled()
            self.assertEqual(tuple(plan.values[key] for key in examples.KEYS), numbers)
            self.judged("ACCEPT", plan)
        self.judged("ACCEPT", micro((3, 1, 1), [0, None, None, ], 0).changed(walls=[walls_beside_first(3)]).settled())

    def test_a_ring_of_one_tile_has_genus_one(self):
        plan = models.honest("a ring")
        breaks = [sorted(set(t)) for t in plan.maps[0].knots]
        counts = [len(b) - 1 for b in breaks]
        ring = examples.Micro(plan, [(0, breaks)], [examples.jack(grows=Q(0))], [[0] * counts[0]]).settled()
        self.assertEqual((ring.values["genus"], ring.values["glued_caps"]), (1, counts[0]))
        self.judged("ACCEPT", ring)

    def test_voids_between_caps_are_shells(self):
        kinds = ["ring" if wall < 2 else "centre" if wall == 2 else "none" for wall in range(6)]
        tile = examples.lattice_tile(7, [examples.pattern(kind, 7) for kind in kinds])
        plan = micro((2, 1, 1), tiles=[tile]).settled()
        self.assertEqual((plan.values["components"], plan.values["shells"], plan.values["genus"]), (1, 2, 0))
        self.judged("ACCEPT", plan)

    def test_a_file_without_cells_or_tiles_in_them(self):
        plan = micro((1, 1, 1))
        self.judged("ACCEPT", plan.changed(grids=[], cells=[], walls=[]).settled())
        self.judged("ACCEPT", plan.changed(cells=[[None]], walls=[same_walls((1, 1, 1), 0)]).settled())

    def test_every_number_of_the_statement_counts(self):
        plan = micro((2, 2, 1)).settled()
        for key in examples.KEYS:
            self.judged("W3", plan, **{key: plan.values[key] + 1})

    # ------------------------------------------------------------ the file

    def refused(self, change):
        """change: of the text, or of the JSON."""
        plan = micro((2, 1, 1), number=UNIT).settled()
        made = json.loads(plan.text())
        changed = change(plan.text().decode(), made)
        text = (changed if isinstance(changed, str) else json.dumps(made)).encode()
        self.assertNotEqual(text, plan.text())
        plan.made = text
        self.says("ERROR", text, plan.certificate())

    def test_the_file_may_be_written_in_other_ways(self):
        plan = micro((2, 1, 1), number=UNIT).settled()
        plan.made = json.dumps(json.loads(plan.text())).encode()
        self.judged("ACCEPT", plan)
        plan.made = plan.text().replace(b'"1/2"', b'"0.50"')
        self.judged("ACCEPT", plan)
        plan = plan.changed(model={"name": "\u00e9 \" \\", "sha256": "0a" * 32})
        self.judged("ACCEPT", plan)

    def test_forbidden_files_are_refused(self):
        def of_tile(key, value):
            return lambda text, made: made["tiles"][0].update({key: value})

        def of_patch(key, value, n=0):
            return lambda text, made: made["tiles"][0]["patches"][n].update({key: value})

        def of_grid(key, value):
            return lambda text, made: made["grids"][0].update({key: value})

        def of_file(key, value):
            return lambda text, made: made.update({key: value})
        half, unit = ["0", "1/2", "1"], ["0", "1"]
        points = [[["1/2"] * 3] * 4]
        for n, change in enumerate((
                of_file("format", "veritope-micro-2"), of_file("more", 1), of_file("model", {}), of_file("model", "a"),
                of_file("model", {"name": "a", "sha256": "0A" * 32}), of_file("model", {"name": "a", "sha256": "0a" * 31}),
                of_file("model", {"name": "\ud800", "sha256": "0a" * 32}),
                of_file("cage", None), of_file("grids", {}), of_file("tiles", []), of_file("cells", []), of_file("walls", []),
                lambda text, made: made.pop("walls") and None, lambda text, made: text.replace('"model": null,\n', "") + " ",
                lambda text, made: text[:-2] + ', "walls": []}', lambda text, made: text + "x", lambda text, made: text[:-3],
                of_grid("volume", 1), of_grid("volume", -1), of_grid("volume", "0"), of_grid("volume", True), of_grid("breaks", [half, unit]),
                of_grid("breaks", [["0", "1/2", "1/2"], unit, unit]), of_grid("breaks", [["0", "1/2", "5/4"], unit, unit]),
                of_grid("breaks", [["0", "1/2", 1], unit, unit]), of_grid("breaks", [["0", "1/2", "1/0"], unit, unit]),
                of_grid("breaks", [["-1/2", "1/2", "1"], unit, unit]), of_grid("breaks", [half, ["1"], unit]),
                lambda text, made: made["grids"].append(made["grids"][0]) or made["cells"].append(made["cells"][0]) or
                made["walls"].append(made["walls"][0]),
                of_tile("range", None), of_tile("range", [1, 0]), of_tile("range", [0, UNIT + 1]), of_tile("range", [0]), of_tile("name", 1),
                of_tile("patches", []), of_tile("more", 1), of_tile("range", [-1, UNIT]),
                of_patch("wall", 6), of_patch("wall", -1), of_patch("wall", None), of_patch("degrees", [0, 1]), of_patch("degrees", [8, 1]),
                of_patch("degrees", [1]), of_patch("degrees", [1, 2]), of_patch("points", []), of_patch("points", points * 5),
                of_patch("points", [[["1/2"] * 3] * 3]), of_patch("points", [[["1/2"] * 2] * 4]), of_patch("points", [[[0] * 3] * 4]),
                of_patch("points", [[["1/%d" % (1 << 128)] * 3] * 4]), of_patch("points", [[[str(1 << 128)] * 3] * 4]), of_patch("more", 1),
                of_file("cells", [["e"]]), of_file("cells", [["C"]]), of_file("cells", [["c0"]]), of_file("cells", [[""]]), of_file("cells", [["c", "0"]]),
                of_file("cells", [[]]), of_file("cells", [["g"]]), of_file("cells", [[12]]), of_file("cells", [["\u0663"]]),
                lambda text, made: text.replace("[1048576,1048576,", "[1048577,1048576,"), lambda text, made: text.replace("[1048576,", "[01,"),
                lambda text, made: text.replace("[1048576,", "[1.0,"), lambda text, made: text.replace("[1048576,", "[1e3,"),
                lambda text, made: text.replace("[1048576,", "[-1,"), lambda text, made: text.replace("[1048576,", "[true,"),
                lambda text, made: text.replace("[1048576,", '["1",'), lambda text, made: text.replace("[1048576,", "[1,1,"),
                lambda text, made: text.replace("[1048576,", "["), lambda text, made: text.replace("[1048576,", "[NaN,"),
                lambda text, made: made["walls"][0].pop() and None, lambda text, made: made["walls"].append([[], [], []]))):
            with self.subTest(n):
                self.refused(change)

    def test_two_tiles_in_a_cell_and_numbers_beside_no_tile_are_refused(self):
        plan = micro((2, 1, 1), tiles=[examples.jack(), examples.jack()]).settled()
        for cells, expected in ((["8", "4"], "ACCEPT"), (["c", "4"], "ERROR"), (["8", "0"], "ERROR")):
            made = json.loads(plan.text())
            made["cells"] = [cells]
            lie = plan.changed()
            lie.made = json.dumps(made).encode()
            self.says(expected, lie.text(), lie.certificate())

    def test_a_cage_without_a_knot_among_the_breaks_is_refused(self):
        plan = models.honest("a ring")
        knots = [sorted(set(t)) for t in plan.maps[0].knots]
        tile = examples.jack(grows=Q(0))
        for breaks, expected in ((knots[0], "ACCEPT"), (knots[0][:1] + knots[0][2:], "ERROR"), (knots[0][1:3], "ACCEPT")):
            ring = examples.Micro(plan, [(0, [breaks, *knots[1:]])], [tile], [[0] * (len(breaks) - 1)])
            ring.values = dict.fromkeys(examples.KEYS, 0) if expected == "ERROR" else ring.truth()
            self.says(expected, ring.text(), ring.certificate())

    def test_what_is_no_volume_is_refused(self):
        plan = micro((1, 1, 1)).settled()
        made = json.loads(plan.text())
        for change in ({"kind": "surface"}, {"group": 0}, {"more": 1}):
            other = json.loads(plan.text())
            other["cage"]["entities"][0].update(change)
            plan.made = json.dumps(other).encode()
            self.says("ERROR", plan.made, plan.certificate())
        self.assertEqual(made["cage"]["format"], "veritope-spline-1")

    # ------------------------------------------------------------ limits

    def test_a_surface_between_the_exit_and_the_wall(self):
        plan = micro((1, 1, 1), tiles=[examples.jack(grows=Q(0))])
        tile = plan.tiles[0]
        inner = [(wall, degrees, [[[Q(1, 2) + (Q(c) - Q(1, 2)) / 4 for c in p] for p in lists[0]]]) for wall, degrees, lists in tile.patches]
        tile.patches += inner
        self.judged("F2", plan)
        tile.exit += len(inner)
        self.judged("F2", plan)

    def test_patches_whose_coefficients_are_too_long(self):
        plan = micro((1, 1, 1), tiles=[examples.jack(grows=Q(0))])
        tile = plan.tiles[0]
        patch = tile.patches[0]
        for k in range(6):
            patch = examples.raised(examples.raised(patch, 0), 1)
        primes = iter([p for p in range(10 ** 6, 10 ** 6 + 5000) if all(p % d for d in range(2, 1001))])
        points = [[c + Q(1, next(primes) ** 3) for c in point] for point in patch[2][0]]
        tile.patches[0] = patch[0], patch[1], [points]
        self.judged("B2", plan)

    def test_a_large_grid_of_graded_tiles(self):
        n = 12
        plan = examples.large(n, models.honest("cube"))
        pairs = 3 * n * n * (n - 1)
        self.judged("ACCEPT", plan.changed(values={"cells": n ** 3, "tiles": n ** 3, "glued_caps": pairs, "components": 1, "shells": 1,
                                                   "genus": 1 - (n ** 3 - pairs), "bridges": 0}))


def walls_beside_first(n):
    """The numbers of a row of n cells along the first axis, of which the first one holds a tile."""
    return [[5, 5] + [0] * (n - 1), ([5, 5] + [0] * (2 * n - 2)), ([5, 5] + [0] * (2 * n - 2))]


if __name__ == "__main__":
    unittest.main()
