// SPDX-License-Identifier: LGPL-3.0-or-later
#include "splines/polynomial_filter.h"

#include <algorithm>
#include <cstring>

#include "robust/fixed_int.h"

namespace veritope::internal {
namespace {

// Results are made kLanes at a time, in registers of two: as many chains of dependent sums.
typedef double Pair __attribute__((vector_size(16)));
constexpr std::size_t kPairs = 4, kLanes = 2 * kPairs;

struct Lanes {
  Pair p[kPairs] = {};

  [[gnu::always_inline]] void add(const Lanes& b) {
    VT_UNROLL for (std::size_t i = 0; i < kPairs; ++i) p[i] += b.p[i];
  }
  // this = or += factor * (from[0], from[1], ...)
  template <bool Add>
  [[gnu::always_inline]] void multiply(const double* from, double factor) {
    VT_UNROLL for (std::size_t i = 0; i < kPairs; ++i) {
      Pair v;
      std::memcpy(&v, from + 2 * i, sizeof v);
      if constexpr (Add) {
        p[i] += v * factor;
      } else {
        p[i] = v * factor;
      }
    }
  }
};

// The factor's coefficients where the product's array has them, behind `front` zeros.
struct Spread {
  std::size_t front;
  std::vector<double> c;

  Spread(const DoubleAlgebra::Polynomial& p, const Grid<3>& out, std::size_t furthest)
      : front(furthest), c(furthest + out.count() + kLanes) {
    const double* row = p.c.data();
    for (std::size_t i = 0; i < p.grid.size[0]; ++i)
      for (std::size_t j = 0; j < p.grid.size[1]; ++j, row += p.grid.size[2])
        std::copy(row, row + p.grid.size[2], c.data() + front + out.at({i, j, 0}));
  }
  const double* at(std::size_t place) const { return c.data() + front + place; }
};

// sum += the sum over k of q[k] a[-k]
[[gnu::always_inline]] inline void add_row(Lanes& sum, const double* a, const double* q,
                                           std::size_t count) {
  Lanes row;
  row.multiply<false>(a, q[0]);
  for (std::size_t k = 1; k < count; ++k) row.multiply<true>(a - k, q[k]);
  sum.add(row);
}

// `factors` pairs of a spread polynomial and a small one of the grid `q`.
template <std::size_t Factors>
void filter(const Spread* const (&a)[Factors], const double* const (&q)[Factors],
            const Grid<3>& small, DoubleAlgebra::Polynomial& out) {
  const std::size_t count = out.grid.count(), row = out.grid.size[2],
                    plane = row * out.grid.size[1];
  for (std::size_t first = 0; first < count; first += kLanes) {
    Lanes sum;
    std::size_t place = 0;  // in the small factors
    for (std::size_t i = 0; i < small.size[0]; ++i) {
      Lanes of_plane;
      for (std::size_t j = 0; j < small.size[1]; ++j, place += small.size[2])
        for (std::size_t f = 0; f < Factors; ++f)
          add_row(of_plane, a[f]->at(first) - i * plane - j * row, q[f] + place, small.size[2]);
      sum.add(of_plane);
    }
    std::memcpy(out.c.data() + first, sum.p, std::min(kLanes, count - first) * sizeof(double));
  }
}

DoubleAlgebra::Polynomial zeros(const Grid<3>& grid) {
  return {grid, std::vector<double>(grid.count())};
}
std::size_t furthest(const Grid<3>& out, const Grid<3>& small) {
  return out.at({small.size[0] - 1, small.size[1] - 1, small.size[2] - 1});
}

}  // namespace

DoubleAlgebra::Polynomial DoubleAlgebra::product(const Polynomial& a, const Polynomial& q) const {
  Polynomial out = zeros(product_grid(a.grid, q.grid));
  const Spread spread(a, out.grid, furthest(out.grid, q.grid));
  filter<1>({&spread}, {q.c.data()}, q.grid, out);
  return out;
}

DoubleAlgebra::Polynomial DoubleAlgebra::blend(const Polynomial& a, const Polynomial& q,
                                               const Polynomial& b, const Polynomial& w) const {
  Polynomial out = zeros(product_grid(a.grid, q.grid));
  const std::size_t front = furthest(out.grid, q.grid);
  const Spread of_a(a, out.grid, front), of_b(b, out.grid, front);
  filter<2>({&of_a, &of_b}, {q.c.data(), w.c.data()}, q.grid, out);
  return out;
}

DoubleAlgebra::Polynomial DoubleAlgebra::linear(std::span<const double> factor,
                                                std::span<const Polynomial> p) const {
  Polynomial out = zeros(p[0].grid);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < out.c.size(); ++j) out.c[j] += factor[i] * p[i].c[j];
  return out;
}

}  // namespace veritope::internal
