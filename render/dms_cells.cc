// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/dms_cells.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <unordered_map>
#include <utility>
#include <vector>

#include "render/spline_view_internal.h"
#include "render/vtu_text_internal.h"
#include "robust/base/check.h"

namespace veritope {
namespace {

constexpr int kBezierTetrahedronType = 78;  // VTK_BEZIER_TETRAHEDRON

class DmsGrid {
 public:
  explicit DmsGrid(const DmsModel& model) : model_(model), values_(model.attributes.size()) {}

  /// The control points in VTK's order: their places in the domain, and the components there.
  Status add(std::uint32_t tetrahedron, const std::vector<std::vector<double>>& points) {
    for (const std::vector<double>& point : points) {
      connectivity_ += std::to_string(number_of(point)) + ' ';
      if (numbers_.size() > internal::kMostViewPoints)
        return internal::view_error(Code::kOverLimit, tetrahedron, "more than 33554432 points");
    }
    connectivity_ += '\n';
    num_corners_ += points.size();
    offsets_ += std::to_string(num_corners_) + '\n';
    types_ += std::to_string(kBezierTetrahedronType) + '\n';
    tetrahedra_ += std::to_string(tetrahedron) + '\n';
    for (int a = 0; a < 3; ++a) degrees_ += std::to_string(model_.degree) + (a == 2 ? '\n' : ' ');
    ++num_cells_;
    return ok_status();
  }
  DmsCells write() const {
    using internal::vtu_array;
    std::string out = internal::vtu_begin(numbers_.size(), num_cells_) + "<PointData>\n";
    for (std::size_t a = 0; a < values_.size(); ++a)
      out += vtu_array("Float64", internal::xml_text(model_.attributes[a]), 1, values_[a]);
    out += "</PointData>\n<CellData HigherOrderDegrees=\"HigherOrderDegrees\">\n" +
           vtu_array("Float64", "HigherOrderDegrees", 3, degrees_) +
           vtu_array("Int64", "tetrahedron", 1, tetrahedra_) + "</CellData>\n<Points>\n" +
           vtu_array("Float64", "Points", 3, points_) + "</Points>\n<Cells>\n" +
           vtu_array("Int64", "connectivity", 1, connectivity_) +
           vtu_array("Int64", "offsets", 1, offsets_) + vtu_array("UInt8", "types", 1, types_) +
           "</Cells>\n" + std::string(internal::kVtuEnd);
    return {std::move(out), num_cells_};
  }

 private:
  // The number of a control point: its place in the domain and the components there.
  std::size_t number_of(const std::vector<double>& point) {
    std::string key(point.size() * sizeof(double), '\0');
    for (std::size_t i = 0; i < point.size(); ++i) {
      const double x = point[i] + 0.0;  // -0 becomes 0
      std::memcpy(key.data() + i * sizeof x, &x, sizeof x);
    }
    const auto [at, is_new] = numbers_.try_emplace(std::move(key), numbers_.size());
    if (!is_new) return at->second;
    for (std::size_t c = 0; c < 3; ++c) {
      internal::append_number(points_, point[3 + c]);
      points_ += c == 2 ? '\n' : ' ';
    }
    for (std::size_t a = 0; a < values_.size(); ++a) {
      internal::append_number(values_[a], point[6 + a]);
      values_[a] += '\n';
    }
    return at->second;
  }

  const DmsModel& model_;
  std::unordered_map<std::string, std::size_t> numbers_;  // by the bytes of place and values
  std::uint64_t num_cells_ = 0, num_corners_ = 0;
  std::string points_, connectivity_, offsets_, types_, degrees_, tetrahedra_;
  std::vector<std::string> values_;
};

using Points = std::vector<std::vector<double>>;

// As DmsGrid::add takes them.
Points points_of(const std::array<DmsPoint, 4>& corners, DmsRestriction& map, int degree) {
  const auto components = map.on(corners);
  Points out(num_tetrahedral_indices(degree));
  for_each_tetrahedral_index(degree, [&](const TetrahedralIndex& index) {
    std::vector<double>& point = out[vtk_tetrahedron_index(index)];
    for (std::size_t c = 0; c < 3; ++c) {
      Rational sum;
      for (std::size_t m = 0; m < 4; ++m) sum += Rational(index[m]) * corners[m][c];
      point.push_back(nearest_double(sum / Rational(degree)));
    }
    for (const std::vector<double>& component : components)
      point.push_back(component[tetrahedral_index(index)]);
  });
  return out;
}

Result<std::vector<Points>> cells_of(DmsPolynomials& polynomials, std::uint32_t tetrahedron,
                                     int degree) {
  std::vector<Points> out;
  const auto add = [&](const DmsCell& cell, const auto& /*components*/,
                       DmsRestriction& map) -> Status {
    for (const auto& corners : cell.tetrahedra) {
      const Points& points = out.emplace_back(points_of(corners, map, degree));
      for (const std::vector<double>& point : points)
        if (!std::all_of(point.begin(), point.end(), [](double x) { return std::isfinite(x); }))
          return error_in_tetrahedron(Code::kNotFinite, tetrahedron,
                                      "a control point is too large for binary64");
    }
    return ok_status();
  };
  if (const Status status = polynomials.visit_cells(tetrahedron, add); !status)
    return status.error();
  return out;
}

}  // namespace

Result<DmsCells> dms_cells(const DmsModel& model, const DmsCellOptions& options) {
  VT_CHECK(model.num_coordinates == 3, "an attribute domain has no shape");
  DmsGrid grid(model);
  const Status status = for_each_tetrahedron<std::vector<Points>>(
      model, options,
      [&](DmsPolynomials& polynomials, std::uint32_t tetrahedron) {
        return cells_of(polynomials, tetrahedron, model.degree);
      },
      [&](std::uint32_t tetrahedron, const std::vector<Points>& cells) {
        Status added = ok_status();
        for (const Points& points : cells)
          if (added) added = grid.add(tetrahedron, points);
        return added;
      });
  if (!status) return status.error();
  return grid.write();
}

}  // namespace veritope
