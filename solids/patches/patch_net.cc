// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/patches/patch_net.h"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "splines/bezier_degree.h"
#include "splines/bezier_triangle_algebra.h"

namespace veritope {
namespace {

// The map with the degree along the axis lowered by one, if that is possible: see lowered in patch_sides.cc.
std::optional<Patch::Tensor> lowered(const Patch::Tensor& map, std::size_t axis) {
  const int n = map.degree(axis);
  if (n <= 1) return std::nullopt;
  auto degrees = map.degrees();
  --degrees[axis];
  const auto count = static_cast<std::size_t>(n);
  Patch::Tensor out(degrees, map.num_components(), map.is_rational(),
                    internal::map_lines(map, axis, count, [&](auto from, auto to) {
                      to[0] = from[0];
                      for (std::size_t i = 1; i < count; ++i) {
                        const auto left = static_cast<std::int64_t>(i);
                        to[i] = (Rational(n) * from[i] - Rational(left) * to[i - 1]) /
                                Rational(n - left);
                      }
                    }));
  if (elevate(out, axis, 1) == map) return out;
  return std::nullopt;
}

// From n b_ijk = i a_(i-1)jk + j a_i(j-1)k + k a_ij(k-1), solved for the first term by rising j + k.
std::optional<Patch::Triangle> lowered(const Patch::Triangle& map) {
  const int n = map.degree();
  if (n <= 1) return std::nullopt;
  Patch::Triangle out(n - 1, map.num_components(), map.is_rational());
  for (int c = 0; c < map.num_components(); ++c) {
    const auto from = map.component(c);
    const auto to = out.component(c);
    for_each_triangle_index(n - 1, [&](int less, int j, int k) {
      const int i = less + 1;
      Rational sum = Rational(n) * from[triangle_index(j, k)];
      if (j > 0) sum -= Rational(j) * to[triangle_index(j - 1, k)];
      if (k > 0) sum -= Rational(k) * to[triangle_index(j, k - 1)];
      to[triangle_index(j, k)] = sum / Rational(i);
    });
  }
  if (elevated(out) == map) return out;
  return std::nullopt;
}

CanonicalNet form_of(const Patch& patch, bool is_reversed) {
  CanonicalNet out;
  out.degrees =
      patch.is_triangle() ? std::array{patch.triangle().degree(), -1} : patch.tensor().degrees();
  out.values.assign(patch.coefficients().begin(), patch.coefficients().end());
  out.is_reversed = is_reversed;
  if (!patch.is_rational()) return out;
  const std::size_t count = patch.num_control();
  const auto weights = std::span(out.values).last(count);
  const auto first = std::find_if(weights.begin(), weights.end(),
                                  [](const Rational& w) { return w.sign() != Sign::kZero; });
  if (first != weights.end()) {
    const Rational by = abs(*first);
    for (Rational& v : out.values) v /= by;
  }
  out.num_components = 4;
  if (std::all_of(weights.begin(), weights.end(),
                  [](const Rational& w) { return w == Rational(1); })) {
    out.values.resize(3 * count);
    out.num_components = 3;
  }
  return out;
}

}  // namespace

std::strong_ordering operator<=>(const CanonicalNet& a, const CanonicalNet& b) {
  if (const auto order =
          std::tie(a.degrees, a.num_components) <=> std::tie(b.degrees, b.num_components);
      order != 0)
    return order;
  return std::lexicographical_compare_three_way(a.values.begin(), a.values.end(), b.values.begin(),
                                                b.values.end());
}

Patch with_least_degrees(const Patch& patch) {
  if (patch.is_triangle()) {
    Patch::Triangle map = patch.triangle();
    for (auto next = lowered(map); next; next = lowered(map)) map = *std::move(next);
    return make_patch(std::move(map), patch.origin()).value();
  }
  Patch::Tensor map = patch.tensor();
  for (const std::size_t axis : {std::size_t{0}, std::size_t{1}})
    for (auto next = lowered(map, axis); next; next = lowered(map, axis)) map = *std::move(next);
  return make_patch(std::move(map), patch.origin()).value();
}

CanonicalNet canonical_net(const Patch& patch) {
  Patch side = with_least_degrees(patch);
  std::optional<CanonicalNet> best;
  for (const bool is_reversed : {false, true}) {
    if (is_reversed) side = reversed(side);
    for (std::uint32_t corner = 0; corner < side.num_sides(); ++corner) {
      CanonicalNet form = form_of(turned(side, corner), is_reversed);
      if (!best || form < *best) best = std::move(form);
    }
  }
  return *std::move(best);
}

}  // namespace veritope
