// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "render/colour_map.h"
#include "render/dms_surface_scene.h"
#include "splines/bezier_triangle.h"

namespace veritope {
namespace {

constexpr Colour kSurface{178, 190, 205};

// A piece in binary64. In the domain its corners take the place of x, y and z.
class PieceMap {
 public:
  PieceMap(const DmsBoundaryPiece& piece, bool in_solid)
      : map_(rounded(piece.map)),
        along_{directional_derivative(map_, {-1.0, 1.0, 0.0}),
               directional_derivative(map_, {-1.0, 0.0, 1.0})},
        in_solid_(in_solid) {
    for (std::size_t m = 0; m < 3; ++m)
      for (std::size_t c = 0; c < 3; ++c) corners_[m][c] = nearest_double(piece.corners[m][c]);
  }

  std::vector<double> value(const Barycentric<double>& at) const {
    std::vector<double> out = evaluate(map_, at);
    if (in_solid_) return out;
    for (std::size_t c = 0; c < 3; ++c)
      out[c] = at[0] * corners_[0][c] + at[1] * corners_[1][c] + at[2] * corners_[2][c];
    return out;
  }
  Point3d normal(const Barycentric<double>& at) const {
    std::array<Point3d, 2> d;
    for (std::size_t k = 0; k < 2; ++k) {
      const std::vector<double> slope = evaluate(along_[k], at);
      for (std::size_t c = 0; c < 3; ++c)
        d[k][c] = in_solid_ ? slope[c] : corners_[k + 1][c] - corners_[0][c];
    }
    const auto& [u, v] = d;
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  }

 private:
  static BezierTriangle<double> rounded(const BezierTriangle<Rational>& map) {
    BezierTriangle<double> out(map.degree(), map.num_components(), false);
    std::transform(map.coefficients().begin(), map.coefficients().end(), out.coefficients().begin(),
                   [](const Rational& x) { return nearest_double(x); });
    return out;
  }

  BezierTriangle<double> map_;
  std::array<BezierTriangle<double>, 2> along_;
  std::array<Point3d, 3> corners_;
  bool in_solid_;
};

int cuts_for(const std::vector<DmsBoundaryPiece>& pieces, const DmsSurfaceOptions& options) {
  constexpr double kMostTriangles = 1 << 18, kMostCuts = 24;
  if (pieces[0].map.degree() <= 1 || (!options.in_solid && !options.component)) return 1;
  const double most = std::sqrt(kMostTriangles / static_cast<double>(pieces.size()));
  return static_cast<int>(std::clamp(std::floor(most), 2.0, kMostCuts));
}

// Adds the points and triangles of a piece, and the values that colours show.
Status add_piece(const PieceMap& piece, int cuts, std::optional<std::size_t> component,
                 SceneSurface& out, std::vector<double>& values) {
  const auto first = static_cast<std::uint32_t>(out.points.size());
  for_each_triangle_index(cuts, [&](int i, int j, int k) {
    const double n = cuts;
    const Barycentric<double> at{i / n, j / n, k / n};
    const std::vector<double> value = piece.value(at);
    out.points.push_back({value[0], value[1], value[2]});
    out.normals.push_back(piece.normal(at));
    if (component) values.push_back(value[*component]);
  });
  for (std::size_t p = first; p < out.points.size(); ++p)
    for (const double x : out.points[p])
      if (!std::isfinite(x))
        return Error{Code::kNotFinite, {}, "points of the boundary are beyond binary64"};
  const auto id = [first](int j, int k) {
    return first + static_cast<std::uint32_t>(triangle_index(j, k));
  };
  for (int row = 0; row < cuts; ++row)
    for (int k = 0; k <= row; ++k) {
      const int j = row - k;
      out.triangles.push_back({id(j, k), id(j + 1, k), id(j, k + 1)});
      if (k < row) out.triangles.push_back({id(j, k), id(j, k + 1), id(j - 1, k + 1)});
    }
  return ok_status();
}

}  // namespace

Result<DmsSurfaceView> view_of_boundary(const std::vector<DmsBoundaryPiece>& pieces,
                                        const DmsSurfaceOptions& options) {
  if (pieces.empty()) return Error{Code::kEmpty, {}, "there is no boundary"};
  DmsSurfaceView out;
  out.surface.name = "boundary";
  out.surface.paints = {{kSurface, options.opacity}};
  std::vector<double> values;
  const int cuts = cuts_for(pieces, options);
  for (const DmsBoundaryPiece& piece : pieces)
    if (const Status status = add_piece(PieceMap(piece, options.in_solid), cuts, options.component,
                                        out.surface, values);
        !status)
      return status.error();
  if (!options.component) return out;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  out.range = options.range.value_or(std::array<double, 2>{*low, *high});
  const double width = out.range[1] - out.range[0];
  if (!std::isfinite(width))
    return Error{Code::kNotFinite, {}, "values of the attribute are beyond binary64"};
  for (const double v : values)
    out.surface.colours.push_back(map_colour((v - out.range[0]) / (width > 0 ? width : 1)));
  return out;
}

}  // namespace veritope
