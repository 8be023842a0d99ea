// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/patch_explanations.h"

#include <algorithm>
#include <array>

namespace veritope::cli {
namespace {

constexpr std::array<PatchExplanation, 6> kExplanations = {{
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
      "veritope certify --orient auto reverses patches and lists them; or exchange u and v of the "
      "patches that disagree.",
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
      "veritope certify --orient auto turns whole shells and lists the entities. A solid inside "
      "of another: remove or subtract it.",
      "Open CASCADE ShapeFix_Solid orientation; Parasolid: inside-out body; val3dity 405"},
     R"(  +-------------+ -->
  |   +-----+   |
  |   |     | -->      the inner shell bounds a cavity and must
  |   +-----+   |      face inward; here both face outward
  +-------------+)"},
    {{"not-certified", "neither proved nor refuted",
      "Near `where` no box with two centres sees the surface from both sides: a contact, a fold, "
      "a cusp, a vertex whose normals lie in no open half-space, or a gap below the least size. "
      "Or the message names another reason: coordinates out of range, a degree over 15, no free "
      "path from a shell.",
      "Parts that just touch, surfaces tangent to themselves, knife edges, sides that agree as "
      "point sets but not as curves (T-junctions), a vertex that is a steep saddle.",
      "Where sheets pass the message has their distance and the angle of their normals. At about "
      "0 they touch: unite them or move them apart. A T-junction: cut the long side in two.",
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
