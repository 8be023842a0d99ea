// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/side_witness.h"

#include <algorithm>
#include <array>
#include <span>
#include <unordered_map>

#include "solids/patches/patch_sides.h"
#include "splines/bezier_calculus.h"
#include "splines/bezier_components.h"
#include "splines/bezier_domain.h"
#include "splines/de_casteljau.h"

namespace veritope {
namespace {

using Curve = Patch::Curve;

constexpr int kMaxHalvings = 200;
constexpr std::uint64_t kWorkPerSide = 2000;  // the bound on the certificate's page

Curve part_of(const PatchComplex& complex, const SideArc& arc) {
  return restricted(complex.patch(arc.side.patch).side(arc.side.side), 0, arc.at.lower(),
                    arc.at.upper());
}

// The arcs by side, and along each side: where very many sides coincide there are as many arcs.
class ArcsOfSides {
 public:
  explicit ArcsOfSides(const SideWitness& witness) : sorted_(witness.arcs) {
    std::sort(sorted_.begin(), sorted_.end(), [](const SideArc& a, const SideArc& b) {
      return a.side != b.side ? a.side < b.side : a.at.lower() < b.at.lower();
    });
  }
  std::span<const SideArc> of(PatchSide side) const {
    struct BySide {
      bool operator()(const SideArc& a, PatchSide b) const { return a.side < b; }
      bool operator()(PatchSide a, const SideArc& b) const { return a < b.side; }
    };
    const auto range = std::equal_range(sorted_.begin(), sorted_.end(), side, BySide());
    return {range.first, range.second};
  }
  // If any two arcs overlap, two adjacent ones do. REQUIRES that none of them is a point.
  bool are_apart() const {
    const auto overlap = [](const SideArc& a, const SideArc& next) {
      return a.side == next.side && next.at.lower() < a.at.upper();
    };
    return std::adjacent_find(sorted_.begin(), sorted_.end(), overlap) == sorted_.end();
  }

 private:
  std::vector<SideArc> sorted_;
};

bool holds_d1(const PatchComplex& complex, const OuterSides& outer, const SideWitness& w) {
  if (w.arcs.empty() || w.axis > 2 || w.point_bits > 62) return false;
  for (const SideArc& arc : w.arcs) {
    if (arc.side.patch >= complex.patches().size() ||
        arc.side.side >= complex.patch(arc.side.patch).num_sides() || !is_outer(outer, arc.side) ||
        complex.is_collapsed(arc.side))
      return false;
    if (!arc.at.is_part_of_unit() || arc.at.is_point()) return false;
  }
  if (!ArcsOfSides(w).are_apart()) return false;
  const Rational t = DyadicInterval{w.point_bits, w.point, w.point}.lower();
  return w.arcs[0].at.lower() < t && t < w.arcs[0].at.upper();
}

// Whether the second side is given by the same numbers as the first one, or by the same run backwards: then what is
// known of one need not be found out about the other.
bool have_equal_numbers(const PatchComplex& complex, PatchSide a, PatchSide b, bool is_back) {
  const Patch &p = complex.patch(a.patch), &q = complex.patch(b.patch);
  const std::size_t n = p.side_length(a.side);
  if (n != q.side_length(b.side) || p.is_rational() != q.is_rational()) return false;
  for (int c = 0; c < (p.is_rational() ? 4 : 3); ++c) {
    const std::span<const Rational> x = p.component(c), y = q.component(c);
    for (std::size_t i = 0; i < n; ++i)
      if (!(x[p.side_index(a.side, i)] == y[q.side_index(b.side, is_back ? n - 1 - i : i)]))
        return false;
  }
  return true;
}
bool have_equal_numbers(const PatchComplex& complex, const SideArc& a, const SideArc& b,
                        bool is_back) {
  return b.at == (is_back ? a.at.mirrored() : a.at) &&
         have_equal_numbers(complex, a.side, b.side, is_back);
}

bool holds_d2(const PatchComplex& complex, const SideWitness& w) {
  const CanonicalCurve first = directed_form(part_of(complex, w.arcs[0])),
                       back = run_backwards(first);
  const bool is_both = first == back;
  std::uint32_t same = 0, opposite = 0;
  for (const SideArc& arc : w.arcs) {
    if (have_equal_numbers(complex, w.arcs[0], arc, false)) {
      ++same;
      continue;
    }
    if (have_equal_numbers(complex, w.arcs[0], arc, true)) {
      ++(is_both ? same : opposite);
      continue;
    }
    const CanonicalCurve curve = directed_form(part_of(complex, arc));
    if (curve == first) {
      ++same;
    } else if (curve == back) {
      ++opposite;
    } else {
      return false;
    }
  }
  return same == w.same && opposite == w.opposite && !(same == 1 && opposite == 1);
}

bool holds_d3(const PatchComplex& complex, const SideWitness& w) {
  const Curve curve = part_of(complex, w.arcs[0]);
  const Curve points = numerators(curve);
  Curve slope = derivative(points, 0);
  if (curve.is_rational()) {
    const Curve weights = weight(curve);
    slope = difference(multiplied(weights, slope), multiplied(derivative(weights, 0), points));
  }
  const auto along = slope.component(w.axis);
  return std::all_of(along.begin(), along.end(), [&](const Rational& v) {
    return v.sign() != Sign::kZero && v.sign() == along[0].sign();
  });
}

// The parts of sides that come near a point, halved until they do not.
class PassSearch {
 public:
  PassSearch(const PatchComplex& complex, const SideWitness& witness, const PatchPoint& point,
             std::uint64_t most)
      : complex_(complex), arcs_(witness), point_(point), most_(most) {}

  // Whether some part of the side outside of all arcs cannot be kept away from the point.
  bool may_pass(PatchSide side) {
    const std::span<const SideArc> arcs = arcs_.of(side);
    if (arcs.size() == 1 && arcs.front().at == DyadicInterval::whole()) return ++visits_ > most_;
    if (!arcs.empty()) return examine(side);
    const auto [known, is_new] = known_.try_emplace(complex_.edge(side), Known{side, 0});
    if (!is_new && have_equal_numbers(complex_, known->second.side, side, false)) {
      visits_ += known->second.visits;
      return visits_ > most_;
    }
    const std::uint64_t before = visits_;
    if (examine(side)) return true;
    known->second = {side, visits_ - before};
    return false;
  }

 private:
  // A side that does not pass, and the work that it took.
  struct Known {
    PatchSide side;
    std::uint64_t visits;
  };

  bool examine(PatchSide side) {
    const Patch& patch = complex_.patch(side.patch);
    const auto at = [&](int c, std::size_t i) -> const Rational& {
      return patch.component(c)[patch.side_index(side.side, i)];
    };
    // The whole side comes first, without a copy of its coefficients.
    if (is_away(patch.side_length(side.side), patch.is_rational(), at)) return ++visits_ > most_;
    return may_pass(arcs_.of(side), patch.side(side.side), {0, 0, 1}, 0);
  }

  // A part of the side that has these arcs.
  bool may_pass(std::span<const SideArc> arcs, const Curve& curve, const DyadicInterval& at,
                int halvings) {
    if (++visits_ > most_) return true;
    for (const SideArc& arc : arcs)
      if (arc.at.lower() <= at.lower() && at.upper() <= arc.at.upper()) return false;
    const auto coefficient = [&](int c, std::size_t i) -> const Rational& {
      return curve.component(c)[i];
    };
    if (is_away(static_cast<std::size_t>(curve.degree(0)) + 1, curve.is_rational(), coefficient))
      return false;
    // Dyadic intervals have at most 62 bits; a certificate's checker may go to kMaxHalvings.
    if (halvings >= std::min(kMaxHalvings, 62)) return true;
    const auto [left, right] = split(curve, 0, Rational(1) / Rational(2));
    const std::uint64_t middle = at.lo + at.hi;
    return may_pass(arcs, left, {at.bits + 1, 2 * at.lo, middle}, halvings + 1) ||
           may_pass(arcs, right, {at.bits + 1, middle, 2 * at.hi}, halvings + 1);
  }

  // Whether the closed hull of the control points does not contain the point.
  template <typename Coefficient>
  bool is_away(std::size_t n, bool is_rational, Coefficient coefficient) const {
    for (int c = 0; c < 3; ++c) {
      const Rational& x = point_[static_cast<std::size_t>(c)];
      std::size_t below = 0, above = 0;
      for (std::size_t i = 0; i < n && (below == 0 || above == 0); ++i) {
        const auto order =
            coefficient(c, i) <=> (is_rational ? x * coefficient(3, i) : Rational(x));
        below += order <= 0 ? 1 : 0;
        above += order >= 0 ? 1 : 0;
      }
      if (below == 0 || above == 0) return true;
    }
    return false;
  }

  const PatchComplex& complex_;
  ArcsOfSides arcs_;
  const PatchPoint& point_;
  std::uint64_t most_, visits_ = 0;
  std::unordered_map<std::uint32_t, Known> known_;  // by edge
};

bool holds_d4(const PatchComplex& complex, const OuterSides& outer, const SideWitness& w) {
  std::uint64_t num_outer = 0;
  const auto for_each_side = [&](auto visit) {
    for (std::uint32_t p = 0; p < complex.patches().size(); ++p)
      for (std::uint32_t s = 0; s < complex.patch(p).num_sides(); ++s)
        if (is_outer(outer, {p, s})) visit(PatchSide{p, s});
  };
  for_each_side([&](PatchSide) { ++num_outer; });
  const PatchPoint point = point_of(complex, w);
  PassSearch search(complex, w, point, kWorkPerSide * (num_outer + 100));
  bool is_alone = true;
  for_each_side([&](PatchSide side) {
    is_alone = is_alone && (complex.is_collapsed(side) || !search.may_pass(side));
  });
  return is_alone;
}

}  // namespace

std::optional<SideCondition> broken_condition(const PatchComplex& complex, const OuterSides& outer,
                                              const SideWitness& w) {
  if (!holds_d1(complex, outer, w)) return SideCondition::kD1;
  if (!holds_d2(complex, w)) return SideCondition::kD2;
  if (!holds_d3(complex, w)) return SideCondition::kD3;
  if (!holds_d4(complex, outer, w)) return SideCondition::kD4;
  return std::nullopt;
}

PatchPoint point_of(const PatchComplex& complex, const SideWitness& w) {
  const PatchSide side = w.arcs.front().side;
  const Rational t = DyadicInterval{w.point_bits, w.point, w.point}.lower();
  const std::vector<Rational> at =
      evaluate<Rational, 1>(complex.patch(side.patch).side(side.side), {t});
  return point_of(std::span<const Rational>(at)).value();
}

SideWitness with_reversed(const PatchComplex& complex, const std::vector<bool>& is_reversed,
                          SideWitness w) {
  if (is_reversed[w.arcs.front().side.patch])
    w.point = (std::uint64_t{1} << w.point_bits) - w.point;
  for (SideArc& arc : w.arcs) {
    if (!is_reversed[arc.side.patch]) continue;
    arc.side.side = complex.patch(arc.side.patch).num_sides() - 1 - arc.side.side;
    arc.at = arc.at.mirrored();
  }
  return w;
}

}  // namespace veritope
