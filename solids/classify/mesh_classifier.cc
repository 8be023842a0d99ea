// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/classify/mesh_classifier.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robust/base/check.h"
#include "robust/base/fp_guard.h"
#include "robust/base/parallel.h"
#include "solids/classify/cell_octree_internal.h"
#include "solids/classify/facet_box_internal.h"
#include "solids/classify/facet_tests_internal.h"
#include "solids/classify/ray_count_internal.h"
#include "solids/classify/segment_count_internal.h"
#include "solids/classify/shell_chain_internal.h"
#include "topology/incidence.h"
#include "topology/surface.h"

namespace veritope {

using namespace internal;

namespace {

constexpr std::size_t kChunkOfPoints = 1024;
// A cell of the octree with no more facets than this is not divided.
constexpr std::size_t kFewForPoints = 6, kFewForBoxes = 24;

Box3d box_around(const std::array<Vec3d, 3>& corners) {
  Box3d out = empty_box();
  for (const Vec3d& p : corners) add(to_point(p), &out);
  return out;
}

Box3d box_of(const TriangleMesh& mesh) {
  Box3d out = empty_box();
  for (const auto& t : mesh.faces)
    for (const std::uint32_t v : t) add(to_point(mesh.positions[v]), &out);
  return out;
}

}  // namespace

namespace {

bool is_cycle(const TriangleMesh& mesh) {
  const Incidence incidence =
      Incidence::build(mesh.faces, static_cast<std::uint32_t>(mesh.positions.size()), 1);
  return analyse_surface(mesh.faces, incidence, 0, 1).is_cycle;
}

// The first edge, by its ids, that is not used equally often in both directions. REQUIRES a mesh that is not a cycle.
Error unbalanced_edge(const TriangleMesh& mesh) {
  std::vector<std::pair<std::uint64_t, int>> uses;  // an edge by its ids, the less one first; 1: so
  uses.reserve(3 * mesh.faces.size());
  for (const auto& t : mesh.faces)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint64_t a = t[i], b = t[(i + 1) % 3];
      if (a != b) uses.emplace_back(std::min(a, b) << 32 | std::max(a, b), a < b ? 1 : 0);
    }
  std::sort(uses.begin(), uses.end());
  for (std::size_t i = 0, j = 0; i < uses.size(); i = j) {
    std::size_t upward = 0;
    for (; j < uses.size() && uses[j].first == uses[i].first; ++j)
      upward += uses[j].second == 1 ? 1 : 0;
    if (2 * upward == j - i) continue;
    return Error{Code::kBadArgument,
                 {},
                 "the surface is not closed: the edge from vertex " +
                     std::to_string(uses[i].first >> 32) + " to vertex " +
                     std::to_string(uses[i].first & 0xffffffffu) + " is used " +
                     std::to_string(upward) + " times in this direction and " +
                     std::to_string(j - i - upward) + " times in the other"};
  }
  throw InternalError("a mesh that is not a cycle has no unbalanced edge");
}

}  // namespace

class MeshClassifier::Body {
 public:
  Body(const TriangleMesh& mesh, const MeshShells* shells, LookupDetail detail)
      : mesh_(mesh), box_(box_of(mesh)), chains_(shells) {
    const std::optional<OctreeFrame> frame = OctreeFrame::around(box_);
    const auto vec = [](const Point3d& p) { return Vec3d{p[0], p[1], p[2]}; };
    if (!frame) {
      tests_.emplace(mesh, vec(box_.lo), vec(box_.hi));
      return;
    }
    const Vec3d& o = frame->origin;
    tests_.emplace(mesh, o, Vec3d{o.x + frame->size, o.y + frame->size, o.z + frame->size});
    octree_.emplace(*tests_, *frame, num_facets(),
                    detail == LookupDetail::kForPoints ? kFewForPoints : kFewForBoxes, chains_);
    tests_->reorder(octree_->renumber_facets(num_facets()));
    if (detail != LookupDetail::kForBoxes) return;
    boxes_.reserve(num_facets());
    for (std::uint32_t f = 0; f < num_facets(); ++f)
      boxes_.push_back(box_around(tests_->corners(f)));
  }

  template <typename Point>
  PointAnswer classify(const Point& q) const {
    return answer_at(find(q), q);
  }

  // Some points at a time, in stages: the next stage's memory is fetched while this one's points are computed.
  void classify_all(std::span<const Vec3d> points, std::span<PointAnswer> answers) const {
    constexpr std::size_t kGroup = 16;
    std::array<CellOctree::Found, kGroup> found;
    for (std::size_t begin = 0; begin < points.size(); begin += kGroup) {
      const std::size_t n = std::min(kGroup, points.size() - begin);
      for (std::size_t i = 0; i < n; ++i) found[i] = find(points[begin + i]);
      for (std::size_t i = 0; i < n; ++i)
        if (found[i].occupied != nullptr) octree_->prefetch_facets(*found[i].occupied);
      for (std::size_t i = 0; i < n; ++i)
        if (found[i].occupied != nullptr)
          for (const CellFacet& f : octree_->facets(*found[i].occupied)) tests_->prefetch(f.facet);
      for (std::size_t i = 0; i < n; ++i)
        answers[begin + i] = answer_at(found[i], points[begin + i]);
    }
  }

  // The box meets no facet if those of the cells that it meets miss it.
  Value3 value(const Box3d& box) const {
    if (!meets(box, box_)) return Value3::kZero;
    const auto misses = [&](std::uint32_t f) {
      return !is_near(f, box) || !facet_meets(tests_->corners(f), box);
    };
    const auto all_miss = [&](std::span<const CellFacet> facets) {
      return std::all_of(facets.begin(), facets.end(),
                         [&](const CellFacet& f) { return misses(f.facet); });
    };
    if (octree_ && !octree_->visit_facets(box, all_miss)) return Value3::kMixed;
    for (std::uint32_t f = 0; !octree_ && f < num_facets(); ++f)
      if (!misses(f)) return Value3::kMixed;
    return to_value(classify(Vec3d{box.lo[0], box.lo[1], box.lo[2]}).winding != 0);
  }

  template <typename Point>
  std::vector<std::uint32_t> facets_at(const Point& q) const {
    std::vector<std::uint32_t> out;
    const auto test = [&](std::uint32_t f) {
      if (tests_->side(f, q) == Sign::kZero && tests_->contains(f, q)) out.push_back(tests_->id(f));
    };
    if (!is_in(box_, q)) return out;
    if (!octree_) {
      for (std::uint32_t f = 0; f < num_facets(); ++f) test(f);
    } else if (const auto* cell = octree_->find(rounded(q)).occupied) {
      for (const CellFacet& f : octree_->facets(*cell)) test(f.facet);
    }
    std::sort(out.begin(), out.end());
    return out;
  }

  std::vector<std::uint32_t> facets_near(const Box3d& box) const {
    std::vector<std::uint32_t> out;
    const auto take = [&](std::uint32_t f) {
      if (is_near(f, box)) out.push_back(tests_->id(f));
    };
    if (octree_) {
      octree_->visit_facets(box, [&](std::span<const CellFacet> facets) {
        for (const CellFacet& f : facets) take(f.facet);
        return true;
      });
    } else {
      for (std::uint32_t f = 0; f < num_facets(); ++f) take(f);
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }

  const Box3d& box() const { return box_; }

  LookupSize lookup() const {
    LookupSize out = octree_ ? octree_->size() : LookupSize{};
    out.bytes += tests_->bytes() + boxes_.size() * sizeof(Box3d);
    return out;
  }

 private:
  static const Vec3d& rounded(const Vec3d& q) { return q; }
  static const Vec3d& rounded(const ScaledPoint& q) { return q.rounded; }
  std::uint32_t num_facets() const { return static_cast<std::uint32_t>(mesh_.faces.size()); }

  // Whether the box of the facet meets the box.
  bool is_near(std::uint32_t f, const Box3d& box) const {
    return veritope::meets(boxes_.empty() ? box_around(tests_->corners(f)) : boxes_[f], box);
  }

  // Neither a label nor a cell: outside of the box, or no octree.
  template <typename Point>
  CellOctree::Found find(const Point& q) const {
    if (!octree_ || !is_in(box_, q)) return {};
    return octree_->find(rounded(q));
  }
  template <typename Point>
  PointAnswer answer_at(const CellOctree::Found& found, const Point& q) const {
    if (found.label != nullptr) return answer(*found.label, {});
    if (found.occupied != nullptr) return in_cell(found, q);
    return octree_ || !is_in(box_, q) ? PointAnswer{} : by_all_facets(q);
  }

  PointAnswer answer(const RegionLabel& from, const WindingChange& change) const {
    return {from.winding + change.winding, kNowhere,
            chains_.innermost_after(from.chain, change.shells)};
  }
  PointAnswer on(std::uint32_t facet) const { return {0, facet, chains_.shell_of(facet)}; }

  // The segment from the cell's reference point to q lies in the cell, margin included, so that only facets of the cell
  // can cross it.
  template <typename Point>
  PointAnswer in_cell(const CellOctree::Found& found, const Point& q) const {
    const OccupiedCell& cell = *found.occupied;
    WindingChange change;
    bool touches_rim = !cell.has_reference;
    std::uint32_t least = kNowhere;
    for (const CellFacet& f : octree_->facets(cell)) {
      const Sign side = tests_->side(f.facet, q);
      if (side == Sign::kZero) {  // a plane without the reference meets the segment in q only
        const std::uint32_t id = tests_->id(f.facet);
        if (id < least && tests_->contains(f.facet, q)) least = id;
        continue;
      }
      if (touches_rim || side == f.reference_side()) continue;
      const Passage passage = tests_->passage(f.facet, cell.reference, q);
      touches_rim = passage == Passage::kTouchesRim;
      if (passage == Passage::kCrosses)
        change.cross(tests_->id(f.facet), f.reference_side(), chains_.shells());
    }
    if (least != kNowhere) return on(least);
    if (!touches_rim) return answer(cell.label, change);
    if (cell.has_reference)
      for (int i = 0; i < OctreeCell::kNumPoints; ++i)
        if (const auto around = change_through(found.cell.point(i), cell, q))
          return answer(cell.label, *around);
    return answer({}, change_along_ray(mesh_, q, chains_.shells()));
  }

  // The change along two segments, from the reference point to p and from p to q. Nothing if one of them touches the
  // rim of a facet, or if p lies on the plane of a facet. REQUIRES q off the facets.
  template <typename Point>
  std::optional<WindingChange> change_through(const Vec3d& p, const OccupiedCell& cell,
                                              const Point& q) const {
    WindingChange out;
    for (const CellFacet& f : octree_->facets(cell)) {
      if (tests_->is_degenerate(f.facet)) continue;
      const Sign start = f.reference_side(), middle = tests_->side(f.facet, p),
                 end = tests_->side(f.facet, q);
      if (middle == Sign::kZero) return std::nullopt;
      if (start != middle) {
        const Passage passage = tests_->passage(f.facet, cell.reference, p);
        if (passage == Passage::kTouchesRim) return std::nullopt;
        if (passage == Passage::kCrosses) out.cross(tests_->id(f.facet), start, chains_.shells());
      }
      if (end == Sign::kZero || middle == end) continue;
      const Passage passage = tests_->passage(f.facet, p, q);
      if (passage == Passage::kTouchesRim) return std::nullopt;
      if (passage == Passage::kCrosses) out.cross(tests_->id(f.facet), middle, chains_.shells());
    }
    return out;
  }

  // For meshes that are too large, too small, or too far away for an octree with corners in binary64.
  template <typename Point>
  PointAnswer by_all_facets(const Point& q) const {
    std::uint32_t f = 0;
    while (f < num_facets() && !(tests_->side(f, q) == Sign::kZero && tests_->contains(f, q))) ++f;
    if (f < num_facets()) return on(f);
    return answer({}, change_along_ray(mesh_, q, chains_.shells()));
  }

  const TriangleMesh& mesh_;
  const Box3d box_;
  ShellChains chains_;
  std::optional<FacetTests> tests_;
  std::optional<CellOctree> octree_;
  std::vector<Box3d> boxes_;  // of the facets, for LookupDetail::kForBoxes
};

MeshClassifier::MeshClassifier(std::unique_ptr<const Body> body) : body_(std::move(body)) {}
MeshClassifier::MeshClassifier(MeshClassifier&&) noexcept = default;
MeshClassifier::~MeshClassifier() = default;

Result<MeshClassifier> MeshClassifier::make(const TriangleMesh& mesh, const MeshShells* shells,
                                            LookupDetail detail) {
  if (!is_cycle(mesh)) return unbalanced_edge(mesh);
  const ScopedDefaultFp nearest;
  return MeshClassifier(std::make_unique<const Body>(mesh, shells, detail));
}

PointAnswer MeshClassifier::classify(const Vec3d& point) const {
  const ScopedDefaultFp nearest;
  return body_->classify(point);
}

PointAnswer MeshClassifier::classify(const ExactPoint& point) const {
  const ScopedDefaultFp nearest;
  return body_->classify(ScaledPoint(point));
}

void MeshClassifier::classify(std::span<const Vec3d> points, std::span<PointAnswer> answers,
                              unsigned jobs) const {
  parallel_for(points.size(), kChunkOfPoints, jobs,
               [&](std::size_t, std::size_t begin, std::size_t end) {
                 const ScopedDefaultFp nearest;
                 body_->classify_all(points.subspan(begin, end - begin),
                                     answers.subspan(begin, end - begin));
               });
}

Value3 MeshClassifier::value(const Box3d& box) const {
  const ScopedDefaultFp nearest;
  return body_->value(box);
}

std::vector<std::uint32_t> MeshClassifier::facets_at(const Vec3d& point) const {
  const ScopedDefaultFp nearest;
  return body_->facets_at(point);
}

std::vector<std::uint32_t> MeshClassifier::facets_at(const ExactPoint& point) const {
  const ScopedDefaultFp nearest;
  return body_->facets_at(ScaledPoint(point));
}

std::vector<std::uint32_t> MeshClassifier::facets_near(const Box3d& box) const {
  const ScopedDefaultFp nearest;
  return body_->facets_near(box);
}

const Box3d& MeshClassifier::box() const { return body_->box(); }

LookupSize MeshClassifier::lookup() const { return body_->lookup(); }

}  // namespace veritope
