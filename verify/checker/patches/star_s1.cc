// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_s1.cc: S1 of docs/certificates/star-box.md (is_strict) and star-box-2.md, section 4.
#include "star_sheet.h"

#include "star_curve.h"
#include "star_poly.h"

namespace {

__extension__ typedef __int128 i128;

// The sign of g_c = G0 + c.G. Products are below 2^125 in absolute value, three of them and the carry below 2^127.
template <int N>
inline int sign_of(const uint64_t* g, const int64_t* c, int n) {
  const int width = N != 0 ? N : n;
  i128 carry = 0;
  uint64_t any = 0;
  for (int i = 0; i < width; ++i) {
    const bool top = i + 1 == width;
    i128 t[4];
    for (int k = 0; k < 4; ++k)
      t[k] = top ? i128(int64_t(g[k * width + i])) : i128(g[k * width + i]);
    carry += t[0] + t[1] * c[0] + t[2] * c[1] + t[3] * c[2];
    if (top) break;
    any |= uint64_t(carry);
    carry >>= 64;
  }
  return carry < 0 ? -1 : (carry != 0 || any != 0) ? 1 : 0;
}
// Whether the signs at c- and c+ are sgn and -sgn.
template <int N>
inline bool are_opposite(const uint64_t* g, const Sheet& sheet, int sgn, int n) {
  return sign_of<N>(g, sheet.c[0], n) == sgn && sign_of<N>(g, sheet.c[1], n) == -sgn;
}
bool signs(const uint64_t* g, const Sheet& sheet, int sgn, int n) {
  switch (n) {
    case 1: return are_opposite<1>(g, sheet, sgn, n);
    case 2: return are_opposite<2>(g, sheet, sgn, n);
    case 3: return are_opposite<3>(g, sheet, sgn, n);
    case 4: return are_opposite<4>(g, sheet, sgn, n);
    case 5: return are_opposite<5>(g, sheet, sgn, n);
    case 6: return are_opposite<6>(g, sheet, sgn, n);
    default: return are_opposite<0>(g, sheet, sgn, n);
  }
}

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
  const int sgn = p.is_reversed ? -1 : 1, n = node->g.n;
  const Shape s = shape_of_g(p);
  std::vector<bool> left_out;
  for (int e = 0; e < s.sides(); ++e) {
    if (!is_pole(p, *node, e)) continue;
    left_out.resize(size_t(s.count()));
    for (int k = 0; k <= s.side_degree(e); ++k) left_out[size_t(s.on_side(e, k))] = true;
  }
  const auto holds = [&](uint32_t i) {
    if (!left_out.empty() && left_out[i]) return true;
    return signs(node->g.number(4 * i), sheet, sgn, n);
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
  const auto sign = [&](uint32_t i) {
    return sgn * sign_of<0>(node->g.number(4 * i), c, node->g.n);
  };
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
