// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_patches.cc: the patches of docs/certificates/star-box.md, section 3, that the breaks cut the
// surfaces into, and the limits of B2 on their numbers.
#include "star_extraction.h"

std::vector<Big> integers_of(const std::vector<Ratio>& v, int64_t most) {
  Big factor = 1, common;
  for (const Ratio& x : v) {
    if (x.d.is_one()) continue;
    factor = factor * divide(x.d, gcd(factor, x.d), nullptr);
    require(factor.bits() <= most, "B2", "a common denominator has more bits than", uint64_t(most));
  }
  std::vector<Big> r;
  r.reserve(v.size());
  for (const Ratio& x : v) {
    r.push_back(factor.is_one() ? x.n : x.n * divide(factor, x.d, nullptr));
    require(r.back().bits() <= most, "B2", "a number has more bits than", uint64_t(most));
  }
  for (size_t i = r.size(); i-- > 0 && !common.is_one();) common = gcd(common, r[i]);
  for (Big& x : r)
    if (!common.is_one() && common.sign() != 0) x = divide(x, common, nullptr);
  return r;
}

KnotWindow knot_window(const std::vector<Ratio>& knots, size_t p, const Ratio& a, const Ratio& b) {
  const size_t k =
      size_t(std::upper_bound(knots.begin() + int64_t(p) + 1, knots.end(), a,
                              [](const Ratio& x, const Ratio& y) { return compare(x, y) < 0; }) -
             knots.begin()) -
      1;  // knots[k] <= a < b <= knots[k + 1]
  std::vector<Ratio> from_a;
  for (size_t i = k - p + 1; i <= k + p; ++i) from_a.push_back(knots[i] - a);
  from_a.push_back(b - a);
  return KnotWindow{p, k - p, integers_of(from_a, kMostKnotBits)};
}
// By blossoms: coefficient j is the polar form at p - j times a and j times b, evaluated with the knots around the
// interval (de Boor), the steps of each level times the same factor.
Extraction extraction(const KnotWindow& window) {
  const size_t p = window.degree;
  const std::vector<Big>& t = window.from_begin;
  Extraction e = {window.first, {}};
  // Between knots that are p-fold at both ends the coefficients are the control points.
  if (t[0].sign() == 0 && t[p - 1].sign() == 0 && t[p] == t.back() && t[2 * p - 1] == t.back()) {
    e.matrix.assign(p + 1, std::vector<Big>(p + 1));
    for (size_t j = 0; j <= p; ++j) e.matrix[j][j] = 1;
    return e;
  }
  for (size_t j = 0; j <= p; ++j) {
    std::vector<std::vector<Big>> d(p + 1, std::vector<Big>(p + 1));
    for (size_t i = 0; i <= p; ++i) d[i][i] = 1;
    for (size_t r = 1; r <= p; ++r) {
      Big common = 1;
      for (size_t i = r; i <= p; ++i) {
        const Big length = t[p + i - r] - t[i - 1];
        common = common * divide(length, gcd(common, length), nullptr);
      }
      const Big at = r <= j ? t.back() : Big();
      for (size_t i = p; i >= r; --i) {
        const Big f = divide(common, t[p + i - r] - t[i - 1], nullptr);
        const Big up = f * (at - t[i - 1]), down = f * (t[p + i - r] - at);
        for (size_t c = 0; c <= p; ++c) d[i][c] = down * d[i - 1][c] + up * d[i][c];
      }
    }
    e.matrix.push_back(d[p]);
  }
  return e;
}

namespace {

// The control points i * row + j, i and j from `first` on, p times q of them, homogeneous.
std::vector<Big> window(const Entity& e, const size_t* first, size_t p, size_t q, size_t row,
                        int64_t unit) {
  const size_t components = size_t(e.components);
  std::vector<Ratio> r;
  r.reserve(4 * p * q);
  for (size_t i = 0; i < p; ++i)
    for (size_t j = 0; j < q; ++j)
      for (size_t c = 0; c < 4; ++c) {
        const uint64_t at = (first[0] + i) * row + first[1] + j;
        r.push_back(c < 3            ? scaled(e.number(at, c), -unit)
                    : c < components ? e.number(at, c)
                                     : Ratio(1));
      }
  return integers_of(r, kMostBits);
}
std::vector<Big> extracted(const Entity& e, const Extraction& u, const Extraction& v,
                           int64_t unit) {
  const size_t p = u.matrix.size(), q = v.matrix.size();  // degrees + 1
  const size_t first[2] = {u.first, v.first};
  const std::vector<Big> net = window(e, first, p, q, e.knots[1].size() - q, unit);
  std::vector<Big> half(4 * p * q), r(4 * p * q);
  for (size_t i = 0; i < p; ++i)
    for (size_t j = 0; j < q; ++j)
      for (size_t c = 0; c < 4; ++c)
        for (size_t k = 0; k < q; ++k) {
          if (v.matrix[j][k].sign() == 0) continue;  // most are, where knots are multiple
          Big& to = half[(i * q + j) * 4 + c];
          to = to + v.matrix[j][k] * net[(i * q + k) * 4 + c];
        }
  for (size_t i = 0; i < p; ++i)
    for (size_t j = 0; j < 4 * q; ++j)
      for (size_t k = 0; k < p; ++k)
        if (u.matrix[i][k].sign() != 0)
          r[i * 4 * q + j] = r[i * 4 * q + j] + u.matrix[i][k] * half[k * 4 * q + j];
  Big common;
  for (size_t i = r.size(); i-- > 0 && !common.is_one();) common = gcd(common, r[i]);
  for (Big& x : r) x = divide(x, common, nullptr);
  return r;
}

Patch patch(const Place& at, int64_t unit, const std::vector<std::vector<Ratio>>& breaks,
            std::vector<std::map<size_t, Extraction>>* cache) {
  const Entity& e = *at.entity;
  Patch r = Patch();
  r.is_rational = e.is_rational;
  r.shape = Shape{e.kind == Entity::kTriangle, int(e.degrees[0]), int(e.degrees.back())};
  if (r.shape.is_triangle) {
    std::fill(r.is_outer, r.is_outer + 4, true);
    const size_t first[2] = {0, 0};
    r.net = window(e, first, 1, size_t(r.shape.count()), 0, unit);
    return r;
  }
  const Extraction* part[2];
  for (size_t a = 0; a < 2; ++a) {
    std::map<size_t, Extraction>& known = (*cache)[2 * at.surface + a];
    const Ratio* const b = &breaks[2 * at.surface + a][at.interval[a]];
    if (known.count(at.interval[a]) == 0)
      known[at.interval[a]] = extraction(knot_window(e.knots[a], size_t(e.degrees[a]), b[0], b[1]));
    part[a] = &known[at.interval[a]];
    r.is_outer[a == 0 ? 3 : 0] = at.interval[a] == 0;
    r.is_outer[a == 0 ? 1 : 2] = at.interval[a] + 2 == breaks[2 * at.surface + a].size();
  }
  r.net = extracted(e, *part[0], *part[1], unit);
  return r;
}

}  // namespace

void cut_patches(const std::vector<Place>& places, int64_t unit,
                 const std::vector<std::vector<Ratio>>& breaks,
                 const std::function<void(Patch&&)>& use) {
  std::vector<std::map<size_t, Extraction>> cache(breaks.size());
  for (const Place& at : places) {
    Patch made = patch(at, unit, breaks, &cache);
    for (const Big& x : made.net) made.bits = std::max(made.bits, x.bits());
    require(are_short(made.shape, made.bits), "B2",
            "the coefficients are too long for their degree, bits", uint64_t(made.bits));
    use(std::move(made));
  }
}
