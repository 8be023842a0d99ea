// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "solids/pieces/root_choice_internal.h"

namespace veritope::internal {
namespace {

using Form = PieceForest::Form;

constexpr int kMaxRootBits = 6;
// Parts of rims are as short as the square root of the wall's thickness: as many as a certificate may have, unless the
// patches are so many that all might have more than 2^kMostBitsOfAll.
constexpr int kMostRimBits = 12, kMostBitsOfAll = 22;
int most_rim_bits(std::size_t num_patches) {
  return std::clamp(kMostBitsOfAll - static_cast<int>(std::bit_width(num_patches)), kMaxRootBits,
                    kMostRimBits);
}

// The part of the bend of a wall that counts for the rim beside it, which is cut less finely than a bent one.
constexpr double kBesideStraight = 0.25;

Point3d minus(const Point3d& a, const Point3d& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double length(const Point3d& a) { return std::hypot(a[0], a[1], a[2]); }
double distance(const Point3d& a, const Point3d& b) { return length(minus(a, b)); }
Point3d cross(const Point3d& a, const Point3d& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The control points of a patch.
class ControlPoints {
 public:
  explicit ControlPoints(const Form& form) : form_(form) {}

  std::size_t count() const { return form_.shape.count(); }
  Point3d operator[](std::size_t i) const {
    Point3d out;
    for (std::size_t c = 0; c < 3; ++c) {
      out[c] = form_.root_control[c * count() + i];
      if (form_.is_rational) out[c] /= form_.root_control[3 * count() + i];
    }
    return out;
  }
  // The lines of control points of a tensor patch along one parameter.
  std::vector<std::vector<Point3d>> lines(std::size_t axis) const {
    const auto rows = static_cast<std::size_t>(form_.shape.p + 1),
               columns = static_cast<std::size_t>(form_.shape.q + 1);
    std::vector<std::vector<Point3d>> out(axis == 0 ? columns : rows);
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t j = 0; j < columns; ++j)
        out[axis == 0 ? j : i].push_back((*this)[i * columns + j]);
    return out;
  }
  // A normal, as long as twice the area between the corners; nearly 0 for a patch that closes on itself.
  Point3d area() const {
    const auto p = static_cast<std::size_t>(form_.shape.p),
               q = static_cast<std::size_t>(form_.shape.q);
    const Point3d first = (*this)[0], last = (*this)[count() - 1];
    if (form_.shape.is_triangle) {
      const Point3d other = (*this)[triangle_index(static_cast<int>(p), 0)];
      return cross(minus(other, first), minus(last, first));
    }
    return cross(minus(last, first), minus((*this)[q], (*this)[p * (q + 1)]));
  }

 private:
  const Form& form_;
};

// The greatest distance of a control point from the chord of its line.
double bend_of(const std::vector<std::vector<Point3d>>& lines) {
  double out = 0;
  for (const std::vector<Point3d>& line : lines) {
    const Point3d chord = minus(line.back(), line.front());
    const double size = length(chord);
    for (const Point3d& p : line) {
      // The length of the cross product: a difference of squares would take rounding for a bend.
      const Point3d d = minus(p, line.front());
      out = std::max(out, size > 0 ? length(cross(d, chord)) / size : length(d));
    }
  }
  return out;
}
// The greatest distance of a line's ends.
double chord_of(const std::vector<std::vector<Point3d>>& lines) {
  double out = 0;
  for (const std::vector<Point3d>& line : lines)
    out = std::max(out, distance(line.front(), line.back()));
  return out;
}
// The greatest length of a line of control points.
double length_of(const std::vector<std::vector<Point3d>>& lines) {
  double out = 0;
  for (const std::vector<Point3d>& line : lines) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) sum += distance(line[i], line[i + 1]);
    out = std::max(out, sum);
  }
  return out;
}

// How far the control points leave a plane through their corners.
double bend_from_plane(const ControlPoints& points) {
  const Point3d normal = points.area();
  const double size = length(normal);
  double least = 0, most = 0, farthest = 0;
  for (std::size_t i = 0; i < points.count(); ++i) {
    const Point3d d = minus(points[i], points[0]);
    const double height = (d[0] * normal[0] + d[1] * normal[1] + d[2] * normal[2]) / size;
    least = std::min(least, height), most = std::max(most, height);
    farthest = std::max(farthest, length(d));
  }
  return size > 0 ? most - least : farthest;
}

// The greatest bend of the patches across the two sides of a patch that run along the axis.
double bend_beside(const PatchComplex& complex, const std::vector<Form>& forms, std::uint32_t patch,
                   std::size_t axis) {
  double out = 0;
  for (const auto side : {static_cast<std::uint32_t>(axis), static_cast<std::uint32_t>(axis + 2)})
    if (const auto mate = complex.mate({patch, side}))
      out = std::max(out, bend_from_plane(ControlPoints(forms[mate->patch])));
  return out;
}

}  // namespace

void choose_square_roots(Form* form) {
  if (form->shape.is_triangle) return;
  const ControlPoints points(*form);
  const double ratio = length_of(points.lines(0)) / length_of(points.lines(1));
  if (!(ratio > 0) || !std::isfinite(ratio)) return;
  const int bits =
      std::min(kMaxRootBits, std::abs(static_cast<int>(std::lround(std::log2(ratio)))));
  form->root_bits[ratio > 1 ? 0 : 1] = static_cast<std::uint8_t>(bits);
}

void choose_straight_roots(const PatchComplex& complex, std::vector<Form>* forms) {
  const int most = most_rim_bits(forms->size());
  for (std::uint32_t p = 0; p < forms->size(); ++p) {
    Form& form = (*forms)[p];
    if (form.shape.is_triangle) continue;
    const ControlPoints points(form);
    const std::array lines{points.lines(0), points.lines(1)};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double bend =
          std::max(bend_of(lines[axis]), kBesideStraight * bend_beside(complex, *forms, p, axis));
      const double ratio = bend / chord_of(lines[1 - axis]);
      if (!(ratio > 1) || !std::isfinite(ratio)) continue;
      // A half bends by a quarter.
      const int bits = static_cast<int>(std::ceil(0.5 * std::log2(ratio)));
      form.root_bits[axis] = static_cast<std::uint8_t>(std::min(most, bits));
    }
  }
}

}  // namespace veritope::internal
