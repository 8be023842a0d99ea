# SPDX-License-Identifier: Apache-2.0 OR MIT
"""A prover of collar certificates for small models: tests only. It covers the hulls of leaves with cells, or takes given cells, collapses
greedily and looks for straight shores. It uses the checker's own complex, which collar_test.py compares with grids of unit cubes."""
import copy
from collections import deque

import star_box_forge as forge
from veritope_checker.collar import collar_complex as complexes

star_nodes, star_triangles, read = forge.star_nodes, forge.star_triangles, forge.read
FULL, LEVELS = complexes.FULL, complexes.LEVELS


class Plan(forge.Plan):
    """Everything that a body says. codes, sides, collapses as in the body, undone; finer: for each leaf 1 or four trees; shores: (points, end)."""

    def take(self, plan):
        self.__dict__.update(copy.deepcopy(plan.__dict__))
        self.values.update(claim="collar-1")
        self.shift, self.least, self.codes, self.sides, self.collapses, self.finer, self.shores = 0, [0] * 3, [], [], [], [], []
        return self

    def body(self):
        tail, self.tail = self.tail, b""
        out = [super().body()]
        self.tail = tail
        out += [forge.varint(self.shift), *map(forge.zigzag, self.least), forge.u32(len(self.codes))]
        out += [forge.varint(b - a) for a, b in zip([0, *self.codes], self.codes)]
        out += [forge.u32(len(self.sides)), bytes(self.sides)]
        out += [forge.zigzag(b - a) for a, b in zip([0, *self.collapses], self.collapses)]
        out += [encoded(tree) for tree in self.finer]
        for points, end in self.shores:
            out += [forge.u32(len(points))] + [b"\0" + b"".join(map(forge.zigzag, p)) for p in points]
            out.append(bytes([end]) if isinstance(end, int) else b"\6" + forge.varint(end[0]) + bytes([end[1]]))
        return b"".join(out) + tail


def encoded(tree):
    return b"\1" if tree == 1 else b"\0" + b"".join(map(encoded, tree))


def in_version_2(plan, star):
    """The certificate of version 2 with what `plan` says of the collar after the star boxes of `star`, a plan of version 2."""
    bare, result = copy.copy(plan), copy.copy(star)
    bare.tail = b""
    result.tail = bare.body()[len(forge.Plan.body(bare)):] + plan.tail
    result.values = dict(star.values, claim="collar-2", cells=plan.values["cells"])
    return result


class Collar:
    """A collar of a model that a star-box Prover has proved. The root is [corner, corner + 2^shift]^3 in units of the model."""

    def __init__(self, prover, corner, shift, depth=0):
        self.prover, self.plan = prover, Plan([]).take(prover.plan)
        self.model = prover.model
        self.corner, self.shift = corner, shift
        scale = -prover.plan.unit                           # the model's unit is 2^scale units of the body
        self.plan.shift, self.plan.least = shift + scale - LEVELS, [c << LEVELS - shift for c in corner]
        assert self.plan.shift >= 0
        self.hulls = []
        for patch, trees in zip(prover.patches, prover.plan.trees):
            for root, tree in zip(star_nodes.root_nodes(patch), trees):
                self.refine(root, tree, depth)

    def refine(self, node, tree, depth):
        if isinstance(tree, list):
            for kid, of_kid in zip(node.children(), tree):
                self.refine(kid, of_kid, depth)
        else:
            self.plan.finer.append(self.leaves(node, depth))

    def leaves(self, node, depth):
        if depth:
            return [self.leaves(kid, depth - 1) for kid in node.children()]
        lo, hi = node.hull()
        step = 1 << self.plan.shift
        least = [c * step for c in self.plan.least]
        self.hulls.append(([-((c * m - a) // (m * step)) for (a, m), c in zip(lo, least)], [(b - c * n) // (n * step) for (b, n), c in zip(hi, least)]))
        return 1

    def cells_at(self, level):
        """The codes of the cells of a level that meet the hulls."""
        codes, size = set(), FULL >> level
        for lo, hi in self.hulls:
            ranges = [range(-(-a // size) - 1, b // size + 1) for a, b in zip(lo, hi)]
            codes |= {complexes.code_of((x * size, y * size, z * size), size) for x in ranges[0] for y in ranges[1] for z in ranges[2]}
        return sorted(codes)

    def codes_of(self, cells):
        """(x, y, z, size) in units of the model."""
        unit = FULL >> self.shift
        return sorted(complexes.code_of([(c - o) * unit for c, o in zip(p, self.corner)], size * unit) for *p, size in cells)

    def build(self, codes, inner=None, shores=True, steps=True):
        """inner: is d+ the inner side? With None it is the first side that works."""
        plan = self.plan
        plan.codes, plan.values["cells"] = codes, len(codes)
        self.complex = complexes.Complex(complexes.Cells(codes, len(codes)))
        for choice in (False, True) if inner is None else (inner,):
            plan.sides = self.outer_sides(choice)
            plan.collapses, stuck = collapse(self.complex, plan.sides)
            if not stuck:
                break
        else:
            if steps:
                raise ValueError("the collapse gets stuck")
        plan.shores = [self.shore(c) if shores else ([], 1) for c in range(self.complex.num_components)]
        return self

    def outer_sides(self, inner):
        """The outer boundary of each component has its least face; the others are inner."""
        seen, sides = set(), []
        for body in self.complex.body_of_component:
            sides.append(int((body in seen) == inner))
            seen.add(body)
        return sides

    def ends_at(self, box):
        """c- and c+ of a box at which shores may end."""
        return forge.check_box(box).c if box.kind == 0 else ()

    def shore(self, component):
        step = 1 << self.plan.shift
        start = [(a + b) * step for a, b in zip(self.plan.least, self.complex.least_vertex(component))]
        for end in range(6):
            ray = [0, 0, 0]
            ray[end // 2] = 1 - 2 * (end % 2)
            if self.prover.is_free(star_nodes.misses_segment(start, ray, True)):
                return [], end
        for number, box in enumerate(self.plan.boxes):
            for sign, to in enumerate(self.ends_at(box)):
                if self.prover.is_free(star_nodes.misses_segment(start, star_triangles.sub(to, start), False)):
                    return [], (number, sign)
        raise ValueError("no shore found")

    def certificate(self):
        return self.plan.certificate(self.model)


def collapse(complex_, sides, rng=None):
    """From d-, breadth first or at random: (numbers of the faces, what the checker says against them)."""
    remaining, faces_of, steps = [set(of) for of in complex_.cells_of], {}, []
    for n, of in enumerate(complex_.cells_of):
        for cell in of:
            faces_of.setdefault(cell, []).append(n)
    outer = {n for n, c in complex_.component_of.items() if sides[c] == 1}
    queue = deque(n for n in complex_.boundary if n not in outer)
    while queue:
        if rng:
            queue.rotate(rng.randrange(-9, 10))
        n = queue.popleft()
        if len(remaining[n]) == 1 and n not in outer:
            cell, = remaining[n]
            steps.append(n)
            for m in faces_of[cell]:
                remaining[m].discard(cell)
                if m != n and len(remaining[m]) == 1:
                    queue.append(m)
    missing = len(complex_.cells.codes) - len(steps)
    return steps + [0] * missing, "cells are left" if missing else complex_.bad_collapse(sides, steps)
