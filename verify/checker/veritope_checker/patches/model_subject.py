# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The choice of a reader: docs/certificates/star-box.md, table of formats."""
from .model_faces import boundary_faces, checked
from .model_g2 import read_g2
from .model_json_volumes import read_json_volumes
from .model_mfem import read_mfem
from .star_box_itd import Reader
from .star_box_read import read_model

VOLUMES = {"vjson": read_json_volumes, "itd": lambda data: Reader(data, 3).model(), "g2": read_g2, "mfem": read_mfem}
MAPS = {"itd": lambda data: Reader(data).model(), "g2": read_g2, "mfem": read_mfem}

def read_volumes(data, subject_format):
    """The volumes of a file in this format: reading-rule-faces.md, section 1."""
    return [volume for volume, _ in checked(VOLUMES[subject_format](data))]

def read_subject(data, subject_format):
    """The entities of a model in the format that the statement names; None for those of other kinds than surfaces and
    triangles."""
    name, _, faces = subject_format.partition("-")
    if faces:
        return boundary_faces(VOLUMES[name](data))
    if name == "vjson":
        return read_model(data)
    return [entity if entity.kind == "surface" else None for entity in MAPS[name](data)]
