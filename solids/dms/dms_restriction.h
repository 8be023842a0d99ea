// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_restriction.h: a polynomial map of a tetrahedron on other tetrahedra, rounded once.
#pragma once
#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "solids/dms/dms_knots.h"

namespace veritope {

/// Its blossoms, in integers: denominators are cleared first, and no greatest common divisor is taken on the way.
/// Keeps the barycentric coordinates of corners; so one thread at a time.
class DmsRestriction {
 public:
  /// components[c] has the Bernstein coefficients of component c on the tetrahedron, in the order of tetrahedral_index.
  /// REQUIRES corners that are not in one plane, 0 <= degree <= kMaxDmsDegree.
  DmsRestriction(int degree, const std::array<DmsPoint, 4>& corners,
                 std::span<const std::vector<Rational>> components);

  /// Restricts the polynomials to another tetrahedron: their coefficients there, each the nearest binary64 number.
  /// @cost for each coefficient and component a few products of integers for each lower degree
  std::vector<std::vector<double>> on(const std::array<DmsPoint, 4>& corners);

 private:
  // The barycentric coordinates of a point are numerators[m] / denominator.
  struct Weights {
    std::array<Integer, 4> numerators;
    Integer denominator;
  };
  struct Polynomial {
    std::vector<Integer> numerators;
    Integer denominator;
  };
  using Corners = std::array<const Weights*, 4>;

  const Weights& weights(const DmsPoint& point);
  void blossom(const Polynomial& net, TetrahedralIndex index, std::size_t first,
               const Corners& corners, std::vector<double>& out) const;

  int degree_;
  DmsPoint origin_;
  DmsMatrix to_unit_;
  std::vector<Polynomial> components_;
  std::map<DmsPoint, Weights> weights_;
};

}  // namespace veritope
