// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/certify/pair_code_oracle.h: the leaf-pair test of docs/certificates/mesh.md section 5, written from the page alone: sets of named
// points, no bit masks, no ranking. T is any exact integer type.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace veritope::oracle {

template <typename T>
using Point = std::array<T, 3>;

template <typename T>
Point<T> difference(const Point<T>& a, const Point<T>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <typename T>
Point<T> outer(const Point<T>& a, const Point<T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <typename T>
T inner(const Point<T>& a, const Point<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <typename T>
bool is_null(const Point<T>& a) {
  return a[0] == T(0) && a[1] == T(0) && a[2] == T(0);
}

/// The corners of a triangle in order, with their vertex ids.
template <typename T>
struct NamedTriangle {
  std::array<Point<T>, 3> at;
  std::array<std::uint32_t, 3> id;
};
template <typename T>
using NamedPoints = std::map<std::uint32_t, Point<T>>;

template <typename T>
NamedPoints<T> points_of(const NamedTriangle<T>& t) {
  return {{t.id[0], t.at[0]}, {t.id[1], t.at[1]}, {t.id[2], t.at[2]}};
}

/// "Axes: 0: n(a). 1: n(b). 2 + 3i + j: ei(a) x ej(b). 11 + i: n(a) x ei(a). 14 + i: n(b) x ei(b)."
template <typename T>
Point<T> axis_vector(int axis, const NamedTriangle<T>& a, const NamedTriangle<T>& b) {
  const auto edge = [](const NamedTriangle<T>& t, int i) {
    return difference(t.at[static_cast<std::size_t>(i == 2 ? 0 : i + 1)], t.at[static_cast<std::size_t>(i)]);
  };
  const auto normal = [](const NamedTriangle<T>& t) {
    return outer(difference(t.at[1], t.at[0]), difference(t.at[2], t.at[0]));
  };
  if (axis == 0) return normal(a);
  if (axis == 1) return normal(b);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j)
      if (axis == 2 + 3 * i + j) return outer(edge(a, i), edge(b, j));
    if (axis == 11 + i) return outer(normal(a), edge(a, i));
    if (axis == 14 + i) return outer(normal(b), edge(b, i));
  }
  return {T(0), T(0), T(0)};
}

enum class DirectionTest { kFails, kHolds, kOpen };

/// "Test of a direction d for vertex sets P, Q"; if open, P and Q become P' and Q'.
template <typename T>
DirectionTest test_direction(const Point<T>& d, NamedPoints<T>& p, NamedPoints<T>& q) {
  T most = inner(d, p.begin()->second), least = inner(d, q.begin()->second);
  for (const auto& [id, x] : p)
    if (inner(d, x) > most) most = inner(d, x);
  for (const auto& [id, x] : q)
    if (inner(d, x) < least) least = inner(d, x);
  if (most > least) return DirectionTest::kFails;
  if (most < least) return DirectionTest::kHolds;
  NamedPoints<T> p1, q1, k;
  for (const auto& [id, x] : p)
    if (inner(d, x) == most) p1[id] = k[id] = x;
  for (const auto& [id, x] : q)
    if (inner(d, x) == least) q1[id] = k[id] = x;
  if (k.size() <= 2) return DirectionTest::kHolds;
  if (k.size() == 3) {
    std::vector<Point<T>> x;
    for (const auto& [id, at] : k) x.push_back(at);
    if (!is_null(outer(difference(x[1], x[0]), difference(x[2], x[0])))) return DirectionTest::kHolds;
  }
  p = p1;
  q = q1;
  return DirectionTest::kOpen;
}

/// Judges the code bytes of the leaf pair a, b. Empty if they hold, else what is wrong. Reads one code from the front of `codes`
/// and leaves the rest.
template <typename T>
std::string judge_codes(const NamedTriangle<T>& a, const NamedTriangle<T>& b, std::span<const std::uint8_t>& codes) {
  NamedPoints<T> p = points_of(a), q = points_of(b);
  for (int n = 1;; ++n) {
    if (codes.empty()) return "a code is missing";
    if (n > 4) return "more than four bytes";
    const std::uint8_t code = codes.front();
    codes = codes.subspan(1);
    if (code >= 128) return "bit 7";
    if (code % 32 > 16) return "no such axis";
    Point<T> d = axis_vector(code % 32, a, b);
    if (code / 32 % 2 == 1) d = {T(0) - d[0], T(0) - d[1], T(0) - d[2]};
    const bool follows = code / 64 == 1;
    switch (test_direction(d, p, q)) {
      case DirectionTest::kFails: return "the test fails";
      case DirectionTest::kHolds: return follows ? "a byte follows a test that holds" : "";
      case DirectionTest::kOpen:
        if (!follows) return "the test is open and no byte follows";
    }
  }
}

}  // namespace veritope::oracle
