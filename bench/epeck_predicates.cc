// SPDX-License-Identifier: LGPL-3.0-or-later
// CGAL's EPECK [CGAL55]. Its points are made before the clock starts, and remember earlier answers.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include "bench/predicate_peers.h"

namespace veritope::bench {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

class Epeck : public PredicatePeer {
 public:
  Epeck() : PredicatePeer("epeck", 8192) {}
  void load(const Vec2d* points, std::size_t count) override {
    a_.clear();
    for (std::size_t i = 0; i < count; ++i) a_.emplace_back(points[i].x, points[i].y);
  }
  void load(const Vec3d* points, std::size_t count) override {
    b_.clear();
    for (std::size_t i = 0; i < count; ++i) b_.emplace_back(points[i].x, points[i].y, points[i].z);
  }
  void decide(Predicate predicate, std::size_t n, signed char* out) override {
    for (std::size_t i = 0; i < n; ++i) {
      const Kernel::Point_2* p = a_.data();
      const Kernel::Point_3* q = b_.data();
      switch (predicate) {
        case Predicate::kOrient2d:
          p += 3 * i;
          out[i] = CGAL::orientation(p[0], p[1], p[2]);
          break;
        case Predicate::kOrient3d:
          q += 4 * i;
          out[i] = CGAL::orientation(q[0], q[1], q[2], q[3]);
          break;
        case Predicate::kInCircle:
          p += 4 * i;
          out[i] = CGAL::side_of_oriented_circle(p[0], p[1], p[2], p[3]);
          break;
        case Predicate::kInSphere:
          q += 5 * i;
          out[i] = CGAL::side_of_oriented_sphere(q[0], q[1], q[2], q[3], q[4]);
          break;
      }
    }
  }

 private:
  std::vector<Kernel::Point_2> a_;
  std::vector<Kernel::Point_3> b_;
};

}  // namespace

void add_epeck_predicates(PredicatePeers& out) { out.push_back(std::make_unique<Epeck>()); }

}  // namespace veritope::bench
