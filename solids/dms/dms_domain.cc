// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_domain.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "predicates/entry_path.h"
#include "robust/base/box3d.h"
#include "robust/base/check.h"
#include "solids/base/box_hierarchy.h"
#include "solids/dms/dms_exact_knots_internal.h"
#include "solids/dms/dms_knots.h"

namespace veritope {
namespace {

using Edge = std::array<std::uint32_t, 2>;

class DomainCheck {
 public:
  DomainCheck(const DmsModel& model, const TetrahedralComplex& complex)
      : model_(model), complex_(complex), exact_(model), knots_(model) {}

  DmsDomainDefects run() {
    find_crowded();
    find_pinched();
    find_improper();
    if (out_.crowded.empty() && out_.pinched.empty() && out_.improper.empty()) find_overlaps();
    return std::move(out_);
  }

 private:
  void find_crowded() {
    for (const TetrahedronFace f : complex_.boundary()) {
      const auto v = complex_.vertices(f);
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = v[i], b = v[(i + 1) % 3];
        edges_.push_back({{std::min(a, b), std::max(a, b)}, f});
      }
    }
    std::sort(edges_.begin(), edges_.end());
    for_each_run(edges_, [&](auto first, auto last) {
      if (last - first < 3) return;
      DmsCrowdedEdge edge{first->first, {}};
      for (auto e = first; e != last; ++e) edge.faces.push_back(e->second);
      out_.crowded.push_back(std::move(edge));
    });
  }
  // visit(first, last) for each run of pairs with one first part.
  template <typename List, typename Visit>
  static void for_each_run(const List& list, Visit visit) {
    for (auto first = list.begin(); first != list.end();) {
      const auto last = std::find_if(first, list.end(),
                                     [&](const auto& item) { return item.first != first->first; });
      visit(first, last);
      first = last;
    }
  }

  // At a vertex each face joins two others; fans are the components of these.
  void find_pinched() {
    std::vector<std::pair<std::uint32_t, Edge>> opposite;
    for (const TetrahedronFace f : complex_.boundary()) {
      const auto v = complex_.vertices(f);
      for (std::size_t i = 0; i < 3; ++i)
        opposite.push_back({v[i], {v[(i + 1) % 3], v[(i + 2) % 3]}});
    }
    std::sort(opposite.begin(), opposite.end());
    for_each_run(opposite, [&](auto first, auto last) {
      const std::size_t fans = count_components(first, last);
      if (fans > 1) out_.pinched.push_back({first->first, fans});
    });
  }
  template <typename Iterator>
  static std::size_t count_components(Iterator first, Iterator last) {
    std::vector<std::uint32_t> names;
    for (auto e = first; e != last; ++e)
      names.insert(names.end(), e->second.begin(), e->second.end());
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    std::vector<std::size_t> root(names.size());
    std::iota(root.begin(), root.end(), std::size_t{0});
    const auto find = [&](std::uint32_t name) {
      auto at = static_cast<std::size_t>(std::lower_bound(names.begin(), names.end(), name) -
                                         names.begin());
      while (root[at] != at) at = root[at] = root[root[at]];
      return at;
    };
    std::size_t count = names.size();
    for (auto e = first; e != last; ++e) {
      const std::size_t a = find(e->second[0]), b = find(e->second[1]);
      if (a != b) root[a] = b, --count;
    }
    return count;
  }

  internal::CornersWithIds corners_of(TetrahedronFace f) const {
    internal::CornersWithIds out;
    out.ids = complex_.vertices(f);
    for (std::size_t i = 0; i < 3; ++i) out.points[i] = &exact_.at(out.ids[i], 0);
    return out;
  }
  void find_improper() {
    std::vector<Box3d> boxes;
    for (const TetrahedronFace f : complex_.boundary()) {
      std::vector<DmsPoint> points;
      for (const std::uint32_t v : complex_.vertices(f)) points.push_back(model_.knot(v, 0));
      boxes.push_back(box_around(points));
    }
    const BoxHierarchy tree(boxes);
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
      tree.visit(
          [&](const Box3d& box) {
            return meets(box, boxes[i]) && out_.improper.size() < DmsDomainDefects::kMaxImproper;
          },
          [&](std::uint32_t j) {
            if (i < j) compare(complex_.boundary()[i], complex_.boundary()[j]);
          });
    std::sort(
        out_.improper.begin(), out_.improper.end(),
        [](const DmsImproperFaces& a, const DmsImproperFaces& b) { return a.faces < b.faces; });
  }
  void compare(TetrahedronFace f, TetrahedronFace g) {
    auto found = internal::find_improper_point(corners_of(f), corners_of(g));
    if (!found) return;
    if (found->is_swapped) std::swap(f, g);
    out_.improper.push_back({{f, g}, std::move(found->weights), std::move(found->point)});
  }

  // The boundary is embedded. How many tetrahedra contain a point is a constant beside each component of it, one more
  // on the inner side than on the outer; where tetrahedra overlap, some component has two on its inner side.
  void find_overlaps() {
    for (const TetrahedronFace f : one_face_of_each_shell()) {
      const std::uint32_t t = face_tetrahedron(f);
      DmsPoint middle;
      for (const std::uint32_t v : complex_.vertices(f))
        for (std::size_t c = 0; c < 3; ++c) middle[c] += model_.knot(v, 0)[c];
      for (Rational& x : middle) x /= Rational(3);
      DmsPoint target;
      for (const DmsPoint& p : knots_.corners(t))
        for (std::size_t c = 0; c < 3; ++c) target[c] += p[c] * Rational::power_of_two(-2);
      if (const auto other = entered_beside(t, middle, target))
        add_overlap(t, *other, middle, target);
    }
  }
  std::vector<TetrahedronFace> one_face_of_each_shell() const {
    const std::vector<TetrahedronFace>& all = complex_.boundary();
    std::vector<std::size_t> root(all.size());
    std::iota(root.begin(), root.end(), std::size_t{0});
    const auto find = [&](TetrahedronFace f) {
      auto at = static_cast<std::size_t>(std::lower_bound(all.begin(), all.end(), f) - all.begin());
      while (root[at] != at) at = root[at] = root[root[at]];
      return at;
    };
    for_each_run(edges_, [&](auto first, auto last) {
      for (auto e = first + 1; e != last; ++e) {
        const std::size_t a = find(first->second), b = find(e->second);
        root[std::max(a, b)] = std::min(a, b);
      }
    });
    std::vector<TetrahedronFace> out;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (root[i] == i) out.push_back(all[i]);
    return out;
  }
  std::optional<std::uint32_t> entered_beside(std::uint32_t t, const DmsPoint& from,
                                              const DmsPoint& to) const {
    const EntryPath path = EntryPath::inward(ExactPoint3(from), ExactPoint3(to));
    for (const std::uint32_t other : knots_.tetrahedra_near(box_around(std::span(&from, 1))))
      if (other != t && is_entered(exact_corners(other), path)) return other;
    return std::nullopt;
  }
  std::array<const ExactPoint3*, 4> exact_corners(std::uint32_t t) const {
    const TetrahedronCorners& v = model_.tetrahedra[t];
    return {&exact_.at(v[0], 0), &exact_.at(v[1], 0), &exact_.at(v[2], 0), &exact_.at(v[3], 0)};
  }
  bool is_strictly_inside(std::uint32_t t, const ExactPoint3& p) const {
    const auto corners = exact_corners(t);
    return std::all_of(kTetrahedronFaces.begin(), kTetrahedronFaces.end(), [&](const auto& f) {
      return internal::side_of({corners[f[0]], corners[f[1]], corners[f[2]]}, p) == Sign::kNegative;
    });
  }
  // Follows the path towards its start until it is inside of both.
  void add_overlap(std::uint32_t t, std::uint32_t other, const DmsPoint& from, const DmsPoint& to) {
    for (std::int64_t step = 1;; ++step) {
      Rational share = Rational::power_of_two(-step);
      DmsPoint p = from;
      Rational off = share;
      for (std::size_t c = 0; c < 3; ++c) {
        off *= share;  // share^2, share^3, share^4
        p[c] += share * (to[c] - from[c]) + off;
      }
      const ExactPoint3 exact(p);
      if (!is_strictly_inside(t, exact) || !is_strictly_inside(other, exact)) continue;
      out_.overlaps.push_back({{std::min(t, other), std::max(t, other)}, std::move(p)});
      return;
    }
  }

  const DmsModel& model_;
  const TetrahedralComplex& complex_;
  const internal::DmsExactKnots exact_;
  const DmsKnotTable knots_;
  std::vector<std::pair<Edge, TetrahedronFace>>
      edges_;  // of the boundary, each once for each of its faces
  DmsDomainDefects out_;
};

}  // namespace

DmsDomainDefects find_domain_defects(const DmsModel& model, const TetrahedralComplex& complex) {
  return DomainCheck(model, complex).run();
}

}  // namespace veritope
