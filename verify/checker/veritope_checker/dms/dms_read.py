# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The reader of simplex-spline solids (docs/formats/dms-files.md). Numbers become fractions."""
from itertools import combinations_with_replacement

from ..common.errors import Refused
from ..patches.star_box_read import members, number, read_json, texts, typed, whole

KEYS = ("format", "degree", "attributes", "vertices", "tetrahedra", "control")
OWN = ("attribute_domain",)
MAX_DEGREE, MAX_ATTRIBUTES, MAX_COUNT, MAX_BITS = 9, 256, 1 << 24, 2048

def read_spline(data):
    """The geometry of a file. Its attribute domain is read, too, but nothing depends on it."""
    top = typed(read_json(data, integer), dict)
    has_own = "attribute_domain" in top
    form, *rest = members(top, *KEYS, *OWN[:has_own])
    if form != "veritope-dms-1" or tuple(top) != KEYS + OWN[:has_own]:
        raise Refused("not veritope-dms-1, or its keys are in another order")
    spline = Spline(rest[:5], 3, [])
    if has_own:
        own = members(typed(rest[5], dict), *KEYS[1:])
        if tuple(rest[5]) != KEYS[1:]:
            raise Refused("the keys of the attribute domain are in another order")
        Spline(own, 0, spline.names)
    return spline

class Spline:
    """degree: n; clouds: of each vertex the knots 0 to n; tetrahedra: four vertices each; shared: whether control
    points are; control: (x, y, z), or () in an attribute domain, by the sorted vertices, or by the tetrahedron and
    beta; num_control; names: the attributes, after those that are taken."""

    def __init__(self, values, coordinates, taken):
        degree, attributes, clouds, tetrahedra, control = values
        self.degree, self.coordinates = whole(degree, 1, MAX_DEGREE), coordinates
        texts(a_list(attributes, 0 if coordinates else 1, MAX_ATTRIBUTES))
        self.names = taken + attributes
        if len(set(self.names)) != len(self.names) or "" in attributes or len(self.names) > MAX_ATTRIBUTES:
            raise Refused("two attributes are equal, one has no name, or there are too many")
        self.given = [self.read_cloud(cloud) for cloud in a_list(clouds, 4, MAX_COUNT)]
        self.clouds = [self.fill(cloud) for cloud in self.given]
        self.tetrahedra = [self.read_tetrahedron(t) for t in a_list(tetrahedra, 1, MAX_COUNT)]
        self.read_control(a_list(control, 1, None), coordinates + len(attributes))

    def read_cloud(self, cloud):
        if len(typed(cloud, list)) not in (1, self.degree, self.degree + 1):
            raise Refused("a cloud of %d knots" % len(cloud))
        return [vector(knot, 3) for knot in cloud]

    def fill(self, cloud):
        if len(cloud) == 1:
            return cloud * (self.degree + 1)
        return cloud if len(cloud) == self.degree + 1 else cloud + cloud[:1]

    def read_tetrahedron(self, tetrahedron):
        corners = tuple(whole(v, 0, len(self.clouds) - 1) for v in a_list(tetrahedron, 4, 4))
        if len(set(corners)) != 4:
            raise Refused("a tetrahedron has a vertex twice")
        return corners

    def read_control(self, entries, size):
        self.shared = type(entries[0]) is dict and "at" in entries[0]
        self.last = self.degree - self.shared
        self.control, self.num_control = {}, len(entries)
        for entry in entries:
            if self.shared:
                at, value = members(entry, "at", "value")
                key = tuple(whole(v, 0, len(self.clouds) - 1) for v in a_list(at, self.degree, self.degree))
                if list(key) != sorted(key):
                    raise Refused("the vertices of a control point decrease")
            else:
                t, beta, value = members(entry, "tetrahedron", "beta", "value")
                key = whole(t, 0, len(self.tetrahedra) - 1), tuple(whole(b, 0, self.degree) for b in a_list(beta, 4, 4))
                if sum(key[1]) != self.degree:
                    raise Refused("the numbers of a beta do not add up to the degree")
            if key in self.control:
                raise Refused("a control point twice")
            self.control[key] = vector(value, size)[:self.coordinates]
        self.check_complete()

    def check_complete(self):
        if self.shared:
            needed = {key for t in self.tetrahedra for key in combinations_with_replacement(sorted(t), self.degree)}
            if needed != set(self.control):
                raise Refused("a control point is missing, or belongs to no tetrahedron")
            return
        per_tetrahedron = (self.degree + 1) * (self.degree + 2) * (self.degree + 3) // 6
        if len(self.control) != per_tetrahedron * len(self.tetrahedra):
            raise Refused("a control point is missing")
        if any(len(cloud) not in (1, self.degree + 1) for cloud in self.given):
            raise Refused("a cloud lacks its last knot")

def integer(text):
    """The value of an integer in JSON: digits only."""
    if len(text) > 15 or not text.isdigit():
        raise Refused("no integer as the page says: %s" % text[:20])
    return int(text)

def a_list(value, least, most):
    if len(typed(value, list)) < least or most is not None and len(value) > most:
        raise Refused("a list of %d where %d to %s belong" % (len(value), least, most))
    return value

def vector(values, size):
    numbers = [number(c) for c in a_list(values, size, size)]
    if any(max(abs(c.numerator), c.denominator) >> MAX_BITS for c in numbers):
        raise Refused("a number has a part of more than %d bits" % MAX_BITS)
    return numbers
