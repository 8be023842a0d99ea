// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/entry_path.h: paths that leave a point into exactly one cell of any arrangement of planes, and the
// half-open tetrahedra that they make: a tetrahedron contains the point if the path enters it. (Rule H of
// docs/formats/dms-files.md.)
// Source: symbolic perturbation, [EM90], of one point along a curve that lies in no plane.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <utility>

#include "predicates/exact_point.h"
#include "robust/base/sign.h"
#include "robust/cascade.h"

namespace veritope {

/// x(ε) for all small ε > 0. Immutable.
class EntryPath {
 public:
  /// x(ε) = u + (ε, ε^2, ε^3)
  static EntryPath along_axes(ExactPoint3 u) { return EntryPath(std::move(u), std::nullopt); }
  /// x(ε) = u + ε (g - u) + (ε^2, ε^3, ε^4)
  static EntryPath inward(ExactPoint3 u, ExactPoint3 g) {
    return EntryPath(std::move(u), std::move(g));
  }

  const ExactPoint3& start() const { return start_; }
  const std::optional<ExactPoint3>& target() const { return target_; }

 private:
  EntryPath(ExactPoint3 u, std::optional<ExactPoint3> g)
      : start_(std::move(u)), target_(std::move(g)) {}

  ExactPoint3 start_;
  std::optional<ExactPoint3> target_;
};

/// The sign of orient3d(a, b, c, x(ε)) for all small ε > 0. Laws:
///   (1) that of orient3d(a, b, c, path.start()) if this is not zero;
///   (2) zero iff a, b, c lie on one line: the path leaves every plane at once;
///   (3) swapping two of a, b, c negates it.
Sign orient3d_entered(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
                      const EntryPath& path, TierCounts* tally = nullptr);

/// Is x(ε) inside the tetrahedron, of either orientation, for all small ε > 0? Never for a degenerate one. If
/// tetrahedra cover a neighbourhood of the point without overlapping, exactly one of them is entered.
bool is_entered(const std::array<const ExactPoint3*, 4>& tetrahedron, const EntryPath& path,
                TierCounts* tally = nullptr);

}  // namespace veritope
