// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/pieces/piece_net_quarters_internal.h: the bodies of piece_net_internal.h, over doubles and over what the bound
// test counts with.
#pragma once
#include <algorithm>

#include "robust/base/check.h"
#include "solids/patches/patch.h"
#include "solids/pieces/piece_net_internal.h"

namespace veritope::internal {

// In keep_half the coefficients of one step, at `along` = i of all lines, are read with those at i - 1 of the
// same lines. Going through the triangle in the order of memory, or against it, so that what is read has not
// been written, makes each step one pass over rows without an index to compute.
//
// Rows of the triangle: row r = j + k holds k = 0 .. r, from r (r + 1) / 2 on; i = degree - r.
template <typename Number>
Number* row_of(Number* net, int r) {
  return net + r * (r + 1) / 2;
}

// Sets b[m] to (a[m] + b[m]) / 2.
template <typename Number>
void average_into(const Number* a, Number* b, int n) {
  for (int m = 0; m < n; ++m) b[m] = average(a[m], b[m]);
}

// The half of a triangle at corner `keep`, cut at the midpoint of the side between corners keep and move:
// corner `move` goes to that midpoint. Along the lines parallel to that side the net is one of curves of
// degree 0 .. n: step `level` replaces the coefficients whose index of corner `move` is at least `level` by
// their means with those one step nearer to corner `keep`.
template <typename Number>
void keep_half(int degree, int keep, int move, Number* net) {
  for (int level = 1; level <= degree; ++level) {
    if (keep == 0) {  // from row r - 1: (j, k) from (j - 1, k) or (j, k - 1)
      for (int r = degree; r >= level; --r) {
        const Number* const before = row_of(net, r - 1);
        Number* const row = row_of(net, r);
        if (move == 1)  // j >= level: k <= r - level
          average_into(before, row, r - level + 1);
        else  // k >= level
          average_into(before + level - 1, row + level, r - level + 1);
      }
    } else if (move ==
               0) {  // from row r + 1: (j, k) from (j + 1, k) or (j, k + 1), with i >= level
      for (int r = 0; r <= degree - level; ++r)
        average_into(row_of(net, r + 1) + (keep == 1 ? 0 : 1), row_of(net, r), r + 1);
    } else if (move == 2) {  // keep 1, within a row: k from k - 1
      for (int r = level; r <= degree; ++r) {
        blend_backward(row_of(net, r) + level - 1, 1, r - level + 1, kHalves);
      }
    } else {  // keep 2, move 1: k from k + 1, j = r - k >= level
      for (int r = level; r <= degree; ++r) {
        blend_forward(row_of(net, r), 1, r - level + 1, kHalves);
      }
    }
  }
}

// One argument of the blossom becomes the midpoint of corners 1 and 2: degree to degree - 1, in place.
template <typename Number>
void set_middle_of_side_0(int degree, Number* net) {
  for_each_triangle_index(degree - 1, [&](int, int j, int k) {
    net[triangle_index(j, k)] =
        average(net[triangle_index(j + 1, k)], net[triangle_index(j, k + 1)]);
  });
}

// Coefficient (i, j, k) of the middle triangle is the blossom at m0 i times, m1 j times, m2 k times.
template <typename Number>
void middle_quarter(int degree, const Number* net, Number* out) {
  static thread_local std::vector<Number> first, work;
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

// Coefficients of kLinesAbreast lines side by side: the compiler makes vectors of them.
inline constexpr std::size_t kLinesAbreast = 4;
template <typename Number>
struct LinesAbreast {
  Number at[kLinesAbreast];

  friend LinesAbreast average(const LinesAbreast& a, const LinesAbreast& b) {
    LinesAbreast out;
    for (std::size_t l = 0; l < kLinesAbreast; ++l) out.at[l] = internal::average(a.at[l], b.at[l]);
    return out;
  }
};

// Halves up to kLinesAbreast lines of n + 1 coefficients. Coefficient i of line l is read from first[i step + l next],
// the left half goes to the same places of `left`, the right half to those of `right`. The averages are those of
// split_keeping_left. work: room for n + 1.
template <typename Number>
void halve_lines(const Number* first, int n, std::size_t step, std::size_t lines, std::size_t next,
                 Number* left, Number* right, LinesAbreast<Number>* work) {
  const auto store = [&](LinesAbreast<Number> from, Number* to) {
    if (lines == kLinesAbreast)
      for (std::size_t l = 0; l < kLinesAbreast; ++l) to[l * next] = from.at[l];
    else
      for (std::size_t l = 0; l < lines; ++l) to[l * next] = from.at[l];
  };
  for (int i = 0; i <= n; ++i) {
    const Number* const from = first + static_cast<std::size_t>(i) * step;
    for (std::size_t l = 0; l < kLinesAbreast; ++l)
      work[i].at[l] = from[(l < lines ? l : 0) * next];
  }
  // Two steps of the scheme in one pass.
  for (int level = 0; level <= n; level += 2) {
    LinesAbreast<Number> before = work[level];
    store(before, left + static_cast<std::size_t>(level) * step);
    store(work[n], right + static_cast<std::size_t>(n - level) * step);
    if (level == n) return;
    LinesAbreast<Number> once = average(before, work[level + 1]);
    before = work[level + 1];
    store(once, left + static_cast<std::size_t>(level + 1) * step);
    for (int i = level + 2; i <= n; ++i) {
      const LinesAbreast<Number> here = work[i], next_once = average(before, here);
      work[i] = average(once, next_once);
      once = next_once, before = here;
    }
    store(once, right + static_cast<std::size_t>(n - level - 1) * step);
  }
}

template <typename Number>
void quarter_tensor(const FormShape& shape, const Number* net, Number* const children[4]) {
  const auto rows = static_cast<std::size_t>(shape.p + 1);
  const auto columns = static_cast<std::size_t>(shape.q + 1);
  // The longest lines are those of determinant forms, whose degrees are 3 p - 1 and 3 q - 1.
  constexpr std::size_t kLongestLine = 3 * kMaxPatchDegree;
  LinesAbreast<Number> work[kLongestLine];
  VT_CHECK(std::max(rows, columns) <= kLongestLine, "a net of too great a degree");
  for (std::size_t j = 0; j < columns; j += kLinesAbreast)
    halve_lines(net + j, shape.p, columns, std::min(kLinesAbreast, columns - j), 1, children[0] + j,
                children[2] + j, work);
  for (const int k : {0, 2})
    for (std::size_t i = 0; i < rows; i += kLinesAbreast) {
      Number* const left = children[k] + i * columns;
      halve_lines(left, shape.q, 1, std::min(kLinesAbreast, rows - i), columns, left,
                  children[k + 1] + i * columns, work);
    }
}

template <typename Number>
void quarter_triangle(int degree, const Number* net, Number* const children[4]) {
  const std::size_t count = num_triangle_coefficients(degree);
  for (int k = 0; k < 3; ++k) {
    std::copy(net, net + count, children[k]);
    keep_half(degree, k, (k + 1) % 3, children[k]);
    keep_half(degree, k, (k + 2) % 3, children[k]);
  }
  middle_quarter(degree, net, children[3]);
}

}  // namespace veritope::internal
