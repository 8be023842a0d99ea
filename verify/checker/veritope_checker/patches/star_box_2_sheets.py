# SPDX-License-Identifier: Apache-2.0 OR MIT
"""To which sheet of a star box a node belongs (docs/certificates/star-box-2.md, section 4)."""
from ..common.errors import Reject
from ..common.vectors import cross
from . import star_box_work as work_of
from .star_box_patches import FULL, MAX_SIZE, Packing, longest

class Signs:
    """The signs of the separators of a box on the nodes of its descent.  spend: called with units of work."""

    def __init__(self, box, spend):
        self.box, self.spend, self.of = box, spend, {}      # of: for each node that was split, all signs

    def sheet_of(self, node):
        """The number of the sheet to which the node belongs, or None: then its children may be asked for."""
        for separator in self.box.separators:
            if node.patch.num_g * (node.patch.bits + separator.length) > MAX_SIZE:
                raise Reject("C2", "a separator is too long for the degree of a patch")
        before = self.of.get(node.parent, {})
        # If all coefficients on the parent have one sign, so have those on the node.
        signs = {i: sign for i, sign in before.items() if sign}
        for i in before.keys() - signs.keys():
            self.spend(work_of.of_quarter(self.box.separators[i], node))

        def sign(i):
            if i not in signs:
                if i not in before:
                    self.spend(work_of.of_composition(self.box.separators[i], node))
                signs[i] = sign_on(node, self.box.separators[i])
            return signs[i]

        for n, sheet in enumerate(self.box.sheets):
            self.spend(work_of.of_s1(node))
            if has_s1(node, sheet.c) and all(sign(i) == s for i, s in enumerate(sheet.signs) if s):
                return n
        self.of[node] = {i: sign(i) for i in range(len(self.box.separators))}
        return None


# ---------------------------------------------------------------- S1

def has_s1(node, centres):
    return are_apart(node) and all(has_signs(node, c, sign) for c, sign in zip(centres, (1, -1)))

def are_apart(node):
    """Part 4: no two sides of the node in collapsed sides of the patch share a corner."""
    return node.collapsed_sides() is not None

def has_signs(node, c, sign):
    """Parts 1 to 3, for one of the two points."""
    d, x, y, z = node.coefficients()
    rows = [[sign * (d - c[0] * x - c[1] * y - c[2] * z) for d, x, y, z in zip(*row)] for row in zip(d, x, y, z)]
    least = min(map(min, rows))
    return least > 0 or least == 0 and is_positive_inside(node, rows) and not touches_radial_side(node, c)

def is_positive_inside(node, rows):
    """Part 2: the coefficients of which none is negative are positive somewhere, in the rows of all sides that lie in
    no side of the patch, and at all corners that lie on no side of the patch."""
    patch = node.patch
    return (max(map(max, rows)) > 0 and
            all(max(patch.side_of(rows, s)) > 0 for s in range(patch.num_sides) if is_inner_side(node, s)) and
            all(value > 0 for value, at in zip(patch.corner_of(rows), node.at) if is_inner_corner(patch, at)))

def is_inner_side(node, s):
    return node.line(s)[0] is None

def is_inner_corner(patch, at):
    return not sides_at(patch, at)

def touches_radial_side(node, c):
    """Part 3: does a corner of the node lie on a side of the patch, not collapsed, that lies on a line through c?"""
    patch = node.patch
    sides = {s for at in node.at for s in sides_at(patch, at)}
    return any(patch.sides[s] is not None and is_radial(patch.side(s), c) for s in sides)

def sides_at(patch, at):
    """The sides of the patch on which a point of its parameters lies."""
    if patch.is_tensor:
        u, v = at
        return [s for s, lies in enumerate((v == 0, u == FULL, v == FULL, u == 0)) if lies]
    return [s for s in range(3) if at[s] == 0]

def is_radial(curve, c):
    """D x D' = 0 for D = (X, Y, Z) - w c: all coefficients of D are multiples of one vector."""
    first = None
    for x, y, z, w in curve:
        d = x - w * c[0], y - w * c[1], z - w * c[2]
        if first and cross(first, d) != (0, 0, 0):
            return False
        first = first or any(d) and d
    return True


# ---------------------------------------------------------------- separators

def sign_on(node, separator):
    """The sign of all Bernstein coefficients of W^d q(F / W) on the node, or 0 if they have not one sign."""
    *axes, weights = node.net
    up, down = max(separator.exponent, 0), max(-separator.exponent, 0)
    net = [[[x - o * w << down for x, w in zip(*pair)] for pair in zip(axis, weights)]
           for axis, o in zip(axes, separator.origin)]
    net.append([[w << up for w in row] for row in weights])
    p, q, d = len(weights) - 1, len(weights[-1]) - 1, separator.degree
    # at most 20 terms, each a coefficient times a product of d factors with at most 2^(p + q) terms
    bits = max(abs(n).bit_length() for n, _ in separator.terms) + d * (longest(net) + 2 * (p + q)) + 6
    packing = Packing(node.patch.is_tensor, (d * p, d * q), bits)
    powers = [powers_of(packing.packed(rows), d) for rows in net]
    value = sum(n * powers[0][a] * powers[1][b] * powers[2][c] * powers[3][d - a - b - c]
                for n, (a, b, c) in separator.terms if n)
    values = packing.unpacked(value)
    return (min(map(min, values)) > 0) - (max(map(max, values)) < 0)

def powers_of(x, n):
    result = [1]
    for _ in range(n):
        result.append(result[-1] * x)
    return result
