# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Findings about domains and clouds (docs/certificates/dms-invalid.md, section 3): W0 to W4 and W7 to W10. Each
function takes the model and the witness, and says why the condition does not hold, or None."""
from ..common.vectors import cross, dot, sub
from ..patches.star_box_patches import Groups
from .dms_domain import boundary_of, cycle, faces_of
from .dms_map import AXES, det, faces_and_apexes

ORIGIN = (0, 0, 0)

def place(model, v):
    return model.clouds[v][0]

def corners_of(model, t):
    return [place(model, v) for v in model.tetrahedra[t]]

def w_of(model, t, gamma):
    return [model.clouds[v][i] for v, i in zip(model.tetrahedra[t], gamma)]

def face_at(model, face):
    t, number = face
    return faces_of(model.tetrahedra[t])[number]

def is_of_the_boundary(model, *faces):
    known = set(map(cycle, boundary_of(model)))
    return all(cycle(face) in known for face in faces)

def is_strictly_inside(point, corners):
    """Whether a point is inside of a tetrahedron, whose volume is positive, too."""
    return det(*corners) > 0 and all(det(point, *face) > 0 for face, _ in faces_and_apexes(corners))

def mean(points, weights):
    """The mean with these weights, or None if they do not define one."""
    if min(weights) < 0 or not any(weights):
        return None
    return [sum(w * p[i] for w, p in zip(weights, points)) / sum(weights) for i in range(3)]

def why_not_reversed(model, t):
    return "its volume is positive" if det(*corners_of(model, t)) > 0 else None

def why_not_overused(model, faces):
    one, other = faces
    if one == other:
        return "the two faces are one"
    if cycle(face_at(model, one)) != cycle(face_at(model, other)):
        return "the two faces differ"
    return None

def why_not_degenerate(model, witness):
    t, gamma = witness
    if not 0 < sum(gamma) <= model.last:
        return "no condition is about this index"
    return "the volume of its knots is positive" if det(*w_of(model, t, gamma)) > 0 else None

def why_a_core(model, witness):
    t, terms = witness
    totals = [0, 0, 0, 0]                                   # of the sum at the origin and at the ends of the axes
    for gamma, m, y in terms:
        if sum(gamma) > model.last or y <= 0:
            return "no condition is about an index, or a factor is not positive"
        w = w_of(model, t, gamma)
        if det(*w) <= 0:
            return "a volume is not positive"
        totals = [total + y * det(*w[:m], u, *w[m + 1:]) for total, u in zip(totals, (ORIGIN, *AXES))]
    if any(total != totals[0] for total in totals) or totals[0] > 0:
        return "the sum is not constant, or positive"
    return None

def why_not_inside(model, witness):
    number, index, t, weights = witness
    face = face_at(model, number)
    if sum(index) != model.last or not is_of_the_boundary(model, face):
        return "no condition is about this hull"
    u = mean([model.clouds[v][k] for v, i in zip(face, index) for k in range(i + 1)], weights)
    if u is None or not is_strictly_inside(u, corners_of(model, t)):
        return "no mean with these weights is inside of the tetrahedron"
    return None

def why_no_edge_of_three(model, vertices):
    a, b = vertices
    if a >= b:
        return "the vertices do not ascend"
    number = sum(a in face and b in face for face in boundary_of(model))
    return "%d faces of the boundary have this edge" % number if number < 3 else None

def why_one_fan(model, v):
    faces = [face for face in boundary_of(model) if v in face]
    groups, first = Groups(len(faces)), {}
    for i, face in enumerate(faces):
        for w in face:
            if w != v:
                groups.unite(i, first.setdefault(w, i))
    return "its faces form one fan, or there are none" if len(set(groups.number())) < 2 else None

def why_proper(model, witness):
    one, other, *weights = witness
    faces = [face_at(model, one), face_at(model, other)]
    if not is_of_the_boundary(model, *faces) or set(faces[0]) == set(faces[1]):
        return "they are not two faces of the boundary"
    first, second = [mean([place(model, v) for v in face], of_face) for face, of_face in zip(faces, weights)]
    if first is None or first != second:
        return "the weights are of two points"
    if not any(w > 0 and v not in faces[1] for v, w in zip(faces[0], weights[0])):
        return "the point lies between common vertices"
    return None

def why_apart(model, witness):
    one, other, point = witness
    if one == other:
        return "the two tetrahedra are one"
    if not all(is_strictly_inside(point, corners_of(model, t)) for t in (one, other)):
        return "the point is not inside of both tetrahedra"
    return None

TESTS = {"tet-reversed": why_not_reversed, "tet-face-overused": why_not_overused,
         "cloud-degenerate": why_not_degenerate, "cloud-no-core": why_a_core, "cloud-inside": why_not_inside,
         "M4": why_no_edge_of_three, "M6": why_one_fan, "M7": why_proper, "M9": why_apart}
