// SPDX-License-Identifier: Apache-2.0 OR MIT
// cone.h: directions near a point of flat walls; docs/certificates/points.md, section 7.
#pragma once
#include <functional>

#include "../patches/big.h"

struct BigVec {
  Big x[3];
};

struct
    Wedge {  // the directions s a + t b with s, t >= 0; n = a x b is not 0, and points out of the solid
  BigVec a, b, n;
};
typedef std::vector<Wedge> Cone;

BigVec cross(const BigVec& a, const BigVec& b);
BigVec sum(const Big& s, const BigVec& a, const Big& t, const BigVec& b);  // s a + t b
int side(const BigVec& n, const BigVec& d);                                // the sign of n.d
// The wedges of a convex polygon that contains the origin, in a plane; its corners are counterclockwise, seen from
// outside.
void add_polygon(const std::vector<BigVec>& corners, Cone* to);

// D of the page: the values of f in the directions off all cones, by the bits of the solids. What is wrong, if a cone
// is not that of a solid, or null.
struct ValuesNearby {
  bool has[2];
  const char* fault;
};
ValuesNearby values_nearby(const std::vector<Cone>& cones,
                           const std::function<bool(const std::vector<bool>& bits)>& f);
