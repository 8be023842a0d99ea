// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_glue.cc: P1 of docs/certificates/star-box.md: paired sides, and the numbers of X.
#include "star.h"

namespace {

typedef std::vector<Big> Curve;  // homogeneous points, X Y Z W each

Curve side(const Patch& p, int e) {  // in the direction of travel
  const int n = p.shape.side_degree(e);
  Curve c;
  for (int k = 0; k <= n; ++k) {
    const int at = p.shape.on_side(e, p.is_flipped ? n - k : k);
    c.insert(c.end(), p.net.begin() + 4 * at, p.net.begin() + 4 * at + 4);
  }
  return c;
}
bool is_point(const Curve& c) {
  for (size_t i = 4; i < c.size(); ++i)
    if (!(c[i] * c[3] == c[i % 4] * c[i - i % 4 + 3])) return false;
  return true;
}

// One degree lower, if the curve has it.
bool reduce(Curve* c) {
  const size_t n = c->size() / 4 - 1;
  if (n == 0) return false;
  Big binomial = 1, factorial = 1;
  Curve top(4);  // the n-th difference, up to sign
  for (size_t i = 0; i <= n; ++i) {
    for (size_t j = 0; j < 4; ++j) top[j] = top[j] + binomial * (*c)[4 * i + j];
    if (i < n && i > 0) factorial = factorial * Big(int64_t(i));
    binomial = -divide(binomial * Big(int64_t(n - i)), Big(int64_t(i + 1)), nullptr);
  }
  for (const Big& x : top)
    if (x.sign() != 0) return false;
  // c_i = (i r_(i-1) + (n - i) r_i) / n; (n - 1)! r_i are integers if the c_i are, as the
  // denominators n - i, n - i + 1, ... divide it.
  Curve r;
  for (size_t i = 0; i < n; ++i)
    for (size_t j = 0; j < 4; ++j) {
      Big x = Big(int64_t(n)) * (*c)[4 * i + j] * factorial;
      if (i > 0) x = x - Big(int64_t(i)) * r[4 * i - 4 + j];
      r.push_back(divide(x, Big(int64_t(n - i)), nullptr));
    }
  *c = r;
  return true;
}

std::string text(const Curve& c, bool reversed) {
  std::string s;
  for (size_t i = 0; i < c.size(); ++i) {
    const Big& x = c[reversed ? c.size() - 4 - (i - i % 4) + i % 4 : i];
    s += char(1 + x.sign());
    for (int k = 0; k < 4; ++k) s += char(uint8_t(x.m.size() >> 8 * k));
    for (uint64_t limb : x.m)
      for (int k = 0; k < 8; ++k) s += char(uint8_t(limb >> 8 * k));
  }
  return s;
}
Curve canonical(Curve c) {
  while (reduce(&c)) {
  }
  Big g;
  for (size_t i = c.size(); i-- > 0;) g = gcd(g, c[i]);
  for (Big& x : c) x = divide(x, g, nullptr);
  return c;
}

uint32_t find(std::vector<uint32_t>* parent, uint32_t i) {
  while ((*parent)[i] != i) i = (*parent)[i] = (*parent)[(*parent)[i]];
  return i;
}
void unite(std::vector<uint32_t>* parent, uint32_t i, uint32_t j) {
  i = find(parent, i), j = find(parent, j);
  (*parent)[std::max(i, j)] = std::min(i, j);
}
// Corner i of a tensor patch is where its side i starts unflipped; of a triangle, its corner i.
uint32_t end_of(const Patch& p, int e, bool last) {  // in the direction of travel
  const int n = p.shape.sides(), first = p.shape.is_triangle ? e + 1 : e;
  return uint32_t((first + (last != p.is_flipped)) % n);
}

}  // namespace

Gluing::Gluing(std::vector<Patch>* patches) {
  typedef std::pair<std::string, uint32_t> Entry;  // a side 4 patch + e, by its curve
  require(patches->size() < kNoPair / 4, "B2", "over a limit of this checker: 2^30 patches");
  std::vector<Entry> forward, backward;
  for (uint32_t i = 0; i < patches->size(); ++i) {
    Patch& p = (*patches)[i];
    std::fill(p.pair, p.pair + 4, kNoPair);
    for (int e = 0; e < p.shape.sides(); ++e) {
      const Curve c = side(p, e);
      if (is_point(c)) continue;
      const Curve key = canonical(c);
      forward.push_back(Entry(text(key, false), 4 * i + uint32_t(e)));
      backward.push_back(Entry(text(key, true), 4 * i + uint32_t(e)));
    }
  }
  std::sort(forward.begin(), forward.end());
  std::sort(backward.begin(), backward.end());
  std::vector<uint32_t> corner(4 * patches->size()), whole(patches->size());
  for (uint32_t i = 0; i < corner.size(); ++i) corner[i] = i;
  for (uint32_t i = 0; i < whole.size(); ++i) whole[i] = i;
  for (size_t i = 0; i < forward.size(); ++i) {
    const uint32_t a = forward[i].second, b = backward[i].second;
    require(i == 0 || forward[i - 1].first != forward[i].first, "P1",
            "two sides are the same curve, one of patch", a / 4);
    require(forward[i].first == backward[i].first, "P1",
            "a side has no opposite; it or another is of patch", a / 4);
    require(a != b, "P1", "a side is its own opposite, of patch", a / 4);
    Patch &p = (*patches)[a / 4], &q = (*patches)[b / 4];
    p.pair[a % 4] = std::min(a, b);  // numbered by its first side
    p.is_second[a % 4] = a > b;
    edges += a < b;
    unite(&whole, a / 4, b / 4);
    for (int last = 0; last < 2; ++last)
      unite(&corner, a / 4 * 4 + end_of(p, int(a % 4), last != 0),
            b / 4 * 4 + end_of(q, int(b % 4), last == 0));
  }
  for (uint32_t i = 0; i < patches->size(); ++i)
    for (int e = 0; e < (*patches)[i].shape.sides(); ++e)
      if ((*patches)[i].is_collapsed(e))
        unite(&corner, 4 * i + end_of((*patches)[i], e, false),
              4 * i + end_of((*patches)[i], e, true));

  std::vector<int64_t> chi(patches->size());
  std::vector<uint32_t> number(patches->size());
  for (uint32_t i = 0; i < patches->size(); ++i) {
    Patch& p = (*patches)[i];
    const uint32_t c = find(&whole, i);
    p.component = number[i] = c == i ? components++ : number[c];
    ++chi[p.component];
    for (int e = 0; e < p.shape.sides(); ++e) {
      const uint32_t at = 4 * i + uint32_t(e);
      p.vertex[e] = find(&corner, at);
      vertices += p.vertex[e] == at;
      chi[p.component] += int(p.vertex[e] == at) - int(p.pair[e] == at);
    }
  }
  for (uint32_t i = 0; i < components; ++i) {
    require(chi[i] % 2 == 0 && chi[i] <= 2, "P1", "chi is odd or over 2, of component", i);
    genus += uint64_t(1 - chi[i] / 2);
  }
}
