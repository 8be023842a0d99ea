// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/patch_cell.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "robust/base/fp_guard.h"
#include "solids/chain/simplex_cell.h"

namespace veritope {
namespace {

constexpr int kCellLevels = 256;

// x 2^scale, rounded towards -infinity, or, for `is_upper`, +infinity.
double unscaled(double x, int scale, bool is_upper) {
  const double y = std::ldexp(x, scale);
  if (std::ldexp(y, -scale) == x) return y;
  return std::nextafter(y, is_upper ? std::numeric_limits<double>::infinity()
                                    : -std::numeric_limits<double>::infinity());
}

Box3d box_of_patches(const PatchRays& rays, std::uint32_t first, std::uint32_t last) {
  Box3d out = empty_box();
  for (std::uint32_t p = first; p < last; ++p) out = hull(out, rays.box(p));
  for (std::size_t k = 0; k < 3; ++k) {
    out.lo[k] = unscaled(out.lo[k], rays.scale(), false);
    out.hi[k] = unscaled(out.hi[k], rays.scale(), true);
  }
  return out;
}

NormalIn<3> normal_of(const BaseTriangle& t) {
  NormalIn<3> u, v;
  for (std::size_t k = 0; k < 3; ++k) {
    u[k] = t[1][k] - t[0][k];
    v[k] = t[2][k] - t[0][k];
  }
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

bool is_zero(const NormalIn<3>& n) {
  return n[0].sign() == 0 && n[1].sign() == 0 && n[2].sign() == 0;
}

Sign side_of_base(const BaseTriangle& t, const PointIn<3>& q) {
  return orientation_of<3>({t[0], t[1], t[2], q});
}

// REQUIRES a triangle with an area, and a point in its plane.
bool is_in_triangle(const BaseTriangle& t, const NormalIn<3>& normal, const PointIn<3>& q) {
  PointIn<3> above = q;
  for (std::size_t k = 0; k < 3; ++k) above[k] += normal[k];
  for (std::size_t i = 0; i < 3; ++i)
    if (orientation_of<3>({q, t[i], t[(i + 1) % 3], above}) < 0) return false;
  return true;
}

bool is_in_plane_of(const BaseTriangle& t, const BaseTriangle& other) {
  return std::all_of(other.begin(), other.end(),
                     [&](const PatchPoint& p) { return side_of_base(t, p) == 0; });
}

PatchCell cell_of(const Patch& patch) {
  int scale = 0;  // any serves; nets have the size of the model with this one
  double most = 0;
  for (std::size_t i = 0; i < patch.num_control(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double x = std::abs(nearest_double(patch.component(c)[i]));
      if (std::isfinite(x)) most = std::max(most, x);
    }
  if (most > 0) scale = std::ilogb(most) + 1;
  std::vector<TensorForm> forms = free_form_cell(patch, scale, 0, 0);
  const auto count = static_cast<std::uint32_t>(forms.size());
  const int sign = coefficient_of(cell_sign(patch));
  return PatchCell(std::make_shared<const PatchRays>(std::move(forms), scale), 0, count,
                   base_triangles(patch), sign == 0 ? 1 : sign);
}

}  // namespace

int coefficient_of(CellSign sign) {
  switch (sign) {
    case CellSign::kZero: return 0;
    case CellSign::kMinus: return -1;
    default: return 1;
  }
}

PatchCell::PatchCell(std::shared_ptr<const PatchRays> rays, std::uint32_t first, std::uint32_t last,
                     std::vector<BaseTriangle> bases, int sign)
    : Cell<3>(box_of_patches(*rays, first, last)),
      rays_(std::move(rays)),
      first_(first),
      last_(last),
      bases_(std::move(bases)),
      sign_(sign) {}

PatchCell::PatchCell(const Patch& patch) : PatchCell(cell_of(patch)) {}

std::optional<int> PatchCell::winding(const PointIn<3>& q) const {
  const RayCount count = rays_->count_some(RayPoint(q, rays_->scale()), first_, last_, kCellLevels);
  if (count.state != RayCount::State::kCounted) return std::nullopt;
  int out = 0;
  for (const auto& [shell, w] : count.windings) out += w;
  return out;
}

std::optional<int> PatchCell::value(const ChainPoint<3>& q) const {
  if (!meets(box(), q.box())) return 0;
  if (const auto w = winding(q.exact())) return sign_ * *w;
  const std::optional<CellGerm<3>> near = germ(q);
  if (!near) return std::nullopt;
  return near->half_spaces.empty() ? near->inside : near->border;
}

bool PatchCell::is_off_curved_walls(const PointIn<3>& a, const PointIn<3>& b) const {
  const int scale = rays_->scale();
  const Box3d box = hull(RayPoint(a, scale).box(), RayPoint(b, scale).box());
  return rays_->misses(box, first_, last_ - static_cast<std::uint32_t>(bases_.size()));
}

std::optional<CellGerm<3>> PatchCell::germ(const ChainPoint<3>& q) const {
  if (!meets(box(), q.box())) return CellGerm<3>::constant(0);
  if (const auto w = winding(q.exact())) return CellGerm<3>::constant(sign_ * *w);
  // On a base, if the answer is known at all.
  const BaseTriangle* base = nullptr;
  NormalIn<3> normal;
  for (const BaseTriangle& t : bases_) {
    const NormalIn<3> n = normal_of(t);
    if (is_zero(n) || side_of_base(t, q.exact()) != 0 || !is_in_triangle(t, n, q.exact())) continue;
    if (base != nullptr && !is_in_plane_of(*base, t)) return std::nullopt;
    if (base == nullptr) base = &t, normal = n;
  }
  if (base == nullptr) return std::nullopt;
  Rational size;
  for (const Rational& x : normal) size += abs(x);
  for (int bits = 4; bits <= 120; bits += 4) {
    const Rational step = Rational::power_of_two(rays_->scale() - bits) / size;
    PointIn<3> above = q.exact(), below = q.exact();
    for (std::size_t k = 0; k < 3; ++k) {
      above[k] += step * normal[k];
      below[k] -= step * normal[k];
    }
    const bool is_free = std::all_of(bases_.begin(), bases_.end(), [&](const BaseTriangle& t) {
      if (&t == base || is_zero(normal_of(t)) || is_in_plane_of(*base, t)) return true;
      const Sign s = side_of_base(t, above);
      return s != 0 && s == side_of_base(t, below);
    });
    if (!is_free || !is_off_curved_walls(above, below)) continue;
    const auto a = winding(above), b = winding(below);
    if (!a || !b) continue;
    const int inside = sign_ * *a, outside = sign_ * *b;
    return CellGerm<3>{
        {normal}, inside, std::max({0, inside, outside}) + std::min({0, inside, outside}), outside};
  }
  return std::nullopt;
}

}  // namespace veritope
