#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The Python checker of star-box certificates of version 2: flat patches and mesh boxes."""
import unittest
from fractions import Fraction as Q

import star_box_2_models as models2
import star_box_forge as forge
from star_box_2_judged import Judged, replaced, Box2, Prover2, UNIT, units

from veritope_checker.patches import star_box_2_flat as flat


class FlatPatches(Judged):
    def test_a_patch_that_bulges(self):
        for lift, good in (((0, Q(1, 8), -Q(1, 4)), True), ((Q(1, UNIT), 0, 0), False), ((-Q(1, 4), 0, 0), False)):
            entities = models2.blocks(lift=lambda rows, lift=lift: models2.biquadratic(rows, lift))
            prover = models2.star_and_mesh(entities, (-Q(1, 2), -Q(1, 2), 1))
            if good:
                self.says("ACCEPT", prover.prove())
                continue
            with replaced((flat, "lies_in_plane", lambda *_: True)):
                prover.prove()
            self.alone("C4", prover, None, (flat, "lies_in_plane", lambda *_: True))

    # PROVES STAR-6
    def test_a_patch_that_folds(self):
        """Its middle control point lies in its plane, far beyond its sides."""
        def lift(rows):
            (a, _), (c, _) = rows
            return models2.biquadratic(rows, [6 * (y - x) for x, y in zip(a, c)])
        prover = models2.star_and_mesh(models2.blocks(lift=lift), (-Q(1, 2), -Q(1, 2), 1))
        with replaced((flat, "is_unfolded", lambda *_: True)):
            prover.prove()
        self.alone("C4", prover, None, (flat, "is_unfolded", lambda *_: True))

    def test_a_corner_on_a_side(self):
        """A prism over a triangle, with four walls: at one corner of the section the angle is straight."""
        section = [(0, 0), (1, 0), (2, 0), (0, 2)]
        caps = [[[(*section[1], z), (*section[0], z)], [(*section[2], z), (*section[3], z)]] for z in (0, 1)]
        walls = [[[(*p, 0), (*p, 1)], [(*q, 0), (*q, 1)]] for p, q in zip(section, section[1:] + section[:1])]
        entities = [forge.surface(rows) for rows in [caps[1], [list(c) for c in zip(*caps[0])], *walls]]
        wall = Box2(0, units(Q(1, 4), -Q(1, 8), Q(1, 8)), units(Q(3, 4), Q(1, 8), Q(7, 8)), [[units(Q(1, 2), Q(1, 16), Q(1, 2)), units(Q(1, 2), -Q(1, 16), Q(1, 2))]])
        prover = Prover2(entities, [wall, Box2(1, units(-4, -4, -4), units(4, 4, 4))], roots=2, deepest=1)
        with replaced((flat, "is_convex", lambda *_: True)):
            prover.prove()
        self.alone("C4", prover, None, (flat, "is_convex", lambda *_: True))

    def test_a_side_that_is_curved(self):
        """A mesh box inside the cap of a prism."""
        mesh = Box2(1, units(-Q(5, 16), -Q(5, 16), Q(7, 8)), units(Q(5, 16), Q(5, 16), Q(9, 8)))

        class Deep(Prover2):
            def star_box(self, node):
                return None if node.patch.index == 0 and node.level < 3 else super().star_box(node)

        prover = Deep(models2.prism(models2.barrel), [mesh], search=True)
        with replaced((flat, "has_straight_sides", lambda *_: True)):
            prover.prove()
        self.assertTrue(any(box.kind for box in prover.plan.boxes))
        self.alone("C4", prover, None, (flat, "has_straight_sides", lambda *_: True))

    def polygon(self, rows):
        return flat.polygon_of(Prover2([forge.surface(rows)], checked=False).patches[0])

    def test_polygons(self):
        square = [[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]]
        to_units = [tuple(units(*p)) for p in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0))]
        self.assertEqual(self.polygon(square), to_units)
        self.assertEqual(self.polygon(models2.biquadratic(square)), to_units)
        self.assertIsNotNone(self.polygon([list(c) for c in zip(*square)]))
        for corner in ((Q(1, 2), Q(1, 2), 0), (Q(1, 4), Q(1, 4), 0), (0, 0, 0), (1, 0, 0), (0, -1, 0), (1, 1, 1)):
            self.assertIsNone(self.polygon([square[0], [(1, 0, 0), corner]]), corner)
        collapsed = [[(0, 0, 0), (0, 0, 0)], square[1]]
        self.assertIsNone(self.polygon(collapsed))
        crossed = [[(0, 0, 0), (1, 1, 0)], [(1, 0, 0), (0, 1, 0)]]
        self.assertIsNone(self.polygon(crossed))
        # a side that goes beyond its end and comes back
        beyond = [[(0, 0, 0), (0, Q(1, 2), 0), (0, 1, 0)], [(3, 0, 0), (3, Q(1, 2), 0), (Q(1, 2), 1, 0)], [(1, 0, 0), (1, Q(1, 2), 0), (1, 1, 0)]]
        self.assertIsNone(self.polygon(beyond))

    def test_triangles(self):
        def polygon(points, degree, **options):
            return flat.polygon_of(Prover2([forge.triangle(points, degree, **options)], checked=False).patches[0])
        self.assertEqual(polygon([(0, 0, 1), (1, 0, 1), (0, 1, 1)], 1), [tuple(units(*p)) for p in ((0, 0, 1), (1, 0, 1), (0, 1, 1))])
        self.assertIsNone(polygon([(0, 0, 1), (1, 1, 1), (2, 2, 1)], 1))
        good = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (2, 0, 0), (1, 1, 0), (0, 2, 0)]
        self.assertEqual(len(polygon(good, 2)), 3)
        self.assertIsNone(polygon([(*p, 1) for p in good], 2, rational=True))
        for i, p in ((1, (1, Q(1, 8), 0)), (4, (1, 1, Q(1, 8))), (1, (3, 0, 0)), (4, (4, -2, 0))):
            self.assertIsNone(polygon(good[:i] + [p] + good[i + 1:], 2), (i, p))

    def test_a_mesh_box_in_a_frame_tests_the_mapped_triangles(self):
        """Two squares that cross at x = 2 to 3; the frame multiplies by 8."""
        def crossing(x):
            return [forge.surface([[(a, -1, z), (a, 1, z)] for a, z in ((x, 0), (x + 1, 0))]),
                    forge.surface([[(a, 0, -1), (a, 0, 1)] for a in (x, x + 1)])]
        frame, box = ((8, 0, 0), (0, 8, 0), (0, 0, 8)), Box2(1, units(16, -8, -8), units(24, 8, 8), frame=1)
        for x, expected in ((2, "C4"), (16, "")):
            self.one_box(expected, crossing(x), box, frames=[frame])
            # a triangle in the plane x + y + z = const that misses the box, although its hull meets it
            corner = forge.triangle([(x + 4, 0, 0), (x, 4, 0), (x, 0, 4)])
            self.one_box("", [corner, crossing(x)[0]], box, frames=[frame])

    def test_the_two_triangles_of_a_patch_and_those_of_its_neighbours(self):
        """Contacts count by X, not by position: blocks that touch along an edge, and at a vertex."""
        for cells in (((0, 0, 0), (1, 1, 0)), ((0, 0, 0), (1, 1, 1))):
            entities = [face for cell in cells for face in models2.cuboid(cell, [c + 1 for c in cell])]
            prover = models2.star_and_mesh(entities, (Q(1, 2), Q(1, 2), 1), checked=False)
            mesh = Box2(1, units(-1, -1, -1), units(3, 3, 3))
            self.assertIn("do not meet properly", prover.reason(mesh))
        cube = Prover2(models2.cuboid((0, 0, 0), (1, 1, 1)))
        self.assertEqual(cube.reason(Box2(1, units(-1, -1, -1), units(3, 3, 3))), "")

if __name__ == "__main__":
    unittest.main()
