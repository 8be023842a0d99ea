// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/patches/patch_knots.h"

#include <algorithm>
#include <utility>

#include "solids/patches/patch_complex_internal.h"
#include "solids/patches/tied_axes.h"
#include "splines/bezier_domain.h"
#include "splines/bspline_domain.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace internal {

std::strong_ordering operator<=>(const SplineCurveForm& a, const SplineCurveForm& b) {
  if (const auto order = a.breaks <=> b.breaks; order != 0) return order;
  return a.pieces <=> b.pieces;
}

namespace {

// The pieces of the curve between the breaks where it is not one polynomial, over [0,1].
struct LongPieces {
  std::vector<Rational> ends;  // one for each piece
  std::vector<Patch::Curve> pieces;
};
LongPieces long_pieces(const BSplineCurve<Rational>& curve) {
  const auto cut = bezier_pieces(curve);
  const auto& at = cut.breaks[0];
  const Rational length = at.back() - at.front();
  LongPieces out;
  Rational begin = at.front();  // of the last piece of `out`
  for (std::size_t i = 0; i < cut.pieces.size(); ++i) {
    if (i > 0) {
      const Rational scale = Rational(1) / (at[i] - begin), end = (at[i + 1] - begin) * scale;
      if (restricted(out.pieces.back(), 0, Rational(1), end) == cut.pieces[i]) {
        out.pieces.back() = restricted(out.pieces.back(), 0, Rational(0), end);
        out.ends.back() = (at[i + 1] - at.front()) / length;
        continue;
      }
      begin = at[i];
    }
    out.pieces.push_back(cut.pieces[i]);
    out.ends.push_back((at[i + 1] - at.front()) / length);
  }
  return out;
}

}  // namespace

SplineCurveForm canonical_spline(const BSplineCurve<Rational>& curve) {
  const LongPieces found = long_pieces(curve);
  SplineCurveForm forward, backward;
  forward.breaks.assign(found.ends.begin(), found.ends.end() - 1);
  for (const Patch::Curve& piece : found.pieces) forward.pieces.push_back(directed_form(piece));
  for (std::size_t i = forward.breaks.size(); i-- > 0;)
    backward.breaks.push_back(Rational(1) - forward.breaks[i]);
  for (std::size_t i = forward.pieces.size(); i-- > 0;)
    backward.pieces.push_back(run_backwards(forward.pieces[i]));
  const auto order = forward <=> backward;
  forward.travel = order == 0 ? Travel::kBoth : Travel::kForward;
  backward.travel = Travel::kBackward;
  return order > 0 ? backward : forward;
}

std::uint64_t hash_of(const SplineCurveForm& form) {
  std::uint64_t hash = form.pieces.size();
  for (const Rational& u : form.breaks) hash = hash_step(hash, u);
  for (const CanonicalCurve& piece : form.pieces) hash = hash_step(hash, veritope::hash_of(piece));
  return hash;
}

}  // namespace internal

namespace {

using Surface = BSplineSurface<Rational>;

// One boundary: where axis `fixed` ends (end 0 or 1), along the other axis with rising parameter.
struct Boundary {
  std::uint32_t surface, fixed, end;
  friend auto operator<=>(const Boundary&, const Boundary&) = default;
};
std::uint32_t axis_along(const Boundary& b) { return 2 * b.surface + (1 - b.fixed); }

BSplineCurve<Rational> curve_of(std::span<const Surface> surfaces, const Boundary& b) {
  const Surface& s = surfaces[b.surface];
  const std::size_t at = b.end == 0 ? 0 : s.axis(b.fixed).num_control() - 1;
  return {{s.axis(1 - b.fixed)},
          s.num_components(),
          s.is_rational(),
          internal::map_lines(s, b.fixed, 1, [at](auto from, auto to) { to[0] = from[at]; })};
}
bool is_collapsed(const BSplineCurve<Rational>& curve) {
  const int degree = static_cast<int>(curve.axis(0).num_control()) - 1;
  return veritope::is_collapsed(
      Patch::Curve({degree}, curve.num_components(), curve.is_rational(),
                   {curve.coefficients().begin(), curve.coefficients().end()}));
}

void tie_equal_sides(std::span<const Surface> surfaces, internal::TiedAxes& axes) {
  std::vector<std::pair<std::uint64_t, Boundary>> hashed;
  std::vector<Travel> travel(4 * surfaces.size());
  const auto slot = [](const Boundary& b) { return 4 * b.surface + 2 * b.fixed + b.end; };
  for (std::uint32_t s = 0; s < surfaces.size(); ++s)
    for (const std::uint32_t fixed : {0u, 1u})
      for (const std::uint32_t end : {0u, 1u}) {
        const Boundary b{s, fixed, end};
        const auto curve = curve_of(surfaces, b);
        if (is_collapsed(curve)) continue;
        const auto form = internal::canonical_spline(curve);
        travel[slot(b)] = form.travel;
        hashed.emplace_back(internal::hash_of(form), b);
      }
  const auto classes = internal::equal_classes(std::move(hashed), [&](const Boundary& b) {
    return internal::canonical_spline(curve_of(surfaces, b));
  });
  for (const auto& equal : classes)
    for (std::size_t i = 1; i < equal.size(); ++i) {
      const std::uint32_t a = axis_along(equal[0]), b = axis_along(equal[i]);
      const Travel s = travel[slot(equal[0])], t = travel[slot(equal[i])];
      axes.tie(a, b, s != t);
      if (s == Travel::kBoth) axes.tie(a, b, true);  // fits in both directions
    }
}

std::vector<Rational> own_breaks(const KnotAxis<Rational>& axis) {
  std::vector<Rational> breaks = internal::breaks_of(axis);
  const Rational begin = breaks.front(), length = breaks.back() - begin;
  for (Rational& u : breaks) u = (u - begin) / length;
  return breaks;
}
void reverse_breaks(std::vector<Rational>& breaks) {
  for (Rational& u : breaks) u = Rational(1) - u;
  std::reverse(breaks.begin(), breaks.end());
}
void make_set(std::vector<Rational>& breaks) {
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
}

}  // namespace

CommonBreaks common_breaks(std::span<const Surface> surfaces) {
  internal::TiedAxes axes(2 * surfaces.size());
  tie_equal_sides(surfaces, axes);
  std::vector<std::vector<Rational>> of_root(2 * surfaces.size());
  for (std::uint32_t a = 0; a < of_root.size(); ++a) {
    const auto root = axes.find(a);
    std::vector<Rational> breaks = own_breaks(surfaces[a / 2].axis(a % 2));
    if (root.flips) reverse_breaks(breaks);
    auto& all = of_root[root.axis];
    all.insert(all.end(), breaks.begin(), breaks.end());
    if (axes.is_symmetric(root.axis)) {
      reverse_breaks(breaks);
      all.insert(all.end(), breaks.begin(), breaks.end());
    }
  }
  CommonBreaks out;
  std::vector<std::array<std::uint32_t, 2>> list_of(of_root.size());  // as it is, reversed
  for (std::size_t r = 0; r < of_root.size(); ++r) {
    if (of_root[r].empty()) continue;
    make_set(of_root[r]);
    for (const std::size_t way : {std::size_t{0}, std::size_t{1}}) {
      list_of[r][way] = static_cast<std::uint32_t>(out.lists.size());
      out.lists.push_back(of_root[r]);
      reverse_breaks(of_root[r]);
    }
  }
  for (std::uint32_t s = 0; s < surfaces.size(); ++s) {
    std::array<std::uint32_t, 2> lists;
    for (std::uint32_t a = 0; a < 2; ++a) {
      const auto root = axes.find(2 * s + a);
      lists[a] = list_of[root.axis][root.flips ? 1 : 0];
    }
    out.list_of.push_back(lists);
  }
  return out;
}

}  // namespace veritope
