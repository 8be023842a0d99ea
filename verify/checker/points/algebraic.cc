// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "algebraic.h"

namespace {

const uint64_t kMostPolyDegree = 64;

RationalPoly read_poly(Bytes* bytes) {
  RationalPoly p;
  const uint64_t degree =
      bytes->at_most(bytes->body.natural(1), kMostPolyDegree, "the degree of a polynomial is");
  for (uint64_t i = 0; i <= degree; ++i) p.c.push_back(bytes->rational());
  return p;
}

Ratio sum(const Ratio& x, const Ratio& y) {
  return lowest(Ratio(x.n * y.d + y.n * x.d, x.d * y.d));
}
Ratio product(const Ratio& x, const Ratio& y) { return lowest(Ratio(x.n * y.n, x.d * y.d)); }

int sign_at(const RationalPoly& p, const Ratio& t) {
  Ratio r;
  for (size_t i = p.c.size(); i-- > 0;) r = sum(product(r, t), p.c[i]);
  return r.n.sign();
}
RationalPoly difference(const RationalPoly& p, const RationalPoly& q) {
  RationalPoly r = p;
  r.c.resize(std::max(p.c.size(), q.c.size()));
  for (size_t i = 0; i < q.c.size(); ++i) r.c[i] = r.c[i] - q.c[i];
  return r;
}
RationalPoly one() { return RationalPoly{std::vector<Ratio>(1, Ratio(Big(1)))}; }

// Polynomials modulo M: c / d, d > 0, with as many integers c as the degree of M.
struct Residue {
  std::vector<Big> c;
  Big d = 1;
};
class Residues {
 public:
  explicit Residues(const RationalPoly& modulus) : m_(integers(modulus).c) {
    if (m_.back().sign() < 0)
      for (Big& x : m_) x = -x;
  }
  static Residue integers(const RationalPoly& p) {
    Residue r;
    for (const Ratio& x : p.c) r.d = r.d * divide(x.d, gcd(r.d, x.d), nullptr);
    for (const Ratio& x : p.c) r.c.push_back(x.n * divide(r.d, x.d, nullptr));
    return r;
  }
  Residue of(const RationalPoly& p) const { return reduced(integers(p)); }
  Residue times(const Residue& f, const Residue& g) const {
    Residue r;
    r.d = f.d * g.d;
    r.c.resize(f.c.size() + g.c.size());
    for (size_t i = 0; i < f.c.size(); ++i)
      for (size_t j = 0; j < g.c.size(); ++j)
        if (f.c[i].sign() != 0 && g.c[j].sign() != 0) r.c[i + j] = r.c[i + j] + f.c[i] * g.c[j];
    return reduced(std::move(r));
  }
  // f + factor g.
  static Residue added(const Residue& f, const Residue& g, const Big& factor) {
    Residue r;
    const Big both = gcd(f.d, g.d), of_f = divide(g.d, both, nullptr),
              of_g = divide(f.d, both, nullptr) * factor;
    r.d = f.d * of_f;
    for (size_t i = 0; i < f.c.size(); ++i) r.c.push_back(f.c[i] * of_f + g.c[i] * of_g);
    return r;
  }
  Residue zero() const {
    Residue r;
    r.c.resize(m_.size() - 1);
    return r;
  }
  // f^(n - i) g^i for all i.
  std::vector<Residue> products(const Residue& f, const Residue& g, int n) const {
    const std::vector<Residue> x = powers(f, n), y = powers(g, n);
    std::vector<Residue> r;
    for (int i = 0; i <= n; ++i) r.push_back(times(x[size_t(n - i)], y[size_t(i)]));
    return r;
  }
  std::vector<Residue> powers(const Residue& f, int n) const {
    std::vector<Residue> r(1, of(one()));
    for (int i = 0; i < n; ++i) r.push_back(times(r.back(), f));
    return r;
  }

 private:
  Residue reduced(Residue f) const {
    const size_t n = m_.size() - 1;
    for (; f.c.size() > n; f.c.pop_back()) {
      const Big top = f.c.back();
      if (top.sign() == 0) continue;
      const size_t low = f.c.size() - 1 - n;
      for (size_t i = 0; i + 1 < f.c.size(); ++i) {
        f.c[i] = f.c[i] * m_[n];
        if (i >= low) f.c[i] = f.c[i] - top * m_[i - low];
      }
      f.d = f.d * m_[n];
    }
    f.c.resize(n);
    Big common = f.d;
    for (size_t i = 0; i < n && !(common == Big(1)); ++i) common = gcd(common, f.c[i]);
    if (common == Big(1)) return f;
    for (Big& x : f.c) x = divide(x, common, nullptr);
    f.d = divide(f.d, common, nullptr);
    return f;
  }
  std::vector<Big> m_;  // the last one is > 0
};

Big binomial(int n, int k) {
  Big r = 1;
  for (int i = 0; i < k; ++i) r = divide(r * Big(n - i), Big(i + 1), nullptr);
  return r;
}
// Whether all Bernstein coefficients on [a, b] have at least this sign. By the polar form f of p: coefficient i is f
// of n - i times a and i times b, where t^k has the elementary symmetric function k, divided by its number of terms.
bool has_least_sign(const RationalPoly& p, const Ratio& a, const Ratio& b, int least) {
  const int n = int(p.c.size()) - 1;
  const std::vector<Big> c = Residues::integers(p).c;
  const Big unit = a.d * b.d, from = a.n * b.d, to = b.n * a.d;  // of both ends, times unit
  Big terms = 1;                                                 // a multiple of all binomials
  for (int k = 0; k <= n; ++k)
    terms = terms * divide(binomial(n, k), gcd(terms, binomial(n, k)), nullptr);
  for (int i = 0; i <= n; ++i) {
    std::vector<Big> e(1, Big(1));  // of (unit + from x)^(n - i) (unit + to x)^i
    for (int k = 0; k < n; ++k) {
      e.push_back(Big());
      for (size_t j = e.size(); j-- > 0;)
        e[j] = unit * e[j] + (j > 0 ? (k < i ? to : from) * e[j - 1] : Big());
    }
    Big value;
    for (int k = 0; k <= n; ++k)
      value = value + c[size_t(k)] * e[size_t(k)] * divide(terms, binomial(n, k), nullptr);
    if (value.sign() < least) return false;
  }
  return true;
}
// Component k of R for the homogeneous control point at net[at].
Big relative(const std::vector<Big>& net, size_t at, int k, const RationalPoint& q) {
  return q.d * net[at + size_t(k)] - net[at + 3] * q.n[k];
}
bool is_zero(const Residue& f) {
  for (const Big& x : f.c)
    if (x.sign() != 0) return false;
  return true;
}

}  // namespace

Algebraic Algebraic::read(Bytes* bytes) {
  Algebraic r;
  r.modulus = read_poly(bytes);
  r.a = bytes->rational();
  r.b = bytes->rational();
  r.u = read_poly(bytes);
  r.v = read_poly(bytes);
  require(r.modulus.c.size() > 1 && r.modulus.c.back().n.sign() != 0, "B1",
          "the polynomial of an algebraic number has another degree");
  require(compare(r.a, r.b) < 0, "B1", "an interval's ends fall");
  return r;
}

uint64_t Algebraic::size() const {
  return std::max(modulus.c.size(), std::max(u.c.size(), v.c.size()));
}
uint64_t Algebraic::units(const Grid& grid, const RationalPoint& q) const {
  int64_t g = std::max(std::max(a.n.bits(), a.d.bits()), std::max(b.n.bits(), b.d.bits()));
  for (const RationalPoly* p : {&modulus, &u, &v})
    for (const Ratio& x : p->c) g = std::max(g, std::max(x.n.bits(), x.d.bits()));
  const uint64_t h =
      uint64_t(grid.bits + q.bits) + grid.degrees() * (size() + 1) * uint64_t(g);  // below 2^26
  return 16 + uint64_t(u128(grid.count() + 4 * grid.degrees()) * size() * size() * h * h >> 22);
}

bool Algebraic::is_in_domain(bool of_triangle, int least) const {
  const RationalPoly not_u = difference(one(), u), not_v = difference(one(), v);
  return has_least_sign(u, a, b, least) && has_least_sign(v, a, b, least) &&
         (of_triangle ? has_least_sign(difference(not_u, v), a, b, least)
                      : has_least_sign(not_u, a, b, least) && has_least_sign(not_v, a, b, least));
}

const char* Algebraic::why_not_on(const Grid& grid, const RationalPoint& q) const {
  if (sign_at(modulus, a) * sign_at(modulus, b) >= 0) return "no root of the polynomial is shown";
  const RationalPoly not_u = difference(one(), u), not_v = difference(one(), v),
                     rest = difference(not_u, v);
  if (!is_in_domain(grid.is_triangle, 0)) return "the parameters may leave the domain";

  const Residues ring(modulus);
  const int p = grid.shape.p;
  // Factors of the rows, and of the points of each row.
  std::vector<Residue> of_rows;
  std::vector<std::vector<Residue>> of_points;
  if (grid.is_triangle) {
    of_rows = ring.powers(ring.of(rest), p);
    std::reverse(of_rows.begin(), of_rows.end());
    for (int r = 0; r <= p; ++r) of_points.push_back(ring.products(ring.of(u), ring.of(v), r));
  } else {
    of_rows = ring.products(ring.of(not_u), ring.of(u), p);
    of_points.assign(1, ring.products(ring.of(not_v), ring.of(v), grid.shape.q));
  }
  for (int k = 0; k < 3; ++k) {
    Residue sum = ring.zero();
    size_t at = 0;
    for (int r = 0; r <= p; ++r) {
      const std::vector<Residue>& factors = of_points[grid.is_triangle ? size_t(r) : 0];
      const int n = int(factors.size()) - 1;
      Residue inner = ring.zero();
      for (int j = 0; j <= n; ++j, at += 4)
        inner = Residues::added(
            inner, factors[size_t(j)],
            binomial(n, j) * relative(grid.is_triangle ? grid.triangle : grid.net, at, k, q));
      sum = Residues::added(sum, ring.times(inner, of_rows[size_t(r)]), binomial(p, r));
    }
    if (!is_zero(sum)) return "the patch has another point at the parameters";
  }
  return nullptr;
}
