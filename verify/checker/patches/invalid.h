// SPDX-License-Identifier: Apache-2.0 OR MIT
// invalid.h: what the parts of patch-invalid-1 and patch-invalid-2 share. The pages: docs/certificates/patch-invalid.md
// and patch-invalid-2.md.
#pragma once
#include "star_bytes.h"
#include "star_curve.h"

struct InvalidBytes : Bytes {  // a body from its beginning: B1
  InvalidBytes(const std::vector<Entity>& entities, const char* magic, bool has_kinds,
               const Body& bytes)
      : Bytes(bytes), cuts(read_cuts(entities, magic, has_kinds, false, this)) {}

  const Cuts cuts;

  uint64_t patch() {
    const uint64_t i = varint();
    require(i < cuts.patches(), "B1", "there is no patch", i);
    return i;
  }
};
// The part of B2 that needs no coefficients.
void check_kinds_and_knots(const std::vector<Entity>& entities);
Patch cut_patch(const Cuts& cuts, uint64_t number);                // B2 for its coefficients
void check_numbers_of_patches(const Statement& s, const Cuts& c);  // B3: `patches` and `flipped`

typedef std::vector<Big> Net;  // a tensor patch's homogeneous points, second index fastest
// A patch's net of degrees p, q; a triangle's in (s, t), up to a positive factor.
Net tensor_net(const Patch& patch);

struct RestrictedPatch {  // a patch restricted to a rectangle
  uint64_t patch;
  Part t[2];
};
Part read_interval(Bytes* bytes);  // B1
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

struct Fraction {  // n / d, 0 <= n <= d, 1 <= d; not always in lowest terms
  int64_t n, d;
};
inline bool are_equal(const Fraction& a, const Fraction& b) {
  return u128(a.n) * u128(b.d) == u128(b.n) * u128(a.d);  // below 2^126
}
struct PatchPoint {  // a place of the page of version 2: a patch and parameters of it
  uint64_t patch;
  Fraction t[2];
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

// Whether no number is in both.
inline bool are_apart(const Part& s, const Part& t) {
  return compare_dyadic(s.b, s.k, t.a, t.k) < 0 || compare_dyadic(t.b, t.k, s.a, s.k) < 0;
}

void check_crossing(const Crossing& x, const Patch& a, const Patch& b);  // X1 to X3
// What X1 says of the intervals but for their disjointness.
void check_intervals(const Crossing& x, bool b_is_triangle, const char* id);
// X2 and X3, by these names.
void check_signs(const Crossing& x, const Patch& a, const Patch& b, const char* id2,
                 const char* id3);
// D1 to D4. outer: by patch and side; num_outer: their number, collapsed ones included.
void check_sides(const Sides& s, const std::vector<OuterSide>& outer, uint64_t num_outer,
                 bool has_flags, uint64_t same, uint64_t opposite);
// Reason (b) of M1, and B2 for the coefficients of all patches. bytes: of the model and the body.
void check_points_of_x(const Cuts& cuts, const PatchPoint& a, const PatchPoint& b, uint64_t bytes);
