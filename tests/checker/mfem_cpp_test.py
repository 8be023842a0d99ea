#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""reading-rule-mfem.md in the C++ checker: what a text means, what is refused, certificates. VERITOPE_CHECK and VERITOPE_PRINT_MODEL name the
programs."""
import itertools
import os
import random
import unittest
from fractions import Fraction as Q

import judges
import printed_models
import star_box_forge as forge
import star_box_models as models
import volume_grids as grids
from volume_grids import LINEAR, SKEW

SCALE = int(os.environ.get("VT_TEST_SCALE", "1"))
# Two squares side by side, the second one turned: its u runs down along the common edge. One knot vector is quadratic.
TWO = """MFEM NURBS mesh v1.0
dimension 2
elements 2
1 3 0 1 2 3
1 3 2 1 4 5 # a comment
boundary 2 1 1 0 1 1 0 3
edges 7
0 0 1
1 1 2
0 3 2
1 0 3
0 1 4
0 2 5
1 4 5
vertices 6
knotvectors 2
1 2 0 0 1 1
2 3 0 0 0 1 1 1
weights 1 1 1 1 1 1 1 1 1
FiniteElementSpace
FiniteElementCollection: NURBS
VDim: 3
Ordering: 1
0 0 0
1 0 0
1 2 0
0 2 0
2 0 0
2 2 0
1 1 7
0 1 8
2 1 9
"""
CUBE = grids.Grid(axes=[[SKEW], [(4, (0,) * 5 + (1,) * 5)], [(2, (0, 0, 0, Q(1, 2), 1, 1, 1))]])


def square(degree=1):
    """One square, section 4."""
    knots = "%d %d %s" % (degree, degree + 1, "0 " * (degree + 1) + "1 " * (degree + 1))
    points = (degree + 1) ** 2
    text = ("MFEM NURBS mesh v1.0 dimension 2 elements 1 1 3 0 1 2 3 boundary 0 edges 4 0 0 1 0 3 2 0 0 3 0 1 2 vertices 4 knotvectors 1 %s "
            "weights %s FiniteElementSpace FiniteElementCollection: NURBS%d VDim: 3 Ordering: 1 %s")
    return text % (knots, "1 " * points, degree, "0 0 0 " * points)


def rational(entities):
    """As this format has them."""
    return [e if e["shape"]["rational"] else dict(e, shape=dict(e["shape"], rational=True, components=4, points=[[*p, "1"] for p in e["shape"]["points"]]))
            for e in entities]


class Meaning(printed_models.PrintedTest):
    fmt = "mfem"

    def test_two_squares_written_by_hand(self):
        """Control points 6, 7, 8 lie within the edges 1 2, 0 3 and 4 5; the other edges have no points of their own."""
        first, second = self.entities(TWO)
        self.assertEqual((first["kind"], first["rational"], first["components"]), ("surface", True, 4))
        self.assertEqual((first["degrees"], first["knots"]), ([1, 2], [[0, 0, 1, 1], [0, 0, 0, 1, 1, 1]]))
        self.assertEqual(first["points"], [(0, 0, 0, 1), (0, 1, 8, 1), (0, 2, 0, 1), (1, 0, 0, 1), (1, 1, 7, 1), (1, 2, 0, 1)])
        self.assertEqual((second["degrees"], second["knots"]), ([2, 1], [[0, 0, 0, 1, 1, 1], [0, 0, 1, 1]]))
        self.assertEqual(second["points"], [(1, 2, 0, 1), (2, 2, 0, 1), (1, 1, 7, 1), (2, 1, 9, 1), (1, 0, 0, 1), (2, 0, 0, 1)])

    def test_knots_run_with_the_edges_of_the_list(self):
        skew = TWO.replace("2 3 0 0 0 1 1 1", "1 3 0 0 4 6 6")
        first, second = self.entities(skew)
        self.assertEqual((first["degrees"], first["knots"][1], second["knots"][0]), ([1, 1], [0, 0, 4, 6, 6], [0, 0, 2, 6, 6]))

    def test_weights_and_orderings(self):
        weights = "weights 1 2 1 1 1 1 0.5 4 1"
        first, second = self.entities(TWO.replace("weights 1 1 1 1 1 1 1 1 1", weights))
        self.assertEqual(first["points"], [(0, 0, 0, 1), (0, 4, 32, 4), (0, 2, 0, 1), (2, 0, 0, 2), (Q(1, 2), Q(1, 2), Q(7, 2), Q(1, 2)), (1, 2, 0, 1)])
        for word in ("unitweights", "autoweights"):
            self.assertEqual(self.entities(TWO.replace("weights 1 1 1 1 1 1 1 1 1", word)), self.entities(TWO))
        head, points = TWO.split("Ordering: 1\n")
        rows = [line.split() for line in points.splitlines()]
        self.assertEqual(self.entities(head + "Ordering: 0\n" + "\n".join(" ".join(column) for column in zip(*rows))), self.entities(TWO))

    def test_a_newer_file(self):
        newer = TWO.replace("v1.0", "v1.1")
        for between in ("spacing 0", "refinements 1 2 spacing 0", "knotvector_refinements 0 2 5 6 spacing 0", "refinements 1 2 knotvector_refinements 1 9 0 spacing 1 1 2 3 4 7 8 9 .5 1 2 3",
                        "spacing 1 -1 2 0 0 "):
            text = newer.replace("weights", between + "\nweights")
            self.assertEqual(self.entities(text), self.entities(TWO), between)
        self.refused("expected spacing", newer, newer.replace("weights", "refinements 1 2 weights"))
        self.refused("expected weights", newer.replace("weights", "spacing 0 refinements 1 2 weights"))
        self.refused("expected weights", TWO.replace("weights", "spacing 0 weights"))

    def test_edges_and_vertices_that_no_patch_has_keep_their_numbers(self):
        more = TWO.replace("edges 7", "edges 9 1 6 6 1 0 5").replace("vertices 6", "vertices 7")
        more = more.replace("weights 1 1 1 1 1 1", "weights 1 1 1 1 1 1 -3 -3 -3").replace("2 2 0\n1 1 7", "2 2 0\n8 8 8\n6 6 6\n5 5 5\n1 1 7")
        self.assertEqual(self.entities(more), self.entities(TWO))

    def test_one_volume_in_one_mesh(self):
        for turn in (False, True):
            mesh = grids.mesh_of_grid(CUBE, None, turn)
            self.reads(rational(CUBE.volumes()), mesh.text())

    def test_patches_of_grids_in_all_positions(self):
        """Shared edges and faces, seen from both sides; vertices and edges in any order, edges in both directions."""
        rng = random.Random(83)
        place = lambda x, y, z: (4 * x + y * z, 4 * y + x, 4 * z + x * y)                           # noqa: E731
        cells = list(itertools.product((0, 1), repeat=3))
        axes = [[SKEW, (1, (0, 0, Q(1, 8), 1, 1))], [(1, (0, 0, Q(1, 2), 2, 2)), SKEW], [(4, (0,) * 5 + (1,) * 5), (2, (0, 0, 0, 1, Q(3, 2), 2, 2, 2))]]
        for case in range(24 * SCALE):
            chosen = rng.sample(cells, rng.choice((2, 2, 3, 8)))
            turns = [grids.SIGNED[(case + 7 * i) % 48] if i == 0 else rng.choice(grids.SIGNED) for i in range(len(chosen))]
            weight = (lambda x, y, z: 1 + x + 2 * y * z) if case % 2 else None
            grid = grids.Grid(chosen, axes, turns, place, weight)
            mesh = grids.mesh_of_grid(grid, rng, case % 3 == 0)
            with self.subTest(seed=83, case=case):
                self.reads(rational(grid.volumes()), mesh.text(ordering=case % 2))

    def test_surfaces_in_space(self):
        """The outside of a cube as one mesh of six patches."""
        for axis in (LINEAR, SKEW):
            grid = grids.Grid(axes=[[axis]] * 3)
            self.reads_surfaces(grid)

    def reads_surfaces(self, grid):
        faces = grid.faces()
        corners = [[tuple(map(int, grids.points_of(f)[i, j])) for i, j in self.ends(f)] for f in faces]
        vertices = sorted(grids.CORNERS)
        number = {v: i for i, v in enumerate(vertices)}
        edges = [(0, number[a], number[b]) for a in vertices for b in vertices if sum(x != y for x, y in zip(a, b)) == 1 and a < b]
        mesh = grids.Mesh(2, 8, [[number[v] for v in c] for c in corners], edges, [grid.axes[0][0]],
                          lambda patch, at: (*grids.points_of(faces[patch])[at], Q(1)))
        self.reads(rational(faces), mesh.text())
        return mesh

    @staticmethod
    def ends(face):
        m, n = (len(knots) - p - 1 for p, knots in grids.axes_of(face))
        return (0, 0), (m - 1, 0), (m - 1, n - 1), (0, n - 1)

    def test_patches_with_their_own_points(self):
        weighted = grids.Grid(axes=[[SKEW], [LINEAR], [LINEAR]], weight=lambda x, y, z: 1 + x)
        for entities in (weighted.volumes() * 2, models.octant_sphere()):
            for word in ("controlpoints", "controlpoints_homogeneous", "controlpoints_cartesian"):
                if word != "controlpoints_cartesian" or entities[0]["kind"] == "volume":    # thirds have no decimals
                    self.reads(entities, grids.mfem_patches(entities, word))

    def test_comments_and_blanks(self):
        text = "\xef\xbb\xbf#1\r" + TWO.replace("dimension 2", "dimension#\n2#").replace("\n", "#x\r \t\v\f")
        self.assertEqual(self.entities(text), self.entities(TWO))

    def test_other_dimensions_are_read(self):
        plane = TWO.replace("VDim: 3", "VDim: 2")
        head, points = plane.split("Ordering: 1\n")
        text = head + "Ordering: 1\n" + "\n".join(line.rsplit(" ", 1)[0] for line in points.splitlines())
        self.assertEqual([e["components"] for e in self.entities(text)], [3, 3])


class Refusals(printed_models.PrintedTest):
    fmt = "mfem"

    def test_truncations(self):
        for text in (TWO, grids.mfem_patches(models.cube()[:1]), TWO.replace("v1.0", "v1.1").replace("weights", "refinements 1 1 spacing 1 1 1 1 1 5 .5 weights")):
            self.assertEqual(printed_models.printed(text, "mfem")[0], 0)
            words = text.replace("# a comment", "").split()
            for n in range(len(words)):
                self.refused("expected", " ".join(words[:n]))
        self.refused("something follows the mesh", TWO + "0", TWO + "x", grids.mfem_patches(models.cube()[:1]) + "patches")

    def test_words(self):
        for word in ("MFEM", "NURBS", "mesh", "v1.0", "dimension", "elements", "boundary", "edges", "vertices", "knotvectors", "weights", "FiniteElementSpace",
                     "FiniteElementCollection:", "VDim:", "Ordering:"):
            self.refused("expected " if word != "edges" else "", TWO.replace(word, word.lower() + "_", 1), TWO.replace(word, "", 1))
        self.refused("line 1, at 'v1.2': expected v1.0", TWO.replace("v1.0", "v1.2"))

    def test_sections(self):
        self.refused("line 2, at '1': expected an integer from 2 to 3", TWO.replace("dimension 2", "dimension 1"))
        self.refused("expected an integer", TWO.replace("dimension 2", "dimension 4"), TWO.replace("dimension 2", "dimension 3"), TWO.replace("elements 2", "elements 0"),
                     TWO.replace("elements 2", "elements -1"), TWO.replace("1 3 0 1", "1 2 0 1"), TWO.replace("1 3 0 1", "1 5 0 1"), TWO.replace("0 1 2 3", "0 1 2 -3"),
                     TWO.replace("0 1 2 3", "0 1 2 3."))
        self.refused("expected a geometry", *(TWO.replace("boundary 2 1 1", "boundary 2 1 %d" % g) for g in (2, 4)))
        self.refused("expected an integer from 0 to 5", *(TWO.replace("boundary 2 1 1", "boundary 2 1 %d" % g) for g in (-1, 6, 7)))
        for text in ("boundary 3 1 0 5 1 3 0 1 2 3 1 5 0 1 2 3 4 5 6 7", "boundary 1 -4 1 9 9"):
            self.assertEqual(len(self.entities(TWO.replace("boundary 2 1 1 0 1 1 0 3", text))), 2)
        self.refused("a patch has a vertex that does not exist", TWO.replace("vertices 6", "vertices 5"), grids.mfem_patches(models.cube()[:1]).replace("vertices\n4", "vertices\n3"))
        self.refused("expected an integer from 0 to", TWO.replace("vertices 6", "vertices 99999"), TWO.replace("edges 7", "edges 99999"), TWO.replace("boundary 2", "boundary 99999"))

    def test_knot_vectors(self):
        self.refused("expected an integer from 1 to 63", TWO.replace("1 2 0 0 1 1", "0 1 0 1"), TWO.replace("1 2 0 0 1 1", "64 2 0 0 1 1"))
        self.refused("expected an integer from 3 to", TWO.replace("2 3 0 0 0 1 1 1", "2 2 0 0 1 1 1"))
        self.refused("expected an integer from 1 to", TWO.replace("knotvectors 2", "knotvectors 0"), TWO.replace("knotvectors 2", "knotvectors 99999"))
        for knots, word in (("0 0 -1 1", "less than the one before"), ("0 0 0 1", "occurs too often"), ("0 1 1 1", "occurs too often")):
            self.refused(word, TWO.replace("1 2 0 0 1 1", "1 2 " + knots))
        self.refused("domain is empty", TWO.replace("2 3 0 0 0 1 1 1", "2 3 0 1 2 2 2 3"))

    def test_fields(self):
        self.refused("expected weights, unitweights or autoweights", TWO.replace("weights 1", "weight 1"))
        self.refused("at 'x': expected a decimal", TWO.replace("weights 1", "weights x"))
        self.refused("a weight is not positive", TWO.replace("weights 1", "weights 0"), TWO.replace("1 1 1\nFinite", "1 1 -1\nFinite"))
        self.refused("expected NURBS", *(TWO.replace(": NURBS", ": " + c) for c in ("NURBS1", "NURBS2", "NURBS_", "nurbs", "H1")))
        self.refused("expected VDim:", TWO.replace(": NURBS", ": NURBS 1"))
        for degree in (1, 2, 12):
            text = square(degree)
            self.assertEqual([e["degrees"] for e in self.entities(text)], [[degree, degree]])
            self.assertEqual(self.entities(text.replace("NURBS%d " % degree, "NURBS ")), self.entities(text))
            self.refused("expected NURBS", *(text.replace("NURBS%d " % degree, "NURBS%s " % d) for d in ("+%d" % degree, "0%d" % degree, degree + 1, "%d0" % degree, "%d." % degree)))
        self.refused("expected an integer from 1 to 1000", TWO.replace("VDim: 3", "VDim: 0"), TWO.replace("VDim: 3", "VDim: 1001"))
        self.refused("expected an integer from 0 to 1", TWO.replace("Ordering: 1", "Ordering: 2"))

    def test_edges(self):
        self.refused("an edge names a knot vector that does not exist", TWO.replace("0 0 1\n", "2 0 1\n"))
        self.refused("an edge names a vertex that does not exist", TWO.replace("edges 7", "edges 8 0 0 6"), TWO.replace("edges 7", "edges 8 0 6 0"))
        self.refused("two edges of the list have the same vertices", TWO.replace("edges 7", "edges 8 0 0 1"), TWO.replace("edges 7", "edges 8 0 1 0"), TWO.replace("edges 7", "edges 9 0 3 3 0 3 3"))
        self.refused("an edge of a patch is not in the list", TWO.replace("0 0 1\n", "0 0 2\n"), TWO.replace("edges 7\n0 0 1", "edges 6"))
        self.refused("different knot vectors", TWO.replace("0 0 1\n", "1 0 1\n"))
        self.refused("a patch has a vertex twice", TWO.replace("1 3 0 1 2 3", "1 3 0 1 2 0"), TWO.replace("1 3 0 1 2 3", "1 3 0 0 2 3"))
        skew = TWO.replace("2 3 0 0 0 1 1 1", "2 3 0 0 0 1 1 2")
        self.assertEqual(len(self.entities(skew)), 2)
        self.refused("the edges of an axis of a patch give it different knots", skew.replace("\n1 0 3\n", "\n1 3 0\n"))
        turned = TWO.replace("\n1 0 3\n", "\n1 3 0\n")        # the knots are symmetric, and the control points do not depend on the edge's direction
        self.assertEqual(self.entities(turned), self.entities(TWO))

    def test_faces(self):
        """Two cells on one face, whose vertices the second one has in another cyclic order."""
        mesh = grids.mesh_of_grid(grids.Grid([(0, 0, 0), (1, 0, 0)]))
        self.assertEqual(len(self.entities(mesh.text())), 2)
        first, second = map(list, mesh.patches)
        common = [v for v in first if v in second]
        self.assertEqual(len(common), 4)
        spare = [v for v in second if v not in first]
        a, b, c, d = first[1], first[2], first[6], first[5]
        crossed = [a, c, b, d, *spare]                    # the face a c b d instead of a b c d
        edges = set()
        for patch in (first, crossed):
            for i, j in itertools.combinations(range(8), 2):
                if sum(x != y for x, y in zip(grids.CORNERS[i], grids.CORNERS[j])) == 1:
                    edges.add(frozenset((patch[i], patch[j])))
        listed = [(0, *sorted(e)) for e in sorted(edges, key=sorted)]
        head = grids.head(3, [first, crossed], listed, 12)
        points = "0 0 0\n" * 12
        tail = "knotvectors 1 1 2 0 0 1 1 unitweights FiniteElementSpace FiniteElementCollection: NURBS VDim: 3 Ordering: 1 " + points
        self.refused("two faces have the same vertices in another order", head + tail)

    def test_patches(self):
        text = grids.mfem_patches(models.cube()[:1])
        self.refused("expected knotvectors", text.replace("knotvectors", "knotvector"))
        self.refused("expected an integer from 2 to 2", text.replace("knotvectors\n2", "knotvectors\n3"))
        self.refused("expected controlpoints", text.replace("controlpoints_homogeneous", "controlpoints_"))
        self.refused("a weight is not positive", *(text.rsplit("1\n", 1)[0] + weight + "\n" for weight in ("-1", "0")))
        self.refused("expected an integer from 1 to 1000", text.replace("dimension 3", "dimension 0"))

    def test_counts_that_lie_take_no_memory_and_no_time(self):
        big = "1 " * 2000
        knots = "60 2 0 %s" % " ".join(map(str, range(62)))
        long = "1 2000 0 %s 3000 " % " ".join(map(str, range(2000)))
        many = TWO.replace("knotvectors 2\n1 2 0 0 1 1\n2 3 0 0 0 1 1 1", "knotvectors 2 " + 2 * long)
        self.refused("a patch has more control points than the file can hold", many + big)
        vertices = itertools.combinations(range(100, 108), 2)          # of edges that no patch has
        edges = " ".join("0 %d %d" % e for e in vertices)
        self.refused("the mesh has more control points than the file can hold", many.replace("edges 7", "edges 35 " + edges).replace("vertices 6", "vertices 108"))
        self.refused("", TWO.replace("edges 7", "edges 2000") + big, TWO.replace("elements 2", "elements 2000") + big, TWO.replace("VDim: 3", "VDim: 1000") + big)
        self.refused("", TWO.replace("weights", "spacing 1 1 1 2000 2000 " + big), TWO.replace("1 2 0 0 1 1", knots))

    def test_one_long_number_in_many_patches(self):
        """12 vertices far away, in all patches that they allow: 0.3 MB that name each number ten thousand times."""
        vertices = 12
        patches = [p for q in itertools.combinations(range(vertices), 4) for p in itertools.permutations(q)][:10000]
        edges = [(0, a, b) for a, b in itertools.combinations(range(vertices), 2)]
        text = grids.head(2, patches, edges, vertices) + "knotvectors 1 1 2 -7e4096 -7e4096 3e4096 3e4096 weights " + "3e4000 " * vertices
        text += "FiniteElementSpace FiniteElementCollection: NURBS VDim: 3 Ordering: 1 " + "7e4096 1e-4000 3e4090 " * vertices
        model = text.encode()
        code, _, out = judges.in_cpp(model, printed_models.hollow(model, "mfem"))
        self.assertEqual((code, out[:9]), (1, "REJECT B1"), out)


class Certificates(printed_models.PrintedTest):
    def test_sound_models_are_accepted(self):
        entities = models.octant_sphere()
        prover = forge.Prover(entities).prove()
        for fmt, expected in (("mfem", 0), ("mfem-faces", 4), ("g2", 4)):
            text = grids.mfem_patches(entities).encode()
            prover.plan.values["subject_format"] = fmt
            self.assertEqual(judges.in_cpp(text, prover.plan.certificate(text))[0], expected)
        mesh = Meaning().reads_surfaces(grids.Grid())
        text = mesh.text().encode()
        prover = forge.Prover(grids.Grid().faces()).prove()
        prover.plan.values["subject_format"] = "mfem"
        code, condition, out = judges.in_cpp(text, prover.plan.certificate(text))
        self.assertEqual((code, condition), (0, "ACCEPT"), out)

    def test_mutated_texts_are_read_or_refused(self):
        rng = random.Random(87)
        bases = TWO, grids.mesh_of_grid(CUBE).text(), grids.mfem_patches(CUBE.volumes())
        bits = ["0", "1", "3", "5", "-", " ", "#", "\n", "e", "1e4096", ".", "x", "patches", "weights", "99999999999999999999", "7 "]
        for _ in range(200):
            text = rng.choice(bases)
            for _ in range(rng.randrange(1, 4)):
                at = rng.randrange(len(text))
                text = text[:at] + rng.choice(bits) + text[at + rng.randrange(4):]
            with self.subTest(text):
                self.assertIn(printed_models.printed(text, "mfem")[0], (0, 4))
                self.assertIn(printed_models.printed(text, "mfem-faces")[0], (0, 4))


def tearDownModule():
    import resource
    most = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
    assert most < 500 * 1024, "a run took %d KiB" % most


if __name__ == "__main__":
    unittest.main()
