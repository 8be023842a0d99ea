# SPDX-License-Identifier: Apache-2.0 OR MIT
"""A prover of star-box certificates for small models: tests only. Its search may use floats and the checker's own pieces; what it
finds is judged by the checker, and the truth of a model is known by its construction. Plan can write every lie."""
import copy
import hashlib
import json
import math
import pathlib
import sys
from fractions import Fraction

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "verify" / "checker"))
from veritope_checker.patches import star_box_crossing as star_crossing, star_box_nodes as star_nodes  # noqa: E402
from veritope_checker.patches import star_box_patches as patches, star_box_read as read  # noqa: E402
from veritope_checker.patches import star_box_triangles as star_triangles                # noqa: E402


# ---------------------------------------------------------------- models

def surface(rows, degrees=None, knots=None, rational=False):
    """rows[i][j]: homogeneous points if rational. Without knots: one Bezier patch on [0, 1]^2."""
    degrees = degrees or (len(rows) - 1, len(rows[0]) - 1)
    knots = knots or [[0] * (p + 1) + [1] * (p + 1) for p in degrees]
    return {"kind": "surface", "group": None, "attributes": [], "shape": {
        "degrees": list(degrees), "periodic": [False, False], "knots": [[str(Fraction(t)) for t in axis] for axis in knots],
        "rational": rational, "components": len(rows[0][0]), "points": [[str(Fraction(c)) for c in p] for row in rows for p in row]}}


def triangle(points, degree=1, rational=False):
    return {"kind": "triangle", "group": None, "attributes": [], "shape": {
        "degree": degree, "rational": rational, "components": len(points[0]), "points": [[str(Fraction(c)) for c in p] for p in points]}}


def encode_model(entities):
    return json.dumps({"format": "veritope-spline-1", "groups": [], "entities": entities}).encode()


def varint(n):
    out = bytearray()
    while n > 127:
        out.append(n & 127 | 128)
        n >>= 7
    out.append(n)
    return bytes(out)


def zigzag_code(z):
    return 2 * z if z >= 0 else -2 * z - 1


def zigzag(z):
    return varint(zigzag_code(z))


def u32(n):
    return n.to_bytes(4, "little")


def rational(r):
    p, q = Fraction(r).numerator, Fraction(r).denominator
    if max(abs(p), q) < 1 << 63:
        return zigzag(p) + varint(q)
    a, b = [n.to_bytes((n.bit_length() + 7) // 8, "little") for n in (abs(p), q)]
    return b"\0\0" + varint(len(a) + 1) + bytes([p < 0]) + a + varint(len(b)) + b


class Box:
    def __init__(self, kind, lo, size, minus=None, plus=None, shift=0):
        self.kind, self.lo, self.size, self.shift = kind, list(lo), list(size), shift
        self.minus, self.plus = minus and list(minus), plus and list(plus)   # from lo

    def encode(self):
        offsets = [] if self.kind else [*self.minus, *self.plus]
        return bytes([self.kind]) + varint(self.shift) + b"".join(map(zigzag, self.lo)) + b"".join(map(varint, [*self.size, *offsets]))


def trees_and_walks(trees, walks):
    """What ends the bodies of both versions. A tree: a box, or four trees."""
    last = 0

    def encode(tree):
        nonlocal last
        if isinstance(tree, int):
            code, last = zigzag_code(tree - last), tree
            return varint(1 + code)
        return b"\0" + b"".join(map(encode, tree))

    out = [encode(tree) for of_patch in trees for tree in of_patch] + [u32(len(walks))]
    for box, sign, points, end in walks:
        out += [varint(box), bytes([sign]), u32(len(points))] + [b"\0" + b"".join(map(zigzag, p)) for p in points]
        out.append(bytes([end]) if isinstance(end, int) else b"\6" + varint(end[0]) + bytes([end[1]]))
    return b"".join(out)


def bent(rng, body):
    """The body with one to three random changes: a byte, a stretch that is missing, a stretch that is too much."""
    lie = bytearray(body)
    for _ in range(rng.randint(1, 3)):
        at = rng.randrange(len(lie))
        kind = rng.randrange(5)
        if kind < 3:
            lie[at] = rng.choice((0, 1, 127, 128, 255, rng.randrange(256)))
        elif kind == 3:
            del lie[at:at + rng.randint(1, 9)]
        else:
            lie[at:at] = bytes(rng.randrange(256) for _ in range(rng.randint(1, 9)))
    return bytes(lie)


class Plan:
    """Everything that a body says. trees[patch][root]: a box or four trees. walks: (box, sign, points, end)."""
    claim, magic = "star-box-1", b"VTSB"

    def __init__(self, entities, unit=-20):
        self.entities, self.unit = entities, unit
        self.flags = [0] * len(entities)
        self.breaks = []
        for e in entities:
            axes = zip(e["shape"]["degrees"], e["shape"]["knots"]) if e["kind"] == "surface" else ()
            self.breaks.append([sorted({Fraction(t) for t in knots[p:len(knots) - p]}) for p, knots in axes])
        self.roots, self.boxes, self.trees, self.walks, self.values, self.tail = [], [], [], [], {}, b""

    def body(self):
        out = [self.magic, u32(len(self.entities)), self.marks()]
        for axes in self.breaks:
            for axis in axes:
                out += [u32(len(axis)), *map(rational, axis)]
        out += [bytes(r) for r in self.roots] + [zigzag(self.unit), self.table(), u32(len(self.boxes))] + [b.encode() for b in self.boxes]
        return b"".join(out) + trees_and_walks(self.trees, self.walks) + self.tail

    def marks(self):
        """What stands for each entity."""
        return bytes(self.flags)

    def table(self):
        """What stands between the unit and the boxes."""
        return b""

    def certificate(self, model=None):
        model, body = encode_model(self.entities) if model is None else model, self.body()
        statement = {"certificate": "veritope-certificate-1", "tool": "star_box_forge", "claim": self.claim,
                     "subject_sha256": hashlib.sha256(model).hexdigest(), "subject_bytes": len(model), "subject_format": "vjson",
                     "body_sha256": hashlib.sha256(body).hexdigest(), "patches": 0, "edges": 0, "vertices": 0, "shells": 0,
                     "bodies": 0, "genus": 0, "boxes": len(self.boxes), "flipped": sum(self.flags)}
        statement.update(self.values)
        return json.dumps(statement, separators=(",", ":")).encode() + b"\n" + body


# ---------------------------------------------------------------- the search

class Prover:
    """Star boxes around leaves, split where none is found; mesh boxes around flat triangles where splitting does not help."""
    plan_kind = Plan

    def __init__(self, entities, flags=None, unit=-20, factor=1.6, roots=0, deepest=6, checked=True):
        self.plan, self.factor, self.deepest = self.plan_kind(entities, unit), factor, deepest
        plan = self.plan
        plan.flags = flags or plan.flags
        self.model = encode_model(entities)
        parsed = read.read_model(self.model)
        self.patches = []
        for entity, flag, breaks in zip(parsed, plan.flags, plan.breaks):
            self.patches += patches.patches_of(entity, breaks, flag, unit)
        for i, patch in enumerate(self.patches):
            patch.index, patch.roots = i, [roots, roots] if patch.is_tensor else [0, 0]
        plan.roots = [patch.roots for patch in self.patches]

        def fail(condition, why):
            if checked:
                raise ValueError(condition + " " + why)

        edges, vertices, chi, self.vertex_of = patches.glue(self.patches, fail)
        plan.values = {"patches": len(self.patches), "edges": edges, "vertices": vertices, "shells": len(chi),
                       "genus": sum(1 - c // 2 for c in chi)}
        self.forest = star_nodes.Forest(self.patches, 10 ** 9)
        self.components = [[] for _ in chi]                 # star boxes

    def prove(self):
        for patch in self.patches:
            self.plan.trees.append([self.tree(node) for node in star_nodes.root_nodes(patch)])
        self.walk()
        self.plan.values["bodies"] = sum(sign for _, sign, _, _ in self.plan.walks)
        return self

    def certificate(self):
        return self.plan.certificate(self.model)

    def tree(self, node):
        box = self.star_box(node)
        if box is None and node.level == self.deepest:
            if not node.patch.is_flat:
                raise ValueError("no box at %r of patch %d" % (node.at, node.patch.index))
            lo, size = self.grown(node, 1.05)
            box = Box(1, lo, size)
        if box is None:
            return [self.tree(kid) for kid in node.children()]
        self.plan.boxes.append(box)
        number = len(self.plan.boxes) - 1
        if box.kind == 0:
            self.components[node.patch.component].append(number)
        return number

    def grown(self, node, factor):
        lo, hi = node.hull()
        lo, hi = [n // d for n, d in lo], [-(-n // d) for n, d in hi]
        least = max(h - l for l, h in zip(lo, hi)) // 3 + 8
        lo, size = zip(*[(int((l + h - max(h - l, least) * factor) // 2), int(max(h - l, least) * factor) + 2) for l, h in zip(lo, hi)])
        return lo, size

    def star_box(self, node):
        lo, size = self.grown(node, self.factor)
        hi = [a + s for a, s in zip(lo, size)]
        probe = type("Probe", (), {"lo": lo, "hi": hi})
        half = max(size) // 2

        def small(piece):
            a, b = piece.hull()
            return max(q[0] // q[1] - p[0] // p[1] for p, q in zip(a, b)) <= half

        pieces = self.forest.descend(star_nodes.misses_box(probe), "C2", lambda n: small(n) or n.level == read.MAX_DEPTH)
        if len(pieces) > 400:
            return None
        rows = []
        for piece in pieces:
            d, x, y, z = [[c for row in a for c in row] for a in piece.coefficients()]
            keep = piece.kept(piece.coefficients())
            if keep is False:
                return None
            for i in range(0, len(d), 1 + len(d) // 12):
                length = math.isqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i])
                if length and (keep is True or keep[i]):
                    rows.append((ratio(x[i], length), ratio(y[i], length), ratio(z[i], length), ratio(d[i], length)))
        rows = list(dict.fromkeys(rows))
        rows = rows[::1 + len(rows) // 120]
        for minus, plus in self.centres(rows, lo, hi):
            offsets = [[int(c) - a for c, a in zip(p, lo)] for p in (minus, plus)]
            if any(not 0 < o < s for p in offsets for o, s in zip(p, size)):
                continue
            box = Box(0, lo, size, *offsets)
            if self.holds(box):
                return box
        return None

    def centres(self, rows, lo, hi):
        """Solves the rows n.c < d (for c-) and n.c > d (for c+): pushes c along the worst one, inside the box."""
        result = []
        for sign in (1, -1):
            c, size = [(a + b) / 2 for a, b in zip(lo, hi)], min(b - a for a, b in zip(lo, hi))
            best, best_gap = c, -math.inf
            for step in range(40):
                gap, worst = min((sign * (r[3] - r[0] * c[0] - r[1] * c[1] - r[2] * c[2]), r) for r in rows)
                if gap > best_gap:
                    best, best_gap = list(c), gap
                move = max(size * 0.5 * 0.87 ** step, 0)
                c = [min(max(v - sign * move * n, a + 0.02 * (b - a) + 1), b - 0.02 * (b - a) - 1)
                     for v, n, a, b in zip(c, worst, lo, hi)]
            if best_gap <= 0:
                return
            result.append(best)
        yield result

    def holds(self, box):
        probe = check_box(box)
        before, self.forest.work = self.forest.work, 10 ** 5
        try:
            nodes = self.forest.descend(star_nodes.misses_box(probe), "C2", lambda n: n.has_s1(probe.c))
            return star_crossing.Crossing(nodes, probe, lambda units: self.forest.spend("C2", units)).number() == 1
        except read.Reject:
            return False
        finally:
            self.forest.work = before

    def walk(self):
        """From c+ or c- of some box straight to infinity or to a box of an earlier component."""
        done = []
        while len(done) < len(self.components):
            for n in range(len(self.components)):
                if n not in done:
                    found = self.first_walk(n, done)
                    if found:
                        self.plan.walks.append(found)
                        done.append(n)
                        break
            else:
                raise ValueError("no walk found")

    def first_walk(self, n, done):
        for number in self.components[n]:
            box = self.probe(self.plan.boxes[number])
            for sign in (1, 0):
                for end in range(6 if sign else 0):
                    ray = [0, 0, 0]
                    ray[end // 2] = 1 - 2 * (end % 2)
                    if self.is_free(star_nodes.misses_segment(box.c[sign], ray, True)):
                        return number, sign, [], end
                for other in [b for m in done for b in self.components[m][:12]]:
                    to = self.probe(self.plan.boxes[other]).c[sign]
                    if self.is_free(star_nodes.misses_segment(box.c[sign], star_triangles.sub(to, box.c[sign]), False)):
                        return number, sign, [], (other, sign)
        return None

    def probe(self, box):
        return check_box(box)

    def is_free(self, misses):
        before, self.forest.work = self.forest.work, 10 ** 6
        try:
            self.forest.descend(misses, "W1", lambda n: False)
            return True
        except read.Reject:
            return False
        finally:
            self.forest.work = before


def check_box(box):
    lo = [a << box.shift for a in box.lo]
    hi = [a + s << box.shift for a, s in zip(box.lo, box.size)]
    c = [[a + o << box.shift for a, o in zip(box.lo, offset)] for offset in (box.minus, box.plus)] if box.kind == 0 else []
    return type("Probe", (), {"lo": lo, "hi": hi, "c": c, "kind": box.kind})


def ratio(a, b):
    return float(Fraction(a, b)) if b > 1 << 900 or abs(a) > 1 << 900 else a / b
