// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/literal_chain.h"

#include <algorithm>
#include <utility>

#include "robust/base/fp_guard.h"
#include "solids/chain/literal_conditions_internal.h"
#include "solids/chain/literal_hypotheses_internal.h"
#include "solids/chain/local_cones_internal.h"
#include "solids/base/box_hierarchy.h"

namespace veritope {
namespace {

using internal::cross;
using internal::dot;
using internal::LocalCone;
using internal::minus;

Box3d box_around(const ExactPoint& p) {
  Box3d out = empty_box();
  internal::add_rounded(p, out);
  return out;
}

// The closed simplex over a base, if it has a volume and holds the point.
void add_simplex(const internal::LiteralFacet& facet, const ExactPoint& origin, const ExactPoint& q,
                 std::vector<LocalCone>& out) {
  const Sign sign = -facet.height(origin).sign();
  if (sign == 0) return;
  const std::array<const ExactPoint*, 4> v{&origin, &facet.corners[0], &facet.corners[1],
                                           &facet.corners[2]};
  LocalCone cone;
  cone.coefficient = to_int(sign);
  for (std::size_t i = 0; i < 4; ++i) {
    const ExactPoint &a = *v[(i + 1) % 4], &b = *v[(i + 2) % 4], &c = *v[(i + 3) % 4];
    ExactPoint n = cross(minus(b, a), minus(c, a));
    if (dot(n, minus(*v[i], a)).sign() < 0) n = internal::times(Rational(-1), n);
    const Sign side = dot(n, minus(q, a)).sign();
    if (side < 0) return;
    if (side == 0) cone.inner.push_back(std::move(n));
  }
  out.push_back(std::move(cone));
}

}  // namespace

class LiteralChain::Body {
 public:
  explicit Body(const PatchComplex& complex) : complex_(complex), facets_(complex) {
    std::vector<Box3d> boxes;
    for (const internal::LiteralFacet& facet : facets_.facets()) {
      Box3d base = empty_box();
      for (const ExactPoint& p : facet.corners) internal::add_rounded(p, base);
      bases_.push_back(base);
      if (!internal::has_cell(facet)) continue;
      cells_.emplace_back(facet);
      boxes.push_back(cells_.back().box());
    }
    hierarchy_ = BoxHierarchy(boxes);
  }

  LiteralHypotheses hypotheses(unsigned jobs) const {
    LiteralHypotheses out;
    out.planes_share_lines = internal::planes_share_lines(complex_, facets_);
    out.curves_in_planes = internal::curves_in_planes(complex_, facets_);
    internal::decide_graphs(complex_, facets_, jobs, out);
    return out;
  }

  LiteralCells cells(unsigned jobs) const {
    LiteralCells out;
    for (const internal::LiteralFacet& facet : facets_.facets())
      out.without_wedge += facet.has_wedge ? 0 : 1;
    internal::judge_cells(complex_, cells_, jobs, out);
    return out;
  }

  LiteralValue value(const ExactPoint& q, const ExactPoint& origin) const {
    std::vector<LocalCone> cones;
    const Box3d at = box_around(q), from = box_around(origin);
    for (std::size_t i = 0; i < bases_.size(); ++i)
      if (meets(veritope::hull(bases_[i], from), at))
        add_simplex(facets_.facets()[i], origin, q, cones);
    bool is_open = false, is_flat = true;
    hierarchy_.visit([&](const Box3d& box) { return !is_open && meets(box, at); },
                     [&](std::uint32_t i) {
                       if (is_open) return;
                       const internal::Meets met = cells_[i].add_cones(q, cones);
                       is_open = met == internal::Meets::kOpen;
                       is_flat = is_flat && met == internal::Meets::kSome;
                     });
    LiteralValue out;
    if (is_open) return out;
    out.f = 0;
    for (const LocalCone& cone : cones) *out.f += cone.coefficient;
    if (is_flat) out.regular = internal::regular_value(cones);
    return out;
  }

 private:
  const PatchComplex& complex_;
  const internal::LiteralFacets facets_;
  std::vector<Box3d> bases_;
  std::vector<internal::LiteralCell> cells_;
  BoxHierarchy hierarchy_;
};

LiteralChain::LiteralChain(const PatchComplex& complex) {
  const ScopedDefaultFp nearest;
  body_ = std::make_unique<const Body>(complex);
}
LiteralChain::LiteralChain(LiteralChain&&) noexcept = default;
LiteralChain::~LiteralChain() = default;

LiteralHypotheses LiteralChain::hypotheses(unsigned jobs) const { return body_->hypotheses(jobs); }
LiteralCells LiteralChain::cells(unsigned jobs) const {
  const ScopedDefaultFp nearest;
  return body_->cells(jobs);
}
LiteralValue LiteralChain::value(const ExactPoint& point, const ExactPoint& origin) const {
  const ScopedDefaultFp nearest;
  return body_->value(point, origin);
}

}  // namespace veritope
