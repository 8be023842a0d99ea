# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The table of claims: one row for each claim that this checker decides. tests/claims_table_test.py compares it with
the C++ checker's."""
from collections import namedtuple

from .common.statement import HEX64, keys_of

# magic: the first bytes of the body.  keys: of the statement, besides those that every statement has.  module: its
# check(claim, statement, body, model, skip) raises Refused or Reject, or the claim holds; the result is what is said
# about it, or None.  about_answers: the claim is about a third file, too, whose bytes are one more argument of check(),
# before (name of the model, function that reads the file of a name).  about_model: the same for the bytes of a second
# model, alone.
Claim = namedtuple("Claim", "name magic formats keys module about_answers about_model", defaults=(False, False))

MESHES = ("stl", "obj", "ply", "off")
SPLINES = ("vjson", "itd", "g2", "mfem", "vjson-faces", "itd-faces", "g2-faces", "mfem-faces")
VOLUMES = ("vjson", "itd", "g2", "mfem")
OF_MESHES = {"reading_rule": r".*", "as_indexed": bool}
OF_SOLIDS = {**OF_MESHES, "vertices": int, "edges": int, "faces": int, "shells": int, "bodies": int, "genus": int,
             "volume": r"(0|[1-9][0-9]*)/[1-9][0-9]*"}      # lowest terms: V11
OF_POINTS = {**OF_MESHES, "answers_sha256": HEX64, "answers_bytes": int, "decimals": "nearest|exact", "winding": bool,
             "points": int, "on": int, "undecided": int}
OF_PATCHES = {"patches": int, "flipped": int}
OF_VMODELS = {name: int for name in (
    "cells", "pieces", "half_v_surfaces", "v_surfaces", "v_curves", "v_points", "euler", "reversed", "singular",
    "patches", "shells", "bodies", "genus", "boxes")}
V_FINDINGS = "flat|left-handed|singular|overlap|curve-nonmanifold|point-nonmanifold"
OF_MICROSTRUCTURES = {name: int for name in (
    "cells", "tiles", "bridges", "glued_caps", "components", "shells", "genus")}
OF_DMS = {name: int for name in ("tetrahedra", "control_points", "leaves", "patches", "shells", "bodies", "genus")}
OF_DMS_PAIRS = {name: int for name in (
    "tetrahedra", "control_points", "leaves", "faces", "shells", "bodies", "genus")}
DMS_FINDINGS = ("tet-reversed|tet-face-overused|cloud-degenerate|cloud-no-core|cloud-inside|jacobian|jacobian-zero|"
                "M4|M6|M7|M9|meeting|crossing|covering")
A_RATIO = r"[0-9]{1,100}(/(?!0+\Z)[0-9]{1,100})?"
OF_INSIDES = {**OF_MICROSTRUCTURES, **OF_MESHES, "model_sha256": HEX64, "model_bytes": int,
              "model_format": "|".join(MESHES + SPLINES), "skin": "-|" + A_RATIO}
OF_STARS = {**OF_PATCHES, "edges": int, "vertices": int, "shells": int, "bodies": int, "genus": int, "boxes": int}

CLAIMS = {claim.name: claim for claim in (
    Claim("mesh-valid-1", b"VTMV", MESHES, OF_SOLIDS, "mesh.mesh_valid"),
    Claim("mesh-invalid-1", b"VTMI", MESHES, {**OF_MESHES, "rules": r"M[1-9]( M[1-9])*"}, "mesh.mesh_invalid"),
    Claim("mesh-reversed-1", b"VTMR", MESHES, {**OF_SOLIDS, "reversed": int, "reversed_shells": int},
          "mesh.mesh_reversed"),
    Claim("points-1", b"VTPT", MESHES + SPLINES + ("chain",), OF_POINTS, "points.points_check", about_answers=True),
    Claim("star-box-1", b"VTSB", SPLINES, OF_STARS, "patches.star_box_check"),
    Claim("star-box-turned-1", b"VTSB", SPLINES, {**OF_STARS, "winding": int}, "patches.star_box_check"),
    Claim("star-box-2", b"VTS2", SPLINES, OF_STARS, "patches.star_box_2_check"),
    Claim("star-box-turned-2", b"VTS2", SPLINES, {**OF_STARS, "winding": int}, "patches.star_box_2_check"),
    Claim("patch-invalid-1", b"VTPI", SPLINES, {**OF_PATCHES, "finding": "crossing|side", "same": int, "opposite": int},
          "patches.patch_invalid_check"),
    Claim("patch-invalid-2", b"VTI2", SPLINES, {**OF_PATCHES, "finding": "meeting"}, "patches.patch_meeting_check"),
    Claim("volume-folded-1", b"VTVF", VOLUMES, {"volumes": int, "entity": int}, "patches.volume_folded_check"),
    Claim("collar-1", b"VTSB", SPLINES, {**OF_STARS, "cells": int}, "collar.collar_check"),
    Claim("collar-2", b"VTS2", SPLINES, {**OF_STARS, "cells": int}, "collar.collar_check"),
    Claim("vmodel-1", b"VTVM", VOLUMES, OF_VMODELS, "vmodel.vmodel_check"),
    Claim("vmodel-invalid-1", b"VTVI", VOLUMES, {"finding": V_FINDINGS, "cells": int}, "vmodel.vmodel_invalid_check"),
    Claim("microstructure-1", b"VTMS", ("vmicro",), OF_MICROSTRUCTURES, "micro.micro_check"),
    Claim("dms-solid-1", b"VTDM", ("vdms",), OF_DMS, "dms.dms_check"),
    Claim("dms-solid-2", b"VTD2", ("vdms",), OF_DMS_PAIRS, "dms.dms_pairs_check"),
    Claim("dms-invalid-1", b"VTDI", ("vdms",), {"finding": DMS_FINDINGS, "tetrahedra": int}, "dms.dms_invalid_check"),
    Claim("micro-inside-1", b"VTIM", ("vmicro",), OF_INSIDES, "micro.inside_check", about_model=True),
)}

def lines():
    """The text that --claims prints, a line for each claim: name, magic, formats, keys with the kinds of their
    values."""
    kinds = {int: "number", bool: "flag"}
    for claim in CLAIMS.values():
        keys = ["%s=%s" % (key, kinds.get(rule, "text")) for key, rule in sorted(keys_of(claim).items())]
        yield " ".join((claim.name, claim.magic.decode(), ",".join(claim.formats), ",".join(keys)))
