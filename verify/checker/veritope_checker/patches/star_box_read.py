# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The input of star_box_check.py: a model (docs/formats/spline-json.md) and the body of a certificate
(docs/certificates/star-box.md, section 2).  All numbers become integers or fractions."""
import json
import re
from fractions import Fraction
from math import gcd, prod

from ..common.errors import Refused, Reject

MAX_DEPTH = 24                          # levels below a root
MAX_LONG, MAX_SHIFT = 256, 4096         # bytes of a long rational's numerator; exponents of 2
MAX_FILE_DEGREE = 63                    # of the file format
MAX_NESTED = 100                        # of a shape that is not looked into
MAX_DIGITS, MAX_EXPONENT = 1000, 4096   # of a number of the model
OTHER_KINDS = frozenset(("curve", "volume", "trimmed", "model"))    # star-box certificates do not cover them


# ---------------------------------------------------------------- spline-json.md: the model

RATIO = re.compile(r"([-+]?)([0-9]+)(?:/([0-9]+))?")
DECIMAL = re.compile(r"([-+]?)([0-9]*)(?:\.([0-9]*))?(?:[eE]([-+]?[0-9]+))?")
HEXADECIMAL = re.compile(r"([-+]?)0[xX]([0-9a-fA-F]*)(?:\.([0-9a-fA-F]*))?(?:[pP]([-+]?[0-9]+))?")

class Entity:
    """A surface or a triangle.  rows: rows of homogeneous points; a triangle has the rows of an array."""

    def __init__(self, kind):
        self.kind, self.degrees, self.knots, self.rational, self.dimension, self.rows = kind, (), (), False, 0, ()

def natural(digits):
    """int() of a natural of any length: Python refuses long decimals in one call."""
    return int(digits) if len(digits) <= 4000 else natural(digits[:-4000]) * 10 ** 4000 + int(digits[-4000:])

def number(text):
    m = RATIO.fullmatch(typed(text, str))
    if m:
        if max(len(m[2]), len(m[3] or "")) > MAX_DIGITS + MAX_EXPONENT:
            raise Refused("too many digits")
        q = natural(m[3]) if m[3] else 1
        if q == 0:
            raise Refused("a denominator is 0")
        value = Fraction(natural(m[2]), q)
    else:
        base, m = (16, HEXADECIMAL.fullmatch(text)) if "x" in text.lower() else (10, DECIMAL.fullmatch(text))
        digits = m and m[2] + (m[3] or "")
        if not digits or len(digits) > MAX_DIGITS:
            raise Refused("not a number, or too many digits: %r" % text[:40])
        exponent = (m[4] or "").lstrip("+-0") or "0"
        if len(exponent) > 5 or int(exponent) > MAX_EXPONENT:
            raise Refused("an exponent is too large: %r" % text[:40])
        power = Fraction(2 if base == 16 else 10) ** (-int(exponent) if m[4] and m[4][0] == "-" else int(exponent))
        value = int(digits, base) * power / base ** len(m[3] or "")
    return -value if m[1] == "-" else value

def typed(value, kind):
    if type(value) is not kind:
        raise Refused("%r where %s belongs" % (str(value)[:40], kind.__name__))
    return value

def whole(value, least, most):
    if not least <= typed(value, int) <= most:
        raise Refused("%d is not within %d to %d" % (value, least, most))
    return value

def members(value, *keys):
    if set(typed(value, dict)) != set(keys):
        raise Refused("keys missing or unknown: %s" % sorted(set(value) ^ set(keys))[:4])
    return [value[key] for key in keys]

def read_model(data, readers=None, others=OTHER_KINDS):
    """The entities: what the reader of its kind makes of each, None for the other kinds."""
    return entities_of(read_json(data), readers or {"surface": read_surface, "triangle": read_triangle}, others)

def short_integer(text):
    if len(text) > 15:
        raise Refused("too large: %s" % text[:20])
    return int(text)

def read_json(data, integer=short_integer):
    """The value that the text has in Python; its numbers are integers, by default of at most 15 characters."""
    def unique(pairs):
        if len(dict(pairs)) != len(pairs):
            raise Refused("a key twice")
        return dict(pairs)

    def no_number(text):
        raise Refused("%s is no string" % text[:20])

    try:
        return json.loads(data[3 if data[:3] == b"\xef\xbb\xbf" else 0:].decode("utf-8"), object_pairs_hook=unique,
                         parse_int=integer, parse_float=no_number, parse_constant=no_number)
    except (ValueError, RecursionError) as e:
        raise Refused("no JSON: %s" % str(e)[:80])

def entities_of(top, readers, others):
    """The entities of a model that is this value."""
    form, groups, entities = members(top, "format", "groups", "entities")
    if form != "veritope-spline-1" or list(top).index("groups") > list(top).index("entities"):
        raise Refused("not veritope-spline-1, or groups behind entities")
    for i, group in enumerate(typed(groups, list)):
        name, parent, attributes = members(group, "name", "parent", "attributes")
        texts([name, *typed(attributes, list)])
        if parent is not None:
            whole(parent, 0, i - 1)
    return [read_entity(entity, len(groups), readers, others) for entity in typed(entities, list)]

def texts(values):
    try:
        for value in values:
            typed(value, str).encode()
    except UnicodeEncodeError:
        raise Refused("half of a surrogate pair")

def not_looked_into(shape):
    """Accepts an entity that is neither surface nor triangle: it must be an object."""
    level = [typed(shape, dict)]
    for _ in range(MAX_NESTED):
        texts([*(value for value in level if type(value) is str),
               *(key for value in level if type(value) is dict for key in value)])
        level = [kid for value in level if type(value) in (dict, list)
                 for kid in (value.values() if type(value) is dict else value)]
    if level:
        raise Refused("nested too deep")

def read_entity(entity, num_groups, readers, others):
    kind, group, attributes, shape = members(entity, "kind", "group", "attributes", "shape")
    texts(typed(attributes, list))
    if group is not None:
        whole(group, 0, num_groups - 1)
    if list(entity).index("kind") > list(entity).index("shape"):
        raise Refused("kind behind shape")
    if typed(kind, str) in others:
        return not_looked_into(shape)
    if kind not in readers:
        raise Refused("an entity of the kind %r" % kind[:40])
    return readers[kind](shape)

def read_points(entity, points, components, rational, num_points):
    """Reads homogeneous points; their number is tested before they are read."""
    whole(components, 1 + typed(rational, bool), 1001)
    entity.rational, entity.dimension = rational, components - rational
    if len(typed(points, list)) != num_points:
        raise Refused("%d points where %d belong" % (len(points), num_points))
    result = []
    for point in points:
        if len(typed(point, list)) != components:
            raise Refused("a point of %d numbers" % len(point))
        result.append([number(c) for c in point] + ([] if rational else [Fraction(1)]))
        if result[-1][-1] <= 0:
            raise Refused("a weight is not positive")
    return result

def read_triangle(shape):
    degree, rational, components, points = members(shape, "degree", "rational", "components", "points")
    n, entity = whole(degree, 1, MAX_FILE_DEGREE), Entity("triangle")
    entity.degrees = (n,)
    flat = read_points(entity, points, components, rational, (n + 1) * (n + 2) // 2)
    entity.rows = [flat[r * (r + 1) // 2:(r + 1) * (r + 2) // 2] for r in range(n + 1)]
    return entity

def axis_size(p, t):
    """The number of control points of an axis of degree p with the knots t."""
    n = len(t) - p - 1
    if n <= p or any(a > b for a, b in zip(t, t[1:])) or t[p] >= t[n] or any(a == b for a, b in zip(t, t[p + 1:])):
        raise Refused("the knots are too few, decrease, are too often the same or have no domain")
    return n

def read_map(shape, kind, num_axes):
    """(entity without control points, periodic axes, sizes, control points with the last axis fastest)"""
    degrees, periodic, knots, rational, components, points = members(
        shape, "degrees", "periodic", "knots", "rational", "components", "points")
    if not len(typed(degrees, list)) == len(typed(periodic, list)) == len(typed(knots, list)) == num_axes:
        raise Refused("a %s has %d axes" % (kind, num_axes))
    entity = Entity(kind)
    entity.degrees = tuple(whole(p, 1, MAX_FILE_DEGREE) for p in degrees)
    entity.knots = [[number(t) for t in typed(axis, list)] for axis in knots]
    sizes = [axis_size(p, t) for p, t in zip(entity.degrees, entity.knots)]
    return entity, periodic, sizes, read_points(entity, points, components, rational, prod(sizes))

def read_surface(shape):
    entity, periodic, sizes, flat = read_map(shape, "surface", 2)
    entity.rows = [flat[i * sizes[1]:(i + 1) * sizes[1]] for i in range(sizes[0])]
    for axis, is_periodic in enumerate(periodic):
        p, t, n = entity.degrees[axis], entity.knots[axis], sizes[axis]
        lines = entity.rows if axis == 0 else list(zip(*entity.rows))
        if typed(is_periodic, bool) and (list(lines[:p]) != list(lines[n - p:]) or
                                         any(t[i] + t[n] - t[p] != t[i + n - p] for i in range(2 * p + 1))):
            raise Refused("an axis that is said to be periodic is not")
    return entity


# ---------------------------------------------------------------- section 2: the body

class Body:
    """A cursor over the body; running out of bytes is B1."""

    def __init__(self, data):
        self.data, self.pos = data, 0

    def left(self):
        return len(self.data) - self.pos

    def bytes(self, n):
        if n > self.left():
            raise Reject("B1", "the body ends too early")
        self.pos += n
        return self.data[self.pos - n:self.pos]

    def u8(self, most=255):
        value = self.bytes(1)[0]
        if value > most:
            raise Reject("B1", "a byte is %d, at most %d belongs there" % (value, most))
        return value

    def count(self, least_size):
        n = int.from_bytes(self.bytes(4), "little")
        if n * least_size > self.left():
            raise Reject("B1", "a count is larger than the body")
        return n

    def end(self):
        if self.left():
            raise Reject("B1", "bytes after the end of the body")

    def varint(self, limit=1 << 63):
        value = shift = 0
        while shift < 70:
            byte = self.u8()
            value |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                if value >= limit or byte == 0 and shift > 7:
                    break
                return value
        raise Reject("B1", "a varint is too large or not in shortest form")

    def zigzag(self):
        return unzigzag(self.varint((1 << 64) - 1))

    def shift(self):
        s = self.varint()
        if s > MAX_SHIFT:
            raise Reject("B1", "a shift of %d" % s)
        return s

    def rational(self):
        p, q = self.zigzag(), self.varint()
        if q == 0:
            long_p = self.bytes(self.varint(MAX_LONG + 2))
            long_q = self.bytes(self.varint(MAX_LONG + 1))
            if p or len(long_p) < 2 or long_p[0] > 1 or not long_p[-1] or not long_q or not long_q[-1]:
                raise Reject("B1", "a long rational is not as the page says")
            p, q = (1 - 2 * long_p[0]) * int.from_bytes(long_p[1:], "little"), int.from_bytes(long_q, "little")
            if max(abs(p), q) < 1 << 63:
                raise Reject("B1", "a short rational in the long form")
        if gcd(p, q) != 1:
            raise Reject("B1", "a rational is not in lowest terms")
        return Fraction(p, q)

def unzigzag(code):
    return -(code + 1 >> 1) if code & 1 else code >> 1

class Box:
    """kind 0 star, 1 mesh; lo, hi: corners; c: (c-, c+) of a star box."""
    frame, is_shared = None, False      # version 2 has boxes in frames, and boxes that components share

    def __init__(self, body):
        self.kind, shift = body.u8(1), body.shift()
        lo = [body.zigzag() for _ in range(3)]
        size = [body.varint() for _ in range(3)]
        centres = [[body.varint() for _ in range(3)] for _ in range(0 if self.kind else 2)]
        if not all(size) or any(not 0 < o < s for c in centres for o, s in zip(c, size)):
            raise Reject("B1", "a box is empty, or a centre is not inside")
        self.lo, self.hi = [x << shift for x in lo], [x + s << shift for x, s in zip(lo, size)]
        self.c = [[x + o << shift for x, o in zip(lo, c)] for c in centres]
        self.component = None           # of the leaves that name it

def read_head(body, magic, entities):
    """Reads the magic and the number of entities."""
    if body.bytes(4) != magic or body.count(1) != len(entities):
        raise Reject("B1", "magic, or another number of entities")
    if not entities:
        raise Reject("B1", "a model without entities bounds nothing")

def read_all_breaks(body, entities):
    return [read_breaks(body, e) if e and e.kind == "surface" else None for e in entities]

def read_entities(body, magic, entities):
    """(flags, breaks) after the magic and the number of entities."""
    read_head(body, magic, entities)
    flags = [body.u8(1) for _ in entities]
    return flags, read_all_breaks(body, entities)

class Certificate:
    """Reads the body for these entities: B1."""

    def __init__(self, magic, data, entities):
        body = Body(data)
        self.flags, self.breaks = self.read_entities(body, magic, entities)
        cells = [1 if e.kind == "triangle" else (len(b[0]) - 1) * (len(b[1]) - 1) if e else 0
                 for e, b in zip(entities, self.breaks) if e]
        if 3 * sum(cells) > body.left():
            raise Reject("B1", "more patches than the body has room for")
        tensor = [e.kind == "surface" for e, n in zip([e for e in entities if e], cells) for _ in range(n)]
        self.roots = [[body.u8(12 * is_tensor), body.u8(12 * is_tensor)] for is_tensor in tensor]
        self.unit = body.zigzag()
        if abs(self.unit) > MAX_SHIFT:
            raise Reject("B1", "a unit of 2^%d" % self.unit)
        self.boxes = self.read_boxes(body)
        self.last = 0
        if sum(1 << a + b for a, b in self.roots) > body.left():
            raise Reject("B1", "more roots than the body has room for")
        self.trees = [[self.tree(body) for _ in range(1 << a + b)] for a, b in self.roots]
        self.walks = [self.walk(body) for _ in range(body.count(7))]
        self.read_rest(body)
        body.end()

    read_entities = staticmethod(read_entities)

    def read_boxes(self, body):
        return [Box(body) for _ in range(body.count(8))]

    def read_rest(self, body):
        """Reads what other claims have after the walks."""

    def tree(self, body):
        """Reads a tree in preorder: None for a node with children, else the leaf's box."""
        tree, levels = [], [0]
        while levels:
            level, code = levels.pop(), body.varint()
            if code:
                self.last += unzigzag(code - 1)
                if not 0 <= self.last < len(self.boxes):
                    raise Reject("B1", "box %d does not exist" % self.last)
            elif level == MAX_DEPTH:
                raise Reject("B1", "a tree is too deep")
            else:
                levels += [level + 1] * 4
            tree.append(self.last if code else None)
        return tree

    def end_of_walk(self, body):
        box, sign = body.varint(), body.u8(1)
        if box >= len(self.boxes):
            raise Reject("B1", "box %d does not exist" % box)
        return box, sign

    def walk(self, body):
        """Reads a walk: (start, points, None or the box at which it ends, the direction to infinity)."""
        return (self.end_of_walk(body), *self.way(body))

    def way(self, body):
        """Reads a walk without its start."""
        points = []
        for _ in range(body.count(4)):
            shift = body.shift()
            points.append([body.zigzag() << shift for _ in range(3)])
        direction = body.u8(6)
        return points, self.end_of_walk(body) if direction == 6 else None, direction

def read_breaks(body, entity):
    result = []
    for p, knots in zip(entity.degrees, entity.knots):
        breaks = [body.rational() for _ in range(body.count(2))]
        first, last = knots[p], knots[-p - 1]
        if (len(breaks) < 2 or any(a >= b for a, b in zip(breaks, breaks[1:]))
            or [breaks[0], breaks[-1]] != [first, last] or
                not {t for t in knots if first <= t <= last} <= set(breaks)):
            raise Reject("B1", "breaks do not ascend, lack a knot or are not those of the domain")
        result.append(breaks)
    return result
