# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Winding numbers of a spline model and of its shells (docs/certificates/micro-inside.md, section 8): for I2 and I3.
All numbers are exact."""
from fractions import Fraction
from functools import cached_property

from ..common.errors import Reject
from ..points.patch_points_check import Model, Point
from ..points.patch_winding import LeftOver, TooMuchWork, Work, winding
from .inside_points import OnSurface

class PatchWinding:
    """As Winding of inside_points.py.  num_bytes: of the model and of the certificate."""

    def __init__(self, entities, breaks, num_bytes, fail):
        self.model, self.num_bytes = Model(entities, breaks, fail), num_bytes
        self.shell_of = [patch.component for patch in self.model.patches]
        self.condition, self.work = None, None

    def begin(self, condition, num_points):
        self.condition, self.work = condition, Work(num_points, self.num_bytes)

    def around(self, point):
        """The winding number."""
        self.work.begin_point()
        return self.number(point)

    def shells_around(self, point):
        """The shells whose winding number is not 0."""
        self.work.begin_point()
        return {shell for shell in self.shells() if self.number(point, shell)}

    def shells(self):
        return range(1 + max(self.shell_of))

    @cached_property
    def depths(self):
        """For each shell the number of the others that contain a vertex of it."""
        firsts = [self.shell_of.index(shell) for shell in self.shells()]
        if len(firsts) == 1:
            return [0]
        depths = []
        for shell, patch in enumerate(firsts):
            *point, w = self.model.grids[patch].rows[0][0]
            point = [Fraction(c, w) for c in point]
            self.work.begin_point()
            try:
                depths.append(sum(self.number(point, other) != 0 for other in self.shells() if other != shell))
            except OnSurface as on:
                raise Reject(self.condition, "a vertex of shell %d may lie on %s" % (shell, on)) from None
        return depths

    def number(self, point, shell=None):
        """The winding number of the model, or of a shell."""
        at = Point([(c.numerator, c.denominator) for c in point])
        for direction in range(6):
            patches = [n for n in self.model.patches_on_ray(at, direction) if shell in (None, self.shell_of[n])]
            try:
                return winding(self.model, at, patches, direction, self.work)
            except LeftOver:
                continue
            except TooMuchWork:
                raise Reject(self.condition, "a winding number takes too much work") from None
        raise OnSurface("the surface of the model")
