// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/chain_cells.h"

#include <algorithm>
#include <cmath>

#include "render/spline_view_internal.h"
#include "render/vtu_text_internal.h"

namespace veritope {
namespace {

constexpr int kTetrahedronType = 10, kWedgeType = 80;  // VTK_TETRA, VTK_BEZIER_WEDGE

}  // namespace

std::size_t vtk_wedge_index(int i, int j, int k, int n) {
  const auto at = [](int number) { return static_cast<std::size_t>(number); };
  if (i == n || j == n || i + j == 0) return at((i == n ? 1 : j == n ? 2 : 0) + 3 * k);
  const int edge = n - 1, edges = 6 + 3 * edge * k;
  if (j == 0) return at(edges + i - 1);
  if (i + j == n) return at(edges + edge + j - 1);
  if (i == 0) return at(edges + 2 * edge + n - j - 1);
  const int interior = (n - 1) * (n - 2) / 2;
  return at(6 + 6 * edge + interior * k + i + n * (j - 1) - j * (j + 1) / 2);
}

Status ChainCells::add_point(const std::array<Rational, 3>& p, const Rational& weight) {
  if (num_points_ >= internal::kMostViewPoints)
    return Error{Code::kOverLimit, {}, "more than 33554432 points of cells"};
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = nearest_double(p[k]);
    if (!std::isfinite(x)) return Error{Code::kNotFinite, {}, "a cell reaches beyond binary64"};
    internal::append_number(points_, x);
    points_ += k == 2 ? '\n' : ' ';
  }
  internal::append_number(weights_, nearest_double(weight));
  weights_ += '\n';
  connectivity_ += std::to_string(num_points_++) + ' ';
  return ok_status();
}

void ChainCells::close_cell(const std::array<int, 3>& degrees, int type,
                            const ChainCellValues& values) {
  connectivity_ += '\n';
  for (std::size_t a = 0; a < 3; ++a)
    degrees_ += std::to_string(degrees[a]) + (a == 2 ? "\n" : " ");
  offsets_ += std::to_string(num_points_) + '\n';
  types_ += std::to_string(type) + '\n';
  kinds_ += std::to_string(values.kind) + '\n';
  coefficients_ += std::to_string(values.coefficient) + '\n';
  patches_ += std::to_string(values.patch) + '\n';
  ++num_cells_;
}

Status ChainCells::add_tetrahedron(const std::array<std::array<Rational, 3>, 4>& corners,
                                   const ChainCellValues& values) {
  for (const auto& p : corners)
    if (const Status status = add_point(p, Rational(1)); !status) return status.error();
  close_cell({1, 1, 1}, kTetrahedronType, values);
  return ok_status();
}

Status ChainCells::add_wedge(const std::array<std::array<Rational, 3>, 3>& corners,
                             const BezierTriangle<Rational>& top, const ChainCellValues& values) {
  struct WeightedPoint {
    std::array<Rational, 3> p;
    Rational weight;
  };
  const int n = top.degree();
  Rational greatest(1);  // weights are divided by it, so that binary64 has it
  if (top.is_rational())
    greatest = *std::max_element(top.component(3).begin(), top.component(3).end());
  std::vector<WeightedPoint> points(2 * top.count());
  for_each_triangle_index(n, [&](int i, int j, int k) {
    const std::size_t at = triangle_index(j, k);
    const Rational w = top.is_rational() ? top.component(3)[at] : Rational(1);
    WeightedPoint &below = points[vtk_wedge_index(j, k, 0, n)],
                  &above = points[vtk_wedge_index(j, k, 1, n)];
    below.weight = above.weight = w / greatest;
    for (std::size_t c = 0; c < 3; ++c) {
      below.p[c] = (Rational(i) * corners[0][c] + Rational(j) * corners[1][c] +
                    Rational(k) * corners[2][c]) /
                   Rational(n);
      above.p[c] = top.component(static_cast<int>(c))[at] / w;
    }
  });
  for (const WeightedPoint& p : points)
    if (const Status status = add_point(p.p, p.weight); !status) return status.error();
  close_cell({n, n, 1}, kWedgeType, values);
  return ok_status();
}

std::string ChainCells::vtu_bytes() const {
  using namespace internal;
  std::string out = vtu_begin(num_points_, num_cells_);
  out += "<PointData RationalWeights=\"RationalWeights\">\n" +
         vtu_array("Float64", "RationalWeights", 1, weights_) + "</PointData>\n";
  out += "<CellData HigherOrderDegrees=\"HigherOrderDegrees\">\n" +
         vtu_array("Float64", "HigherOrderDegrees", 3, degrees_) +
         vtu_array("Int64", "kind", 1, kinds_) +
         vtu_array("Int64", "coefficient", 1, coefficients_) +
         vtu_array("Int64", "patch", 1, patches_) + "</CellData>\n";
  out += "<Points>\n" + vtu_array("Float64", "Points", 3, points_) + "</Points>\n<Cells>\n" +
         vtu_array("Int64", "connectivity", 1, connectivity_) +
         vtu_array("Int64", "offsets", 1, offsets_) + vtu_array("UInt8", "types", 1, types_) +
         "</Cells>\n" + std::string(kVtuEnd);
  return out;
}

}  // namespace veritope
