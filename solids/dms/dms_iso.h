// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_iso.h: the surface on which an attribute of a simplex-spline solid has a value, as triangles, with a
// proof of its topology. Theory: docs/THEORY.md, DMS-4. Design: docs/design/0098-isosurfaces-of-simplex-splines.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "solids/dms/dms_model.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

struct DmsIsoOptions {
  std::size_t attribute = 0;
  Rational level;
  Rational within = Rational(1);  ///< cells that the surface crosses are not wider
  bool in_solid = false;          ///< vertices are mapped
  /// What maps them: the model itself if null; that to which an attribute domain belongs.
  const DmsModel* map = nullptr;
  bool keeps_places = false;  ///< the vertices in the domain, exact, are wanted, too
  std::size_t max_cells = 20'000;
  int max_rounds = 90;  ///< cuts of one cell after another for the proof's sake
};

enum class DmsIsoDoubt {
  kVertex,  ///< the attribute has the level's value at a corner
  kOpen,    ///< on the cell, a face or an edge neither a sign nor a direction of growth was found
  kWide,    ///< the cell is wider than demanded
};
/// "vertex", "open", "wide"
const char* doubt_name(DmsIsoDoubt doubt);

struct DmsIsoCell {
  std::uint32_t tetrahedron = 0;  ///< of the domain of the attribute
  std::array<DmsPoint, 4> corners;
  DmsIsoDoubt why = DmsIsoDoubt::kOpen;
};

struct DmsIso {
  /// Triangles turn counterclockwise as seen from where the attribute is less.
  TriangleMesh mesh;
  /// The points of the closed domain that are the vertices, or whose images they are, before rounding; with
  /// keeps_places.
  std::vector<DmsPoint> places;
  /// The level set in the domain is isotopic to the triangles before rounding: `components` and `euler` are its own.
  bool certified = false;
  /// "control-disagrees": the attribute's separate control points of two tetrahedra differ where shared ones would be
  /// one, so that it may jump, and nothing is certified.
  std::optional<std::string> obstacle;
  std::uint64_t components = 0;
  std::int64_t euler = 0;
  std::uint64_t cells = 0;
  std::uint64_t num_undecided = 0;
  std::vector<DmsIsoCell> undecided;  ///< the first ones
};

/// @param model  one that has the attribute: for an attribute over a domain of its own the attribute domain
/// REQUIRES a model without defects of its domain and its clouds (solids/dms/dms_defects.h), attribute <
/// model.attributes.size(), within > 0.
/// @error kNotFinite for a vertex beyond binary64, with the tetrahedron as the entity
/// @cost  a form of each cell: at most max_cells of them, and those of one more edge
Result<DmsIso> find_dms_iso(const DmsModel& model, const DmsIsoOptions& options,
                            std::size_t max_listed = 100);

}  // namespace veritope
