// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/normal_chain.h"

#include <algorithm>
#include <utility>

#include "robust/base/fp_guard.h"
#include "solids/chain/patch_cell.h"
#include "solids/classify/patch_rays.h"
#include "solids/base/box_hierarchy.h"

namespace veritope {
namespace {

// The determinant of b - a, c - a, d - a.
Sign orientation(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                 const ExactPoint& d) {
  std::array<ExactPoint, 3> m;
  for (std::size_t k = 0; k < 3; ++k) {
    m[0][k] = b[k] - a[k];
    m[1][k] = c[k] - a[k];
    m[2][k] = d[k] - a[k];
  }
  return (m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
          m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
          m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]))
      .sign();
}

Box3d box_of(const BaseTriangle& t) {
  Box3d out = empty_box();
  for (const PatchPoint& p : t)
    for (std::size_t k = 0; k < 3; ++k) {
      out.lo[k] = std::min(out.lo[k], round_down(p[k]));
      out.hi[k] = std::max(out.hi[k], round_up(p[k]));
    }
  return out;
}

Box3d box_of(const ExactPoint& p) {
  Box3d out;
  for (std::size_t k = 0; k < 3; ++k) {
    out.lo[k] = round_down(p[k]);
    out.hi[k] = round_up(p[k]);
  }
  return out;
}

// How the simplex from the origin over a triangle lies to a point: its coefficient if the point is in its interior, 0
// if it is off the closed simplex or that has no interior; nothing on its boundary.
std::optional<int> simplex_value(const BaseTriangle& t, const ExactPoint& origin,
                                 const ExactPoint& q) {
  const Sign sign = orientation(origin, t[0], t[1], t[2]);
  if (sign == 0) return 0;
  const std::array<Sign, 4> sides{
      orientation(q, t[0], t[1], t[2]), orientation(origin, q, t[1], t[2]),
      orientation(origin, t[0], q, t[2]), orientation(origin, t[0], t[1], q)};
  bool is_on_side = false;
  for (const Sign s : sides) {
    if (s * sign == Sign::kNegative) return 0;
    is_on_side = is_on_side || s == 0;
  }
  if (is_on_side) return std::nullopt;
  return to_int(sign);
}

void count(const BaseTriangle& t, const ExactPoint& origin, CellCounts& out) {
  const Sign s = simplex_sign(t, origin);
  ++(s > 0 ? out.plus : s < 0 ? out.minus : out.zero);
}

}  // namespace

Sign simplex_sign(const BaseTriangle& base, const ExactPoint& origin) {
  return orientation(origin, base[0], base[1], base[2]);
}

CellCounts count_simplices(const PatchComplex& complex, const ExactPoint& origin) {
  CellCounts out;
  for (const Patch& patch : complex.patches())
    for (const BaseTriangle& t : base_triangles(patch)) count(t, origin, out);
  return out;
}

class NormalChain::Body {
 public:
  explicit Body(const PatchComplex& complex) : scale_(scale_of(complex)), surface_(complex) {
    std::vector<TensorForm> forms;
    std::uint32_t cell = 0;
    for (const Patch& patch : complex.patches()) {
      for (const BaseTriangle& t : base_triangles(patch)) {
        bases_.push_back(t);
        boxes_of_bases_.push_back(box_of(t));
      }
      const CellSign sign = cell_sign(patch);
      ++(sign == CellSign::kPlus    ? counts_.plus
         : sign == CellSign::kMinus ? counts_.minus
         : sign == CellSign::kZero  ? counts_.zero
                                    : counts_.mixed);
      if (patch.is_flat_triangle()) continue;  // it is its base
      first_.push_back(static_cast<std::uint32_t>(forms.size()));
      cells_of_patches_.push_back({base_triangles(patch), coefficient_of(sign)});
      for (TensorForm& form : free_form_cell(patch, scale_, cell * kEdgesOfCell, cell))
        forms.push_back(std::move(form));
      ++cell;
    }
    first_.push_back(static_cast<std::uint32_t>(forms.size()));
    rays_ = std::make_shared<const PatchRays>(std::move(forms), scale_);
    std::vector<Box3d> boxes(cell, empty_box());
    for (std::uint32_t c = 0; c < cell; ++c)
      for (std::uint32_t p = first_[c]; p < first_[c + 1]; ++p)
        boxes[c] = veritope::hull(boxes[c], rays_->box(p));
    cells_ = BoxHierarchy(boxes);
  }

  std::optional<int> value(const ExactPoint& q, const ExactPoint& origin) const {
    if (const auto sum = value_off_walls(q, origin)) return sum;
    // Beside it, in a direction without a pattern, nearer and nearer until no patch is between.
    const std::array<Rational, 3> away{Rational(3) / Rational(7), Rational(5) / Rational(11),
                                       Rational(-8) / Rational(13)};
    for (int bits = 10; bits <= 200; bits += 10) {
      const Rational step = Rational::power_of_two(scale_ - bits);
      ExactPoint beside = q;
      for (std::size_t k = 0; k < 3; ++k) beside[k] += step * away[k];
      const RayPoint a(q, scale_), b(beside, scale_);
      if (!surface_.misses(veritope::hull(a.box(), b.box()))) continue;
      if (const auto sum = value_off_walls(beside, origin)) return sum;
    }
    return std::nullopt;
  }

  Chain<3> chain(const ExactPoint& origin) const {
    Chain<3> out = original_simplices<3>(bases_, origin);
    std::vector<ChainTerm<3>> terms = out.terms();
    for (std::uint32_t c = 0; c < cells_of_patches_.size(); ++c) {
      const auto& [bases, sign] = cells_of_patches_[c];
      if (sign == 0) continue;
      auto cell = std::make_shared<const PatchCell>(rays_, first_[c], first_[c + 1], bases, sign);
      const Box3d box = cell->box();
      terms.push_back({Integer(sign), {std::move(cell)}, box});
    }
    return Chain<3>::from_terms(std::move(terms));
  }

  CellCounts simplices(const ExactPoint& origin) const {
    CellCounts out;
    for (const BaseTriangle& t : bases_) count(t, origin, out);
    return out;
  }
  const CellCounts& free_form_cells() const { return counts_; }

 private:
  // Nothing on a wall, or where it is open whether the point is on one.
  std::optional<int> value_off_walls(const ExactPoint& q, const ExactPoint& origin) const {
    int sum = 0;
    const Box3d at = box_of(q), from = box_of(origin);
    for (std::size_t i = 0; i < bases_.size(); ++i) {
      if (!meets(veritope::hull(boxes_of_bases_[i], from), at)) continue;
      const auto value = simplex_value(bases_[i], origin, q);
      if (!value) return std::nullopt;
      sum += *value;
    }
    constexpr int kLevels = 256;
    const RayPoint point(q, scale_);
    bool is_on_wall = false;
    cells_.visit([&](const Box3d& box) { return !is_on_wall && meets(box, point.box()); },
                 [&](std::uint32_t cell) {
                   const RayCount count =
                       rays_->count_some(point, first_[cell], first_[cell + 1], kLevels);
                   is_on_wall = is_on_wall || count.state != RayCount::State::kCounted;
                   for (const auto& [shell, winding] : count.windings) sum += winding;
                 });
    if (is_on_wall) return std::nullopt;
    return sum;
  }

  const int scale_;
  const PatchRays surface_;
  std::vector<BaseTriangle> bases_;
  std::vector<Box3d> boxes_of_bases_;
  std::shared_ptr<const PatchRays> rays_;  // the patches of all free-form cells
  std::vector<std::uint32_t> first_;       // of each cell
  struct CellOfPatch {
    std::vector<BaseTriangle> bases;
    int sign;
  };
  std::vector<CellOfPatch> cells_of_patches_;
  BoxHierarchy cells_;
  CellCounts counts_;
};

NormalChain::NormalChain(const PatchComplex& complex) {
  const ScopedDefaultFp nearest;
  body_ = std::make_unique<const Body>(complex);
}
NormalChain::NormalChain(NormalChain&&) noexcept = default;
NormalChain::~NormalChain() = default;

std::optional<int> NormalChain::value(const ExactPoint& point, const ExactPoint& origin) const {
  const ScopedDefaultFp nearest;
  return body_->value(point, origin);
}
Chain<3> NormalChain::chain(const ExactPoint& origin) const {
  const ScopedDefaultFp nearest;
  return body_->chain(origin);
}
CellCounts NormalChain::simplices(const ExactPoint& origin) const {
  return body_->simplices(origin);
}
CellCounts NormalChain::free_form_cells() const { return body_->free_form_cells(); }

}  // namespace veritope
