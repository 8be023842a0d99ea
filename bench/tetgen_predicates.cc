// SPDX-License-Identifier: LGPL-3.0-or-later
// Shewchuk's predicates as in Debian's tetgen: those in space with a static filter for the model's box, those in the
// plane of [She97]. Its orient3d has the opposite sign of ours, and so has its insphere.
#include <tetgen.h>

#include <algorithm>
#include <cmath>

#include "bench/predicate_peers.h"

// In the library, but missing from its header.
REAL orient2d(REAL* a, REAL* b, REAL* c);
REAL incircle(REAL* a, REAL* b, REAL* c, REAL* d);

namespace veritope::bench {
namespace {

class Tetgen : public PredicatePeer {
 public:
  Tetgen() : PredicatePeer("tetgen", 32768) { exactinit(0, 0, 0, 1, 1, 1); }
  void load(const Vec2d* points, std::size_t count) override {
    c_.clear();
    for (std::size_t i = 0; i < count; ++i) c_.insert(c_.end(), {points[i].x, points[i].y});
  }
  // The bounds of the filters hold for the extents that exactinit gets.
  void load(const Vec3d* points, std::size_t count) override {
    c_.clear();
    Vec3d lo = points[0], hi = points[0];
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3d& p = points[i];
      c_.insert(c_.end(), {p.x, p.y, p.z});
      lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
      hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
    }
    exactinit(0, 0, 0, hi.x - lo.x, hi.y - lo.y, hi.z - lo.z);
  }
  void decide(Predicate predicate, std::size_t n, signed char* out) override {
    for (std::size_t i = 0; i < n; ++i) {
      double *p = c_.data(), d = 0;
      switch (predicate) {
        case Predicate::kOrient2d: p += 6 * i, d = ::orient2d(p, p + 2, p + 4); break;
        case Predicate::kOrient3d: p += 12 * i, d = -::orient3d(p, p + 3, p + 6, p + 9); break;
        case Predicate::kInCircle: p += 8 * i, d = ::incircle(p, p + 2, p + 4, p + 6); break;
        case Predicate::kInSphere:
          p += 15 * i, d = -::insphere(p, p + 3, p + 6, p + 9, p + 12);
          break;
      }
      out[i] = static_cast<signed char>((d > 0) - (d < 0));
    }
  }

 private:
  std::vector<double> c_;
};

}  // namespace

void add_tetgen_predicates(PredicatePeers& out) { out.push_back(std::make_unique<Tetgen>()); }

}  // namespace veritope::bench
