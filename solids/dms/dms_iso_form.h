// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_iso_form.h: bounds of an attribute and of its derivatives on a tetrahedron and on its faces and edges,
// and the rule by which a level set meets each of them as the signs at its corners say. Theory: docs/THEORY.md, DMS-4;
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

/// What is known of g - c on a tetrahedron: it is p + Σ N_γ r_γ, where the N_γ >= 0 add up to at most 1.
struct DmsIsoForm {
  std::vector<Interval> coefficients;  ///< of the polynomial p, those of Bernstein
  /// The V_γ whose knots may reach into the tetrahedron; none if all their r_γ are 0.
  std::vector<DmsSupport> supports;
  std::vector<Interval> rests;  ///< the values of each affine function r_γ at the four corners
  /// Lower bounds, at the four corners, of the limits of each N_γ from inside.
  std::vector<double> shares;

  bool is_polynomial() const { return supports.empty(); }
};

/// What the derivative of g is made of on a simplex, along its edges from one corner: it is in the hull of `polynomial`
/// plus the hull of zero and `rests`.
struct DmsIsoSlopes {
  using Slope = std::array<Interval, 3>;
  using Direction = std::array<double, 3>;

  std::vector<Slope> polynomial, rests;
  std::size_t size = 0;  ///< edges from the corner; further numbers are 0

  /// Encloses the derivative along edge k. Under a live ScopedUpward.
  Interval range(std::size_t k) const;
  /// A direction along which all may grow, or not: the mean of the polynomial's, turned to the one that is most against
  /// it. Slopes that are 0 do not count if `may_be_zero`. Nothing is proved.
  std::optional<Direction> guess_direction(bool may_be_zero = false) const;
  /// Whether all grow strictly along e; if `may_be_zero`, whether none falls. Under a live ScopedUpward.
  bool all_grow_along(const Direction& e, bool may_be_zero = false) const;
};

/// An edge and a place on it, strictly between 0 and 1.
struct DmsIsoCut {
  std::size_t edge = 0;
  Rational place;
  bool is_extremum = false;  ///< g has an extremum along the edge there
  bool touches = false;      ///< which may be c itself
};

/// Works on forms of one degree. @cost of each function: linear in the numbers of a form, but for find_open
class DmsIsoRule {
 public:
  explicit DmsIsoRule(int degree);

  /// An enclosure of g - c at a corner.
  Interval at_corner(const DmsIsoForm& form, std::size_t corner) const;
  /// The coefficients of p along an edge, from its first corner to its second.
  std::vector<Interval> along_edge(const DmsIsoForm& form, std::size_t edge) const;
  /// 1 or -1 if g - c is proved to have this sign on the closed simplex of the corners; else 0. With `zeros`, corners
  /// at which g = c, 1 if g - c >= 0.
  int sign_on(const DmsIsoForm& form, DmsCorners corners, DmsCorners zeros = 0) const;
  /// Whether g is proved to grow strictly along a direction parallel to the simplex, everywhere on it. With `zeros`
  /// whether it does not fall along a direction in which the sum of their barycentric coordinates grows.
  bool is_monotone_on(const DmsIsoForm& form, DmsCorners corners, DmsCorners zeros = 0) const;
  /// The first of the tetrahedron, its faces and its edges for which neither is proved, if there is one.
  std::optional<DmsCorners> find_open(const DmsIsoForm& form, DmsCorners zeros = 0) const;
  /// What bounds the derivative on a simplex, along the edges from its corner `first` to the others, ascending.
  DmsIsoSlopes slopes(const DmsIsoForm& form, DmsCorners corners, std::size_t first) const;
  /// Where to cut next, if a simplex is open: where the level may touch an edge; with `extrema_first` at an extremum of
  /// any edge on which g - c is not proved to keep its sign. Nothing is proved of the place. REQUIRES two corners or
  /// more.
  DmsIsoCut choose_cut(const DmsIsoForm& form, DmsCorners corners, bool extrema_first) const;
  /// The forms of the parts with the point (1 - t) a + t b in the place of b, and of a, for the corners a, b of an
  /// edge. Shares at the point are 0, which is always right.
  /// REQUIRES 0 < t < 1.
  std::pair<DmsIsoForm, DmsIsoForm> cut(const DmsIsoForm& form, std::size_t edge,
                                        const Rational& t) const;

 private:
  struct Mixture;
  std::size_t widest_edge(const DmsIsoForm& form, DmsCorners corners) const;
  std::optional<DmsIsoCut> find_touch(const DmsIsoForm& form, DmsCorners corners) const;
  std::optional<DmsIsoCut> touch_of_edge(const DmsIsoForm& form, std::size_t edge) const;
  std::optional<DmsIsoCut> touch_of_face(const DmsIsoForm& form, DmsCorners face) const;
  DmsIsoCut cut_of_edge(const DmsIsoForm& form, std::size_t edge, bool extrema_first) const;
  int sign_by_slopes(const DmsIsoForm& form, DmsCorners corners) const;
  static Mixture mixture(const DmsIsoForm& form, DmsCorners corners);
  static Interval rest_on(const DmsIsoForm& form, DmsCorners corners);

  int degree_;
  std::vector<std::array<std::size_t, 4>> raised_;  // the coefficients γ + e_m of each γ
  std::vector<DmsCorners> used_, with_;  // the corners whose numbers in γ, and in β, are not 0
};

}  // namespace veritope
