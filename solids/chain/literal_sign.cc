// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <deque>
#include <span>
#include <utility>

#include "solids/chain/integer_net_internal.h"
#include "solids/chain/literal_sign_internal.h"

namespace veritope::internal {
namespace {

struct CoefficientSigns {
  bool has_positive = false, has_negative = false;
};
template <typename Number>
CoefficientSigns signs_of(std::span<const Number> f) {
  CoefficientSigns out;
  for (const Number& c : f) {
    out.has_positive = out.has_positive || c.sign() > 0;
    out.has_negative = out.has_negative || c.sign() < 0;
  }
  return out;
}

struct SignPiece {
  IntegerNet f;
  std::array<Barycentric<Rational>, 3> corners;
};

Barycentric<Rational> centre_of(const SignPiece& piece) {
  Barycentric<Rational> out;
  for (const auto& corner : piece.corners)
    for (std::size_t k = 0; k < 3; ++k) out[k] += corner[k] / Rational(3);
  return out;
}

Barycentric<Rational> middle(const Barycentric<Rational>& a, const Barycentric<Rational>& b) {
  Barycentric<Rational> out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = (a[k] + b[k]) / Rational(2);
  return out;
}

// Parameters of a corner or of the middle at which f is negative.
std::optional<Barycentric<Rational>> negative_place(const SignPiece& piece) {
  const int n = piece.f.degree();
  const std::array<std::size_t, 3> at{triangle_index(0, 0), triangle_index(n, 0),
                                      triangle_index(0, n)};
  for (std::size_t k = 0; k < 3; ++k)
    if (piece.f.component(0)[at[k]].sign() < 0) return piece.corners[k];
  if (evaluate<Integer>(piece.f, {1, 1, 1})[0].sign() < 0) return centre_of(piece);
  return std::nullopt;
}

// The order of split_in_four.
std::array<std::array<Barycentric<Rational>, 3>, 4> quarters(const SignPiece& p) {
  const auto &c0 = p.corners[0], &c1 = p.corners[1], &c2 = p.corners[2];
  const auto m0 = middle(c1, c2), m1 = middle(c0, c2), m2 = middle(c0, c1);
  return {{{c0, m2, m1}, {m2, c1, m0}, {m1, m0, c2}, {m0, m1, m2}}};
}

Rational at_half(std::vector<Rational> f) {
  for (std::size_t left = f.size(); left > 1; --left)
    for (std::size_t i = 0; i + 1 < left; ++i) f[i] = (f[i] + f[i + 1]) / Rational(2);
  return f.front();
}

std::array<std::vector<Rational>, 2> halves_of(std::vector<Rational> f) {
  std::array<std::vector<Rational>, 2> out{f, f};
  const std::size_t n = f.size();
  for (std::size_t level = 0; level < n; ++level) {
    out[0][level] = f[0];
    out[1][n - 1 - level] = f[n - 1 - level];
    for (std::size_t i = 0; i + level + 1 < n; ++i) f[i] = (f[i] + f[i + 1]) / Rational(2);
  }
  return out;
}

struct CurvePiece {
  std::vector<Rational> f;
  Rational begin, end;
};

}  // namespace

NowhereNegative nowhere_negative(const BezierTriangle<Rational>& f) {
  const CoefficientSigns all = signs_of<Rational>(f.component(0));
  NowhereNegative out;
  out.is_zero = !all.has_positive && !all.has_negative;
  const Rational o(1), z;
  std::deque<SignPiece> pieces;
  pieces.push_back({integer_net(f), {{{o, z, z}, {z, o, z}, {z, z, o}}}});
  for (std::size_t examined = 0; !pieces.empty(); examined += f.count()) {
    if (examined > kMostCoefficients) return out;
    const SignPiece piece = std::move(pieces.front());
    pieces.pop_front();
    if (!signs_of<Integer>(piece.f.component(0)).has_negative) continue;
    out.where = negative_place(piece);
    if (out.where) {
      out.decision = Decision::kViolated;
      return out;
    }
    auto parts = quarters_of(piece.f);
    const auto corners = quarters(piece);
    for (std::size_t k = 0; k < 4; ++k) pieces.push_back({std::move(parts[k]), corners[k]});
  }
  out.decision = Decision::kHolds;
  return out;
}

NowhereNegativeCurve nowhere_negative(std::vector<Rational> f) {
  const CoefficientSigns all = signs_of<Rational>(f);
  NowhereNegativeCurve out;
  out.is_zero = !all.has_positive && !all.has_negative;
  const std::size_t count = f.size();
  std::deque<CurvePiece> pieces;
  pieces.push_back({std::move(f), Rational(0), Rational(1)});
  for (std::size_t examined = 0; !pieces.empty(); examined += count) {
    if (examined > kMostCoefficients) return out;
    const CurvePiece piece = std::move(pieces.front());
    pieces.pop_front();
    if (!signs_of<Rational>(piece.f).has_negative) continue;
    const Rational half = (piece.begin + piece.end) / Rational(2);
    if (piece.f.front().sign() < 0) out.where = piece.begin;
    if (piece.f.back().sign() < 0) out.where = piece.end;
    if (at_half(piece.f).sign() < 0) out.where = half;
    if (out.where) {
      out.decision = Decision::kViolated;
      return out;
    }
    auto parts = halves_of(piece.f);
    pieces.push_back({std::move(parts[0]), piece.begin, half});
    pieces.push_back({std::move(parts[1]), half, piece.end});
  }
  out.decision = Decision::kHolds;
  return out;
}

}  // namespace veritope::internal
