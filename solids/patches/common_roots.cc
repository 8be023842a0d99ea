// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/patches/common_roots.h"

#include <utility>

#include "robust/base/check.h"
#include "robust/simplest.h"

namespace veritope {
namespace {

// A root with a denominator of at most 2^20 is the simplest number of every interval around it of this width.
constexpr int kIsolatedBits = 42;

void drop_zeros(Polynomial& p) {
  while (!p.empty() && p.back().sign() == Sign::kZero) p.pop_back();
}

// Scales the polynomial by a positive number so that its leading coefficient is 1 or -1: numbers stay short along
// chains of remainders, and signs do not change.
void shorten(Polynomial& p) {
  if (p.empty()) return;
  const Rational scale = abs(p.back());
  for (Rational& c : p) c /= scale;
}

struct Division {
  Polynomial quotient, remainder;
};
// REQUIRES b not zero.
Division divided(Polynomial a, const Polynomial& b) {
  Division out;
  if (a.size() >= b.size()) out.quotient.resize(a.size() - b.size() + 1);
  while (a.size() >= b.size()) {
    const std::size_t shift = a.size() - b.size();
    const Rational factor = a.back() / b.back();
    out.quotient[shift] = factor;
    for (std::size_t i = 0; i < b.size(); ++i) a[i + shift] -= factor * b[i];
    a.back() = Rational();
    drop_zeros(a);
  }
  out.remainder = std::move(a);
  return out;
}

Polynomial common_divisor(Polynomial a, Polynomial b) {
  while (!b.empty()) {
    Polynomial rest = divided(std::move(a), b).remainder;
    shorten(rest);
    a = std::exchange(b, std::move(rest));
  }
  return a;
}

Polynomial derivative(const Polynomial& p) {
  Polynomial out;
  for (std::size_t i = 1; i < p.size(); ++i) out.push_back(p[i] * Rational(i));
  return out;
}

Sign sign_at(const Polynomial& p, const Rational& t) {
  Rational value;
  for (std::size_t i = p.size(); i-- > 0;) value = value * t + p[i];
  return value.sign();
}

// A polynomial without multiple roots, and the Sturm chain that counts them.
class Isolation {
 public:
  explicit Isolation(Polynomial p) {
    chain_.push_back(std::move(p));
    chain_.push_back(derivative(chain_[0]));
    while (chain_.back().size() > 1) {
      Polynomial rest = divided(chain_[chain_.size() - 2], chain_.back()).remainder;
      for (Rational& c : rest) c.negate();
      shorten(rest);
      chain_.push_back(std::move(rest));
    }
  }

  std::vector<std::array<Rational, 2>> run() {
    const Rational zero(0), one(1);
    if (is_root(zero)) out_.push_back({zero, zero});
    isolate(zero, one, 0);
    if (is_root(one)) out_.push_back({one, one});
    return std::move(out_);
  }

 private:
  bool is_root(const Rational& t) const { return sign_at(chain_[0], t) == Sign::kZero; }

  int changes_at(const Rational& t) const {
    int changes = 0;
    Sign last = Sign::kZero;
    for (const Polynomial& p : chain_) {
      const Sign s = sign_at(p, t);
      if (s == Sign::kZero) continue;
      changes += last != Sign::kZero && s != last ? 1 : 0;
      last = s;
    }
    return changes;
  }
  // The number of roots in the open interval. The chain counts those of (lo, hi].
  int count(const Rational& lo, const Rational& hi) const {
    return changes_at(lo) - changes_at(hi) - (is_root(hi) ? 1 : 0);
  }

  void isolate(const Rational& lo, const Rational& hi, int bits) {
    const int n = count(lo, hi);
    if (n == 0) return;
    if (n == 1 && !is_root(lo) && !is_root(hi)) {
      narrow(lo, hi, bits);
      return;
    }
    const Rational middle = (lo + hi) / Rational(2);
    isolate(lo, middle, bits + 1);
    if (is_root(middle)) out_.push_back({middle, middle});
    isolate(middle, hi, bits + 1);
  }

  // Keeps the one root between lo and hi, at which the sign changes.
  void narrow(Rational lo, Rational hi, int bits) {
    const Sign below = sign_at(chain_[0], lo);
    for (; bits < kIsolatedBits; ++bits) {
      Rational middle = (lo + hi) / Rational(2);
      const Sign sign = sign_at(chain_[0], middle);
      if (sign == Sign::kZero) {
        out_.push_back({middle, middle});
        return;
      }
      (sign == below ? lo : hi) = std::move(middle);
    }
    const Rational simplest = simplest_between(lo, hi);
    if (is_root(simplest)) {
      out_.push_back({simplest, simplest});
    } else {
      out_.push_back({std::move(lo), std::move(hi)});
    }
  }

  std::vector<Polynomial> chain_;
  std::vector<std::array<Rational, 2>> out_;
};

}  // namespace

Polynomial polynomial_of(std::span<const Rational> bernstein) {
  // The coefficient of t^k is binomial(n, k) times the k-th difference at 0.
  Polynomial out;
  std::vector<Rational> differences(bernstein.begin(), bernstein.end());
  const std::size_t n = bernstein.size() - 1;
  Rational binomial(1);
  for (std::size_t k = 0; k <= n; ++k) {
    out.push_back(binomial * differences[0]);
    for (std::size_t i = 0; i + k < n; ++i) differences[i] = differences[i + 1] - differences[i];
    binomial = binomial * Rational(n - k) / Rational(k + 1);
  }
  drop_zeros(out);
  return out;
}

CommonRoots common_roots(std::span<const Polynomial> polynomials) {
  VT_CHECK(!polynomials.empty(), "common roots of no polynomial");
  Polynomial common;
  for (const Polynomial& p : polynomials) {
    common = common_divisor(std::move(common), p);
    if (common.size() == 1) return {};
  }
  CommonRoots out;
  if (common.empty()) {
    out.is_everywhere = true;
    return out;
  }
  common = divided(common, common_divisor(common, derivative(common))).quotient;
  if (common.size() == 2) {
    const Rational root = -common[0] / common[1];
    if (Rational(0) <= root && root <= Rational(1)) out.roots.push_back({root, root});
  } else {
    out.roots = Isolation(common).run();
  }
  if (!out.roots.empty()) out.polynomial = std::move(common);
  return out;
}

}  // namespace veritope
