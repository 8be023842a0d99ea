// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_iso_form.h: bounds of an attribute and of its derivatives on a tetrahedron and on its faces and edges,
// and the rule by which a level set meets each of them as the signs at its corners say. Theory: docs/THEORY.md, DMS-1;
// docs/design/0098-isosurfaces-of-simplex-splines.md.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "interval/interval.h"
#include "solids/dms/dms_knots.h"

namespace veritope {

/// A subset of the four corners of a tetrahedron: bit m is corner m.
using DmsCorners = unsigned;
inline constexpr DmsCorners kAllCorners = 15;
/// The corners of the edges 0 to 5.
inline constexpr std::array<std::array<std::size_t, 2>, 6> kDmsEdges = {
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// What is known of g - c on a tetrahedron. If it is one polynomial: its Bernstein coefficients. If not: for each V_γ
/// near it the values at the four corners of the affine function whose multiples by N_γ add up to g - c.
struct DmsIsoForm {
  bool is_polynomial = false;
  std::vector<Interval> numbers;
  std::vector<DmsSupport> supports;  ///< of the affine functions; four numbers for each
};

/// An edge and a place on it, strictly between 0 and 1.
struct DmsIsoCut {
  std::size_t edge = 0;
  Rational place;
  bool is_extremum = false;  ///< g has an extremum along the edge there
};

/// Works on forms of one degree. @cost of each function: linear in the numbers of a form, but for find_open
class DmsIsoRule {
 public:
  explicit DmsIsoRule(int degree);

  /// An enclosure of g - c at a corner.
  static Interval at_corner(const DmsIsoForm& form, std::size_t corner);
  /// The coefficients along an edge of a polynomial, from its first corner to its second.
  std::vector<Interval> along_edge(const DmsIsoForm& form, std::size_t edge) const;
  /// 1 or -1 if g - c is proved to have this sign on the closed simplex of the corners; else 0.
  int sign_on(const DmsIsoForm& form, DmsCorners corners) const;
  /// Whether g is proved to grow strictly along a direction parallel to the simplex, everywhere on it.
  bool is_monotone_on(const DmsIsoForm& form, DmsCorners corners) const;
  /// The first of the tetrahedron, its faces and its edges for which neither is proved, if there is one.
  std::optional<DmsCorners> find_open(const DmsIsoForm& form) const;
  /// Where to cut next, if a simplex is open; with `extrema_first` at an extremum of any edge on which g - c is not
  /// proved to keep its sign. Nothing is proved of the place. REQUIRES two corners or more.
  DmsIsoCut choose_cut(const DmsIsoForm& form, DmsCorners corners, bool extrema_first) const;
  /// The forms of the parts with the point (1 - t) a + t b in the place of b, and of a, for the corners a, b of an
  /// edge.
  /// REQUIRES 0 < t < 1.
  std::pair<DmsIsoForm, DmsIsoForm> cut(const DmsIsoForm& form, std::size_t edge,
                                        const Rational& t) const;

 private:
  using Row = std::array<const Interval*, 4>;
  std::size_t widest_edge(const DmsIsoForm& form, DmsCorners corners) const;
  DmsIsoCut cut_of_edge(const DmsIsoForm& form, std::size_t edge, bool extrema_first) const;
  std::vector<Row> rows(const DmsIsoForm& form, DmsCorners corners) const;

  int degree_;
  std::vector<std::array<std::size_t, 4>> raised_;  // the coefficients γ + e_m of each γ
  std::vector<DmsCorners> used_;                    // the corners whose numbers in γ are not 0
};

}  // namespace veritope
