// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/piece_bound_search.h: inputs that use as large a part of a bound as a search can find. Deterministic.
#pragma once
#include <functional>

#include "robust/base/random.h"
#include "tests/support/piece_bound_subjects.h"

namespace veritope::piece_bounds {

struct Search {
  std::function<double(const Numbers&)> share;
  std::function<Numbers(Random&)> draw;           ///< a start
  std::function<void(Random&, Numbers&)> change;  ///< a neighbour
};
struct Found {
  Numbers in;
  double share = 0;
};
/// Climbs from `starts` drawn inputs with `steps` neighbours each; takes a neighbour that uses at least as much.
Found climb(const Search& search, int starts, int steps, std::uint64_t seed);

/// Numbers around powers of two, where a rounding is greatest relative to its result, and neighbours of such.
Numbers draw_numbers(Random& random, std::size_t n);
void change_numbers(Random& random, Numbers& in);

/// Nearly constant nets: sums just above 1 of coefficients just above 1/2, whose last digits determine every rounding.
Numbers draw_net(Random& random, std::size_t n);
void change_net(Random& random, Numbers& in);

}  // namespace veritope::piece_bounds
