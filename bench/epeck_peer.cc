// SPDX-License-Identifier: LGPL-3.0-or-later
#include "bench/epeck_peer.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <array>
#include <vector>

namespace veritope::bench {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

struct EpeckPoints::State {
  bool three_planes;
  std::size_t stride;
  std::vector<Kernel::Point_3> given, made;

  Kernel::Plane_3 plane(const Kernel::Point_3* p) const { return {p[0], p[1], p[2]}; }
  Kernel::Point_3 make(const Kernel::Point_3* p) const {
    if (three_planes) {
      const auto x = CGAL::intersection(plane(p), plane(p + 3), plane(p + 6));
      if (const Kernel::Point_3* at = x ? boost::get<Kernel::Point_3>(&*x) : nullptr) return *at;
    } else {
      const auto x = CGAL::intersection(Kernel::Line_3(p[0], p[1]), plane(p + 2));
      if (const Kernel::Point_3* at = x ? boost::get<Kernel::Point_3>(&*x) : nullptr) return *at;
    }
    return CGAL::ORIGIN;
  }
};

EpeckPoints::EpeckPoints(const Vec3d* points, std::size_t tuples, bool three_planes)
    : state_(new State) {
  state_->three_planes = three_planes;
  state_->stride = three_planes ? 12 : 8;
  for (std::size_t i = 0; i < tuples * state_->stride; ++i)
    state_->given.emplace_back(points[i].x, points[i].y, points[i].z);
}
EpeckPoints::~EpeckPoints() = default;

long EpeckPoints::construct() {
  state_->made.clear();
  state_->made.reserve(state_->given.size() / state_->stride);
  for (std::size_t i = 0; i < state_->given.size(); i += state_->stride)
    state_->made.push_back(state_->make(&state_->given[i]));
  return static_cast<long>(state_->made.size());
}
long EpeckPoints::orient() {
  long sum = 0;
  const Kernel::Point_3* p = state_->given.data() + state_->stride - 3;
  for (const Kernel::Point_3& d : state_->made) {
    sum += CGAL::orientation(p[0], p[1], p[2], d);
    p += state_->stride;
  }
  return sum;
}

}  // namespace veritope::bench
