# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Polynomials over [0, 1] in powers and in Bernstein form, with integers in the place of long fractions."""
from fractions import Fraction
from math import comb, lcm

def bernstein(a):
    """Integers: the Bernstein coefficients of sum a_r t^r over [0, 1], times factor_of(their degree)."""
    d = len(a) - 1
    b = [factor_of(d) // comb(d, r) * x for r, x in enumerate(a)]
    for r in range(1, d + 1):                               # adds one to the i of C(i, r)
        b[r:] = [x + y for x, y in zip(b[r - 1:], b[r:])]
    return b

def factor_of(d):
    return lcm(*[comb(d, r) for r in range(d + 1)])

def scaled(values):
    """(integers, factor): the values times their least common denominator."""
    common = lcm(*[x.denominator for x in values])
    return [x.numerator * (common // x.denominator) for x in values], common

def degree_of(values):
    """The degree of the polynomial with these Bernstein coefficients; 0 for one that is 0."""
    differences, degree = scaled(values)[0], 0
    for k in range(len(values)):
        degree = k if differences[0] else degree
        differences = [b - a for a, b in zip(differences, differences[1:])]
    return degree

def has_full_degree(values):
    """Whether the degree cannot be lowered: an alternating sum is not 0."""
    p = len(values) - 1
    return sum((-1) ** i * comb(p, i) * x for i, x in enumerate(scaled(values)[0])) != 0

def lowered(values, degree):
    """The Bernstein coefficients of the same polynomial in a lower degree that it has."""
    (differences, common), p, powers = scaled(values), len(values) - 1, []
    for k in range(degree + 1):
        powers.append(comb(p, k) * differences[0])
        differences = [b - a for a, b in zip(differences, differences[1:])]
    return [Fraction(x, common * factor_of(degree)) for x in bernstein(powers)]
