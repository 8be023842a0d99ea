// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_iso_cells_internal.h: conforming tetrahedra that refine those of a domain, each with what is known of
// g - c on it.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_iso.h"
#include "solids/dms/dms_iso_form.h"
#include "solids/dms/dms_iso_local.h"
#include "solids/dms/dms_region.h"
#include "solids/dms/dms_values.h"

namespace veritope::internal {

struct IsoVertex {
  DmsPoint at;
  int sign = 0;  ///< of g - c, exactly
};

/// An edge of a cell.
struct IsoEdge {
  std::size_t number = 0;
  Rational squared_length;
};

struct IsoCell {
  std::array<std::uint32_t, 4> corners{};
  std::uint32_t tetrahedron = 0;
  bool is_alive = true;
  int off = 0;  ///< the sign of g - c on the whole cell, if that is proved; then there is no form
  int rounds = 0;           ///< cuts for the proof's sake
  bool has_shares = false;  ///< those of the form are known
  DmsIsoForm form;
};

class IsoCells {
 public:
  IsoCells(const DmsModel& model, const DmsIsoOptions& options);

  std::vector<IsoVertex> vertices;
  std::vector<IsoCell> cells;
  std::size_t num_alive = 0;

  const DmsIsoRule& rule() const { return rule_; }
  /// The corners at which g = c.
  DmsCorners zeros(const IsoCell& cell) const;
  /// Whether g grows on all cells at the vertex along one vector, which is parallel to the faces of the domain there.
  /// REQUIRES a vertex at which g = c.
  bool grows_around(std::uint32_t vertex) const;
  /// Vectors, linearly independent, that span those which are parallel to all faces of the domain at such a vertex.
  std::vector<DmsPoint> parallel_at(std::uint32_t vertex) const;
  /// Whether g = c at the vertex, and cells have it.
  bool has_star(std::uint32_t vertex) const { return at_zero_.contains(vertex); }
  /// The living cells at such a vertex.
  std::vector<std::uint32_t> star(std::uint32_t vertex) const;
  /// Cuts an edge at such a vertex, the longest.
  void cut_star(std::uint32_t vertex);
  /// The first of the longest.
  IsoEdge longest_edge(const IsoCell& cell) const;
  /// Exact, so that domains of any size and place are cut alike.
  Rational squared_length(std::uint32_t a, std::uint32_t b) const;
  /// Whether an edge of this length is longer than `within`.
  bool is_long(const Rational& squared_length) const { return squared_length > squared_within_; }
  /// Whether the cell has such an edge.
  bool is_wide(const IsoCell& cell) const;
  /// g - c at a point. REQUIRES a point of the closed domain.
  Rational value_at(const DmsPoint& point);
  DmsPoint between(std::uint32_t a, std::uint32_t b, const Rational& t) const;

  /// Cuts all cells at an edge of a cell, at the place, or if g is c there and may not be, at one of a few near
  /// the middle.
  void cut(std::uint32_t cell, std::size_t edge, const Rational& place, bool may_be_zero = false);
  /// Forgets supports whose N_γ are 0 on the closed cell: their knots do not reach into it, and they cannot jump.
  void drop_far_supports(std::uint32_t cell);
  /// Finds the shares of the cell's form.
  void add_shares(std::uint32_t cell);
  /// Cuts the cell at the plane of three knots that reach into it; where no three do, the form becomes a polynomial.
  /// False if nothing was done, and for a polynomial.
  bool cut_at_knots(std::uint32_t cell);
  std::vector<std::uint32_t> around(std::uint32_t a, std::uint32_t b) const;

 private:
  std::array<DmsPoint, 4> points(const IsoCell& cell) const;
  DmsRegion region(const IsoCell& cell) const;
  DmsIsoForm first_form(const IsoCell& cell);
  DmsIsoForm polynomial_on(const IsoCell& cell);
  void add_cell(IsoCell cell);
  using Shares = std::unordered_map<std::uint64_t, double>;
  bool may_jump(const DmsSupport& support);
  Shares shares_at(const DmsPoint& point, std::uint32_t tetrahedron);
  void set_shares(DmsIsoForm& form, std::size_t corner, const Shares& shares) const;
  bool cut_at(std::uint32_t a, std::uint32_t b, const Rational& t, bool may_be_zero);

  const DmsModel& model_;
  const DmsIsoOptions& options_;
  DmsKnotTable knots_;
  DmsEvaluator evaluator_;
  SimplexInterpolation interpolation_;
  DmsIsoRule rule_;
  Rational squared_within_;
  DmsIsoLocal local_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> at_edge_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> at_zero_;
  std::unordered_map<std::uint64_t, bool> jumps_;
};

}  // namespace veritope::internal
