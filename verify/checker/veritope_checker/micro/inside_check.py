# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claim micro-inside-1: check() is called when the statement and the hashes are right, but for that of the model.

Written from docs/certificates/micro-inside.md alone, and the pages that it quotes.
"""
import hashlib
from fractions import Fraction

from ..common.errors import Reject
from ..mesh import mesh_reader, mesh_valid
from ..mesh.mesh_model import Body as MeshBody, Mesh
from ..patches.star_box_read import Body
from .inside_mesh import Triangles
from .inside_points import NO_CORNER, Void, Voids, Winding, test_i2
from .inside_surface import Surface
from .micro_body import MAX_BITS
from .micro_check import Checker
from .micro_read import Microstructure

MAGIC, NO_SKIN = b"VTIM", "-"

def check(claim, statement, body, model, skip, solid):
    """solid: the file of --model.  skip: conditions that are not tested, for tests only."""
    if "A1" not in skip and (len(solid) != statement["model_bytes"]
                             or hashlib.sha256(solid).hexdigest() != statement["model_sha256"]):
        raise Reject("A1", "the certificate is about another model")
    microstructure = Microstructure(model)
    mesh = mesh_reader.read_model(solid, statement["model_format"], statement["as_indexed"])
    Inside(statement, body, microstructure, mesh, skip).run()

class Inside:
    """The conditions in the order of the page. mesh: coordinates and triangles."""

    def __init__(self, statement, body, model, mesh, skip):
        self.statement, self.model, self.skip = statement, model, skip
        body = Body(body)
        if body.bytes(4) != MAGIC:
            raise Reject("B1", "magic")
        lengths = [int.from_bytes(body.bytes(4), "little") for _ in range(2)]
        self.structure, self.solid = [body.bytes(n) for n in lengths]
        self.voids = [Void(int.from_bytes(body.bytes(4), "little"), [body.rational() for _ in range(3)],
                           body.u8(NO_CORNER)) for _ in range(body.count(11))]
        body.end()
        if any(void.volume >= len(model.cage) for void in self.voids):
            raise Reject("B1", "a volume does not exist")
        self.mesh = mesh

    def unless_skipped(self, condition, test, *arguments):
        if condition not in self.skip:
            test(*arguments)

    def run(self):
        self.unless_skipped("B2", self.test_b2)
        structure = Checker(self.statement, self.structure, self.model, self.skip)
        structure.test()
        mesh, shell_of, depths = self.proved_mesh()
        triangles = Triangles(mesh)
        surface, winding = Surface(self.model, structure.tiles, triangles), Winding(mesh, triangles.tree)
        self.unless_skipped("I1", surface.test_i1)
        self.unless_skipped("I2", test_i2, self.model, structure.tiles, structure.glued, winding)
        self.unless_skipped("I3", Voids(self.model, structure.tiles, winding, shell_of, depths).test, self.voids)
        self.unless_skipped("I4", self.test_i4, surface)
        structure.compare()

    def test_b2(self):
        if any(max(abs(c.numerator), c.denominator) >> MAX_BITS for void in self.voids for c in void.x):
            raise Reject("B2", "a number of a void is too long")

    def proved_mesh(self):
        """(the mesh, the shell of each triangle, the depth of each shell)"""
        mesh, body = Mesh(*self.mesh), MeshBody(self.solid)
        body.header(b"VTMV", mesh.points, mesh.triangles)
        cert = mesh_valid.ValidBody(body, mesh)
        return mesh, cert.shell_of, mesh_valid.proved(cert, mesh, self.skip).depths

    def test_i4(self, surface):
        skin = self.statement["skin"]
        if (skin == NO_SKIN) != (not self.model.bridges):
            raise Reject("I4", "there is a skin without bridges, or the reverse")
        if skin != NO_SKIN:
            surface.test_i4(Fraction(*map(int, skin.split("/"))))
