// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/vmodel/v_face_internal.h: a face of a cell, seen in the cell's control net; how it is collapsed; when two are
// equal.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "solids/vmodel/v_model.h"

namespace veritope::internal {

/// Face 2 axis + end: its control points (i, j), i along its first parameter.
class FaceView {
 public:
  FaceView(const VVolume& cell, std::size_t number) : cell_(&cell), axes_(v_face_axes(number / 2)) {
    const Grid<3> grid = cell.grid();
    for (std::size_t k = 0; k < 2; ++k)
      size_[k] = grid.size[axes_[k]], step_[k] = grid.stride(axes_[k]);
    if (number % 2 == 1) offset_ = (grid.size[number / 2] - 1) * grid.stride(number / 2);
  }
  const VVolume& cell() const { return *cell_; }
  std::size_t axis(std::size_t k) const { return axes_[k]; }
  const KnotAxis<Rational>& knots(std::size_t k) const { return cell_->axis(axes_[k]); }
  std::size_t size(std::size_t k) const { return size_[k]; }
  bool is_rational() const { return cell_->is_rational(); }
  /// Homogeneous coordinate c, 0 to 2.
  const Rational& at(int c, std::size_t i, std::size_t j) const {
    return cell_->component(c)[place(i, j)];
  }
  /// REQUIRES is_rational().
  const Rational& weight(std::size_t i, std::size_t j) const {
    return cell_->component(3)[place(i, j)];
  }

 private:
  std::size_t place(std::size_t i, std::size_t j) const {
    return offset_ + i * step_[0] + j * step_[1];
  }

  const VVolume* cell_;
  std::array<std::size_t, 2> axes_, size_{}, step_{};
  std::size_t offset_ = 0;
};

/// A range of control points first, ..., last.
struct ControlRange {
  std::size_t first, last;
};
/// How the map whose control points these are is collapsed.
VCollapse collapse_of(const FaceView& face, ControlRange i, ControlRange j);
VCollapse collapse_of(const FaceView& face);

/// The symmetries, of those in `wanted` (bit s for symmetry s), that take the parameters of f to those of g so that the
/// maps are equal, up to one positive factor of homogeneous coordinates.
unsigned equal_symmetries(const FaceView& f, const FaceView& g, unsigned wanted);

/// The corner (x, y), x and y 0 or 1.
std::array<Rational, 3> corner_of(const FaceView& face, unsigned x, unsigned y);

/// What is equal for equal faces: from the corner points, and from exact points inside as well.
std::uint64_t corner_hash(const FaceView& face);
std::uint64_t inner_hash(const FaceView& face);

/// The face as a surface, its parameters in their order; with weights if `is_rational`.
BSplineSurface<Rational> surface_of(const FaceView& face, bool is_rational);

BSplineSurface<Rational> on_unit_square(BSplineSurface<Rational> surface);
/// The surface in the parameters to which symmetry s takes its own.
BSplineSurface<Rational> under_symmetry(BSplineSurface<Rational> face, unsigned s);
/// f under symmetry s, and g: on the unit square, in the parameters of g and in one function space; with weights if one
/// of them has some.
std::pair<BSplineSurface<Rational>, BSplineSurface<Rational>> in_common_space(const FaceView& f,
                                                                              const FaceView& g,
                                                                              unsigned s);

/// Whether the edge 4 axis + e + 2 f of the cell is collapsed.
bool is_edge_collapsed(const VVolume& cell, std::size_t edge);

/// Finds the collapses on a cell of several pieces that no certificate allows.
void find_forbidden(const VModel& model, std::size_t cell, std::vector<VForbiddenCollapse>& out);

}  // namespace veritope::internal
