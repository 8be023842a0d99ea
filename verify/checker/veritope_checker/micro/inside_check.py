# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claim micro-inside-1: check() is called when the statement and the hashes are right, but for that of the model.

Written from docs/certificates/micro-inside.md alone, and the pages that it quotes.
"""
import hashlib
from fractions import Fraction

from ..common.errors import Reject
from ..mesh import mesh_reader, mesh_valid
from ..mesh.mesh_model import Body as MeshBody, Mesh
from ..patches.model_subject import read_subject
from ..patches.star_box_2_check import Checker2
from ..patches.star_box_read import Body
from .inside_mesh import Triangles
from .inside_parts import Parts
from .inside_patches import NearPatches
from .inside_points import NO_CORNER, Void, Voids, Winding, test_i2
from .inside_shells import PatchWinding
from .inside_surface import Surface
from .micro_body import MAX_BITS
from .micro_check import Checker
from .micro_read import Microstructure

MAGIC, NO_SKIN, MESHES = b"VTIM", "-", ("stl", "obj", "ply", "off")

def check(claim, statement, body, model, skip, solid):
    """solid: the file of --model.  skip: conditions that are not tested, for tests only."""
    if "A1" not in skip and (len(solid) != statement["model_bytes"]
                             or hashlib.sha256(solid).hexdigest() != statement["model_sha256"]):
        raise Reject("A1", "the certificate is about another model")
    microstructure = Microstructure(model)
    kind = MeshSolid if statement["model_format"] in MESHES else SplineSolid
    Inside(statement, body, microstructure, kind(statement, solid), skip).run()

class MeshSolid:
    def __init__(self, statement, data):
        self.mesh = mesh_reader.read_model(data, statement["model_format"], statement["as_indexed"])

    def prove(self, data, num_bytes, skip):
        """The conditions of the part `solid`."""
        mesh, body = Mesh(*self.mesh), MeshBody(data)
        body.header(b"VTMV", mesh.points, mesh.triangles)
        cert = mesh_valid.ValidBody(body, mesh)
        depths = mesh_valid.proved(cert, mesh, skip).depths
        self.triangles = Triangles(mesh)
        self.winding = Winding(mesh, self.triangles.tree, cert.shell_of, depths)

    def surface(self, parts):
        return Surface(parts, self.triangles)

class SplineSolid:
    def __init__(self, statement, data):
        self.statement = {"claim": "star-box-2", "subject_bytes": statement["model_bytes"]}
        self.entities = read_subject(data, statement["model_format"])

    def prove(self, data, num_bytes, skip):
        """The conditions of the part `solid`, and I0."""
        def fail(condition, why):
            if condition not in skip:
                raise Reject(condition, why)

        checker = Checker2(b"VTS2", self.statement, data, self.entities, skip)
        checker.make_patches()
        if checker.numbers()["bodies"] < 1:
            fail("W3", "the model has no body")
        if any(checker.cert.flags):
            fail("I0", "an entity of the model is reversed")
        num_bytes += self.statement["subject_bytes"]
        self.winding = PatchWinding(self.entities, checker.cert.breaks, num_bytes, fail)

    def surface(self, parts):
        return NearPatches(parts, self.winding.model.grids)

class Inside:
    """The conditions in the order of the page. solid: MeshSolid or SplineSolid."""

    def __init__(self, statement, body, model, solid, skip):
        self.statement, self.model, self.skip, self.num_bytes = statement, model, skip, len(body)
        body = Body(body)
        if body.bytes(4) != MAGIC:
            raise Reject("B1", "magic")
        lengths = [int.from_bytes(body.bytes(4), "little") for _ in range(2)]
        self.structure, self.proof = [body.bytes(n) for n in lengths]
        self.voids = [Void(int.from_bytes(body.bytes(4), "little"), [body.rational() for _ in range(3)],
                           body.u8(NO_CORNER)) for _ in range(body.count(11))]
        body.end()
        if any(void.volume >= len(model.cage) for void in self.voids):
            raise Reject("B1", "a volume does not exist")
        self.solid = solid

    def unless_skipped(self, condition, test, *arguments):
        if condition not in self.skip:
            test(*arguments)

    def run(self):
        self.unless_skipped("B2", self.test_b2)
        structure = Checker(self.statement, self.structure, self.model, self.skip)
        structure.test()
        self.solid.prove(self.proof, self.num_bytes, self.skip)
        surface, winding = self.solid.surface(Parts(self.model, structure.tiles)), self.solid.winding
        self.unless_skipped("I1", surface.test_i1)
        self.unless_skipped("I2", test_i2, self.model, structure.tiles, structure.glued, winding)
        self.unless_skipped("I3", Voids(self.model, structure.tiles, winding).test, self.voids)
        self.unless_skipped("I4", self.test_i4, surface)
        structure.compare()

    def test_b2(self):
        if any(max(abs(c.numerator), c.denominator) >> MAX_BITS for void in self.voids for c in void.x):
            raise Reject("B2", "a number of a void is too long")

    def test_i4(self, surface):
        skin = self.statement["skin"]
        if (skin == NO_SKIN) == bool(self.model.bridges or self.model.sweeps):
            raise Reject("I4", "there is a skin without bridges and sweeps, or the reverse")
        if skin != NO_SKIN:
            surface.test_i4(Fraction(*map(int, skin.split("/"))))
