# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Flat patches of any degree (docs/certificates/star-box-2.md, section 5)."""
from fractions import Fraction

from ..common.vectors import cross, dot, sub
from .star_box_patches import Packing, derivatives, longest

def polygon_of(patch):
    """The corners of a flat patch, in the order of its sides; None if the patch is not flat."""
    if patch.rational:
        return None
    weight = patch.net[3][0][0]                             # all weights are equal
    corners = patch.corner_of(points_of(patch))
    normal = cross(sub(corners[1], corners[0]), sub(corners[2], corners[0]))
    if not (is_convex(corners, normal) and lies_in_plane(patch, corners[0], normal) and has_straight_sides(patch) and
            is_unfolded(patch, normal)):
        return None
    return [tuple(Fraction(x, weight) for x in p) for p in corners]

def points_of(patch):
    """The control points, times their common weight."""
    return [list(zip(*rows)) for rows in zip(*patch.net[:3])]

def is_convex(corners, normal):
    """Is each corner strictly to the left of the line through any two successive others?"""
    n = len(corners)
    return all(dot(normal, cross(sub(corners[i - n + 1], corners[i]), sub(corners[i - n + j], corners[i]))) > 0
               for i in range(n) for j in range(2, n))

def lies_in_plane(patch, at, normal):
    return all(dot(normal, sub(p, at)) == 0 for row in points_of(patch) for p in row)

def has_straight_sides(patch):
    """Does each side lie on the line through its ends, which are different?"""
    def is_straight(side):
        along = sub(side[-1], side[0])
        return all(cross(along, sub(p, side[0])) == (0, 0, 0) for p in side)
    return all(is_straight(patch.side(s)) for s in range(patch.num_sides))

def is_unfolded(patch, normal):
    """Is no coefficient of the patch's normal, without its flag, times this one negative, and one positive?"""
    p, q = patch.degrees * (1 if patch.is_tensor else 2)
    bits = 2 * (longest(patch.net[:3]) + 1) + 3 * (p + q) + max(abs(n).bit_length() for n in normal) + 6
    degrees = (2 * p - 1, 2 * q - 1) if patch.is_tensor else (2 * p - 2, 2 * p - 2)
    packing = Packing(patch.is_tensor, degrees, bits)
    u, v = zip(*[map(packing.packed, derivatives(rows, patch.is_tensor)) for rows in patch.net[:3]])
    values = [c for row in packing.unpacked(dot(normal, cross(u, v))) for c in row]
    return min(values) >= 0 < max(values)
