// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/facet_meetings.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "solids/polyhedron/box_order.h"
#include "solids/polyhedron/separating_axis.h"

namespace veritope {
namespace {

bool facet_boxes_meet(const TriangleMesh& mesh, std::uint32_t f, std::uint32_t g) {
  const auto &s = mesh.faces[f], &t = mesh.faces[g];
  const Vec3d &a = mesh.positions[s[0]], &b = mesh.positions[s[1]], &c = mesh.positions[s[2]],
              &p = mesh.positions[t[0]], &q = mesh.positions[t[1]], &r = mesh.positions[t[2]];
  const auto meet = [&](double Vec3d::*x) {
    return std::max({a.*x, b.*x, c.*x}) >= std::min({p.*x, q.*x, r.*x}) &&
           std::max({p.*x, q.*x, r.*x}) >= std::min({a.*x, b.*x, c.*x});
  };
  return meet(&Vec3d::x) && meet(&Vec3d::y) && meet(&Vec3d::z);
}

}  // namespace

MeetingCollector::MeetingCollector(const TriangleMesh& mesh, std::vector<std::uint32_t> order,
                                   const BoxGroups& boxes)
    : mesh_(mesh), order_(std::move(order)), of_task_(boxes.num_tasks()) {
  position_.resize(mesh.faces.size());
  for (std::uint32_t p = 0; p < order_.size(); ++p) position_[order_[p]] = p;
}

bool MeetingCollector::add(std::size_t task, std::uint32_t f, std::uint32_t g) {
  if (!facet_boxes_meet(mesh_, f, g)) return false;
  if (position_[g] < position_[f]) std::swap(f, g);
  FacetMeeting& out = of_task_[task].emplace_back(FacetMeeting{position_[f], position_[g]});
  if (const auto axis = separating_axis(mesh_, f, g)) return out.axis = *axis, false;
  return true;
}

FacetMeetings MeetingCollector::finish() {
  FacetMeetings out{std::move(order_), {}};
  std::size_t size = 0;
  for (const auto& some : of_task_) size += some.size();
  out.pairs.reserve(size);
  for (auto& some : of_task_) {
    out.pairs.insert(out.pairs.end(), some.begin(), some.end());
    some = {};
  }
  return out;
}

FacetMeetings find_facet_meetings(const TriangleMesh& mesh, const VertexStars& stars,
                                  const Box3d& box, unsigned jobs, WorkShare* work) {
  std::vector<std::uint32_t> facets(mesh.faces.size());
  std::iota(facets.begin(), facets.end(), 0u);
  const UnitScale scale(box);
  std::vector<std::uint32_t> order = morton_order(mesh, facets, scale, jobs);
  const BoxGroups boxes(mesh, order, stars, scale, jobs);
  MeetingCollector collector(mesh, std::move(order), boxes);
  boxes.for_each_overlap(
      std::numeric_limits<std::uint64_t>::max(), jobs,
      [&](std::size_t task, std::span<const FacetPair> pairs) {
        collector.take(task, pairs, [](std::uint32_t, std::uint32_t) {});
      },
      work);
  return collector.finish();
}

}  // namespace veritope
