// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/fast/fast_pair_internal.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace veritope::internal {
namespace {

// Each operation on pairs has a relative error below 2^-102 [JMP17]; errors of the kernels count 2^-53.
constexpr double kPairUnit = 0x1p-102, kFiner = 0x1p-49, kPairFloor = 0x1p-900;

FastPair two_sum(double a, double b) {
  const double s = a + b, t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}
FastPair quick_sum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}
FastPair two_product(double a, double b) {
  constexpr double kSplit = 0x1p27 + 1;
  const double p = a * b, ca = kSplit * a, cb = kSplit * b;
  const double ah = ca - (ca - a), al = a - ah, bh = cb - (cb - b), bl = b - bh;
  return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
}
FastPair operator+(FastPair x, FastPair y) {
  const FastPair s = two_sum(x.hi, y.hi), t = two_sum(x.lo, y.lo);
  const FastPair v = quick_sum(s.hi, s.lo + t.hi);
  return quick_sum(v.hi, t.lo + v.lo);
}
FastPair operator-(FastPair x) { return {-x.hi, -x.lo}; }
FastPair operator*(FastPair x, FastPair y) {
  const FastPair c = two_product(x.hi, y.hi);
  return quick_sum(c.hi, c.lo + (x.hi * y.lo + x.lo * y.hi));
}
bool operator<(FastPair x, FastPair y) { return x.hi < y.hi || (x.hi == y.hi && x.lo < y.lo); }

struct PairValue {
  FastPair value;
  double error = 0;
};

class PairUnit {
 public:
  PairUnit(const FastRegionUnit& unit, const std::array<Rational, 3>& point)
      : unit_(unit), u_(unit.unit), tables_(*unit.tables) {
    for (std::size_t c = 0; c < 3; ++c)
      at_[c] = pair_of((point[c] - Rational::from_double(u_.origin[c])) *
                       Rational::power_of_two(-tables_.place.exponent));
    values_.resize(1 + u_.num_leaves + u_.num_nodes);
    lambda_.resize(u_.num_frames);
    for (std::size_t i = 0; i < u_.num_leaves; ++i) values_[1 + i] = leaf(u_.leaf_ids[i]);
    for (std::size_t i = 0; i < u_.num_frames; ++i)
      for (std::size_t m = 0; m < 4; ++m)
        lambda_[i][m] = linear(frame(i).lambda[m], tables_.frame_low[4 * u_.frame_ids[i] + m]);
    for (std::size_t i = 0; i < u_.num_nodes; ++i)
      values_[1 + u_.num_leaves + i] = node(u_.nodes[i]);
  }
  bool is_open() const { return is_open_; }

  void add(double slack, bool with_gradient, FastPairSums& sums) const {
    const std::size_t k = u_.components, parts = u_.is_separate ? 4 : 1;
    for (const FastTop& top : unit_.tops) {
      const PairValue& m = values_[top.at];
      const double size_of_m = std::abs(m.value.hi);
      double size = 1, off = 0;
      for (std::size_t c = 0; c < k; ++c) {
        FastPair l;
        if (u_.is_separate) {
          l = number(tables_.value, tables_.value_low, top.number * k + c);
        } else {
          for (std::size_t i = 0; i < 4; ++i)
            l = l + lambda_[top.frame][i] *
                        number(tables_.value, tables_.value_low, (top.number * 4 + i) * k + c);
        }
        sums.value[c] = sums.value[c] + m.value * l;
      }
      if (!u_.is_separate) {
        size = 0;
        for (std::size_t i = 0; i < 4; ++i) {
          size += std::abs(lambda_[top.frame][i].hi);
          off += error_of(frame(top.frame).lambda[i]);
        }
      }
      sums.error += u_.value_weight[top.number] *
                    (size * (m.error + slack * size_of_m) + off * (size_of_m + m.error));
      for (std::size_t p = 0; with_gradient && p < parts; ++p) {
        const PairValue& g = values_[top.part[p]];
        const std::size_t first = (top.number * parts + p) * 3 * k;
        for (std::size_t c = 0; c < 3 * k; ++c)
          sums.gradient[c] = sums.gradient[c] +
                             g.value * number(tables_.gradient, tables_.gradient_low, first + c);
        sums.slope_error +=
            u_.gradient_weight[top.number * parts + p] * (g.error + slack * std::abs(g.value.hi));
      }
    }
  }

 private:
  static FastPair number(const std::vector<double>& high, const std::vector<double>& low,
                         std::size_t i) {
    return {high[i], low[i]};
  }
  const FastFrame& frame(std::size_t i) const { return u_.frames[u_.frame_ids[i]]; }
  static double error_of(const FastLinear& f) { return f.error[0] * kFiner + kPairFloor; }
  FastPair linear(const FastLinear& f, const FastLow& low) const {
    FastPair sum{f.c[0], low.c[0]};
    for (std::size_t c = 0; c < 3; ++c) sum = sum + FastPair{f.c[c + 1], low.c[c + 1]} * at_[c];
    return sum;
  }

  PairValue leaf(std::uint32_t id) {
    const FastLeaf& f = u_.leaves[id];
    const FastLow* const low = &tables_.leaf_low[5 * id];
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    FastPair up{kInfinity, 0}, least;
    // The functions that are nearest to the ends have errors of their own; others count if they may be nearer.
    double up_error = 0, least_error = 0;
    std::array<FastPair, 5> g;
    const std::size_t ends = f.upper + f.lower;
    for (std::size_t i = 0; i < ends; ++i) {
      g[i] = linear(f.g[i], low[i]);
      if (i < f.upper ? g[i] < up : least < g[i]) (i < f.upper ? up : least) = g[i];
    }
    for (std::size_t i = 0; i < ends; ++i) {
      const double error = error_of(f.g[i]);
      const FastPair& end = i < f.upper ? up : least;
      const double away = std::abs((g[i] + -end).hi) * (1 - 0x1p-50);
      double& of_end = i < f.upper ? up_error : least_error;
      of_end = std::max(of_end, error - away);
      if (away == 0) of_end = std::max(of_end, error);
    }
    const FastPair length = up + -least;
    const double rounding = (std::abs(up.hi) + std::abs(least.hi)) * (4 * kPairUnit);
    PairValue out{length, up_error + least_error + rounding};
    if (length.hi + out.error <= 0) return {};
    if (length.hi <= 0) out = {{}, out.error};
    for (std::size_t i = ends; i < ends + f.flat; ++i) {
      const FastPair l = linear(f.g[i], low[i]);
      const double error = error_of(f.g[i]) * 2;
      if (l.hi < -error) return {};
      if (!(l.hi > error)) is_open_ = true;
    }
    return out;
  }

  PairValue node(const FastNode& n) const {
    PairValue out;
    const auto& l = lambda_[n.frame];
    for (std::size_t m = 0; m < 4; ++m) {
      const PairValue& part = values_[n.part[m]];
      out.value = out.value + l[m] * part.value;
      const double size = std::abs(part.value.hi);
      out.error += std::abs(l[m].hi) * (part.error + 10 * kPairUnit * size) +
                   error_of(frame(n.frame).lambda[m]) * (size + part.error);
    }
    return out;
  }

  const FastRegionUnit& unit_;
  const FastUnit& u_;
  const FastTables& tables_;
  std::array<FastPair, 3> at_;
  std::vector<PairValue> values_;
  std::vector<std::array<FastPair, 4>> lambda_;
  bool is_open_ = false;
};

}  // namespace

FastPair pair_of(const Rational& x) {
  const double hi = nearest_double(x);
  return {hi, std::isfinite(hi) ? nearest_double(x - Rational::from_double(hi)) : 0};
}

void add_pairs(const FastRegionUnit& unit, const std::array<Rational, 3>& point, double slack,
               bool with_gradient, FastPairSums& sums) {
  const PairUnit at(unit, point);
  sums.is_open = sums.is_open || at.is_open();
  at.add(slack, with_gradient, sums);
}

}  // namespace veritope::internal
