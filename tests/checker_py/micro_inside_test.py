#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The Python checker of micro-inside-1. Each lie names the condition that rejects it, and most are accepted without that condition."""
import itertools
import json
import pathlib
import random
import sys
import tempfile
import unittest
from fractions import Fraction as Q

import vmodel_models

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests" / "support"), str(ROOT / "verify" / "checker"), str(ROOT / "tests" / "mutation")]
import mesh_models as meshes                              # noqa: E402
import micro_bridge_examples as bridged                   # noqa: E402
import micro_examples as examples                         # noqa: E402
import micro_inside_examples as insides                   # noqa: E402
from veritope_checker import program                      # noqa: E402
from veritope_checker.mesh import mesh_model              # noqa: E402
from veritope_checker.patches.model_subject import read_volumes    # noqa: E402
from veritope_checker.common.errors import Reject         # noqa: E402
from veritope_checker.micro import inside_mesh, inside_nodes, inside_parts, inside_points, inside_space, inside_surface, micro_check, micro_read    # noqa: E402

UNIT = examples.UNIT
move, join, turned, CUBE = meshes.move, meshes.join, meshes.turned, meshes.CUBE
AROUND = move(CUBE, (-1, -1, -1), 3)


def block(n=2, cage="cube", tile=None, held=None, **more):
    """n x n x n cells with jacks."""
    breaks = [[Q(i, n) for i in range(n + 1)]] * 3
    cells = [0 if held is None or c in held else None for c in range(n ** 3)]
    return bridged.Micro(vmodel_models.honest(cage), [(0, breaks)], [tile or examples.jack(grows=Q(0))], [cells], **more)


def small(**more):
    """A jack in [1/4, 3/4]^3, the only cell."""
    return block(1, **more).changed(grids=[(0, [[Q(1, 4), Q(3, 4)]] * 3)])


def with_bridges(plan, end=Q(1, 8), walls=range(6)):
    return plan.changed(bridges=[bridged.straight(plan, 0, 0, w, 1 - end if w % 2 else end) for w in walls]).settled()


def cubes(*boxes):
    """The join of cubes (least corner, side, is it turned)."""
    found = [(turned if is_turned else lambda m: m)(move(CUBE, (at,) * 3 if not isinstance(at, tuple) else at, side)) for at, side, is_turned in boxes]
    mesh = found[0]
    for more in found[1:]:
        mesh = join(mesh, more)
    return mesh


class Judged(unittest.TestCase):
    def says(self, expected, plan, skip=(), certificate=None, model=None):
        certificate = certificate or plan.certificate()
        code, line = program._check(plan.micro.text(), certificate, frozenset(skip), second=model or plan.model())
        self.assertEqual(line.split(":")[0].replace("REJECT ", "").replace("ACCEPT micro-inside-1", "ACCEPT"), expected, line)
        self.assertEqual(code, {"ACCEPT": 0, "ERROR": 4}.get(expected, 1), line)

    def dies_by(self, condition, plan):
        self.says(condition, plan)
        self.says("ACCEPT", plan, (condition,))


class InsideTest(Judged):
    # ------------------------------------------------------------ honest

    def test_cages_in_a_cube(self):
        for name in ("cube", "bent", "rational", "cube with breaks", "mirrored", "a wedge", "a ring"):
            plan = block(2, name)
            if name == "a ring":
                breaks = [sorted(set(t)) for t in plan.cage.maps[0].knots]
                plan = plan.changed(grids=[(0, breaks)], cells=[[0] * (len(breaks[0]) - 1)])
            if name == "a wedge":
                plan = plan.changed(grids=[(0, [[Q(1, 2), Q(1)], [Q(0), Q(1)], [Q(0), Q(1)]])], cells=[[0]])
            self.says("ACCEPT", insides.Inside(plan, move(CUBE, (-5, -5, -5), 11)))

    def test_graded_jacks_and_formats(self):
        number, n = UNIT // 3, 2
        plan = block(n, tile=examples.jack()).changed(walls=[[[number + 17 * i for i in range(n * n * (n + 1))] for _ in range(3)]])
        for mesh_format in ("off", "stl", "obj", "ply"):
            self.says("ACCEPT", insides.Inside(plan, AROUND, mesh_format=mesh_format))

    def test_a_mesh_close_to_the_surface(self):
        """Caps lie in the border of the cage, so the mesh is that far away."""
        for gap in (Q(1, 8), Q(1, 1 << 10), Q(1, 1 << 30)):
            mesh = move(CUBE, (float(-gap),) * 3, float(1 + 2 * gap))
            self.says("ACCEPT", insides.Inside(block(2), mesh))
        self.dies_by("I1", insides.Inside(block(2), CUBE))

    def test_a_mesh_far_away(self):
        for size in (1e30, 1e120, 1e300):
            self.says("ACCEPT", insides.Inside(with_bridges(small()), move(CUBE, (-size,) * 3, 2 * size), skin="9" * 100 if size == 1e30 else "1"),
                      () if size == 1e30 else ("I4",))

    def test_bridges_to_the_skin(self):
        plan = with_bridges(small(), Q(1, 8))
        mesh = move(CUBE, (0.0625,) * 3, 0.875)
        self.says("ACCEPT", insides.Inside(plan, mesh, skin="1/8"))
        self.says("ACCEPT", insides.Inside(plan, mesh, skin="001/15"))
        self.says("ACCEPT", insides.Inside(plan, mesh, skin="626/10000"))
        self.dies_by("I4", insides.Inside(plan, mesh, skin="624/10000"))
        self.dies_by("I4", insides.Inside(plan, mesh, skin="0"))
        self.dies_by("I4", insides.Inside(plan, mesh, skin="-"))
        self.says("ACCEPT", insides.Inside(plan, mesh, skin="9" * 100))
        self.dies_by("I4", insides.Inside(small(), mesh, skin="1"))
        one = with_bridges(small(), Q(3, 16), [1, 2, 3]).changed()
        one.bridges[0] = with_bridges(small(), Q(1, 8), [1]).bridges[0]
        self.dies_by("I4", insides.Inside(one, mesh, skin="1/8"))

    def test_a_bridge_across_knots(self):
        """The map has knots inside of the bridge."""
        plan = vmodel_models.honest("cube with breaks")
        cage = plan.changed()
        knots = vmodel_models.spline((2, 1, 1), [[Q(t) for t in (0, 0, 0, 1, 2, 3, 3, 3)], [Q(t) for t in (0, 0, 1, 1)], [Q(t) for t in (0, 0, 1, 1)]],
                                     lambda i, j, k: (Q([0, 1, 3, 5, 6][i], 2) + Q(j, 8), Q(j), Q(k) + Q(i * i, 32)))
        cage = vmodel_models.forge.proved([knots])
        micro = bridged.Micro(cage, [(0, [[Q(1, 4), Q(3, 4)], [Q(1, 4), Q(3, 4)], [Q(1, 4), Q(3, 4)]])], [examples.jack(grows=Q(0))], [[0]])
        micro = micro.changed(bridges=[bridged.straight(micro, 0, 0, 1, Q(5, 2))]).settled()
        self.says("ACCEPT", insides.Inside(micro, move(CUBE, (-1, -1, -1), 6), skin="3"))
        cut = move(CUBE, (1.75, 0.4375, 0.375), 0.375)
        self.says("I1", insides.Inside(micro, join(move(CUBE, (-1, -1, -1), 6), turned(cut)), skin="3", voids=[(0, (Q(1, 8),) * 3, 8)]))

    # ------------------------------------------------------------ lies

    def test_a1(self):
        plan = insides.Inside(block(1), AROUND)
        certificate, other = plan.certificate(), insides.Inside(block(1), move(CUBE, (-1, -1, -2), 3))
        self.says("A1", plan, certificate=certificate, model=other.model())
        self.says("A1", plan, certificate=certificate, model=plan.model() + b"\n")
        self.says("A1", plan.changed(values={"model_bytes": len(plan.model()) + 1}))
        self.says("ACCEPT", plan.changed(values={"model_bytes": len(plan.model()) + 1}), ("A1",))
        self.says("A1", plan.changed(values={"model_sha256": "0" * 64}))
        self.says("ERROR", plan.changed(values={"model_format": "stl"}))

    def test_statements(self):
        plan = insides.Inside(with_bridges(small()), AROUND)
        for values in ({"skin": ""}, {"skin": "1/0"}, {"skin": "1/00"}, {"skin": "-1"}, {"skin": "1.5"}, {"skin": "1/2/3"}, {"skin": "1/"}, {"skin": "/2"},
                       {"skin": "1" * 101}, {"skin": "1/" + "1" * 101}, {"skin": 1}, {"model_format": "chain"}, {"model_sha256": "0"}, {"model_bytes": "1"},
                       {"as_indexed": 1}, {"more": 1}):
            self.says("S1", plan.changed(values=values))
        self.says("S2", plan.changed(values={"reading_rule": "another"}))
        for skin in ("2/1", "00002/1", "1" * 100 + "/" + "1" * 98):
            self.says("ACCEPT", plan.changed(skin=skin))

    def test_bodies(self):
        honest = insides.Inside(block(1), AROUND)
        self.says("B1", honest.changed(tail=b"\0"))
        self.says("B1", honest.changed(magic=b"VTMS"))
        void = (0, (Q(1, 2),) * 3, 8)
        self.says("B1", honest.changed(voids=[(1, *void[1:])]))
        self.says("B1", honest.changed(voids=[(0, void[1], 9)]))
        self.says("I3", honest.changed(voids=[void]))
        hollow = insides.Inside(small(), cubes((-1, 3, 0), (0.0625, 0.0625, 1)), voids=[(0, (Q(3, 32),) * 3, 8)])
        self.says("ACCEPT", hollow)
        long = Q(3, 32) + Q(1, 1 << 65)
        self.dies_by("B2", hollow.changed(voids=[(0, (long,) * 3, 8)]))
        body = honest.body()
        for n in (4, 8):
            lie = honest.changed(body=lambda n=n: body[:n] + b"\xff\xff\xff\xff" + body[n + 4:])
            self.says("B1", lie)
        micro = small()
        micro.tail = b"\0"
        self.says("B1", insides.Inside(micro, AROUND))
        self.says("F2", insides.Inside(small().changed(hints=[((Q(1, 2),) * 3, 0)]), AROUND))
        dented = cubes((-1, 3, 0), (-3, 9, 0))
        self.says("V10", insides.Inside(small(), dented, voids=[]))

    def test_i1(self):
        through = join(AROUND, turned(move(CUBE, (0.1875, 0.4375, 0.4375), 0.125)))                   # a void that a cap's arm passes
        self.dies_by("I1", insides.Inside(small(), through, voids=[(0, (Q(7, 32), Q(1, 2), Q(1, 2)), 8)]))
        bridge = with_bridges(small(), walls=[1])
        at_bridge = join(AROUND, turned(move(CUBE, (0.8125, 0.53125, 0.53125), 0.125)))
        self.dies_by("I1", insides.Inside(bridge, at_bridge, voids=[(0, (Q(29, 32), Q(5, 8), Q(5, 8)), 8)]))
        self.says("I1", insides.Inside(block(1), cubes((0, 0.5, 0))))

    def test_i2(self):
        self.dies_by("I2", insides.Inside(small(), cubes(((2, 0, 0), 1, 0))))
        self.dies_by("I2", insides.Inside(small(), cubes((-2, 5, 0), (-1, 3, 1)), voids=[(0, (Q(1, 8),) * 3, 8)]))
        self.says("ACCEPT", insides.Inside(small(), cubes((-2, 5, 0), (-1, 3, 1), (-0.5, 2, 0)), voids=[(0, (Q(1, 8),) * 3, 8)]), ("I3",))
        apart = block(3, held=(0, 26))
        self.dies_by("I2", insides.Inside(apart, move(CUBE, (-1, -1, -1), 1.5)))                      # only the first tile is inside
        self.dies_by("I2", insides.Inside(apart, move(CUBE, (0.5,) * 3, 1.5)))                        # only the last one

    def test_every_shell_counts(self):
        """A shell of a void between two tiles lies in the solid, too."""
        kinds = ["ring" if wall < 2 else "centre" if wall == 2 else "none" for wall in range(6)]
        tile = examples.lattice_tile(7, [examples.pattern(kind, 7) for kind in kinds], scale=(Q(19, 20), Q(0)))
        breaks = [[Q(0), Q(1, 2), Q(1)], [Q(0), Q(1)], [Q(0), Q(1)]]
        plan = bridged.Micro(vmodel_models.honest("cube"), [(0, breaks)], [tile], [[0, 0]]).settled()
        self.assertEqual(plan.values["shells"], 2)
        self.says("ACCEPT", insides.Inside(plan, AROUND))
        inner = turned(move(CUBE, (0.46875, 0.46875, 0.46875), 0.0625))                               # a hole inside of that void
        hollow = insides.Inside(plan, join(AROUND, inner), voids=[(0, (Q(1, 2) - Q(1, 128), Q(1, 2), Q(1, 2)), 0)])
        code, line = program._check(plan.text(), hollow.certificate(), frozenset(), second=hollow.model())
        self.assertIn((code, line[:9]), ((0, "ACCEPT mi"), (1, "REJECT I1"), (1, "REJECT I3")), line)

    def test_i3(self):
        corner = (Q(3, 32),) * 3
        hole = cubes((-1, 3, 0), (0.0625, 0.0625, 1))
        honest = insides.Inside(small(), hole, voids=[(0, corner, 8)])
        self.says("ACCEPT", honest)
        self.dies_by("I3", honest.changed(voids=[]))
        self.dies_by("I3", honest.changed(voids=[(0, corner, 8)] * 2))
        self.dies_by("I3", honest.changed(voids=[(0, (Q(1, 5),) * 3, 8)]))                            # not in the void
        self.dies_by("I3", honest.changed(voids=[(0, (Q(1, 16), Q(3, 32), Q(3, 32)), 8)]))            # on its surface
        self.dies_by("I3", honest.changed(voids=[(0, (Q(1, 8), Q(1, 8), Q(1, 8)), 8)]))
        self.dies_by("I3", honest.changed(voids=[(0, corner, 0)]))                                    # in no cell
        self.dies_by("I3", honest.changed(voids=[(0, (Q(-3, 32),) * 3, 8)]))                          # not in the volume
        border = join(AROUND, turned(move(CUBE, (-0.03125, 0.0625, 0.0625), 0.0625)))
        at_border = insides.Inside(small(), border, voids=[(0, (Q(0), Q(3, 32), Q(3, 32)), 8)])
        self.dies_by("I3", at_border)                                                                 # on the volume's border
        self.says("ACCEPT", at_border.changed(voids=[(0, (Q(1, 1 << 60), Q(3, 32), Q(3, 32)), 8)]))
        whole = block(1)                                                                              # the cell is all of the volume
        behind = insides.Inside(whole, hole, voids=[(0, corner, 0)])
        self.says("ACCEPT", behind)
        for lie in (3, 5, 6, 7, 8):
            self.dies_by("I3", behind.changed(voids=[(0, corner, lie)]))
        for e in itertools.product((0, 1), repeat=3):
            at = tuple(Q(29, 32) if x else Q(3, 32) for x in e)
            mesh = join(AROUND, turned(move(CUBE, tuple(float(c - Q(1, 32)) for c in at), 0.0625)))
            self.says("ACCEPT", insides.Inside(whole, mesh, voids=[(0, at, e[0] + 2 * e[1] + 4 * e[2])]))
            self.says("I3", insides.Inside(whole, mesh, voids=[(0, at, 7 - (e[0] + 2 * e[1] + 4 * e[2]))]))

    def test_a_void_in_a_tile(self):
        """The body of the tile fills the hole: nothing but I3 sees that."""
        mesh = join(AROUND, turned(move(CUBE, (0.46875,) * 3, 0.0625)))
        for corner in range(9):
            self.dies_by("I3", insides.Inside(block(1), mesh, voids=[(0, (Q(1, 2),) * 3, corner)]))

    def test_a_void_beside_a_leaning_bridge(self):
        plan = with_bridges(small(), walls=[1])
        bridge = plan.bridges[0]
        for k in (1, 2):                                                                              # list 2 ends at y = 11/16
            bridge = bridge.moved(k, lambda p, k=k: (p[0], p[1] + Q(k, 16), p[2]))
        bridge.matrix = bridged.inverse(bridged.jacobian(bridge.points, bridge.degrees))
        plan = plan.changed(bridges=[bridge])
        mesh = join(AROUND, turned(move(CUBE, (0.7734375, 0.6484375, 0.4921875), 0.015625)))
        at = (Q(25, 32), Q(21, 32), Q(1, 2))
        self.dies_by("I3", insides.Inside(plan, mesh, voids=[(0, at, 8)]))                            # in the box of its coefficients
        inside = join(AROUND, turned(move(CUBE, (0.8046875, 0.4921875, 0.4921875), 0.015625)))
        self.says("I1", insides.Inside(plan, inside, voids=[(0, (Q(13, 16), Q(1, 2), Q(1, 2)), 8)]))

    def test_nested_voids(self):
        at = (Q(3, 32),) * 3
        mesh = cubes((-1, 3, 0), (0.0625, 0.0625, 1), (0.078125, 0.03125, 0))
        between = (Q(9, 128),) * 3
        self.says("ACCEPT", insides.Inside(small(), mesh, voids=[(0, between, 8)]))
        self.dies_by("I3", insides.Inside(small(), mesh, voids=[(0, at, 8)]))                         # inside of the body in the hole
        two = cubes((-1, 3, 0), (0.0625, 0.0625, 1), (0.875, 0.0625, 1))
        honest = insides.Inside(small(), two, voids=[(0, at, 8), (0, (Q(29, 32),) * 3, 8)])
        self.says("ACCEPT", honest)
        self.dies_by("I3", honest.changed(voids=honest.voids[::-1]))
        self.dies_by("I3", honest.changed(voids=honest.voids[:1] * 2))

    def test_w3(self):
        honest = insides.Inside(with_bridges(small()), AROUND)
        self.says("ACCEPT", honest)
        for key in examples.KEYS:
            lie = honest.changed(values={key: honest.micro.values[key] + 1})
            self.dies_by("W3", lie)

    # ------------------------------------------------------------ the command line

    def test_the_option(self):
        plan = insides.Inside(block(1), AROUND)
        other = block(1).settled()
        with tempfile.TemporaryDirectory() as folder:
            paths = {name: pathlib.Path(folder) / name for name in ("a.vmicro", "a.cert", "a.off", "b.cert")}
            for name, data in (("a.vmicro", plan.micro.text()), ("a.cert", plan.certificate()), ("a.off", plan.model()), ("b.cert", other.certificate())):
                paths[name].write_bytes(data)
            subject, certificate, solid, second = map(str, paths.values())
            for arguments, expected in (
                    ([subject, certificate, "--model", solid], 0), ([subject, certificate], 2), ([subject, certificate, solid], 2),
                    ([subject, certificate, solid, "--model", solid], 2), ([subject, certificate, "--model", solid, solid], 2),
                    ([subject, second], 0), ([subject, second, "--model", solid], 2), ([subject, certificate, "--model"], 2),
                    (["--model", solid, subject, certificate], 2), ([subject, certificate, "--model", solid, "--model", solid], 2),
                    ([subject, certificate, "--model", solid + "x"], 4), ([subject, certificate, "--model", folder], 4),
                    ([subject, certificate, "--models", solid], 2), ([subject, certificate, "--model", subject], 1)):
                with self.subTest(arguments):
                    self.assertEqual(quietly(program.main, ["veritope_check.py", *arguments]), expected)


def quietly(function, *arguments):
    out, err = sys.stdout, sys.stderr
    with open("/dev/null", "w", encoding="ascii") as sys.stdout, open("/dev/null", "w", encoding="ascii") as sys.stderr:
        try:
            return function(*arguments)
        finally:
            sys.stdout, sys.stderr = out, err


# ---------------------------------------------------------------- numbers with bounds

def exact_value(m, parameters):
    return examples.value_at(m, parameters)


class BoundsTest(unittest.TestCase):
    """What the checker computes in binary64 contains what the tests compute exactly."""

    def spaces(self):
        for name in ("cube", "bent", "rational", "a ring", "squares"):
            plan = vmodel_models.honest(name)
            text = plan.changed(subject_format="vjson", text=None).model()
            yield plan.maps[0], read_volumes(text, "vjson")[0]

    def test_the_image_of_a_point(self):
        rng = random.Random(5)
        for m, volume in self.spaces():
            for _ in range(5):
                at = [t[0] + (t[-1] - t[0]) * Q(rng.randrange(65), 64) for t in m.knots]
                self.assertEqual(inside_points.image(volume, at), exact_value(m, at))

    def test_boxes_contain_images(self):
        rng = random.Random(6)
        for m, volume in self.spaces():
            space = inside_space.Space(volume)
            for _ in range(20):
                ends = [sorted(rng.choice((Q(rng.randrange(1001), 1000), Q(rng.randrange(9), 8))) for _ in range(2)) for _ in range(3)]
                box = [float(c) for pair in ends for c in pair]
                parts = list(space.parts(box))
                for _ in range(5):
                    at = [lo + (hi - lo) * Q(rng.randrange(17), 16) for lo, hi in ends]
                    image = exact_value(m, [t[0] + (t[-1] - t[0]) * c for t, c in zip(m.knots, at)])
                    self.assertTrue(any(all(Q(p.box[2 * a]) <= image[a] <= Q(p.box[2 * a + 1]) for a in range(3)) for p in parts), (box, at))
                    self.assertTrue(all(p.error < 1e-12 for p in parts))

    def test_weights_of_any_size(self):
        # u -> u^2 / ((1 - u)^2 + 2 w u (1 - u) + u^2) for w to 0, which binary64 does not hold, in coordinates of any size.
        for w, size in itertools.product((Q(1, 10 ** 4), Q(1, 10 ** 50), Q(1, 10 ** 310), Q(1, 10 ** 400)), (Q(1), Q(1, 10 ** 310), Q(10 ** 200))):
            points = [[str(c) for c in (size * i * k, size * a * k, size * b * k, k)]
                      for i, k in ((Q(0), Q(1)), (Q(1, 2), w), (Q(1), Q(1))) for a, b in itertools.product((Q(0), Q(1)), repeat=2)]
            text = json.dumps({"format": "veritope-spline-1", "groups": [], "entities": [{"kind": "volume", "group": None, "attributes": [], "shape": {
                "degrees": [2, 1, 1], "periodic": [False] * 3, "knots": [["0"] * 3 + ["1"] * 3, *[["0", "0", "1", "1"]] * 2], "rational": True,
                "components": 4, "points": points}}]}).encode()
            space = inside_space.Space(read_volumes(text, "vjson")[0])
            for lo, hi in ((0, 1), (Q(1, 4), Q(1, 2)), (Q(1, 2), Q(1, 2)), (0, Q(1, 8)), (1, 1)):
                (part,) = space.parts([float(c) for _ in range(3) for c in (lo, hi)])
                for u in (lo, (lo + hi) / 2, hi):
                    x = size * (w * u * (1 - u) + u * u) / ((1 - u) ** 2 + 2 * w * u * (1 - u) + u * u)
                    self.assertTrue(all(part.box[2 * k] <= c <= part.box[2 * k + 1] for k, c in enumerate((x, size * u, size * u))), (w, size, u))
                if lo > 0 and size == 1:
                    self.assertLess(part.error, 1e-12)

    def test_halves_contain_the_map(self):
        rng = random.Random(7)
        for sizes in ((2, 2), (4, 3), (8, 8), (2, 3, 3), (3, 2, 3)):
            points = [[Q(rng.randrange(1001), 1000) for _ in range(3)] for _ in range(len(list(itertools.product(*map(range, sizes)))))]
            node, ends = inside_nodes.node_of(points, list(sizes)), [[Q(0), Q(1)] for _ in sizes]
            for level in range(12):
                which = rng.randrange(2)
                lo, hi = ends[level % len(sizes)]
                ends[level % len(sizes)] = [[lo, (lo + hi) / 2], [(lo + hi) / 2, hi]][which]
                node = node.halves()[which]
                self.assertEqual(node.level, level + 1)
                for corner in itertools.product((0, 1), repeat=len(sizes)):
                    at = [pair[c] for pair, c in zip(ends, corner)]
                    exact = of_bernstein(points, sizes, at)
                    self.assertTrue(all(Q(node.box[2 * a]) <= exact[a] <= Q(node.box[2 * a + 1]) for a in range(3)))

    def test_cubes_at_random_places(self):
        """I1 holds of no cube whose surface separates points of a part, and of each that is far from all points of a fine grid."""
        rng, found = random.Random(10), [0, 0, 0]
        for name in ("bent", "rational", "cube with breaks", "a ring"):
            plan = vmodel_models.honest(name)
            ends = [[t[0] + (t[-1] - t[0]) * Q(n, 4) for n in (1, 2)] for t in plan.maps[0].knots]
            if name == "a ring":
                ends[0] = sorted(set(plan.maps[0].knots[0]))[:2]
            micro = bridged.Micro(plan, [(0, ends)], [examples.jack(grows=Q(0))], [[0]])
            last = plan.maps[0].knots[1][-1]
            micro = micro.changed(bridges=[bridged.straight(micro, 0, 0, 3, ends[1][1] + (last - ends[1][1]) / 2)]).settled()
            checker = micro_check.Checker(json.loads(micro.certificate().split(b"\n", 1)[0]), micro.body(), micro_read.Microstructure(micro.text()), ())
            checker.test()
            parts = list(samples(micro))
            places = [p for part in parts for p in part]
            for _ in range(60):
                near, side = rng.choice(places), rng.choice((1 / 4, 1 / 16, 1 / 64))
                least = [float(c) + side * rng.uniform(-1.5, .5) for c in near]
                mesh = mesh_model.Mesh(*meshes.triangles(move(CUBE, tuple(least), side)))
                inside = [[all(lo < c < lo + side for c, lo in zip(p, least)) for p in part] for part in parts]
                is_cut = any(any(part) != all(part) for part in inside)
                far = min(max(max(lo - c, c - lo - side) for c, lo in zip(p, least)) for p in places)
                holds = True
                try:
                    inside_surface.Surface(inside_parts.Parts(checker.model, checker.tiles), inside_mesh.Triangles(mesh)).test_i1()
                except Reject:
                    holds = False
                self.assertFalse(is_cut and holds, (name, least, side))
                self.assertFalse(far > 1 / 8 and not holds, (name, least, side))
                found[2 * holds + is_cut] += 1
        self.assertGreater(min(found), 20, found)

    def test_what_is_apart(self):
        """A triangle that is called apart is so by one of the seven vectors; one that is far from it is called apart."""
        rng, found = random.Random(9), [0, 0]
        for _ in range(400):
            corners = [tuple(rng.randrange(-8, 9) / 8 for _ in range(3)) for _ in range(3)]
            if not any(cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]))):
                continue
            triangles = inside_mesh.Triangles(mesh_model.Mesh(corners, [(0, 1, 2)]))
            at, size = [rng.randrange(-8, 9) / 8 for _ in range(3)], rng.choice((1 / 64, 1 / 8, 1 / 2))
            points = [tuple(c + size * rng.randrange(-4, 5) / 4 for c in at) for _ in range(8)]
            left = triangles.not_apart(inside_space.Points(*map(list, zip(*points)), 1e-15), [0])
            distance = gap(points, corners)
            self.assertFalse(not left and distance <= 0, (points, corners))
            self.assertFalse(left and distance > 1e-9, (points, corners))
            found[bool(left)] += 1
        self.assertGreater(min(found), 40)

    def test_distances_from_triangles(self):
        rng = random.Random(8)
        for _ in range(300):
            corners = [tuple(float(rng.randrange(-4, 5)) for _ in range(3)) for _ in range(3)]
            p = tuple(float(rng.randrange(-8, 9)) for _ in range(3))
            found, truth = inside_mesh.distance_to(p, corners), squared_distance(p, corners)
            self.assertAlmostEqual(found ** 2, float(truth), places=9, msg=(p, corners))


def samples(micro):
    """Points of each patch and of each bridge, in space; one cell."""
    m, tile = micro.cage.maps[0], micro.tiles[0]
    for _, (p, q), lists in tile.patches:
        for_patch = [of_bernstein(lists[0], (p + 1, q + 1), [Q(i, 3), Q(j, 3)]) for i in range(4) for j in range(4)]
        yield [[float(c) for c in micro.in_space(0, 0, point)] for point in for_patch]
    for bridge in micro.bridges:
        points, sizes = [bridge.points[at] for at in bridge.order()], (*[d + 1 for d in bridge.degrees], 3)
        yield [[float(c) for c in exact_value(m, of_bernstein(points, sizes, [Q(i, 3) for i in at]))] for at in itertools.product(range(4), repeat=3)]


def of_bernstein(points, sizes, at):
    values = {index: point for index, point in zip(itertools.product(*map(range, sizes)), points)}
    for t in at:
        lines = {}
        for index in sorted(values):
            lines.setdefault(index[1:], []).append(values[index])
        for index, line in lines.items():
            while len(line) > 1:
                line = [[(1 - t) * a + t * b for a, b in zip(p, q)] for p, q in zip(line, line[1:])]
            lines[index] = line[0]
        values = lines
    return values[()]


def minus(x, y):
    return [s - t for s, t in zip(x, y)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def gap(points, corners):
    """The greatest gap between the points and the corners along one of the seven vectors, exactly; positive if they are apart."""
    points, corners = ([[Q(x) for x in q] for q in group] for group in (points, corners))
    a, b, c = corners
    n = cross(minus(b, a), minus(c, a))
    found = []
    for d in ([1, 0, 0], [0, 1, 0], [0, 0, 1], n, *[cross(n, minus(q, p)) for p, q in ((a, b), (b, c), (c, a))]):
        ours, theirs = ([sum(s * t for s, t in zip(d, q)) for q in group] for group in (points, corners))
        found.append(max(min(ours) - max(theirs), min(theirs) - max(ours)))
    return max(found)


def squared_distance(p, corners):
    """The exact number for integers: the least of those from the plane, sides and corners that belong to points of the triangle."""
    p, a, b, c = ([Q(x) for x in q] for q in (p, *corners))

    def dot(x, y):
        return sum(s * t for s, t in zip(x, y))
    found = [dot(minus(p, q), minus(p, q)) for q in (a, b, c)]
    for q, r in ((a, b), (b, c), (c, a)):
        d = minus(r, q)
        if dot(d, d) and 0 <= dot(minus(p, q), d) <= dot(d, d):
            t = dot(minus(p, q), d) / dot(d, d)
            rest = [x - t * y for x, y in zip(minus(p, q), d)]
            found.append(dot(rest, rest))
    u, v, w = minus(b, a), minus(c, a), minus(p, a)
    det = dot(u, u) * dot(v, v) - dot(u, v) ** 2
    if det:
        s = (dot(w, u) * dot(v, v) - dot(w, v) * dot(u, v)) / det
        t = (dot(w, v) * dot(u, u) - dot(w, u) * dot(u, v)) / det
        if s >= 0 and t >= 0 and s + t <= 1:
            rest = [x - s * y - t * z for x, y, z in zip(w, u, v)]
            found.append(dot(rest, rest))
    return min(found)


if __name__ == "__main__":
    unittest.main()
