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

class Triangles {
 public:
  explicit Triangles(const Model& model);
  // Whether the box is apart from all triangles along an axis.
  bool miss(const DoubleBox& box) const {
    return tree_.each(box, [](uint32_t) { return false; });
  }
  // Whether the points are known to be apart from each triangle. Counts the triangles whose boxes meet theirs.
  bool miss(const PointHull& hull, uint64_t* pairs) const;
  // Whether there is a triangle that is known to be at most this far from each point. Counts those that are tried.
  bool is_near(const PointHull& hull, double distance, uint64_t* pairs) const;

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
