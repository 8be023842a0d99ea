// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/patch_explanations.h"

#include <algorithm>
#include <array>

namespace veritope::cli {
namespace {

constexpr std::array<PatchExplanation, 22> kExplanations = {{
    {{"patches-crossing", "patches that cross",
      "Two parts of patches, or of one patch, that are different places of the surface have a "
      "common point.",
      "Parts pushed through one another without a Boolean operation, a fillet larger than its "
      "wall, control points moved past their neighbours, an offset beyond the radius of curvature.",
      "Unite overlapping parts and trim them; move the control points near the point. The "
      "parameters say which spans to look at.",
      "Open CASCADE BOPAlgo_ArgumentAnalyzer self-interference; Parasolid face-face "
      "inconsistency; GoTools: none"},
     R"(       |   /
  -----+--x----    the proved point lies in a box, near x
       | /)"},
    {{"patches-touching", "patches that touch",
      "Two different places of the surface are the same point, exactly, though nothing crosses "
      "there: faces that lie on one another, a corner or an edge in a face, two smooth sheets that "
      "are tangent. Status 1, with a certificate that names both places; status 3, as "
      "not-certified, where no such place has simple parameters.",
      "Parts that were placed side by side and not united, a fillet tangent to another face, a "
      "hole that just reaches the border.",
      "Unite the parts, or move them apart.",
      "Open CASCADE BOPAlgo_ArgumentAnalyzer: self-interference; Parasolid: face-face "
      "inconsistency, or general body; val3dity 501, 601"},
     R"(    _____
   |     |
   |_____|___     the lower side of the small block lies
   |         |    in the upper one of the large one
   |_________|)"},
    {{"side-open", "open side",
      "A side of a patch that no other side runs along exactly, or only sides that stop short of "
      "a point of it. The surface is open there.",
      "A missing patch, a crack (control points that should be equal differ in the last digit), "
      "a side that was approximated, or is one curve with its neighbour only about.",
      "A crack: give both sides the same control points, in as many digits as it takes. A hole: "
      "add the patch.",
      "Open CASCADE BRepCheck_NotClosed, free edges; Parasolid: sheet body, laminar edge; "
      "G+Smo: boundary of a multipatch"},
     R"(  +-----+-----+
  |     |     :    the side : of the left patch has no mate:
  |     |     :    its neighbour is missing, or is near only
  +-----+-----+)"},
    {{"side-direction", "sides that run in one direction",
      "Two sides are the same curve and run along it in the same direction: the normals "
      "dS/du x dS/dv of their patches are on opposite sides of the surface.",
      "A patch with u and v exchanged, one mirrored copy, a one-sided surface, which no "
      "orientation cures.",
      "veritope certify --orient auto reverses patches, not volumes, and lists them; or exchange u "
      "and v of the patches that disagree.",
      "Open CASCADE BRepCheck_BadOrientationOfSubshape; Parasolid: inconsistent face normals; "
      "val3dity 307"},
     R"(  +--->-+--->-+
  | (+) | (-) |    both patches pass the common side upwards
  +-<---^-----+)"},
    {{"side-overused", "more than two sides on one curve",
      "Three sides or more are one curve: more than two patches meet along it.",
      "Solids that touch along an edge, inner walls, a patch that occurs twice.",
      "Delete inner walls and copies. Where solids touch along an edge, move them apart or unite "
      "them.",
      "Open CASCADE BRepCheck_InvalidMultiConnexity; Parasolid: general body, non-manifold edge; "
      "val3dity 303"},
     R"(  +-----+
  |  1  |          both squares have the edge x,
  +-----x-----+    which four patches meet
        |  2  |
        +-----+)"},
    {{"shell-turned", "shell with the wrong side in",
      "The patches are mapped one to one and closed, but the winding number on the inner side of "
      "a shell is not 1, or not 0 on its outer side.",
      "Normals that point inward everywhere, a cavity whose normals point out of it, a solid "
      "inside of another.",
      "veritope certify --orient auto reverses whole shells of surfaces and lists the entities; it "
      "leaves volumes as they are. A solid inside of another: remove or subtract it.",
      "Open CASCADE ShapeFix_Solid orientation; Parasolid: inside-out body; val3dity 405"},
     R"(  +-------------+ -->
  |   +-----+   |
  |   |     | -->      the inner shell bounds a cavity and must
  |   +-----+   |      face inward; here both face outward
  +-------------+)"},
    {{"side-t-junction", "corner inside a side",
      "A corner of a patch lies inside a side of its neighbour, and the two run along each other "
      "there: equal maps after an affine change of parameter. Nothing gapes, but the sides are not "
      "equal one to one, as the proof needs them. Status 3.",
      "A long face beside two short ones, a surface refined on one side only, a hierarchical mesh.",
      "Insert a vertex where the message says, exactly: veritope convert --rejoin IN OUT does so "
      "at "
      "every such place and lists them.",
      "T-junction, hanging node; G+Smo: non-conforming interface"},
     R"(  +-----+-----+
  |  1  |  2  |
  +-----x-----+    a corner of 1 and 2 is x, inside the
  |     3     |    upper side of 3
  +-----------+)"},
    {{"side-parametrization", "one curve, other parameters",
      "Two sides are arcs of one curve, but pass it at other speeds, and no affine change of "
      "parameter makes them equal: equal sets are not equal maps. Or the message says that this "
      "could not be decided. Status 3.",
      "A straight edge with control points that are not evenly spread, a circle with other "
      "weights, "
      "one side that was parametrised by length.",
      "Give both sides the control points and weights of one of them, with all digits.",
      "tools with tolerances compare points, and accept such sides"},
     R"(  o--o-----------o    the same edge twice: the middle control
  o-------o------o    points o differ)"},
    {{"knot-multiplicity", "inner knot of too great multiplicity",
      "An inner knot of a surface occurs more often than its degree: the surface may break there. "
      "The message says whether it does. A proof of INVALID would be about the pieces. Status 3.",
      "Surfaces that were joined into one, knots that were inserted once too often.",
      "Remove one copy of the knot and one of the equal rows of control points, or make two "
      "surfaces "
      "of it.",
      "Open CASCADE: C-1 continuity; Parasolid: discontinuous B-surface"},
     R"(  -----------.
             |     between two rows of control points
             '---  the surface may jump)"},
    {{"patch-repeated", "patch that occurs twice",
      "Two patches have equal control points, in one of the 8 orders of a tensor patch or the 6 of "
      "a "
      "triangle. The surface passes itself everywhere there, so it bounds no solid. Where other "
      "patches share a side with both, the report says side-overused; otherwise it names the "
      "middles "
      "of the two, which have one image. Status 1, with a certificate.",
      "A face that was exported twice, the two sides of a sheet without thickness.",
      "Delete one of the two, or both if the sheet has no thickness.",
      "Open CASCADE: coincident faces; mesh tools: duplicate face"},
     R"(  +-----+
  | 1 2 |    1 and 2 are the same points
  +-----+)"},
    {{"patch-degenerate", "patch that is a point or a curve",
      "All control points of a patch are one point, or its normal is zero everywhere, so that it "
      "is "
      "a curve. Such a patch cannot be mapped one to one, so the model bounds no solid as it "
      "stands. Status 1, with a certificate that names two of its points with one image; status 3 "
      "where a curve has no such points on lines of parameters.",
      "A face that shrank to nothing, a fillet of radius zero, a sliver that was collapsed.",
      "Delete the patch, and give the patches beside it a common side.",
      "Open CASCADE BRepCheck: degenerated face; mesh tools: zero-area face"},
     R"(  +-----+
  |     x    x: four corners in one point
  +-----+)"},
    {{"singular-line", "line inside a patch that is one point",
      "A line of parameters strictly inside a patch is mapped to one point: different places of "
      "the "
      "surface have one image, so the model bounds no solid. Only a whole side of a surface may be "
      "one "
      "point. Status 1, with a certificate that names two points of the line; status 3 where the "
      "line's parameter is irrational or has a denominator over 20 bits, or where the surface is "
      "cut at it.",
      "A spindle torus, a cone that was continued through its apex, a profile that touches its "
      "axis "
      "of revolution.",
      "Cut the patch at the line and leave out what lies beyond it; keep the profile off the axis.",
      "Open CASCADE: degenerated edge inside a face; others: none"},
     R"(   \     /
    \   /
      x      all parameters of one line have the image x
    /   \
   /     \)"},
    {{"left-handed", "cell that is left-handed",
      "The Jacobian determinant of a volume is negative at a point: its axes u, v, w are oriented "
      "like a left hand. As a cell of a V-model it would count negative. Status 1 without --orient "
      "auto, which reverses such cells and lists them.",
      "Two axes that were exchanged, a mirrored copy, a writer with another order of axes.",
      "veritope certify --orient auto FILE; or exchange two axes of the volume.",
      "MFEM, Gmsh: inverted element, negative Jacobian"},
     R"(    w
    |            u and v exchanged: the other hand
    +--- u
   /
  v)"},
    {{"partial-contact", "face that is a part of a face",
      "Cells of volumes are glued along whole faces that are equal. Here a face of one cell is a "
      "part of a face of another, so that the two are not glued, although together the volumes "
      "bound a solid. Status 3.",
      "A cell that was split and its neighbour not, parts of an assembly that were meshed apart.",
      "Split the neighbour at the same parameters, so that whole faces are equal.",
      "MFEM, deal.II: hanging node; G+Smo: non-conforming interface"},
     R"(  +-----+-----+
  |  1  |  2  |
  +-----+-----+    the upper face of 3 has two parts
  |     3     |
  +-----------+)"},
    {{"folded", "volume that folds",
      "The map of a volume keeps the orientation of space at one point of its domain and reverses "
      "it at another: its Jacobian determinant has both signs. Such a volume is not mapped one to "
      "one, whatever its boundary faces do. The message has the parameters of both points. Looked "
      "for at the corners, in the middle, at 27 points of each polynomial piece, and where the "
      "coefficients of the determinant leave its sign open.",
      "A corner that was pulled too far into the volume, control points in the wrong order, a "
      "volume that was swept or ruled past itself.",
      "Move control points until the determinant has one sign; near the two points the net of "
      "control points shows what has turned over.",
      "MFEM: negative Jacobian (mesh is inverted); Gmsh: negative scaled Jacobian; finite "
      "elements: "
      "inverted element"},
     R"(  +.
  |  '.
  |  x '.    x: the upper right corner, pulled past
  |      '.  the diagonal; near it the cell is
  +--------+ inside out)"},
    {{"overlap", "cells that overlap",
      "Two points of the cells, one of them inside of its cell, are one point of space. The cells "
      "overlap, or one cell runs through itself. Status 1, with a certificate that has the one "
      "point exactly and the other one exactly or in a small box of parameters.",
      "Cells that were placed into one another and not united, a cell twice, a sweep that meets "
      "itself, a sector of more than a full turn.",
      "Move the cells apart, or leave out what is there twice.",
      "MFEM, Gmsh: not tested (each cell is looked at alone); Open CASCADE: self-interference"},
     R"(  +------+
  |   +--+---+
  |   |x |   |    x lies in both cells
  +---+--+   |
      +------+)"},
    {{"flat", "cell without volume",
      "The Jacobian determinant of a cell is zero on a whole knot span: its image is a surface, a "
      "curve or a point there. Status 1.",
      "Two opposite faces that are equal, control points that were projected or merged.",
      "Leave out the cell, or the knot span.",
      "MFEM, Gmsh: zero Jacobian; finite elements: degenerate element"},
     R"(   ________
  /_______/|    the part on the right has no
          ||    thickness)"},
    {{"curve-nonmanifold", "curve that too many faces share",
      "More than two sides of faces that are not glued pass one arc of a curve, so that the "
      "boundary is no surface there. Faces are glued that are equal as wholes; a face that is a "
      "part of another one, or the same set of points with other parameters, is not. Status 1.",
      "Cells that share only an edge, walls of neighbours that are nearly equal, a cell that was "
      "split beside one that was not.",
      "veritope convert --weld EPS where walls are nearly equal; split the neighbour where a face "
      "is a part of another; move cells apart, or let them overlap and unite them, where they "
      "share only an edge.",
      "Parasolid: non-manifold edge; MFEM, deal.II: hanging node or non-conforming interface"},
     R"(  +-----+
  |     |
  +-----x-----+    two cells share the edge x alone
        |     |
        +-----+)"},
    {{"point-nonmanifold", "point that the border has twice",
      "Corners of border faces that are no neighbours around a point, by faces and edges, are at "
      "one point. Status 1.",
      "Cells that share only a corner; two gaps between cells that meet in a corner.",
      "Move the corners apart, or fill the gap.",
      "Parasolid: non-manifold vertex; MFEM: not tested"},
     R"(  +-----+
  |     |
  +-----x-----+    two cells share the corner x alone
       |      |
       +------+)"},
    {{"singular", "point where the Jacobian determinant is zero",
      "The determinant of a cell is zero at a point, so that the model is not regular. Status 1 "
      "with --regular; without it such a model may be VALID, and the places are listed.",
      "A face that is collapsed to an axis or a pole, a smooth section that was cut into four "
      "sides, repeated control points.",
      "Leave --regular out, or build the shape of more cells (veritope build).",
      "MFEM, Gmsh: zero Jacobian at a node"},
     R"(     _____
    /     \
   |   x   |    all lines of one parameter meet in x
    \_____/)"},
    {{"contact", "cells that touch",
      "Two faces of cells touch in a point or along a part that neither's sides or corners share. "
      "The cells may be valid once they are split there: faces are glued as wholes only. Status 3.",
      "Cells that were placed side by side and not cut to fit.",
      "Split the cells so that whole faces are equal, or move them apart.",
      "MFEM, deal.II: hanging node or non-conforming interface"},
     R"(    +---+
    |   |          the small cell stands on a part
  +-+---+--+       of the large one's face
  +--------+)"},
    {{"not-certified", "neither proved nor refuted",
      "Near `where` no box with two centres sees the surface from both sides: a contact, a fold, "
      "a cusp, a vertex whose normals lie in no open half-space, or a gap below the least size. "
      "Or the message names another reason: coordinates out of range, a degree over 15, no free "
      "path from a shell.",
      "Parts that just touch, surfaces tangent to themselves, knife edges, walls that are thin for "
      "their curvature, a vertex that is a steep saddle.",
      "Where two sheets run near each other the message has their distance. At about 0 they touch: "
      "unite them or move them apart.",
      "tools with tolerances call it valid or invalid, as the tolerance has it"},
     R"(     \  /
      \/           which of the two is it?
  ----------)"},
}};

}  // namespace

std::span<const PatchExplanation> patch_explanations() { return kExplanations; }

const PatchExplanation* patch_explanation(std::string_view code) {
  const auto at = std::find_if(kExplanations.begin(), kExplanations.end(),
                               [&](const PatchExplanation& e) { return e.text.id == code; });
  return at == kExplanations.end() ? nullptr : &*at;
}

}  // namespace veritope::cli
