// SPDX-License-Identifier: Apache-2.0 OR MIT
// relation.h: where a point Q lies, as seen from a triangle; docs/certificates/points.md, section 4.
//
// V holds three integers x[0..2]: Vec<C> of geometry.h, whose bit budget covers every product here, or IntegerVec.
// edge[i] runs from corner i to the next corner; to[i] is Q minus corner i, times a positive number.
#pragma once
#include "../mesh/geometry.h"
#include "integer.h"

struct IntegerVec {
  Integer x[3];
};

// Component k of the cross product.
template <class V>
auto cross_part(const V& a, const V& b, int k) -> decltype(a.x[0] * b.x[0]) {
  const int p = (k + 1) % 3, q = (k + 2) % 3;
  return a.x[p] * b.x[q] - a.x[q] * b.x[p];
}

// The sign of n.(Q - v0), n = the normal.
template <class V>
int side_of_plane(const V* edge, const V* to) {
  return sign(cross_part(edge[0], edge[1], 0) * to[0].x[0] +
              cross_part(edge[0], edge[1], 1) * to[0].x[1] +
              cross_part(edge[0], edge[1], 2) * to[0].x[2]);
}

// Whether Q lies on the triangle. REQUIRES that the triangle's closed box contains Q. In the plane of the triangle the
// products edge[i] x to[i] are multiples of the normal, and their factors are the barycentric coordinates of Q. The
// normal of a degenerate triangle is 0; then they are 0 where Q lies on the line of its corners, and the box does the
// rest.
template <class V>
bool lies_on(const V* edge, const V* to) {
  if (side_of_plane(edge, to) != 0) return false;
  for (int k = 0; k < 3; ++k) {
    const int normal = sign(cross_part(edge[0], edge[1], k));
    for (int i = 0; i < 3; ++i) {
      const int s = sign(cross_part(edge[i], to[i], k));
      if (s != 0 && s != normal) return false;
    }
  }
  return true;
}

// What the triangle adds to the sum of section 4 for the ray from Q along axis u, upward or downward: 1, -1, or 0 if
// the ray does not stab it. has_reached[i]: corner i is not above Q along axis q, the second one after u. REQUIRES that
// Q does not lie on the triangle.
template <class V>
int crossing(const V* edge, const V* to, const bool* has_reached, int u, bool upward) {
  bool odd = false;
  for (int i = 0; i < 3; ++i) {
    const bool rises = has_reached[i];
    if (rises == has_reached[(i + 1) % 3]) continue;
    odd ^= sign(cross_part(edge[i], to[i], u)) == (rises ? 1 : -1);
  }
  if (!odd) return 0;
  const int nu = sign(cross_part(edge[0], edge[1], u));
  const bool is_above = side_of_plane(edge, to) != nu;  // the triangle, along u; t = -side
  return is_above == upward ? (upward ? nu : -nu) : 0;
}
