# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The surface of a simplex-spline solid (docs/certificates/dms-solid.md, section 6): T1 to T3."""
from ..common.vectors import cross, dot, sub
from .dms_domain import triangle_entity
from .dms_near import coefficients, first_cut, tile_region, unexcluded
from .dms_walls import normal_of

class Surface:
    """tiles: of each face of the boundary (corners as numbers of points, planes); points: scaled."""

    def __init__(self, spline, boundary, cert, fail, spend):
        self.spline, self.boundary, self.fail, self.spend = spline, boundary, fail, spend
        self.points = [cloud[0] for cloud in spline.knots] + [spline.scaled(point) for point in cert.points]
        self.tiles = [[(tile.corners, tile.planes) for tile in tiles] or [(list(face), [])]
                      for face, tiles in zip(boundary, cert.tiles)]

    def test_tiling(self):
        """T1."""
        for face, tiles in zip(self.boundary, self.tiles):
            why = self.why_no_tiling(face, [corners for corners, _ in tiles])
            if why:
                self.fail("T1", "the tiles of the face %s: %s" % (face, why))

    def why_no_tiling(self, face, tiles):
        at = self.points.__getitem__
        normal = normal_of([at(v) for v in face])
        for corners in tiles:
            if any(dot(normal, sub(at(v), at(face[0]))) for v in corners):
                return "a point is not in the plane"
            if dot(normal, normal_of([at(v) for v in corners])) <= 0:
                return "one is flat or reversed"
        edges = [(a, b) for c in tiles for a, b in zip(c, [*c[1:], c[0]])]
        if len(set(edges)) != len(edges):
            return "an edge occurs twice"
        outer = {a: b for a, b in edges if (b, a) not in set(edges)}
        if len(outer) != sum((b, a) not in set(edges) for a, b in edges):
            return "the border passes a point twice"
        for begin, end in zip(face, [*face[1:], face[0]]):
            way = sub(at(end), at(begin))
            while begin != end:
                following = outer.pop(begin, None)
                if following is None:
                    return "the border is open"
                step = sub(at(following), at(begin))
                if any(cross(way, step)) or dot(way, step) <= 0 or dot(way, sub(at(end), at(following))) < 0:
                    return "the border leaves the face's"
                begin = following
        return "there is another border" if outer else None

    def entities(self):
        """Those of T3, a tile after the other; tests T2 on the way."""
        for corners, planes in (tile for tiles in self.tiles for tile in tiles):
            places = [self.points[v] for v in corners]
            near = self.test_walls(corners, tile_region(self.spline, places, planes))
            yield triangle_entity(self.spline.model.degree, coefficients(self.spline, places, near))

    def test_walls(self, corners, region):
        """T2 for a tile; the V_gamma that count."""
        near = list(unexcluded(self.spline, region, lambda: self.spend("T2")))
        cut = first_cut(region, near, lambda: self.spend("T2"))
        if cut:
            self.fail("T2", "knots %s of tetrahedron %d meet the tile %s" % (cut[1], cut[0], corners))
        return near
