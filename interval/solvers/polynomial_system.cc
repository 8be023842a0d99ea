// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/solvers/polynomial_system.h"

#include <algorithm>
#include <string>
#include <vector>

#include "interval/solvers/exact_bernstein.h"
#include "interval/solvers/mp_restriction_internal.h"
#include "interval/upward.h"
#include "splines/de_casteljau.h"

namespace veritope {
namespace {

constexpr double kTight = 0x1p-40;
constexpr int kFirstPrecision = 128;

// 2^e <= the largest magnitude < 2^(e + 2), if that is not 0.
std::optional<std::int64_t> exponent_of(const std::vector<MpInterval>& values) {
  std::optional<std::int64_t> out;
  for (const MpInterval& v : values)
    for (const Rational& bound : {v.lo(), v.hi()})
      if (bound.sign() != Sign::kZero) out = std::max(out.value_or(INT64_MIN), floor_log2(bound));
  return out;
}

// The equations on one frame in many bits.
template <std::size_t N>
class WideEquations {
 public:
  WideEquations(const Bezier<Rational, N>& exact, const ExactBox<N>& frame, int precision)
      : degrees_(exact.degrees()), precision_(precision) {
    for (std::size_t r = 0; r < N; ++r) {
      for (const Rational& c : exact.component(static_cast<int>(r)))
        rows_[r].emplace_back(c, precision);
      internal::restrict_to(rows_[r], exact.grid(), frame, precision);
    }
  }
  // The equations in double intervals, each times a power of two; empty if their relative errors are too large.
  // Equations with nearly dependent gradients are replaced by combinations first, until no combination is much smaller
  // than its parts, because such a difference would be lost in double. Multipliers are doubles, so that one round gains
  // at most 53 bits.
  std::optional<Bezier<Interval, N>> independent() {
    for (int round = 0; round <= precision_ / 32; ++round) {
      const auto out = normalised();
      if (!out || N == 1 || !shrinks_by(elimination(*out).combination)) return out;
    }
    return std::nullopt;
  }

 private:
  static constexpr std::int64_t kMuchSmaller = -8;  // as a power of two

  std::optional<Bezier<Interval, N>> normalised() {
    Bezier<Interval, N> out(degrees_, static_cast<int>(N), false);
    for (std::size_t r = 0; r < N; ++r) {
      const auto exponent = exponent_of(rows_[r]);
      if (!exponent) continue;
      const MpInterval scale(Rational::power_of_two(-*exponent), precision_);
      const auto to = out.component(static_cast<int>(r));
      for (std::size_t i = 0; i < to.size(); ++i) {
        rows_[r][i] = scale * rows_[r][i];
        to[i] = rows_[r][i].to_interval();
        if (!(wid(to[i]) <= kTight)) return std::nullopt;
      }
    }
    return out;
  }
  // Multiplies by the matrix if some row becomes much smaller, and returns whether it did. The matrix is invertible: it
  // is triangular up to the order of its rows, with 1 at the pivots. REQUIRES normalised rows.
  bool shrinks_by(const ApproxMatrix<N>& matrix) {
    std::array<std::vector<MpInterval>, N> out;
    bool shrunk = false;
    for (std::size_t r = 0; r < N; ++r) {
      out[r].assign(rows_[r].size(), MpInterval(precision_));
      for (std::size_t c = 0; c < N; ++c) {
        if (matrix[r][c] == 0) continue;
        const MpInterval factor(Interval(matrix[r][c]), precision_);
        for (std::size_t i = 0; i < out[r].size(); ++i)
          out[r][i] = out[r][i] + factor * rows_[c][i];
      }
      const auto exponent = exponent_of(out[r]);
      shrunk = shrunk || (exponent && *exponent <= kMuchSmaller);
    }
    if (shrunk) rows_ = std::move(out);
    return shrunk;
  }

  std::array<int, N> degrees_;
  int precision_;
  std::array<std::vector<MpInterval>, N> rows_;
};

template <std::size_t N>
Bezier<Interval, N> rounded(const Bezier<Rational, N>& exact) {
  Bezier<Interval, N> out(exact.degrees(), exact.num_components(), false);
  for (int c = 0; c < exact.num_components(); ++c) {
    std::optional<std::int64_t> exponent;
    for (const Rational& v : exact.component(c))
      if (v.sign() != Sign::kZero) exponent = std::max(exponent.value_or(INT64_MIN), floor_log2(v));
    if (!exponent) continue;
    const Rational scale = Rational::power_of_two(-*exponent);
    for (std::size_t i = 0; i < exact.component(c).size(); ++i)
      out.component(c)[i] = enclose(exact.component(c)[i] * scale);
  }
  return out;
}

Error refusal(Code code, std::string message) { return {code, {}, std::move(message)}; }

}  // namespace

template <std::size_t N>
Result<PolynomialSystem<N>> PolynomialSystem<N>::make(
    std::span<const Bezier<Rational, N>> equations) {
  std::array<int, N> degrees{};
  std::vector<Bezier<Rational, N>> scalars;
  for (const Bezier<Rational, N>& map : equations) {
    if (map.is_rational())
      return refusal(Code::kBadArgument, "an equation is a polynomial, not a rational function");
    for (int c = 0; c < map.num_components(); ++c) {
      const auto values = map.component(c);
      scalars.emplace_back(map.degrees(), 1, false,
                           std::vector<Rational>(values.begin(), values.end()));
    }
    for (std::size_t a = 0; a < N; ++a) degrees[a] = std::max(degrees[a], map.degree(a));
  }
  if (scalars.size() != N)
    return refusal(Code::kBadArgument, std::to_string(scalars.size()) + " equations in " +
                                           std::to_string(N) + " unknowns");
  std::size_t count = 1;
  for (const int d : degrees) {
    count *= static_cast<std::size_t>(d) + 1;
    if (count > kMaxCoefficients)
      return refusal(Code::kOverLimit, "an equation would have more than " +
                                           std::to_string(kMaxCoefficients) + " coefficients");
  }
  std::vector<Rational> coefficients;
  for (Bezier<Rational, N>& scalar : scalars) {
    for (std::size_t a = 0; a < N; ++a)
      while (scalar.degree(a) < degrees[a]) scalar = raised(scalar, a);
    for (const Rational& c : scalar.component(0)) coefficients.push_back(c);
  }
  auto exact = std::make_shared<const Bezier<Rational, N>>(degrees, static_cast<int>(N), false,
                                                           std::move(coefficients));
  const ScopedUpward upward;
  Piece local = rounded(*exact);
  return PolynomialSystem(std::move(exact), ExactBox<N>::unit(), std::move(local), 53);
}

template <std::size_t N>
std::optional<std::size_t> PolynomialSystem<N>::zero_equation() const {
  for (std::size_t c = 0; c < N; ++c) {
    const auto values = exact_->component(static_cast<int>(c));
    if (std::all_of(values.begin(), values.end(),
                    [](const Rational& v) { return v.sign() == Sign::kZero; }))
      return c;
  }
  return std::nullopt;
}

template <std::size_t N>
std::optional<PolynomialSystem<N>> PolynomialSystem<N>::zoom(const ExactBox<N>& frame,
                                                             int max_precision) const {
  for (int precision = std::max(kFirstPrecision, precision_); precision <= max_precision;
       precision *= 2)
    if (auto local = WideEquations<N>(*exact_, frame, precision).independent())
      return PolynomialSystem(exact_, frame, std::move(*local), precision);
  return std::nullopt;
}

template <std::size_t N>
bool PolynomialSystem<N>::vanishes_at(const std::array<Rational, N>& point) const {
  for (const Rational& v : evaluate(*exact_, point))
    if (v.sign() != Sign::kZero) return false;
  return true;
}

template class PolynomialSystem<1>;
template class PolynomialSystem<2>;
template class PolynomialSystem<3>;
template class PolynomialSystem<4>;

}  // namespace veritope
