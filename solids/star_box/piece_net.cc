// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>

#include "solids/star_box/piece_net_internal.h"

namespace veritope::internal {
namespace {

// The half of a triangle at corner `keep`, cut at the midpoint of the side between corners keep and move: corner `move` goes to that midpoint.
// Along the lines parallel to that side the net is one of curves of degree 0 .. n.
void keep_half(int degree, int keep, int move, double* net) {
  const int other = 3 - keep - move;
  int index[3];
  const auto at = [&](int fixed, int along, int n) -> double& {
    // `along` steps from corner keep to corner move; the third index is `fixed`.
    index[other] = fixed, index[move] = along, index[keep] = n - fixed - along;
    return net[triangle_index(index[1], index[2])];
  };
  for (int fixed = 0; fixed < degree; ++fixed) {
    const int n = degree - fixed;
    for (int level = 1; level <= n; ++level)
      for (int i = n; i >= level; --i) {
        double& b = at(fixed, i, degree);
        b = 0.5 * (at(fixed, i - 1, degree) + b);
      }
  }
}

// One argument of the blossom becomes the midpoint of corners 1 and 2: degree to degree - 1, in place.
void set_middle_of_side_0(int degree, double* net) {
  for_each_triangle_index(degree - 1, [&](int, int j, int k) {
    net[triangle_index(j, k)] =
        0.5 * (net[triangle_index(j + 1, k)] + net[triangle_index(j, k + 1)]);
  });
}

// Coefficient (i, j, k) of the middle triangle is the blossom at m0 i times, m1 j times, m2 k times.
void middle_quarter(int degree, const double* net, double* out) {
  static thread_local std::vector<double> first, work;
  first.assign(net, net + num_triangle_coefficients(degree));
  for (int i = 0; i <= degree; ++i) {
    const int n = degree - i;
    // In the half (c0, m2, c2), then its half (c0, m2, m1), the side from m1 to m2 holds the blossom at m1 and m2.
    work.assign(first.begin(),
                first.begin() + static_cast<std::ptrdiff_t>(num_triangle_coefficients(n)));
    keep_half(n, 0, 1, work.data());
    keep_half(n, 0, 2, work.data());
    for (int k = 0; k <= n; ++k)  // j = n - k times m1, which is corner 2 now; m2 is corner 1
      out[triangle_index(n - k, k)] = work[triangle_index(k, n - k)];
    if (n > 0) set_middle_of_side_0(n, first.data());
  }
}

}  // namespace

void quarter_tensor(const FormShape& shape, const double* net, double* const children[4]) {
  const auto columns = static_cast<std::size_t>(shape.q + 1);
  std::copy(net, net + shape.count(), children[0]);
  for (std::size_t j = 0; j < columns; ++j)
    halve_line(children[0] + j, columns, shape.p, children[2] + j, columns);
  for (const int k : {0, 2})
    for (int i = 0; i <= shape.p; ++i) {
      const std::size_t row = static_cast<std::size_t>(i) * columns;
      halve_line(children[k] + row, 1, shape.q, children[k + 1] + row, 1);
    }
}

void quarter_triangle(int degree, const double* net, double* const children[4]) {
  const std::size_t count = num_triangle_coefficients(degree);
  for (int k = 0; k < 3; ++k) {
    std::copy(net, net + count, children[k]);
    keep_half(degree, k, (k + 1) % 3, children[k]);
    keep_half(degree, k, (k + 2) % 3, children[k]);
  }
  middle_quarter(degree, net, children[3]);
}

}  // namespace veritope::internal
