#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Lying provers against both certificate checkers.

An attack is a model with a claim known to be false (forge.Truth says so) and a certificate in which
everything but that claim is right.  Every attack must be rejected, by both checkers, for the same
condition.  Honest certificates of random models must be accepted.  Run

    python3 tests/mutation/attacks.py --count 100000 --seed 1 --checker PATH_TO_veritope-check

The table counts strategy x rejecting condition; `alone` counts attacks that the Python checker accepts
as soon as that one condition is disabled.  Exit 1 if anything is wrong; the case is saved.
"""
import argparse
import collections
import importlib
import json
import multiprocessing
import os
import pathlib
import random
import struct
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import forge                                              # noqa: E402
import solids                                             # noqa: E402
import time_limit                                         # noqa: E402

CHECKER_PY = HERE.parent.parent / "verify" / "checker" / "veritope_check.py"
CONDITIONS = ["V%d" % i for i in range(1, 12)] + ["I%d" % i for i in range(1, 11)]
UNCOUNTED = ("S1", "S2", "S3", "S4", "B1")                # such a death proves nothing
# V3 and V5 follow from the others (a degenerate triangle never meets its neighbours properly or has a
# shell without volume; two triangles with the same vertices are a shell without volume), so no attack
# can need them alone.  It must need them together with one of these.
IMPLIED = {"V3": ("V9", "V8", "V10"), "V5": ("V10", "V4")}


def load_checker(path=CHECKER_PY):
    """The module `program` of the checker that this file starts, from now on the one that `import veritope_checker` finds."""
    folder = pathlib.Path(path).resolve().parent
    loaded = sys.modules.get("veritope_checker")
    if loaded and pathlib.Path(loaded.__file__).resolve().parent.parent != folder:
        for name in [name for name in sys.modules if name.split(".")[0] == "veritope_checker"]:
            del sys.modules[name]
    sys.path.insert(0, str(folder))
    try:
        return importlib.import_module("veritope_checker.program")
    finally:
        del sys.path[0]


def condition_of(code, message):
    return message.split(":")[0].split()[1] if code == 1 else "ACCEPT" if code == 0 else "exit %d" % code


class Native:
    """The C++ checker: one process for each certificate, files in memory if the system has such. more: the files after the certificate."""

    def __init__(self, path):
        self.path = path and os.path.abspath(path)
        shm = "/dev/shm"
        self.dir = tempfile.mkdtemp(prefix="attacks", dir=shm if os.path.isdir(shm) else None)
        self.files = [os.path.join(self.dir, n) for n in ("model", "cert", "out", "answers")]
        self.last_model = None

    def check(self, model, cert, *more):
        if self.last_model is not model:
            self.write(0, model)
            self.last_model = model
        self.write(1, cert)
        names = self.arguments(more)
        for i, data in enumerate(more):
            self.write(3 + i, data)
        flags = os.O_WRONLY | os.O_CREAT | os.O_TRUNC
        actions = [(os.POSIX_SPAWN_OPEN, 1, self.files[2], flags, 0o600), (os.POSIX_SPAWN_DUP2, 1, 2)]
        pid = os.posix_spawn(self.path, [self.path, *names], {}, file_actions=actions)
        time_limit.limit_process(pid)
        status = os.waitpid(pid, 0)[1]
        with open(self.files[2], "rb") as f:
            return os.waitstatus_to_exitcode(status), f.read().decode("latin-1").strip()

    def arguments(self, more):
        return self.files[:2] + self.files[3:3 + len(more)]

    def write(self, i, data):
        with open(self.files[i], "wb") as f:
            f.write(data)

    def close(self):
        for name in self.files:
            if os.path.exists(name):
                os.remove(name)
        os.rmdir(self.dir)


# ---------------------------------------------------------------- cases

class Case:
    """A model, what is true about it, and the most honest plan for its certificate."""

    def __init__(self, points, tris, rng, fmt=None, as_indexed=None, variant=None):
        self.rng = rng
        as_indexed = rng.random() < .3 if as_indexed is None else as_indexed
        fmt = fmt or rng.choice(forge.FORMATS)
        variant = rng.randrange(3) if variant is None else variant
        if rng.random() < .1 and fmt != "stl":
            points = list(points) + [points[0] if as_indexed else tuple(c + 7 for c in points[0])]
        self.model = forge.Model(points, tris, fmt, as_indexed, variant)
        self.bytes = self.model.encode()
        self.mesh = forge.mesh_of(self.model)
        self.truth = forge.Truth(self.mesh, limit=8)
        self.broken = self.truth.nested(rng)
        self.base = forge.Plan(self.mesh, rng, rng.choice((0, .5, 1)))
        self.open_pairs = self.base.unproved()

    def certificate(self, plan):
        return plan.certificate(self.bytes, self.model)

    def invalid(self, witnesses, rules=None):
        return forge.invalid_certificate(self.bytes, self.model, self.mesh, witnesses, rules)


def valid_case(rng):
    while True:
        points, tris = solids.solid(rng)
        if len(tris) > 200:
            continue
        case = Case(solids.affine(points, rng), tris, rng)
        if not case.broken:
            return case


def false_case(rng):
    """(case that breaks a rule, the same solid before the defect: points and triangles)"""
    while True:
        points, tris = solids.solid(rng)
        before = points, tris
        defect = rng.choice(solids.DEFECTS)
        points, tris = defect(points, tris, rng)
        if not 3 < len(tris) <= 200:
            continue
        state = rng.getstate()
        points = solids.affine(points, rng)
        rng2 = random.Random()
        rng2.setstate(state)
        before = solids.affine(before[0], rng2), before[1]
        try:
            case = Case(points, tris, rng, *as_indexed_often(defect, rng))
        except OverflowError:                             # a power of two too far
            continue
        if case.broken:
            return case, before


def as_indexed_often(defect, rng):
    """(format, as_indexed): two positions in one place are a defect of their own if as indexed."""
    if defect in (solids.copy_at_vertex, solids.copy_at_edge, solids.stack_boxes) and rng.random() < .6:
        return rng.choice(("obj", "ply", "off")), True
    return None, None


# ---------------------------------------------------------------- liars for mesh-valid-1

def with_codes(case, code_of_pair):
    plan = case.base.copy()
    plan.forced = {frozenset(p): bytes(code_of_pair(*p)) for p in case.open_pairs}
    return case.certificate(plan)


def axis_single(case, rng):
    """Each axis code on the offending pairs."""
    if case.open_pairs:
        for code in range(34):
            code = code if code < 17 else code + 15
            yield with_codes(case, lambda a, b: [code])


def open_codes(mesh, a, b):
    """Codes whose test is open, and all codes by how nearly they hold."""
    opened, ranked = [], []
    for c, d in enumerate(forge.axis_vectors(mesh, a, b)):
        if any(d):
            for code, e in ((c, d), (c + 32, forge.neg(d))):
                gap, p, q = forge.apply_axis(mesh, e, mesh.tris[a], mesh.tris[b])
                ranked.append((forge.Fraction(gap, max(map(abs, e))), code))
                if gap == 0:
                    opened.append((len(p) + len(q), code))
    return [c for _, c in sorted(opened)], [c for _, c in sorted(ranked, reverse=True)]


def axis_best(case, rng):
    """The codes that come nearest to holding, touching ones first; alone and with a second byte."""
    if not case.open_pairs:
        return
    table = {p: open_codes(case.mesh, *p) for p in case.open_pairs}
    for k in range(6):
        yield with_codes(case, lambda a, b: [(table[a, b][0] + table[a, b][1])[k:k + 1][0]
                                             if len(table[a, b][0] + table[a, b][1]) > k else 0])
        yield with_codes(case, lambda a, b: [64 | (table[a, b][0] or [0])[k % len(table[a, b][0] or [0])],
                                             rng.choice(table[a, b][1] or [0])])


def axis_chain(case, rng):
    """Two to five bytes, the first ones open where possible."""
    if not case.open_pairs:
        return
    table = {p: open_codes(case.mesh, *p)[0] or [0] for p in case.open_pairs}
    for _ in range(12):
        n = rng.choice((2, 2, 3, 4, 5))
        yield with_codes(case, lambda a, b: [64 | rng.choice(table[a, b]) for _ in range(n - 1)] +
                         [rng.randrange(17) + rng.choice((0, 32))])


def axis_pairs(case, rng):
    """Two bytes: every open code of an offending pair before every code (a sample of 40)."""
    if not case.open_pairs:
        return
    pair = rng.choice(case.open_pairs)
    opened = open_codes(case.mesh, *pair)[0] or [rng.randrange(17)]
    codes = [[64 | first, second + axis] for first in opened for second in (0, 32) for axis in range(17)]
    best = {p: (open_codes(case.mesh, *p)[1] or [0])[:1] for p in case.open_pairs}
    for two in rng.sample(codes, min(40, len(codes))):
        yield with_codes(case, lambda a, b: two if (a, b) == pair else best[a, b])


def axis_malformed(case, rng):
    """Bytes that are no codes: bit 7, axes above 16, a chain without an end."""
    if case.open_pairs:
        for bad in ([128 | rng.randrange(128)], [17 + rng.randrange(15)], [49 + rng.randrange(15)], [64] * 5,
                    [64 | rng.randrange(17)], [255], [96, 96, 96, 96]):
            yield with_codes(case, lambda a, b: bad)


def drop_triangle(case, rng):
    """The offending triangles are left out of `order`, others twice."""
    hot = {f for p in case.open_pairs for f in p[:1]} or {rng.randrange(len(case.mesh.tris))}
    cold = [f for f in case.base.order if f not in hot and all(f not in p for p in case.open_pairs)]
    for k in range(4):
        if cold:
            plan = case.base.copy()
            plan.order = [rng.choice(cold) if f in hot else f for f in plan.order]
            if k % 2:
                rng.shuffle(plan.order)
            yield case.certificate(plan)


def lost_code(case, rng):
    """No code for the offending pairs; sometimes spare codes at the end."""
    if case.open_pairs:
        for spare in (b"", bytes(len(case.open_pairs)), bytes(rng.randrange(17) for _ in case.open_pairs)):
            plan = case.base.copy()
            plan.forced = {frozenset(p): b"" for p in case.open_pairs}
            plan.extra_codes = spare
            yield case.certificate(plan)


def other_order(case, rng):
    """Random orders; the offending pairs borrow the codes of other pairs."""
    for _ in range(4):
        plan = case.base.copy()
        kind = rng.random()
        if kind < .5:
            rng.shuffle(plan.order)
        elif case.open_pairs:                             # the offenders next to each other
            a, b = rng.choice(case.open_pairs)
            plan.order = [a, b] + [f for f in plan.order if f not in (a, b)]
        known = [c for c in case.mesh.codes.values() if c] or [[0]]
        plan.forced = {frozenset(p): bytes(rng.choice(known)) for p in case.open_pairs}
        yield case.certificate(plan)


def transplant(case, rng, before=None):
    """The complete hints of the solid before its defect."""
    if not before or len(before[1]) != len(case.model.tris) or len(before[0]) > len(case.model.points):
        return
    other = Case(before[0], before[1], rng, case.model.fmt, case.model.as_indexed, case.model.variant)
    if other.broken or len(other.mesh.p) != len(case.mesh.p):
        return
    for honest in (0, .5, 1, 1):
        plan = forge.Plan(other.mesh, rng, honest)
        plan.quantities = case.base.quantities
        yield case.certificate(plan)


def hot_vertices(case, rng):
    """Vertices of offending pairs, the shared ones first; else any."""
    pairs = case.open_pairs or [w[:2] for w in case.truth.crossings]
    tris = case.mesh.tris
    both = [v for a, b in pairs for v in set(tris[a]) & set(tris[b])]
    rest = [v for a, b in pairs for v in tris[a] + tris[b]]
    out = list(dict.fromkeys(both + rest))
    return out[:6] if out else [rng.choice(list(case.mesh.at))]


def star_table(case, rng):
    """Every direction of the table on the vertices that the offenders share."""
    for v in hot_vertices(case, rng)[:3]:
        for code in range(1, 14):
            plan = case.base.copy()
            plan.stars[v] = code
            yield case.certificate(plan)


def star_vector(case, rng):
    """Fitted, random, tiny and huge star vectors on vertices of the offenders."""
    mesh = case.mesh
    for v in hot_vertices(case, rng)[:4]:
        fit = [forge.to_i32([sum(mesh.n[f][k] for f in mesh.at[v]) for k in range(3)]),
               forge.to_i32(forge.mean_normal(mesh, v)), (0, 0, 0), (-2 ** 31, 2 ** 31 - 1, -2 ** 31)]
        fit += [tuple(rng.randint(-s, s) for _ in range(3)) for s in (1, 9, 10 ** 6, 2 ** 31 - 1)]
        fit += [forge.to_i32(forge.cross(mesh.n[mesh.at[v][0]], mesh.n[mesh.at[v][-1]]))]
        for d in fit:
            if d:
                plan = case.base.copy()
                plan.stars[v] = d
                yield case.certificate(plan)


def star_many(case, rng):
    """Star codes, fitted or not, on all vertices of the offenders or of the whole mesh."""
    for k in range(4):
        plan = case.base.copy()
        for v in hot_vertices(case, rng) if k < 2 else list(case.mesh.at):
            if v not in plan.stars:
                plan.stars[v] = forge.to_i32(forge.mean_normal(case.mesh, v)) or rng.randint(1, 13)
                if rng.random() < .5:
                    plan.stars[v] = rng.randint(1, 13)
        yield case.certificate(plan)


def sides(case, a, b):
    return [sorted({v for f in s for v in case.mesh.tris[f]}) for s in (a, b)]


def with_cut(case, direction, largest):
    """A forged separator wherever an offending pair is split and both sides are small enough."""
    hot = {frozenset(p) for p in case.open_pairs}
    plan = case.base.copy()

    def cut(a, b, k):
        if max(len(a), len(b)) > largest or not any(frozenset((f, g)) in hot for f in a for g in b):
            return None
        return direction(a, b)
    plan.cut = cut
    return case.certificate(plan)


def separator_random(case, rng):
    """Random, zero and extreme separators at nodes that hold the offenders."""
    if case.open_pairs:
        for largest in (1, 2, 8, 1000):
            for s in (1, 100, 2 ** 31 - 1):
                yield with_cut(case, lambda a, b: tuple(rng.randint(-s, s) for _ in range(3)), largest)
        yield with_cut(case, lambda a, b: (0, 0, 0), 1)
        yield with_cut(case, lambda a, b: (2 ** 31 - 1, -2 ** 31 + 1, 2 ** 31 - 1), 1)


def separator_fit(case, rng):
    """The directions that nearly separate: between centres, normals, edge products, touching ones."""
    if not case.open_pairs:
        return
    mesh = case.mesh

    def centres(a, b):
        va, vb = sides(case, a, b)
        return forge.to_i32([sum(mesh.p[v][k] for v in vb) * len(va) - sum(mesh.p[v][k] for v in va) * len(vb)
                             for k in range(3)]) or (1, 0, 0)

    def touching(a, b, k):
        pairs = [(f, g) for f in a for g in b if (f, g) in case.open_pairs or (g, f) in case.open_pairs]
        f, g = pairs[0]
        opened, ranked = open_codes(mesh, f, g)
        codes = opened + ranked or [0]
        code = codes[k % len(codes)]
        d = forge.axis_vectors(mesh, f, g)[code & 31]
        return forge.to_i32(forge.neg(d) if code & 32 else d) or (0, 0, 1)

    for largest in (1, 3, 1000):
        yield with_cut(case, centres, largest)
        for k in range(5):
            yield with_cut(case, lambda a, b: touching(a, b, k), largest)


def separator_spare(case, rng):
    """Separators for step numbers that never come, or one step too early or too late."""
    for k in range(3):
        plan = case.base.copy()
        plan.walk()
        plan.extra_separators = [(plan.reached + rng.choice((0, 1, 1000, 2 ** 60)), (1, 0, 0))]
        if k:
            at = rng.randrange(max(plan.reached, 1))
            plan.cut = lambda a, b, i: (rng.randint(-9, 9), rng.randint(-9, 9), 1) if i == at else None
            plan.extra_separators = []
        yield case.certificate(plan)


def nesting_codes(case, rng):
    """All nesting codes, together and shell by shell."""
    n = len(case.base.shells)
    if n > 1:
        for code in range(6):
            plan = case.base.copy()
            plan.nesting = [code] * n
            yield case.certificate(plan)
        for _ in range(6):
            plan = case.base.copy()
            plan.nesting = [rng.randrange(6) for _ in range(n)]
            plan.values = {"bodies": rng.randint(0, n)}
            yield case.certificate(plan)


def as_is(case, rng):
    """The most honest certificate that the broken mesh can have, and small variations."""
    for k in range(6):
        plan = forge.Plan(case.mesh, rng, (0, 1, .5)[k % 3])
        if k > 2:
            rng.shuffle(plan.order)
        if k == 5:
            for v in case.mesh.at:
                plan.stars.setdefault(v, rng.randint(1, 13))
        yield case.certificate(plan)


def mixed(case, rng):
    """Several lies at once."""
    for _ in range(6):
        plan = case.base.copy()
        for v in hot_vertices(case, rng):
            if rng.random() < .4:
                plan.stars[v] = rng.randint(1, 13)
        plan.forced = {frozenset(p): bytes([64 | rng.randrange(17), rng.randrange(17)]) if rng.random() < .3 else
                       bytes([rng.randrange(17) + rng.choice((0, 32))]) for p in case.open_pairs}
        if rng.random() < .3:
            rng.shuffle(plan.order)
        if rng.random() < .2:
            plan.cut = lambda a, b, k: (1, 2, 3) if k % 7 == 3 else None
        yield case.certificate(plan)


VALID_LIARS = (axis_single, axis_best, axis_chain, axis_pairs, axis_malformed, drop_triangle, lost_code, other_order, transplant,
               star_table, star_vector, star_many, separator_random, separator_fit, separator_spare,
               nesting_codes, mixed)
HIDDEN = {"M1": "hide_degenerate", "M2": "hide_duplicate", "M3": "hide_open", "M4": "hide_crowded_edge",
          "M5": "hide_misoriented", "M6": "hide_pinch", "M7": "hide_crossing", "M8": "hide_wrong_side",
          "V2": "hide_double_position"}


def false_valid_attacks(rng):
    """(strategy, case, certificate): mesh-valid-1 about a broken mesh."""
    case, before = false_case(rng)
    for cert in as_is(case, rng):
        yield "+".join(HIDDEN[r] for r in sorted(case.broken)[:1]), case, cert
    for liar in VALID_LIARS:
        made = liar(case, rng, before) if liar is transplant else liar(case, rng)
        for cert in made:
            yield liar.__name__, case, cert


def wrong_quantities(rng):
    """A valid solid, one stated quantity off."""
    case = valid_case(rng)
    true = case.base.quantities()
    p, q = map(int, true["volume"].split("/"))
    lies = [(k, true[k] + d) for k in true if k != "volume" for d in (1, -1, 2) if true[k] + d >= 0]
    lies += [("volume", "%d/%d" % v) for v in ((p + q, q), (p + 1, q), (p, q + 1), (q, p), (0, 1),
                                               (p * 2 // forge.math.gcd(2 * p, q), q // forge.math.gcd(2 * p, q)),
                                               (p, 2 * q))
             if forge.math.gcd(*v) == 1 and v != (p, q)]
    for key, value in lies:
        plan = case.base.copy()
        plan.values = {key: value}
        yield "wrong_quantity", case, case.certificate(plan)


# ---------------------------------------------------------------- liars for mesh-invalid-1

def barycentric_lies(case, rng):
    """M7 witnesses that are almost right: common points, disguised weights, wrong denominators."""
    mesh, n = case.mesh, len(case.mesh.tris)
    f = rng.randrange(n)
    near = [g for v in mesh.tris[f] for g in mesh.at[v] if g != f]
    g = rng.choice(near) if rng.random() < .8 else rng.randrange(n)
    tf, tg = mesh.tris[f], mesh.tris[g]
    common = [v for v in tf if v in tg]
    yield f, g, [0, 0, 0], [0, 0, 0]
    yield f, f, [1, 1, 1], [1, 1, 1]
    yield f, g, [1, 1, 1], [0, 0, 0]
    yield f, g, [0, 0, 0], [1, 2, 3]
    for k in range(4):                                    # points of the common edge or vertex
        big = rng.choice((1, 7, 2 ** 70))
        w = {v: rng.randint(1, 9) * big for v in common}
        x = [w.get(v, 0) for v in tg]
        w = [w.get(v, 0) for v in tf]
        yield f, g, w, x
        yield f, g, [2 * c for c in w], x
        yield f, g, w, [c + (rng.random() < .3) for c in x]
        yield f, g, [c + (rng.random() < .3) for c in w], x
        if k:
            yield f, g, x, w
            yield f, g, sorted(w), sorted(x)
    for _ in range(3):                                    # equal in two coordinates only
        w = projected_meeting(mesh, f, g, rng)
        if w:
            yield (f, g) + w
    h = rng.randrange(n)
    yield f, h, [rng.randint(0, 3) for _ in range(3)], [rng.randint(0, 3) for _ in range(3)]
    yield f, h, [rng.randint(1, 2 ** 90) for _ in range(3)], [1, 1, 1]


def projected_meeting(mesh, f, g, rng):
    """Weights of a point of f that looks like a point of g along an axis."""
    k = rng.randrange(3)
    i, j = (k + 1) % 3, (k + 2) % 3
    w = [rng.randint(1, 5) for _ in range(3)]
    p = [forge.Fraction(sum(c * mesh.p[v][m] for c, v in zip(w, mesh.tris[f])), sum(w)) for m in range(3)]
    a, b, c = ([mesh.p[v][i], mesh.p[v][j]] for v in mesh.tris[g])
    area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    if not area:
        return None

    def part(u, v):
        return ((u[0] - p[i]) * (v[1] - p[j]) - (u[1] - p[j]) * (v[0] - p[i])) / area
    x = [part(b, c), part(c, a), part(a, b)]
    if min(x) < 0:
        return None
    return w, forge.integers(x)


def false_invalid_witnesses(case, rng):
    """(strategy, witness) for rules that the mesh does not break."""
    mesh, n, nv = case.mesh, len(case.mesh.tris), len(case.mesh.p)
    for _ in range(4):
        f, g, v = rng.randrange(n), rng.randrange(n), rng.randrange(nv)
        a, b, c = rng.choice(mesh.tris)
        yield "false_M1", (1, f)
        yield "false_M2", (2, f, f)
        yield "false_M2", (2, f, rng.choice(mesh.at[mesh.tris[f][0]]))
        yield "false_M2", (2, f, g)
        for rule in (3, 4, 5):
            for e in ((a, b), (b, a), (a, a), (a, v)):
                yield "false_M%d" % rule, (rule,) + e
        yield "false_M6", (6, a)
        yield "false_M6", (6, v)
        for u in range(3):
            yield "false_M8", (8, f, u)
            yield "false_M9", (9, f, u)
    for w in barycentric_lies(case, rng):
        yield "false_M7", (7,) + w


def false_invalid_attacks(rng):
    """mesh-invalid-1 about a valid solid, or for a rule that the broken mesh does not break."""
    if rng.random() < .7:
        case = valid_case(rng)
    else:
        case = false_case(rng)[0]
    sure = {"M%d" % k for k in range(1, 8)} | (set() if case.broken else {"M8", "M9"})
    true = forge.true_witnesses(case.truth, rng)
    for name, w in false_invalid_witnesses(case, rng):
        if "M%d" % w[0] in sure - case.broken:
            others = [x for r, x in true.items() if rng.random() < .3 and r != w[0]]
            yield name, case, case.invalid(sorted(others + [w], key=lambda x: x[0]))
    for rules in unproved_rules(true, sure - case.broken, rng):
        yield "false_rule_list", case, case.invalid([true[r] for r in sorted(true)], rules)


def unproved_rules(true, absent, rng):
    if true:
        for extra in sorted(absent):
            yield sorted({"M%d" % r for r in true} | {extra})
        for extra in sorted(absent)[:3]:
            yield sorted(({"M%d" % r for r in true} | {extra}) - {"M%d" % min(true)})


def attacks(rng):
    kind = rng.random()
    if kind < .72:
        return false_valid_attacks(rng)
    return wrong_quantities(rng) if kind < .8 else false_invalid_attacks(rng)


# ---------------------------------------------------------------- honest certificates

def honest_certificates(rng):
    """(name, case, certificate) that must be accepted."""
    case = valid_case(rng)
    if case.open_pairs:
        yield "no_chain_found", case, b""
    for k in range(2):
        plan = forge.Plan(case.mesh, rng, (1, 0)[k])
        plan.detours = rng.choice((0, .2, 1))
        if rng.random() < .5:
            rng.shuffle(plan.order)
        if rng.random() < .5:
            share = rng.choice((.1, .5, 1))
            plan.cut = lambda a, b, i: (forge.separator(case.mesh, *sides(case, a, b), rng)
                                        if rng.random() < share else None)
        yield "valid", case, case.certificate(plan)
    broken = false_case(rng)[0]
    true = forge.true_witnesses(broken.truth, rng)
    if true:
        yield "invalid", broken, broken.invalid([true[r] for r in sorted(true)])
        w = rng.choice(sorted(true.items()))[1]
        yield "invalid", broken, broken.invalid([w, w])


# ---------------------------------------------------------------- running

class Run:
    """Counts of one worker; plain data, so that workers can send them back."""

    conditions, implied, often_enough = CONDITIONS, IMPLIED, 10
    attacks, honest_certificates = staticmethod(attacks), staticmethod(honest_certificates)

    def __init__(self, options):
        self.options = options
        self.py = load_checker(options.python_checker)
        self.native = Native(options.checker)
        self.table = collections.Counter()                # (strategy, condition)
        self.alone = collections.Counter()
        self.failures = []
        self.honest = collections.Counter()

    def in_python(self, model, cert, *more):
        return time_limit.within_limit(self.py.check, model, cert, *more)

    def more(self, case):
        """The files after the certificate that the checkers are given."""
        return ()

    def both(self, case, cert, seed, name):
        more = self.more(case)
        code, message = self.in_python(case.bytes, cert, *more)
        found = condition_of(code, message)
        if code not in (0, 1):
            self.fail("python checker: " + message, case.bytes, cert, seed, name, *more)
        if self.options.checker:
            code2, message2 = self.native.check(case.bytes, cert, *more)
            found2 = condition_of(code2, message2) if code2 in (0, 1) else "exit %d" % code2
            if (code, found) != (code2, found2):
                self.fail("the checkers disagree: %r, %r" % (message, message2), case.bytes, cert, seed, name, *more)
            if code2 == 0 and code != 0:
                found = "ACCEPT"
        return found

    def attack(self, name, case, cert, seed):
        found = self.both(case, cert, seed, name)
        if found == "ACCEPT":
            self.fail("FALSE CLAIM ACCEPTED", case.bytes, cert, seed, name, *self.more(case))
        self.table[name, found] += 1
        if found in self.conditions and not self.is_shown(found):
            self.try_alone(case, cert, found)

    # Attacks that need the condition, or it and one that implies it, have been seen often enough.
    def is_shown(self, found):
        return any(self.alone[name] >= self.often_enough
                   for name in [found] + ["%s with %s" % (found, p) for p in self.implied.get(found, ())])

    def try_alone(self, case, cert, found):
        def code(*skip):
            return self.py._check(case.bytes, cert, frozenset(skip), *self.more(case))[0]

        if code(found) == 0:
            self.alone[found] += 1
        for partner in self.implied.get(found, ()):
            if code(found, partner) == 0 and code(partner) == 1:
                self.alone[found + " with " + partner] += 1

    def accept(self, name, case, cert, seed):
        found = self.both(case, cert, seed, name)
        self.honest[name, found] += 1
        if found != "ACCEPT":
            self.fail("HONEST CERTIFICATE NOT ACCEPTED (%s)" % found, case.bytes, cert, seed, name, *self.more(case))

    def fail(self, why, model, cert, seed, name, *more):
        if len(self.failures) >= 20:
            return
        folder = pathlib.Path(self.options.save)
        folder.mkdir(parents=True, exist_ok=True)
        stem = folder / ("seed%d-%s-%d" % (seed, name.replace("/", "-"), len(self.failures)))
        stem.with_suffix(".model").write_bytes(model)
        stem.with_suffix(".cert").write_bytes(cert)
        for data in more:
            stem.with_suffix(".answers").write_bytes(data)
        self.failures.append("seed %d, %s: %s; saved %s.*" % (seed, name, why, stem))


def worker(kind, options, first, count, honest, queue):
    run = kind(options)
    done, seed, end = 0, 0, time.monotonic() + (options.seconds or float("inf"))
    try:
        while done < count and time.monotonic() < end and not len(run.failures) >= 20:
            seed = first + options.jobs
            first = seed
            for name, case, cert in run.attacks(random.Random(seed)):
                run.attack(name, case, cert, seed)
                done += 1
                if done >= count:
                    break
        accepted = 0
        while accepted < honest and not len(run.failures) >= 20:
            seed = first + options.jobs
            first = seed
            for name, case, cert in run.honest_certificates(random.Random(seed)):
                run.accept(name, case, cert, seed)
                accepted += 1
    except Exception as e:                                # a bug here must not look like a success
        import traceback
        run.failures.append("seed %d: %s: %s\n%s" % (seed, type(e).__name__, e, traceback.format_exc()))
    run.native.close()
    queue.put((run.table, run.alone, run.honest, run.failures))


def run_all(options, kind=Run):
    """(table, alone, honest, failures) of all workers together."""
    queue, totals = multiprocessing.Queue(), None
    share = [options.count // options.jobs + (j < options.count % options.jobs) for j in range(options.jobs)]
    honest = [options.honest // options.jobs + (j < options.honest % options.jobs) for j in range(options.jobs)]
    first = options.seed * 10 ** 8
    processes = [multiprocessing.Process(target=worker, args=(kind, options, first + j, share[j], honest[j], queue))
                 for j in range(options.jobs)]
    for p in processes:
        p.start()
    for _ in processes:
        part = queue.get()
        totals = part if totals is None else [a + b for a, b in zip(totals, part)]
    for p in processes:
        p.join()
    return totals


def print_table(table, alone, all_conditions=CONDITIONS):
    names = sorted({n for n, _ in table})
    conditions = [c for c in ["S1", "S2", "S3", "S4", "B1"] + all_conditions if any((n, c) in table for n in names)]
    conditions += sorted({c for _, c in table} - set(conditions))
    print("%-22s" % "strategy" + "".join("%7s" % c for c in conditions))
    for n in names:
        print("%-22s" % n + "".join("%7s" % (table.get((n, c)) or "") for c in conditions))
    print("%-22s" % "alone (some tried)" + "".join("%7s" % (alone.get(c) or "") for c in conditions))
    for name in sorted(c for c in alone if " with " in c):
        print("%-22s %d" % (name, alone[name]))


def missing_conditions(alone, conditions=CONDITIONS, implied=IMPLIED):
    """Condition ids that no attack needed (V3 and V5: that none needed next to the one that implies them)."""
    return [c for c in conditions if not alone.get(c) and
            not (c in implied and any(alone.get("%s with %s" % (c, p)) for p in implied[c]))]


def figures(table, alone, honest, failures, seconds, options):
    total = sum(table.values())
    weak = sum(n for (_, c), n in table.items() if c in UNCOUNTED)
    yield "mesh_attacks", total, options.count
    yield "mesh_attacks_that_count", total - weak, None
    yield "mesh_attacks_stopped_by_S_or_B1", weak, None
    yield "mesh_attack_strategies", len({n for n, _ in table}), 14
    yield "mesh_attacks_accepted", sum(n for (_, c), n in table.items() if c == "ACCEPT"), 0
    yield "checker_disagreements", sum("disagree" in f for f in failures), 0
    yield "conditions_needed_alone", sum(1 for c in CONDITIONS if alone.get(c)), 19
    yield "conditions_not_needed", len(missing_conditions(alone)), 0
    yield "honest_certificates", sum(honest.values()), options.honest
    yield "honest_certificates_rejected", sum(n for (_, c), n in honest.items() if c != "ACCEPT"), 0
    yield "checkers_compared", 2 if options.checker else 1, 2
    yield "seconds", round(seconds, 1), None


def parse(argv):
    a = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    a.add_argument("--count", type=int, default=10000)
    a.add_argument("--seed", type=int, default=1)
    a.add_argument("--checker", default="")
    a.add_argument("--python-checker", default=str(CHECKER_PY), help=argparse.SUPPRESS)
    a.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    a.add_argument("--honest", type=int, default=1000)
    a.add_argument("--seconds", type=float, default=0, help="stop after so long, if not 0")
    a.add_argument("--only", default="", help="one kind of cases: sheet_attacks, ... of patch_attacks.py, sheets of patch_differential.py")
    a.add_argument("--python-share", type=float, default=1, help="of the attacks of patch_attacks.py: the Python checker judges this part, too")
    a.add_argument("--save", default="mutation-failures")
    return a.parse_args(argv)


def report(failures, figures, missing=()):
    """Prints what a run found; the exit code.  missing: conditions that no attack needs, though some should."""
    failures = failures + ["no attack needs condition %s" % c for c in missing]
    for f in failures:
        print("FAILURE:", f)
    for name, value, goal in figures:
        print(json.dumps({"name": name, "value": value, "goal": goal}))
    return 1 if failures else 0


def main(argv):
    options, start = parse(argv), time.monotonic()
    table, alone, honest, failures = run_all(options)
    print_table(table, alone)
    return report(failures, figures(table, alone, honest, failures, time.monotonic() - start, options),
                  missing_conditions(alone) if options.count >= 5000 else ())


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
