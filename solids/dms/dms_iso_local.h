// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_iso_local.h: an attribute on a tetrahedron as the polynomial of its own control points, plus what
// other tetrahedra add. Theory: docs/THEORY.md, DMS-4.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "solids/dms/dms_iso_form.h"
#include "solids/dms/dms_knots.h"
#include "splines/dms_blossom.h"

namespace veritope {

class DmsIsoLocal {
 public:
  /// g is the component of the model's values. Model and knots must outlive this.
  DmsIsoLocal(const DmsModel& model, const DmsKnotTable& knots, std::size_t component,
              const Rational& level);

  /// The form of g - level on a tetrahedron. `supports` are the V_γ that may reach into it, |γ| = n - 1.
  /// REQUIRES a model without defects of its clouds.
  /// @cost a blossom for each control point of the other tetrahedra of `supports`
  DmsIsoForm form(std::uint32_t tetrahedron, std::span<const DmsSupport> supports);

 private:
  using Frame = SimplexFrame<Rational>;
  Rational control(std::uint32_t tetrahedron, const TetrahedralIndex& beta) const;
  bool is_collapsed(std::uint32_t tetrahedron) const;
  std::vector<DmsPoint> knots_of(std::uint32_t tetrahedron, const TetrahedralIndex& beta) const;
  const Frame& frame(const DmsSupport& support);
  void add_rests(std::uint32_t tetrahedron, const BPatch<Rational>& own,
                 std::span<const DmsSupport> supports, DmsIsoForm& out);

  const DmsModel& model_;
  const DmsKnotTable& knots_;
  std::size_t component_;
  Rational level_;
  std::unordered_map<std::uint64_t, Frame> frames_;
};

}  // namespace veritope
