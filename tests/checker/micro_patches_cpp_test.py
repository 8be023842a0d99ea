#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The C++ checker of micro-inside-1: sweeps, in meshes and in spline models, and all about spline models. The tests about meshes are asked about
spline models with the same faces, too. VERITOPE_CHECK names the checker, VERITOPE the program that certifies cages and models."""
import itertools
import json
import os
import random
import unittest
from fractions import Fraction as Q

import micro_cpp_test as base
import micro_files as mf
import micro_inside_cpp_test as inside
from micro_files import HALF, Grid, Mesh, Micro, Patch, Patches, Sweep, Void
from micro_inside_cpp_test import INNER, middle, numbers_of
from micro_sweeps_cpp_test import straight

KINDS = (Mesh, Patches)


def box(kind, half, centre=HALF):
    return kind().box((centre - half,) * 3, (centre + half,) * 3)


def weighted():
    """Weights of corners that are far from 1."""
    solid = Patches()
    solid.weight = lambda p: 1 + abs(Q(p[0])) * 3 + abs(Q(p[1])) / 7
    return solid


def triangles():
    solid = Patches()
    solid.are_triangles = True
    return solid


class InPatches(inside.Judged):
    """A tile in boxes of six patches."""

    def test_a_tile_in_a_box(self):
        for half in (Q(1, 5), HALF, 3, Q(1, 6) + Q(1, 1 << 30)):
            self.accept(middle(), box(Patches, half))
        for half in (Q(1, 6), Q(1, 6) - Q(1, 1 << 30), Q(1, 8)):
            self.reject(middle(), box(Patches, half), "I1")

    def test_rational_patches_and_triangles(self):
        for kind in (weighted, triangles):
            for half in (Q(1, 5), 3, Q(1, 6) + Q(1, 1 << 28)):
                self.accept(middle(), box(kind, half))
            for half in (Q(1, 6), Q(1, 8)):
                self.reject(middle(), box(kind, half), "I1")
            self.reject(middle(), kind().box((2, 2, 2), (3, 3, 3)), "I2")
            hole = ((Q(1, 8),) * 3, (Q(1, 4),) * 3)
            solid = box(kind, HALF).box(*hole, inward=True)
            self.accept(middle(), solid, voids=[Void((Q(3, 16), Q(7, 32), Q(13, 64)))])
            self.reject(middle(), solid, "I3", voids=[Void((Q(3, 32), Q(7, 32), Q(13, 64)))])
            micro = middle()
            micro.sweeps = [straight((Q(1, 4), 0, 0), 13, 1, speed=8)]
            self.accept(micro, box(kind, Q(7, 16)), skin="1/30")
            self.reject(micro, box(kind, Q(7, 16)), "I4", skin="1/49")

    def test_outside(self):
        self.reject(middle(), Patches().box((2, 2, 2), (3, 3, 3)), "I2")
        self.reject(middle(), Patches().box((Q(1, 3), 0, 0), (Q(3, 4), 1, 1)), "I1")
        far = Patches().box((2, 2, 2), (3, 3, 3)).box((0, 0, 0), (1, 1, 1))
        self.accept(middle(), far)
        self.reject(middle(), box(Patches, Q(1, 32)), "I2")    # it lies in the tile's core: their surfaces do not meet

    def test_each_shell_counts(self):
        two = inside.one_of(5, [(1, 1, 1), (3, 1, 1)])
        for lo, hi, verdict in ((Q(1, 10), Q(9, 10), True), (Q(1, 10), HALF, False), (HALF, Q(9, 10), False)):
            solid = Patches().box((lo, Q(1, 10), Q(1, 10)), (hi, HALF, HALF))
            self.accept(two, solid, (2, 0, 2, 2, 0)) if verdict else self.reject(two, solid, "I2")

    def test_blocks(self):
        cells = list(itertools.product((1, 2), repeat=3))
        self.accept(inside.one_of(4, cells), box(Patches, Q(3, 10)), base.jack_numbers(2, 2, 2)[1:])
        self.reject(inside.one_of(4, cells), box(Patches, Q(1, 4)), "I1")

    def test_curved_faces(self):
        """A box whose upper face is a paraboloid over [0, 1]^2, from 1/2 at the sides to 1/2 + rise/4 in the middle: the tile's arm ends at 2/3, over
        [11/24, 13/24]^2, where the face's least height is 1/2 + rise (143/576)^2 16 / 4."""
        least = HALF + 4 * Q(143, 576) ** 2 * 4 * Q(1, 4)
        self.assertLess(least, Q(3, 4))
        for rise, verdict in ((Q(1, 5), True), (Q(2, 3) - HALF + Q(1, 100), True), (Q(2, 3) - HALF, False), (Q(1, 10), False)):
            solid = Patches().box((0, 0, 0), (1, 1, HALF))
            solid.patches = [s for s in solid.patches if not all(p[2] == HALF for p in s.points[0])]
            heights = [[HALF + rise * 4 * (i == 1) * (j == 1) for j in range(3)] for i in range(3)]
            solid.patches.append(Patch([[(Q(i, 2), Q(j, 2), heights[i][j]) for i in range(3) for j in range(3)]], (2, 2)))
            with self.subTest(rise=rise):
                self.accept(middle(), solid) if verdict else self.reject(middle(), solid, "I1")

    def test_random_boxes(self):
        """A box is convex: it holds a tile if and only if it holds its corners."""
        rng = random.Random(int(os.environ.get("VT_SEED", "20261202")))
        for turn in range(30):
            tile = mf.jack(half=Q(rng.randint(1, 5), 32), core=Q(rng.randint(3, 6), 32), walls=rng.sample(range(6), rng.randint(1, 6)))
            micro = middle(tile)
            corners = [tuple((1 + c) / 3 for c in p) for s in tile.patches for p in s.points[0]]
            lo, hi = ([f(p[k] for p in corners) for k in range(3)] for f in (min, max))
            room = [rng.choice((Q(1, 1 << 20), Q(1, 100), -Q(1, 1 << 20), -Q(1, 50), Q(1, 10))) for _ in range(6)]
            solid = Patches().box([lo[k] - room[k] for k in range(3)], [hi[k] + room[3 + k] for k in range(3)])
            with self.subTest(turn=turn, room=room):
                self.accept(micro, solid) if min(room) > 0 else self.reject(micro, solid, "I1")

    def test_a_turned_patch(self):
        """A flag makes sense of a model one patch of which is turned, but I0 forbids it."""
        solid = box(Patches, Q(1, 5))
        solid.patches[2] = solid.patches[2].mapped(lambda x: x, turn=True)
        solid.options = ("--orient", "auto")
        self.reject(middle(), solid, "I0")

    def test_the_part_about_the_model(self):
        micro, solid = middle(), box(Patches, Q(1, 5))
        text, model = micro.text(), solid.text().encode()
        structure, of_model = mf.hints(micro.tiles) + mf.cage_body(micro.cage_text(), inside.VERITOPE), solid.body(inside.VERITOPE)
        numbers = {**dict(zip(mf.NUMBERS, numbers_of(micro, *INNER[1:]))), "bridges": 0}

        def judge(part, *expected, **changes):
            body = mf.inside_body(structure, part)
            self.judge((text, mf.inside_certificate(text, model, body, {**numbers, **changes}, model_format="vjson"), model), *expected)
        judge(of_model, 0, "ACCEPT")
        for part in (of_model[:-1], of_model + b"\0", b"VTSB" + of_model[4:], b""):
            judge(part, 1, "B1")
        flag = bytearray(of_model)
        flag[9] = 1
        judge(bytes(flag), 1, "P1")
        judge(of_model, 1, "W3", shells=2)
        bad = model[:-4]
        certificate = mf.inside_certificate(text, bad, mf.inside_body(structure, of_model), numbers, model_format="vjson")
        self.judge((text, certificate, bad), 4, "")

    def test_formats(self):
        """Every format of spline models is a format, and this file is not in it, or is of another kind."""
        micro, solid = middle(), box(Patches, Q(1, 5))
        text, certificate, model = mf.certified_inside(micro, solid, numbers_of(micro, *INNER[1:]), inside.VERITOPE)
        self.judge((text, certificate, model), 0, "ACCEPT")
        for name in ("itd", "g2", "mfem", "vjson-faces", "itd-faces", "g2-faces", "mfem-faces"):
            self.judge((text, certificate.replace(b'"vjson"', f'"{name}"'.encode()), model), 4, "")
        for name in ("vmicro", "chain", "faces", "vjson-", "gismo"):
            self.judge((text, certificate.replace(b'"vjson"', f'"{name}"'.encode()), model), 1, "S1")


class VoidsOfPatches(inside.Judged):
    def solid(self, *holes):
        solid = box(Patches, HALF)
        for lo, hi in holes:
            solid.box(lo, hi, inward=True)
        return solid

    def test_a_void_in_an_empty_cell(self):
        hole = ((Q(1, 8),) * 3, (Q(1, 4),) * 3)
        solid, x = self.solid(hole), (Q(3, 16), Q(7, 32), Q(13, 64))
        self.accept(middle(), solid, voids=[Void(x)])
        self.reject(middle(), solid, "I3")
        self.reject(middle(), self.solid(), "I3", voids=[Void(x)])
        self.reject(middle(), solid, "I3", voids=[Void(x)] * 2)
        self.reject(middle(), solid, "I3", voids=[Void((Q(1, 16),) * 3)])    # it is not in the void
        self.reject(middle(), solid, "I3", voids=[Void((Q(1, 8), Q(3, 16), Q(3, 16)))])    # on its surface
        self.reject(middle(), solid, "I3", voids=[Void(x, corner=0)])    # the cell is empty

    def test_a_point_in_the_plane_of_a_face(self):
        """Four of the six rays run in faces' planes, beyond the faces or along them."""
        hole = ((Q(1, 8),) * 3, (Q(1, 4),) * 3)
        inner = ((Q(3, 4), Q(3, 16), Q(3, 16)), (Q(7, 8), Q(3, 4), Q(3, 4)))
        first, second = Void((Q(3, 16), Q(3, 16), Q(7, 32))), Void((Q(13, 16), HALF, Q(1, 4)))
        self.accept(middle(), self.solid(hole, inner), voids=[first, second])

    def test_a_void_in_the_material(self):
        hole = ((Q(31, 64),) * 3, (Q(33, 64),) * 3)
        for corner in (0, 8):
            self.reject(middle(), self.solid(hole), "I3", voids=[Void((HALF,) * 3, corner)])

    def test_voids_come_in_the_order_of_shells(self):
        holes = [((Q(1, 8),) * 3, (Q(1, 4),) * 3), ((Q(3, 4),) * 3, (Q(7, 8),) * 3)]
        entries = [Void((Q(3, 16), Q(5, 32), Q(7, 32))), Void((Q(13, 16), Q(27, 32), Q(25, 32)))]
        self.accept(middle(), self.solid(*holes), voids=entries)
        self.reject(middle(), self.solid(*holes), "I3", voids=entries[::-1])

    def test_a_solid_in_a_void(self):
        """Depth 2: a point in the inner solid is in the void's shell, too, but not in the hole behind it."""
        hole = ((Q(1, 16),) * 3, (Q(5, 16),) * 3)
        solid = self.solid(hole).box((Q(1, 8),) * 3, (Q(1, 4),) * 3)
        self.accept(middle(), solid, voids=[Void((Q(3, 32), Q(5, 64), Q(7, 64)))])
        self.reject(middle(), solid, "I3", voids=[Void((Q(3, 16), Q(13, 64), Q(11, 64)))])


class SweepsInSolids(inside.Judged):
    """For meshes and for spline models."""

    def with_sweep(self, length=Q(1, 4), **others):
        micro = middle()
        micro.sweeps = [straight((length, 0, 0), 13, 1, speed=2 / Q(length), **others)]
        return micro

    def test_the_skin(self):
        """The end is at x = 2/3 + 1/4 = 11/12; the box ends at 15/16. Triangles are larger than the end, and may reach as far as they do; patches are
        halved: from a point of the end to the farthest one of a small node it is little more than the gap."""
        gap, half_end = Q(15, 16) - Q(11, 12), Q(1, 24)
        for kind in KINDS:
            solid = box(kind, Q(7, 16))
            for skin, verdict in ((gap + Q(1, 1 << 18), True), (gap - Q(1, 1 << 30), False), (1, True), (0, False), ("-", False)):
                micro = self.with_sweep()
                self.assertGreater(half_end, gap)
                with self.subTest(kind=kind.format, skin=skin):
                    if verdict and (kind is Mesh or skin == 1):
                        self.accept(micro, solid, skin=str(skin))
                    else:                                  # 4,096 nodes of the end are too large for a skin that is so near to the gap
                        self.reject(micro, solid, "I4", skin=str(skin))
            self.accept(self.with_sweep(), solid, skin=str(gap * 2))
            self.reject(middle(), solid, "I4", skin="1")

    def test_a_skin_that_some_nodes_reach(self):
        for skin, verdict in ((Q(1, 30), True), (Q(1, 40), True), (Q(1, 49), False)):
            self.accept(self.with_sweep(), box(Patches, Q(7, 16)), skin=str(skin)) if verdict else self.reject(
                self.with_sweep(), box(Patches, Q(7, 16)), "I4", skin=str(skin))

    def test_a_sweep_meets_the_model(self):
        for kind in KINDS:
            for half in (Q(11, 12) - HALF, Q(2, 5), Q(1, 5)):
                self.reject(self.with_sweep(), box(kind, half), "I1", skin="1")
            self.accept(self.with_sweep(), box(kind, Q(11, 12) - HALF + Q(1, 1 << 30)), skin="1")
            pin = kind().box((0, 0, 0), (1, 1, 1)).box((Q(3, 4), Q(7, 16), Q(7, 16)), (Q(7, 8), Q(9, 16), Q(9, 16)), inward=True)
            self.reject(self.with_sweep(), pin, "I1", skin="1")

    def test_a_curved_sweep_passes_the_model(self):
        """Its box meets the hole, and the sweep itself does not; or it does."""
        for kind in KINDS:
            for y, verdict in ((Q(5, 8), True), (Q(1, 2), False)):
                solid = kind().box((0, 0, 0), (1, 1, 1)).box((Q(23, 32), y, Q(7, 16)), (Q(25, 32), y + Q(1, 16), Q(9, 16)), inward=True)
                micro = middle()
                micro.sweeps = [Sweep(13, 1, (Q(1, 8), -Q(1, 16), 0), (Q(1, 4), Q(1, 8), 0), speed=4)]
                void = Void((Q(3, 4), y + Q(1, 64), Q(15, 32)))
                with self.subTest(kind=kind.format, y=y):
                    if verdict:
                        self.reject(micro, solid, "I3", skin="1", voids=[void])    # x is in the sweep's box
                    else:
                        self.reject(micro, solid, "I1", skin="1", voids=[void])

    def test_a_void_beside_a_sweep(self):
        for kind in KINDS:
            solid = kind().box((0, 0, 0), (1, 1, 1)).box((Q(11, 16), Q(5, 8), Q(7, 16)), (Q(7, 8), Q(11, 16), Q(9, 16)), inward=True)
            self.accept(self.with_sweep(), solid, skin="1", voids=[Void((Q(3, 4), Q(43, 64), Q(15, 32)))])


if __name__ == "__main__":
    unittest.main()
