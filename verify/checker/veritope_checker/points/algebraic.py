# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Parameters of kind 1: docs/certificates/points.md, section 6.  A polynomial is the list of its coefficients, the
constant one first."""
from fractions import Fraction
from math import comb

from ..common.errors import Reject

MAX_DEGREE = 64

def polynomial(body):
    return [body.rational() for _ in range(body.u8(MAX_DEGREE) + 1)]

def value(p, t):
    total = Fraction(0)
    for c in reversed(p):
        total = total * t + c
    return total

def difference(p, q):
    n = max(len(p), len(q))
    p, q = [r + [Fraction(0)] * (n - len(r)) for r in (p, q)]
    return [a - b for a, b in zip(p, q)]

def bernstein(p, a, b):
    """The coefficients on [a, b] in the degree of the list."""
    n, moved = len(p) - 1, []
    for c in reversed(p):                                   # Horner's scheme at a + (b - a) x
        moved = [a * x + (b - a) * y for x, y in zip(moved + [Fraction(0)], [Fraction(0)] + moved)]
        moved[0] += c
    moved = moved[:n + 1]
    return [sum(Fraction(comb(i, k), comb(n, k)) * moved[k] for k in range(i + 1)) for i in range(n + 1)]

class Algebraic:
    """U(t), V(t) at a root t of the modulus in [a, b].  size: the greatest degree plus 1.  bits: of the longest
    number."""

    def __init__(self, body):
        self.modulus = polynomial(body)
        self.a, self.b = body.rational(), body.rational()
        self.u, self.v = polynomial(body), polynomial(body)
        if len(self.modulus) < 2 or not self.modulus[-1] or self.a >= self.b:
            raise Reject("B1", "parameters of kind 1 without a polynomial or an interval")
        self.size = max(len(self.modulus), len(self.u), len(self.v))
        self.bits = max(abs(n).bit_length() for c in (*self.modulus, *self.u, *self.v, self.a, self.b)
                        for n in (c.numerator, c.denominator))

    def not_on(self, grid, point):
        """Why P2 does not hold."""
        if value(self.modulus, self.a) * value(self.modulus, self.b) >= 0:
            return "no root of the polynomial is shown"
        if min(self.distances(grid.is_tensor)) < 0:
            return "the parameters may leave the domain"
        for k, n in enumerate(point.n):
            if any(self.at_parameters(grid, lambda c, k=k, n=n: point.d * c[k] - n * c[3])):
                return "another point at the parameters"

    def distances(self, is_tensor):
        """The Bernstein coefficients of what is >= 0 in the domain."""
        one = [Fraction(1)]
        rest = difference(one, self.u)
        others = [rest, difference(one, self.v)] if is_tensor else [difference(rest, self.v)]
        return [c for p in (self.u, self.v, *others) for c in bernstein(p, self.a, self.b)]

    def at_parameters(self, grid, component):
        """A component of R at the parameters, modulo the polynomial."""
        p, q = grid.degrees
        u, rest = self.reduced(self.u), self.reduced(difference([Fraction(1)], self.u))
        v = self.reduced(self.v)
        total = [Fraction(0)] * (len(self.modulus) - 1)
        if grid.is_tensor:
            along_u = self.products(rest, u, p)
            along_v = self.products(self.reduced(difference([Fraction(1)], self.v)), v, q)
            for i, row in enumerate(grid.rows):
                inner = combination([(comb(q, j) * component(c), f) for j, (c, f) in enumerate(zip(row, along_v))])
                total = added(total, self.times(inner, along_u[i]), comb(p, i))
            return total
        powers = self.powers(self.reduced(difference(rest, self.v)), p)
        points = [list(zip(*rows)) for rows in zip(*grid.triangle)]
        for r, row in enumerate(points):
            along = self.products(u, v, r)
            inner = combination([(comb(r, k) * component(c), f) for k, (c, f) in enumerate(zip(row, along))])
            total = added(total, self.times(inner, powers[p - r]), comb(p, r))
        return total

    def powers(self, f, n):
        result = [self.reduced([Fraction(1)])]
        for _ in range(n):
            result.append(self.times(result[-1], f))
        return result

    def products(self, f, g, n):
        """f^(n - i) g^i for all i."""
        return [self.times(x, y) for x, y in zip(reversed(self.powers(f, n)), self.powers(g, n))]

    def times(self, f, g):
        product = [Fraction(0)] * (len(f) + len(g))
        for i, x in enumerate(f):
            for j, y in enumerate(g):
                product[i + j] += x * y
        return self.reduced(product)

    def reduced(self, f):
        """Modulo the polynomial: as many coefficients as its degree."""
        n, f = len(self.modulus) - 1, list(f)
        while len(f) > n:
            factor = f.pop() / self.modulus[-1]
            for i in range(n):
                f[len(f) - n + i] -= factor * self.modulus[i]
        return f + [Fraction(0)] * (n - len(f))

def combination(terms):
    total = [Fraction(0)] * len(terms[0][1])
    for factor, f in terms:
        total = added(total, f, factor)
    return total

def added(f, g, factor):
    return [x + factor * y for x, y in zip(f, g)]
