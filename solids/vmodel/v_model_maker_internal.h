// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/vmodel/v_model_maker_internal.h: how a V-model is made, step by step: v_model.cc, v_gluing.cc, v_breaks.cc and
// v_counts.cc.
#pragma once
#include <optional>
#include <vector>

#include "robust/base/disjoint_sets.h"
#include "robust/base/result.h"
#include "solids/patches/tied_axes.h"
#include "solids/vmodel/v_face_internal.h"
#include "solids/vmodel/v_model.h"

namespace veritope {

/// REQUIRES that the steps are called in this order.
class VModelMaker {
 public:
  std::optional<Error> take(std::vector<VVolume> cells);
  void find_hands(VOrientation orientation);
  void find_collapses();
  void glue();
  std::optional<Error> find_breaks();
  void count();
  VModel finish() &&;

 private:
  internal::FaceView view(VFaceNumber f) const { return {m_.cells_[f / 6], f % 6}; }

  // v_gluing.cc
  std::vector<VFaceNumber> all_open_faces() const;
  unsigned right_symmetries(VFaceNumber f, VFaceNumber g) const;
  void match(const std::vector<VFaceNumber>& group);
  void match_pair(VFaceNumber f, VFaceNumber g);

  // v_breaks.cc
  void tie_axes(internal::TiedAxes& axes, VFaceNumber f) const;
  bool has_inner(std::uint32_t axis) const;
  std::vector<Rational> inner_breaks(std::uint32_t axis, bool is_reversed) const;
  std::vector<std::vector<Rational>> breaks_of_classes(internal::TiedAxes& axes) const;
  void add_missing(std::uint32_t axis, const std::vector<Rational>& all, bool is_reversed);

  // v_counts.cc
  void count_points_and_curves();

  VModel m_;
};

}  // namespace veritope
