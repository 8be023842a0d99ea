# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Models in MFEM's format of NURBS meshes: docs/certificates/reading-rule-mfem.md, section by section."""
import re
from collections import namedtuple
from fractions import Fraction
from math import prod

from ..common.errors import Refused
from .model_maps import map_of
from .model_mfem_numbers import Numbering
from .model_tokens import Tokens

COMMENT = re.compile(rb"#[^\r\n]*")
COLLECTION = re.compile(rb"NURBS([1-9][0-9]*)?")
VERTICES_OF = {0: 1, 1: 2, 3: 4, 5: 8}                      # of a part of the boundary with this geometry
PATCH_GEOMETRY = {2: 3, 3: 5}
MAX_DIMENSION, MAX_DEGREE = 1000, 63

# patches: the vertices of each; edges: (knot vector, from, to)
Mesh = namedtuple("Mesh", "num_axes patches edges num_vertices")
KnotVector = namedtuple("KnotVector", "degree size knots")

def read_mfem(data):
    """The patches of the mesh: surfaces or volumes."""
    tokens = Tokens(COMMENT.sub(lambda m: b" " * len(m[0]), data))
    for word in (b"MFEM", b"NURBS", b"mesh"):
        tokens.one_of(word)
    version = tokens.one_of(b"v1.0", b"v1.1")
    mesh = read_topology(tokens)
    if tokens.one_of(b"patches", b"knotvectors") == b"patches":
        entities = [read_patch(tokens, mesh.num_axes) for _ in mesh.patches]
    else:
        entities = read_shared(tokens, mesh, version == b"v1.1")
    tokens.end()
    return entities


# ---------------------------------------------------------------- section 2: the topology

def read_topology(tokens):
    tokens.one_of(b"dimension")
    num_axes = tokens.integer(2, 3)
    tokens.one_of(b"elements")
    patches = [read_element(tokens, num_axes) for _ in range(tokens.integer(1, tokens.size))]
    tokens.one_of(b"boundary")
    for _ in range(tokens.count()):
        tokens.integer()
        geometry = tokens.integer(0, 5)
        if geometry not in VERTICES_OF:
            tokens.refuse("0, 1, 3 or 5")
        for _ in range(VERTICES_OF[geometry]):
            tokens.count()
    tokens.one_of(b"edges")
    edges = [(tokens.count(), tokens.count(), tokens.count()) for _ in range(tokens.count())]
    tokens.one_of(b"vertices")
    num_vertices = tokens.count()
    if max(map(max, patches)) >= num_vertices:
        tokens.refuse("a number of vertices greater than %d" % max(map(max, patches)))
    return Mesh(num_axes, patches, edges, num_vertices)

def read_element(tokens, num_axes):
    tokens.integer()
    tokens.integer(PATCH_GEOMETRY[num_axes], PATCH_GEOMETRY[num_axes])
    return [tokens.count() for _ in range(1 << num_axes)]

def read_knot_vector(tokens):
    degree, size = tokens.integer(1, MAX_DEGREE), tokens.count()
    if size <= degree:
        tokens.refuse("a number of control points greater than the degree %d" % degree)
    return KnotVector(degree, size, tokens.knots(degree, size))


# ---------------------------------------------------------------- section 3: a patch by itself

def read_patch(tokens, num_axes):
    tokens.one_of(b"knotvectors")
    tokens.integer(num_axes, num_axes)
    axes = [read_knot_vector(tokens) for _ in range(num_axes)]
    tokens.one_of(b"dimension")
    dimension = tokens.integer(1, MAX_DIMENSION)
    kind = tokens.one_of(b"controlpoints", b"controlpoints_homogeneous", b"controlpoints_cartesian")
    points = tokens.weighted(prod(axis.size for axis in axes), dimension)
    if kind == b"controlpoints_cartesian":
        points = [homogeneous(point[:-1], point[-1]) for point in points]
    return map_of([axis.degree for axis in axes], [axis.knots for axis in axes], True, dimension, points)

def homogeneous(coordinates, weight):
    return [*(weight * c for c in coordinates), weight]


# ---------------------------------------------------------------- section 4: patches that share control points

def read_shared(tokens, mesh, is_newer):
    knot_vectors = [read_knot_vector(tokens) for _ in range(tokens.integer(1, tokens.size))]
    if is_newer:
        pass_over_refinements(tokens, mesh.num_axes, len(knot_vectors))
    numbering = Numbering(mesh, knot_vectors, tokens.size)
    count = numbering.count
    kind = tokens.one_of(b"weights", b"unitweights", b"autoweights")
    weights = tokens.decimals(count) if kind == b"weights" else None
    read_collection(tokens, knot_vectors)
    tokens.one_of(b"VDim:")
    dimension = tokens.integer(1, MAX_DIMENSION)
    tokens.one_of(b"Ordering:")
    is_by_point = tokens.integer(0, 1) == 1
    numbers, made = tokens.decimals(count * dimension), {}

    def point(m):
        if m not in made:
            at = numbers[m * dimension:(m + 1) * dimension] if is_by_point else numbers[m::count]
            weight = weights[m] if weights else Fraction(1)
            if weight <= 0:
                raise Refused("the weight of control point %d is not positive" % m)
            made[m] = homogeneous(at, weight)
        return made[m]

    return [map_of(degrees, knots, True, dimension, [point(m) for m in numbers_of_patch])
            for degrees, knots, numbers_of_patch in numbering.patches()]

def pass_over_refinements(tokens, num_axes, num_knot_vectors):
    """Reads what only files of v1.1 have; it means nothing."""
    if tokens.peek() == b"refinements":
        tokens.word()
        for _ in range(num_axes):
            tokens.integer()
    if tokens.peek() == b"knotvector_refinements":
        tokens.word()
        for _ in range(num_knot_vectors):
            for _ in range(tokens.count()):
                tokens.integer()
    tokens.one_of(b"spacing")
    for _ in range(tokens.count()):
        tokens.integer(), tokens.integer()
        num_integers, num_decimals = tokens.count(), tokens.count()
        for _ in range(num_integers):
            tokens.integer()
        tokens.decimals(num_decimals)

def read_collection(tokens, knot_vectors):
    tokens.one_of(b"FiniteElementSpace")
    tokens.one_of(b"FiniteElementCollection:")
    m = COLLECTION.fullmatch(tokens.word())
    if not m or m[1] and any(m[1] != b"%d" % kv.degree for kv in knot_vectors):
        tokens.refuse("NURBS, or NURBS and the degree of all knot vectors,")
