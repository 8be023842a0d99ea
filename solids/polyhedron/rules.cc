// SPDX-License-Identifier: LGPL-3.0-or-later
// The texts of the rules. docs/rules/ says the same at length, with pictures.
#include "solids/polyhedron/rules.h"

#include "robust/base/check.h"

namespace veritope {
namespace {

constexpr std::array<RuleText, kNumMeshRules> kTexts = {{
    {"M1", "degenerate face",
     "A face whose three corners lie on one line exactly, or of which two are the same vertex. "
     "It has no area and no normal.",
     "Rounding on export (a thin face collapses in binary32), welding of nearby vertices, a "
     "vertex that repeats in a polygon, a polygon whose fan starts on a straight side.",
     "Collapse the shortest edge, or flip the longest one. Deleting the face opens the surface. "
     "Export doubles, or text with 17 digits.",
     "CGAL is_degenerate_triangle_face; val3dity 101/102; trimesh nondegenerate_faces; "
     "admesh \"degenerate facets\"; Parasolid: degenerate geometry"},
    {"M2", "duplicate face",
     "A face with the same three vertices as an earlier face, in either orientation. Each later "
     "copy counts once.",
     "A model merged with itself, a part saved twice, a double-sided sheet, the wall that two "
     "glued solids have in common.",
     "Same orientation: delete the copy. Opposite orientations: delete both.",
     "CGAL merge_duplicate_polygons_in_polygon_soup; val3dity 303; trimesh unique_faces; "
     "gmsh -check \"duplicate\"; Parasolid: face-face inconsistency"},
    {"M3", "boundary edge",
     "An edge that exactly one face has. The surface is open there and encloses no volume.",
     "A missing face, a crack (two vertices that should be equal differ in the last digit), "
     "a T-junction, a sheet that was never meant to be a solid.",
     "Weld cracks; fill holes. The reported distance to the nearest open edge tells them apart.",
     "CGAL is_closed, border halfedge; val3dity 302; trimesh is_watertight; admesh \"facets with "
     "1 edge disconnected\"; Parasolid: sheet body, laminar edge"},
    {"M4", "edge with more than two faces",
     "An edge that three faces or more have. No side of the surface is the inside there.",
     "Solids that touch along an edge and were welded, inner walls, duplicate or left-over faces.",
     "Delete inner walls. Where two solids touch along an edge, move them apart or unite them.",
     "CGAL non-manifold edge (is_polygon_soup_a_polygon_mesh); val3dity 303; trimesh "
     "is_watertight; Parasolid: general body, non-manifold edge"},
    {"M5", "misoriented edge",
     "An edge with exactly two faces that run along it in the same direction: their normals are "
     "on opposite sides of the surface.",
     "Faces turned over by a mirror, a modeller that ignores orientation, a one-sided surface "
     "(Moebius strip, Klein bottle), which no orientation can cure.",
     "veritope certify --orient auto reverses the faces that disagree, if nothing else is wrong, "
     "and certifies the file so; or reverse their vertex order in the file, shell by shell.",
     "CGAL orient_polygon_soup; val3dity 307; trimesh is_winding_consistent; admesh \"facets "
     "reversed\"; Parasolid: inconsistent face normals"},
    {"M6", "vertex with several fans",
     "A vertex whose faces, connected through edges at the vertex, form more than one fan: parts "
     "of the surface touch in this point only.",
     "Solids that touch in a corner and were welded, hour-glass shapes, a tunnel of width zero.",
     "Give each fan a vertex of its own and move them apart; equal positions are one vertex.",
     "CGAL is_non_manifold_vertex; val3dity 303; MeshLab \"non manifold vertices\"; "
     "Parasolid: general body, non-manifold vertex"},
    {"M7", "improper intersection",
     "An unordered pair of non-degenerate faces with a common point outside their common vertex "
     "or edge: they cross, overlap, or touch. Each pair counts once.",
     "Parts pushed through one another without a Boolean union, folds and spikes after "
     "smoothing or decimation, rounding on export, parts that just touch.",
     "Unite overlapping parts with an exact Boolean. For folds, remesh the neighbourhood. The "
     "exact point and the size say how deep it is.",
     "CGAL does_self_intersect; val3dity 306; MeshLab \"self intersecting faces\"; trimesh and "
     "admesh do not look; Parasolid: face-face inconsistency"},
    {"M8", "inward outer shell",
     "A shell that lies inside no other shell and whose normals point into the solid: its "
     "signed volume is negative. Decided if M1 to M7 hold.",
     "A mirrored model, the other convention for the order of vertices, a cavity whose outer "
     "shell is missing.",
     "veritope certify --orient auto reverses the shell, if nothing else is wrong, and certifies "
     "the file so; or reverse all faces of the shell in the file.",
     "CGAL is_outward_oriented; val3dity 405; trimesh volume < 0; admesh reverses it silently; "
     "Parasolid: inside-out body"},
    {"M9", "shell nested with the wrong side",
     "A shell inside others whose side does not fit its depth: shells must alternate outward, "
     "inward, outward with depth. Decided if M1 to M7 hold.",
     "A cavity with the normals of a solid, a part put inside another one without subtracting "
     "it, left-over inner shells.",
     "A cavity: reverse its faces, or let veritope certify --orient auto do so. A part that is "
     "buried: delete it.",
     "CGAL does_bound_a_volume; val3dity 405; trimesh, admesh do not look; "
     "Parasolid: region with bad shells"},
}};

}  // namespace

const RuleText& rule_text(MeshRule rule) {
  VT_CHECK(rule_index(rule) < kNumMeshRules, "no such rule");
  return kTexts[rule_index(rule)];
}

std::optional<MeshRule> rule_from_id(std::string_view id) {
  if (id.size() != 2 || (id[0] != 'M' && id[0] != 'm')) return std::nullopt;
  if (id[1] < '1' || id[1] > '9') return std::nullopt;
  return static_cast<MeshRule>(id[1] - '0');
}

MeshRule rule_of(const Finding& defect) {
  const std::optional<MeshRule> rule = rule_from_id(defect.code);
  VT_CHECK(rule.has_value(), "a defect of a mesh has the code of a rule");
  return *rule;
}

}  // namespace veritope
