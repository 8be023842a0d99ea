// SPDX-License-Identifier: Apache-2.0 OR MIT
// invalid.h: what the parts of patch-invalid-1 share. The page: docs/certificates/patch-invalid.md.
#pragma once
#include "star_curve.h"

struct RestrictedPatch {  // a patch restricted to a rectangle
  uint64_t patch;
  Part t[2];
};
struct Crossing {
  RestrictedPatch sheet[2];
  Big y[3][3];
};
struct Arc {
  uint64_t patch;
  int side;
  Part t;
};
struct Sides {
  std::vector<Arc> arcs;
  int axis, k;
  int64_t at;  // at / 2^k on the side of the first arc
};

// An outer side that is not collapsed, in its own direction of travel.
struct OuterSide {
  uint64_t patch;
  int e;
  bool is_reversed, is_rational;
  Curve curve;
};

// Compares numbers of different scales: the sign of a / 2^k - c / 2^l.
inline int compare_dyadic(int64_t a, int k, int64_t c, int l) {
  const u128 x = u128(a) << l, y = u128(c) << k;  // below 2^124
  return x < y ? -1 : x > y;
}

void check_crossing(const Crossing& x, const Patch& a, const Patch& b);  // X1 to X3
// D1 to D4. outer: by patch and side; num_outer: their number, collapsed ones included.
void check_sides(const Sides& s, const std::vector<OuterSide>& outer, uint64_t num_outer,
                 bool has_flags, uint64_t same, uint64_t opposite);
