// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/fast_spline_loops_internal.h: the kernels of fast_spline_internal.h over a vector V of four doubles:
// load, store, all(x), +, -, *, unary -.
#pragma once
#include "splines/fast_spline_formulas_internal.h"
#include "splines/fast_spline_internal.h"

namespace veritope::internal {
namespace {

constexpr double kFastInfinity = __builtin_inf(), kFastNan = __builtin_nan("");
constexpr int kFastMaxDegree = 63;

[[gnu::always_inline]] inline double fast_abs(double x) { return __builtin_fabs(x); }

/// The cell of u. REQUIRES breaks[0] <= u <= breaks[pieces]. Correct for every rounding of the bucket's number: the
/// function u -> bucket is monotone, and `first` was made with it.
[[gnu::always_inline]] inline std::size_t fast_cell(const FastAxis& axis, double u) {
  auto bucket = static_cast<std::size_t>((u - axis.breaks[0]) * axis.per_bucket);
  bucket = bucket < axis.buckets ? bucket : axis.buckets;
  std::size_t low = axis.first[bucket], high = axis.first[bucket + 1];
  while (high - low > 4) {
    const std::size_t middle = (low + high + 1) / 2;
    if (axis.breaks[middle] <= u) {
      low = middle;
    } else {
      high = middle - 1;
    }
  }
  while (low < high && axis.breaks[low + 1] <= u) ++low;
  return low;
}

template <typename V, std::size_t N, int Degree>
struct FastLoop {
  struct Place {
    std::size_t piece = 0;
    std::size_t cell[N];
    alignas(32) double s[4] = {0, 0, 0, 0};
  };
  // Returns false if a parameter is outside of the domain, or NaN.
  [[gnu::always_inline]] static bool locate(const FastSplineTables& t, const double* const* at,
                                            std::size_t i, Place& place) {
    for (std::size_t a = 0; a < N; ++a) {
      const FastAxis& axis = t.axis[a];
      const double u = at[a][i];
      if (!(u >= axis.breaks[0] && u <= axis.breaks[axis.pieces])) [[unlikely]]
        return false;
      const std::size_t cell = fast_cell(axis, u);
      const double s = (u - axis.origin[cell]) * axis.rate[cell];
      place.s[a] = s < 1.0 ? s : 1.0;
      place.cell[a] = cell;
      place.piece = place.piece * axis.pieces + cell;
    }
    return true;
  }

  // For known degrees: the weights of all axes side by side in the lanes.
  struct FixedWeights {
    alignas(32) double b[Degree + 1][4], d[Degree + 1][4];
    template <bool WithSlopes>
    [[gnu::always_inline]] void set(const FastSplineTables&, const Place& place) {
      const V s = V::load(place.s), one = V::all(1.0);
      V weights[Degree + 1], below[Degree + 1], slopes[Degree + 1];
      bernstein_weights(Degree, s, one - s, one, weights, below);
      for (int i = 0; i <= Degree; ++i) V::store(b[i], weights[i]);
      if constexpr (WithSlopes) {
        derivative_weights(Degree, below, slopes);
        for (int i = 0; i <= Degree; ++i) V::store(d[i], slopes[i]);
      }
    }
    [[gnu::always_inline]] static constexpr int degree(std::size_t) { return Degree; }
    [[gnu::always_inline]] V value(std::size_t a, int i) const { return V::all(b[i][a]); }
    [[gnu::always_inline]] V slope(std::size_t a, int i) const { return V::all(d[i][a]); }
  };
  struct AnyWeights {
    int degrees[N];
    double b[N][kFastMaxDegree + 1], d[N][kFastMaxDegree + 1];
    template <bool WithSlopes>
    void set(const FastSplineTables& t, const Place& place) {
      for (std::size_t a = 0; a < N; ++a) {
        degrees[a] = t.axis[a].degree;
        double below[kFastMaxDegree + 1];
        bernstein_weights(degrees[a], place.s[a], 1.0 - place.s[a], 1.0, b[a], below);
        if (WithSlopes) derivative_weights(degrees[a], below, d[a]);
      }
    }
    int degree(std::size_t a) const { return degrees[a]; }
    V value(std::size_t a, int i) const { return V::all(b[a][i]); }
    V slope(std::size_t a, int i) const { return V::all(d[a][i]); }
  };
  template <bool IsFixed, typename Dummy = void>
  struct WeightsOf {
    using Type = AnyWeights;
  };
  template <typename Dummy>
  struct WeightsOf<true, Dummy> {
    using Type = FixedWeights;
  };
  using Weights = typename WeightsOf<(Degree > 0)>::Type;

  struct Net {
    const double* at;
    [[gnu::always_inline]] V next() {
      const V v = V::load(at);
      at += 4;
      return v;
    }
  };

  static void refuse(const FastSplineTables& t, std::size_t i, std::size_t dimension,
                     const FastOut& out) {
    const auto fill = [i](double* to, std::size_t size, double x) {
      for (std::size_t c = 0; to != nullptr && c < size; ++c) to[i * size + c] = x;
    };
    fill(out.value, dimension, kFastNan), fill(out.value_bound, dimension, kFastInfinity);
    fill(out.partial, N * dimension, kFastNan);
    fill(out.partial_bound, N * dimension, kFastInfinity);
  }

  [[gnu::always_inline]] static void put(double* to, V v, std::size_t count) {
    if (count >= 4) return V::store(to, v);
    if (count == 3) return V::store3(to, v);
    alignas(32) double lanes[4];
    V::store(lanes, v);
    for (std::size_t c = 0; c < count; ++c) to[c] = lanes[c];
  }
  [[gnu::always_inline]] static void copy(double* to, const double* from, std::size_t count) {
    if (count == 3)
      return V::store3(to, V::load_loose(from));  // a bound or more follows: N >= 1 axes
    for (std::size_t c = 0; c < count; ++c) to[c] = from[c];
  }

  // x / w and its bound, docs/bounds/fast_spline.md, 6.
  static double quotient_bound(double q, double x_bound, double w_bound, double inverse_w) {
    const double size = fast_abs(q);
    return ((x_bound + size * w_bound) * inverse_w + size * kFastQuotientRel) * kFastQuotientSlack +
           kFastQuotientFloor;
  }

  static void value(const FastSplineTables& t, const double* const* at, std::size_t n,
                    const FastOut& out) {
    const auto components = static_cast<std::size_t>(t.num_components);
    const bool is_rational = t.is_rational();
    const std::size_t dimension = t.dimension(), blocks = t.num_blocks();
    const std::size_t stride = 4 * t.num_coefficients;
    for (std::size_t i = 0; i < n; ++i) {
      Place place;
      if (!locate(t, at, i, place)) [[unlikely]] {
        refuse(t, i, dimension, out);
        continue;
      }
      Weights weights;
      weights.template set<false>(t, place);
      const double* const bounds = t.bounds + place.piece * components * (N + 1);
      double* const to = out.value + i * dimension;
      Net net{t.coefficients + place.piece * blocks * stride};
      if (!is_rational) {
        for (std::size_t done = 0; done < components; done += 4)
          put(to + done, Contraction<N, V, Weights, Net>{weights, net}.template value<0>(),
              components - done);
        if (out.value_bound != nullptr) copy(out.value_bound + i * dimension, bounds, dimension);
        continue;
      }
      // The block of the weight, which is the last one, comes first.
      const double inverse_w = t.inverse_weight[place.piece];
      alignas(32) double lanes[4];
      double w = 0;
      for (std::size_t k = blocks; k-- > 0;) {
        Net block{t.coefficients + (place.piece * blocks + k) * stride};
        V::store(lanes, Contraction<N, V, Weights, Net>{weights, block}.template value<0>());
        if (k + 1 == blocks) w = lanes[(components - 1) % 4];
        for (std::size_t c = 4 * k; c < dimension && c < 4 * k + 4; ++c) to[c] = lanes[c % 4] / w;
      }
      if (out.value_bound != nullptr)
        for (std::size_t c = 0; c < dimension; ++c)
          out.value_bound[i * dimension + c] =
              quotient_bound(to[c], bounds[c], bounds[dimension], inverse_w);
    }
  }

  static void jet(const FastSplineTables& t, const double* const* at, std::size_t n,
                  const FastOut& out) {
    const auto components = static_cast<std::size_t>(t.num_components);
    const bool is_rational = t.is_rational();
    const std::size_t dimension = t.dimension(), blocks = t.num_blocks();
    const std::size_t stride = 4 * t.num_coefficients;
    for (std::size_t i = 0; i < n; ++i) {
      Place place;
      if (!locate(t, at, i, place)) [[unlikely]] {
        refuse(t, i, dimension, out);
        continue;
      }
      Weights weights;
      weights.template set<true>(t, place);
      const double* const bounds = t.bounds + place.piece * components * (N + 1);
      alignas(32) double w[N + 1][4];  // of the weight: value, partial derivatives
      std::size_t w_lane = (components - 1) % 4;
      for (std::size_t k = blocks; k-- > 0;) {
        Net net{t.coefficients + (place.piece * blocks + k) * stride};
        Jet<V, N> jet = Contraction<N, V, Weights, Net>{weights, net}.template jet<0>();
        for (std::size_t a = 0; a < N; ++a)
          jet.partial[a] = V::all(t.axis[a].slope_scale[place.cell[a]]) * jet.partial[a];
        const std::size_t first = 4 * k;
        if (!is_rational) {
          put(out.value + i * dimension + first, jet.value, dimension - first);
          for (std::size_t a = 0; a < N; ++a)
            put(out.partial + (i * N + a) * dimension + first, jet.partial[a], dimension - first);
          continue;
        }
        alignas(32) double x[N + 1][4];
        V::store(x[0], jet.value);
        for (std::size_t a = 0; a < N; ++a) V::store(x[a + 1], jet.partial[a]);
        if (k + 1 == blocks)
          for (std::size_t a = 0; a <= N; ++a) w[a][0] = x[a][w_lane];
        for (std::size_t c = first; c < dimension && c < first + 4; ++c)
          quotients(t, place.piece, i, c, dimension, x, w, bounds, out);
      }
      if (is_rational) continue;
      if (out.value_bound != nullptr) copy(out.value_bound + i * dimension, bounds, dimension);
      if (out.partial_bound != nullptr)
        for (std::size_t c = 0; c < N * dimension; ++c)
          out.partial_bound[i * N * dimension + c] = bounds[dimension + c];
    }
  }
  // (x' - q w') / w of component c, q = x / w, and the bounds.
  static void quotients(const FastSplineTables& t, std::size_t piece, std::size_t i, std::size_t c,
                        std::size_t dimension, const double (&x)[N + 1][4],
                        const double (&w)[N + 1][4], const double* bounds, const FastOut& out) {
    const std::size_t components = dimension + 1;
    const double inverse_w = t.inverse_weight[piece], q = x[0][c % 4] / w[0][0];
    const double q_bound = quotient_bound(q, bounds[c], bounds[dimension], inverse_w);
    out.value[i * dimension + c] = q;
    if (out.value_bound != nullptr) out.value_bound[i * dimension + c] = q_bound;
    for (std::size_t a = 0; a < N; ++a) {
      const double product = q * w[a + 1][0], top = x[a + 1][c % 4] - product;
      const double slope = top / w[0][0];
      const std::size_t at = (i * N + a) * dimension + c;
      out.partial[at] = slope;
      if (out.partial_bound == nullptr) continue;
      const double* const own = bounds + (a + 1) * components;
      const double size = fast_abs(q) + q_bound;
      const double top_bound =
          ((own[c] + size * own[dimension]) + fast_abs(w[a + 1][0]) * q_bound) +
          (fast_abs(product) + fast_abs(top)) * kFastQuotientRel;
      out.partial_bound[at] = quotient_bound(
          slope, top_bound * kFastQuotientSlack + kFastQuotientFloor, bounds[dimension], inverse_w);
    }
  }
};

template <typename V, std::size_t N>
constexpr void fill_fast_kernels(FastKernels& out) {
  out.value[N - 1][0] = FastLoop<V, N, 0>::value, out.jet[N - 1][0] = FastLoop<V, N, 0>::jet;
  out.value[N - 1][1] = FastLoop<V, N, 1>::value, out.jet[N - 1][1] = FastLoop<V, N, 1>::jet;
  out.value[N - 1][2] = FastLoop<V, N, 2>::value, out.jet[N - 1][2] = FastLoop<V, N, 2>::jet;
  out.value[N - 1][3] = FastLoop<V, N, 3>::value, out.jet[N - 1][3] = FastLoop<V, N, 3>::jet;
  out.value[N - 1][4] = FastLoop<V, N, 4>::value, out.jet[N - 1][4] = FastLoop<V, N, 4>::jet;
  out.value[N - 1][5] = FastLoop<V, N, 5>::value, out.jet[N - 1][5] = FastLoop<V, N, 5>::jet;
}
template <typename V>
constexpr FastKernels fast_kernels_of() {
  FastKernels out{};
  fill_fast_kernels<V, 1>(out), fill_fast_kernels<V, 2>(out), fill_fast_kernels<V, 3>(out);
  return out;
}

}  // namespace
}  // namespace veritope::internal
