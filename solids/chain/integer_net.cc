// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/integer_net_internal.h"

namespace veritope::internal {

IntegerNet integer_net(const BezierTriangle<Rational>& map) {
  Integer scale(1);
  for (const Rational& c : map.coefficients()) scale = lcm(scale, c.denominator());
  IntegerNet out(map.degree(), map.num_components(), false);
  const auto to = out.coefficients();
  const auto from = map.coefficients();
  for (std::size_t i = 0; i < from.size(); ++i)
    to[i] = from[i].numerator() * divide_exactly(scale, from[i].denominator());
  return out;
}

namespace {

using Counts = std::array<int, 3>;
std::size_t index_of(const Counts& n) { return triangle_index(n[1], n[2]); }

// Restricts the map to the triangle whose corner `corner` is replaced, times 2^(bits degree): p is 2^bits times the
// barycentric coordinates of the new corner. After s steps of the scheme of de Casteljau with p, the coefficients
// without the old corner are those of the new triangle with the new corner s times.
IntegerNet with_corner(const IntegerNet& net, std::size_t corner, const Barycentric<Integer>& p,
                       std::uint64_t bits) {
  IntegerNet out(net.degree(), net.num_components(), false);
  const int n = net.degree();
  std::vector<Integer> work;
  for (int c = 0; c < net.num_components(); ++c) {
    work.assign(net.component(c).begin(), net.component(c).end());
    for (int s = 0; s <= n; ++s) {
      if (s > 0) set_argument(work.data(), n - s + 1, p);
      for (int a = 0; a <= n - s; ++a) {
        Counts from{}, to{};
        from[(corner + 1) % 3] = to[(corner + 1) % 3] = a;
        from[(corner + 2) % 3] = to[(corner + 2) % 3] = n - s - a;
        to[corner] = s;
        out.component(c)[index_of(to)] = work[index_of(from)]
                                         << (bits * static_cast<std::uint64_t>(n - s));
      }
    }
  }
  return out;
}

IntegerNet with_corners_0_and_2_exchanged(const IntegerNet& net) {
  IntegerNet out = net;
  for (int c = 0; c < net.num_components(); ++c)
    for_each_triangle_index(net.degree(), [&](int i, int j, int k) {
      out.component(c)[triangle_index(j, i)] = net.component(c)[triangle_index(j, k)];
    });
  return out;
}

// Divides by 2^degree. REQUIRES that this leaves integers.
IntegerNet reduced(IntegerNet net) {
  for (Integer& x : net.coefficients()) x.shift_right(static_cast<std::uint64_t>(net.degree()));
  return net;
}

}  // namespace

// Two corners become middles, one after the other, which gives the factor 4^degree; with all three arguments of a
// blossom doubled it is 2^degree, so that half of these bits are zeros. The triangle in the middle has the corner m1 =
// m2 + m0 - c1 in the place of c1 in that at c1.
std::array<IntegerNet, 4> quarters_of(const IntegerNet& net) {
  const Barycentric<Integer> m0{0, 1, 1}, m1{1, 0, 1}, m2{1, 1, 0};
  std::array<IntegerNet, 4> out{reduced(with_corner(with_corner(net, 1, m2, 1), 2, m1, 1)),
                                reduced(with_corner(with_corner(net, 0, m2, 1), 2, m0, 1)),
                                reduced(with_corner(with_corner(net, 0, m1, 1), 1, m0, 1)), net};
  out[3] = with_corners_0_and_2_exchanged(with_corner(out[1], 1, {1, -1, 1}, 0));
  return out;
}

}  // namespace veritope::internal
