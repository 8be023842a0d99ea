// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_node.cc: hulls, roots and children.
#include "star_node.h"

#include "star_ratio.h"

namespace {

__extension__ typedef __int128 i128;

bool is_less(const uint64_t* a, const uint64_t* b, int n) {
  if (a[n - 1] != b[n - 1]) return int64_t(a[n - 1]) < int64_t(b[n - 1]);
  for (int i = n - 1; i-- > 0;)
    if (a[i] != b[i]) return a[i] < b[i];
  return false;
}
// Extent k of the hull of a node with this net, in units 2^shift times those of the net.
void set_extent(int k, const Patch& p, const Block& net, int shift, Hull* h) {
  const int n = net.n, count = p.shape.count();
  const size_t step = p.is_rational ? 4 : 3;
  const auto coordinate = [&](int i) { return net.number(step * size_t(i) + size_t(k)); };
  h->out_lo[k] = h->in_lo[k] = kFarthest;
  h->out_hi[k] = h->in_hi[k] = -kFarthest;
  int least = 0, most = 0;
  for (int i = 1; i < count && !p.is_rational; ++i) {
    if (is_less(coordinate(i), coordinate(least), n)) least = i;
    if (is_less(coordinate(most), coordinate(i), n)) most = i;
  }
  for (int i = 0; i < count; ++i) {
    if (!p.is_rational && i != least && i != most) continue;
    bool exact;
    const uint64_t* const weight = net.number(p.is_rational ? 4 * size_t(i) + 3 : 3 * size_t(count));
    const int64_t low = floor_ratio(coordinate(i), weight, n, shift, &exact);
    const int64_t high = exact ? low : std::min(low + 1, kFarthest);
    h->out_lo[k] = std::min(h->out_lo[k], low);
    h->in_lo[k] = std::min(h->in_lo[k], high);
    h->in_hi[k] = std::max(h->in_hi[k], low);
    h->out_hi[k] = std::max(h->out_hi[k], high);
  }
}
Hull hull_of(const Patch& p, const Block& net) {
  Hull h;
  for (int k = 0; k < 3; ++k) set_extent(k, p, net, 0, &h);
  return h;
}

// Coordinate `row` of A times the points of a net, in *to, which has one limb more. Sums of three products with entries
// below 2^31 need 33 bits more.
void map_row(const Patch& p, const Block& net, const Frame& frame, size_t row, Block* to) {
  const int n = net.n;
  const size_t step = p.is_rational ? 4 : 3;
  for (size_t i = 0; i < size_t(p.shape.count()); ++i) {
    const uint64_t* const from = net.number(step * i);
    uint64_t* const out = &to->d[(step * i + row) * size_t(n + 1)];
    i128 carry = 0;
    for (int limb = 0; limb < n; ++limb) {
      for (int k = 0; k < 3; ++k) {
        const uint64_t x = from[k * n + limb];
        carry += (limb + 1 == n ? i128(int64_t(x)) : i128(x)) * frame.a[row][k];
      }
      out[limb] = uint64_t(carry);
      carry >>= 64;
    }
    out[n] = uint64_t(carry);
  }
}
// Sets the extents of the hull in a frame, one after the other, until is_enough(k).
template <class IsEnough>
void set_hull(const Frame& frame, int shift, const Patch& p, const Node& node, Hull* h, IsEnough is_enough) {
  static thread_local Block image;  // kept, so that little memory is asked for
  widen(node.net, node.net.n + 1, &image);
  for (int k = 0; k < 3; ++k) {
    map_row(p, node.net, frame, size_t(k), &image);
    set_extent(k, p, image, shift, h);
    if (is_enough(k)) return;
  }
}

}  // namespace

bool Node::touches(const Patch& p, int corner, int e) const {
  const int64_t *const c = at[corner], whole = kWholeSide;
  if (p.shape.is_triangle) return (e == 0 ? whole - c[0] - c[1] : c[e - 1]) == 0;
  return e % 2 == 0 ? c[1] == (e == 0 ? 0 : whole) : c[0] == (e == 3 ? 0 : whole);
}
bool Node::is_outer(const Patch& p, int e) const {
  if (!p.shape.is_triangle) return touches(p, e, e);  // its sides follow the axes
  return touches(p, (e + 1) % 3, e) && touches(p, (e + 2) % 3, e);
}

Hull hull_in(const Frame& frame, int shift, const Patch& p, const Node& node) {
  Hull h;
  set_hull(frame, shift, p, node, &h, [](int) { return false; });
  return h;
}
bool misses_in(const Frame& frame, const Bounds& b, const Patch& p, const Node& node) {
  Hull h;
  bool is_apart = false;
  set_hull(frame, b.shift, p, node, &h, [&](int k) { return is_apart = h.misses(b, k); });
  return is_apart;
}
std::vector<Big> coefficients(const Patch& p, const Node& node, int k) {
  std::vector<Big> r;
  for (int i = 0; i < p.shape.count(); ++i)
    r.push_back(Big::of(k < 3 ? node.coordinate(p, i, k) : node.weight(p, i), node.net.n));
  return r;
}

namespace {

struct Index {  // of a root along u and v
  int64_t at[2];
};
Index index_of(const Patch& p, uint64_t root) {
  return Index{{int64_t(root >> p.roots[1]), int64_t(root & ((uint64_t(1) << p.roots[1]) - 1))}};
}

}  // namespace

Block on_root(const Patch& p, uint64_t root, const Shape& s, int numbers, Block b) {
  const Index ij = index_of(p, root);
  for (int axis = 0; axis < 2; ++axis)
    for (int bit = p.roots[axis]; bit-- > 0;)
      b = half_of(s, axis, int(ij.at[axis] >> bit & 1), numbers, b);
  return b;
}

Node make_root(const Patch& p, uint64_t root) {
  Node r = Node();
  std::vector<Big> numbers;
  for (size_t i = 0; i < p.net.size(); ++i)
    if (p.is_rational || i % 4 < 3 || i + 1 == p.net.size()) numbers.push_back(p.net[i]);
  r.net = on_root(p, root, p.shape, p.is_rational ? 4 : 3, packed(numbers));
  const Index ij = index_of(p, root);
  if (p.shape.is_triangle) {
    r.at[1][0] = r.at[2][1] = kWholeSide;
  } else {
    for (int c = 0; c < 4; ++c)
      for (int axis = 0; axis < 2; ++axis)
        r.at[c][axis] =
            (ij.at[axis] + int((axis == 0 ? c + 1 : c) % 4 >= 2)) * (kWholeSide >> p.roots[axis]);
  }
  r.hull = hull_of(p, r.net);
  return r;
}

void make_children(const Patch& p, Node* node) {
  node->child.reset(new Node[4]());
  Block quarter[4];
  quarters(p.shape, p.is_rational ? 4 : 3, node->net, quarter);
  const auto& a = node->at;
  for (int c = 0; c < 4; ++c) {
    Node& to = node->child[c];
    to.level = node->level + 1;
    to.net = std::move(quarter[c]);
    for (int i = 0; i < p.shape.sides(); ++i)
      for (int k = 0; k < 2; ++k) {
        // The midpoint with the corner at which the quarter lies; for the middle triangle, the
        // midpoint of the two other corners.
        const int own = p.shape.is_triangle ? c : (c == 0 ? 0 : c == 1 ? 3 : c == 2 ? 1 : 2);
        to.at[i][k] =
            (own < p.shape.sides() ? a[i][k] + a[own][k] : a[(i + 1) % 3][k] + a[(i + 2) % 3][k]) /
            2;
      }
    to.hull = hull_of(p, to.net);
  }
}
