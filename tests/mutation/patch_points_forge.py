# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Reference prover of the claim points-1 for spline models whose inside has a formula, honest by default. What is true says the formula, not
a ray, and patches are evaluated by Bernstein polynomials: none of it is a checker's method."""
import copy
import hashlib
import json
import pathlib
import sys
from fractions import Fraction as Q

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "checker_py")]
import forge                                              # noqa: E402
import patch_invalid_2_forge as places                    # noqa: E402
import points_forge                                       # noqa: E402
import star_box_forge as patch_forge                      # noqa: E402
import star_box_models as models                          # noqa: E402
from points_forge import Line, off_line, tokens_of        # noqa: E402,F401  Line and off_line are for those who use this


# ---------------------------------------------------------------- solids with a formula

class Part:
    """Entities that bound a solid. level(x, y, z): below 0 inside, 0 on the surface."""

    def __init__(self, entities, level, size):
        self.entities, self.level, self.size, self.sign = entities, level, size, 1

    def placed(self, scale, shift):
        """Scaled by one positive number for each axis, then moved."""
        entities, level = [copy.deepcopy(e) for e in self.entities], self.level
        for e in entities:
            shape = e["shape"]
            for p in shape["points"]:
                w = Q(p[3]) if shape["rational"] else 1
                p[:3] = [str(Q(c) * s + w * d) for c, s, d in zip(p, scale, shift)]
        part = Part(entities, lambda *q: level(*((c - d) / s for c, s, d in zip(q, scale, shift))), None)
        part.size = [(s * a + d, s * b + d) for (a, b), s, d in zip(self.size, scale, shift)]
        part.sign = self.sign
        return part

    def reversed(self):
        part = Part([reversed_entity(e) for e in self.entities], self.level, self.size)
        part.sign = -self.sign
        return part


def reversed_entity(entity):
    if entity["kind"] == "surface":
        return models.reversed_surface(entity)
    rows = places.rows_of(entity)                         # corners 1 and 2 are exchanged
    out = copy.deepcopy(entity)
    out["shape"]["points"] = [[str(c) for c in p] for row in rows for p in reversed(row)]
    return out


def ball():
    return Part(models.octant_sphere(), lambda x, y, z: x * x + y * y + z * z - 1, [(-1, 1)] * 3)


def cube(degree=1, weight=1):
    """[-1, 1]^3; with a weight, one corner of each face has it."""
    entities = models.cube(degree=degree)
    for e in entities if weight != 1 else ():
        shape = e["shape"]
        n = degree + 1
        shape["rational"], shape["components"] = True, 4
        # the weights of a face are products along u and v, equal along common edges: those of the cube's corner (1, 1, 1)
        for at, p in enumerate(shape["points"]):
            w = weight if all(Q(c) == 1 for c in p) else 1
            p[:] = [str(Q(c) * w) for c in p] + [str(w)]
        assert len(shape["points"]) == n * n
    return Part(entities, lambda *q: max(abs(c) for c in q) - 1, [(-1, 1)] * 3)


def tetrahedron():
    return Part(models.tetrahedron(), lambda x, y, z: max(-x, -y, -z, x + y + z - 1), [(0, 1)] * 3)


def torus():
    def level(x, y, z):
        return (x * x + y * y + z * z + 3) ** 2 - 16 * (x * x + y * y)
    return Part(models.torus(), level, [(-3, 3), (-3, 3), (-1, 1)])


class Solid:
    """Parts, which may overlap; entities in any order."""

    def __init__(self, parts, rng=None):
        self.parts, self.entities = parts, [e for part in parts for e in part.entities]
        if rng:
            rng.shuffle(self.entities)

    def truth(self, q):
        """The winding number, or None on a surface."""
        levels = [part.level(*q) for part in self.parts]
        return None if 0 in levels else sum(part.sign for part, level in zip(self.parts, levels) if level < 0)

    def encode(self):
        return patch_forge.encode_model(self.entities)


def solid(rng):
    parts = []
    for _ in range(rng.choice((1, 1, 1, 2, 3))):
        r = rng.random()
        part = (cube() if r < .3 else cube(2) if r < .4 else cube(1, Q(3)) if r < .5 else tetrahedron() if r < .7 else ball() if r < .9 else torus())
        if rng.random() < .25:
            part = part.reversed()
        # Shifts of different parts have different fractions: no two sides are one curve.
        shift = [Q(rng.randint(-12, 12), 8) + Q(len(parts), 97) for _ in range(3)]
        parts.append(part.placed([rng.choice((1, 1, Q(1, 2), Q(3, 4), Q(1, 10))) for _ in range(3)], shift))
    return Solid(parts, rng)


# ---------------------------------------------------------------- points of interest

def point_at(entity, at):
    """The exact point of a patch at the parameters of the page."""
    s, t = at
    if entity["kind"] == "triangle":
        s, t = s + t, Q(t, 1) / (s + t) if s + t else Q(0)
    return places.point(entity, s, t)


def is_in_domain(entity, at):
    return min(at) >= 0 and (sum(at) if entity["kind"] == "triangle" else max(at)) <= 1


def parameters(entity, rng):
    def one():
        return rng.choice((Q(0), Q(1), Q(1, 2), Q(rng.randint(0, 8), 8), Q(rng.randint(0, 999), 999)))
    while True:
        at = one(), one()
        if is_in_domain(entity, at):
            return at


def interesting(solid_, rng, count):
    """(point, code of an `on` line or None)"""
    for _ in range(count):
        part = rng.choice(solid_.parts)
        r = rng.random()
        if r < .4:
            yield [Q(rng.randint(-3, 35), 32) * (b - a) + a for a, b in part.size], None
            continue
        patch = rng.randrange(len(solid_.entities))
        at = parameters(solid_.entities[patch], rng)
        q = list(point_at(solid_.entities[patch], at))
        if r < .7:
            yield q, (patch, at)
            continue
        k = rng.randrange(3)
        q[k] += rng.choice((1, -1)) * Q(1, 2 ** rng.choice((3, 8, 20, 53, 90)))
        yield q, None


# ---------------------------------------------------------------- lines and plans

class Root:
    """Parameters of kind 1: the polynomials u and v at the root of a polynomial in [a, b]."""

    def __init__(self, modulus, ends, u, v):
        self.modulus, self.ends, self.u, self.v = modulus, ends, u, v

    def bytes(self):
        def poly(p):
            return bytes([len(p) - 1]) + b"".join(map(patch_forge.rational, p))
        return poly(self.modulus) + b"".join(map(patch_forge.rational, self.ends)) + poly(self.u) + poly(self.v)

    def changed(self, **fields):
        return Root(**{**vars(self), **fields})

    def parameters(self):
        """Those at the root, or None if it is not in the interval. The modulus has the degree 1."""
        constant, slope = self.modulus
        (a, b), root = self.ends, -constant / slope
        return tuple(sum(c * root ** k for k, c in enumerate(p)) for p in (self.u, self.v)) if a < root < b else None


def as_root(at, rng):
    """These parameters, as polynomials at a rational root."""
    (s, t), r = at, Q(rng.randint(-9, 9), rng.randint(1, 9))
    c, scale = Q(rng.randint(-3, 3), 4), rng.choice((1, -2, Q(1, 3)))
    modulus = [-r * scale, scale * Q(1)]
    width = Q(1, 2 ** 40)
    u = [s - c * r * (0 < s < 1), c * (0 < s < 1)]
    v = [t + r * r * Q(1, 8) * (0 < t < 1), Q(0), -Q(1, 8) * (0 < t < 1)]
    if 0 < s and 0 < t and s + t == 1 or s in (0, 1) or t in (0, 1):
        u, v = [s], [t]                                   # on a border it must stay there
    return Root(modulus, (r - width, r + width), u, v)


class PatchLine(Line):
    """code of an `on` line: (patch, parameters or a Root)."""
    kind = b"\0"

    def changed(self, **fields):
        line = PatchLine(self.tokens, self.word, self.f, self.shell, self.code)
        line.__dict__.update({**self.__dict__, **fields})
        return line

    def bytes(self):
        if type(self.code) is bytes:
            return self.code
        if self.code is None or self.is_off():
            return super().bytes()
        patch, at = self.code
        if isinstance(at, Root):
            return forge.varint(patch) + b"\1" + at.bytes()
        return forge.varint(patch) + self.kind + b"".join(map(patch_forge.rational, at))


class PatchPlan(points_forge.Plan):
    """mesh: a Solid."""
    breaks = None

    def copy(self, **changes):
        plan = PatchPlan(self.mesh, self.lines, self.decimals, self.winding)
        plan.__dict__.update({**self.__dict__, "lines": list(self.lines), "values": dict(self.values), **changes})
        return plan

    def head(self):
        return [len(self.mesh.entities)] * 2              # each entity is one patch

    def body(self):
        counts = b"".join(n.to_bytes(4, "little") for n in self.head())
        points = self.quantities()["points"]
        counts += (points if type(points) is int and points >= 0 else len(self.lines)).to_bytes(8, "little")
        axis = patch_forge.u32(2) + patch_forge.rational(0) + patch_forge.rational(1)
        breaks = b"".join(2 * axis for e in self.mesh.entities if e["kind"] == "surface") if self.breaks is None else self.breaks
        return self.magic + counts + breaks + b"".join(line.bytes() for line in self.lines) + self.extra

    def certificate(self, model_bytes, model=None):
        body = self.body()
        statement = {"certificate": "veritope-certificate-1", "tool": "forge", "claim": "points-1",
                     "subject_sha256": hashlib.sha256(model_bytes).hexdigest(), "subject_bytes": len(model_bytes), "subject_format": "vjson",
                     "reading_rule": forge.READING_RULE, "as_indexed": False, "body_sha256": hashlib.sha256(body).hexdigest(), **self.quantities()}
        return json.dumps(statement, separators=(",", ":")).encode() + b"\n" + body


def true_line(solid_, point, code, rng, with_winding):
    tokens = [rng.choice(tokens_of(c, "exact")) for c in point]
    shell = rng.choice(("-", "0", "7"))
    if code:
        patch, at = code
        return PatchLine(tokens, "on", "-", shell, (patch, as_root(at, rng)) if rng.random() < .2 else code)
    w = solid_.truth(point)
    if w is None or w not in (0, 1) and not with_winding:
        return PatchLine(tokens, "undecided", "-", "-", None)
    return PatchLine(tokens, "-" if with_winding else "in" if w else "out", str(w), shell, rng.randrange(6))


def holds(solid_, line, decimals):
    """Whether what a line says is so."""
    if line.word == "undecided":
        return True
    q = line.point(decimals)
    if line.word != "on":
        return solid_.truth(q) == int(line.f)
    patch, at = line.code
    if isinstance(at, Root):
        at = at.parameters()
    return (at is not None and patch < len(solid_.entities) and is_in_domain(solid_.entities[patch], at) and
            list(point_at(solid_.entities[patch], at)) == list(q))


def true_plan(solid_, rng, count=6, with_winding=None):
    with_winding = rng.random() < .6 if with_winding is None else with_winding
    return PatchPlan(solid_, [true_line(solid_, q, code, rng, with_winding) for q, code in interesting(solid_, rng, count)], "exact", with_winding)
