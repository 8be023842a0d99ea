# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Models in GoTools' .g2: docs/certificates/reading-rule-g2.md, section 2."""
from fractions import Fraction
from math import prod

from .model_maps import map_of, sizes_of
from .model_tokens import Tokens

SURFACE, VOLUME = 200, 700
MAX_DIMENSION, MAX_ORDER = 1000, 64

def read_g2(data):
    """The surfaces and volumes of the file."""
    tokens = Tokens(data)
    entities = [read_object(tokens)]
    while tokens.peek():
        entities.append(read_object(tokens))
    return entities

def read_object(tokens):
    kind = tokens.integer()
    if kind not in (SURFACE, VOLUME):
        tokens.refuse("200 (a spline surface) or 700 (a spline volume)")
    tokens.integer(), tokens.integer()                      # the version
    for _ in range(tokens.count()):
        tokens.integer()
    dimension, rational = tokens.integer(1, MAX_DIMENSION), tokens.integer(0, 1) == 1
    axes = [read_axis(tokens) for _ in range(2 if kind == SURFACE else 3)]
    degrees, knots = zip(*axes)
    num_points = prod(sizes_of(degrees, knots))
    if rational:
        points = tokens.weighted(num_points, dimension)
    else:
        numbers = tokens.decimals(num_points * dimension)
        points = [[*numbers[i:i + dimension], Fraction(1)] for i in range(0, len(numbers), dimension)]
    return map_of(degrees, list(knots), rational, dimension, points)

def read_axis(tokens):
    """(degree, knots)"""
    num_points, order = tokens.count(), tokens.integer(2, MAX_ORDER)
    if order > num_points:
        tokens.refuse("an order of at most %d, the number of control points" % num_points)
    return order - 1, tokens.knots(order - 1, num_points)
