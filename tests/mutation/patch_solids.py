# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Small patch models of known truth with certificates: tests only. A Proof is a model and the plan of its body; exact maps, unions and
finer breaks of models carry their plans along, so that a random model costs no search."""
import copy
import pathlib
import sys
from fractions import Fraction as Q

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "checker_py")]
import solids                                             # noqa: E402
import star_box_forge as forge                            # noqa: E402
import star_box_models as models                          # noqa: E402

UNIT = 1 << 20                                            # of the forge: a unit of the models
COUNTS = ("patches", "edges", "vertices", "shells", "genus")


class Proof:
    """inner: (middle, half) of a cube inside the solid; box: the corners, if the solid is an axis-parallel box."""

    def __init__(self, plan, inner=None, box=None):
        self.plan, self.inner, self.box = plan, inner, box

    @property
    def entities(self):
        return self.plan.entities

    def copy(self):
        plan = copy.copy(self.plan)
        for name in ("flags", "breaks", "roots", "boxes", "walks"):
            setattr(plan, name, list(getattr(plan, name)))
        plan.boxes, plan.trees = [copy.copy(b) for b in plan.boxes], copy.deepcopy(plan.trees)
        plan.values = dict(plan.values)
        return Proof(plan, self.inner, self.box)

    def settle(self):
        """The statement's number of bodies follows the walks."""
        self.plan.values["bodies"] = sum(sign for _, sign, _, _ in self.plan.walks)
        return self


def proved(entities, inner=None, box=None, kind=forge.Prover, **options):
    return Proof(kind(entities, **options).prove().plan, inner, box)


# ---------------------------------------------------------------- sound solids

MADE = {}                                                 # proofs that took a search: once for each process, then only mapped


def made(name, make):
    if name not in MADE:
        MADE[name] = make()
    return MADE[name].copy()


def cube_faces(degree, weights):
    """[0, 2]^3; weights at the corners: the iso-lines of a face stay disjoint segments, so it stays injective."""
    out, grid = [], [Q(2 * i, degree) - 1 for i in range(degree + 1)]
    for at in models.cube_faces():
        rows = []
        for u in grid:
            rows.append([])
            for v in grid:
                side = at(u, v)
                w = weights[sum(1 << k for k in range(3) if side[k] > 0)]
                rows[-1].append(tuple((1 + Q(c)) * w for c in side) + ((w,) if any(x != 1 for x in weights) else ()))
        out.append(forge.surface(rows, rational=any(x != 1 for x in weights)))
    return out


WEIGHTS = ((1, 2, 1, 3, 1, 1, 2, 1), (1, 1, 1, 1, 1, Q(1, 5), 1, 1), (3, 1, 1, 2, 2, 1, 1, 3))


def box_solid(rng, lo, hi):
    """Six bilinear, biquadratic or bicubic faces, or rational ones."""
    kind = rng.choice((1, 1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 3, -1, -2, -3))
    degree, weights = (kind, (1,) * 8) if kind > 0 else (1, WEIGHTS[kind])
    cube = made(("cube", kind), lambda: proved(cube_faces(degree, weights), ((1, 1, 1), 1), ((0, 0, 0), (2, 2, 2))))
    return moved(cube, (0, 1, 2), (1, 1, 1), [Q(b - a) / 2 for a, b in zip(lo, hi)], lo)


def random_box(rng):
    lo = [rng.randint(-6, 6) for _ in range(3)]
    return box_solid(rng, lo, [a + 2 * rng.randint(1, 4) for a in lo])


def frame():
    """A torus of sixteen flat quadrilaterals: the square ring 1 <= max(|x|, |y|) <= 3, |z| <= 1."""
    corners = [(1, 1), (-1, 1), (-1, -1), (1, -1)]
    section = [(3, -1), (3, 1), (1, 1), (1, -1)]
    out = []
    for (x, y), (s, t) in zip(corners, corners[1:] + corners[:1]):
        for (r, z), (q, w) in zip(section, section[1:] + section[:1]):
            out.append(forge.surface([[(r * x, r * y, z), (q * x, q * y, w)], [(r * s, r * t, z), (q * s, q * t, w)]]))
    return out


def prism(n):
    """Flat triangles over a convex polygon about the origin."""
    ring = solids.ring(n, 1000, None)
    low, high = [(Q(x, 250), Q(y, 250), -3) for x, y in ring], [(Q(x, 250), Q(y, 250), 3) for x, y in ring]
    out = []
    for i in range(n):
        j = (i + 1) % n
        out += models.triangles([(0, 0, 3), high[i], high[j], (0, 0, -3), low[j], low[i]], [(0, 1, 2), (3, 4, 5), (5, 4, 2), (5, 2, 1)])
    return out


def solid(rng, heavy=.005):
    """A sound solid somewhere."""
    r = rng.random()
    if r < .6:
        found = random_box(rng)
    elif r < .7:
        found = made("frame", lambda: proved(frame(), ((2, 0, 0), Q(1, 2))))
    elif r < .85:
        found = made("tetrahedron", lambda: flat_solid(models.tetrahedron(8), ((1, 1, 1), Q(1, 2))))
    elif r < 1 - heavy:
        n = rng.choice((3, 4))
        found = made(("prism", n), lambda: flat_solid(prism(n), ((0, 0, 0), 1)))
    else:
        name, make = rng.choice((("octants", models.octant_sphere), ("cubic", models.cubic_octahedron), ("ball", models.bicubic_ball)))
        found = made(name, lambda: proved(make(), ((0, 0, 0), Q(1, 3))))
    return moved(found, *random_map(rng))


def flat_solid(entities, inner):
    proof, prover = flat_proof(entities, inner)
    prover.walk()
    return proof.settle()


def reader(plan):
    """A prover over the whole model, which need be neither closed nor sound, with the boxes of a plan."""
    prover = forge.Prover.__new__(forge.Prover)
    prover.plan, prover.model, prover.patches = plan, forge.encode_model(plan.entities), []
    for entity, flag, breaks in zip(forge.read.read_model(prover.model), plan.flags, plan.breaks):
        prover.patches += forge.patches.patches_of(entity, breaks, flag, plan.unit)
    plan.roots = plan.roots or [[0, 0]] * len(prover.patches)
    for i, patch in enumerate(prover.patches):
        patch.index, patch.roots = i, plan.roots[i]
    edges, vertices, chi, prover.vertex_of = forge.patches.glue(prover.patches, lambda condition, why: None)
    prover.counts = {"patches": len(prover.patches), "edges": edges, "vertices": vertices, "shells": len(chi),
                     "genus": sum(1 - c // 2 for c in chi)}
    prover.components = [[] for _ in chi]
    prover.forest = forge.star_nodes.Forest(prover.patches, 10 ** 9)
    return prover


def flat_proof(entities, inner=None):
    """A proof for flat triangles: a mesh box around each, and a star box at the middle of one of each component, where there is room."""
    plan = forge.Plan(entities)
    prover = reader(plan)
    plan.values = dict(prover.counts)
    for patch in prover.patches:
        tree = middle = len(plan.boxes)
        plan.boxes.append(forge.Box(1, *hull_of(next(forge.star_nodes.root_nodes(patch)), 2)))
        star = None if prover.components[patch.component] else star_at_middle(prover, patch)
        if star:
            level, box = star
            prover.components[patch.component].append(len(plan.boxes))
            tree = len(plan.boxes)
            plan.boxes.append(box)
            for _ in range(level):
                tree = [middle, middle, middle, tree]
        plan.trees.append([tree])
    return Proof(plan, inner), prover


def hull_of(node, margin):
    lo, hi = node.hull()
    lo = [n // d - margin for n, d in lo]
    return lo, [-(-n // d) + margin - l for (n, d), l in zip(hi, lo)]


def star_at_middle(prover, patch):
    """(level of the leaf, box)."""
    node = next(forge.star_nodes.root_nodes(patch))
    a, b, c = forge.star_triangles.corners_of(patch)
    normal = [float(x) for x in forge.star_triangles.cross(forge.star_triangles.sub(b, a), forge.star_triangles.sub(c, a))]
    most = max(map(abs, normal))
    for level in range(1, 8):
        node = node.children()[3]
        lo, size = hull_of(node, 0)
        room = max(size) // 3 + 16
        lo, size = [x - room for x in lo], [s + 2 * room for s in size]
        if most == 0 or level < 3:
            continue
        way = [x / most * (-1 if patch.flag else 1) for x in normal]
        offsets = [[int(s // 2 + sign * room * .9 * w) for s, w in zip(size, way)] for sign in (-1, 1)]
        box = forge.Box(0, lo, size, *offsets)
        if all(0 < o < s for c in offsets for o, s in zip(c, size)) and prover.holds(box):
            return level, box
    return None


# ---------------------------------------------------------------- exact maps, unions, finer breaks

ROTATIONS = [(p, s) for p in ((0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1), (1, 0, 2), (2, 1, 0))
             for s in ((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1), (-1, -1, -1), (-1, 1, 1), (1, -1, 1), (1, 1, -1))]


def random_map(rng, far=5):
    """(axes, signs, scales, shift): coordinate k becomes scales[k] * signs[k] * p[axes[k]] + shift[k]. Axis-parallel boxes stay such,
    and what S1 and the crossing number say stays true under every affine map."""
    axes, signs = rng.choice(ROTATIONS)
    scale = rng.choice((1, 1, 2, 3))
    scales = [scale] * 3 if rng.random() < .5 else [rng.choice((1, 2, 3)) for _ in range(3)]
    return axes, signs, scales, tuple(Q(rng.randint(-8 * far, 8 * far), 8) for _ in range(3))


def is_odd(axes, signs):
    swaps = sum(axes[i] > axes[j] for i in range(3) for j in range(i + 1, 3))
    return (swaps + sum(s < 0 for s in signs)) % 2 == 1


def mapped_entity(entity, axes, signs, scales, shift):
    shape = entity["shape"]
    points = []
    for text in shape["points"]:
        p = [Q(c) for c in text]
        w = p[3] if shape["rational"] else 1
        points.append([str(scales[k] * signs[k] * p[axes[k]] + shift[k] * w) for k in range(3)] + text[3:])
    return dict(entity, shape=dict(shape, points=points))


def moved(proof, axes, signs, scales, shift):
    """A reflection turns all flags over, so that the outer sides stay outside."""
    new, at = proof.copy(), [int(s * UNIT) for s in shift]
    plan = new.plan
    plan.entities = [mapped_entity(e, axes, signs, scales, shift) for e in plan.entities]
    if is_odd(axes, signs):
        plan.flags = [1 - f for f in plan.flags]

    def image(p):
        return [int(scales[k] * signs[k] * p[axes[k]]) + at[k] for k in range(3)]
    for box in plan.boxes:
        box.lo, box.size, box.minus, box.plus = box_of(box, image)
    plan.walks = [(box, sign, [image(p) for p in points], end_of(end, axes, signs)) for box, sign, points, end in plan.walks]
    if new.inner:
        middle, half = new.inner
        new.inner = tuple(scales[k] * signs[k] * middle[axes[k]] + shift[k] for k in range(3)), min(scales) * half
    if new.box:
        corners = [[scales[k] * signs[k] * c[axes[k]] + shift[k] for k in range(3)] for c in new.box]
        new.box = [min(c) for c in zip(*corners)], [max(c) for c in zip(*corners)]
    return new


def box_of(box, image):
    """(lo, size, c- and c+ from lo) of the image."""
    a, b = image(box.lo), image([x + s for x, s in zip(box.lo, box.size)])
    lo = [min(c) for c in zip(a, b)]
    centres = [None if c is None else [x - l for x, l in zip(image([x + o for x, o in zip(box.lo, c)]), lo)] for c in (box.minus, box.plus)]
    return [lo, [abs(x - y) for x, y in zip(a, b)], *centres]


def end_of(end, axes, signs):
    if not isinstance(end, int):
        return end
    k = axes.index(end // 2)
    return 2 * k + (end % 2 if signs[k] > 0 else 1 - end % 2)


def shifted_tree(tree, by):
    return tree + by if isinstance(tree, int) else [shifted_tree(t, by) for t in tree]


def joined(*proofs):
    """Their patches together, each with the boxes and walks that it has alone."""
    new = proofs[0].copy()
    plan, new.inner, new.box = new.plan, None, None
    for other in [p.copy().plan for p in proofs[1:]]:
        n = len(plan.boxes)
        for name in ("entities", "flags", "breaks", "roots", "boxes"):
            setattr(plan, name, list(getattr(plan, name)) + list(getattr(other, name)))
        plan.trees = list(plan.trees) + [[shifted_tree(t, n) for t in trees] for trees in other.trees]
        plan.walks += [(box + n, sign, points, end if isinstance(end, int) else (end[0] + n, end[1])) for box, sign, points, end in other.walks]
        for key in COUNTS:
            plan.values[key] += other.values[key]
    return new.settle()


def turned(proof):
    """Every patch reversed, and with it c- and c+ of every box; walks still start at the same places."""
    new = proof.copy()
    plan = new.plan
    plan.flags = [1 - f for f in plan.flags]
    for box in plan.boxes:
        box.minus, box.plus = box.plus, box.minus
    plan.walks = [(box, 1 - sign, points, end if isinstance(end, int) else (end[0], 1 - end[1])) for box, sign, points, end in plan.walks]
    return new.settle()


def refined(proof):
    """Every surface cut at the middle of both parameters: the quarters of each tree become trees of their own."""
    new = proof.copy()
    plan = new.plan
    if any(e["kind"] != "surface" or r != [0, 0] or [len(b) for b in bs] != [2, 2] for e, r, bs in zip(plan.entities, plan.roots, plan.breaks)):
        return None
    plan.breaks = [[[b[0], (b[0] + b[1]) / 2, b[1]] for b in axes] for axes in plan.breaks]
    trees = []
    for (tree,) in plan.trees:
        trees += [[t] for t in (tree if isinstance(tree, list) else [tree] * 4)]
    faces, edges, vertices = [plan.values[key] for key in ("patches", "edges", "vertices")]
    plan.trees, plan.roots = trees, [[0, 0]] * (4 * faces)
    plan.values.update(patches=4 * faces, edges=2 * edges + 4 * faces, vertices=vertices + edges + faces)
    return new
