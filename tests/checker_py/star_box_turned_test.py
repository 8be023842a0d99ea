#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The Python checker of the claim star-box-turned-1: embedded models whose orientation is wrong, and sound ones."""
import copy
import unittest
from fractions import Fraction as Q

import star_box_forge as forge
import star_box_models as models
import star_box_test as star

vc, zigzag = star.vc, forge.zigzag_code


def turned_cube(*args):
    return [models.reversed_surface(e) for e in models.cube(*args)]


class Turned(unittest.TestCase):
    def says(self, expected, prover, plan=None, skip=(), claim="star-box-turned-1"):
        plan = copy.deepcopy(plan or prover.plan)
        plan.values["claim"] = claim
        code, line = vc._check(prover.model, plan.certificate(prover.model), frozenset(skip))
        self.assertEqual(line.split(":")[0].replace("REJECT ", "").replace("ACCEPT " + claim, "ACCEPT"), expected, line)
        self.assertEqual(code, 0 if expected == "ACCEPT" else 1, line)

    def proved(self, entities, winding, flags=None):
        prover = star.AnySign(entities, flags).prove()
        prover.plan.values.update(winding=zigzag(winding), bodies=0)
        return prover

    def test_a_cube_inside_out(self):
        prover = self.proved(turned_cube(), 0)
        self.says("ACCEPT", prover)
        for winding in (1, 2, 5, (1 << 64) - 1):
            plan = copy.deepcopy(prover.plan)
            plan.values["winding"] = winding
            self.says("W3", prover, plan)
            self.says("ACCEPT", prover, plan, {"W3"})

    def test_the_claims_exclude_each_other(self):
        prover = self.proved(turned_cube(), 0)
        del prover.plan.values["winding"]
        prover.plan.values["bodies"] = 0
        self.says("W2", prover, claim="star-box-1")
        sound = self.proved(models.cube(), 1)
        self.says("W2", sound)
        self.says("ACCEPT", sound, skip={"W2"})
        self.says("S1", prover)                           # without its key

    def test_p1_a_line_inside_of_a_surface_that_is_a_point(self):
        entities, breaks = star.bow_tie()
        turned = [models.reversed_surface(e) for e in entities]
        prover = star.cut(turned, [axes[::-1] for axes in breaks], kind=star.AnySign, checked=False).prove()
        prover.plan.values.update(winding=zigzag(0), bodies=0)
        self.says("P1", prover)
        self.says("ACCEPT", prover, skip={"P1"})

    def test_a_solid_in_a_solid(self):
        """The inner cube has w = 2 inside; the outer one alone is sound, so the inner one's walk must be the last."""
        prover = self.proved(models.cube(2) + models.cube(Q(1, 2)), 2)
        self.says("ACCEPT", prover)
        outer_last = copy.deepcopy(prover.plan)
        outer_last.walks.reverse()
        outer_last.values["winding"] = zigzag(1)
        self.says("W1", prover, outer_last)               # the inner one's walk ends at the outer one's

    def test_shells_of_which_one_is_turned(self):
        prover = self.proved(models.cube() + turned_cube(1, (4, 0, 0)), 0)
        walks = prover.plan.walks
        if prover.plan.walks[-1][1] == 1:
            walks.reverse()
        self.says("ACCEPT", prover)
        sound_last = copy.deepcopy(prover.plan)
        sound_last.walks.reverse()
        sound_last.values["winding"] = zigzag(1)
        self.says("W2", prover, sound_last)
        self.says("ACCEPT", prover, sound_last, {"W2"})

    def test_a_negative_winding_number(self):
        """A turned cube in a turned cube: -1."""
        prover = self.proved(turned_cube(2) + turned_cube(Q(1, 2)), -1)
        self.says("ACCEPT", prover)

    def test_flags_of_the_prover_turn_nothing(self):
        prover = self.proved(models.cube(), 0, flags=[1] * 6)
        prover.plan.values["flipped"] = 6
        self.says("W3", prover)
        self.says("ACCEPT", prover, skip={"W3"})

    def test_bodies_are_none(self):
        prover = self.proved(turned_cube(), 0)
        prover.plan.values["bodies"] = 1
        self.says("W3", prover)
        self.says("ACCEPT", prover, skip={"W3"})

    def test_what_is_not_embedded_is_not_turned(self):
        """A cube inside out and one that crosses it: P1 to W1 hold but for C3."""
        crossing = turned_cube() + turned_cube(1, (1, Q(1, 2), Q(1, 4)))

        class Careless(star.Careless, star.AnySign):
            pass
        prover = Careless(crossing).prove()
        prover.plan.values.update(winding=0, bodies=0)
        self.says("C3", prover)
        self.says("ACCEPT", prover, skip={"C3"})


if __name__ == "__main__":
    unittest.main()
