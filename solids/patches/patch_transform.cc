// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/patches/patch_transform.h"

#include <algorithm>
#include <array>
#include <utility>

#include "robust/base/check.h"
#include "robust/base/disjoint_sets.h"
#include "solids/patches/patch_complex.h"
#include "solids/patches/patch_complex_internal.h"
#include "splines/bezier_degree.h"
#include "splines/bezier_domain.h"
#include "splines/bezier_product.h"
#include "splines/bezier_triangle_algebra.h"

namespace veritope {
namespace {

Patch made(Patch::Tensor map, const PatchOrigin& origin) {
  return make_patch(std::move(map), origin).value();
}
Patch made(Patch::Triangle map, const PatchOrigin& origin) {
  return make_patch(std::move(map), origin).value();
}

Rational determinant(const std::vector<Rational>& m) {
  return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
         m[2] * (m[3] * m[7] - m[4] * m[6]);
}

// One component as a map of its own.
Patch::Tensor part(const Patch::Tensor& map, std::size_t c) {
  return components(map, static_cast<int>(c), 1);
}
Patch::Triangle part(const Patch::Triangle& map, std::size_t c) {
  const auto b = map.component(static_cast<int>(c));
  return Patch::Triangle(map.degree(), 1, false, std::vector<Rational>(b.begin(), b.end()));
}
Patch::Tensor times(const Patch::Tensor& a, const Patch::Tensor& b) {
  return componentwise_product(a, b);
}
Patch::Triangle times(const Patch::Triangle& a, const Patch::Triangle& b) { return product(a, b); }

template <typename Map>
Map scaled(Map map, const Rational& factor) {
  for (Rational& v : map.coefficients()) v *= factor;
  return map;
}
// The map whose components these are, of equal degrees.
template <typename Map>
std::vector<Rational> coefficients_of(const std::vector<Map>& parts) {
  std::vector<Rational> all;
  for (const Map& p : parts)
    all.insert(all.end(), p.coefficients().begin(), p.coefficients().end());
  return all;
}
Patch::Tensor assembled(const std::vector<Patch::Tensor>& parts, bool is_rational) {
  return {parts[0].degrees(), static_cast<int>(parts.size()), is_rational, coefficients_of(parts)};
}
Patch::Triangle assembled(const std::vector<Patch::Triangle>& parts, bool is_rational) {
  return {parts[0].degree(), static_cast<int>(parts.size()), is_rational, coefficients_of(parts)};
}
Patch::Tensor unit_like(const Patch::Tensor& map) {
  return {map.degrees(), 1, false, std::vector<Rational>(map.grid().count(), Rational(1))};
}
Patch::Triangle unit_like(const Patch::Triangle& map) {
  return {map.degree(), 1, false, std::vector<Rational>(map.count(), Rational(1))};
}

// Homogeneous: (X, Y, Z, W) -> (X W, Y W, Z W, W W) + factor X_i X_j in the target. A polynomial map has W = 1.
template <typename Map>
Map sheared_map(const Map& map, const QuadraticShear& shear) {
  const Map w = map.is_rational() ? part(map, 3) : unit_like(map);
  std::vector<Map> parts;
  for (std::size_t c = 0; c < 3; ++c) {
    Map value = times(part(map, c), w);
    if (c == shear.target) {
      const Map more = scaled(times(part(map, shear.i), part(map, shear.j)), shear.factor);
      for (std::size_t k = 0; k < value.coefficients().size(); ++k)
        value.coefficients()[k] += more.coefficients()[k];
    }
    parts.push_back(std::move(value));
  }
  if (map.is_rational()) parts.push_back(times(w, w));
  return assembled(parts, map.is_rational());
}

// Chooses the axes of tensor patches that are cut: whole classes of axes that mates tie.
std::vector<bool> chosen_axes(std::span<const Patch> patches, Random& random) {
  const PatchComplex complex =
      make_patch_complex(std::vector<Patch>(patches.begin(), patches.end())).value();
  DisjointSets axes(2 * patches.size());
  std::vector<bool> is_stopped(2 * patches.size(), false);
  const auto axis_of = [](PatchSide s) { return 2 * s.patch + s.side % 2; };
  internal::for_each_side(patches, [&](PatchSide s) {
    if (patches[s.patch].is_triangle() || complex.is_collapsed(s)) return;
    const auto mate = complex.mate(s);
    if (mate && !patches[mate->patch].is_triangle()) {
      axes.join(axis_of(s), axis_of(*mate));
    } else {
      is_stopped[axis_of(s)] = true;
    }
  });
  for (std::uint32_t a = 0; a < is_stopped.size(); ++a)
    if (is_stopped[a]) is_stopped[axes.find(a)] = true;
  std::vector<bool> chosen(2 * patches.size(), false);
  for (std::uint32_t a = 0; a < chosen.size(); ++a) {
    const std::uint32_t root = axes.find(a);
    if (root == a) chosen[a] = random.below(2) == 1 && !is_stopped[a];
    chosen[a] = chosen[root];
  }
  return chosen;
}

std::vector<Patch::Tensor> cut(std::vector<Patch::Tensor> maps, std::size_t axis) {
  std::vector<Patch::Tensor> out;
  for (const Patch::Tensor& map : maps) {
    auto halves = split(map, axis, Rational(1) / 2);
    out.push_back(std::move(halves.first));
    out.push_back(std::move(halves.second));
  }
  return out;
}

void add_quarters(const Patch& patch, std::vector<Patch>& out) {
  if (!patch.is_triangle()) {
    for (Patch::Tensor& part : cut(cut({patch.tensor()}, 0), 1))
      out.push_back(made(std::move(part), patch.origin()));
    return;
  }
  const Rational half = Rational(1) / 2;
  using Corner = Barycentric<Rational>;
  const Corner a{1, 0, 0}, b{0, 1, 0}, c{0, 0, 1}, ab{half, half, 0}, bc{0, half, half},
      ca{half, 0, half};
  for (const std::array<Corner, 3>& corners : {std::array{a, ab, ca}, std::array{ab, b, bc},
                                               std::array{ca, bc, c}, std::array{bc, ca, ab}})
    out.push_back(made(restricted(patch.triangle(), corners), patch.origin()));
}

}  // namespace

Result<std::vector<Patch>> affine_image(std::span<const Patch> patches, const AffineMap& map) {
  if (map.rows != 3 || map.columns != 3 || map.linear.size() != 9 || map.translation.size() != 3)
    return Error{
        Code::kBadArgument, {}, "a model is mapped by 3 times 3 numbers and a translation"};
  const Sign sign = determinant(map.linear).sign();
  if (sign == Sign::kZero)
    return Error{Code::kBadArgument, {}, "a map of determinant 0 has no model as its image"};
  std::vector<Patch> out;
  out.reserve(patches.size());
  for (const Patch& p : patches) {
    Patch image =
        p.is_triangle()
            ? made(affine_image<Rational>(p.triangle(), map.linear, map.translation), p.origin())
            : made(transformed(p.tensor(), map), p.origin());
    out.push_back(sign == Sign::kPositive ? std::move(image) : reversed(image));
  }
  return out;
}

std::vector<Patch> sheared(std::span<const Patch> patches, const QuadraticShear& shear) {
  VT_CHECK(shear.target < 3 && shear.i < 3 && shear.j < 3 && shear.i != shear.target &&
               shear.j != shear.target,
           "a shear moves one coordinate by the others");
  std::vector<Patch> out;
  for (const Patch& p : patches)
    out.push_back(p.is_triangle() ? made(sheared_map(p.triangle(), shear), p.origin())
                                  : made(sheared_map(p.tensor(), shear), p.origin()));
  return out;
}

std::vector<Patch> relabelled(std::span<const Patch> patches, Random& random) {
  std::vector<Patch> out;
  for (const Patch& p : patches)
    out.push_back(turned(p, static_cast<std::uint32_t>(random.below(p.num_sides()))));
  for (std::size_t i = out.size(); i > 1; --i) std::swap(out[i - 1], out[random.below(i)]);
  return out;
}

std::vector<Patch> subdivided(std::span<const Patch> patches) {
  std::vector<Patch> out;
  out.reserve(4 * patches.size());
  for (const Patch& p : patches) add_quarters(p, out);
  return out;
}

std::vector<Patch> cut_along_belts(std::span<const Patch> patches, Random& random) {
  const std::vector<bool> chosen = chosen_axes(patches, random);
  std::vector<Patch> out;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    if (patches[p].is_triangle()) {
      out.push_back(patches[p]);
      continue;
    }
    std::vector<Patch::Tensor> parts{patches[p].tensor()};
    for (const std::size_t axis : {std::size_t{0}, std::size_t{1}})
      if (chosen[2 * p + axis]) parts = cut(std::move(parts), axis);
    for (Patch::Tensor& part : parts) out.push_back(made(std::move(part), patches[p].origin()));
  }
  return out;
}

std::vector<Patch> elevated(std::span<const Patch> patches, int by) {
  std::vector<Patch> out;
  for (const Patch& p : patches)
    out.push_back(
        p.is_triangle()
            ? made(elevated_to(p.triangle(), p.triangle().degree() + by), p.origin())
            : made(elevate_to(p.tensor(), {p.tensor().degree(0) + by, p.tensor().degree(1) + by}),
                   p.origin()));
  return out;
}

}  // namespace veritope
