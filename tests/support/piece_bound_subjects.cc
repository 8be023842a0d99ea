// SPDX-License-Identifier: LGPL-3.0-or-later
#include "tests/support/piece_bound_subjects.h"

#include <algorithm>

#include "solids/pieces/piece_net_quarters_internal.h"

namespace veritope::internal {
// Over rationals an average does not round.
template <>
inline Rational average(const Rational& a, const Rational& b) {
  return (a + b) * Rational::power_of_two(-1);
}
}  // namespace veritope::internal

namespace veritope::piece_bounds {
namespace {

template <typename Number>
std::vector<std::vector<Number>> quarters(const FormShape& shape, const std::vector<Number>& net) {
  std::vector<std::vector<Number>> out(4, net);
  Number* const to[4] = {out[0].data(), out[1].data(), out[2].data(), out[3].data()};
  if (shape.is_triangle)
    internal::quarter_triangle(shape.p, net.data(), to);
  else
    internal::quarter_tensor(shape, net.data(), to);
  return out;
}

// The lower end of a hull as the code in piece_forest.cc computes it, and the slack.
Numbers lower_end(double lo, double hi, double origin, bool is_rational) {
  const double slack = internal::hull_slack(lo, hi, origin, is_rational);
  return {origin + lo - slack, slack};
}
double share_of_slack(const Rational& exact, const Numbers& found) {
  const Rational slack = Rational::from_double(found[1]);
  return nearest_double((Rational::from_double(found[0]) + slack - exact) / slack);
}

}  // namespace

double share_of_quarters(const FormShape& shape, const Numbers& net, Rounding mode) {
  const Numbers found = computed(mode, net, [&](const Numbers& in) {
    double size = 0;
    for (const double v : in) size = std::max(size, std::abs(v));
    Numbers out{internal::error_after_halving(0, size, internal::quarter_depth(shape))};
    for (const Numbers& child : quarters(shape, in))
      out.insert(out.end(), child.begin(), child.end());
    return out;
  });
  double worst = 0;
  std::size_t at = 1;
  for (const auto& child : quarters(shape, exactly(net)))
    for (const Rational& exact : child)
      worst = std::max(worst, share(Rational::from_double(found[at++]) - exact, found[0]));
  return worst;
}

double share_of_side(const Numbers& in, Rounding mode) {
  const Numbers found = computed(mode, in, [](const Numbers& v) {
    const std::array<double, 3> x{v[4] - v[7], v[5] - v[8], v[6] - v[9]};
    const double magnitude =
        internal::side_sum(std::abs(v[0]), std::abs(v[1]), std::abs(v[2]), std::abs(v[3]), x);
    return Numbers{internal::side_value(v[0], v[1], v[2], v[3], x),
                   internal::side_bound(0, magnitude)};
  });
  const auto v = exactly(in);
  const Rational exact = internal::side_value(
      v[0], v[1], v[2], v[3], std::array<Rational, 3>{v[4] - v[7], v[5] - v[8], v[6] - v[9]});
  return share(Rational::from_double(found[0]) - exact, found[1]);
}

double share_of_hull(const Numbers& in, Rounding mode) {
  if (!(in[1] >= 0)) return 0;
  const Numbers found = computed(mode, in, [](const Numbers& v) {
    const auto ends = internal::hull_ends(v[0], v[1]);
    return lower_end(ends[0], ends[1], v[2], false);
  });
  const auto v = exactly(in);
  return share_of_slack(v[2] + v[0] - v[1], found);
}

double share_of_rational_hull(const Numbers& in, Rounding mode) {
  if (!(in[1] >= 0) || !(in[3] >= 0) || !(in[2] > in[3])) return 0;
  const Numbers found = computed(mode, in, [](const Numbers& v) {
    const auto ends = internal::hull_ends(v[0], v[1], v[2], v[3]);
    return lower_end(ends[0], ends[1], v[4], true);
  });
  const auto v = exactly(in);
  const Rational a = v[0] - v[1];
  return share_of_slack(v[4] + a / (a.sign() == Sign::kNegative ? v[2] - v[3] : v[2] + v[3]),
                        found);
}

double share_of_crossing(const Numbers& in, const std::array<double, 2>& turn, Rounding mode) {
  const auto on_axes = [&turn](const auto& m, const auto& w, const auto& c, const auto& d) {
    using Number = std::decay_t<decltype(w)>;
    std::array<Number, 3> p{internal::relative_to_centre(m[0], w, c[0]),
                            internal::relative_to_centre(m[1], w, c[1]),
                            internal::relative_to_centre(m[2], w, c[2])};
    const Number x = internal::projected(p[0], p[2], d[0], d[2]),
                 y = internal::projected(p[1], p[2], d[1], d[2]);
    if constexpr (std::is_same_v<Number, double>)
      return internal::turned(turn[0], turn[1], x, y);
    else
      return internal::turned(Number::from_double(turn[0]), Number::from_double(turn[1]), x, y);
  };
  const Numbers found = computed(mode, in, [&](const Numbers& v) {
    const std::array<double, 3> m{v[0], v[1], v[2]}, c{v[4] - v[10], v[5] - v[11], v[6] - v[12]},
        d{v[7] - v[4], v[8] - v[5], v[9] - v[6]};
    if (!(v[3] > 0) || !(std::abs(d[2]) >= std::max(std::abs(d[0]), std::abs(d[1]))) || d[2] == 0)
      return Numbers{};
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k)
      size = std::max(size, std::abs(m[k]) + v[3] * std::abs(c[k]));
    const auto xy = on_axes(m, v[3], c, d);
    return Numbers{xy[0], xy[1], internal::crossing_bound(0, size, std::abs(d[2]), turn)};
  });
  if (found.empty()) return 0;
  const auto v = exactly(in);
  using Vector = std::array<Rational, 3>;
  const auto exact =
      on_axes(Vector{v[0], v[1], v[2]}, v[3], Vector{v[4] - v[10], v[5] - v[11], v[6] - v[12]},
              Vector{v[7] - v[4], v[8] - v[5], v[9] - v[6]});
  return std::max(share(Rational::from_double(found[0]) - exact[0], found[2]),
                  share(Rational::from_double(found[1]) - exact[1], found[2]));
}

double share_of(const BoundCase& c) {
  if (c.what == "side") return share_of_side(c.in, c.mode);
  if (c.what == "hull") return share_of_hull(c.in, c.mode);
  if (c.what == "rational_hull") return share_of_rational_hull(c.in, c.mode);
  if (c.what == "projected") return share_of_crossing(c.in, {1, 0}, c.mode);
  if (c.what == "turned") return share_of_crossing(c.in, {0.8125, 0.59375}, c.mode);
  return share_of_quarters({c.what == "triangle", c.p, c.q}, c.in, c.mode);
}

}  // namespace veritope::piece_bounds
