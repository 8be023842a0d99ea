# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Liars for the claims star-box-2 and star-box-turned-2: thin solids that cross, touch, fold or are inside out, with frames, sheets
and separators that are right for a solid nearby; and the lies of version 1 in the form of version 2."""
from fractions import Fraction as Q

import patch_liars
import patch_solids as ps
import sheet_lies
import sheet_models
import star_box_2_forge as forge2
import star_box_2_models as models2
from patch_solids import UNIT
from sheet_lies import LIES, plain
from sheet_plans import encoded, made, shifted

CLAIMS = {"star-box-1": "star-box-2", "star-box-turned-1": "star-box-turned-2"}
GAPS = [Q(1, 16), Q(1, 64), Q(1, 1 << 10)]


# ---------------------------------------------------------------- sound models

def plate(rng):
    gap, turned = rng.choice(GAPS), rng.random() < .7
    return gap, turned, made("plate %s %s" % (gap, turned), lambda: models2.proved_plate(gap, turned).plan)


def shell(rng):
    gap = Q(1, 1 << rng.choice((8, 12)))
    return made("shell %s" % gap, lambda: models2.proved_shell(gap).plan)


def blocks(rng):
    return made("blocks", lambda: models2.star_and_mesh(models2.blocks()).prove().plan)


def squircle(rng):
    return made("squircle", lambda: forge2.Prover2(models2.prism(models2.squircle), search=True).prove().plan)


def sound(rng):
    return sheet_models.sound(rng) if rng.random() < .9 else rng.choice((blocks, squircle))(rng)


def of_version_1(plan):
    """The plan in version 2; None if it has a box that cannot be read."""
    try:
        new = forge2.to_version_2(plan)
    except forge2.Reject:
        return None
    if "claim" in new.values:
        new.values["claim"] = CLAIMS[new.values["claim"]]
    return new


# ---------------------------------------------------------------- attacks

# (false model, lie): the parts of conditions (sheet_conditions.py) of which some such attack needs each alone.
DIRECTED = {("poked", "equal_signs"): ("B1 signs differ",), ("far_centres", "plain"): ("B1 centres inside",), ("two_that_cross", "boxes_elsewhere"): ("C1", "C1 hull"),
            ("one_inside_out", "walks_from_unnamed_boxes"): ("C1 named",), ("poked", "plain"): ("C2 separators",), ("z_fold", "plain"): ("C2 own centres",),
            ("pinched_roof", "plain"): ("C2 inner side",), ("tip_on_a_face", "plain"): ("C2 zero of q",),
            ("nested_and_poking", "merged_by_component"): ("C3",), ("two_that_cross", "plain"): ("C4", "C4 meet"), ("bulging", "plain"): ("C4 plane",),
            ("folded", "plain"): ("C4 unfolded",), ("upside_down_in_a_cavity", "plain"): ("W1", "W1 one sheet"), ("open_by_an_ulp", "plain"): ("P1",),
            ("one_inside_out", "missing_walks"): ("W1 one walk", "W1 earlier"), ("one_inside_out", "plain"): ("W2",), ("sound", "wrong_numbers"): ("W3",)}


def directed_attacks(rng, pair=None):
    model, lie = pair or rng.choice(list(DIRECTED))
    found = sheet_models.sound(rng) if model == "sound" else getattr(sheet_models, model)(rng)[0]
    for new in getattr(sheet_lies, lie)(found, rng):
        yield "%s/%s" % (model, lie), *encoded(new)


def thin_attacks(rng):
    if rng.random() < .2:
        yield from directed_attacks(rng)
        return
    name, plan = sheet_models.false_model(rng)
    for lie in LIES:
        if lie is plain or rng.random() < .5:
            for new in lie(plan, rng):
                yield "%s/%s" % (name, lie.__name__), *encoded(new)


def wrong_windings(rng):
    """The cube inside out, in version 2, with another winding number, flags or counts."""
    for case, plan in patch_liars.wrong_windings(rng):
        yield "wrong_windings", case.bytes, of_version_1(plan).certificate(case.bytes)


def sheet_attacks(rng):
    """(strategy, model, certificate)."""
    r = rng.random()
    if r < .9:
        yield from thin_attacks(rng)
    elif r < .95:
        yield from wrong_windings(rng)
    else:
        for name, case, plan in patch_liars.star_lies(rng):
            new = of_version_1(plan)
            if new:
                yield name, case.bytes, new.certificate(case.bytes)


def honest(rng):
    """(name, model, certificate)."""
    way = rng.randrange(8)
    if way >= 6:
        yield "thin", *encoded(sheet_models.sound(rng))
    elif way < 4:
        plan = (lambda rng: plate(rng)[2], shell, blocks, squircle)[way](rng)
        if way < 2 and rng.random() < .5:
            plan = shifted(plan, [rng.randint(-5, 5) * UNIT for _ in range(3)])
        yield "sheets", *encoded(plan)
    elif way == 4:
        yield "converted", *encoded(of_version_1(ps.solid(rng, .02).plan))
    else:
        case = patch_liars.really_turned(rng)
        yield "turned-2", case.bytes, of_version_1(case.plan).certificate(case.bytes)
