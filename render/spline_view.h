// SPDX-License-Identifier: LGPL-3.0-or-later
// render/spline_view.h: spline models for viewers: Bezier cells (.vtu) and tessellations (.obj, .gltf). These are
// pictures: everything is rounded to binary64 (gltf: binary32), trimmed surfaces are shown whole with their loops as
// lines.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/splines/spline_model.h"
#include "robust/base/box3d.h"
#include "robust/base/result.h"

namespace veritope {

enum class ViewFormat { kVtu, kObj, kGltf };

/// "vtu", "obj", "gltf" in any case.
std::optional<ViewFormat> view_format_from_name(std::string_view name);

struct ViewOptions {
  /// For obj and gltf: the aimed-at distance of chords from curves and surfaces; by default 1/1000 of the model's
  /// diagonal. For polynomial splines it is a bound up to rounding unless a span would need more than 256 pieces, for
  /// rational ones an estimate.
  std::optional<double> chord;
};

/// Vertices, polylines and triangles of one entity.
struct Tessellation {
  std::string name;
  std::vector<Point3d> points;
  std::vector<std::vector<std::uint32_t>> lines;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// One tessellation for each entity: of a volume its boundary, of trimmed surfaces and models also their loops. All
/// Bezier triangles have the same number of divisions, which the most curved one needs, so that they fit at common
/// sides.
/// @error kNotFinite for a coordinate beyond binary64, with the entity; kOverLimit for more than 2^25 points
Result<std::vector<Tessellation>> tessellate(const SplineModel& model, const ViewOptions& options);

/// @error as tessellate
Result<std::string> view_bytes(const SplineModel& model, ViewFormat format,
                               const ViewOptions& options);

/// The number of point (i, j, k) of a Bezier cell in VTK's order; degrees of one, two or three axes.
/// Source: VTK 9.1, vtkHigherOrderHexahedron::PointIndexFromIJK, vtkHigherOrderQuadrilateral and -Curve likewise.
std::size_t vtk_point_index(const std::array<std::size_t, 1>& index,
                            const std::array<int, 1>& degrees);
std::size_t vtk_point_index(const std::array<std::size_t, 2>& index,
                            const std::array<int, 2>& degrees);
std::size_t vtk_point_index(const std::array<std::size_t, 3>& index,
                            const std::array<int, 3>& degrees);

/// The index of control point b_ijk of a Bezier triangle, whose corners 0, 1, 2 are VTK's: corners, edges from corner
/// to corner, then the triangle inside, likewise. Source: VTK 9.1, vtkHigherOrderTriangle::Index with its coordinates
/// (j, k, i). REQUIRES i, j, k >= 0, not all 0.
std::size_t vtk_triangle_index(int i, int j, int k);

/// The index of control point b_ijkl of a Bezier tetrahedron, whose corners 0 to 3 are VTK's: corners, edges 01, 12,
/// 20, 03, 13, 23 from the first corner to the second, the insides of the faces 013, 231, 032, 021 as triangles of
/// these corners, then the tetrahedron inside, likewise. Source: VTK 9.1, vtkHigherOrderTetra::Index with its
/// coordinates (j, k, l, i). REQUIRES i, j, k, l >= 0, not all 0.
std::size_t vtk_tetrahedron_index(std::array<int, 4> index);

/// RFC 4648.
std::string base64(std::string_view bytes);

}  // namespace veritope
