// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/vmodel_invalid_work.h: whether checkers may take a certificate of an invalid V-model: the limits on
// numbers and work of docs/certificates/vmodel-invalid.md, section 5.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "solids/vmodel/v_border_defects.h"
#include "solids/vmodel/v_overlap.h"

namespace veritope {

/// Adds up the page's units, with upper bounds for lengths of numbers that only cut pieces show.
class VInvalidWork {
 public:
  /// The points of the corners (0, 0), (1, 0), (0, 1), (1, 1) of a face.
  using FaceCorners = std::array<std::array<Rational, 3>, 4>;

  /// @param bytes  of the model; those of the body come on top of what is allowed
  VInvalidWork(const VModel& model, std::uint64_t bytes) : model_(model), bytes_(bytes) {}

  void add_box(const VBox& box);
  /// A box of knot spans and the determinant on it.
  void add_flat(std::uint32_t cell, const std::array<std::size_t, 3>& span);
  void add_arc(const VArc& arc);
  /// V1 of all cells that are near the point.
  void add_cells_near(const std::array<Rational, 3>& point);
  /// The comparisons of each of these faces with all others that are not collapsed and have a corner in `with`, or
  /// with all of the model's if `with` is null.
  void add_comparisons(std::span<const VFaceNumber> faces, const std::array<Rational, 3>* with);

  bool fits() const;

 private:
  void add_cut(const VVolume& cell, std::span<const std::size_t> axes,
               const std::array<std::array<Rational, 2>, 3>& at, bool has_intervals,
               bool has_determinant);
  void add_interval(const VVolume& cell, std::size_t axis, const std::array<Rational, 2>& at,
                    bool is_compared);
  void add_comparison(VFaceNumber f, const FaceCorners& of_f, VFaceNumber g);
  void add_face_parts(VFaceNumber f, const std::array<std::vector<Rational>, 2>& breaks);

  const VModel& model_;
  std::uint64_t bytes_, units_ = 0;
  bool is_beyond_ = false;
};

}  // namespace veritope
