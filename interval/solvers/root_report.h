// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/solvers/root_report.h: what the solvers of systems of equations answer. Proofs: docs/THEORY.md, ROOT-1,
// ROOT-2.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "interval/exact_box.h"

namespace veritope {

/// Where a root lies in the closed domain. Intervals cannot show that a root is on a face, only that it is near.
enum class RootPlace {
  kInside,      ///< proved: in the open domain
  kOnBoundary,  ///< proved: on a face, in the closed domain
  kAtBoundary,  ///< no farther from a face than its box is wide: on it, inside or outside
};

/// Proved: in `unique_in` the system has exactly one root, it is simple, and it lies in `box`, a subset of `unique_in`.
/// `unique_in` may extend beyond the domain: there the equations are continued by the same formulas.
template <std::size_t N>
struct IsolatedRoot {
  ExactBox<N> box, unique_in;
  RootPlace place = RootPlace::kInside;
  std::optional<std::array<Rational, N>>
      exact;  ///< the root, if it is proved to be this short fraction
};

/// Why a part of the domain was left undecided.
enum class OpenReason {
  kNarrow,       ///< as small as least_width: a multiple root, or roots closer than that
  kPrecision,    ///< max_precision bits do not tell the equations from dependent ones here
  kBudget,       ///< max_boxes had been examined
  kZeroEquation  ///< an equation is identically zero: its roots are not isolated points
};

/// A part of the domain where roots were neither isolated nor excluded.
template <std::size_t N>
struct RootCluster {
  ExactBox<N> box;
  OpenReason reason = OpenReason::kNarrow;
  std::optional<std::array<Rational, N>> exact;  ///< a proved root in the cluster; empty if unknown
};

struct SolverEffort {
  std::uint64_t boxes = 0;   ///< examined
  std::uint64_t frames = 0;  ///< parts whose equations were computed anew from the exact ones
  int precision = 53;        ///< the most bits that were used
};

struct SolverOptions {
  std::uint64_t max_boxes = 100000;
  int max_precision = 4096;
  /// Roots closer than this may end in one cluster. > 0.
  Rational least_width = Rational::power_of_two(-80);
  /// Roots are refined to boxes at most this wide. > 0.
  Rational root_width = Rational::power_of_two(-40);
};

/// Every root in the closed domain lies in exactly one roots[i].box, or in clusters; no two roots[i] are the same root.
/// A root of the equations outside of the domain is reported only as kAtBoundary. The rest of the domain is proved free
/// of roots.
template <std::size_t N>
struct RootReport {
  std::vector<IsolatedRoot<N>> roots;
  std::vector<RootCluster<N>> clusters;
  SolverEffort effort;

  bool is_complete() const { return clusters.empty(); }
};

}  // namespace veritope
