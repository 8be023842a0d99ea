# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The boundary faces of volumes: docs/certificates/reading-rule-faces.md, sections 1 to 3."""
from itertools import islice, product

from ..common.errors import Refused
from .model_powers import scaled
from .model_walls import left_over
from .model_maps import Volume
from .star_box_read import Entity

MAX_BITS, MAX_KNOT_BITS = 8192, 2048    # of the integers of a control point; of the parts of a knot
MAX_TRIED = 1000                        # determinants of section 2, list 2
# The two parameters of the faces across an axis, at its begin and at its end, of a volume of hand +1.
PARAMETERS = (((2, 1), (1, 2)), ((0, 2), (2, 0)), ((1, 0), (0, 1)))

def boundary_faces(volumes):
    """The surfaces that are left of the faces of all volumes."""
    faces = []
    for n, (volume, exact) in enumerate(checked(volumes)):
        faces += faces_of(volume, hand_of(n, volume, exact))
    surfaces = left_over(faces)
    if not surfaces:
        raise Refused("the volumes have no boundary face that is not a wall between two and has an area")
    return surfaces


# ---------------------------------------------------------------- section 1: volumes

def checked(volumes):
    """Each volume without its attributes, and its control points, each in integers; refuses what section 1 refuses."""
    for n, volume in enumerate(volumes):
        check_volume(n, volume)
        volume = in_space(n, volume)
        yield volume, [integers(n, point) for point in volume.points]

def check_volume(n, volume):
    if volume.kind != "volume" or volume.dimension < 3:
        raise Refused("entity %d is no volume with at least three coordinates" % n)
    for axis, (p, knots) in enumerate(zip(volume.degrees, volume.knots)):
        if max(max(abs(t.numerator), t.denominator) for t in knots).bit_length() > MAX_KNOT_BITS:
            raise Refused("a knot of volume %d has a part of more than %d bits" % (n, MAX_KNOT_BITS))
        inner = knots[p + 1:-p - 1]
        if knots[0] != knots[p] or knots[-1] != knots[-p - 1] or any(a == b for a, b in zip(inner, inner[p:])):
            raise Refused("axis %d of volume %d does not begin and end with %d equal knots, or has more than %d equal"
                          " ones between" % (axis, n, p + 1, p))

def in_space(n, volume):
    """The volume without its attributes."""
    if volume.dimension == 3:
        return volume
    attributes = [a for point in volume.points for a in point[3:-1]]
    if max(max(abs(a.numerator), a.denominator) for a in attributes).bit_length() > MAX_BITS:
        raise Refused("an attribute of volume %d has a part of more than %d bits" % (n, MAX_BITS))
    return Volume(volume.degrees, volume.knots, volume.rational, 3, [[*p[:3], p[-1]] for p in volume.points])

def integers(n, point):
    """The homogeneous point, times the least common denominator of its numbers."""
    result, common = scaled(point)
    if max(common, *map(abs, result)).bit_length() > MAX_BITS:
        raise Refused("a control point of volume %d has integers of more than %d bits" % (n, MAX_BITS))
    return result


# ---------------------------------------------------------------- section 2: the hand

def hand_of(n, volume, exact):
    """1 or -1; 1 if all determinants are 0."""
    at_corners = set(corner_hands(volume, exact)) - {0}
    if len(at_corners) == 2:
        raise Refused("volume %d is folded: its corners have different hands" % n)
    if at_corners:
        return at_corners.pop()
    strides = volume.strides()
    for k, j, i in islice(product(*[range(size - 1) for size in volume.sizes[::-1]]), MAX_TRIED):
        at = i + j * strides[1] + k * strides[2]
        turn = orientation(exact[at], *[exact[at + stride] for stride in strides])
        if turn:
            return turn
    return 1

def corner_hands(volume, exact):
    """The sign of each corner's determinant, list 1."""
    strides = volume.strides()
    for ends in product((0, 1), repeat=3):
        ends, sign, at = ends[::-1], 1, 0
        for end, size, stride in zip(ends, volume.sizes, strides):
            at, sign = at + end * (size - 1) * stride, -sign if end else sign
        inward = [exact[at - stride if end else at + stride] for end, stride in zip(ends, strides)]
        yield sign * orientation(exact[at], *inward)

def orientation(p, q, r, s):
    """The sign of the determinant of the vectors from p to q, r and s; all have positive weights."""
    (a, b, c, d), (e, f, g, h) = p, q
    x, y, z, w = r
    i, j, k, l = s
    det = ((a * f - b * e) * (z * l - w * k) - (a * g - c * e) * (y * l - w * j) + (a * h - d * e) * (y * k - z * j)
           + (b * g - c * f) * (x * l - w * i) - (b * h - d * f) * (x * k - z * i) + (c * h - d * g) * (x * j - y * i))
    return (det < 0) - (det > 0)


# ---------------------------------------------------------------- section 3: faces

def face_of(volume, axis, end, axes):
    """The face across this axis, with these two axes as parameters."""
    (u, v), strides = axes, volume.strides()
    first = end * (volume.sizes[axis] - 1) * strides[axis]
    face = Entity("surface")
    face.degrees, face.knots = (volume.degrees[u], volume.degrees[v]), [volume.knots[u], volume.knots[v]]
    face.rational, face.dimension = volume.rational, 3
    face.rows = [[volume.points[first + i * strides[u] + j * strides[v]] for j in range(volume.sizes[v])]
                 for i in range(volume.sizes[u])]
    return face

def faces_of(volume, hand):
    return [face_of(volume, axis, end, axes[::hand]) for axis, of_axis in enumerate(PARAMETERS)
            for end, axes in enumerate(of_axis)]
