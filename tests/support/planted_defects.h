// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/planted_defects.h: models with defects in known places, many of them tiny, hidden or beside others: what
// pictures must show at a glance.
#pragma once
#include <string>
#include <variant>
#include <vector>

#include "io/splines/spline_model.h"
#include "solids/polyhedron/rules.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope::planted {

struct MeshModel {
  std::string name;
  TriangleMesh mesh;
  std::vector<MeshRule> rules;  ///< that it breaks
};
/// Pictures are seen along (-5, 8, -5): from the side of (5, -8, 5). "Behind" is the other one.
std::vector<MeshModel> meshes();

struct SplineExample {
  std::string name;
  SplineModel model;
  MeshRule rule;  ///< whose colour its defects have
};
std::vector<SplineExample> splines();

}  // namespace veritope::planted
