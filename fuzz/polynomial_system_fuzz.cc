// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/polynomial_system_fuzz.cc: the bytes are the small integer coefficients of a polynomial system. With one
// unknown, every claim is compared with Sturm's count. With 2 to 4, the equations are shifted so that they vanish at a
// fraction given by the bytes: it must lie in exactly one root's box or in a cluster, and in no other root's uniqueness
// box.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <vector>

#include "interval/solvers/polynomial_roots.h"
#include "splines/de_casteljau.h"
#include "tests/interval/sturm.h"

namespace {

using namespace veritope;

class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  int next() { return size_ == 0 ? 0 : (--size_, *data_++); }
  int below(int n) { return next() % n; }
  int small() { return static_cast<std::int8_t>(next()); }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

template <std::size_t N>
[[noreturn]] void fail(const char* what, const std::vector<Bezier<Rational, N>>& equations) {
  std::fprintf(stderr, "%s\n", what);
  for (const auto& e : equations) {
    for (const int d : e.degrees()) std::fprintf(stderr, "degree %d ", d);
    for (const Rational& c : e.coefficients()) std::fprintf(stderr, " %s", c.to_string().c_str());
    std::fprintf(stderr, "\n");
  }
  std::abort();
}

template <std::size_t N>
RootReport<N> solve(const std::vector<Bezier<Rational, N>>& equations) {
  SolverOptions options;
  options.max_boxes = 3000;
  options.max_precision = 1024;
  return polynomial_roots<N>(std::span<const Bezier<Rational, N>>(equations), options).value();
}

// Converts Bernstein coefficients to powers.
sturm::Polynomial powers(std::span<const Rational> c) {
  std::vector<Rational> d(c.begin(), c.end());
  sturm::Polynomial out;
  Rational binomial(1);
  for (std::size_t k = 0; k < c.size(); ++k) {
    out.push_back(binomial * d[0]);
    for (std::size_t i = 0; i + k + 1 < c.size(); ++i) d[i] = d[i + 1] - d[i];
    binomial *= Rational(c.size() - 1 - k) / Rational(k + 1);
  }
  return out;
}

void one_unknown(Bytes& bytes) {
  const int degree = bytes.below(9);
  std::vector<Rational> c;
  for (int i = 0; i <= degree; ++i) c.emplace_back(bytes.small());
  const std::vector<Bezier<Rational, 1>> equations{Bezier<Rational, 1>({degree}, 1, false, c)};
  const RootReport<1> report = solve(equations);
  sturm::Polynomial p = powers(c);
  sturm::trim(p);
  if (p.empty()) {
    if (report.clusters.size() != 1) fail("a zero polynomial is one cluster", equations);
    return;
  }
  const sturm::Sequence roots(p);
  int outside = 0;
  for (const auto& r : report.roots) {
    if (roots.count(r.box[0].lo, r.box[0].hi) != 1 ||
        roots.count(r.unique_in[0].lo, r.unique_in[0].hi) != 1)
      fail("a root's boxes hold one root", equations);
    const int inside =
        roots.count(Rational(0), Rational(1)) == 0
            ? 0
            : roots.count(std::max(r.box[0].lo, Rational(0)), std::min(r.box[0].hi, Rational(1)));
    if (r.place != RootPlace::kAtBoundary && inside != 1)
      fail("a root is in the domain", equations);
    outside += 1 - inside;
  }
  int in_clusters = 0;
  for (const auto& part : report.clusters) {
    in_clusters += roots.count(part.box[0].lo, part.box[0].hi);
    for (const auto& r : report.roots)
      if (touches(part.box, r.box))
        in_clusters -= roots.count(std::max(part.box[0].lo, r.box[0].lo),
                                   std::min(part.box[0].hi, r.box[0].hi));
    if (part.exact && sturm::value(p, (*part.exact)[0]) != Rational(0))
      fail("a cluster's root is one", equations);
  }
  if (static_cast<int>(report.roots.size()) - outside + in_clusters !=
      roots.count(Rational(0), Rational(1)))
    fail("Sturm counts otherwise", equations);
}

template <std::size_t N>
void more_unknowns(Bytes& bytes, int max_degree) {
  std::array<Rational, N> point;
  for (Rational& x : point) {
    const int q = 1 + bytes.below(20);
    x = Rational(bytes.below(q + 1)) / Rational(q);
  }
  std::vector<Bezier<Rational, N>> equations;
  for (std::size_t e = 0; e < N; ++e) {
    std::array<int, N> degrees;
    for (int& d : degrees) d = bytes.below(max_degree + 1);
    Bezier<Rational, N> map(degrees, 1, false);
    for (Rational& c : map.coefficients()) c = Rational(bytes.small());
    const Rational at = evaluate(map, point)[0];
    for (Rational& c : map.coefficients()) c -= at;
    equations.push_back(std::move(map));
  }
  const RootReport<N> report = solve(equations);
  int isolated = 0, unique = 0;
  bool in_cluster = false;
  for (const auto& r : report.roots) {
    isolated += r.box.contains(point);
    unique += r.unique_in.contains(point) && !r.box.contains(point);
    for (const auto& s : report.roots)
      if (&r != &s && touches(r.box, s.box)) fail("boxes of two roots touch", equations);
  }
  for (const auto& part : report.clusters) in_cluster = in_cluster || part.box.contains(point);
  if (isolated > 1 || isolated + (in_cluster ? 1 : 0) == 0)
    fail("a root is lost or doubled", equations);
  if (unique > 0) fail("a second root where there is one", equations);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  switch (bytes.below(4)) {
    case 0: one_unknown(bytes); break;
    case 1: more_unknowns<2>(bytes, 3); break;
    case 2: more_unknowns<3>(bytes, 2); break;
    default: more_unknowns<4>(bytes, 1);
  }
  return 0;
}
