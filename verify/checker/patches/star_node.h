// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_node.h: nodes of docs/certificates/star-box.md, section 4: hulls, quarters, S1.
//
// Numbers are integers in two's complement, as many limbs each as the largest of a block needs.
// Halving multiplies by 2^degree instead of dividing: by 2^(p + q) for the quarters of a tensor
// product, by 2^p for those of a triangle; common powers of two are then divided out. Control
// points of a node bound all its values, so limbs for B + p + q + 1 bits hold every result, and
// intermediate sums that exceed this range are right modulo the width.
#pragma once
#include "star.h"

struct Block {
  int n = 0;      // limbs of a number
  int bits = -1;  // of the largest magnitude, where they have been counted
  std::vector<uint64_t> d;
  const uint64_t* number(size_t i) const { return &d[i * size_t(n)]; }
};

// In units 2^E, or of the box whose frame it is in: the exact hull, rounded to integers outwards and inwards; farther
// ones are cut at +-kFarthest.
struct Hull {
  int64_t out_lo[3], out_hi[3], in_lo[3], in_hi[3];
  // Along axis k. Exact, as the box has integers and is nearer.
  bool misses(const Bounds& b, int k) const { return in_hi[k] < b.lo[k] || in_lo[k] > b.hi[k]; }
  bool misses(const Bounds& b) const { return misses(b, 0) || misses(b, 1) || misses(b, 2); }
  bool is_inside(const Bounds& b) const {
    for (int k = 0; k < 3; ++k)
      if (out_lo[k] < b.lo[k] || out_hi[k] > b.hi[k]) return false;
    return true;
  }
};

struct Node {
  int level;
  int64_t at[4][2];  // corners: (u, v), or the second and third barycentric coordinate
  Hull hull;
  Block net;  // (X, Y, Z), and W for all after the last; rational: (X, Y, Z, W)
  Block g;    // G0, G1, G2, G3 of each coefficient of g_c = G0 + c.G, once needed
  uint32_t last_fail;
  std::unique_ptr<Node[]> child;  // four, once needed

  size_t limbs() const { return net.d.size() + g.d.size(); }  // this node's alone
  const uint64_t* weight(const Patch& p, int point) const {
    return net.number(p.is_rational ? size_t(4 * point + 3) : size_t(3 * p.shape.count()));
  }
  const uint64_t* coordinate(const Patch& p, int point, int k) const {
    return net.number(size_t((p.is_rational ? 4 : 3) * point + k));
  }
  // Whether a corner of the node lies on side e of the patch.
  bool touches(const Patch& p, int corner, int e) const;
  // Whether side e of the node is a part of a side of the patch; that side is then side e, too.
  bool is_outer(const Patch& p, int e) const;
};

Node make_root(const Patch& p, uint64_t root);   // v fastest
void make_children(const Patch& p, Node* node);  // with nets and hulls
Shape shape_of_g(const Patch& p);
Block make_g(const Patch& p);  // on the whole patch
Block on_root(const Patch& p, uint64_t root, const Shape& s, int numbers, Block b);  // the root's part of a block
void make_children_g(const Patch& p, Node* node);  // REQUIRES the node's g, and children
Hull hull_in(const Frame& frame, int shift, const Patch& p, const Node& node);  // in units 2^(E + shift)
// Whether the node's hull in the box's frame misses the box.
bool misses_in(const Frame& frame, const Bounds& b, const Patch& p, const Node& node);
std::vector<Big> coefficients(const Patch& p, const Node& node, int k);  // of (X, Y, Z, W)[k]

Block packed(const std::vector<Big>& numbers);
void widen(const Block& b, int n, Block* to);  // all numbers with n limbs
int bits_of(const Block& b);                   // of the largest magnitude
int bits_of(const uint64_t* a, int n);         // a number of n limbs is at most 2^this in absolute value
void shrink(Block* b);                         // divides by the greatest common power of two; as few limbs as possible
// A half along an axis, divided by the greatest common power of two; what follows the points (a common weight) is only
// scaled.
Block half_of(const Shape& s, int axis, int half, int numbers, const Block& b);
// The blocks of all four children: points of `numbers` numbers each, and what follows them (a common weight), all times
// the same power of two.
void quarters(const Shape& s, int numbers, const Block& b, Block* out);
