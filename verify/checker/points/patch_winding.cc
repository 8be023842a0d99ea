// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "patch_winding.h"

#include "../patches/star_node.h"

namespace {

struct OpenPiece {
  Rectangle at;
  Block net;  // R: three numbers for each control point
};

int sign_of(const uint64_t* a, int n) {
  if (int64_t(a[n - 1]) < 0) return -1;
  for (int i = 0; i < n; ++i)
    if (a[i] != 0) return 1;
  return 0;
}

// The sign that all have, or 0. get(i): the sign of number i.
template <class Get>
int one_sign(size_t count, Get get) {
  const int first = get(0);
  for (size_t i = 1; i < count && first != 0; ++i)
    if (get(i) != first) return 0;
  return first;
}
int one_sign(const Block& net, size_t points, int k) {
  return one_sign(points, [&](size_t i) { return sign_of(net.number(3 * i + size_t(k)), net.n); });
}

class Counter {
 public:
  Counter(const std::vector<Grid>& grids, const RationalPoint& point, int direction,
          PointUnits* units)
      : grids_(grids),
        nets_(grids, point),
        axis_(direction / 2),
        ahead_(direction % 2 == 0 ? 1 : -1),
        sides_(&nets_, axis_, units),
        units_(units) {}

  void add_patch(uint32_t patch) {
    const Mark zero, one(1);
    std::vector<OpenPiece> todo;
    todo.push_back(OpenPiece{{patch, {zero, zero}, {one, one}, {0, 0}}, packed(nets_.of(patch))});
    while (!todo.empty()) {
      const OpenPiece piece = std::move(todo.back());
      todo.pop_back();
      const int place = place_of(piece);
      if (place > 0) sides_.add(piece.at);
      if (place != 0) continue;
      const int k = axis_to_halve(piece);
      if (piece.at.halvings[k] == kMostHalvingsOnRay) {
        is_left_over_ = true;
        continue;
      }
      for (int half = 0; half < 2; ++half) {
        Rectangle at = piece.at;
        ++at.halvings[k];
        (half == 0 ? at.hi : at.lo)[k] = middle(piece.at.lo[k], piece.at.hi[k]);
        todo.push_back(
            OpenPiece{std::move(at), half_of(grids_[patch].shape, k, half, 3, piece.net)});
      }
    }
  }

  // False if a piece or a part of a line was halved too often.
  bool sum(int64_t* result) {
    if (is_left_over_ || !sides_.sum(result)) return false;
    *result *= ahead_;
    return true;
  }

 private:
  // 1 ahead, -1 missed, 0 neither: steps 1 to 3 of the page.
  int place_of(const OpenPiece& piece) {
    const Grid& grid = grids_[piece.at.patch];
    const size_t points = size_t(grid.count());
    for (int k = 1; k < 3; ++k)
      if (one_sign(piece.net, points, (axis_ + k) % 3) != 0) return -1;
    const int along = ahead_ * one_sign(piece.net, points, axis_);
    if (along < 0) return -1;
    const uint64_t h =
        uint64_t(grid.bits + nets_.bits_of_point() + grid.shape.p * piece.at.halvings[0] +
                 grid.shape.q * piece.at.halvings[1]);
    units_->add(16 + (grid.count() * h * (64 * grid.degrees() + h) >> 16));
    if (along > 0) return 1;

    Big normal[3];
    set_normal(grid, piece.net, normal);
    const int side = one_sign(points, [&](size_t i) {
      Big sum;
      for (size_t k = 0; k < 3; ++k)
        sum = sum + normal[k] * Big::of(piece.net.number(3 * i + k), piece.net.n);
      return sum.sign();
    });
    if (side == 0) return 0;
    return side * normal[axis_].sign() * ahead_ > 0 ? 1 : -1;
  }
  static void set_normal(const Grid& grid, const Block& net, Big* normal) {
    const int p = grid.shape.p, q = grid.shape.q;
    const int corner[4] = {grid.shape.at(0, 0), grid.shape.at(p, 0), grid.shape.at(0, q),
                           grid.shape.at(p, q)};
    Big a[3], b[3];
    for (int k = 0; k < 3; ++k) {
      Big at[4];
      for (int c = 0; c < 4; ++c) at[c] = Big::of(net.number(size_t(3 * corner[c] + k)), net.n);
      const Big diagonal = at[3] - at[0], other = at[1] - at[2];
      a[k] = diagonal + other;
      b[k] = diagonal - other;
    }
    for (int k = 0; k < 3; ++k)
      normal[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
  }

  int axis_to_halve(const OpenPiece& piece) const {  // step 4
    const Grid& grid = grids_[piece.at.patch];
    bool is_at_pole[2] = {false, false};
    for (int side = 0; side < 4; ++side)
      if (grid.is_collapsed(side) && piece.at.is_on_border(side)) is_at_pole[1 - side % 2] = true;
    if (is_at_pole[0] != is_at_pole[1]) return is_at_pole[0] ? 0 : 1;
    const int order = compare(length(grid.shape, piece.net, 0), length(grid.shape, piece.net, 1));
    if (order != 0) return order > 0 ? 0 : 1;
    return piece.at.halvings[0] <= piece.at.halvings[1] ? 0 : 1;
  }
  static Big length(const Shape& shape, const Block& net, int axis) {
    const int n = axis == 0 ? shape.p : shape.q, rows = axis == 0 ? shape.q : shape.p;
    Big most;
    for (int row = 0; row <= rows; ++row) {
      Big sum;
      for (int i = 0; i < n; ++i) {
        const int from = axis == 0 ? shape.at(i, row) : shape.at(row, i),
                  to = axis == 0 ? shape.at(i + 1, row) : shape.at(row, i + 1);
        for (int k = 0; k < 3; ++k) {
          Big step = Big::of(net.number(size_t(3 * to + k)), net.n) -
                     Big::of(net.number(size_t(3 * from + k)), net.n);
          step.neg = false;
          sum = sum + step;
        }
      }
      if (most < sum) most = sum;
    }
    return most;
  }

  const std::vector<Grid>& grids_;
  RelativeNets nets_;
  const int axis_, ahead_;  // ahead_: the sign of the direction
  SidesAhead sides_;
  PointUnits* const units_;
  bool is_left_over_ = false;
};

}  // namespace

bool sum_around(const std::vector<Grid>& grids, const std::vector<uint32_t>& patches,
                const RationalPoint& point, int direction, PointUnits* units, int64_t* sum) {
  Counter counter(grids, point, direction, units);
  for (uint32_t patch : patches) counter.add_patch(patch);
  return counter.sum(sum);
}

int64_t winding_number(const std::vector<Grid>& grids, const PatchBoxes& boxes,
                       const RationalPoint& point, int direction, const std::string& where,
                       PointUnits* units) {
  int64_t sum = 0;
  if (!sum_around(grids, boxes.on_ray(point, direction), point, direction, units, &sum))
    throw Rejected{"P3", "a piece or a curve was halved too often" + where};
  return sum;
}
