# SPDX-License-Identifier: LGPL-3.0-or-later
"""Expressions over the inputs of a predicate: a graph without duplicates, and the polynomials that its nodes
represent."""


class Node:
    """kind: "input" (name), "integer" (value), "+", "-", "*", "sqr" (args). Equal expressions are one object: see
    Graph."""

    def __init__(self, kind, args=(), name="", value=0):
        self.kind, self.args, self.name, self.value = kind, args, name, value

    @property
    def is_leaf(self):
        """Whether it is an input, or the difference of two: such a node is rounded once at most, and never
        underflows."""
        return self.kind == "input" or (self.kind == "-" and all(a.kind == "input" for a in self.args))

    @property
    def is_sum(self):
        return self.kind in "+-" and not self.is_leaf

    def __str__(self):
        if self.kind == "input":
            return self.name
        if self.kind == "integer":
            return str(self.value)
        if self.kind == "sqr":
            return f"sqr({self.args[0]})"
        texts = [f"({a})" if a.kind in "+-" else str(a) for a in self.args]
        return f" {self.kind} ".join(texts)


class Graph:
    def __init__(self):
        self.nodes = {}

    def make(self, kind, *args, name="", value=0):
        key = (kind, name, value, *map(id, args))
        if key not in self.nodes:
            self.nodes[key] = Node(kind, args, name, value)
        return self.nodes[key]


def post_order(roots):
    """Every node below the roots once, arguments first; leaves are not entered."""
    seen, order, todo = set(), [], [(node, False) for node in reversed(roots)]
    while todo:
        node, opened = todo.pop()
        if opened:
            order.append(node)
        elif id(node) not in seen:
            seen.add(id(node))
            todo.append((node, True))
            if not node.is_leaf:
                todo += [(a, False) for a in reversed(node.args)]
    return order


def leaves_of(root):
    return [node for node in post_order([root]) if node.is_leaf]


MOST_PRODUCTS = 1_000_000  # of terms, when a product is written out: half a minute or so


class TooLarge(Exception):
    """The polynomial has too many terms for a proof."""


class Polynomial:
    """Integer coefficients by monomial: a sorted tuple of (input, exponent)."""

    def __init__(self, terms=None):
        self.terms = {m: c for m, c in (terms or {}).items() if c != 0}

    def combine(self, other, factor):
        terms = dict(self.terms)
        for monomial, c in other.terms.items():
            terms[monomial] = terms.get(monomial, 0) + factor * c
        return Polynomial(terms)

    def times(self, other):
        if len(self.terms) * len(other.terms) > MOST_PRODUCTS:
            raise TooLarge(f"a product of {len(self.terms)} and {len(other.terms)} terms when written out; at most "
                           f"{MOST_PRODUCTS} products of terms")
        terms = {}
        for m, c in self.terms.items():
            for n, d in other.terms.items():
                powers = dict(m)
                for name, e in n:
                    powers[name] = powers.get(name, 0) + e
                key = tuple(sorted(powers.items()))
                terms[key] = terms.get(key, 0) + c * d
        return Polynomial(terms)

    def degree(self):
        return max((sum(e for _, e in m) for m in self.terms), default=0)


def polynomial_of(root, rename=None, values=None):
    """The polynomial in the inputs. rename maps inputs to inputs; values maps them to polynomials."""
    found = {}

    def value(node):
        if node.kind == "input":
            if values and node.name in values:
                return values[node.name]
            return Polynomial({(((rename or {}).get(node.name, node.name), 1),): 1})
        if node.kind == "integer":
            return Polynomial({(): node.value})
        args = [found[id(a)] if id(a) in found else value(a) for a in node.args]
        if node.kind == "sqr":
            return args[0].times(args[0])
        if node.kind == "*":
            return args[0].times(args[1])
        return args[0].combine(args[1], 1 if node.kind == "+" else -1)

    for node in post_order([root]):
        found[id(node)] = value(node)
    return found[id(root)]


def value_modulo(root, values, modulus):
    """The value at integers {input: value}."""
    found = {}

    def value(node):
        if node.kind in ("input", "integer"):
            return values.get(node.name, node.value)
        args = [found[id(a)] if id(a) in found else value(a) for a in node.args]
        a, b = args[0], args[-1]
        return (a + b if node.kind == "+" else a - b if node.kind == "-" else a * b) % modulus

    for node in post_order([root]):
        found[id(node)] = value(node)
    return found[id(root)]
