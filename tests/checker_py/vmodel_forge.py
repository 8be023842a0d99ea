# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Writes bodies and certificates of vmodel-1, whatever they say, and proves small V-models: tests only. Pieces, determinants, glued
faces and numbers are computed here in the tests' own way (blossoms, Leibniz's formula, raised degrees); the proof of X is that of
star_box_2_forge.py."""
import copy
import hashlib
import json
import math
from fractions import Fraction as Q
from itertools import permutations, product

import model_texts as texts
import star_box_2_forge as forge2
import star_box_forge as forge
from volume_folded_forge import made_rational

OTHERS = ((1, 2), (0, 2), (0, 1))
PARAMETERS = (((2, 1), (1, 2)), ((0, 2), (2, 0)), ((1, 0), (0, 1)))
POINT, FIRST, SECOND = "point", "first", "second"
LEAF = 0                                                  # a tree: LEAF, or (axis, lower half, upper half)


# ---------------------------------------------------------------- pieces

def blossom(points, knots, p, k, at):
    """The polar form of the span k at p parameters."""
    d = list(points[k - p:k + 1])
    for r in range(1, p + 1):
        for i in range(p, r - 1, -1):
            low, high = knots[k - p + i], knots[k + 1 + i - r]
            t = (at[r - 1] - low) / (high - low)
            d[i] = tuple((1 - t) * a + t * b for a, b in zip(d[i - 1], d[i]))
    return d[p]


def along(net, axis, m, lo, hi):
    """The net with its lines along the axis replaced by their Bezier points on [lo, hi]."""
    p, knots, n = m.degrees[axis], m.knots[axis], m.sizes[axis]
    k = max(i for i, t in enumerate(knots) if t <= lo and i < n)
    found = {}
    for index in {index[:axis] + index[axis + 1:] for index in net}:
        line = [net[index[:axis] + (i,) + index[axis:]] for i in range(n)]
        for j in range(p + 1):
            found[index[:axis] + (j,) + index[axis:]] = blossom(line, knots, p, k, [lo] * (p - j) + [hi] * j)
    return found


def breaks_of(m, added):
    return [sorted({*knots, *map(Q, more)}) for knots, more in zip(m.knots, added)]


def pieces(m, added):
    """[(index, net)], net: homogeneous Bezier points by their indices."""
    breaks, found = breaks_of(m, added), []
    for index in product(*[range(len(b) - 1) for b in breaks]):
        net = m.all()
        for axis, i in enumerate(index):
            net = along(net, axis, m, *breaks[axis][i:i + 2])
        found.append((index, net))
    return found


def times(a, b):
    out = {}
    for i, x in a.items():
        for j, y in b.items():
            k = (i[0] + j[0], i[1] + j[1], i[2] + j[2])
            out[k] = out.get(k, 0) + x * y
    return out


def scaled(values, degrees):
    """Bernstein coefficients times their binomials."""
    return {i: c * math.prod(map(math.comb, degrees, i)) for i, c in values.items()}


def derivative(values, degrees, axis):
    step = tuple(int(a == axis) for a in range(3))
    lower = [p - s for p, s in zip(degrees, step)]
    return scaled({i: values[tuple(x + s for x, s in zip(i, step))] - c for i, c in values.items() if i[axis] < degrees[axis]}, lower)


def determinant(net, degrees, rational, flag):
    """(Bernstein coefficients of N by their indices, its degrees), up to a factor > 0."""
    factor = math.lcm(*[Q(c).denominator for p in net.values() for c in p])
    count = 4 if rational else 3
    parts = [{i: int(p[c] * factor) for i, p in net.items()} for c in range(count)]
    rows = [[derivative(a, degrees, axis) for a in parts] for axis in range(3)]
    if rational:
        rows.append([scaled(a, degrees) for a in parts])
    total = {}
    for order in permutations(range(count)):
        odd = sum(order[i] > order[j] for i in range(count) for j in range(i + 1, count)) % 2
        term = {(0, 0, 0): (-1) ** (odd + bool(flag))}
        for row, c in zip(rows, order):
            term = times(term, row[c])
        for i, c in term.items():
            total[i] = total.get(i, 0) + c
    of_n = [count * p - 1 for p in degrees]
    return {i: Q(total.get(i, 0), math.prod(map(math.comb, of_n, i))) for i in product(*[range(n + 1) for n in of_n])}, of_n


# ---------------------------------------------------------------- zeros and trees

def digits(sub_face):
    return sub_face // 9, sub_face // 3 % 3, sub_face % 3


def sub_face(*ends):
    """The number; None: all of the axis."""
    return sum((2 if e is None else e) * 3 ** (2 - a) for a, e in enumerate(ends))


def on(values, degrees, number):
    return [c for i, c in values.items() if all(d == 2 or x == d * n for x, d, n in zip(i, digits(number), degrees))]


def is_part(number, zero, ends):
    return all(z == 2 or d == z and end[z] for d, z, end in zip(digits(number), digits(zero), ends))


WHOLE = ((True, True),) * 3


def zeros_of(values, degrees):
    """The sub-faces on which N is 0 and that are no part of another one."""
    found = [s for s in range(26) if not any(on(values, degrees, s))]
    return [s for s in found if not any(s != z and is_part(s, z, WHOLE) for z in found)]


def is_leaf(values, degrees, zeros, ends):
    return min(values.values()) >= 0 and all(max(on(values, degrees, s)) > 0 for s in range(27)
                                             if not any(is_part(s, z, ends) for z in zeros))


def halves(values, degrees, axis):
    low, high, n = {}, {}, degrees[axis]
    for start in [i for i in values if i[axis] == 0]:
        def at(k, start=start):
            return start[:axis] + (k,) + start[axis + 1:]
        line = [values[at(k)] for k in range(n + 1)]
        for k in range(n + 1):
            low[at(k)], high[at(n - k)] = line[0], line[-1]
            line = [(a + b) / 2 for a, b in zip(line, line[1:])]
    return low, high


def tree_of(values, degrees, zeros, deepest=6, ends=WHOLE, level=0):
    """A tree all of whose leaves hold; ValueError if none is found."""
    if is_leaf(values, degrees, zeros, ends):
        return LEAF
    if level == deepest:
        raise ValueError("no leaf")
    axis = level % 3
    kids = []
    for which, part in enumerate(halves(values, degrees, axis)):
        inner = list(ends)
        inner[axis] = (ends[axis][0] and which == 0, ends[axis][1] and which == 1)
        kids.append(tree_of(part, degrees, zeros, deepest, inner, level + 1))
    return (axis, *kids)


def encode_tree(tree):
    return b"\0" if tree == LEAF else bytes([1 + tree[0]]) + encode_tree(tree[1]) + encode_tree(tree[2])


# ---------------------------------------------------------------- faces

def face_net(net, axis, end):
    """The points of a face of a net by their two indices."""
    last, (p, q) = max(i[axis] for i in net) * end, OTHERS[axis]
    return {(i[p], i[q]): x for i, x in net.items() if i[axis] == last}


def equal(p, q, v, w):
    return all(a * w == b * v for a, b in zip(p, q))


def collapse_of(net):
    """POINT, FIRST, SECOND or None, of the homogeneous control points of a face."""
    corner = net[0, 0][3]
    if all(equal(x, net[0, 0], x[3], corner) for x in net.values()):
        return POINT
    if all(equal(x, net[0, j], net[i, 0][3], corner) for (i, j), x in net.items()):
        return FIRST
    if all(equal(x, net[i, 0], net[0, j][3], corner) for (i, j), x in net.items()):
        return SECOND
    return None


def moved(at, last, symmetry):
    (i, j), (m, n) = at, last
    if symmetry & 1:
        i, j, m, n = j, i, n, m
    return m - i if symmetry & 2 else i, n - j if symmetry & 4 else j


def raised(line, degree):
    while len(line) <= degree:
        n = len(line)
        line = [tuple((Q(k, n) * a if k else 0) + ((1 - Q(k, n)) * b if k < n else 0)
                      for a, b in zip(line[max(k - 1, 0)], line[min(k, n - 1)])) for k in range(n + 1)]
    return line


def raised_net(net, degrees):
    """The net of a face in these degrees."""
    for axis, degree in enumerate(degrees):
        n, other = max(i[axis] for i in net) + 1, max(i[1 - axis] for i in net) + 1
        lines = [raised([net[(i, j) if axis == 0 else (j, i)] for i in range(n)], degree) for j in range(other)]
        net = {(i, j) if axis == 0 else (j, i): x for j, line in enumerate(lines) for i, x in enumerate(line)}
    return net


def are_equal(a, b):
    """Do these nets of faces agree up to one positive factor, in whatever degrees?"""
    degrees = [max(*[i[k] for i in a], *[i[k] for i in b]) for k in range(2)]
    a, b = raised_net(a, degrees), raised_net(b, degrees)
    return all(equal(a[i], b[i], a[0, 0][3], b[0, 0][3]) for i in a)


class Faces:
    """All faces of cells: nets[f]: of the cell's control points, parts[f]: of its pieces by their places, breaks[f]: brought to [0, 1]."""

    def __init__(self, maps, added):
        self.nets, self.parts, self.breaks = [], [], []
        for m, more in zip(maps, added):
            counts, found = [len(b) - 1 for b in breaks_of(m, more)], pieces(m, more)
            unit = [[(t - b[0]) / (b[-1] - b[0]) for t in b] for b in breaks_of(m, more)]
            for axis, end in product(range(3), range(2)):
                p, q = OTHERS[axis]
                self.nets.append(face_net(m.all(), axis, end))
                self.breaks.append([unit[p], unit[q]])
                self.parts.append({(index[p], index[q]): face_net(net, axis, end) for index, net in found
                                   if index[axis] == end * (counts[axis] - 1)})

    def are_glued(self, f, g, symmetry):
        """Is face f under the symmetry face g?"""
        ours = self.breaks[f][::-1] if symmetry & 1 else self.breaks[f]
        ours = [[1 - t for t in b[::-1]] if symmetry & (4 if k else 2) else b for k, b in enumerate(ours)]
        if ours != self.breaks[g]:
            return False
        last = max(self.parts[f])
        for at, net in self.parts[f].items():
            turned = {moved(i, max(net), symmetry): x for i, x in net.items()}
            if not are_equal(turned, self.parts[g][moved(at, last, symmetry)]):
                return False
        return True


def hand(face, flag):
    return (1 if face % 2 else -1) * (-1 if face // 2 == 1 else 1) * (-1 if flag else 1)


def fits(f, g, flags, symmetry):
    """Do the orientations of the faces and of the symmetry fit?"""
    return hand(f % 6, flags[f // 6]) * hand(g % 6, flags[g // 6]) == (-1) ** (bin(symmetry).count("1") + 1)


def face_of(m, axis, end, flag):
    """The face as an entity of X."""
    axes = PARAMETERS[axis][end][::-1 if flag else 1]
    net, rows = m.all(), []
    index = [0, 0, 0]
    index[axis] = end * (m.sizes[axis] - 1)
    for index[axes[0]] in range(m.sizes[axes[0]]):
        rows.append([])
        for index[axes[1]] in range(m.sizes[axes[1]]):
            rows[-1].append(net[tuple(index)][:None if m.rational else 3])
    return forge.surface(rows, [m.degrees[a] for a in axes], [m.knots[a] for a in axes], m.rational)


# ---------------------------------------------------------------- numbers

class Classes:
    def __init__(self):
        self.of = {}

    def find(self, x):
        while self.of.setdefault(x, x) != x:
            x = self.of[x]
        return x

    def unite(self, x, y):
        self.of[self.find(x)] = self.find(y)


def corner(face, s, t):
    """(cell, three ends)"""
    ends = [0, 0, 0]
    (p, q), ends[face % 6 // 2] = OTHERS[face % 6 // 2], face % 2
    ends[p], ends[q] = s, t
    return face // 6, tuple(ends)


def edge(a, b):
    """The edge between two corners of a cell: (cell, its ends, None along itself)."""
    return a[0], tuple(x if x == y else None for x, y in zip(a[1], b[1]))


def edges_of(cell):
    for axis in range(3):
        for ends in product((0, 1), repeat=2):
            yield cell, ends[:axis] + (None,) + ends[axis:]


def is_collapsed(m, ends):
    net = [x for i, x in m.all().items() if all(e is None or k == e * (n - 1) for k, e, n in zip(i, ends, m.sizes))]
    return all(equal(x, net[0], x[3], net[0][3]) for x in net)


def numbers_of(maps, codes, faces):
    """v_points, v_curves."""
    points, curves = Classes(), Classes()
    for f, code in enumerate(codes):
        if isinstance(code, tuple):
            g, symmetry = code
            image = {c: corner(g, *moved(c, (1, 1), symmetry)) for c in product((0, 1), repeat=2)}
            for c in image:
                points.unite(corner(f, *c), image[c])
            for a, b in (((0, 0), (0, 1)), ((0, 0), (1, 0)), ((1, 1), (0, 1)), ((1, 1), (1, 0))):
                curves.unite(edge(corner(f, *a), corner(f, *b)), edge(image[a], image[b]))
    lines = []
    for n, m in enumerate(maps):
        for cell, ends in edges_of(n):
            if is_collapsed(m, ends):
                points.unite(*[(cell, tuple(e if x is None else x for x in ends)) for e in (0, 1)])
            else:
                lines.append((cell, ends))
        for f in range(6 * n, 6 * n + 6):
            kind = collapse_of(faces.nets[f])
            if kind in (FIRST, SECOND):
                sides = [[corner(f, *(c if kind == SECOND else c[::-1])) for c in ((s, 0), (s, 1))] for s in (0, 1)]
                sides = [[corner(f, s, t) if kind == FIRST else corner(f, t, s) for t in (0, 1)] for s in (0, 1)]
                curves.unite(*[edge(*side) for side in sides])
    return (len({points.find((n, ends)) for n in range(len(maps)) for ends in product((0, 1), repeat=3)}),
            len({curves.find(line) for line in lines}))


# ---------------------------------------------------------------- certificates

class Plan:
    """Everything that a certificate says. added: three lists of breaks a cell; codes: 0, 1, 2 or (face, symmetry); entries: {piece: (zeros,
    tree)}; x: a plan of star_box_2_forge.py, or bytes."""
    claim, magic, tail = "vmodel-1", b"VTVM", b""

    def __init__(self, maps, flags=None, added=None, subject_format="vjson"):
        self.maps, self.flags = maps, flags or [0] * len(maps)
        self.added = added or [[[], [], []] for _ in maps]
        self.codes, self.entries, self.x = [0] * 6 * len(maps), {}, b""
        self.subject_format, self.count, self.values, self.text = subject_format, len(maps), {}, None

    def changed(self, **fields):
        plan = copy.copy(self)
        plan.codes, plan.flags, plan.entries, plan.values = list(self.codes), list(self.flags), dict(self.entries), dict(self.values)
        for key, value in fields.items():
            setattr(plan, key, value)
        return plan

    def body(self):
        out = [self.magic, forge.u32(self.count), bytes(self.flags)]
        for axes in self.added:
            for more in axes:
                out += [forge.varint(len(more)), *map(forge.rational, more)]
        for f, code in enumerate(self.codes):
            out.append(forge.varint(3 + 8 * (code[0] - f - 1) + code[1] if isinstance(code, tuple) else code))
        out.append(self.list_of_entries())
        return b"".join(out) + (self.x if isinstance(self.x, bytes) else self.x.body()) + self.tail

    def list_of_entries(self):
        out, last = [forge.varint(len(self.entries))], 0
        for piece, (zeros, tree) in sorted(self.entries.items()):
            bits = sum(1 << z for z in zeros) if isinstance(zeros, (list, tuple, set)) else zeros
            out += [forge.varint(piece - last), forge.varint(bits), tree if isinstance(tree, bytes) else encode_tree(tree)]
            last = piece + 1
        return b"".join(out)

    def model(self):
        if self.text is None:
            maps = [made_rational(m) for m in self.maps] if self.subject_format == "mfem" else self.maps
            self.text = texts.WRITERS[self.subject_format](maps)
        return self.text

    def numbers(self):
        faces = Faces(self.maps, self.added)
        halves = sum(code != 1 for code in self.codes)
        surfaces = halves - sum(isinstance(code, tuple) for code in self.codes)
        points, curves = numbers_of(self.maps, self.codes, faces)
        euler = points - curves + surfaces - len(self.maps)
        counts = [math.prod(len(b) - 1 for b in breaks_of(*cell)) for cell in zip(self.maps, self.added)]
        of_x = {} if isinstance(self.x, bytes) else {**self.x.values, "boxes": len(self.x.boxes)}
        return {"cells": len(self.maps), "pieces": sum(counts), "half_v_surfaces": halves, "v_surfaces": surfaces, "v_curves": curves,
                "v_points": points, "euler": forge.zigzag_code(euler), "reversed": sum(self.flags),
                "singular": sum(len(zeros) for zeros, _ in self.entries.values()),
                **{key: of_x.get(key, 0) for key in ("patches", "shells", "bodies", "genus", "boxes")}}

    def settled(self):
        """With the numbers that follow from the rest."""
        self.values = self.numbers()
        return self

    def certificate(self, model=None):
        model, body = self.model() if model is None else model, self.body()
        statement = {"certificate": "veritope-certificate-1", "tool": "vmodel_forge", "claim": self.claim,
                     "subject_sha256": hashlib.sha256(model).hexdigest(), "subject_bytes": len(model), "subject_format": self.subject_format,
                     "body_sha256": hashlib.sha256(body).hexdigest(), **self.values}
        return json.dumps(statement, separators=(",", ":")).encode() + b"\n" + body


# ---------------------------------------------------------------- proofs

class ProverOfX(forge2.Prover2):
    def __init__(self, entities, breaks, **options):
        def plan_kind(given, unit):
            plan = forge2.Plan2(given, unit)
            plan.breaks = breaks
            return plan
        self.plan_kind = plan_kind
        super().__init__(entities, search=True, **options)

    def star_box(self, node):
        """Tries several sizes."""
        for self.factor in (1.6, 2.5, 1.2, 4):
            box = super().star_box(node)
            if box:
                return box
        return None


def entities_of_x(plan):
    return [face_of(plan.maps[f // 6], f % 6 // 2, f % 2, plan.flags[f // 6]) for f, code in enumerate(plan.codes) if code == 0]


def breaks_of_x(plan):
    found = []
    for f, code in enumerate(plan.codes):
        if code == 0:
            breaks = breaks_of(plan.maps[f // 6], plan.added[f // 6])
            found.append([breaks[a] for a in PARAMETERS[f % 6 // 2][f % 2][::-1 if plan.flags[f // 6] else 1]])
    return found


def boundary(plan, **options):
    """The plan of X."""
    return ProverOfX(entities_of_x(plan), breaks_of_x(plan), **options).prove().plan


def glued(faces, flags, but=()):
    """The codes: every face that is collapsed, and pairs of equal faces, the first ones first; those of `but` stay in X."""
    codes = [1 if collapse_of(net) else 0 for net in faces.nets]
    for f in range(len(codes)):
        for g in range(f + 1, len(codes)):
            if codes[f] == codes[g] == 0 and f not in but and g not in but:
                found = [s for s in range(8) if fits(f, g, flags, s) and faces.are_glued(f, g, s)]
                if found:
                    codes[f], codes[g] = (g, found[0]), 2
    return codes


def signs_of(plan, deepest=6):
    """The entries; a piece whose signs cannot be shown has a tree of one leaf."""
    found, number = {}, 0
    for m, added, flag in zip(plan.maps, plan.added, plan.flags):
        for _, net in pieces(m, added):
            values, degrees = determinant(net, m.degrees, m.rational, flag)
            zeros = zeros_of(values, degrees)
            try:
                tree = tree_of(values, degrees, zeros, deepest)
            except ValueError:
                tree = LEAF
            if zeros or tree != LEAF:
                found[number] = (zeros, tree)
            number += 1
    return found


def proved(maps, flags=None, added=None, but=(), x=None, **options):
    """The plan of a V-model with all that is right. x: instead of a search, the plan of X."""
    plan = Plan(maps, flags, added)
    plan.codes = glued(Faces(maps, plan.added), plan.flags, but)
    plan.entries = signs_of(plan)
    plan.x = boundary(plan, **options) if x is None else x
    return plan.settled()


def joined_x(*plans):
    """X of several models, each with the boxes and walks that it has alone."""
    new = copy.deepcopy(plans[0])
    for other in map(copy.deepcopy, plans[1:]):
        n = len(new.boxes)
        for name in ("entities", "flags", "breaks", "roots", "boxes", "kinds"):
            setattr(new, name, list(getattr(new, name)) + list(getattr(other, name)))
        new.trees = list(new.trees) + [[shifted(tree, n) for tree in trees] for trees in other.trees]
        new.walks = list(new.walks) + [(box + n, sign, points, end if isinstance(end, int) else (end[0] + n, end[1]))
                                       for box, sign, points, end in other.walks]
        for key, value in other.values.items():
            new.values[key] += value
    new.values["bodies"] = sum(sign for _, sign, _, _ in new.walks)
    return new


def shifted(tree, by):
    return tree + by if isinstance(tree, int) else [shifted(kid, by) for kid in tree]


def together(*plans):
    """The models in one file, with the proofs that they have alone."""
    first = 0
    new = Plan([m for p in plans for m in p.maps], [f for p in plans for f in p.flags], [a for p in plans for a in p.added])
    new.codes, pieces_before = [], 0
    for p in plans:
        new.codes += [(code[0] + first, code[1]) if isinstance(code, tuple) else code for code in p.codes]
        new.entries.update({piece + pieces_before: entry for piece, entry in p.entries.items()})
        first, pieces_before = first + 6 * len(p.maps), pieces_before + p.values["pieces"]
    new.x = joined_x(*[p.x for p in plans])
    return new.settled()
