// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/sign_over_triangle.cc: sign_over_patch.h on triangles, halved at the middle of the edge opposite of the
// newest corner.
#include "predicates/sign_over_patch_internal.h"

namespace veritope {
namespace {

std::size_t index_of(int j, int k) {
  return static_cast<std::size_t>((j + k) * (j + k + 1) / 2 + k);
}

struct TriangleDomain {
  static constexpr std::size_t kDimension = 3, kCorners = 3;
  using Point = std::array<Rational, 3>;
  struct Cut {};  // always the edge of the first two corners
  using Region = std::array<Point, 3>;
  int degree;

  Region whole() const {
    Region r;
    for (std::size_t i = 0; i < 3; ++i) r[i][i] = Rational(1);
    return r;
  }
  std::vector<std::pair<std::size_t, Point>> corners(const Region& r) const {
    return {{index_of(0, 0), r[0]}, {index_of(degree, 0), r[1]}, {index_of(0, degree), r[2]}};
  }
  Point middle(const Region& r) const {
    Point out;
    for (std::size_t c = 0; c < 3; ++c) out[c] = (r[0][c] + r[1][c] + r[2][c]) / Rational(3);
    return out;
  }
  Region place(const Region& r) const { return r; }
  Cut choose(const Region&, const std::vector<Interval>&, std::size_t) const { return {}; }

  // (a, b, c) with the middle m of ab: (c, a, m) and (b, c, m), whose next edges are ca and bc.
  std::pair<Region, Region> halves(const Region& r, Cut) const {
    Point m;
    for (std::size_t c = 0; c < 3; ++c) m[c] = internal::halved(r[0][c] + r[1][c]);
    return {Region{r[2], r[0], m}, Region{r[1], r[2], m}};
  }
  // Lines of constant k are curves of degree n - k along ab.
  template <typename R>
  std::vector<R> half(const std::vector<R>& values, Cut, int which) const {
    std::vector<R> out(values.size()), line, left;
    for (int k = 0; k <= degree; ++k) {
      line.clear();
      for (int j = 0; j <= degree - k; ++j) line.push_back(values[index_of(j, k)]);
      internal::halve_keeping_right(line, left);
      for (int j = 0; j <= degree - k; ++j) {
        const int i = degree - k - j;
        const auto at = static_cast<std::size_t>(j);
        if (which == 0) {
          out[index_of(i, j)] = left[at];  // of (a, m, c): exponents i, j, k; of (c, a, m): k, i, j
        } else {
          out[index_of(k, i)] = line[at];  // of (m, b, c): i, j, k; of (b, c, m): j, k, i
        }
      }
    }
    return out;
  }
};

}  // namespace

TriangleSign sign_over_triangle(int degree, const std::vector<Rational>& coefficients,
                                const SignBudget& budget) {
  VT_CHECK(degree >= 0 && coefficients.size() == index_of(0, degree) + 1,
           "a triangle of degree n has (n + 1)(n + 2) / 2 coefficients");
  const TriangleDomain domain{degree};
  return internal::SignSearch<TriangleDomain>(domain, coefficients, budget).run();
}

}  // namespace veritope
