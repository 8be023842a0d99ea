# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Reference prover of the claim points-1 for expressions of small solids, honest by default, and an oracle of their words.

The oracle knows solids as intersections of half-spaces, and tries all cells of the planes through a point: no winding number, no wedge.
"""
import hashlib
import itertools
import json
import random
from fractions import Fraction as Q

import fan_forge
import forge
import patch_points_forge as curved
import points_forge
from points_forge import tokens_of

ON, OPEN, NOT_COVERED = 12, 13, 14
MOST_TABLE = 12


# ---------------------------------------------------------------- solids as half-spaces

NORMALS = ((1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1), (1, -1, 0), (0, 1, -1))


def directions_of(size):
    """Off all planes with these normals."""
    everything = itertools.product(range(-size, size + 1), repeat=3)
    return [d for d in everything if all(forge.dot(n, d) for n in NORMALS)]


def cells_of(directions):
    """One direction in each cell of the planes."""
    found = {}
    for d in sorted(directions, key=lambda d: forge.dot(d, d)):
        found.setdefault(tuple(forge.dot(n, d) > 0 for n in NORMALS), d)
    return found


CELLS = cells_of(directions_of(4))
assert CELLS.keys() == cells_of(directions_of(7)).keys()
CELLS = list(CELLS.values())


class Solid:
    """planes: (n, c) of the half-spaces n.x <= c, n a normal of the list or its negative.  data: the file.  poles: points of the boundary
    to which sides of patches are collapsed."""
    poles = ()

    def __init__(self, planes, low, high, data, form):
        self.planes, self.low, self.high, self.data, self.form = planes, low, high, data, form

    def side(self, q):
        """-1 inside, 0 on the boundary, 1 outside."""
        rest = [forge.dot(n, q) - c for n, c in self.planes]
        return 1 if max(rest) > 0 else 0 if 0 in rest else -1

    def bit(self, q, d):
        """Whether points near q in the direction d are inside."""
        return all(forge.dot(n, q) < c or forge.dot(n, q) == c and forge.dot(n, d) < 0 for n, c in self.planes)


class MeshSolid(Solid):
    def __init__(self, planes, points, tris, rng, as_indexed):
        self.model = forge.Model(points, tris, rng.choice(forge.FORMATS), as_indexed, rng.randrange(3))
        self.mesh = forge.mesh_of(self.model)
        bounds = [[choose(p[k] for p in points) for k in range(3)] for choose in (min, max)]
        super().__init__(planes, *bounds, self.model.encode(), self.model.fmt)

    def head(self):
        return len(self.mesh.tris).to_bytes(4, "little") + len(self.mesh.p).to_bytes(4, "little")

    def places(self, q):
        """The codes of the places at which the boundary has the point."""
        return [forge.varint(f) for f in points_forge.triangles_at(self.mesh, q)]

    def any_place(self, rng):
        return forge.varint(rng.randrange(len(self.mesh.tris)))


class PatchSolid(Solid):
    by_faces = 0

    def __init__(self, planes, part, rng):
        self.entities = list(part.entities)
        rng.shuffle(self.entities)
        low, high = ([side[k] for side in part.size] for k in (0, 1))
        super().__init__(planes, low, high, curved.Solid([]).encode() if not self.entities else encode(self.entities), "vjson")

    def head(self):
        count = len(self.entities).to_bytes(4, "little")
        axis = curved.patch_forge.u32(2) + curved.patch_forge.rational(0) + curved.patch_forge.rational(1)
        return bytes([self.by_faces]) + 2 * count + b"".join(2 * axis for e in self.entities if e["kind"] == "surface")

    def places(self, q):
        found = []
        for number, entity in enumerate(self.entities):
            at = parameters_of(entity, q)
            if at is not None:
                found.append(place_code(number, at))
        return found

    def any_place(self, rng):
        number = rng.randrange(len(self.entities))
        return place_code(number, curved.parameters(self.entities[number], rng))


class BallSolid(PatchSolid):
    """The unit ball; of its boundary only the places with known parameters."""

    def __init__(self, rng):
        super().__init__([], curved.ball(), rng)
        self.known = {}

    def side(self, q):
        level = sum(x * x for x in q) - 1
        return (level > 0) - (level < 0)

    def bit(self, q, d):
        raise ValueError("not flat")

    def point(self, rng):
        number = rng.randrange(len(self.entities))
        at = curved.parameters(self.entities[number], rng)
        q = tuple(curved.point_at(self.entities[number], at))
        self.known.setdefault(q, []).append(place_code(number, at))
        return q

    def places(self, q):
        return self.known.get(tuple(q), [])


class FanBox(PatchSolid):
    """A box, some of whose faces consist of petals around one of their points. kind_of: says which, of the number of a face: plain, fan,
    corner, a fault of fan_forge, or None for a rose."""

    def __init__(self, low, high, rng, kind_of=None):
        points, quads = box_corners(low, high)
        petals, self.pole_of, self.known = [], {}, {}
        for face, quad in enumerate(quads):
            corners = [points[v] for v in quad]
            turn, kind = rng.randrange(4), kind_of(face) if kind_of else rng.choice(("plain", "fan", "fan", "corner"))
            corners = corners[turn:] + corners[:turn]
            if kind == "plain":
                petals.append(fan_forge.Petal(fan_forge.plain(corners), None))
                continue
            if kind in ("fan", "corner"):
                a, b, _, d = corners
                s, t = (0, 0) if kind == "corner" else (rng.choice((Q(1, 2), Q(1, 2), Q(1, 4), Q(1, 3))) for _ in range(2))
                pole = fan_forge.plus(a, fan_forge.plus(forge.sub(b, a), forge.sub(d, a), s, t))
                found = fan_forge.fan(corners, pole, rng)
            else:                                         # the name of a fault, or None
                found, pole = fan_forge.rose(corners, rng, kind)
                self.known[tuple(pole)] = found
            petals += found
            self.pole_of[face] = pole
        self.poles = list(self.pole_of.values())
        rng.shuffle(petals)
        self.petals, self.rng = petals, rng
        part = curved.Part([p.entity for p in petals], None, list(zip(low, high)))
        super().__init__(box_planes(low, high), part, random.Random(0))
        order = {id(e): n for n, e in enumerate(self.entities)}
        self.petals.sort(key=lambda p: order[id(p.entity)])

    def places(self, q):
        """All of a point on none but plain and even petals; of the pole of a rose, too."""
        found = []
        for number, p in enumerate(self.petals):
            at = parameters_of(p.entity, q) if p.place_at_pole is None else p.solve(q, self.rng)
            if at is None and p in self.known.get(tuple(q), ()):
                at = p.place_at_pole(self.rng)
            if at is not None:
                found.append(place_code(number, at))
        return found


def place_code(number, at):
    return forge.varint(number) + b"\0" + b"".join(map(curved.patch_forge.rational, at))


def encode(entities):
    return curved.patch_forge.encode_model(entities)


def parameters_of(entity, q):
    """The parameters of a point of a flat patch, which is an affine image of its domain; None if it does not have the point."""
    corner = [curved.point_at(entity, at) for at in ((0, 0), (1, 0), (0, 1))]
    a, b, r = (forge.sub(x, corner[0]) for x in (corner[1], corner[2], q))
    n = forge.cross(a, b)
    if forge.dot(n, r):
        return None
    size = forge.dot(n, n)
    at = Q(forge.dot(n, forge.cross(r, b)), 1) / size, Q(forge.dot(n, forge.cross(a, r)), 1) / size
    return at if curved.is_in_domain(entity, at) else None


def box_planes(low, high):
    return [(tuple(s * (i == k) for i in range(3)), s * side[k]) for k in range(3) for s, side in ((-1, low), (1, high))]


def box_corners(low, high):
    """(corners, those of each face)"""
    points = [tuple((low, high)[i >> k & 1][k] for k in range(3)) for i in range(8)]
    return points, ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6))


def box_mesh(low, high):
    points, quads = box_corners(low, high)
    return points, [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]


def tetrahedron(a, s, kind):
    """(planes, four corners): a corner of a box, cut off; the opposite corner; a path along the axes."""
    x, y, z = a
    if kind == 0:
        planes = [((-1, 0, 0), -x), ((0, -1, 0), -y), ((0, 0, -1), -z), ((1, 1, 1), x + y + z + s)]
        return planes, [a, (x + s, y, z), (x, y + s, z), (x, y, z + s)]
    if kind == 1:
        planes = [((1, 0, 0), x), ((0, 1, 0), y), ((0, 0, 1), z), ((-1, -1, -1), s - x - y - z)]
        return planes, [a, (x - s, y, z), (x, y - s, z), (x, y, z - s)]
    # a_x + s >= X >= Y >= Z >= a_z, relative to a
    planes = [((1, 0, 0), x + s), ((-1, 1, 0), y - x), ((0, -1, 1), z - y), ((0, 0, -1), -z)]
    return planes, [a, (x + s, y, z), (x + s, y + s, z), (x + s, y + s, z + s)]


def oriented(points):
    a, b, c, d = points
    outside = forge.dot(forge.cross(forge.sub(b, a), forge.sub(c, a)), forge.sub(d, a)) > 0
    tris = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
    return tris if outside else [(p, r, q) for p, q, r in tris]


def refined(points, tris, rng):
    """Some triangles get a vertex inside, in binary coordinates: points of faces become vertices."""
    points, out = list(points), []
    for a, b, c in tris:
        if rng.random() < .2:
            points.append(tuple((x + y + 2 * z) / Q(4) for x, y, z in zip(points[a], points[b], points[c])))
            out += [(a, b, len(points) - 1), (b, c, len(points) - 1), (c, a, len(points) - 1)]
        else:
            out.append((a, b, c))
    return points, out


def pyramid(n, floor, rng):
    """Over a polygon at the height `floor`, with its apex (0, 0, 9), where n triangles meet; of its boundary only that point."""
    rim = [(float(i - Q(n, 2)), float(Q(i * i, n) - Q(n, 3)), floor) for i in range(n)]
    tris = [(0, i + 1, (i + 1) % n + 1) for i in range(n)] + [(1, i + 2, i + 1) for i in range(1, n - 1)]
    solid = MeshSolid([], [(0.0, 0.0, 9.0), *rim], tris, rng, False)
    solid.side = lambda q: 0
    return solid


def some_solid(rng, as_indexed):
    low = [rng.randint(0, 3) for _ in range(3)]
    r = rng.random()
    if r < .5:
        high = [c + rng.randint(1, 3) for c in low]
        points, tris = box_mesh(low, high)
        if rng.random() < .3:
            points, tris = refined(points, tris, rng)
        return MeshSolid(box_planes(low, high), points, tris, rng, as_indexed)
    if r < .8:
        planes, points = tetrahedron(tuple(low), rng.randint(1, 3), rng.randrange(3))
        return MeshSolid(planes, points, oriented(points), rng, as_indexed)
    half = Q(rng.randint(1, 3), 2)
    if r < .86:
        return FanBox(low, [c + rng.randint(1, 2) for c in low], rng)
    if r < .95:
        middle = [c + half for c in low]
        part = curved.cube(rng.choice((1, 1, 2))).placed([half] * 3, middle)
        return PatchSolid(box_planes(low, [c + 2 * half for c in low]), part, rng)
    planes, _ = tetrahedron(tuple(low), 2 * half, 0)
    return PatchSolid(planes, curved.tetrahedron().placed([2 * half] * 3, low), rng)


def is_in_box(solid, q):
    return all(a <= x <= b for a, x, b in zip(solid.low, q, solid.high))


class BoxVariable(Solid):
    """A box of complements."""

    def __init__(self, low, high):
        super().__init__(box_planes(low, high), low, high, None, None)


# ---------------------------------------------------------------- chain files

class Chain:
    """tree: a name, ("!", tree) or (operator, tree, tree).  operands: {name: Solid or Chain}.  paths: {name: path}."""

    def __init__(self, tree, operands, paths, box):
        self.tree, self.operands, self.paths, self.box = tree, operands, paths, BoxVariable(*box)
        self.form, self.changed = "chain", {}             # changed: keys of the file

    @property
    def data(self):
        names = leaves_of(self.tree)
        content = {"schema": "veritope-chain-1", "tool": "forge", "expression": text_of(self.tree),
                   "operands": [{"name": name, "path": self.paths[name], "sha256": hashlib.sha256(self.operands[name].data).hexdigest(),
                                 "format": self.operands[name].form} for name in sorted(set(names))],
                   "box": [str(c) for c in (*self.box.low, *self.box.high)], "boundary": "not certified", **self.changed}
        return json.dumps(content).encode()

    def files(self, folder=""):
        """{path: bytes} of all files that it names."""
        found = {}
        for name, operand in self.operands.items():
            path = folder + self.paths[name]
            found[path] = operand.data
            if isinstance(operand, Chain):
                found.update(operand.files(path[:path.rfind("/") + 1]))
        return found

    def flat(self, known):
        """The tree with variables as leaves; equal files are one variable, equal boxes, too.  known: {key: variable}."""
        def walk(tree):
            if isinstance(tree, str):
                operand = self.operands[tree]
                if isinstance(operand, Chain):
                    return operand.flat(known)
                return known.setdefault((operand.data, operand.form), operand)
            if tree[0] == "!":
                inner = walk(tree[1])
                return "-", known.setdefault((tuple(self.box.low), tuple(self.box.high)), self.box), inner
            return tree[0], walk(tree[1]), walk(tree[2])

        return walk(self.tree)

    def load(self, known):
        """The solids in the order in which their files are first named."""
        for name in dict.fromkeys(leaves_of(self.tree)):
            operand = self.operands[name]
            key = operand.data, operand.form
            if key in known:
                continue
            known[key] = None if isinstance(operand, Chain) else operand
            if isinstance(operand, Chain):
                operand.load(known)
        return [operand for operand in known.values() if operand]


def leaves_of(tree):
    return [tree] if isinstance(tree, str) else [name for part in tree[1:] for name in leaves_of(part)]


def text_of(tree):
    if isinstance(tree, str):
        return tree
    return "!(%s)" % text_of(tree[1]) if tree[0] == "!" else "(%s %s %s)" % (text_of(tree[1]), tree[0], text_of(tree[2]))


def random_tree(rng, names, depth):
    if depth == 0 or rng.random() < .2:
        return rng.choice(names)
    if rng.random() < .15:
        return "!", random_tree(rng, names, depth - 1)
    return rng.choice("|&-+"), random_tree(rng, names, depth - 1), random_tree(rng, names, depth - 1)


def random_chain(rng, as_indexed, nesting=1):
    operands, paths = {}, {}
    for i in range(rng.choice((1, 2, 2, 3, 3, 4))):
        name, r = "ABCD"[i], rng.random()
        if r < .2 and nesting:
            operands[name], paths[name] = random_chain(rng, as_indexed, nesting - 1), "inner%d/%s.json" % (i, name)
        elif r < .3 and operands:
            operands[name], paths[name] = rng.choice(list(operands.values())), "copy_of_%s" % name
        else:
            operands[name], paths[name] = some_solid(rng, as_indexed), rng.choice(("", "parts/")) + name.lower()
    for name, operand in operands.items():                # a copy of an expression finds its files where the expression does
        if isinstance(operand, Chain):
            paths[name] = next(paths[other] for other in operands if operands[other] is operand)
    while True:
        tree = random_tree(rng, sorted(operands), rng.randint(0, 4))
        if set(leaves_of(tree)) == set(operands):
            break
    margin = rng.choice((1, 1, 2))
    inner = [operand.box if isinstance(operand, Chain) else operand for operand in operands.values()]
    low, high = ([choose(side[k] for side in sides) + step for k in range(3)]
                 for choose, step, sides in ((min, -margin, [i.low for i in inner]), (max, margin, [i.high for i in inner])))
    return Chain(tree, operands, paths, (low, high))


class Subject:
    """A chain with what follows from it: tree of variables, solids in order."""

    def __init__(self, chain, as_indexed):
        self.chain, self.as_indexed = chain, as_indexed
        self.tree, self.solids = chain.flat({}), chain.load({})
        self.variables = list(dict.fromkeys(variables_of(self.tree)))
        self.num_leaves = sum(v in self.solids for v in variables_of(self.tree))

    def word(self, q):
        """The true word; None where a wall is not flat and others matter there, too."""
        near = [v for v in self.variables if v.side(q) == 0]
        bits = {v: v.side(q) < 0 for v in self.variables}
        if any(isinstance(v, BallSolid) for v in near):
            values = {value_of(self.tree, {**bits, **dict(zip(near, some))}) for some in itertools.product((False, True), repeat=len(near))}
            return "on" if len(near) == 1 and len(values) == 2 else None if len(values) == 2 else "in" if values.pop() else "out"
        values = {value_of(self.tree, {**bits, **{v: v.bit(q, d) for v in near}}) for d in CELLS}
        return "on" if len(values) == 2 else "in" if values.pop() else "out"


def variables_of(tree):
    return [tree] if isinstance(tree, Solid) else [v for part in tree[1:] for v in variables_of(part)]


def value_of(tree, bits):
    if isinstance(tree, Solid):
        return bits[tree]
    a, b = value_of(tree[1], bits), value_of(tree[2], bits)
    return a or b if tree[0] in "|+" else a and (b if tree[0] == "&" else not b)


class Files:
    """Reads files for the Python checker.  contents: {path: bytes}.  refused: the exception of the checker."""

    def __init__(self, contents, refused):
        self.contents, self.refused = contents, refused

    def __call__(self, name):
        if name not in self.contents:
            raise self.refused("%r does not exist" % name)
        return self.contents[name]


# ---------------------------------------------------------------- the prover

class Beliefs:
    """What a prover says of the variables at a point: True, False, "on" or "open".  The walk of the page asks for them."""

    def __init__(self, subject, q, rng, changed=()):
        self.subject, self.q, self.asked = subject, q, []
        side = {1: False, 0: "on", -1: True}
        self.says = {v: side[v.side(q)] for v in subject.variables}
        self.says.update(changed)
        self.rng = rng

    def ask(self, v):
        if v not in self.asked:
            self.asked.append(v)
        return self.says[v]

    def walk(self, tree=None):
        """True, False or "mixed"."""
        tree = self.subject.tree if tree is None else tree
        if isinstance(tree, Solid):
            value = self.ask(tree)
            return value if isinstance(value, bool) else "mixed"
        a = self.walk(tree[1])
        if a is (tree[0] in "|+"):
            return a
        b = self.walk(tree[2])
        if tree[0] == "-" and b != "mixed":
            b = not b
        forcing = tree[0] in "|+"
        return forcing if forcing in (a, b) else "mixed" if "mixed" in (a, b) else not forcing

    def conclusion(self):
        """The word; None if checkers refuse to conclude; "walls" if several flat walls decide."""
        value = self.walk()
        if value != "mixed":
            return "in" if value else "out"
        mixed = [v for v in self.asked if not isinstance(self.says[v], bool)]
        fixed = {v: bool(self.says[v]) for v in self.subject.variables if v not in mixed}
        if len(mixed) <= MOST_TABLE:
            def f(bits):
                return value_of(self.subject.tree, {**fixed, **dict(zip(mixed, bits))})
            table = {bits: f(bits) for bits in itertools.product((False, True), repeat=len(mixed))}
            relevant = [v for k, v in enumerate(mixed)
                        if any(table[bits] != table[bits[:k] + (not bits[k],) + bits[k + 1:]] for bits in table)]
            if not relevant:
                return "in" if table[(False,) * len(mixed)] else "out"
        else:
            relevant = mixed
        if any(self.says[v] == "open" for v in relevant):
            return None
        if len(relevant) == 1:
            return "on"
        return None if any(isinstance(v, BallSolid) for v in relevant) else "walls"

    def codes(self, lie=False):
        """One for each solid that is asked for and whose box holds the point.  lie: `on` of a point that is not may have any place."""
        out = b""
        for v in self.asked:
            if isinstance(v, BoxVariable) or not is_in_box(v, self.q):
                continue
            says = self.says[v]
            if isinstance(says, bool):
                out += bytes([6 * says + self.rng.randrange(6)])
            elif says == "open":
                out += bytes([OPEN])
            else:
                places = v.places(self.q)
                out += bytes([ON]) + (self.rng.choice(places) if places else v.any_place(self.rng))
        return out


class Line:
    def __init__(self, tokens, word, codes):
        self.tokens, self.word, self.codes = tokens, word, codes

    def text(self):
        f = {"in": "1", "out": "0"}.get(self.word, "-")
        return "%s %s %s -\n" % (" ".join(self.tokens), self.word, f)

    def point(self, decimals):
        return [points_forge.meaning(token, decimals) for token in self.tokens]

    def changed(self, **fields):
        return Line(**{**vars(self), **fields})


class Plan:
    """Everything that an answers file and its certificate are made of; a liar changes parts of it."""

    def __init__(self, subject, lines, decimals):
        self.subject, self.lines, self.decimals = subject, list(lines), decimals
        self.values, self.heads, self.extra, self.not_covered = {}, None, b"", None
        self.counts, self.claimed_answers, self.magic = {}, None, b"VTPT"

    def copy(self, **changes):
        plan = Plan(self.subject, self.lines, self.decimals)
        plan.__dict__.update({**self.__dict__, "lines": list(self.lines), **changes})
        return plan

    def with_line(self, number, **fields):
        plan = self.copy()
        plan.lines[number] = plan.lines[number].changed(**fields)
        return plan

    def answers(self):
        return "".join(line.text() for line in self.lines).encode()

    def body(self):
        marked = sum(line.codes == bytes([NOT_COVERED]) and line.word != "undecided" for line in self.lines)
        counts = {"solids": len(self.subject.solids), "leaves": self.subject.num_leaves, "points": len(self.lines), "marked": marked, **self.counts}
        head = b"".join(counts[key].to_bytes(size, "little") for key, size in (("solids", 4), ("leaves", 4), ("points", 8), ("marked", 8)))
        heads = b"".join(solid.head() for solid in self.subject.solids) if self.heads is None else self.heads
        return self.magic + head + heads + b"".join(line.codes for line in self.lines if line.word != "undecided") + self.extra

    def certificate(self, model_bytes, as_indexed):
        answers, body = self.answers() if self.claimed_answers is None else self.claimed_answers, self.body()
        words = [line.word for line in self.lines]
        statement = {"certificate": "veritope-certificate-1", "tool": "forge", "claim": "points-1",
                     "subject_sha256": hashlib.sha256(model_bytes).hexdigest(), "subject_bytes": len(model_bytes), "subject_format": "chain",
                     "reading_rule": forge.READING_RULE, "as_indexed": as_indexed, "body_sha256": hashlib.sha256(body).hexdigest(),
                     "answers_sha256": hashlib.sha256(answers).hexdigest(), "answers_bytes": len(answers), "decimals": self.decimals,
                     "winding": False, "points": len(words), "on": words.count("on"), "undecided": words.count("undecided"), **self.values}
        return json.dumps(statement, separators=(",", ":")).encode() + b"\n" + body

    def holds(self):
        """Whether every covered line says what is so."""
        return all(line.word == "undecided" or line.codes == bytes([NOT_COVERED]) or
                   line.word == self.subject.word(line.point(self.decimals)) for line in self.lines)


def true_line(subject, q, rng, decimals):
    tokens = [rng.choice(tokens_of(Q(c), decimals)) for c in q]
    word, beliefs = subject.word(q), Beliefs(subject, q, rng)
    concluded = beliefs.conclusion()
    if concluded is None:
        return Line(tokens, word or "on", bytes([NOT_COVERED]))
    if rng.random() < .3:                                 # say less, if that suffices
        silent = {v: "open" for v in subject.solids if is_in_box(v, q) and rng.random() < .5}
        other = Beliefs(subject, q, rng, silent)
        if other.conclusion() in (word, concluded):
            beliefs = other
    codes = beliefs.codes()
    if codes and rng.random() < .05:
        codes = bytes([NOT_COVERED])
    return Line(tokens, word, codes)


def interesting(subject, rng, count):
    """Points on a grid on which all walls are, and between."""
    for _ in range(count):
        unit = rng.choice((1, 1, 1, 2, 2, 4, 3))
        q = [Q(rng.randint(-unit, 7 * unit), unit) for _ in range(3)]
        if rng.random() < .5:                             # on a wall of a variable
            v = rng.choice(subject.variables)
            k = rng.randrange(3)
            q[k] = Q(rng.choice((v.low, v.high))[k])
        if rng.random() < .5:                             # within its box
            v = rng.choice(subject.variables)
            q = [min(max(c, Q(a)), Q(b)) for c, a, b in zip(q, v.low, v.high)]
        poles = [pole for v in subject.variables for pole in v.poles]
        if poles and rng.random() < .3:
            q = list(map(Q, rng.choice(poles)))
        yield q


def true_plan(subject, rng, count=6):
    decimals = rng.choice(("nearest", "exact"))
    return Plan(subject, [true_line(subject, q, rng, decimals) for q in interesting(subject, rng, count)], decimals)


def random_subject(rng):
    as_indexed = rng.random() < .3
    return Subject(random_chain(rng, as_indexed), as_indexed)


if __name__ == "__main__":
    print(true_plan(random_subject(random.Random(1)), random.Random(1)).answers().decode())
