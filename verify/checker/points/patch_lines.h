// SPDX-License-Identifier: Apache-2.0 OR MIT
// patch_lines.h: the sides of the pieces that are ahead, and how often what is left of them goes around the point:
// "Curves" of docs/certificates/points.md, section 6.
#pragma once
#include "patch_grid.h"

const int64_t kMostHalvingsOnRay = 4096;  // of a piece in one parameter; of a part of a line

struct PointUnits {  // of work
  uint64_t limit;    // of all points together
  uint64_t done = 0, done_on_point = 0;

  PointUnits(uint64_t bytes, uint64_t points);
  void begin_point() { done_on_point = 0; }
  bool are_spent() const { return done > limit; }
  void add(uint64_t units);
};

class RelativeNets {  // R on whole patches
 public:
  RelativeNets(const std::vector<Grid>& grids, const RationalPoint& point)
      : grids_(grids), point_(point) {}
  const std::vector<Grid>& grids() const { return grids_; }
  int64_t bits_of_point() const { return point_.bits; }
  const std::vector<Big>& of(uint32_t patch) {
    std::vector<Big>& known = nets_[patch];
    if (known.empty()) known = grids_[patch].around(point_);
    return known;
  }

 private:
  const std::vector<Grid>& grids_;
  const RationalPoint& point_;
  std::map<uint32_t, std::vector<Big>> nets_;
};

struct Rectangle {  // of parameters
  uint32_t patch;
  Mark lo[2], hi[2];
  int64_t halvings[2];
  // Whether its side is a part of this side of the patch.
  bool is_on_border(int side) const {
    return side == 0   ? lo[1] == Mark()
           : side == 1 ? hi[0] == Mark(1)
           : side == 2 ? hi[1] == Mark(1)
                       : lo[0] == Mark();
  }
};

class SidesAhead {
 public:
  // axis: of the ray.
  SidesAhead(RelativeNets* nets, int axis, PointUnits* units)
      : nets_(*nets), axis_(axis), units_(*units) {}
  void add(const Rectangle& piece);
  // The sum of all lines. False if a part of a line was halved too often.
  bool sum(int64_t* result);

 private:
  struct Interval {  // a side of a piece that is ahead
    uint64_t line;   // twice a pair; or twice a patch and whether v is the parameter, twice, and 1
    Mark place;      // of an inner line
    Mark lo, hi;
    int sign;  // 1: passed from lo to hi

    bool is_on_line_of(const Interval& b) const { return line == b.line && place == b.place; }
  };
  static bool before(const Interval& a, const Interval& b) {
    return a.line != b.line ? a.line < b.line : a.place < b.place;
  }
  struct Curve {
    std::vector<Big> x, y;
    uint64_t bits = 0;  // b + t, and what the place of an inner line adds
  };
  int64_t number_of_line(size_t first, size_t last);
  Curve curve_of(const Interval& on);
  void add_point(uint32_t patch, int at, Curve* to);
  int64_t crossing_number(const Curve& whole, const Mark& begin, const Mark& end);

  RelativeNets& nets_;
  const int axis_;
  PointUnits& units_;
  std::vector<Interval> intervals_;
  bool is_left_over_ = false;
};
