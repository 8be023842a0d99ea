// SPDX-License-Identifier: LGPL-3.0-or-later
#include "tests/support/piece_bound_search.h"

#include <cmath>

namespace veritope::piece_bounds {
namespace {

double near_a_power_of_two(Random& random) {
  const double part = std::ldexp(2 * random.unit() - 1, -static_cast<int>(random.below(56)));
  const double v = std::ldexp(1 + part, static_cast<int>(random.between(-2, 2)));
  return random.below(2) == 0 ? v : -v;
}
double just_above_a_half(Random& random) {
  return 0.5 + std::ldexp(static_cast<double>(random.between(-4, 64)), -54);
}

}  // namespace

Found climb(const Search& search, int starts, int steps, std::uint64_t seed) {
  Random random(seed);
  Found best;
  for (int start = 0; start < starts; ++start) {
    Found now{search.draw(random), 0};
    now.share = search.share(now.in);
    for (int step = 0; step < steps; ++step) {
      Found next = now;
      search.change(random, next.in);
      next.share = search.share(next.in);
      if (next.share >= now.share) now = std::move(next);
    }
    if (now.share > best.share) best = std::move(now);
  }
  return best;
}

Numbers draw_numbers(Random& random, std::size_t n) {
  Numbers out;
  for (std::size_t i = 0; i < n; ++i) out.push_back(near_a_power_of_two(random));
  return out;
}

void change_numbers(Random& random, Numbers& in) {
  for (auto left = 1 + random.below(2); left-- > 0;) {
    double& v = in[random.below(in.size())];
    switch (random.below(6)) {
      case 0: v = near_a_power_of_two(random); break;
      case 1: v = std::ldexp(v, random.below(2) == 0 ? 1 : -1); break;
      case 2: v = -v; break;
      case 3: v = std::ldexp(v, static_cast<int>(random.between(-60, 60))); break;
      default:
        v += v * std::ldexp(2 * random.unit() - 1, -static_cast<int>(random.below(54)));
        break;
    }
    if (!(std::abs(v) > 0x1p-200 && std::abs(v) < 0x1p200)) v = near_a_power_of_two(random);
  }
}

Numbers draw_net(Random& random, std::size_t n) {
  Numbers out;
  for (std::size_t i = 0; i < n; ++i) out.push_back(just_above_a_half(random));
  return out;
}

void change_net(Random& random, Numbers& in) {
  for (auto left = 1 + random.below(2); left-- > 0;)
    in[random.below(in.size())] = just_above_a_half(random);
}

}  // namespace veritope::piece_bounds
