# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Liars for the claim star-box-1. A false model, by construction, with boxes and walks that are right for its parts; then every single
thing that a prover could bend so that the checkers might not see it."""
import random
from fractions import Fraction as Q

import attacks
import solids
import patch_solids as ps
from patch_solids import UNIT, forge, models
import star_box_test as known                             # provers that look away



class Case:
    """why: why every claim about this model with these flags is false; None: the model is a solid."""

    def __init__(self, proof, why):
        self.proof, self.plan, self.why = proof, proof.plan, why
        self.bytes = forge.encode_model(proof.entities)

    def certificate(self, plan=None):
        return (plan or self.plan).certificate(self.bytes)


# ---------------------------------------------------------------- false models

def step_inside(rng, inner):
    """A vector that is not 0 and shorter than the cube's half."""
    while True:
        t = [Q(rng.randint(-7, 7), 8) * inner[1] for _ in range(3)]
        if rng.random() < .5:
            t[rng.randrange(3)] = Q(0)
        if any(t):
            return t


def crossing_copies(rng):
    """A solid and its own image of equal volume, with a common inner point: neither lies in the other, so the boundaries cross."""
    p = ps.solid(rng, .003)
    t, (axes, signs) = step_inside(rng, p.inner), rng.choice(ps.ROTATIONS[:1] + ps.ROTATIONS)
    image = [signs[k] * p.inner[0][axes[k]] for k in range(3)]
    q = ps.moved(p, axes, signs, (1, 1, 1), [m + d - i for m, d, i in zip(p.inner[0], t, image)])
    if (axes, signs) != ps.ROTATIONS[0] and set(map(str, q.entities)) == set(map(str, p.entities)):
        return None
    return ps.joined(p, ps.turned(q) if rng.random() < .3 else q), "two boundaries cross"


def crossing_boxes(rng):
    """Axis-parallel boxes that overlap, neither inside the other."""
    a, b = ps.random_box(rng), ps.random_box(rng)
    overlap = all(max(x) < min(y) for x, y in zip(zip(a.box[0], b.box[0]), zip(a.box[1], b.box[1])))
    nested = any(all(s <= u and v <= t for s, t, u, v in zip(*p.box, *q.box)) for p, q in ((a, b), (b, a)))
    if not overlap or nested and all(s < u and v < t or u < s and t < v for s, t, u, v in zip(*a.box, *b.box)):
        return None
    return ps.joined(a, ps.turned(b) if rng.random() < .3 else b), "boxes cross or touch"


def touching_boxes(rng):
    """A common face, part of a face, edge or corner."""
    a = ps.random_box(rng)
    k, lo, hi = rng.choice((1, 1, 2, 3)), [], []
    for axis, (l, h) in enumerate(zip(*a.box)):
        size = rng.choice((h - l, 2 * rng.randint(1, 3)))
        start = h if axis < k else rng.choice((l, rng.randint(int(l) - int(size) + 1, int(h) - 1)))
        lo.append(start)
        hi.append(start + size)
    b = ps.box_solid(rng, lo, hi)
    joined = ps.joined(a, ps.turned(b) if rng.random() < .2 else b)
    return ps.moved(joined, *ps.random_map(rng)), "two boundaries touch"


def touching_poles(rng):
    """Two octant spheres that share a pole, or touch at an equator's point."""
    p = ps.made("octants", lambda: ps.proved(models.octant_sphere(), ((0, 0, 0), Q(1, 3))))
    t = [Q(0)] * 3
    t[rng.choice((0, 2, 2))] = Q(2)
    return ps.moved(ps.joined(p, ps.moved(p, *ps.ROTATIONS[0], (1, 1, 1), t)), *ps.random_map(rng)), "two spheres touch"


def double_cover(rng):
    """One surface twice, the second time cut finer, so that no two sides are the same curve."""
    p = ps.solid(rng, .003)
    q = ps.refined(p)
    if not q:
        return None
    if rng.random() < .3:
        q = ps.turned(q)
    return ps.joined(*rng.sample((p, q), 2)), "a surface twice"


def looped(rng):
    """A bipyramid of triangles over a polygon that runs round its axis twice: such a curve crosses itself."""
    def make():
        n, corners = rng.choice((5, 7)), []
        for i in range(n):
            (x, y), = solids.ring(n, 1000, None)[2 * i % n:][:1]
            grow = Q(rng.randint(8, 12), 10)
            corners.append((round(x * grow), round(y * grow), rng.randint(-60, 60)))
        corners += [(0, 0, 900), (0, 0, -900)]
        faces = [f for i in range(n) for f in ((i, (i + 1) % n, n), ((i + 1) % n, i, n + 1))]
        points = [tuple(Q(c, 100) for c in p) for p in corners]
        return with_mesh_boxes(models.triangles(points, faces))
    p = ps.made("loop%d" % rng.randrange(4), make)
    return ps.moved(p, *ps.random_map(rng)), "a curve that winds twice round a point crosses itself"


def flat_defect(rng):
    """Triangles with a planted defect (solids.py), judged by the oracle of the mesh rules; mesh boxes everywhere but at one star box."""
    points, tris = rng.choice((solids.tetrahedron, solids.box, solids.bipyramid, solids.needle))(rng)
    points, tris = rng.choice(solids.DEFECTS)(points, tris, rng)
    if not 4 <= len(tris) <= 26 or any(len(set(t)) < 3 for t in tris):
        return None
    case = attacks.Case(points, tris, random.Random(rng.random()), "off", False, 0)
    if not case.broken:
        return None
    size = max(abs(c) for p in points for c in p) or 1
    entities = models.triangles([tuple(Q(c) * 8 / size for c in p) for p in points], tris)
    return with_mesh_boxes(entities), "a mesh that breaks %s" % sorted(case.broken)


def wrinkled(rng):
    """The flat Z-fold, three sheets deep, of referee-2, 4.6."""
    return ps.moved(ps.made("z-fold", lambda: with_mesh_boxes(known.Traps.z_fold(None))), *ps.random_map(rng)), "three sheets in one plane"


def with_mesh_boxes(entities):
    proof, prover = ps.flat_proof(entities)
    return walk(proof, prover).settle()


def walk(proof, prover=None, boxes=None):
    """Walks that are free, from either centre; of a component without one, a walk to infinity all the same."""
    plan = proof.plan
    prover = prover or ps.reader(plan)
    prover.components = [[] for _ in prover.components]
    for n, owner in named_by(proof, prover).items():
        if plan.boxes[n].kind == 0 and (boxes is None or n in boxes):
            prover.components[owner].append(n)
    prover.components = [mine[::1 + len(mine) // 8] for mine in prover.components]
    plan.walks, done = [], []
    for _ in prover.components:
        for n, mine in enumerate(prover.components):
            found = n not in done and known.AnySign.first_walk(prover, n, done)
            if found:
                plan.walks.append(found)
                done.append(n)
    plan.walks += [(mine[0], 1, [], 0) for n, mine in enumerate(prover.components) if n not in done and mine]
    return proof


def leaves(tree):
    return [tree] if isinstance(tree, int) else [n for t in tree for n in leaves(t)]


def named_by(proof, prover):
    """{box: component of a leaf that names it}."""
    return {n: patch.component for patch, trees in zip(prover.patches, proof.plan.trees) for t in trees for n in leaves(t)}


# ---------------------------------------------------------------- models that are open, or glued where nothing agrees

def recounted(proof):
    """The statement's numbers as a checker without P1 would count them."""
    prover = ps.reader(proof.plan)
    proof.plan.values.update(prover.counts)
    return walk(proof, prover).settle()


def without(proof, i):
    plan = proof.plan
    for name in ("entities", "flags", "breaks", "roots", "trees"):
        setattr(plan, name, [x for n, x in enumerate(getattr(plan, name)) if n != i])
    used = sorted({n for trees in plan.trees for t in trees for n in leaves(t)})
    return keep_boxes(proof, used)


def keep_boxes(proof, used):
    number = {n: i for i, n in enumerate(used)}
    plan = proof.plan
    plan.boxes = [plan.boxes[n] for n in used]

    def renamed(tree):
        return number[tree] if isinstance(tree, int) else [renamed(t) for t in tree]
    plan.trees = [[renamed(t) for t in trees] for trees in plan.trees]
    plan.walks = [(number[b], s, p, e if isinstance(e, int) else (number.get(e[0], 0), e[1])) for b, s, p, e in plan.walks if b in number]
    return proof


def whole_patches(proof):
    return len(proof.entities) == len(proof.plan.trees)


def opened(rng):
    p = ps.solid(rng, 0)
    return recounted(without(p, rng.randrange(len(p.entities)))), "a patch is missing"


def doubled_patch(rng):
    """A patch twice, the same or turned over; of higher degree, too."""
    p = ps.solid(rng, 0)
    i = rng.randrange(len(p.entities))
    plan = p.plan
    extra = plan.entities[i]
    if extra["kind"] == "triangle" and rng.random() < .5:
        a, b, c = [tuple(map(Q, t)) for t in extra["shape"]["points"]]
        mid = [tuple((s + t) / 2 for s, t in zip(*e)) for e in ((a, b), (a, c), (b, c))]
        extra = forge.triangle([a, mid[0], mid[1], b, mid[2], c], 2)
    plan.entities, plan.flags, plan.breaks = plan.entities + [extra], plan.flags + [rng.randint(0, 1)], plan.breaks + [plan.breaks[i]]
    plan.roots, plan.trees = plan.roots + [plan.roots[i]], plan.trees + [plan.trees[i]]
    return recounted(p), "a patch twice"


def gap(rng):
    """One control point of one patch moved by a hair, at a corner or on a side."""
    p = ps.solid(rng, 0)
    i = rng.randrange(len(p.entities))
    e = p.entities[i]
    shape = e["shape"]
    points = [list(t) for t in shape["points"]]
    if e["kind"] == "surface":
        m, n = [len(k) - d - 1 for k, d in zip(shape["knots"], shape["degrees"])]
        at = rng.choice([a * n + b for a in range(m) for b in range(n) if a in (0, m - 1) or b in (0, n - 1)])
    else:
        at = rng.randrange(3)
    k = rng.randrange(len(points[at]))
    points[at][k] = str(Q(points[at][k]) + rng.choice((-1, 1)) * Q(1, 1 << rng.choice((30, 40, 52, 80, 400))))
    p.plan.entities = list(p.entities)
    p.plan.entities[i] = dict(e, shape=dict(shape, points=points))
    return recounted(p), "a gap along a side"


def wrong_flag(rng):
    p = ps.solid(rng, 0)
    for i in rng.sample(range(len(p.entities)), rng.choice((1, 1, 2))):
        p.plan.flags[i] ^= 1
    return (recounted(p), "a patch turned over") if len(set(p.plan.flags)) == 2 else None


# ---------------------------------------------------------------- models with a wrong side outside, or with points and needles

def inside_out(rng):
    p = ps.turned(ps.solid(rng, .002))
    return (p if rng.random() < .5 else walk(p).settle()), "inside out"


def nested_wrongly(rng):
    """Two to four boxes in each other, not all of them alternately outward and inward."""
    n = rng.choice((2, 2, 3, 4))
    parts, ways = [], [rng.randint(0, 1) for _ in range(n)]
    if all(way == depth % 2 for depth, way in enumerate(ways)):
        ways[rng.randrange(n)] ^= 1
    for depth, way in enumerate(ways):
        half = 54 // 3 ** depth
        p = ps.box_solid(rng, [-half + rng.randint(0, half // 8) for _ in range(3)], [half - rng.randint(0, half // 8) for _ in range(3)])
        parts.append(ps.turned(p) if way else p)
    rng.shuffle(parts)
    p = ps.moved(ps.joined(*parts), *ps.random_map(rng))
    return (walk(p).settle() if rng.random() < .9 else p), "nested shells of the same side"


def flat_shell(rng):
    """A shell that encloses nothing: a pillow, a point, a needle, a lune of two collapsed sides and its back; closed by P1's rule."""
    a, b, c, d = [tuple(Q(rng.randint(60, 80), 4) for _ in range(3)) for _ in range(4)]
    kind = rng.randrange(6)
    if kind == 0:
        return models.triangles([a, b, c], [(0, 1, 2), (0, 2, 1)])
    if kind == 1:
        return [forge.triangle([a] * rng.choice((3,)))]
    if kind == 2:
        return models.triangles([a, b], [(0, 1, 1), (1, 0, 0)])
    if kind == 3:                                         # two adjacent collapsed sides: a lune, and its back
        rows = [[a, a, a], [a, b, c], [a, d, b]]
        return [forge.surface(rows), forge.surface([list(r) for r in zip(*rows)])]
    if kind == 4:
        return [forge.surface([[a, a], [a, a]])]
    return [forge.surface([[a, a], [b, b]]), forge.surface([[b, b], [a, a]])]


def points_and_needles(rng):
    p = ps.solid(rng, 0)
    far = ps.moved(p, *ps.ROTATIONS[0], (1, 1, 1), [-200, -200, -200])
    plan = forge.Plan(flat_shell(rng))
    n = len(plan.entities)
    plan.roots, plan.trees = [[0, 0]] * n, [[0]] * n
    points = [[int(Q(c) * UNIT) for c in t] for e in plan.entities for t in e["shape"]["points"]]
    lo = [min(c) - UNIT // rng.choice((2, 64, 1 << 20)) for c in zip(*points)]
    size = [max(c) + UNIT // rng.choice((2, 64)) - l for c, l in zip(zip(*points), lo)]
    kind = rng.randint(0, 1)
    centres = [None if kind else [rng.randint(1, s - 1) for s in size] for _ in range(2)]
    plan.boxes = [forge.Box(kind, lo, size, *centres)]
    plan.walks = [(0, rng.randint(0, 1), [], rng.randrange(6))]
    plan.values = dict.fromkeys(ps.COUNTS, 0)
    return recount_only(ps.joined(far, ps.Proof(plan))), "a shell that encloses nothing"


def recount_only(proof):
    proof.plan.values.update(ps.reader(proof.plan).counts)
    return proof.settle()


FALSE_MODELS = ((crossing_copies, 4), (crossing_boxes, 3), (touching_boxes, 3), (touching_poles, .02), (double_cover, 3), (looped, 2), (wrinkled, .5),
                (flat_defect, 4), (opened, 1), (doubled_patch, 1), (gap, 2), (wrong_flag, 1), (inside_out, 2), (nested_wrongly, 2),
                (points_and_needles, 2))


def false_case(rng):
    while True:
        make, = rng.choices([m for m, _ in FALSE_MODELS], [w for _, w in FALSE_MODELS])
        found = make(rng)
        if found and found[0] and found[0].plan.boxes:
            return make.__name__, Case(*found)


# ---------------------------------------------------------------- lies about false models

def plain(case, rng):
    """Boxes and walks as they are right for the parts."""
    yield case.plan


def changed(case):
    return case.proof.copy().plan


def boxes_of(plan, kind=0):
    return [i for i, box in enumerate(plan.boxes) if box.kind == kind]


def hot_and_cool(case):
    """Star boxes that fail among all patches, and those that hold."""
    prover = ps.reader(case.plan)
    holds = {i for i in boxes_of(case.plan) if prover.holds(case.plan.boxes[i])}
    return [i for i in boxes_of(case.plan) if i not in holds], sorted(holds), prover


def swapped_centres(case, rng):
    """c- and c+ exchanged: everywhere, at random, at one box."""
    stars = boxes_of(case.plan)
    for chosen in (stars, rng.sample(stars, len(stars) // 2), rng.sample(stars, min(1, len(stars)))):
        plan = changed(case)
        for i in chosen:
            box = plan.boxes[i]
            box.minus, box.plus = box.plus, box.minus
        yield plan


def forged_centres(case, rng):
    """Centres of the prover's choice, so that the line between them misses or meets the sheets that it should not."""
    stars = boxes_of(case.plan)
    for _ in range(6 if stars else 0):
        plan, way = changed(case), rng.randrange(4)
        for i in rng.sample(stars, rng.choice((1, len(stars)))):
            box = plan.boxes[i]
            if any(s < 3 for s in box.size):
                continue
            if way == 0:
                box.plus = list(box.minus)
            elif way == 1:
                box.minus, box.plus = [[rng.randint(1, s - 1) for s in box.size] for _ in range(2)]
            elif way == 2:                                # both on one side of everything
                box.minus, box.plus = [1, 1, 1], [min(2, s - 1) for s in box.size]
            else:
                box.minus, box.plus = [1, 1, 1], [s - 1 for s in box.size]
        yield plan


def grown_boxes(case, rng):
    """Boxes that reach over more of the surface; one for everything, of either kind."""
    for factor in (2, 4):
        plan = changed(case)
        for box in plan.boxes:
            box.lo = [l - s * (factor - 1) // 2 for l, s in zip(box.lo, box.size)]
            shift = [s * (factor - 1) // 2 for s in box.size]
            box.size = [s * factor for s in box.size]
            if box.kind == 0:
                box.minus, box.plus = [[o + d for o, d in zip(c, shift)] for c in (box.minus, box.plus)]
        yield plan
    for kind in (0, 1):
        plan = changed(case)
        lo = [min(b.lo[k] for b in plan.boxes) for k in range(3)]
        size = [max(b.lo[k] + b.size[k] for b in plan.boxes) - lo[k] for k in range(3)]
        star = boxes_of(plan)[:1]
        keep = [plan.boxes[i] for i in star]
        plan.boxes = keep + [forge.Box(kind, lo, size, *([None] * 2 if kind else [[rng.randint(1, s - 1) for s in size] for _ in range(2)]))]
        plan.trees = [[renamed(t, lambda n: 0 if [n] == star else len(keep)) for t in trees] for trees in plan.trees]
        plan.walks = [(0, 1, [], rng.randrange(6))] * (1 if keep else 0)
        yield plan


def renamed(tree, name):
    return name(tree) if isinstance(tree, int) else [renamed(t, name) for t in tree]


def truncated_cover(case, rng):
    """Leaves of boxes that fail name boxes that hold: the fullest cover of the rest. Then the walks are looked for anew."""
    hot, cool, prover = hot_and_cool(case)
    mine = named_by(case.proof, prover)
    if not hot or not cool:
        return
    for nearest in (True, False):
        proof = case.proof.copy()

        def name(n):
            if n not in hot:
                return n
            same = [m for m in cool if mine[m] == mine[n]] or cool
            return min(same, key=lambda m: sum(abs(a - b) for a, b in zip(case.plan.boxes[m].lo, case.plan.boxes[n].lo))) if nearest else rng.choice(same)
        proof.plan.trees = [[renamed(t, name) for t in trees] for trees in proof.plan.trees]
        used = sorted({n for trees in proof.plan.trees for t in trees for n in leaves(t)})
        keep_boxes(proof, used)
        yield walk(proof).settle().plan


def shrunk_boxes(case, rng):
    """Boxes that fail, cut down around their centres until nothing else is near."""
    hot, _, prover = hot_and_cool(case)
    proof = case.proof.copy()
    if len(hot) > 12 and rng.random() < .8:               # many take long
        return
    for i in hot:
        for _ in range(12):
            box = proof.plan.boxes[i]
            if prover.holds(box):
                break
            lo = [max(min(a, b) - max(1, min(a, b) // 2), 0) for a, b in zip(box.minus, box.plus)]
            hi = [max(a, b) + max(1, (s - max(a, b)) // 2) for a, b, s in zip(box.minus, box.plus, box.size)]
            box.lo, box.size = [l + d for l, d in zip(box.lo, lo)], [h - d for h, d in zip(hi, lo)]
            box.minus, box.plus = [[o - d for o, d in zip(c, lo)] for c in (box.minus, box.plus)]
    if hot:
        yield walk(proof).settle().plan


def cut_trees(case, rng):
    """Trees that end too early, or go on too long, and leaves in another order."""
    for way in range(5):
        plan = changed(case)
        if way == 0:
            plan.trees = [[leaves(t)[0] for t in trees] for trees in plan.trees]
        elif way == 1:
            plan.trees = plan.trees[1:] + plan.trees[:1]
        elif way == 2:
            plan.trees = [[renamed(t, lambda n: [n] * 4) for t in trees] for trees in plan.trees]
        else:
            target = rng.randrange(len(plan.boxes))
            plan.trees = [[renamed(t, lambda n: target if rng.random() < .3 else n) for t in trees] for trees in plan.trees]
        used = sorted({n for trees in plan.trees for t in trees for n in leaves(t)})
        if rng.random() < .7:
            keep_boxes(ps.Proof(plan), used)
        yield plan


def mesh_boxes_everywhere(case, rng):
    """The boxes that fail, or all but the walks' first ones, are called mesh boxes; flat ones get one around each triangle."""
    starts = {w[0] for w in case.plan.walks}
    hot, _, _ = hot_and_cool(case)
    for chosen in (hot, [i for i in boxes_of(case.plan) if i not in starts]):
        plan = changed(case)
        for i in chosen:
            plan.boxes[i].kind, plan.boxes[i].minus, plan.boxes[i].plus = 1, None, None
        yield plan
    if all(e["kind"] == "triangle" and e["shape"]["degree"] == 1 for e in case.proof.entities):
        proof = with_mesh_boxes(case.proof.entities)
        if proof.plan.walks:
            proof.plan.flags = list(case.plan.flags)
            yield proof.plan


def wrong_components(case, rng):
    """Boxes of one component named by leaves of another."""
    plan = changed(case)
    n = len(plan.trees)
    for _ in range(3):
        plan = changed(case)
        i, j = rng.randrange(n), rng.randrange(n)
        other = leaves(plan.trees[j][0])
        plan.trees[i] = [renamed(t, lambda n: rng.choice(other)) for t in plan.trees[i]]
        yield plan


def forged_walks(case, rng):
    """Walks that jump through the surface, start or end on the wrong side, come twice, not at all, or in a circle."""
    plan, stars = case.plan, boxes_of(case.plan)
    for way in rng.sample(range(10), 5 if stars and plan.walks else 0):
        new = changed(case)
        box, sign, points, end = new.walks[-1]
        if way == 0:
            new.walks = [(b, 1, [], rng.randrange(6)) for b, _, _, _ in new.walks]
        elif way == 1:
            new.walks = [(b, rng.randint(0, 1), [[rng.randint(-50, 50) * UNIT for _ in range(3)] for _ in range(rng.randint(0, 3))],
                          rng.randrange(6)) for b, _, _, _ in new.walks]
        elif way == 2:
            new.walks[-1] = (box, 1 - sign, points, end)
        elif way == 3:
            new.walks[-1] = (box, sign, points, (rng.choice(stars), rng.randint(0, 1)))
        elif way == 4:
            new.walks = new.walks[:-1]
        elif way == 5:
            new.walks = new.walks + [new.walks[0]]
        elif way == 6:
            new.walks = new.walks[::-1]
        elif way == 7:                                    # each ends at the next one
            first = [w[0] for w in new.walks]
            new.walks = [(b, s, [], (first[(i + 1) % len(first)], s)) for i, (b, s, _, _) in enumerate(new.walks)]
        elif way == 8:
            new.walks[0] = (new.walks[0][0], 1, [], (new.walks[0][0], 1))
        else:
            meshes = boxes_of(plan, 1)
            new.walks[0] = (rng.choice(meshes or stars), 1, points, end)
        if rng.random() < .7:
            new.values["bodies"] = sum(s for _, s, _, _ in new.walks)
        yield new


def forged_numbers(case, rng):
    """One number of the statement is another."""
    for key in ("patches", "edges", "vertices", "shells", "bodies", "genus", "boxes", "flipped"):
        plan = changed(case)
        plan.values.update({"boxes": len(plan.boxes), "flipped": sum(plan.flags)}, **plan.values)
        value = plan.values[key] + rng.choice((1, -1, 2, 1 << 62))
        plan.values[key] = abs(value)
        if abs(value) != case.plan.values.get(key, -1):
            yield plan


def forged_flags(case, rng):
    for share in (1, .5, .1):
        plan = changed(case)
        plan.flags = [1 - f if rng.random() < share else f for f in plan.flags]
        if share < 1 and len(set(plan.flags)) == 2 or case.why and len(set(plan.flags)) == 2:
            yield plan


def hidden_pieces(case, rng):
    """Breaks that leave out a part of the domain, roots of another number or shape."""
    for i in range(min(3, len(case.proof.entities))):
        plan = changed(case)
        if case.proof.entities[i]["kind"] == "surface":
            plan.breaks[i] = rng.choice(([[Q(0), Q(1, 2)], [Q(0), Q(1)]], [[Q(0), Q(1)], [Q(1, 2), Q(1)]], [[Q(0), Q(2)], [Q(0), Q(1)]]))
            yield plan
            plan = changed(case)
            plan.roots[i], tree = rng.choice(([0, 1], [1, 0], [1, 1], [2, 0])), plan.trees[i][0]
            count = 1 << sum(plan.roots[i])
            plan.trees[i] = ([tree] * 4)[:count] if isinstance(tree, int) else tree[:count]
            yield plan


LIES = (plain, swapped_centres, forged_centres, grown_boxes, truncated_cover, shrunk_boxes, cut_trees, mesh_boxes_everywhere,
        wrong_components, forged_walks, forged_numbers, forged_flags, hidden_pieces)


# ---------------------------------------------------------------- lies about sound models

def hollow():
    """A box of thin walls, cut so fine that a box away from the edges meets no side wall."""
    cubes = [ps.proved(ps.cube_faces(1, (1,) * 8), roots=2) for _ in range(2)]
    outer, inner = [ps.moved(c, (0, 1, 2), (1, 1, 1), (h, h, h), (-h, -h, -h)) for c, h in zip(cubes, (8, 6))]
    return walk(ps.joined(outer, ps.turned(inner))).settle()


def three_sheets(rng):
    """A star box through two, three or four walls of a hollow box: of three, one crossing is left if it is counted with signs."""
    proof = ps.made("hollow", hollow)
    places = [-9, -7, 0, 7, 9]
    for _ in range(8):
        new, k, sheets = proof.copy().plan, rng.randrange(3), rng.choice((2, 3, 3, 4))
        box = rng.choice(new.boxes)
        lo, hi = list(box.lo), [l + s for l, s in zip(box.lo, box.size)]
        if any(l < -5.8 * UNIT or h > 5.8 * UNIT for j, (l, h) in enumerate(zip(lo, hi)) if j != k):
            continue
        a = rng.randrange(5 - sheets)
        ends = [places[a], places[a + sheets]]
        lo[k], hi[k] = min(lo[k], ends[0] * UNIT - UNIT // 2), max(hi[k], ends[1] * UNIT + UNIT // 2)
        middle = [(x + y) // 2 for x, y in zip(lo, hi)]
        centres = [[*middle[:k], e * UNIT, *middle[k + 1:]] for e in ends]
        rng.shuffle(centres)
        box.lo, box.size = lo, [y - x for x, y in zip(lo, hi)]
        box.minus, box.plus = [[c - l for c, l in zip(p, lo)] for p in centres]
        yield Case(proof, None), new


def overstated(rng):
    """A solid with another number of shells, bodies, handles, vertices."""
    case = Case(ps.solid(rng, .001), None)
    yield from ((case, plan) for plan in forged_numbers(case, rng))


def as_turned(plan, winding):
    plan.values = dict(plan.values, claim="star-box-turned-1", winding=forge.zigzag_code(winding), bodies=0)
    return plan


def told_as_turned(rng):
    """A solid said to be turned; flags that turn it; a surface that is turned, with another winding number."""
    p = ps.solid(rng, .001)
    if any(p.plan.flags):                                 # without them the model is turned indeed
        return
    sound = Case(p, None)
    yield sound, as_turned(changed(sound), rng.choice((0, 1, 2, -1)))
    turned = Case(ps.turned(p), None)
    yield turned, as_turned(changed(turned), 0)
    for new in forged_walks(sound, rng):
        yield sound, as_turned(new, rng.choice((0, 1, -1)))


def really_turned(rng):
    """Boxes whose faces point inwards, without a flag."""
    def make():
        return ps.Proof(known.AnySign([models.reversed_surface(e) for e in models.cube()]).prove().plan, ((0, 0, 0), 1))
    proof = ps.made("turned", make)
    axes, signs, scales, shift = ps.random_map(rng)
    if ps.is_odd(axes, signs):
        signs = tuple(-s for s in signs)
    proof = ps.moved(proof, axes, signs, scales, shift)
    as_turned(proof.plan, 0)
    return Case(proof, "turned")


def wrong_windings(rng):
    case = really_turned(rng)
    for winding in (1, 2, -1, -(1 << 62)):
        yield case, as_turned(changed(case), winding)
    for new in forged_numbers(case, rng):
        yield case, new
    for i in range(2):
        new = changed(case)
        new.flags = [1] * 6
        yield case, new


def star_attacks(rng):
    """(strategy, model, certificate)."""
    yield from ((name, case.bytes, case.certificate(plan)) for name, case, plan in star_lies(rng))


def star_lies(rng):
    """(strategy, case, plan)."""
    r = rng.random()
    if r < .06:
        yield from (("three_sheets", case, plan) for case, plan in three_sheets(rng))
    elif r < .12:
        for told in (told_as_turned, wrong_windings):
            yield from ((told.__name__, case, plan) for case, plan in told(rng))
    elif r < .16:
        yield from (("overstated", case, plan) for case, plan in overstated(rng))
    else:
        name, case = false_case(rng)
        for lie in LIES:
            if lie in (plain, truncated_cover, forged_walks) or rng.random() < .5:
                for plan in lie(case, rng):
                    yield "%s/%s" % (name, lie.__name__), case, plan


def honest(rng):
    """(name, model, certificate): a solid, several side by side or in each other, a turned one."""
    r = rng.random()
    if r < .6:
        p = ps.solid(rng, .02)
    elif r < .75:
        p = nested_rightly(rng)
    else:
        case = really_turned(rng)
        yield "turned", case.bytes, case.certificate()
        return
    yield "star", forge.encode_model(p.entities), p.plan.certificate()
    finer = ps.refined(p)
    if finer:
        yield "finer", forge.encode_model(p.entities), finer.plan.certificate()


def nested_rightly(rng):
    parts = []
    for depth in range(rng.choice((2, 3))):
        half = 54 // 3 ** depth
        p = ps.box_solid(rng, [-half + rng.randint(0, half // 8) for _ in range(3)], [half - rng.randint(0, half // 8) for _ in range(3)])
        parts.append(ps.turned(p) if depth % 2 else p)
    rng.shuffle(parts)
    return walk(ps.moved(ps.joined(*parts), *ps.random_map(rng))).settle()
