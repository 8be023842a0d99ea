# SPDX-License-Identifier: LGPL-3.0-or-later
"""The filter's constants: docs/bounds/README.md, sections 2 to 5, over fractions. The generated C++ test derives them
again."""
import math
from fractions import Fraction

from .expression import polynomial_of, post_order

U = Fraction(1, 2**53)
UNITS = (Fraction(1, 2**1075), Fraction(1, 2**1022))  # of an underflowing product: gradual, flushed
FLOOR = -900  # kFilterFloor of robust/base/fp_state.h is 2^FLOOR; so is kEta


class BoundError(Exception):
    pass


def roundings(root):
    """{id(node): the most factors (1 + d) that a monomial of the computed value carries}"""
    count = {}
    for node in post_order([root]):
        if node.is_leaf:
            count[id(node)] = 0 if node.kind == "input" else 1
        elif node.kind == "integer":
            count[id(node)] = 0
        else:
            args = [count[id(a)] for a in node.args]
            own = 2 * args[0] if node.kind == "sqr" else sum(args) if node.kind == "*" else max(args)
            count[id(node)] = own + 1
    return count


def round_up(value):
    """The least binary64 number that is not less than value, as a float. REQUIRES a normal result."""
    exponent = math.floor(math.log2(value)) - 54
    while value / Fraction(2) ** exponent >= 2**53:
        exponent += 1
    return math.ldexp(math.ceil(value / Fraction(2) ** exponent), exponent)


def derived_rel(k, k_magnitude):
    return ((1 + U) ** k - 1) * (1 + U) / (1 - U) ** (k_magnitude + 2)


class Series:
    """A polynomial in m, the largest leaf: coefficients by degree."""

    def __init__(self, coefficients=()):
        self.c = list(coefficients)

    def __add__(self, other):
        n = max(len(self.c), len(other.c))
        return Series((self.at(i) + other.at(i)) for i in range(n))

    def __mul__(self, other):
        if isinstance(other, Fraction):
            return Series(other * c for c in self.c)
        r = [Fraction(0)] * max(len(self.c) + len(other.c) - 1, 0)
        for i, a in enumerate(self.c):
            for j, b in enumerate(other.c):
                r[i + j] += a * b
        return Series(r)

    def at(self, i):
        return self.c[i] if i < len(self.c) else Fraction(0)

    def degree(self):
        return max((i for i, c in enumerate(self.c) if c != 0), default=0)


def underflow(root, unit):
    """A bound of the part of the computed value's error that underflow causes."""
    size, error, grow = {}, {}, 1 + U
    for node in post_order([root]):
        key = id(node)
        if node.is_leaf:
            size[key], error[key] = Series([Fraction(0), Fraction(1)]), Series()
        elif node.kind == "integer":
            size[key], error[key] = Series([Fraction(node.value)]), Series()
        elif node.kind in "+-":
            a, b = map(id, node.args)
            size[key], error[key] = (size[a] + size[b]) * grow, (error[a] + error[b]) * grow
        else:
            a, b = id(node.args[0]), id(node.args[-1])
            size[key] = size[a] * size[b] * grow
            error[key] = (size[a] * error[b] + size[b] * error[a] + error[a] * error[b]) * grow + Series([unit])
    return error[id(root)]


def lost_in_size(degree, unit):
    """A bound of the error that underflow causes in m^degree, computed from left to right."""
    size, error = Series([Fraction(0), Fraction(1)]), Series()
    for _ in range(degree - 1):
        error = (Series([Fraction(0), Fraction(1)]) * error) * (1 + U) + Series([unit])
        size = size * Series([Fraction(0), Fraction(1)]) * (1 + U)
    return error


class Bound:
    """k, k_magnitude: roundings of the determinant without its last addition, and of S; rel: kRel; degree: of the
    underflow's error in the largest leaf, 0 if kFilterFloor alone pays; else kEta = 2^FLOOR times the power of the
    largest leaf does, too."""

    def __init__(self, formula):
        root = formula.sign
        count = roundings(root)
        self.k_magnitude = count[id(root)]
        self.k = self.k_magnitude - (1 if root.is_sum else 0)
        self.rel = round_up(derived_rel(self.k, self.k_magnitude))
        errors = [(underflow(root, unit), unit) for unit in UNITS]
        self.degree = max(error.degree() for error, _ in errors)
        if not all(self.pays(error, unit) for error, unit in errors):
            raise BoundError(f"degree {polynomial_of(root).degree()} is too high: 2^{FLOOR} does not pay for underflow")

    def pays(self, error, unit):
        """With m^j <= 1 + m^degree; error stands for what S lost, too: its terms are those of the determinant."""
        less, rel = 1 - Fraction(1, 2**48), Fraction(self.rel)
        total = sum(error.c, Fraction(0)) * (1 + rel)
        if self.degree:
            eta = Fraction(2) ** FLOOR
            total += eta * sum(lost_in_size(self.degree, unit).c, Fraction(0))
            if total > eta * less:
                return False
        return total + 4 * unit <= Fraction(2) ** FLOOR * less
