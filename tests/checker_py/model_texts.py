# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Maps of two and three parameters, and their texts in every format of spline models that the checkers read."""
import itertools
import json
from fractions import Fraction as Q
from math import prod

import star_box_forge as forge
import star_box_itd_test as itd

decimal = itd.decimal


class Map:
    """points: coordinates, or homogeneous points if rational; the first axis fastest."""

    def __init__(self, degrees, knots, points, rational=False):
        self.degrees, self.knots = tuple(degrees), [[Q(t) for t in axis] for axis in knots]
        self.points, self.rational = [tuple(map(Q, p)) for p in points], rational
        self.sizes = [len(t) - p - 1 for p, t in zip(self.degrees, self.knots)]
        assert prod(self.sizes) == len(self.points)

    @property
    def dimension(self):
        return len(self.points[0]) - self.rational

    def at(self, *index):
        """The homogeneous control point."""
        return self.all()[index]

    def all(self):
        """The homogeneous control points by their indices."""
        order = (index[::-1] for index in itertools.product(*map(range, self.sizes[::-1])))
        return {index: p if self.rational else (*p, Q(1)) for index, p in zip(order, self.points)}

    def entity(self):
        """The entity in JSON, last axis fastest."""
        at = dict(zip((index[::-1] for index in itertools.product(*map(range, self.sizes[::-1]))), self.points))
        return {"kind": {2: "surface", 3: "volume"}[len(self.degrees)], "group": None, "attributes": [], "shape": {
            "degrees": list(self.degrees), "periodic": [False] * len(self.degrees), "knots": [[str(t) for t in axis] for axis in self.knots],
            "rational": self.rational, "components": len(self.points[0]), "points": [[str(c) for c in at[index]] for index in sorted(at)]}}


def bezier_knots(degree):
    return [0] * (degree + 1) + [1] * (degree + 1)


def bezier(degrees, point, rational=False):
    """point(u, v, ...) of the parameters i / degree."""
    grid = itertools.product(*[range(p + 1) for p in degrees[::-1]])
    return Map(degrees, [bezier_knots(p) for p in degrees], [point(*[Q(i, p) for i, p in zip(index[::-1], degrees)]) for index in grid], rational)


def map_of(entity):
    """The map of a surface of star_box_forge.py."""
    shape = entity["shape"]
    m, n = [len(t) - p - 1 for p, t in zip(shape["degrees"], shape["knots"])]
    return Map(shape["degrees"], shape["knots"], [shape["points"][i * n + j] for j in range(n) for i in range(m)], shape["rational"])


# ---------------------------------------------------------------- texts

def numbers(values):
    return " ".join(map(decimal, values))


def json_text(maps):
    return forge.encode_model([m.entity() for m in maps])


def g2_text(maps):
    out = []
    for m in maps:
        out.append("%d 1 0 0\n%d %d" % ({2: 200, 3: 700}[len(m.degrees)], m.dimension, m.rational))
        for p, n, knots in zip(m.degrees, m.sizes, m.knots):
            out.append("%d %d\n%s" % (n, p + 1, numbers(knots)))
        out += map(numbers, m.points)
    return "\n".join(out).encode() + b"\n"


def itd_text(maps):
    out = []
    for m in maps:
        out.append("[%s BSPLINE %s %s %s" % ({2: "SURFACE", 3: "TRIVAR"}[len(m.degrees)], " ".join(map(str, m.sizes)),
                                             " ".join(str(p + 1) for p in m.degrees), "P3" if m.rational else "E3"))
        out += ["[KV %s]" % numbers(knots) for knots in m.knots]
        out += ["[%s]" % numbers(p[3:] + p[:3]) for p in m.points]
        out.append("]")
    return "\n".join(out).encode() + b"\n"


def mfem_head(num_axes, num_patches):
    """The topology of patches that share nothing."""
    n, words = 1 << num_axes, ["MFEM NURBS mesh v1.0\n\ndimension\n%d\n\nelements\n%d" % (num_axes, num_patches)]
    for i in range(num_patches):
        words.append("1 %d %s" % (2 * num_axes - 1, " ".join(str(n * i + k) for k in range(n))))
    return "\n".join(words) + "\n\nboundary\n0\n\nedges\n0\n\nvertices\n%d\n\n" % (n * num_patches)


def mfem_text(maps, kind="controlpoints_homogeneous"):
    """Each patch by itself.  Every patch is rational."""
    out = [mfem_head(len(maps[0].degrees), len(maps)) + "patches"]
    for m in maps:
        out.append("\nknotvectors\n%d" % len(m.degrees))
        out += ["%d %d %s" % (p, n, numbers(knots)) for p, n, knots in zip(m.degrees, m.sizes, m.knots)]
        out.append("dimension\n%d\n%s" % (m.dimension, kind))
        for p in m.points:
            *x, w = p if m.rational else (*p, Q(1))
            out.append(numbers([c / w for c in x] + [w] if kind == "controlpoints_cartesian" else [*x, w]))
    return "\n".join(out).encode() + b"\n"


WRITERS = {"vjson": json_text, "itd": itd_text, "g2": g2_text, "mfem": mfem_text}


# ---------------------------------------------------------------- what a checker makes of them

def is_read(vc, model, subject_format):
    """Whether the checkers read a model, or refuse it (exit 4).  The certificate is rejected as soon as the model is read."""
    model = model if isinstance(model, bytes) else model.encode("latin-1")
    code, line = vc.check(model, itd.hollow(model, subject_format))
    if code == 4:
        return False
    assert line.startswith("REJECT B1"), (model[:2000], line)
    return True


def meaning(entity):
    """An entity of the checker as a Map; None stays None."""
    if entity is None:
        return None
    if entity.kind == "volume":
        points = entity.points
    else:
        points = [point for column in zip(*entity.rows) for point in column]
    return Map(entity.degrees, entity.knots, points if entity.rational else [p[:-1] for p in points], entity.rational)


def same(a, b):
    return a is b is None or a is not None and b is not None and (
        (a.degrees, a.knots, a.rational, a.points) == (b.degrees, b.knots, b.rational, b.points))


def accepted(test, vc, model, subject_format, prover):
    """The certificate of the prover is accepted for this text."""
    prover.plan.values["subject_format"] = subject_format
    code, line = vc.check(model, prover.plan.certificate(model))
    test.assertEqual((code, line), (0, "ACCEPT " + prover.plan.claim), model[:1000])
