// SPDX-License-Identifier: Apache-2.0 OR MIT
// invalid_sides.cc: D1 to D4 of docs/certificates/patch-invalid.md.
#include "invalid.h"

namespace {

const int kMostHalvingsOfSides = 200;

bool before(const Arc& a, const Arc& b) {
  if (a.patch != b.patch) return a.patch < b.patch;
  if (a.side != b.side) return a.side < b.side;
  return compare_dyadic(a.t.a, a.t.k, b.t.a, b.t.k) < 0;
}
bool is_on(const OuterSide& s, const Arc& a) { return s.patch == a.patch && s.e == a.side; }

// Null for an inner side, or a collapsed one.
const OuterSide* side_of(const Arc& a, const std::vector<OuterSide>& outer) {
  const auto at =
      std::lower_bound(outer.begin(), outer.end(), a, [](const OuterSide& s, const Arc& b) {
        return s.patch != b.patch ? s.patch < b.patch : s.e < b.side;
      });
  return at != outer.end() && is_on(*at, a) ? &*at : nullptr;
}

void check_arcs(const Sides& s, const std::vector<Arc>& sorted,
                const std::vector<OuterSide>& outer) {
  for (size_t i = 0; i < s.arcs.size(); ++i) {
    require(side_of(s.arcs[i], outer) != nullptr, "D1", "not on an outer side with a curve: arc",
            i);
    require(!s.arcs[i].t.is_point(), "D1", "a point: arc", i);
  }
  for (size_t i = 1; i < sorted.size(); ++i) {
    const Arc &a = sorted[i - 1], &b = sorted[i];
    require(
        a.patch != b.patch || a.side != b.side || compare_dyadic(a.t.b, a.t.k, b.t.a, b.t.k) <= 0,
        "D1", "two arcs overlap on a side of patch", a.patch);
  }
  const Part& t = s.arcs[0].t;
  require(compare_dyadic(t.a, t.k, s.at, s.k) < 0 && compare_dyadic(s.at, s.k, t.b, t.k) < 0, "D1",
          "the point is not inside the first arc");
}

Curve curve_of(const Arc& a, const OuterSide& side) {  // before the flag reverses it
  return restricted(side.curve, side.curve.size() / 4, a.t);
}
void check_curves(const Sides& s, const std::vector<OuterSide>& outer, bool has_flags,
                  uint64_t same, uint64_t opposite) {
  const OuterSide& of_first = *side_of(s.arcs[0], outer);
  const Curve first = curve_of(s.arcs[0], of_first), lowest = canonical(first);
  const std::string forward = text(lowest, of_first.is_reversed);
  const std::string backward = text(lowest, !of_first.is_reversed);
  uint64_t count[2] = {0, 0};
  for (size_t i = 0; i < s.arcs.size(); ++i) {
    const OuterSide& side = *side_of(s.arcs[i], outer);
    const Curve c = curve_of(s.arcs[i], side);
    // A copy of a patch has the same coefficients, so that its text is known.
    const bool is_copy = c == first && side.is_reversed == of_first.is_reversed;
    const std::string one = is_copy ? forward : text(canonical(c), side.is_reversed);
    require(one == forward || one == backward, "D2", "another curve than the first's: arc", i);
    ++count[one == forward ? 0 : 1];
  }
  require(count[0] == same, "D2", "arcs with the first's curve:", count[0]);
  require(count[1] == opposite, "D2", "arcs with the opposite curve:", count[1]);
  require(count[0] != 1 || count[1] != 1, "D2", "once in each direction is right");
  require(!has_flags || count[0] != 2 || count[1] != 0, "D2",
          "flags may have turned one of the two");
}

// D3: the coefficients of X' w - X w', up to binomials and a positive factor. The coefficients of
// X' are p times the differences; those of products are sums of products.
bool is_monotone(const Curve& c, int axis, bool is_rational) {
  const size_t p = c.size() / 4 - 1;
  const auto x = [&](size_t i) -> const Big& { return c[4 * i + size_t(axis)]; };
  const auto w = [&](size_t i) -> const Big& { return c[4 * i + 3]; };
  std::vector<Big> binomial(1, Big(1)), to(is_rational ? 2 * p : p);  // binomials of degree p
  for (size_t i = 0; i < p; ++i)
    binomial.push_back(divide(binomial[i] * Big(int64_t(p - i)), Big(int64_t(i + 1)), nullptr));
  for (size_t i = 0; i < p; ++i) {
    const Big dx = x(i + 1) - x(i), dw = w(i + 1) - w(i);
    // binomial(p - 1, i) = binomial(p, i) (p - i) / p; the factor 1 / p is left out.
    const Big weight = binomial[i] * Big(int64_t(p - i));
    for (size_t j = 0; j <= p && is_rational; ++j)
      to[i + j] = to[i + j] + weight * binomial[j] * (dx * w(j) - x(j) * dw);
    if (!is_rational) to[i] = dx;
  }
  for (const Big& v : to)
    if (v.sign() == 0 || v.sign() != to[0].sign()) return false;
  return true;
}

struct SideDescent {  // D4
  const Curve x;  // the point
  Units units;

  bool may_pass(const Curve& c) const {  // the point is in its closed hull
    for (size_t k = 0; k < 3; ++k) {
      bool below = false, above = false;
      for (size_t i = 0; i < c.size(); i += 4) {
        const int side = compare(c[i + k] * x[3], x[k] * c[i + 3]);
        below = below || side <= 0;
        above = above || side >= 0;
      }
      if (!below || !above) return false;
    }
    return true;
  }
  // [m, m + 1] / 2^level lies in one of the arcs.
  static bool is_in(const Big& m, int level, const Arc* first, const Arc* last) {
    const Arc* const next = std::partition_point(first, last, [&](const Arc& a) {
      return compare(shifted(Big(a.t.a), level), shifted(m, a.t.k)) <= 0;
    });
    if (next == first) return false;
    const Part& t = next[-1].t;
    return compare(shifted(m + Big(1), t.k), shifted(Big(t.b), level)) <= 0;
  }
  void visit(const Curve& c, const Big& m, int level, const Arc* first, const Arc* last) {
    units.add(1);
    if (is_in(m, level, first, last)) return;
    if (!may_pass(c)) return;
    require(level < kMostHalvingsOfSides, "D4", "another side comes too near the point");
    Curve half[2];
    halve(c, &half[0], &half[1]);
    for (int i = 0; i < 2; ++i) {
      int64_t twos = int64_t(1) << 60;
      for (const Big& v : half[i]) twos = std::min(twos, v.zeros());
      for (Big& v : half[i]) v = shifted(v, -twos);
      visit(half[i], shifted(m, 1) + Big(i), level + 1, first, last);
    }
  }
};

}  // namespace

void check_sides(const Sides& s, const std::vector<OuterSide>& outer, uint64_t num_outer,
                 bool has_flags, uint64_t same, uint64_t opposite) {
  std::vector<Arc> sorted = s.arcs;
  std::sort(sorted.begin(), sorted.end(), before);
  check_arcs(s, sorted, outer);
  check_curves(s, outer, has_flags, same, opposite);
  const OuterSide& first = *side_of(s.arcs[0], outer);
  require(is_monotone(curve_of(s.arcs[0], first), s.axis, first.is_rational), "D3",
          "the first arc is not monotone along axis", uint64_t(s.axis));
  const Curve at = restricted(first.curve, first.curve.size() / 4, Part{s.k, s.at, s.at});
  SideDescent d = {Curve(at.begin(), at.begin() + 4), {0, 2000 * (num_outer + 100), "D4"}};
  const Arc* arc = sorted.data();
  const Arc* const end = arc + sorted.size();
  for (const OuterSide& side : outer) {
    const Arc* last = arc;
    while (last != end && is_on(side, *last)) ++last;
    d.visit(side.curve, Big(0), 0, arc, last);
    arc = last;
  }
}
