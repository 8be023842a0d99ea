// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_s1.cc: S1 of docs/certificates/star-box.md (is_strict) and star-box-2.md, section 4.
#include "star_sheet.h"

#include "star_curve.h"
#include "star_poly.h"

namespace {

__extension__ typedef __int128 i128;

// The signs of g_c = G0 + c.G on a node.
class SignsOfG {
 public:
  SignsOfG(const Block& g, const int64_t* c)
      : g_(g), c_(c), drop_(std::max(0, bits_of(g) - 63)), length_(0) {
    for (int k = 0; k < 3; ++k) length_ += c[k] < 0 ? -i128(c[k]) : i128(c[k]);
  }
  // In most cases the highest 64 bits decide: they are G / 2^drop less e, 0 <= e < 1, where e = 0 if drop is 0.
  int sign(size_t i) const {
    const uint64_t* const g = g_.number(4 * i);
    i128 top = high(g);
    for (int k = 0; k < 3; ++k) top += i128(high(g + (k + 1) * g_.n)) * c_[k];
    if (drop_ == 0) return top < 0 ? -1 : top > 0;
    return top > length_ ? 1 : top < -length_ - 1 ? -1 : exact_sign(g);
  }

 private:
  int64_t high(const uint64_t* a) const {
    a += drop_ / 64;
    const int low = drop_ % 64;
    return int64_t(low == 0 ? a[0] : a[0] >> low | a[1] << (64 - low));
  }
  // Products are below 2^125 in absolute value, three of them and the carry below 2^127.
  int exact_sign(const uint64_t* g) const {
    i128 carry = 0;
    uint64_t any = 0;
    for (int i = 0; i < g_.n; ++i) {
      any |= uint64_t(carry);
      carry >>= 64;
      const bool is_last = i + 1 == g_.n;
      for (int k = 0; k < 4; ++k) {
        const uint64_t x = g[k * g_.n + i];
        carry += (is_last ? i128(int64_t(x)) : i128(x)) * (k == 0 ? 1 : c_[k - 1]);
      }
    }
    return carry < 0 ? -1 : (carry != 0 || any != 0) ? 1 : 0;
  }

  const Block& g_;
  const int64_t* const c_;
  const int drop_;
  i128 length_;  // |c|
};

bool is_pole(const Patch& p, const Node& node, int e) {
  return p.is_collapsed(e) && node.is_outer(p, e);
}
// Two sides of the node lie in collapsed sides of the patch and share a corner.
bool is_double_pole(const Patch& p, const Node& node) {
  const int n = p.shape.sides();
  for (int e = 0; e < n; ++e)
    if (is_pole(p, node, e) && is_pole(p, node, (e + 1) % n)) return true;
  return false;
}

bool holds_strictly(const Patch& p, Node* node, const Sheet& sheet) {
  const int sgn = p.is_reversed ? -1 : 1;
  const Shape s = shape_of_g(p);
  const SignsOfG inner(node->g, sheet.c[0]), outer(node->g, sheet.c[1]);
  std::vector<bool> left_out;
  for (int e = 0; e < s.sides(); ++e) {
    if (!is_pole(p, *node, e)) continue;
    left_out.resize(size_t(s.count()));
    for (int k = 0; k <= s.side_degree(e); ++k) left_out[size_t(s.on_side(e, k))] = true;
  }
  const auto holds = [&](uint32_t i) {
    if (!left_out.empty() && left_out[i]) return true;
    return inner.sign(i) == sgn && outer.sign(i) == -sgn;
  };
  if (!holds(node->last_fail)) return false;
  for (uint32_t i = 0; i < uint32_t(s.count()); ++i)
    if (!holds(i)) {
      node->last_fail = i;
      return false;
    }
  return true;
}

// Condition 3 fails: side e of the patch lies on a line through c.
bool is_on_line_through(const Patch& p, int e, const int64_t* c) {
  const Curve side = side_curve(p, e, false);
  const Shape s = {false, int(side.size() / 4) - 1, 0};
  Poly d[3], derivative[3];
  for (size_t k = 0; k < 3; ++k) {
    std::vector<Big> from_c;
    for (size_t i = 0; i < side.size(); i += 4)
      from_c.push_back(side[i + k] - side[i + 3] * Big(c[k]));
    d[k] = polynomial(s, from_c, -1);
    derivative[k] = polynomial(s, from_c, 0);
  }
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const Poly cross = combined(product(d[i], derivative[j]), product(d[j], derivative[i]), -1);
    for (const Big& x : cross.c)
      if (x.sign() != 0) return false;
  }
  return true;
}

// Conditions 2 and 3 where no coefficient has the wrong sign and some are zero.
bool zeros_are_allowed(const Patch& p, const Node& node, const Shape& s,
                       const std::vector<bool>& is_zero, const int64_t* c) {
  if (std::find(is_zero.begin(), is_zero.end(), false) == is_zero.end()) return false;
  for (int e = 0; e < s.sides(); ++e) {
    bool any = node.is_outer(p, e);
    for (int k = 0; k <= s.side_degree(e) && !any; ++k) any = !is_zero[size_t(s.on_side(e, k))];
    if (!any) return false;
  }
  bool touched[4] = {false, false, false, false};
  for (int corner = 0; corner < s.sides(); ++corner) {
    bool is_inner = true;
    for (int e = 0; e < s.sides(); ++e)
      if (node.touches(p, corner, e)) is_inner = false, touched[e] = true;
    const int side =
        s.is_triangle ? (corner + 2) % 3 : corner;  // the one that starts at the corner
    if (is_inner && is_zero[size_t(s.on_side(side, 0))]) return false;
  }
  for (int e = 0; e < s.sides(); ++e)
    if (touched[e] && !p.is_collapsed(e) && is_on_line_through(p, e, c)) return false;
  return true;
}
// Conditions 1 to 3 for one centre.
bool holds_weakly(const Patch& p, Node* node, const int64_t* c, int sgn) {
  const Shape s = shape_of_g(p);
  const SignsOfG signs(node->g, c);
  const auto sign = [&](uint32_t i) { return sgn * signs.sign(i); };
  if (sign(node->last_fail) < 0) return false;
  std::vector<bool> is_zero(size_t(s.count()));
  bool any_zero = false;
  for (uint32_t i = 0; i < uint32_t(s.count()); ++i) {
    const int one = sign(i);
    if (one < 0) node->last_fail = i;
    if (one < 0) return false;
    if (one == 0) any_zero = is_zero[i] = true;
  }
  // Without a zero, condition 3 holds: on a side that lies on a line through c, g_c is 0.
  return !any_zero || zeros_are_allowed(p, *node, s, is_zero, c);
}

}  // namespace

bool star_test(const Patch& p, Node* node, const Sheet& sheet, bool is_strict) {
  if (is_double_pole(p, *node)) return false;
  if (is_strict) return holds_strictly(p, node, sheet);
  const int sgn = p.is_reversed ? -1 : 1;
  return holds_weakly(p, node, sheet.c[0], sgn) && holds_weakly(p, node, sheet.c[1], -sgn);
}
