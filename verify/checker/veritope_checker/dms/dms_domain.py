# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The domain and the clouds of a simplex-spline solid (docs/certificates/dms-solid.md, sections 3 and 4): D1 to E3."""
from ..common.errors import Reject
from ..patches.star_box_2_check import Checker2
from ..patches.star_box_read import Entity
from ..patches.star_box_work import UNITS_OF_BYTE, words_of
from .dms_map import box_of, det, multi_indices
from .dms_near import scaled_planes
from .dms_walls import Region, face_planes

def faces_of(tetrahedron):
    """Seen from outside."""
    p, q, r, s = tetrahedron
    return (q, r, s), (p, s, r), (p, q, s), (p, r, q)

def cycle(face):
    """The cyclic order, from its least vertex."""
    i = face.index(min(face))
    return face[i:] + face[:i]

def boundary_of(model, fail=lambda condition, why: None):
    """The faces that have no opposite one, in order. Tests D2."""
    faces = [face for t in model.tetrahedra for face in faces_of(t)]
    found = set(map(cycle, faces))
    if len(found) != len(faces):
        fail("D2", "a face occurs twice in one direction")
    boundary = [face for face in faces if cycle(face[::-1]) not in found]
    if not boundary:
        fail("D2", "the tetrahedra have no boundary")
    return boundary

def owners_of(model, boundary):
    """The tetrahedron of each face of the boundary."""
    owners = {cycle(face): t for t, corners in enumerate(model.tetrahedra) for face in faces_of(corners)}
    return [owners[cycle(face)] for face in boundary]

def test_tetrahedra(spline, fail):
    """D1."""
    for t in range(len(spline.model.tetrahedra)):
        if det(*spline.corners(t)) <= 0:
            fail("D1", "tetrahedron %d is flat or reversed" % t)

def triangle_entity(degree, coefficients):
    """coefficients: in the order of a file's triangle."""
    entity = Entity("triangle")
    entity.degrees, entity.dimension = (degree,), 3
    flat = [[*point, 1] for point in coefficients]
    entity.rows = [flat[r * (r + 1) // 2:(r + 1) * (r + 2) // 2] for r in range(degree + 1)]
    return entity

def numbers_of_surface(data, statement, entities, skip, name):
    """The numbers of a part that is a body of star-box-2: D3 and T3."""
    checker = Checker2(b"VTS2", statement, data, entities, skip)
    checker.make_patches()
    checker.work += UNITS_OF_BYTE * sum(map(words_of, checker.patches))
    numbers = checker.numbers()
    if any(checker.cert.flags) or numbers["bodies"] == 0:
        if name not in skip:
            raise Reject(name, "a triangle is reversed, or there is no body")
    return {key: numbers[key] for key in ("shells", "bodies", "genus")}

def test_control(spline, fail):
    """E1."""
    model, seen = spline.model, {}
    if not model.shared:
        for (t, beta), value in model.control.items():
            key = tuple(sorted(v for v, b in zip(model.tetrahedra[t], beta) for _ in range(b)))
            if seen.setdefault(key, value) != value:
                fail("E1", "control points of tetrahedron %d differ from a neighbour's" % t)

def test_clouds(spline, fail):
    """E2."""
    model = spline.model
    for total in range(model.last + 1):
        for gamma in multi_indices(total, 4):
            for t in range(len(model.tetrahedra)):
                if det(*spline.w_of(t, gamma)) <= 0:
                    fail("E2", "knots %s of tetrahedron %d are flat or reversed" % (gamma, t))

def test_hulls(spline, boundary, planes, spend, fail):
    """E3. planes: the lists of the faces."""
    last = spline.model.last
    for face, of_face in zip(boundary, planes):
        places = [spline.knots[v][0] for v in face]
        of_face = scaled_planes(spline, of_face)
        for index in multi_indices(last, 3):
            hull = {spline.knots[v][k] for v, i in zip(face, index) for k in range(i + 1)}
            if hull <= set(places):
                continue
            for t in spline.cells.meeting(box_of(list(hull))):
                spend("E3")
                corners = spline.corners(t)
                if not Region(corners, [*face_planes(corners), *of_face]).misses(hull):
                    fail("E3", "knots of the face %s may lie in tetrahedron %d" % (face, t))
