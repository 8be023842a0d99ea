// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/normality.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "robust/base/fp_guard.h"
#include "robust/base/random.h"
#include "solids/chain/chain_boundary.h"
#include "solids/chain/germ_sum_internal.h"
#include "solids/chain/simplex_cell.h"
#include "solids/polyhedron/validity.h"

namespace veritope {
namespace {

bool is_allowed(const Integer& f) { return f.sign() == 0 || f == Integer(1); }

template <std::size_t Dim>
struct Hyperplane {
  NormalIn<Dim> normal;
  Rational offset;  // normal . x = offset
};

// REQUIRES corners that span a hyperplane.
template <std::size_t Dim>
Hyperplane<Dim> hyperplane_of(const FacetIn<Dim>& facet) {
  Hyperplane<Dim> out;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    std::array<NormalIn<Dim>, Dim> rows;
    rows[0][axis] = Rational(1);
    for (std::size_t i = 1; i < Dim; ++i)
      for (std::size_t k = 0; k < Dim; ++k) rows[i][k] = facet[i][k] - facet[0][k];
    out.normal[axis] = determinant_of<Dim>(rows);
  }
  out.offset = internal::dot_product<Dim>(out.normal, facet[0]);
  return out;
}

// Cramer's rule; nothing if they have no single common point.
template <std::size_t Dim>
std::optional<PointIn<Dim>> common_point(const std::array<const Hyperplane<Dim>*, Dim>& planes) {
  std::array<NormalIn<Dim>, Dim> rows;
  for (std::size_t i = 0; i < Dim; ++i) rows[i] = planes[i]->normal;
  const Rational det = determinant_of<Dim>(rows);
  if (det.sign() == 0) return std::nullopt;
  PointIn<Dim> out;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    for (std::size_t i = 0; i < Dim; ++i) {
      rows[i] = planes[i]->normal;
      rows[i][axis] = planes[i]->offset;
    }
    out[axis] = determinant_of<Dim>(rows) / det;
  }
  return out;
}

// All points at which Dim facets may meet that have no line in common: CHAIN-4's places.
template <std::size_t Dim>
class Places {
 public:
  explicit Places(const std::vector<FacetIn<Dim>>& facets, std::uint64_t max_sets)
      : sets_left_(max_sets) {
    for (const FacetIn<Dim>& f : facets) {
      planes_.push_back(hyperplane_of<Dim>(f));
      Box3d box = box_around<Dim>(f[0]);
      for (const PointIn<Dim>& p : f) box = hull(box, box_around<Dim>(p));
      boxes_.push_back(box);
    }
    tree_ = BoxHierarchy(boxes_);
    std::array<const Hyperplane<Dim>*, Dim> chosen{};
    for (std::uint32_t i = 0; i < boxes_.size() && sets_left_ > 0; ++i) {
      chosen[0] = &planes_[i];
      extend(chosen, 1, i, boxes_[i]);
    }
  }

  const std::set<PointIn<Dim>>& points() const { return points_; }
  bool are_complete() const { return sets_left_ > 0; }

 private:
  void extend(std::array<const Hyperplane<Dim>*, Dim>& chosen, std::size_t count,
              std::uint32_t last, const Box3d& box) {
    if (count == Dim) {
      if (sets_left_ > 0) --sets_left_;
      if (const auto p = common_point<Dim>(chosen))
        if (meets(box_around<Dim>(*p), box)) points_.insert(*p);
      return;
    }
    tree_.visit([&](const Box3d& b) { return sets_left_ > 0 && meets(b, box); },
                [&](std::uint32_t i) {
                  if (i <= last) return;
                  chosen[count] = &planes_[i];
                  extend(chosen, count + 1, i, common(box, boxes_[i]));
                });
  }

  std::vector<Hyperplane<Dim>> planes_;
  std::vector<Box3d> boxes_;
  BoxHierarchy tree_;
  std::set<PointIn<Dim>> points_;
  std::uint64_t sets_left_;
};

// A mesh of facets that occur once each; nothing if binary64 does not have a corner.
std::optional<TriangleMesh> mesh_of(const std::vector<BoundaryFacet<3>>& facets) {
  TriangleMesh out;
  std::map<PointIn<3>, std::uint32_t> numbers;
  for (const BoundaryFacet<3>& facet : facets) {
    if (facet.multiplicity != Integer(1)) return std::nullopt;
    std::array<std::uint32_t, 3>& face = out.faces.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [at, is_new] = numbers.try_emplace(facet.corners[i], numbers.size());
      face[i] = at->second;
      if (!is_new) continue;
      const ChainPoint<3> p(facet.corners[i]);
      if (!p.doubles()) return std::nullopt;
      const auto& c = *p.doubles();
      out.positions.push_back({c[0] + 0.0, c[1] + 0.0, c[2] + 0.0});  // no -0
    }
  }
  return out;
}

// Whether a chain of simplices has no boundary, or one that bounds a solid; false also if this does not tell.
template <std::size_t Dim>
bool is_normal_by_boundary(const Chain<Dim>& chain) {
  const auto facets = boundary_of(chain);
  if (!facets) return false;
  if (facets->empty()) return true;
  if constexpr (Dim == 3) {
    const std::optional<TriangleMesh> mesh = mesh_of(*facets);
    return mesh && decide_validity(*mesh, {}).is_valid;
  }
  return false;
}

template <std::size_t Dim>
class NormalityDecision {
 public:
  using State = typename Normality<Dim>::State;

  NormalityDecision(const AssociatedFunction<Dim>& f, const NormalityOptions& options)
      : f_(f), options_(options) {}

  Normality<Dim> run() {
    if constexpr (Dim > 1)
      if (is_normal_by_boundary(f_.chain())) {
        out_.state = State::kHolds;
        return out_;
      }
    std::vector<FacetIn<Dim>> facets;
    if (all_facets(facets)) {
      const Places<Dim> places(facets, options_.max_places);
      bool is_complete = places.are_complete();
      for (const PointIn<Dim>& p : places.points()) {
        is_complete = examine(p) && is_complete;
        if (out_.witness) return out_;
      }
      if (is_complete) {
        out_.state = State::kHolds;
        return out_;
      }
    }
    try_points();
    return out_;
  }

 private:
  bool all_facets(std::vector<FacetIn<Dim>>& out) const {
    std::set<const Cell<Dim>*> seen;
    for (const ChainTerm<Dim>& t : f_.chain().terms())
      for (const CellPointer<Dim>& c : t.cells)
        if (seen.insert(c.get()).second && !c->add_facets(out)) return false;
    std::set<FacetIn<Dim>> unique;
    for (FacetIn<Dim>& f : out) std::sort(f.begin(), f.end()), unique.insert(std::move(f));
    out.assign(unique.begin(), unique.end());
    return true;
  }

  // False if the limit does not allow it, or a violation is found.
  bool examine(const PointIn<Dim>& p) {
    const ChainPoint<Dim> q(p);
    internal::GermSum<Dim> sum;
    for (const ChainTerm<Dim>& t : f_.chain().terms())
      if (meets(t.box, q.box()) && !sum.add(t, q)) return false;
    const internal::LocalFaces<Dim> local(sum.hyperplanes());
    bool is_within_limits = true, is_right = true;
    local.visit([&](const internal::LocalFace<Dim>& face) {
      is_within_limits = faces_++ < options_.max_places;
      if (!is_within_limits) return false;
      is_right = !face.is_open || is_allowed(sum.at(face.sides));
      if (!is_right) find_near(p, face.vectors);
      return is_right;
    });
    return is_within_limits && is_right;
  }
  // Steps into the open face until a point has the value of the face.
  void find_near(const PointIn<Dim>& p, const std::vector<NormalIn<Dim>>& vectors) {
    for (int bits = 1; bits <= 4096 && !out_.witness; bits *= 2) {
      PointIn<Dim> q = p;
      Rational step = Rational::power_of_two(-bits), factor = step;
      for (const NormalIn<Dim>& v : vectors) {
        for (std::size_t k = 0; k < Dim; ++k) q[k] += factor * v[k];
        factor *= step;
      }
      try_point(q);
    }
  }

  void try_point(const PointIn<Dim>& q) {
    if (f_.is_off_walls(q) != true) return;
    const std::optional<Integer> v = f_.value(q);
    if (!v || is_allowed(*v)) return;
    out_ = {State::kViolated, q, *v};
  }

  // Points of the boxes of cells.
  void try_points() {
    const auto& terms = f_.chain().terms();
    Random random(options_.seed);
    for (std::uint64_t i = 0; i < options_.num_trials && !terms.empty() && !out_.witness; ++i) {
      const Box3d& box = terms[i < terms.size() ? i : random.below(terms.size())].box;
      if (!is_finite(box)) continue;
      PointIn<Dim> q;
      for (std::size_t k = 0; k < Dim; ++k) {
        const double t = random.unit();
        q[k] = Rational::from_double(box.lo[k] * (1 - t) + box.hi[k] * t);
      }
      try_point(q);
    }
  }

  const AssociatedFunction<Dim>& f_;
  const NormalityOptions& options_;
  std::uint64_t faces_ = 0;
  Normality<Dim> out_;
};

}  // namespace

template <std::size_t Dim>
Normality<Dim> is_normal(const AssociatedFunction<Dim>& f, const NormalityOptions& options) {
  const ScopedDefaultFp nearest;
  return NormalityDecision<Dim>(f, options).run();
}

template Normality<1> is_normal<1>(const AssociatedFunction<1>&, const NormalityOptions&);
template Normality<2> is_normal<2>(const AssociatedFunction<2>&, const NormalityOptions&);
template Normality<3> is_normal<3>(const AssociatedFunction<3>&, const NormalityOptions&);

}  // namespace veritope
