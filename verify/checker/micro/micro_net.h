// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_net.h: nets of Bernstein coefficients in double precision with a bound of their error, and the points and
// triangles of docs/certificates/micro-inside.md, section 3. What is said here to be known is so for any of the
// roundings of IEEE 754 (micro_double.h); overflow makes it unknown.
#pragma once
#include "../mesh/mesh.h"
#include "micro_double.h"

const double kTiny = 1e-300;  // far above what underflow can add to an error

struct DoubleNet {
  size_t n[3] = {1, 1, 1};  // coefficients along the axes, the last one the fastest
  size_t stride = 3;        // numbers of a coefficient; 4: X, Y, Z, W
  std::vector<double> v;
  double error = 0;  // each number differs by at most this from the exact one

  double size() const {  // the greatest absolute value
    double r = 0;
    for (double x : v) r = std::max(r, std::abs(x));
    return r;
  }
  size_t degrees() const { return n[0] + n[1] + n[2] - 3; }
  void add(const Span& x) {  // appends a number
    v.push_back(x.lo + (x.hi - x.lo) / 2);
    if (!(x.hi - x.lo <= error)) error = x.hi - x.lo;
  }
};
// The net of the polynomials on [a, b] along the axis, or on a greater interval; 0 <= a <= b <= 1.
void restrict_net(DoubleNet* net, size_t axis, double a, double b);
// Both halves along the axis.
void halve_net(const DoubleNet& net, size_t axis, DoubleNet* lower, DoubleNet* upper);
// The coefficients' least box, or a greater one. The net's stride is 3.
DoubleBox box_of(const DoubleNet& net);

// The points of a net: each coordinate differs by at most `error` from the exact one. Unless is_known, nothing is.
struct PointHull {
  std::vector<double> p;
  double error;
  DoubleBox box;  // contains the exact points
  bool is_known;
};
void set_hull(const DoubleNet& net, PointHull* hull);

const uint64_t kMostPairs = 1 << 30;  // of nodes with triangles or patches

// The surface of the model, as I1 and I4 ask about it.
class Obstacle {
 public:
  virtual ~Obstacle() {}
  // Patches, or triangles.
  virtual bool has_patches() const = 0;
  // Whether the points are known to be apart from all of it. Adds the pairs whose boxes meet; those of blocks of cells
  // may be decided by boxes alone.
  virtual bool misses(const PointHull& hull, uint64_t* pairs) = 0;
  virtual bool misses_block(const PointHull& hull, uint64_t* pairs) = 0;
  // Whether a part of it, as I4 says, is known to be at most this far from each point. Adds the parts that are tried.
  virtual bool is_near(const PointHull& hull, double distance, uint64_t* pairs) = 0;
};

class Triangles : public Obstacle {
 public:
  explicit Triangles(const Model& model);
  bool has_patches() const override { return false; }
  bool misses(const PointHull& hull, uint64_t* pairs) override;
  bool misses_block(const PointHull& hull, uint64_t*) override {
    return hull.is_known && tree_.each(hull.box, [](uint32_t) { return false; });
  }
  bool is_near(const PointHull& hull, double distance, uint64_t* pairs) override;

 private:
  void corners(uint32_t face, double (*to)[3]) const {
    for (size_t i = 0; i < 3; ++i)
      for (size_t k = 0; k < 3; ++k)
        to[i][k] = points_[3 * size_t(model_.tri[3 * size_t(face) + i]) + k];
  }

  const Model& model_;
  std::vector<double> points_;  // of the vertices
  BoxTree tree_;
};
