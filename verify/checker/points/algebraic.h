// SPDX-License-Identifier: Apache-2.0 OR MIT
// algebraic.h: parameters of kind 1: docs/certificates/points.md, section 6.
#pragma once
#include "../patches/star_bytes.h"
#include "patch_grid.h"

struct RationalPoly {  // the constant coefficient first
  std::vector<Ratio> c;
};

struct Algebraic {  // U(t), V(t) at a root t of `modulus` in [a, b]
  RationalPoly modulus, u, v;
  Ratio a, b;

  static Algebraic read(Bytes* bytes);  // B1
  uint64_t units(const Grid& grid, const RationalPoint& q) const;
  // Why P2 does not hold; null if it does.
  const char* why_not_on(const Grid& grid, const RationalPoint& q) const;
  // Whether the Bernstein coefficients of P2 have this sign, 0 or 1, or a greater one.
  bool is_in_domain(bool of_triangle, int least_sign) const;

 private:
  uint64_t size() const;  // the greatest degree plus 1
};
