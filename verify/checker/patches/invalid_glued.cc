// SPDX-License-Identifier: Apache-2.0 OR MIT
// invalid_glued.cc: reason (b) of M1 of docs/certificates/patch-invalid-2.md: two points of the
// surface X that P1 glues.
#include "invalid.h"

namespace {

// What a patch takes in the body of a star-box certificate. Here it takes none, and n breaks may
// define n^2 patches: the bytes of the model and the body must be enough for them.
const uint64_t kBytesOfPatch = 3;

std::vector<Patch> all_patches(const Cuts& cuts) {
  std::vector<Place> places;
  for (size_t i = 0; i < cuts.entities->size(); ++i)
    for (uint64_t k = cuts.first[i]; k < cuts.first[i + 1]; ++k) places.push_back(cuts.place(i, k));
  std::vector<Patch> r;
  r.reserve(places.size());
  cut_patches(places, 0, cuts.breaks, [&](Patch&& p) {
    p.is_reversed = cuts.reversed[cuts.entity_of(r.size())];
    r.push_back(std::move(p));
  });
  return r;
}

bool is_zero(const Fraction& t) { return t.n == 0; }
bool is_one(const Fraction& t) { return t.n == t.d; }
Fraction rest(const Fraction& t) { return Fraction{t.d - t.n, t.d}; }

struct OnSide {  // a side, and a parameter of it in its own direction of travel
  int e;         // -1: on no side
  Fraction t;
};
// A side of the patch on which the place lies.
OnSide side_of(bool is_triangle, const PatchPoint& at) {
  const Fraction &u = at.t[0], &v = at.t[1];
  if (is_triangle) {                                    // u = s, v = t
    if (is_zero(u) || is_zero(v)) return OnSide{2, u};  // s = 0: where it starts, whatever t is
    if (is_one(v)) return OnSide{1, rest(u)};
    if (is_one(u)) return OnSide{0, v};
  } else {
    if (is_zero(v)) return OnSide{0, u};
    if (is_one(u)) return OnSide{1, v};
    if (is_one(v)) return OnSide{2, rest(u)};
    if (is_zero(u)) return OnSide{3, rest(v)};
  }
  return OnSide{-1, u};
}

struct PointOfX {
  enum Kind { kVertex, kEdge, kOpen } kind;
  uint64_t number;  // of the vertex, the pair of sides, or the patch
  Fraction t[2];    // of an edge: twice the parameter in the direction of travel of its first side
};
PointOfX point_of_x(const std::vector<Patch>& patches, const PatchPoint& at) {
  const Patch& p = patches[at.patch];
  const OnSide on = side_of(p.shape.is_triangle, at);
  if (on.e < 0) return PointOfX{PointOfX::kOpen, at.patch, {at.t[0], at.t[1]}};
  if (p.is_collapsed(on.e) || is_zero(on.t) || is_one(on.t)) {
    const int start = p.shape.is_triangle ? on.e + 1 : on.e, corner = start + is_one(on.t);
    return PointOfX{PointOfX::kVertex, p.vertex[corner % p.shape.sides()], {{0, 1}, {0, 1}}};
  }
  const Fraction t = p.is_reversed == p.is_second[on.e] ? on.t : rest(on.t);
  return PointOfX{PointOfX::kEdge, p.pair[on.e], {t, t}};
}

}  // namespace

void check_points_of_x(const Cuts& cuts, const PatchPoint& a, const PatchPoint& b, uint64_t bytes) {
  require(cuts.patches() <= bytes / kBytesOfPatch, "M1", "too few bytes for the patches",
          cuts.patches());
  std::vector<Patch> patches = all_patches(cuts);
  const Gluing x(&patches, "M1");
  const PointOfX p = point_of_x(patches, a), q = point_of_x(patches, b);
  require(p.kind != q.kind || p.number != q.number || !are_equal(p.t[0], q.t[0]) ||
              !are_equal(p.t[1], q.t[1]),
          "M1", "A and B are one point");
}
