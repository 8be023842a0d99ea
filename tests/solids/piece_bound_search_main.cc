// SPDX-License-Identifier: LGPL-3.0-or-later
// piece_bound_search [STARTS STEPS]: prints the rows of tests/solids/piece_bound_cases.h, the inputs that use
// most of each bound of solids/pieces/piece_bounds.h. Same arguments, same output.
#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/support/piece_bound_search.h"

namespace {

using namespace veritope;
using namespace veritope::piece_bounds;

// The row of the input that uses most of the bound.
void print_worst(BoundCase row, const std::function<Numbers(Random&)>& draw,
                 const std::function<void(Random&, Numbers&)>& change, int starts, int steps) {
  const auto share = [&row](const Numbers& in) {
    return share_of({row.what, row.p, row.q, row.mode, in});
  };
  const Found found = climb({share, draw, change}, starts, steps, 1);
  std::printf("    // uses %.3f\n    {\"%s\", %d, %d, Rounding::%s,\n     {", found.share,
              row.what.c_str(), row.p, row.q,
              row.mode == Rounding::kUpward ? "kUpward" : "kNearest");
  for (std::size_t i = 0; i < found.in.size(); ++i)
    std::printf("%s%a", i == 0 ? "" : i % 4 == 0 ? ",\n      " : ", ", found.in[i]);
  std::printf("}},\n");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int starts = argc > 1 ? std::atoi(argv[1]) : 16,
            steps = argc > 2 ? std::atoi(argv[2]) : 10000;
  for (const Rounding mode : {Rounding::kNearest, Rounding::kUpward}) {
    for (const auto& [what, n] :
         {std::pair{"side", 10u}, std::pair{"hull", 3u}, std::pair{"rational_hull", 5u},
          std::pair{"projected", 13u}, std::pair{"turned", 13u}})
      print_worst(
          {what, 0, 0, mode, {}}, [n = n](Random& r) { return draw_numbers(r, n); }, change_numbers,
          starts, steps);
    for (const FormShape& shape : {FormShape{false, 1, 1}, FormShape{false, 3, 3},
                                   FormShape{true, 1, 0}, FormShape{true, 3, 0}})
      print_worst(
          {shape.is_triangle ? "triangle" : "tensor", shape.p, shape.q, mode, {}},
          [&](Random& r) { return draw_net(r, shape.count()); }, change_net, starts, steps / 4);
  }
}
