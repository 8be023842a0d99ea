// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "robust/base/check.h"
#include "solids/dms/dms_polynomials.h"
#include "solids/dms/fast/dms_inverse.h"
#include "solids/dms/fast/dms_inverse_internal.h"

namespace veritope {
namespace {

using internal::dot;
using internal::kInverseEdge;

// A box of a cell's part: its middle, as an offset from the cell's origin, and half its sides.
struct Part {
  Point3d middle, half;
};

double multinomial(int degree, const std::array<int, 3>& exponents) {
  double out = 1;
  int left = degree;
  for (const int e : exponents)
    for (int k = 1; k <= e; ++k) out *= static_cast<double>(left--) / k;
  return out;
}

Point3d rounded(const DmsPoint& p) {
  return {nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])};
}

}  // namespace

// Halves the boxes of cells until the map is even on them.
class DmsInverseMaker {
 public:
  DmsInverseMaker(const DmsModel& model, const DmsInverseOptions& options)
      : model_(model), options_(options), out_(model.degree, options.component ? 4 : 3) {
    double greatest = 0;
    for (std::size_t i = 0; i < model.num_control(); ++i)
      for (std::size_t c = 0; c < 3; ++c)
        greatest = std::max(greatest, std::abs(nearest_double(model.value(i)[c])));
    int exponent = 0;
    if (std::isfinite(greatest)) std::frexp(greatest, &exponent);
    out_.scale_ = std::ldexp(1.0, std::clamp(-exponent, -1000, 1000));
  }

  Result<DmsInverse> run() {
    const Status status = for_each_tetrahedron<std::vector<Made>>(
        model_, {options_.jobs, options_.max_cells},
        [this](DmsPolynomials& polynomials, std::uint32_t tetrahedron) {
          return make(polynomials, tetrahedron);
        },
        [this](std::uint32_t tetrahedron, const std::vector<Made>& cells) {
          return take(tetrahedron, cells);
        });
    if (!status) return status.error();
    out_.boxes_ = BoxHierarchy(boxes_);
    return std::move(out_);
  }

 private:
  // A cell with its leaves, whose number is not yet known.
  struct Made {
    DmsInverse::Cell cell;
    std::vector<DmsInverse::HalfSpace> half_spaces;
    std::vector<DmsInverse::Leaf> leaves;
    std::vector<double> nets;
    std::vector<Box3d> boxes;
  };

  Status take(std::uint32_t tetrahedron, const std::vector<Made>& cells) {
    for (const Made& made : cells) {
      if (out_.leaves_.size() + made.leaves.size() > options_.max_leaves)
        return too_many(tetrahedron);
      DmsInverse::Cell cell = made.cell;
      cell.first = out_.half_spaces_.size();
      const auto append = [](auto& to, const auto& from) {
        to.insert(to.end(), from.begin(), from.end());
      };
      append(out_.half_spaces_, made.half_spaces);
      cell.end = out_.half_spaces_.size();
      for (DmsInverse::Leaf leaf : made.leaves) {
        leaf.cell = static_cast<std::uint32_t>(out_.cells_.size());
        out_.leaves_.push_back(leaf);
      }
      out_.cells_.push_back(cell);
      append(out_.nets_, made.nets);
      for (Box3d box : made.boxes) {
        boxes_.push_back(box);
        for (std::size_t c = 0; c < 3; ++c) box.lo[c] /= out_.scale_, box.hi[c] /= out_.scale_;
        out_.box_ = hull(out_.box_, box);
      }
    }
    return ok_status();
  }
  Error too_many(std::uint32_t tetrahedron) const {
    return error_in_tetrahedron(
        Code::kOverLimit, tetrahedron,
        "the solid is too uneven for " + std::to_string(options_.max_leaves) + " parts");
  }

  Result<std::vector<Made>> make(DmsPolynomials& polynomials, std::uint32_t tetrahedron) const {
    std::vector<Made> out;
    const Status status =
        polynomials.visit_cells(tetrahedron, [&](const DmsCell& cell, DmsRestriction& map) {
          return add_leaves(tetrahedron, cell, map, out.emplace_back());
        });
    if (!status) return status.error();
    return out;
  }

  Status add_leaves(std::uint32_t tetrahedron, const DmsCell& cell, DmsRestriction& map,
                    Made& made) const {
    const Part whole = start(cell, made);
    const double size = std::max({whole.half[0], whole.half[1], whole.half[2]});
    std::vector<Part> todo{whole};
    while (!todo.empty()) {
      const Part part = todo.back();
      todo.pop_back();
      if (is_beside(part, made)) continue;
      const Result<bool> added = add_leaf(tetrahedron, part, map, made);
      if (!added) return added.error();
      if (made.leaves.size() > options_.max_leaves) return too_many(tetrahedron);
      const std::size_t axis = static_cast<std::size_t>(
          std::max_element(part.half.begin(), part.half.end()) - part.half.begin());
      if (*added || part.half[axis] < size * 0x1p-24) continue;
      for (const double side : {1.0, -1.0}) {
        Part half = part;
        half.half[axis] *= 0.5;
        half.middle[axis] += side * half.half[axis];
        todo.push_back(half);
      }
    }
    return ok_status();
  }

  // The half-spaces of the cell, and the box around it.
  static Part start(const DmsCell& cell, Made& made) {
    const Box3d box = box_around(cell.corners);
    DmsPoint origin;
    for (std::size_t k = 0; k < 3; ++k) {
      made.cell.origin[k] = 0.5 * box.lo[k] + 0.5 * box.hi[k];
      origin[k] = Rational::from_double(made.cell.origin[k]);
    }
    Part whole{};
    for (const DmsPoint& corner : cell.corners) {
      const Point3d d = rounded(difference(corner, origin));
      for (std::size_t k = 0; k < 3; ++k)
        whole.half[k] = std::max(whole.half[k], std::abs(d[k]) * (1 + 0x1p-50));
      for (std::size_t k = 0; k < 3; ++k)
        made.cell.inside[k] += d[k] / static_cast<double>(cell.corners.size());
    }
    for (const DmsPlane& plane : cell.planes) {
      // Lengths of exact vectors may be beyond binary64; a power of two brings them near 1.
      std::int64_t bits = INT64_MIN;
      for (const Rational& x : plane.vector)
        if (x.sign() != Sign::kZero)
          bits = std::max(bits, static_cast<std::int64_t>(x.numerator().bit_length()) -
                                    static_cast<std::int64_t>(x.denominator().bit_length()));
      const Rational by = Rational::power_of_two(-bits);
      DmsPoint scaled = plane.vector;
      for (Rational& x : scaled) x *= by;
      const Point3d n = rounded(scaled);
      const double length = std::sqrt(dot(n, n));
      made.half_spaces.push_back(
          {{n[0] / length, n[1] / length, n[2] / length},
           nearest_double(dot_product(scaled, origin) - plane.number * by) / length});
    }
    made.cell.slack = kInverseEdge * std::max({whole.half[0], whole.half[1], whole.half[2]});
    return whole;
  }
  static bool is_beside(const Part& part, const Made& made) {
    return std::any_of(made.half_spaces.begin(), made.half_spaces.end(), [&](const auto& h) {
      double most = h.height + dot(h.normal, part.middle);
      for (std::size_t k = 0; k < 3; ++k) most += std::abs(h.normal[k]) * part.half[k];
      return most < -made.cell.slack;
    });
  }

  // The components on a box, as sums of monomials: those of the tetrahedron with the middle and points at a radius from
  // it along the axes as corners. Each is a difference of its Bernstein coefficients.
  std::vector<double> monomials_on(const DmsInverse::Leaf& leaf, const Point3d& origin,
                                   DmsRestriction& map) const {
    DmsPoint middle;
    for (std::size_t k = 0; k < 3; ++k)
      middle[k] = Rational::from_double(origin[k]) + Rational::from_double(leaf.middle[k]);
    std::array<DmsPoint, 4> corners{middle, middle, middle, middle};
    for (std::size_t k = 0; k < 3; ++k) corners[k + 1][k] += Rational::from_double(leaf.radius);
    const auto components = map.on(corners);
    std::vector<double> out;
    const auto add = [&](const std::vector<double>& coefficients, double scale) {
      std::vector<double> b = coefficients;
      for_each_tetrahedral_index(model_.degree, [&](const TetrahedralIndex& index) {
        out.push_back(multinomial(model_.degree, {index[1], index[2], index[3]}) * scale *
                      difference_of(b, index));
      });
    };
    for (std::size_t c = 0; c < 3; ++c) add(components[c], out_.scale_);
    if (options_.component) add(components[*options_.component], 1);
    return out;
  }
  // The difference of order index[k] along the edges from corner 0 to corner k.
  double difference_of(const std::vector<double>& b, const TetrahedralIndex& index) const {
    double sum = 0;
    const int rest = model_.degree - index[1] - index[2] - index[3];
    for (int i = 0; i <= index[1]; ++i)
      for (int j = 0; j <= index[2]; ++j)
        for (int k = 0; k <= index[3]; ++k) {
          const int lower = index[1] - i + index[2] - j + index[3] - k;
          const double ways = binomial(index[1], i) * binomial(index[2], j) * binomial(index[3], k);
          sum += (lower % 2 == 0 ? ways : -ways) * b[tetrahedral_index({rest + lower, i, j, k})];
        }
    return sum;
  }
  static double binomial(int n, int k) {
    double out = 1;
    for (int i = 1; i <= k; ++i) out = out * (n - k + i) / i;
    return out;
  }

  // False if the map is not even enough there.
  Result<bool> add_leaf(std::uint32_t tetrahedron, const Part& part, DmsRestriction& map,
                        Made& made) const {
    DmsInverse::Leaf leaf;
    leaf.middle = part.middle;
    int exponent = 0;
    std::frexp(std::max({part.half[0], part.half[1], part.half[2]}), &exponent);
    leaf.radius = std::ldexp(1.0, exponent);
    for (std::size_t k = 0; k < 3; ++k) leaf.reach[k] = part.half[k] / leaf.radius;
    const std::vector<double> net = monomials_on(leaf, made.cell.origin, map);
    if (!std::all_of(net.begin(), net.end(), [](double x) { return std::isfinite(x); }))
      return error_in_tetrahedron(Code::kNotFinite, tetrahedron,
                                  "a number of the map is too large for binary64");
    const DmsInverse::Evaluated here = out_.evaluate(net.data(), {0, 0, 0});
    for (std::size_t c = 0; c < 3; ++c) {
      Point3d unit{};
      unit[c] = 1;
      const Point3d column = internal::solved(here.along, unit);
      for (std::size_t m = 0; m < 3; ++m) leaf.linear[m][c] = column[m];
    }
    Box3d box;
    if (!is_even(net, leaf, box)) return false;
    double greatest = 0;
    for (std::size_t c = 0; c < 3; ++c)
      greatest = std::max({greatest, std::abs(box.lo[c]), std::abs(box.hi[c])});
    for (const Point3d& row : leaf.linear)
      leaf.noise =
          std::max(leaf.noise,
                   0x1p-46 * greatest * (std::abs(row[0]) + std::abs(row[1]) + std::abs(row[2])));
    const double wider = kInverseEdge * extent(box) + 0x1p-46 * greatest;
    for (std::size_t c = 0; c < 3; ++c) box.lo[c] -= wider, box.hi[c] += wider;
    made.boxes.push_back(box);
    made.leaves.push_back(leaf);
    made.nets.insert(made.nets.end(), net.begin(), net.end());
    return true;
  }

  // Sums up the sizes that monomials of degree 2 and more have in the box: in the derivative times the inverse of that
  // in the middle; in the place that this inverse gives (leaf.off); and in the image (box).
  bool is_even(const std::vector<double>& net, DmsInverse::Leaf& leaf, Box3d& box) const {
    std::array<Point3d, 3> off{};  // [row][axis]
    Point3d reach{};
    leaf.off = {0, 0, 0};
    const std::size_t n = out_.count_;
    for (std::size_t i = 1; i < n; ++i) {
      const std::array<int, 3>& e = out_.exponents_[i];
      const Point3d b{net[i], net[n + i], net[2 * n + i]};
      double size = 1;
      for (std::size_t k = 0; k < 3; ++k) size *= std::pow(leaf.reach[k], e[k]);
      for (std::size_t c = 0; c < 3; ++c) reach[c] += std::abs(b[c]) * size;
      if (e[0] + e[1] + e[2] < 2) continue;
      const Point3d moved = internal::times(leaf.linear, b);
      for (std::size_t m = 0; m < 3; ++m) {
        leaf.off[m] += std::abs(moved[m]) * size;
        for (std::size_t k = 0; k < 3; ++k)
          if (e[k] > 0) off[m][k] += std::abs(moved[m]) * e[k] * size / leaf.reach[k];
      }
    }
    for (std::size_t c = 0; c < 3; ++c)
      box.lo[c] = net[c * n] - reach[c], box.hi[c] = net[c * n] + reach[c];
    double squares = 0;
    for (const Point3d& row : off) squares += dot(row, row);
    return squares <= 0.25;
  }

  const DmsModel& model_;
  const DmsInverseOptions& options_;
  DmsInverse out_;
  std::vector<Box3d> boxes_;
};

Result<DmsInverse> DmsInverse::make(const DmsModel& model, const DmsInverseOptions& options) {
  VT_CHECK(model.num_coordinates == 3, "an attribute domain has no shape");
  VT_CHECK(!options.component || *options.component < model.num_components(),
           "a component of the model");
  return DmsInverseMaker(model, options).run();
}

}  // namespace veritope
