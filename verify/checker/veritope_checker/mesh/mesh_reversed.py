# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claim mesh-reversed-1: docs/certificates/mesh-reversed.md."""
from ..common.errors import Reject
from . import mesh_reader, mesh_valid
from .mesh_model import Body, Mesh

def check(claim, statement, body, model, skip):
    points, triangles = mesh_reader.read_model(model, statement["subject_format"], statement["as_indexed"])
    body = Body(body)
    body.header(claim.magic, points, triangles)
    is_reversed = read_bits(body, len(triangles))
    mesh = Mesh(points, [(a, c, b) if turns else (a, b, c) for (a, b, c), turns in zip(triangles, is_reversed)])
    cert = mesh_valid.ValidBody(body, mesh)
    if not any(is_reversed) and "R1" not in skip:
        raise Reject("R1", "no triangle is reversed")
    kept = {shell for shell, turns in zip(cert.shell_of, is_reversed) if not turns}
    mesh_valid.prove(cert, mesh, statement,
                     {"reversed": sum(is_reversed), "reversed_shells": cert.num_shells - len(kept)}, skip)

def read_bits(body, n):
    """The first n bits of the next ceil(n / 8) bytes, least significant first; the others are 0."""
    bits = int.from_bytes(body.bytes((n + 7) // 8), "little")
    if bits >> n:
        raise Reject("B1", "a bit of `reversed` belongs to no triangle")
    text = format(bits, "b").zfill(n)                       # linear in n, unlike a shift for each bit
    return [digit == "1" for digit in reversed(text)]
