# SPDX-License-Identifier: LGPL-3.0-or-later
"""The expressions of a formula file: nodes of a graph, vectors as lists of them."""
import re

TOKEN = re.compile(r"\s*(?:(?P<name>[A-Za-z]\w*(?:\.\w+)?)|(?P<number>\d+)|(?P<sign>[-+*/(),=^])|(?P<other>\S))")
AXES = "xyz"


class ExpressionParser:
    """One line NAME = EXPRESSION. values: what is defined; report(message, column) does not return."""

    def __init__(self, line, graph, values, report):
        self.graph, self.values, self.report = graph, values, report
        self.tokens = [(match, match.start(match.lastgroup) + 1) for match in TOKEN.finditer(line) if match.lastgroup]
        self.end, self.at, self.column = len(line) + 1, 0, 1

    def fail(self, message, column=None):
        self.report(message, column or self.column)

    def begin(self):
        """The name that is defined, and its column."""
        name = self.take("name", "a definition NAME = EXPRESSION")
        column = self.column
        self.take_sign("=")
        return name, column

    def whole(self):
        value = self.sum()
        if self.at < len(self.tokens):
            self.unexpected("an operation or the end of the line")
        return value

    def peek(self):
        if self.at < len(self.tokens):
            match, self.column = self.tokens[self.at]
            return match.lastgroup, match[match.lastgroup]
        self.column = self.end
        return None, None

    def unexpected(self, wanted):
        _, text = self.peek()
        self.fail(f"{wanted} expected, but there is " + (repr(text) if text else "the end of the line"))

    def take(self, kind, wanted):
        found, text = self.peek()
        if found != kind:
            self.unexpected(wanted)
        self.at += 1
        return text

    def take_sign(self, text):
        if self.peek() != ("sign", text):
            self.unexpected(repr(text))
        self.at += 1

    def sum(self):
        value = self.product()
        while self.peek() in (("sign", "+"), ("sign", "-")):
            column, kind = self.column, self.tokens[self.at][0]["sign"]
            self.at += 1
            value = self.both(kind, value, self.product(), column)
        return value

    def product(self):
        value = self.factor()
        while self.peek() in (("sign", "*"), ("sign", "/"), ("sign", "^")):
            column, kind = self.column, self.tokens[self.at][0]["sign"]
            if kind != "*":
                self.fail("polynomials have no division" if kind == "/" else "write sqr(x), or x * x, for powers")
            self.at += 1
            value = self.both(kind, value, self.factor(), column)
        return value

    def both(self, kind, a, b, column):
        if isinstance(a, list) != isinstance(b, list) or (isinstance(a, list) and (kind == "*" or len(a) != len(b))):
            self.fail(f"{kind!r} does not go with these: vectors of one dimension can be added and subtracted; see "
                      f"also dot and cross", column)
        if isinstance(a, list):
            return [self.make(kind, x, y, column) for x, y in zip(a, b)]
        return self.make(kind, a, b, column)

    def make(self, kind, a, b, column):
        if "integer" in (a.kind, b.kind) and (kind != "*" or a.kind == b.kind):
            self.fail("a number may only be multiplied with something that is computed", column)
        if b.kind == "integer":
            a, b = b, a
        if kind == "-" and a is b:
            self.fail("a difference of equal things", column)
        return self.graph.make(kind, a, b)

    def factor(self):
        kind, text = self.peek()
        column = self.column
        if kind == "number":
            self.at += 1
            if len(text) > 7 or not text.isascii() or not 1 <= int(text) <= 1 << 20:
                self.fail("a number is 1 to 1048576", column)
            return self.graph.make("integer", value=int(text))
        if (kind, text) == ("sign", "("):
            self.at += 1
            value = self.sum()
            self.take_sign(")")
            return value
        if (kind, text) == ("sign", "-"):
            self.fail("there is no sign in front of a factor: write y - x, or turn a difference round")
        name = self.take("name", "a name, a number or '('")
        if self.peek() == ("sign", "("):
            return self.call(name, column)
        return self.named(name, column)

    def named(self, name, column):
        base, _, axis = name.partition(".")
        if base not in self.values:
            self.fail(f"{base!r} is not defined", column)
        value = self.values[base]
        if not axis:
            return value
        if not isinstance(value, list) or axis not in AXES[:len(value)]:
            self.fail(f"{base!r} has no coordinate {axis!r}", column)
        return value[AXES.index(axis)]

    def call(self, name, column):
        self.take_sign("(")
        args = [self.sum()]
        while self.peek() == ("sign", ","):
            self.at += 1
            args.append(self.sum())
        self.take_sign(")")
        shape = (name, *(len(a) if isinstance(a, list) else 0 for a in args))
        mul, g = self.both, self.graph
        if shape == ("sqr", 0):
            if args[0].kind == "integer":
                self.fail("a number may only be multiplied with something that is computed", column)
            return g.make("sqr", args[0])
        if shape in (("norm2", 2), ("norm2", 3), ("dot", 2, 2), ("dot", 3, 3)):
            squares = [g.make("sqr", a) if name == "norm2" else mul("*", a, b, column)
                       for a, b in zip(args[0], args[-1])]
            total = squares[0]
            for square in squares[1:]:
                total = g.make("+", total, square)
            return total
        if shape in (("cross", 2, 2), ("cross", 3, 3)):
            a, b = args
            rows = [(0, 1)] if len(a) == 2 else [(1, 2), (2, 0), (0, 1)]
            r = [self.make("-", mul("*", a[i], b[j], column), mul("*", a[j], b[i], column), column) for i, j in rows]
            return r if len(r) == 3 else r[0]
        return self.fail(f"no function {name} of such arguments: sqr(number), norm2(vector), dot(vector, vector), "
                         f"cross(vector, vector)", column)
