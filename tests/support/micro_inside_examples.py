# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Certificates of micro-inside-1, whatever they say: tests only."""
import copy
import hashlib
import json
import pathlib
import random
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests" / "support"), str(ROOT / "tests" / "checker_py"), str(ROOT / "tests" / "mutation")]
import forge                                              # noqa: E402
import micro_bridge_examples as bridged                   # noqa: E402

star_forge = bridged.forge


class Inside:
    """micro: of micro_bridge_examples.py; mesh: (points, polygons); voids: (volume, x, corner) each."""
    magic, tail = b"VTIM", b""

    def __init__(self, micro, mesh, skin=None, voids=(), mesh_format="off"):
        self.micro, self.skin, self.voids = micro, skin or ("1000000" if micro.bridges or micro.sweeps else "-"), list(voids)
        points, polygons = mesh
        triangles = [(f[0], f[i], f[i + 1]) for f in polygons for i in range(1, len(f) - 1)]
        self.solid = forge.Model(points, triangles, fmt=mesh_format)
        self.plan = forge.Plan(forge.mesh_of(self.solid), random.Random(3))
        self.values = {}

    def changed(self, **fields):
        new = copy.copy(self)
        for key, value in fields.items():
            setattr(new, key, value)
        return new

    def body(self):
        structure, solid = self.micro.body(), self.plan.body()
        out = [self.magic, star_forge.u32(len(structure)), star_forge.u32(len(solid)), structure, solid, star_forge.u32(len(self.voids))]
        for volume, x, corner in self.voids:
            out += [star_forge.u32(volume), *map(star_forge.rational, x), bytes([corner])]
        return b"".join(out) + self.tail

    def model(self):
        """The file of --model."""
        return self.solid.encode()

    def certificate(self):
        subject, model, body = self.micro.text(), self.model(), self.body()
        if not self.micro.values:
            self.micro.settled()
        statement = {"certificate": "veritope-certificate-1", "tool": "micro_inside_examples", "claim": "micro-inside-1",
                     "subject_sha256": hashlib.sha256(subject).hexdigest(), "subject_bytes": len(subject), "subject_format": "vmicro",
                     "model_sha256": hashlib.sha256(model).hexdigest(), "model_bytes": len(model), "model_format": self.solid.fmt,
                     "reading_rule": forge.READING_RULE, "as_indexed": False, "skin": self.skin,
                     "body_sha256": hashlib.sha256(body).hexdigest(), **self.micro.values, **self.values}
        return json.dumps(statement, separators=(",", ":")).encode() + b"\n" + body
