// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/patches/patch.h"

#include <limits>
#include <utility>

#include "robust/base/check.h"
#include "splines/bezier_domain.h"
#include "splines/knot_axis.h"

namespace veritope {
namespace {

Status check_map(int num_coordinates, int least_degree, int greatest_degree,
                 const PatchOrigin& origin) {
  const auto refuse = [&](Code code, const std::string& what) {
    return Error{code, {}, to_string(origin) + ": " + what};
  };
  if (num_coordinates != 3)
    return refuse(Code::kBadArgument,
                  std::to_string(num_coordinates) + " coordinates; a patch lies in space");
  if (least_degree < 1)
    return refuse(Code::kBadArgument,
                  "a patch of degree " + std::to_string(least_degree) + " is no surface");
  if (greatest_degree > kMaxSplineDegree)
    return refuse(Code::kOverLimit, "degree " + std::to_string(greatest_degree) + "; at most " +
                                        std::to_string(kMaxSplineDegree) + " are read");
  return ok_status();
}

// The triangle whose corner c is corner order[c] of the map.
Patch::Triangle with_corners(const Patch::Triangle& map, const std::array<std::size_t, 3>& order) {
  Patch::Triangle out(map.degree(), map.num_components(), map.is_rational());
  for (int c = 0; c < map.num_components(); ++c)
    for_each_triangle_index(map.degree(), [&](int i, int j, int k) {
      std::array<int, 3> old{};
      old[order[0]] = i, old[order[1]] = j, old[order[2]] = k;
      out.component(c)[triangle_index(j, k)] = map.component(c)[triangle_index(old[1], old[2])];
    });
  return out;
}

Patch made(Result<Patch> patch) { return std::move(patch).value(); }

}  // namespace

std::string to_string(const PatchOrigin& origin) {
  const std::string number = std::to_string(origin.number);
  switch (origin.kind) {
    case PatchOrigin::Kind::kFacet: return "facet " + number;
    case PatchOrigin::Kind::kTriangle: return "triangle " + number;
    case PatchOrigin::Kind::kSurface:
      return "surface " + number + ", span (" + std::to_string(origin.span[0]) + ", " +
             std::to_string(origin.span[1]) + ")";
    case PatchOrigin::Kind::kBuilt: break;
  }
  return "patch " + number;
}

Result<Patch> make_patch(Patch::Tensor map, PatchOrigin origin) {
  if (Status ok = check_map(map.dimension(), std::min(map.degree(0), map.degree(1)),
                            std::max(map.degree(0), map.degree(1)), origin);
      !ok)
    return ok.error();
  return Patch(std::move(map), origin);
}
Result<Patch> make_patch(Patch::Triangle map, PatchOrigin origin) {
  if (Status ok = check_map(map.dimension(), map.degree(), map.degree(), origin); !ok)
    return ok.error();
  return Patch(std::move(map), origin);
}

const Patch::Tensor& Patch::tensor() const {
  VT_CHECK(!is_triangle(), "tensor() of a triangle");
  return *std::get_if<Tensor>(&map_);
}
const Patch::Triangle& Patch::triangle() const {
  VT_CHECK(is_triangle(), "triangle() of a tensor-product patch");
  return *std::get_if<Triangle>(&map_);
}
bool Patch::is_rational() const {
  return is_triangle() ? triangle().is_rational() : tensor().is_rational();
}
int Patch::max_degree() const {
  return is_triangle() ? triangle().degree() : std::max(tensor().degree(0), tensor().degree(1));
}
std::span<const Rational> Patch::coefficients() const {
  return is_triangle() ? triangle().coefficients() : tensor().coefficients();
}
std::span<const Rational> Patch::component(int c) const {
  return is_triangle() ? triangle().component(c) : tensor().component(c);
}

std::size_t Patch::side_length(std::uint32_t side) const {
  VT_CHECK(side < num_sides(), "a side that the patch does not have");
  const int degree = is_triangle() ? triangle().degree() : tensor().degree(side % 2);
  return static_cast<std::size_t>(degree) + 1;
}
std::size_t Patch::side_index(std::uint32_t side, std::size_t i) const {
  if (is_triangle()) {
    const int n = triangle().degree(), t = static_cast<int>(i);
    return side == 0   ? triangle_index(t, 0)
           : side == 1 ? triangle_index(n - t, t)
                       : triangle_index(0, n - t);
  }
  const std::size_t rows = static_cast<std::size_t>(tensor().degree(0)) + 1,
                    columns = static_cast<std::size_t>(tensor().degree(1)) + 1;
  switch (side) {
    case 0: return i * columns;
    case 1: return (rows - 1) * columns + i;
    case 2: return (rows - i) * columns - 1;
    default: return columns - 1 - i;
  }
}

Patch::Curve Patch::side(std::uint32_t side) const {
  const std::size_t length = side_length(side);
  Curve curve({static_cast<int>(length) - 1}, is_rational() ? 4 : 3, is_rational());
  for (int c = 0; c < curve.num_components(); ++c)
    for (std::size_t i = 0; i < length; ++i)
      curve.component(c)[i] = component(c)[side_index(side, i)];
  return curve;
}

std::vector<Rational> Patch::corner(std::uint32_t corner) const {
  const std::size_t at = side_index(corner, 0);
  std::vector<Rational> out;
  for (int c = 0; c < (is_rational() ? 4 : 3); ++c) out.push_back(component(c)[at]);
  return out;
}

Patch reversed(const Patch& patch) {
  if (patch.is_triangle())
    return made(make_patch(with_corners(patch.triangle(), {0, 2, 1}), patch.origin()));
  return made(make_patch(swapped(patch.tensor(), 0, 1), patch.origin()));
}

Patch turned(const Patch& patch, std::uint32_t by) {
  by %= patch.num_sides();
  if (patch.is_triangle())
    return made(make_patch(
        with_corners(patch.triangle(), {by % 3u, (by + 1u) % 3u, (by + 2u) % 3u}), patch.origin()));
  Patch::Tensor map = patch.tensor();
  // A quarter: the new (u, v) is the old point (1 - v, u).
  for (; by > 0; --by) map = reversed(swapped(map, 0, 1), 1);
  return made(make_patch(std::move(map), patch.origin()));
}

std::optional<PatchPoint> point_of(std::span<const Rational> h) {
  VT_CHECK(h.size() == 3 || h.size() == 4, "a point in space has 3 or 4 coefficients");
  if (h.size() == 3) return PatchPoint{h[0], h[1], h[2]};
  if (h[3].sign() == Sign::kZero) return std::nullopt;
  return PatchPoint{h[0] / h[3], h[1] / h[3], h[2] / h[3]};
}

Point3d approx_point(std::span<const Rational> homogeneous) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const auto p = point_of(homogeneous);
  if (!p) return {kNone, kNone, kNone};
  return {nearest_double((*p)[0]), nearest_double((*p)[1]), nearest_double((*p)[2])};
}

}  // namespace veritope
