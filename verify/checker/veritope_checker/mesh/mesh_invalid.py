# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claim mesh-invalid-1: docs/certificates/mesh.md, section 7."""
from ..common.errors import Reject
from ..common.vectors import dot, sub
from .mesh_model import TOO_MUCH_WORK, Body, collapsed, directed_edges, line_stabs, read_mesh, sign

INVALID_FIELDS = {1: "f", 2: "ff", 3: "vv", 4: "vv", 5: "vv", 6: "v", 7: "ffnnnnnn", 8: "fu", 9: "fu"}

def check(claim, statement, body, model, skip):
    mesh, body = read_mesh(statement, model), Body(body)
    witnesses, last = [], 0
    body.header(claim.magic, mesh.points, mesh.triangles)
    count = body.u32()
    if not 1 <= count <= len(body.data):
        raise Reject("B1", "no witness, or a count larger than the body")
    for _ in range(count):
        rule = body.u8()
        if rule not in INVALID_FIELDS or rule < last:
            raise Reject("B1", "an unknown rule, or rules not ascending")
        witnesses.append((rule, [read_field(body, mesh, kind) for kind in INVALID_FIELDS[rule]]))
        last = rule
    body.end()
    allowed = body.work(mesh)
    directed = directed_edges([t for t in mesh.triangles if not collapsed(t)])
    for fan_at_v in mesh.fans:                              # such triangles are at no vertex
        fan_at_v[:] = [entry for entry in fan_at_v if not collapsed(mesh.triangles[entry[0]])]
    holds = {1: i1_degenerate, 2: i2_duplicate, 3: i3_boundary, 4: i4_crowded, 5: i5_misoriented,
             6: i6_fans, 7: i7_intersection, 8: i8_winding, 9: i8_winding}
    for rule, fields in witnesses:
        allowed -= work_of(rule, mesh, fields)
        if allowed < 0:
            raise Reject("B1", TOO_MUCH_WORK)
        if not holds[rule](mesh, directed, *fields) and "I%d" % rule not in skip:
            raise Reject("I%d" % rule, "witness %s of rule M%d proves nothing" % (fields[:2], rule))
    rules = " ".join("M%d" % r for r in sorted({r for r, _ in witnesses}))
    if statement["rules"] != rules and "I10" not in skip:
        raise Reject("I10", "the statement lists %s, the witnesses %s" % (statement["rules"], rules))

def work_of(rule, mesh, fields):
    """The work that section 7 counts for a witness."""
    if rule in (3, 4, 5, 6):
        return min(len(mesh.fans[v]) for v in fields)
    return len(mesh.triangles) if rule > 7 else 0

def read_field(body, mesh, kind):
    if kind == "n":
        size = body.u32()
        if size > 4096:
            raise Reject("B1", "a natural number of %d bytes" % size)
        data = body.bytes(size)
        if data and data[-1] == 0:
            raise Reject("B1", "a natural number with a leading zero")
        return int.from_bytes(data, "little")
    value = body.u8() if kind == "u" else body.u32()
    if value >= {"u": 3, "f": len(mesh.triangles), "v": len(mesh.points)}[kind]:
        raise Reject("B1", "an index is out of range")
    return value

def i1_degenerate(mesh, _, f):
    return mesh.normals[f] == (0, 0, 0)                     # so it is if two of the ids are equal

def i2_duplicate(mesh, _, f, g):
    f_set = set(mesh.triangles[f])
    return f != g and len(f_set) == 3 and f_set == set(mesh.triangles[g])

def uses(directed, a, b):
    return directed.get((a, b), 0) + directed.get((b, a), 0)

def i3_boundary(_, directed, a, b):
    return uses(directed, a, b) == 1

def i4_crowded(_, directed, a, b):
    return uses(directed, a, b) >= 3

def i5_misoriented(_, directed, a, b):
    return uses(directed, a, b) == 2 == directed.get((a, b), 0)

def i6_fans(mesh, _, v):
    neighbours = {}                                         # in the link of v: paths and circles of its edges p q
    for _, p, q in mesh.fans[v]:
        neighbours.setdefault(p, []).append(q)
        neighbours.setdefault(q, []).append(p)
    reached = {next(iter(neighbours))} if neighbours else set()
    todo = list(reached)
    while todo:
        for q in neighbours[todo.pop()]:
            if q not in reached:
                reached.add(q)
                todo.append(q)
    return len(reached) < len(neighbours)

def i7_intersection(mesh, _, f, g, *weights):
    if f == g or (0, 0, 0) in (mesh.normals[f], mesh.normals[g]):
        return False
    w, x = weights[:3], weights[3:]
    if sum(w) == 0 or sum(x) == 0:
        return False
    for at_f, at_g in zip(zip(*mesh.corners(f)), zip(*mesh.corners(g))):            # x, y, z
        if sum(x) * dot(w, at_f) != sum(w) * dot(x, at_g):
            return False
    return any(w[i] > 0 and mesh.triangles[f][i] not in mesh.triangles[g] for i in range(3))

def i8_winding(mesh, _, f, u):
    outward = sign(mesh.normals[f][u])
    if outward == 0:
        return False
    at = [2 * a + b + c for a, b, c in zip(*mesh.corners(f))]                       # 4 P
    w = 0
    for g in range(len(mesh.triangles)):
        corners = [[4 * c for c in p] for p in mesh.corners(g)]
        if g != f and line_stabs(corners, at, u):
            t = dot(mesh.normals[g], sub(corners[0], at))
            if t == 0:
                return False
            if sign(t) == sign(mesh.normals[g][u]) * outward:
                w += sign(mesh.normals[g][u]) * outward
    return w != 0
