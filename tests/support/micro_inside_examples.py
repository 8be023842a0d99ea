# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Certificates of micro-inside-1, whatever they say: tests only."""
import copy
import functools
import hashlib
import json
import pathlib
import random
import sys
from fractions import Fraction as Q

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests" / "support"), str(ROOT / "tests" / "checker_py"), str(ROOT / "tests" / "mutation")]
import forge                                              # noqa: E402
import micro_bridge_examples as bridged                   # noqa: E402
import star_box_2_forge as forge2                         # noqa: E402
import star_box_models as solids                          # noqa: E402

star_forge = bridged.forge


class Inside:
    """micro: of micro_bridge_examples.py; mesh: (points, polygons); voids: (volume, x, corner) each."""
    magic, tail = b"VTIM", b""

    def __init__(self, micro, mesh, skin=None, voids=(), mesh_format="off"):
        self.micro, self.skin, self.voids = micro, skin or ("1000000" if micro.bridges or micro.sweeps else "-"), list(voids)
        points, polygons = mesh
        triangles = [(f[0], f[i], f[i + 1]) for f in polygons for i in range(1, len(f) - 1)]
        self.solid = forge.Model(points, triangles, fmt=mesh_format)
        self.plan = forge.Plan(forge.mesh_of(self.solid), random.Random(3))
        self.values = {}

    def changed(self, **fields):
        new = copy.copy(self)
        for key, value in fields.items():
            setattr(new, key, value)
        return new

    def body(self):
        structure, solid = self.micro.body(), self.plan.body()
        out = [self.magic, star_forge.u32(len(structure)), star_forge.u32(len(solid)), structure, solid, star_forge.u32(len(self.voids))]
        for volume, x, corner in self.voids:
            out += [star_forge.u32(volume), *map(star_forge.rational, x), bytes([corner])]
        return b"".join(out) + self.tail

    def model(self):
        """The file of --model."""
        return self.solid.encode()

    def about_model(self):
        """What the statement says of it."""
        return {"model_format": self.solid.fmt}

    def certificate(self):
        subject, model, body = self.micro.text(), self.model(), self.body()
        if not self.micro.values:
            self.micro.settled()
        statement = {"certificate": "veritope-certificate-1", "tool": "micro_inside_examples", "claim": "micro-inside-1",
                     "subject_sha256": hashlib.sha256(subject).hexdigest(), "subject_bytes": len(subject), "subject_format": "vmicro",
                     "model_sha256": hashlib.sha256(model).hexdigest(), "model_bytes": len(model), **self.about_model(),
                     "reading_rule": forge.READING_RULE, "as_indexed": False, "skin": self.skin,
                     "body_sha256": hashlib.sha256(body).hexdigest(), **self.micro.values, **self.values}
        return json.dumps(statement, separators=(",", ":")).encode() + b"\n" + body


class InsideSpline(Inside):
    """plan: of star_box_2_forge.py, about the entities of a model in JSON."""

    def __init__(self, micro, plan, skin=None, voids=()):
        self.micro, self.skin, self.voids = micro, skin or ("1000000" if micro.bridges or micro.sweeps else "-"), list(voids)
        self.plan, self.values = plan, {}

    def model(self):
        return star_forge.encode_model(self.plan.entities)

    def about_model(self):
        return {"model_format": "vjson"}


@functools.lru_cache(None)
def proved(make, *arguments):
    """The plan of star boxes about make(*arguments), entities."""
    return forge2.Prover2(make(*arguments), search=True).prove().plan


def ball(middle=(0, 0, 0), radius=1, cuts=1, is_reversed=False):
    """Six bicubic patches that bulge, on `cuts` intervals of knots each. The radius is that towards the middle of a patch."""
    found = []
    for at in solids.cube_faces():
        grid, n = [Q(2 * i, 3) - 1 for i in range(4)], cuts
        rows = [[solids_bulge(at(u, v)) for v in grid] for u in grid]
        entity = star_forge.surface([[tuple(m + radius * c for m, c in zip(middle, p)) for p in row] for row in rows])
        entity = cut_evenly(entity, n) if n > 1 else entity
        found.append(solids.reversed_surface(entity) if is_reversed else entity)
    return found


def solids_bulge(p):
    return tuple(c * (Q(5, 4) - sum(x * x for x in p) * Q(3, 16)) for c in p)


def cut_evenly(entity, n):
    """Writes the surface with knots at i / n of full multiplicity."""
    shape = entity["shape"]
    p, q = shape["degrees"]
    points = [[Q(c) for c in point] for point in shape["points"]]
    rows = [points[i * (q + 1):(i + 1) * (q + 1)] for i in range(p + 1)]
    for _ in range(2):                                    # along u, then along v
        columns = [cut_line(line, n) for line in zip(*rows)]
        rows = [list(column) for column in columns]       # transposed: the new direction is second
    knots = [[Q(0)] * (d + 1) + [Q(i, n) for i in range(1, n) for _ in range(d)] + [Q(1)] * (d + 1) for d in (p, q)]
    return star_forge.surface(rows, (p, q), knots)


def cut_line(line, n):
    """The control points of a Bezier curve on n intervals, that they share at their ends."""
    def blossom(values):
        points = [tuple(p) for p in line]
        for t in values:
            points = [tuple((1 - t) * a + t * b for a, b in zip(x, y)) for x, y in zip(points, points[1:])]
        return points[0]
    d, found = len(line) - 1, []
    for i in range(n):
        lo, hi = Q(i, n), Q(i + 1, n)
        part = [blossom([lo] * (d - k) + [hi] * k) for k in range(d + 1)]
        found += part if i == 0 else part[1:]
    return found
