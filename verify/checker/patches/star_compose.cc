// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_compose.cc: W^d q(F / W) in integers of one width: sums and products modulo 2^(64 n), where n limbs hold every
// coefficient of the result.
#include "star_compose.h"

#include "star_poly.h"
#include "star_ring.h"

namespace {

// The place of y1^a y2^b y3^c among the coefficients of degree d: a, then b, then c rising.
size_t place_of(int d, int a, int b, int c) {
  int at = c;
  for (int i = 0; i < b; ++i) at += d - a - i + 1;
  for (int i = 0; i < a; ++i) at += (d - i + 1) * (d - i + 2) / 2;
  return size_t(at);
}

int64_t length_of(const Separator& q) {  // in bits
  uint64_t any = 0;
  for (int64_t f : q.coefficients) any |= magnitude(f);
  return bit_length(any);
}

// The sum of coefficient times v1^a v2^b v3^c v4^(d - a - b - c), v = x - o and w: Horner's scheme, variable by
// variable, so that there are few products.
template <int N>
struct Composition {
  Ring<N> ring;
  const Separator& q;
  const Wide* v;
  int few;  // limbs that hold the coefficients of v

  // Adds to *to the terms of v^power times monomials of degree `left` in the variables from `first` on, without
  // v^power.
  void add(int first, int* power, int left, Wide* to) const {
    const size_t w = size_t(ring.width());
    for (int i = first; i < 4; ++i) {
      ++power[i];
      if (left == 1) {
        const int64_t f = q.coefficients[place_of(q.degree, power[0], power[1], power[2])];
        for (size_t at = 0; at < to->d.size() && f != 0; at += w)
          ring.add_multiple(&to->d[at], &v[i].d[at], f);
      } else {
        Wide rest = zero(left - 1);
        add(i, power, left - 1, &rest);
        ring.add_product(to, v[i], rest, few);
      }
      --power[i];
    }
  }
  Wide zero(int degree) const {
    const Shape& s = v[0].shape;
    Wide r = {Shape{s.is_triangle, degree * s.p, degree * s.q}, {}};
    r.d.resize(size_t(r.shape.count()) * size_t(ring.width()));
    return r;
  }
  Block value() const {
    int power[4] = {0, 0, 0, 0};
    Wide r = zero(q.degree);
    add(0, power, q.degree, &r);
    Block b;
    b.n = ring.width();
    b.d = std::move(r.d);
    return b;
  }
};
Block composed(const Separator& q, const Wide* v, int n, int few) {
  switch (n) {
    case 1: return Composition<1>{{n}, q, v, few}.value();
    case 2: return Composition<2>{{n}, q, v, few}.value();
    case 3: return Composition<3>{{n}, q, v, few}.value();
    case 4: return Composition<4>{{n}, q, v, few}.value();
    case 5: return Composition<5>{{n}, q, v, few}.value();
    case 6: return Composition<6>{{n}, q, v, few}.value();
    case 7: return Composition<7>{{n}, q, v, few}.value();
    case 8: return Composition<8>{{n}, q, v, few}.value();
    default: return Composition<0>{{n}, q, v, few}.value();
  }
}

}  // namespace

LocalNet local_net(const Patch& p, const Node& node, const int64_t* o) {
  Block b, x, w;
  b.n = node.net.n + 2;  // o and the binomials have one limb each
  const size_t n = size_t(b.n), count = size_t(p.shape.count());
  b.d.resize(4 * count * n);
  x.d.resize(n), w.d.resize(n);
  const Ring<0> ring = {b.n};
  each_pair_of_binomials(p.shape, [&](size_t i, int64_t one, int64_t other) {
    const int64_t factor = one * other;
    const size_t weight = size_t(node.weight(p, int(i)) - node.net.d.data()) / size_t(node.net.n);
    put(node.net, weight, 0, w.d.data(), b.n);
    ring.add_multiple(&b.d[(4 * i + 3) * n], w.d.data(), factor);
    for (size_t k = 0; k < 3; ++k) {
      put(node.net, (p.is_rational ? 4 : 3) * i + k, 0, x.d.data(), b.n);
      ring.add_multiple(x.d.data(), w.d.data(), -o[k]);
      ring.add_multiple(&b.d[(4 * i + k) * n], x.d.data(), factor);
    }
  });
  LocalNet r = {p.shape, std::move(b), 0};
  shrink(&r.numbers);
  r.bits = bits_of(r.numbers);
  return r;
}

int sign_of(const Block& b) {
  const Ring<0> ring = {b.n};
  const int first = ring.sign(b.d.data());
  for (size_t at = 0; at < b.d.size(); at += size_t(b.n))
    if (ring.sign(&b.d[at]) != first) return 0;
  return first;
}

Block composed(const Separator& q, const LocalNet& net) {
  const Shape& s = net.shape;
  // Each of at most 20 terms is a coefficient times a product of `degree` polynomials, each of which has at most
  // 2^(p + q) coefficients.
  const int64_t up = int64_t(magnitude(q.scale));
  const int64_t length = net.bits + up, bits = length_of(q) + 5 + q.degree * (length + s.p + s.q);
  const int n = int(bits / 64 + 1), few = int(length / 64 + 1);
  Wide v[4];
  for (size_t k = 0; k < 4; ++k) {
    v[k] = Wide{s, std::vector<uint64_t>(size_t(s.count()) * size_t(n))};
    for (size_t i = 0; i < size_t(s.count()); ++i)
      put(net.numbers, 4 * i + k, (q.scale > 0) == (k == 3) ? up : 0, &v[k].d[i * size_t(n)], n);
  }
  return composed(q, v, n, few);
}
