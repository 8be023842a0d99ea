// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/patch_cells.h"

#include <algorithm>
#include <cmath>

#include "render/spline_view_internal.h"
#include "render/vtu_text_internal.h"

namespace veritope {
namespace {

constexpr int kCurveCellType = 75;      // VTK_BEZIER_CURVE
constexpr int kQuadrilateralType = 77;  // VTK_BEZIER_QUADRILATERAL
constexpr std::size_t kPieceBytes = std::size_t{1} << 20;

// Text that is written whenever enough has come together.
class PiecewiseText {
 public:
  explicit PiecewiseText(const std::function<Status(std::string_view)>& write) : write_(write) {}
  std::string& text() { return text_; }
  void flush_if(bool is_needed) {
    if (!is_needed || !status_) return;
    status_ = write_(text_);
    text_.clear();
  }
  void next() { flush_if(text_.size() >= kPieceBytes); }
  void open_array(const char* type, std::string_view name, int components) {
    text_ += std::string("<DataArray type=\"") + type + "\" Name=\"" + std::string(name) +
             "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"ascii\">\n";
  }
  void close_array() { text_ += "</DataArray>\n"; }
  Status finish() {
    flush_if(true);
    return status_;
  }

 private:
  const std::function<Status(std::string_view)>& write_;
  std::string text_;
  Status status_ = ok_status();
};

// VTK's number of a control point; that of a curve if the second degree is 0.
std::size_t vtk_number(const std::array<std::size_t, 2>& at, const std::array<int, 2>& degrees) {
  if (degrees[1] == 0)
    return vtk_point_index(std::array<std::size_t, 1>{at[0]}, std::array<int, 1>{degrees[0]});
  return vtk_point_index(at, degrees);
}

std::size_t num_points_of(const std::array<int, 2>& degrees) {
  return static_cast<std::size_t>(degrees[0] + 1) * static_cast<std::size_t>(degrees[1] + 1);
}

}  // namespace

Status PatchCells::Part::add(const BezierSurface<Rational>& surface,
                             const std::vector<std::int64_t>& values) {
  const Grid<2> grid = surface.grid();
  std::vector<std::size_t> order(grid.count());
  for (std::size_t n = 0; n < order.size(); ++n)
    order[vtk_number(grid.index_of(n), surface.degrees())] = n;
  for (const std::size_t n : order) {
    const Rational weight = surface.is_rational() ? surface.component(3)[n] : Rational(1);
    for (int c = 0; c < 3; ++c) {
      const double x = nearest_double(surface.component(c)[n] / weight);
      if (!std::isfinite(x))
        return Error{Code::kNotFinite, {}, "a control point is too large for binary64"};
      internal::append_number(points_, x);
      points_ += c == 2 ? '\n' : ' ';
    }
    if (surface.is_rational()) weights_.push_back(nearest_double(weight));
  }
  cells_.push_back({surface.degrees(), surface.is_rational()});
  values_.insert(values_.end(), values.begin(), values.end());
  return ok_status();
}

std::string PatchCells::begin(std::uint64_t num_points, std::uint64_t num_cells) {
  return internal::vtu_begin(num_points, num_cells) +
         "<Points>\n<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" "
         "format=\"ascii\">\n";
}

std::string PatchCells::take(Part part) {
  cells_.insert(cells_.end(), part.cells_.begin(), part.cells_.end());
  weights_.insert(weights_.end(), part.weights_.begin(), part.weights_.end());
  values_.insert(values_.end(), part.values_.begin(), part.values_.end());
  return std::move(part.points_);
}

Status PatchCells::end(const std::function<Status(std::string_view)>& write) const {
  PiecewiseText out(write);
  out.text() = "</DataArray>\n</Points>\n<Cells>\n";
  out.open_array("Int64", "connectivity", 1);
  std::uint64_t point = 0;
  for (const Part::Cell& cell : cells_) {
    for (std::size_t n = 0; n < num_points_of(cell.degrees); ++n)
      out.text() += std::to_string(point++) + ' ';
    out.text() += '\n';
    out.next();
  }
  out.close_array();
  out.open_array("Int64", "offsets", 1);
  point = 0;
  for (const Part::Cell& cell : cells_) {
    out.text() += std::to_string(point += num_points_of(cell.degrees)) + '\n';
    out.next();
  }
  out.close_array();
  out.open_array("UInt8", "types", 1);
  for (const Part::Cell& cell : cells_) {
    out.text() += std::to_string(cell.degrees[1] == 0 ? kCurveCellType : kQuadrilateralType) + '\n';
    out.next();
  }
  out.close_array();
  out.text() += "</Cells>\n<PointData RationalWeights=\"RationalWeights\">\n";
  out.open_array("Float64", "RationalWeights", 1);
  std::size_t weight = 0;
  for (const Part::Cell& cell : cells_)
    for (std::size_t n = 0; n < num_points_of(cell.degrees); ++n, out.next()) {
      internal::append_number(out.text(), cell.is_rational ? weights_[weight++] : 1.0);
      out.text() += '\n';
    }
  out.close_array();
  out.text() += "</PointData>\n<CellData HigherOrderDegrees=\"HigherOrderDegrees\">\n";
  out.open_array("Float64", "HigherOrderDegrees", 3);
  for (const Part::Cell& cell : cells_) {
    out.text() += std::to_string(cell.degrees[0]) + ' ' +
                  std::to_string(std::max(cell.degrees[1], 1)) + " 1\n";
    out.next();
  }
  out.close_array();
  for (std::size_t k = 0; k < names_.size(); ++k) {
    out.open_array("Int64", names_[k], 1);
    for (std::size_t n = k; n < values_.size(); n += names_.size(), out.next())
      out.text() += std::to_string(values_[n]) + '\n';
    out.close_array();
  }
  out.text() += "</CellData>\n" + std::string(internal::kVtuEnd);
  return out.finish();
}

}  // namespace veritope
