// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fast/fast_tables_internal.h: the numbers of one tetrahedron's sets of knots, rounded from exact ones, with
// bounds of the errors of what is computed with them. Proofs: docs/bounds/fast_dms.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "robust/base/box3d.h"
#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_table.h"
#include "solids/dms/fast/fast_dms_internal.h"

namespace veritope::internal {

/// What the coefficients of a FastLinear lack, rounded.
struct FastLow {
  double c[4];
};

/// The greatest coefficient of barycentric coordinates, and what is added to bounds for underflow.
inline constexpr double kMostBarycentric = 0x1p40, kFloor = 0x1p-900;

/// Local coordinates (u - origin) * 2^-exponent of the points of a box, which include each exact point that rounds to a
/// binary64 one in it.
struct FastPlace {
  Box3d box;  ///< wider than what was asked for
  double origin[3];
  double scale;
  int exponent;
  double reach[3];     ///< local coordinates are at most this
  double rounding[3];  ///< and differ by at most this from those of an exact point that was rounded

  /// Nothing if the numbers are too large or too small for binary64 with room to spare.
  static std::optional<FastPlace> around(const Box3d& box);
  /// `factor` times l[0] + l[1] x + l[2] y + l[3] z, rounded. Nothing if a coefficient is beyond `most`, or too small.
  std::optional<FastLinear> round(const std::array<Rational, 4>& l, const Rational& factor,
                                  double most, FastLow* low = nullptr) const;
  /// `low`, unless it is null, has room for four.
  std::optional<FastFrame> round(const SimplexFrame<Rational>& frame, FastLow* low = nullptr) const;
};

/// Whether a coefficient can be used: 0, or not so small that products vanish.
bool is_in_range(double x, double most);

/// A value's place before a unit gives it one: nothing is 0; leaf i is 2 i + 1; node i is 2 i + 2.
using FastId = std::uint32_t;

struct FastTables {
  FastPlace place;
  std::vector<FastLeaf> leaves;
  std::vector<KnotSet> leaf_sets;
  std::vector<FastFrame> frames;
  struct Node {
    std::uint32_t frame;
    std::array<FastId, 4> part;
  };
  std::vector<Node> nodes;  ///< parts come first
  struct Top {
    KnotSet set;
    FastId at = 0;
    std::uint32_t frame = 0;
    std::array<FastId, 4> part{};
  };
  std::vector<Top> tops;
  std::vector<double> value, gradient, value_weight, gradient_weight;
  std::vector<FastLow> leaf_low, frame_low;  ///< five for each leaf, four for each frame
  std::vector<double> value_low, gradient_low;
  bool is_separate = false;
  /// By their numbers: rounded to nearest and to both sides, and whether a set of a top has them.
  std::array<Point3d, 4 * kKnotsOfCorner> knots{};
  std::array<Box3d, 4 * kKnotsOfCorner> knot_boxes{};
  std::array<bool, 4 * kKnotsOfCorner> is_used{};

  std::size_t bytes() const;
};

/// Those of a tetrahedron; nothing if its numbers are out of range. `greatest` has the greatest control value of each
/// component, rounded up.
std::optional<FastTables> make_fast_tables(const DmsModel& model, const DmsEvaluator& evaluator,
                                           std::uint32_t tetrahedron, bool with_gradient,
                                           std::span<const double> greatest);

}  // namespace veritope::internal
