# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Models for star_box_2_*_test.py with boxes made by hand: exact, known by construction. The unit of coordinates is 2^-20."""
from fractions import Fraction as Q

import star_box_2_forge as forge2
import star_box_forge as forge
import star_box_models as models

UNIT = 1 << 20
TURN = ((2, -1, 2), (2, 2, -1), (-1, 2, 2))               # three times a rotation; its transpose is the frame


def times(matrix, p):
    return tuple(sum(a * x for a, x in zip(row, p)) for row in matrix)


def units(*numbers):
    result = [Q(x) * UNIT for x in numbers]
    assert all(x.denominator == 1 for x in result), numbers
    return [int(x) for x in result]


class Setting:
    """Coordinates p in which boxes are along the axes, and the model's, x = 3 R p or x = p."""

    def __init__(self, turned):
        self.turned, self.frames = turned, [tuple(zip(*TURN))] if turned else []

    def point(self, p):
        return times(TURN, p) if self.turned else tuple(p)

    def box(self, kind, lo, hi, *centres):
        scale = 9 if self.turned else 1
        return forge2.Box2(kind, units(*[scale * Q(c) for c in lo]), units(*[scale * Q(c) for c in hi]),
                           [[units(*self.point(c)) for c in pair] for pair in centres], frame=int(self.turned))

    def plane(self, height):
        """The polynomial p_3 - height, up to a factor."""
        row, scale = (self.frames[0][2], 9) if self.turned else ((0, 0, 1), 1)
        return {(1, 0, 0): row[0], (0, 1, 0): row[1], (0, 0, 1): row[2], (0, 0, 0): -scale * Q(height) * UNIT}


def cuboid(lo, hi, point=lambda p: p):
    """Six bilinear patches."""
    def shape(p):
        return point([l + (h - l) * Q(1 + c, 2) for l, h, c in zip(lo, hi, p)])
    return [forge.surface([[shape(at(u, v)) for v in (-1, 1)] for u in (-1, 1)]) for at in models.cube_faces()]


def plate(gap, turned=False, is_inside_out=False):
    """A plate 1 x 1 x gap: (entities, setting, boxes). One box has both walls, whose thickness does not depend on the gap."""
    to, gap = Setting(turned), Q(gap)
    entities = cuboid((0, 0, 0), (1, 1, gap), to.point)
    way = -1 if is_inside_out else 1
    above, below = (Q(1, 2), Q(1, 2), Q(1, 4)), (Q(1, 2), Q(1, 2), -Q(1, 8))
    walls = to.box(0, (Q(3, 16), Q(3, 16), -Q(1, 4)), (Q(13, 16), Q(13, 16), Q(1, 2)), (below, above)[::way], (above, below)[::way])
    walls.separate(to.plane(gap / 2), 0, 1, 2)
    one = to.box(0, (Q(3, 16), Q(3, 16), gap / 4), (Q(9, 16), Q(9, 16), Q(1, 2)), ((Q(3, 8), Q(3, 8), gap / 2), (Q(3, 8), Q(3, 8), Q(1, 4)))[::way])
    everything = to.box(1, (-Q(1, 8), -Q(1, 8), -Q(1, 4)), (Q(9, 8), Q(9, 8), Q(1, 2)))
    if is_inside_out:
        entities = [models.reversed_surface(e) for e in entities]
    return entities, to, [one, walls, everything]


def raised(entity, degree, bump=0):
    """The bilinear patch in this degree, its inner control points moved along it by a part `bump` of its side."""
    a, b, c, d = [[Q(x) for x in p] for p in entity["shape"]["points"]]

    def point(i, j):
        u, v = Q(i, degree), Q(j, degree)
        if 0 < i < degree and 0 < j < degree:
            u += bump
        return tuple((1 - u) * ((1 - v) * w + v * x) + u * ((1 - v) * y + v * z) for w, x, y, z in zip(a, b, c, d))
    return forge.surface([[point(i, j) for j in range(degree + 1)] for i in range(degree + 1)])


def proved_plate(gap, turned=False):
    entities, to, boxes = plate(gap, turned)
    return forge2.Prover2(entities, boxes, to.frames, roots=2, deepest=0).prove()


def shell(gap):
    return models.octant_sphere(1) + models.octant_sphere(1 - Q(gap))


SHELL_UNIT = -40


def proved_shell(gap, factor=1.6):
    """Concentric spheres: the boxes of one sphere with a second sheet and a quadric between them, and a box of one sheet on each. REQUIRES a
    gap of at most 2^-7: the boxes of the outer sphere have room for as much."""
    one, gap, e = forge.Prover(models.octant_sphere(1), unit=SHELL_UNIT, factor=factor).prove(), Q(gap), 1 << -SHELL_UNIT
    prover = forge2.Prover2(shell(gap), flags=[0] * 8 + [1] * 8, unit=SHELL_UNIT)
    plan = prover.plan
    for box in one.plan.boxes:
        probe, coarse = forge.check_box(box), 1 << 16
        minus, plus = [[c // coarse * coarse for c in p] for p in probe.c]
        radius = (1 - gap / 2) * e // coarse * coarse
        plan.boxes.append(forge2.Box2(0, probe.lo, probe.hi, [(minus, plus), (plus, minus)], signs=[[], []]).separate(
            {(2, 0, 0): 1, (0, 2, 0): 1, (0, 0, 2): 1, (0, 0, 0): -radius * radius}, 16, 1, 2))
    plan.trees = one.plan.trees + forge.copy.deepcopy(one.plan.trees)
    # boxes around (1, 0, 0) and (1 - gap, 0, 0)
    wide = Q(1)
    while wide * wide * 16 > gap:
        wide /= 2
    for n, (lo, minus, plus, hi) in enumerate(((Q(1, 2), Q(3, 4), Q(5, 4), Q(3, 2)), (-Q(1, 2), Q(1, 4), -Q(1, 4), Q(3, 8)))):
        at = [int((1 - gap + gap * t) * e) for t in (lo, minus, plus, hi)]
        w = int(wide * e)
        plan.boxes.append(forge2.Box2(0, [at[0], -w, -w], [at[3], w, w], [((at[1], 0, 0), (at[2], 0, 0))]))
        number, patch = len(plan.boxes) - 1, 8 * n
        node, path = next(forge.star_nodes.root_nodes(prover.patches[patch])), []
        while any(a < x * d or b > y * c for (a, d), (b, c), x, y in zip(*node.hull(), plan.boxes[-1].lo, plan.boxes[-1].hi)):
            node, path = node.children()[0], path + [0]
        plan.trees[patch][0] = with_leaf(plan.trees[patch][0], len(path), number)
        prover.components[n].append(number)
    prover.walk()
    plan.values["bodies"] = 1
    return prover


def with_leaf(tree, depth, number):
    """The tree with its first descendant at this depth replaced by a leaf."""
    if depth == 0:
        return number
    kids = [tree] * 4 if isinstance(tree, int) else tree
    return [with_leaf(kids[0], depth - 1, number), *kids[1:]]


def squircle(height):
    """A smooth closed section of four parabolas as one biquadratic patch: its normal is zero in its corners."""
    return [[(0, -1, height), (-1, -1, height), (-1, 0, height)], [(1, -1, height), (0, 0, height), (-1, 1, height)],
            [(1, 0, height), (1, 1, height), (0, 1, height)]]


def barrel(height):
    """A square of which one side is a parabola."""
    grid = [[(x, y, height) for y in (-1, 0, 1)] for x in (-1, 0, 1)]
    grid[1][0] = (0, -Q(5, 4), height)
    return grid


def prism(section):
    """A biquadratic section, at the heights 1 and -1, with walls."""
    top, bottom = section(1), section(-1)
    sides = [[r[0] for r in top], top[2], [r[2] for r in top[::-1]], top[0][::-1]]
    walls = [[[(x, y, -1) for x, y, _ in side], side] for side in sides]
    return [forge.surface(rows) for rows in [top, [list(r) for r in zip(*bottom)], *[[list(c) for c in zip(*w)] for w in walls]]]


def rounded_prism():
    """A prism over a smooth section of three parabolas, whose caps are quadratic triangles: their normals are zero in their corners."""
    around = [(2, 0), (-1, 2), (-1, -2)]
    corners = [tuple(Q(a + b, 2) for a, b in zip(around[i - 2], around[i - 1])) for i in range(3)]
    sides = [[corners[i], around[i - 1], corners[i - 2]] for i in range(3)]
    (a, ab, b), (_, bc, c), (_, ca, _) = sides
    caps = [[(*p, 1) for p in (a, ab, ca, b, bc, c)], [(*p, -1) for p in (a, ca, ab, c, bc, b)]]
    return [forge.triangle(cap, 2) for cap in caps] + [forge.surface([[(*p, -1), (*p, 1)] for p in side]) for side in sides]


def octahedron():
    """The octahedron with |x| + |y| + |z| = 1, of flat triangles."""
    return [forge.triangle([f["shape"]["points"][i] for i in (0, 3, 5)]) for f in folded_octahedron()]


def folded_octahedron(turn=0):
    """The octahedron as quadratic triangles whose normals are zero along the four sides with z = 0 only: the
    other sides double their control point there, and neighbours agree on it. turn: the number of the corner with x = y = 0."""
    ring, faces = [(1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0)], []
    for i, a in enumerate(ring):
        for b, c in ((ring[i - 3], (0, 0, 1)), (ring[i - 1], (0, 0, -1))):
            # the control point of each pair of corners
            between = {(0, 0): c, (1, 1): a, (2, 2): b, (1, 2): tuple(Q(x + y, 2) for x, y in zip(a, b)), (0, 1): a, (0, 2): b}
            corner = [(k - turn) % 3 for k in range(3)]
            faces.append(forge.triangle([between[tuple(sorted((corner[j], corner[k])))] for j, k in
                                         ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))], 2))
    return faces


BLOCKS = ((0, 0, 0), (-1, 0, 0), (-1, -1, 0), (-1, -1, -1))


def blocks(cells=BLOCKS, lift=None):
    """The boundary of unit cubes, a bilinear patch for each face. lift: makes another patch of the rows of the first face."""
    faces = []
    for cell in cells:
        for at in models.cube_faces():
            beyond = tuple(c + sum(p[k] for p in (at(-1, -1), at(1, 1))) // 2 for k, c in enumerate(cell))
            if beyond not in cells:
                faces.append([[tuple(m + Q(x + 1, 2) for m, x in zip(cell, at(u, v))) for v in (-1, 1)] for u in (-1, 1)])
    if lift:
        faces[0] = lift(faces[0])
    return [forge.surface(rows) for rows in faces]


def biquadratic(rows, middle=(0, 0, 0)):
    """The bilinear patch in degree two, its middle control point moved."""
    (a, b), (c, d) = rows

    def mid(*points):
        return tuple(sum(x) / Q(len(points)) for x in zip(*points))
    centre = tuple(x + y for x, y in zip(mid(a, b, c, d), middle))
    return [[a, mid(a, b), b], [mid(a, c), centre, mid(b, d)], [c, mid(c, d), d]]


def star_and_mesh(entities, point=(Q(1, 2), Q(1, 2), Q(1)), **options):
    """A mesh box around all, a star box around one point of a face whose normal is z."""
    x, y, z = point
    one = forge2.Box2(0, units(x - Q(3, 8), y - Q(3, 8), z - Q(1, 4)), units(x + Q(3, 8), y + Q(3, 8), z + Q(1, 4)),
                      [[units(x, y, z - Q(1, 8)), units(x, y, z + Q(1, 8))]])
    around = forge2.Box2(1, units(-4, -4, -4), units(4, 4, 4))
    return forge2.Prover2(entities, [one, around], roots=2, deepest=1, **options)


def nested_cubes():
    """A cube with a cavity and, in the cavity, a cube inside out whose walk ends in the cavity, at the box with two sheets.
    w is 0 at c- and -1 at c+ of the last one."""
    sizes, prover_boxes = (Q(1), Q(7, 8), Q(1, 8)), []
    entities = [face for half in sizes for face in cuboid((-half,) * 3, (half,) * 3)]
    two = Setting(False).box(0, (-Q(1, 4), -Q(1, 4), Q(1, 2)), (Q(1, 4), Q(1, 4), Q(3, 2)), ((0, 0, Q(3, 4)), (0, 0, Q(5, 4))),
                             ((0, 0, Q(5, 4)), (0, 0, Q(3, 4)))).separate({(0, 0, 1): 1, (0, 0, 0): -Q(15, 16) * UNIT}, 0, 1, 2)
    for n, (half, inside) in enumerate(zip(sizes, (1, -1, -1))):
        step, wide = Q(1, 32), half / 2
        star = Setting(False).box(0, (-wide, -wide, half - 2 * step), (wide, wide, half + 2 * step),
                                  ((0, 0, half - inside * step), (0, 0, half + inside * step)))
        mesh = Setting(False).box(1, (-half - step,) * 3, (half + step,) * 3)
        star.owner = mesh.owner = n
        prover_boxes += [star, mesh]
    two.owner = 0
    prover = forge2.Prover2(entities, [prover_boxes[0], two, *prover_boxes[1:]], flags=[0] * 6 + [1] * 12, roots=3, deepest=0)
    # the box with two sheets takes some leaves of the first star box's face
    prover.given[0][0].lo[0] = 0
    prover.given[0][0].centres = [[[units(Q(1, 8))[0], *c[1:]] for c in pair] for pair in prover.given[0][0].centres]
    return prover
