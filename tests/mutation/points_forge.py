# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Reference prover of the claim points-1 for small meshes, honest by default, and an oracle of where points are.

Both share no code with the checkers. The oracle counts crossings of a ray of random direction that meets no edge, and finds the points
of a triangle by their barycentric coordinates; all of it in integers and fractions.
"""
import hashlib
import itertools
import math
import random
import re
from fractions import Fraction

import forge

WORDS = {"in": 1, "out": 0}


# ---------------------------------------------------------------- truth

def around(mesh, point):
    """The corners of each triangle minus the point, all times one positive number: integers."""
    ratios = [Fraction(c) / mesh.unit for c in point]
    d = math.lcm(*(c.denominator for c in ratios))
    x, y, z = (int(c * d) for c in ratios)
    moved = [(d * a - x, d * b - y, d * c - z) for a, b, c in mesh.p]
    return [tuple(moved[v] for v in t) for t in mesh.tris]


def has_origin(a, b, c):
    """Whether the origin is in the convex hull of three points."""
    e, f = forge.sub(b, a), forge.sub(c, a)
    ee, ff, ef = forge.dot(e, e), forge.dot(f, f), forge.dot(e, f)
    det = ee * ff - ef * ef
    if det:
        ae, af = -forge.dot(a, e), -forge.dot(a, f)
        s, t = ae * ff - af * ef, af * ee - ae * ef       # times det
        return s >= 0 and t >= 0 and s + t <= det and all(det * x + s * y + t * z == 0 for x, y, z in zip(a, e, f))
    length, p, q = max(((forge.dot(r, r), p, q) for p, q in ((a, b), (b, c), (c, a)) for r in [forge.sub(q, p)]), key=lambda row: row[0])
    r, at = forge.sub(q, p), -forge.dot(p, forge.sub(q, p))
    return 0 <= at <= length and all(length * x + at * y == 0 for x, y in zip(p, r)) if length else not any(a)


def triangles_at(mesh, point):
    """The triangles on which the point lies."""
    return [f for f, corners in enumerate(around(mesh, point)) if has_origin(*corners)]


def crossings(corners, d):
    """The signed number of triangles that the ray from the origin in direction d crosses, or None if it meets an edge. The origin is on
    none of the triangles."""
    total = 0
    for a, b, c in corners:
        n = forge.cross(forge.sub(b, a), forge.sub(c, a))
        if not any(n):
            continue
        height, speed = forge.dot(n, a), forge.dot(n, d)
        if speed == 0:
            if height == 0:
                return None
            continue
        if height * speed <= 0:                           # behind the origin, or its plane passes through that
            continue
        sides = [forge.dot(d, forge.cross(p, q)) * speed for p, q in ((a, b), (b, c), (c, a))]
        if min(sides) < 0:
            continue
        if 0 in sides:
            return None
        total += 1 if speed > 0 else -1
    return total


def winding(mesh, point, rng=None):
    """The winding number of a closed chain around a point that is on none of its triangles."""
    rng, corners = rng or random.Random(1), around(mesh, point)
    while True:
        total = crossings(corners, tuple(rng.randint(-10 ** 6, 10 ** 6) for _ in range(3)))
        if total is not None:
            return total


def is_closed(mesh):
    edges = [(t[i], t[(i + 1) % 3]) for t in mesh.tris for i in range(3)]
    return all(edges.count((a, b)) == edges.count((b, a)) for a, b in set(edges))


# ---------------------------------------------------------------- tokens

def nearest(value):
    """The binary64 number nearest to a fraction, ties to even, as a fraction, or None if that is infinite."""
    size = abs(value)
    if size == 0:
        return Fraction(0)
    exponent = size.numerator.bit_length() - size.denominator.bit_length()
    exponent -= size < Fraction(2) ** exponent            # 2^exponent <= size < 2^(exponent + 1)
    step = Fraction(2) ** (max(exponent, -1022) - 52)
    steps, rest = divmod(size, step)
    steps += rest * 2 > step or rest * 2 == step and steps % 2
    rounded = steps * step
    return None if rounded >= 2 ** 1024 else -rounded if value < 0 else rounded


def meaning(token, decimals):
    """The number that a token is, or None if rounding makes it infinite. The token is as the page says."""
    if "/" in token:
        return Fraction(token)
    sign = -1 if token.startswith("-") else 1
    digits = token.lstrip("+-").lower()
    base, mark = (16, "p") if digits.startswith("0x") else (10, "e")
    digits, _, power = digits.removeprefix("0x").partition(mark)
    whole, _, after = digits.partition(".")
    value = sign * Fraction(int("0" + whole + after, base), base ** len(after)) * Fraction(2 if base == 16 else 10) ** int(power or 0)
    return nearest(value) if base == 10 and decimals == "nearest" else value


def is_decimal(value):
    """Whether finitely many decimal places suffice."""
    rest = value.denominator
    for prime in (2, 5):
        while rest % prime == 0:
            rest //= prime
    return rest == 1


def decimal_text(value):
    places = next(k for k in itertools.count() if 10 ** k % value.denominator == 0)
    text = str(abs(value.numerator) * 10 ** places // value.denominator).zfill(places + 1)
    return ("-" if value < 0 else "") + (text[:-places] + "." + text[-places:] if places else text)


def hex_text(value):
    places = value.denominator.bit_length() - 1
    return "%s0x%xp%d" % ("-" if value < 0 else "", abs(value.numerator), -places)


def tokens_of(value, decimals):
    """Texts that mean this number."""
    found = ["%d/%d" % (k * value.numerator, k * value.denominator) for k in (1, 3)]
    if value.denominator & value.denominator - 1 == 0:
        found += [hex_text(value), hex_text(value).replace("0x", "0X").replace("p", "P")]
    if is_decimal(value):
        found += [decimal_text(value), decimal_text(value * 1000) + "e-3"]
    if nearest(value) == value:
        found.append(repr(float(value)))
    allowed = [text for text in found if len(text) <= 4096 and all(abs(int(part)) <= 4096 for part in re.findall(r"(?<=[pPe])-?\d+$", text))]
    return [text for text in allowed if meaning(text, decimals) == value]


# ---------------------------------------------------------------- the prover

class Line:
    """A point and its answer. code: None has no bytes."""

    def __init__(self, tokens, word, f, shell, code):
        self.tokens, self.word, self.f, self.shell, self.code = tokens, word, f, shell, code

    def text(self):
        return " ".join((*self.tokens, self.word, self.f, self.shell)) + "\n"

    def point(self, decimals):
        return [meaning(token, decimals) for token in self.tokens]

    def changed(self, **fields):
        line = Line(self.tokens, self.word, self.f, self.shell, self.code)
        line.__dict__.update(fields)
        return line

    def is_off(self):
        return self.word not in ("on", "undecided")

    def bytes(self):
        if self.code is None:
            return b""
        return bytes([self.code]) if self.is_off() else forge.varint(self.code)


def off_line(tokens, f, shell, direction, with_winding):
    return Line(tokens, "-" if with_winding else "in" if f else "out", str(f), shell, direction)


class Plan:
    """Everything that an answers file and its certificate are made of; a liar changes parts of it."""

    def __init__(self, mesh, lines, decimals="nearest", with_winding=False):
        self.mesh, self.lines, self.decimals, self.winding = mesh, list(lines), decimals, with_winding
        self.values, self.extra, self.magic = {}, b"", b"VTPT"
        self.claimed_answers = None                       # another file that the statement names

    def copy(self, **changes):
        plan = Plan(self.mesh, self.lines, self.decimals, self.winding)
        plan.__dict__.update({**self.__dict__, "lines": list(self.lines), "values": dict(self.values), **changes})
        return plan

    def with_line(self, number, **fields):
        plan = self.copy()
        plan.lines[number] = plan.lines[number].changed(**fields)
        return plan

    def answers(self):
        return "".join(line.text() for line in self.lines).encode()

    def quantities(self):
        answers = self.answers() if self.claimed_answers is None else self.claimed_answers
        words = [line.word for line in self.lines]
        return {"answers_sha256": hashlib.sha256(answers).hexdigest(), "answers_bytes": len(answers), "decimals": self.decimals,
                "winding": self.winding, "points": len(words), "on": words.count("on"), "undecided": words.count("undecided"), **self.values}

    def body(self):
        counts = len(self.mesh.tris).to_bytes(4, "little") + len(self.mesh.p).to_bytes(4, "little")
        points = self.quantities()["points"]
        counts += (points if type(points) is int and points >= 0 else len(self.lines)).to_bytes(8, "little")
        return self.magic + counts + b"".join(line.bytes() for line in self.lines) + self.extra

    def certificate(self, model_bytes, model):
        return forge.certificate(model_bytes, model, "points-1", self.body(), self.quantities())


def true_line(mesh, point, rng, decimals, with_winding, tokens=None):
    """The line of a point; undecided if its winding number does not fit a word."""
    tokens = tokens or [rng.choice(tokens_of(Fraction(c), decimals)) for c in point]
    on = triangles_at(mesh, point)
    if on:
        return Line(tokens, "on", "-", rng.choice(("-", "0", "7")), rng.choice(on))
    w = winding(mesh, point, rng)
    if w not in WORDS.values() and not with_winding:
        return Line(tokens, "undecided", "-", "-", None)
    return off_line(tokens, w, rng.choice(("-", "0", "4294967295")), rng.randrange(6), with_winding)


def holds(mesh, line, decimals):
    """Whether what a line says is so. Its shell says nothing, and neither does the direction of its ray."""
    if line.word == "undecided":
        return True
    on = triangles_at(mesh, line.point(decimals))
    return line.code in on if line.word == "on" else not on and winding(mesh, line.point(decimals)) == int(line.f)


def true_plan(mesh, points, rng, decimals="nearest", with_winding=False):
    return Plan(mesh, [true_line(mesh, p, rng, decimals, with_winding) for p in points], decimals, with_winding)


# ---------------------------------------------------------------- meshes and points of interest

def chain(rng):
    """A closed chain that is rarely a solid: borders of random tetrahedra with corners on a small grid, some of them inside out or twice,
    and degenerate triangles."""
    size = rng.randint(1, 3)
    grid = list(itertools.product(range(size + 1), repeat=3))
    points = rng.sample(grid, min(len(grid), rng.randint(4, 9)))
    tris = []
    for _ in range(rng.randint(1, 6)):
        a, b, c, d = rng.sample(range(len(points)), 4)
        tris += [(a, c, b), (a, b, d), (b, c, d), (a, d, c)] * rng.choice((1, 1, 1, 2))
    for _ in range(rng.choice((0, 0, 1, 3))):
        a, b = rng.choice(range(len(points))), rng.choice(range(len(points)))
        tris.append(rng.choice(((a, a, b), (a, b, a), (b, a, a), (a, a, a))))
    rng.shuffle(tris)
    return points, tris


def interesting(mesh, rng, count):
    """Points on and near the triangles: vertices, points of edges and faces and of their lines and planes, points of the lines along the
    axes through those, a grid, and points far away."""
    floats = [tuple(Fraction(c) for c in p) for p in mesh.floats]
    low, high = ([choose(p[k] for p in floats) for k in range(3)] for choose in (min, max))
    sizes = [b - a or Fraction(1) for a, b in zip(low, high)]
    found = []
    while len(found) < count:
        a, b, c = (floats[v] for v in rng.choice(mesh.tris))
        kind = rng.random()
        if kind < .3:
            weights = rng.choice(((1, 0, 0), (1, 1, 0), (1, 2, 0), (2, -1, 0), (1, 1, 1), (2, 1, 1), (1, 1, -1), (3, -1, -1), (1, 2, 4)))
            w = rng.sample(weights, 3)
            at = [(w[0] * x + w[1] * y + w[2] * z) / sum(w) for x, y, z in zip(a, b, c)]
        elif kind < .7:
            at = [x + rng.randint(-2, 5) * s / 4 for x, s in zip(low, sizes)]
        else:
            at = [Fraction(rng.randint(-1, 13), 12) * s + x for x, s in zip(low, sizes)]
        if rng.random() < .3:                             # along an axis through it
            k = rng.randrange(3)
            at[k] = rng.choice((rng.choice(floats)[k], at[k] + sizes[k] / 2, at[k] - sizes[k], at[k] + sizes[k] / 2 ** 40))
        if rng.random() < .1:
            k = rng.randrange(3)
            at[k] = at[k] + sizes[k] * Fraction(rng.choice((1, -1)), rng.choice((3 ** 20, 2 ** 80, 7)))
        found.append(at)
    return found
