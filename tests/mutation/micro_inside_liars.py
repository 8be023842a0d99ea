# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Certificates of micro-inside-1 for microstructures that are not in the interior of the model: one lie for each way out of it. More are in
tests/checker_py/micro_inside_test.py, each with the condition that alone rejects it."""
import pathlib
import sys
from fractions import Fraction as Q

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests" / part) for part in ("support", "checker_py", "mutation")]
import mesh_models as meshes                              # noqa: E402
import micro_bridge_examples as bridged                   # noqa: E402
import micro_examples as examples                         # noqa: E402
import micro_inside_examples as insides                   # noqa: E402
import vmodel_models                                      # noqa: E402

HALF = (Q(1, 2),) * 3
AROUND = meshes.move(meshes.CUBE, (-1, -1, -1), 3)


def bubble(at, side):
    """The model around everything without a cube."""
    return meshes.join(AROUND, meshes.turned(meshes.move(meshes.CUBE, at, side)))


def cells(n, held):
    """n x n x n cells of a cube; those that are held have jacks."""
    breaks = [[Q(i, n) for i in range(n + 1)]] * 3
    kinds = [0 if c in held else None for c in range(n ** 3)]
    return bridged.Micro(vmodel_models.honest("cube"), [(0, breaks)], [examples.jack(grows=Q(0))], [kinds])


def lies(rng):
    """(name, Inside)"""
    one, two = cells(1, (0,)), cells(3, (0, 26))
    size = rng.choice((1, 2, 4)) / 64
    yield "the node holds a bubble", insides.Inside(one, bubble((0.5 - size / 2,) * 3, size), voids=[(0, HALF, rng.randrange(9))])
    yield "an arm holds a bubble", insides.Inside(one, bubble((0.125, 0.5 - size / 4, 0.5 - size / 4), size / 2),
                                                  voids=[(0, (Q(1, 8) + Q(size) / 4, Q(1, 2), Q(1, 2)), rng.randrange(9))])
    yield "the void is not listed", insides.Inside(one, bubble((0.5 - size / 2,) * 3, size))
    yield "an arm leaves the model", insides.Inside(one, meshes.move(meshes.CUBE, (rng.choice((-1, 0, 0.5)), -1, -1), rng.choice((1, 1.25, 1.5))))
    yield "caps touch the model", insides.Inside(one, meshes.CUBE)
    yield "it is elsewhere", insides.Inside(one, meshes.move(meshes.CUBE, (2, rng.randrange(3), 0), 1))
    yield "a second piece is elsewhere", insides.Inside(two, meshes.move(meshes.CUBE, (-1, -1, -1), 1.5))
    yield "a second piece is in a void", insides.Inside(two, bubble((0.5,) * 3, 0.75), voids=[(0, (Q(9, 16),) * 3, 8)])


def inside_attacks(rng):
    """(name, the microstructure, the certificate, the model)"""
    for name, plan in lies(rng):
        yield name, plan.micro.text(), plan.certificate(), plan.model()
