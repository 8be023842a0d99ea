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

using Corners = std::array<DmsPoint, 4>;

constexpr int kMostHalvings = 72;
constexpr std::size_t kMostNumbers = std::size_t{1} << 27;  // of all parts: a gigabyte
constexpr double kLeastHeight = 0x1p-48;
// Where triangles of knots cut thin cells, the polynomial may be so steep that rounding errors of places exceed the
// first number. Then parts with heights below the second one are left out, and those whose images are so thin that
// halving them does not help. Others are halved.
constexpr double kMostNoise = 0x1p-24, kThin = 0x1p-20;

struct Part {
  Corners corners;
  int halvings = 0;
};

// The middle of an edge in the place of either of its ends.
std::pair<Part, Part> halves(const Part& part, const std::array<std::size_t, 2>& edge) {
  const auto [i, j] = edge;
  DmsPoint middle;
  for (std::size_t c = 0; c < 3; ++c)
    middle[c] = (part.corners[i][c] + part.corners[j][c]) * Rational::power_of_two(-1);
  Part first{part.corners, part.halvings + 1}, second = first;
  first.corners[j] = middle, second.corners[i] = middle;
  return {std::move(first), std::move(second)};
}

Point3d rounded(const DmsPoint& p) {
  return {nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])};
}

}  // namespace

// Halves the parts until the map is even on them.
class DmsInverseMaker {
 public:
  DmsInverseMaker(const DmsModel& model, const DmsInverseOptions& options)
      : model_(model), options_(options), out_(model.degree, options.component ? 4 : 3) {
    const std::size_t stride = model_.num_components();
    Box3d box = empty_box();
    for (std::size_t i = 0; i < model_.num_control(); ++i)
      for (std::size_t c = 0; c < 3; ++c) {
        const double x = nearest_double(model_.value(i)[c]);
        box.lo[c] = std::min(box.lo[c], x), box.hi[c] = std::max(box.hi[c], x);
      }
    // Basis functions add up to 1, so a translation of the control points is one of the solid.
    for (std::size_t c = 0; c < 3; ++c) {
      const double middle = 0.5 * box.lo[c] + 0.5 * box.hi[c];
      if (!std::isfinite(middle)) continue;
      out_.offset_[c] = middle;
      const Rational offset = Rational::from_double(middle);
      for (std::size_t i = 0; i < model_.num_control(); ++i)
        model_.control.values[i * stride + c] -= offset;
    }
    int exponent = 0;
    if (std::isfinite(extent(box))) std::frexp(extent(box), &exponent);
    out_.scale_ = std::ldexp(1.0, std::clamp(-exponent, -1000, 1000));
  }

  Result<DmsInverse> run() {
    const Status status = for_each_tetrahedron<Made>(
        model_, {options_.jobs, options_.max_cells},
        [this](DmsPolynomials& polynomials, std::uint32_t tetrahedron) {
          return make(polynomials, tetrahedron);
        },
        [this](std::uint32_t tetrahedron, const Made& made) { return take(tetrahedron, made); });
    if (!status) return status.error();
    if (boxes_.empty())
      return Error{Code::kOverLimit, {}, "all tetrahedra are thinner than 2^-48 of their size"};
    out_.boxes_ = BoxHierarchy(boxes_);
    return std::move(out_);
  }

 private:
  struct Made {
    std::vector<DmsInverse::Leaf> leaves;
    std::vector<double> nets;
    std::vector<Box3d> boxes;
  };

  Status take(std::uint32_t tetrahedron, const Made& made) {
    if (is_over(out_.leaves_.size() + made.leaves.size())) return too_many(tetrahedron);
    const auto append = [](auto& to, const auto& from) {
      to.insert(to.end(), from.begin(), from.end());
    };
    append(out_.leaves_, made.leaves);
    append(out_.nets_, made.nets);
    append(boxes_, made.boxes);
    for (Box3d box : made.boxes) {
      for (std::size_t c = 0; c < 3; ++c) {
        box.lo[c] = box.lo[c] / out_.scale_ + out_.offset_[c];
        box.hi[c] = box.hi[c] / out_.scale_ + out_.offset_[c];
      }
      out_.box_ = hull(out_.box_, box);
    }
    return ok_status();
  }
  bool is_over(std::size_t num_parts) const {
    return num_parts > options_.max_parts || num_parts > kMostNumbers / out_.stride_;
  }
  static Error too_many(std::uint32_t tetrahedron) {
    return error_in_tetrahedron(Code::kOverLimit, tetrahedron,
                                "the map is too uneven, or has too many pieces, to be inverted");
  }

  Result<Made> make(DmsPolynomials& polynomials, std::uint32_t tetrahedron) const {
    Made out;
    const Status status = polynomials.visit_cells(
        tetrahedron, [&](const DmsCell& cell, const auto& components, DmsRestriction& map) {
          DmsRestriction slope = slope_of(cell.tetrahedra[0], components);
          for (const Corners& corners : cell.tetrahedra)
            if (Status added = add(tetrahedron, corners, map, slope, out); !added) return added;
          return ok_status();
        });
    if (!status) return status.error();
    return out;
  }

  // The nine components of the derivative, row by row.
  DmsRestriction slope_of(const Corners& corners,
                          const std::vector<std::vector<Rational>>& components) const {
    std::vector<std::vector<Rational>> out(9);
    const Rational degree(model_.degree);
    for_each_tetrahedral_index(model_.degree - 1, [&](const TetrahedralIndex& gamma) {
      Corners four;
      for (std::size_t m = 0; m < 4; ++m)
        for (std::size_t c = 0; c < 3; ++c)
          four[m][c] = components[c][tetrahedral_index(raised(gamma, m))] * degree;
      DmsMatrix linear = linear_part(corners, four);
      for (std::size_t i = 0; i < 9; ++i) out[i].push_back(std::move(linear[i]));
    });
    return {model_.degree - 1, corners, out};
  }

  Status add(std::uint32_t tetrahedron, const Corners& corners, DmsRestriction& map,
             DmsRestriction& slope, Made& made) const {
    std::vector<Part> todo{{corners, 0}};
    while (!todo.empty()) {
      const Part part = std::move(todo.back());
      todo.pop_back();
      DmsInverse::Leaf leaf;
      if (!place(part, leaf)) continue;
      std::array<std::size_t, 2> edge{};
      const Result<bool> added = add_leaf(tetrahedron, part, map, slope, leaf, edge, made);
      if (!added) return added.error();
      if (is_over(made.leaves.size())) return too_many(tetrahedron);
      if (*added || part.halvings == kMostHalvings) continue;
      auto [first, second] = halves(part, edge);
      todo.push_back(std::move(second));
      todo.push_back(std::move(first));
    }
    return ok_status();
  }

  // The coordinates of a part, and its planes, whose normals come from exact ones. False if it is too thin.
  static bool place(const Part& part, DmsInverse::Leaf& leaf) {
    DmsPoint middle;
    for (std::size_t c = 0; c < 3; ++c) {
      Rational sum;
      for (const DmsPoint& corner : part.corners) sum += corner[c];
      leaf.middle[c] = nearest_double(sum * Rational::power_of_two(-2));
      middle[c] = Rational::from_double(leaf.middle[c]);
    }
    double size = 0;
    for (std::size_t m = 0; m < 4; ++m) {
      leaf.corners[m] = rounded(difference(part.corners[m], middle));
      for (const double x : leaf.corners[m]) size = std::max(size, std::abs(x));
    }
    int exponent = 0;
    std::frexp(size, &exponent);
    leaf.radius = std::ldexp(1.0, exponent);
    for (Point3d& corner : leaf.corners)
      for (double& x : corner) x /= leaf.radius;
    const std::vector<DmsPlane> planes = face_planes(part.corners);
    for (std::size_t m = 0; m < 4; ++m) {
      // Lengths of exact vectors may be beyond binary64; a power of two brings them near 1.
      std::int64_t bits = INT64_MIN;
      for (const Rational& x : planes[m].vector)
        if (x.sign() != Sign::kZero)
          bits = std::max(bits, static_cast<std::int64_t>(x.numerator().bit_length()) -
                                    static_cast<std::int64_t>(x.denominator().bit_length()));
      const Rational by = Rational::power_of_two(-bits);
      DmsPoint scaled = planes[m].vector;
      for (Rational& x : scaled) x *= by;
      const Point3d n = rounded(scaled);
      const Rational number = planes[m].number * by;
      const double length = std::copysign(
          std::sqrt(dot(n, n)), nearest_double(dot_product(scaled, part.corners[m]) - number));
      leaf.normals[m] = {n[0] / length, n[1] / length, n[2] / length};
      leaf.heights[m] = nearest_double(dot_product(scaled, middle) - number) / length / leaf.radius;
    }
    return least_height(leaf) >= kLeastHeight;
  }

  // The components in a part's coordinates, as sums of monomials: from the tetrahedron with the middle and points at a
  // radius from it along the axes as corners.
  std::vector<double> monomials_on(const DmsInverse::Leaf& leaf, DmsRestriction& map) const {
    DmsPoint middle;
    for (std::size_t k = 0; k < 3; ++k) middle[k] = Rational::from_double(leaf.middle[k]);
    Corners corners{middle, middle, middle, middle};
    for (std::size_t k = 0; k < 3; ++k) corners[k + 1][k] += Rational::from_double(leaf.radius);
    const auto components = map.on(corners);
    std::vector<double> out;
    const auto add = [&](const std::vector<double>& coefficients, double scale) {
      for (const double x : internal::monomials_of(model_.degree, coefficients))
        out.push_back(x * scale);
    };
    for (std::size_t c = 0; c < 3; ++c) add(components[c], out_.scale_);
    if (options_.component) add(components[*options_.component], 1);
    return out;
  }

  // False if the map is not even enough there, and the edge that is to be halved.
  Result<bool> add_leaf(std::uint32_t tetrahedron, const Part& part, DmsRestriction& map,
                        DmsRestriction& slope, DmsInverse::Leaf& leaf,
                        std::array<std::size_t, 2>& edge, Made& made) const {
    const std::vector<double> net = monomials_on(leaf, map);
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
    const auto slopes = slope.on(part.corners);
    if (!is_even(slopes, leaf)) {
      edge = uneven_edge(slopes, leaf);
      return false;
    }
    Box3d box = empty_box();
    const auto components = map.on(part.corners);
    double greatest = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      for (const double x : components[c]) {
        box.lo[c] = std::min(box.lo[c], x * out_.scale_);
        box.hi[c] = std::max(box.hi[c], x * out_.scale_);
      }
      for (std::size_t i = 0; i < out_.count_; ++i)
        greatest = std::max(greatest, std::abs(net[c * out_.count_ + i]));
    }
    double inverse = 0;
    for (const Point3d& row : leaf.linear)
      inverse = std::max(inverse, std::abs(row[0]) + std::abs(row[1]) + std::abs(row[2]));
    leaf.noise = 0x1p-46 * greatest * inverse;
    if (!(leaf.noise <= kMostNoise)) {
      edge = longest_edge(leaf);
      return 0x1p-46 * inverse > kMostNoise || least_height(leaf) < kThin;
    }
    const double wider = kInverseEdge * extent(box) + 0x1p-46 * greatest;
    for (std::size_t c = 0; c < 3; ++c) box.lo[c] -= wider, box.hi[c] += wider;
    made.boxes.push_back(box);
    made.leaves.push_back(leaf);
    made.nets.insert(made.nets.end(), net.begin(), net.end());
    return true;
  }

  // The coefficients of the derivative, times the inverse of that in the middle, are near the identity; leaf.off
  // becomes what follows for places.
  bool is_even(const std::vector<std::vector<double>>& slope, DmsInverse::Leaf& leaf) const {
    const double by = out_.scale_ * leaf.radius;
    double most = 0;
    for (std::size_t i = 0; i < slope[0].size(); ++i) {
      double squares = 0;
      for (std::size_t m = 0; m < 3; ++m)
        for (std::size_t k = 0; k < 3; ++k) {
          const Point3d column{slope[k][i] * by, slope[3 + k][i] * by, slope[6 + k][i] * by};
          const double off = dot(leaf.linear[m], column) - (m == k ? 1.0 : 0.0);
          squares += off * off;
        }
      if (!(squares <= 0.25)) return false;
      most = std::max(most, squares);
    }
    double reach = 0;
    for (const Point3d& corner : leaf.corners) reach = std::max(reach, dot(corner, corner));
    leaf.off = std::sqrt(most * reach);
    return true;
  }

  // Along which the derivative changes most, or the longest one. Where it is nearly singular it changes in one
  // direction only, and halving along others, too, would take the square of the number of parts.
  std::array<std::size_t, 2> uneven_edge(const std::vector<std::vector<double>>& slope,
                                         const DmsInverse::Leaf& leaf) const {
    std::array<std::size_t, 2> out{};
    double most = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) {
        TetrahedralIndex at_i{}, at_j{};
        at_i[i] = at_j[j] = model_.degree - 1;
        double change = 0;
        for (std::size_t c = 0; c < 3; ++c) {
          Point3d moved;
          for (std::size_t k = 0; k < 3; ++k)
            moved[k] = slope[3 * k + c][tetrahedral_index(at_j)] -
                       slope[3 * k + c][tetrahedral_index(at_i)];
          const Point3d column = internal::times(leaf.linear, moved);
          change += dot(column, column);
        }
        if (change > most) most = change, out = {i, j};
      }
    return most > 0 && std::isfinite(most) ? out : longest_edge(leaf);
  }
  static std::array<std::size_t, 2> longest_edge(const DmsInverse::Leaf& leaf) {
    std::array<std::size_t, 2> out{};
    double most = -1;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) {
        const Point3d d = internal::minus(leaf.corners[i], leaf.corners[j]);
        if (dot(d, d) > most) most = dot(d, d), out = {i, j};
      }
    return out;
  }
  static double least_height(const DmsInverse::Leaf& leaf) {
    double out = 1;
    for (std::size_t m = 0; m < 4; ++m)
      out = std::min(out, dot(leaf.normals[m], leaf.corners[m]) + leaf.heights[m]);
    return out;
  }

  DmsModel model_;  // moved to the offset
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
