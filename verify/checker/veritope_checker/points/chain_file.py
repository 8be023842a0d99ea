# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Chain files (docs/formats/chain-files.md) and the files that they name: docs/certificates/points.md, section 7."""
import hashlib
import json
import re

from ..common.errors import Refused, Reject
from ..patches.star_box_read import members, number, texts, typed

MESHES, SPLINES = ("stl", "obj", "ply", "off"), ("vjson", "itd", "g2", "mfem")
MOST_OPERANDS, MOST_OPERATORS, MOST_NESTED = 10000, 100000, 1000
NAME, HASH = re.compile(r"[A-Za-z_][A-Za-z0-9_]*"), re.compile(r"[0-9a-f]{64}")
TOKEN = re.compile(r"[ \t\r\n]*(?:([A-Za-z_][A-Za-z0-9_]*)|([()!&|+-])|\Z)")
STRENGTH = {"(": 0, "|": 1, "+": 1, "-": 1, "&": 2, "!": 3}

class Node:
    """A leaf (op None) has a variable; the others have two parts, of which `op` says what becomes: "|", "&" or "-"."""

    def __init__(self, op, left, right=None):
        self.op, self.left, self.right = op, left, right

class Solid:
    """A file that is no chain file."""

    def __init__(self, data, form):
        self.data, self.form, self.is_mesh = data, form, form in MESHES

class Box:
    def __init__(self, lo, hi):
        self.lo, self.hi = lo, hi

class Meaning:
    """What a file stands for: a solid or an expression.  box: of a chain file.  leaves, operators: how many."""

    def __init__(self, node, leaves, operators, solid=None, box=None):
        self.node, self.leaves, self.operators, self.solid, self.box = node, leaves, operators, solid, box

def parse_file(data):
    """(text of the expression, operands by name, box)"""
    def unique(pairs):
        if len(dict(pairs)) != len(pairs):
            raise Refused("a key twice")
        return dict(pairs)

    def no_number(text):
        raise Refused("%s is no string" % text[:20])

    try:
        top = json.loads(data[3 if data[:3] == b"\xef\xbb\xbf" else 0:].decode("utf-8"), object_pairs_hook=unique,
                         parse_int=no_number, parse_float=no_number, parse_constant=no_number)
    except (ValueError, RecursionError) as e:
        raise Refused("no JSON: %s" % str(e)[:80])
    schema, tool, text, operands, bounds, boundary = members(
        top, "schema", "tool", "expression", "operands", "box", "boundary")
    texts([schema, tool, text, boundary])
    if schema != "veritope-chain-1" or boundary != "not certified":
        raise Refused("no chain file of version 1")
    found = {}
    for operand in typed(operands, list):
        name, path, sha, form = texts_of(members(operand, "name", "path", "sha256", "format"))
        if not (NAME.fullmatch(name) and HASH.fullmatch(sha) and path and "\0" not in path and
                form in (*MESHES, *SPLINES, "chain")):
            raise Refused("an operand is not as it should be: %r" % name[:40])
        if name in found:
            raise Refused("two operands have the name %s" % name[:40])
        found[name] = path, sha, form
    sides = [number(text) for text in texts_of(typed(bounds, list))]
    if len(sides) != 6 or any(a >= b for a, b in zip(sides, sides[3:])):
        raise Refused("the box does not have six bounds, or no interior")
    return text, found, Box(sides[:3], sides[3:])

def texts_of(values):
    texts(values)
    return values

class Parser:
    """Operators wait until one follows that does not come first.  apply(op, parts) makes the value of an operator,
    leaf(name) that of a name."""

    def __init__(self, leaf, apply):
        self.leaf, self.apply, self.waiting, self.values, self.counts = leaf, apply, [], [], [0, 0]

    def count(self, kind, most):
        self.counts[kind] += 1
        if self.counts[kind] > most:
            raise Refused("the expression is too long")

    def reduce(self):
        self.count(1, MOST_OPERATORS)
        op = self.waiting.pop()
        parts = [self.values.pop() for _ in range(1 if op == "!" else 2)][::-1]
        self.values.append(self.apply(op, parts))

    def reduce_while(self, strength):
        while self.waiting and STRENGTH[self.waiting[-1]] >= strength:
            self.reduce()

    def parse(self, text):
        at, needs_operand = 0, True
        while True:
            m = TOKEN.match(text, at)
            if not m:
                raise Refused("the expression has an unknown character")
            at, (name, symbol) = m.end(), m.groups()
            if not name and not symbol:
                break
            if needs_operand != bool(name or symbol in "(!"):
                raise Refused("the expression lacks an operand or an operator")
            if name:
                self.count(0, MOST_OPERANDS)
                self.values.append(self.leaf(name))
                needs_operand = False
            elif symbol in "(!":
                self.waiting.append(symbol)
            elif symbol == ")":
                self.reduce_while(1)
                if not self.waiting:
                    raise Refused("a parenthesis was not opened")
                self.waiting.pop()
            else:
                self.reduce_while(STRENGTH[symbol])
                self.waiting.append(symbol)
                needs_operand = True
        if needs_operand or "(" in self.waiting:
            raise Refused("the expression ends too early")
        self.reduce_while(1)
        return self.values.pop()

class Expression:
    """solids: in the order in which their files are read.  variables: solids and boxes.  inside: pairs of a box and
    what has to lie in its interior, a box or a solid.  root: the node of the whole expression."""

    def __init__(self, data, name, read, skip):
        self.solids, self.inside = [], []
        self.read, self.skip, self.known, self.boxes = read, skip, {}, {}
        whole = self.load(data, name)
        self.root, self.leaves = whole.node, whole.leaves

    def load(self, data, name):
        """What the chain file means.  An explicit stack: files may be nested deeply."""
        stack, result = [self.chain(data, name)], None
        while stack:
            try:
                found = stack[-1].send(result)
            except StopIteration as e:
                stack.pop()
                result = e.value
                continue
            if len(stack) == MOST_NESTED:
                raise Refused("more than %d chain files in each other" % MOST_NESTED)
            stack.append(self.chain(*found))
            result = None
        return result

    def chain(self, data, name):
        """A coroutine: yields (bytes, name) of a chain file in this one, and receives what that means."""
        text, operands, box = parse_file(data)
        names = []
        Parser(names.append, lambda op, parts: None).parse(text)
        names = list(dict.fromkeys(names))
        if set(names) != set(operands):
            raise Refused("other operands than those in the expression")
        means = {}
        for operand in names:
            path, sha, form = operands[operand]
            if (sha, form) not in self.known:
                where = path if path.startswith("/") else name[:name.rfind("/") + 1] + path
                content = self.read(where)
                if "O1" not in self.skip and hashlib.sha256(content).hexdigest() != sha:
                    raise Reject("O1", "the file of the operand %s has another hash" % operand)
                self.known[sha, form] = (yield content, where) if form == "chain" else self.solid(content, form)
            means[operand] = self.known[sha, form]
        for operand in names:
            inner = means[operand]
            self.inside.append((box, inner.solid if inner.box is None else inner.box, operand))
        whole = Parser(means.__getitem__, lambda op, parts: self.joined(op, parts, box)).parse(text)
        if whole.leaves > MOST_OPERANDS or whole.operators > MOST_OPERATORS:
            raise Refused("the expression is too long with those in it")
        return Meaning(whole.node, whole.leaves, whole.operators, box=box)

    def solid(self, content, form):
        solid = Solid(content, form)
        self.solids.append(solid)
        return Meaning(Node(None, solid), 1, 0, solid=solid)

    def joined(self, op, parts, box):
        leaves, operators = sum(p.leaves for p in parts), sum(p.operators for p in parts) + 1
        if op == "!":                                       # the box without the operand
            key = tuple(box.lo + box.hi)
            return Meaning(Node("-", Node(None, self.boxes.setdefault(key, box)), parts[0].node), leaves, operators)
        return Meaning(Node("|" if op == "+" else op, parts[0].node, parts[1].node), leaves, operators)

def evaluate(root, value_of, is_all, joined):
    """The value of the expression.  Parts are taken from the left to the right; a union whose left part is 1, another
    operator whose left part is 0, needs no right part."""
    stack, last = [[root, None]], None
    while stack:
        frame = stack[-1]
        node, begun = frame[0], len(frame) - 2
        if node.op is None:
            last = value_of(node.left)
        elif begun == 0:
            frame.append(None)
            stack.append([node.left, None])
            continue
        elif begun == 1 and not is_all(last, node.op == "|"):
            frame[1] = last
            frame.append(None)
            stack.append([node.right, None])
            continue
        elif begun == 2:
            last = joined(node.op, frame[1], last)
        stack.pop()
    return last
