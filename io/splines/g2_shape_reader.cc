// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/g2_shape_reader.h"

#include <utility>

namespace veritope {
namespace {

constexpr const char* kAngles = "its parameters are angles, which no rational spline has";

/// The square root if it is rational.
std::optional<Rational> rational_root(const Rational& square) {
  const auto root = [](const Integer& n, Integer& out) {
    if (n.sign() == Sign::kNegative) return false;
    out = floor_sqrt(n);
    return out * out == n;
  };
  Integer p, q;
  if (!root(square.numerator(), p) || !root(square.denominator(), q)) return std::nullopt;
  return Rational(p, q);
}

Rational dot(const std::vector<Rational>& a, const std::vector<Rational>& b) {
  Rational sum;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

bool normalise(std::vector<Rational>& v) {
  const auto length = rational_root(dot(v, v));
  if (!length || length->sign() == Sign::kZero) return false;
  for (Rational& x : v) x /= *length;
  return true;
}

}  // namespace

const char* g2_class_name(std::int64_t type) {
  switch (type) {
    case kLine: return "line";
    case kCircle: return "circle";
    case kEllipse: return "ellipse";
    case kBoundedCurve: return "bounded curve";
    case kHyperbola: return "hyperbola";
    case kParabola: return "parabola";
    case kPlane: return "plane";
    case kCylinder: return "cylinder";
    case kLinearExtrusion: return "linear extrusion";
    case kSphere: return "sphere";
    case kCone: return "cone";
    case kTorus: return "torus";
    case kRevolution: return "surface of revolution";
    case kDisc: return "disc";
    default: return "shape";
  }
}

bool G2ShapeReader::read_numbers(std::uint64_t count, Numbers& into) {
  if (!check_announced(count, "numbers")) return false;
  into.resize(count);
  return read_all(into);
}

bool G2ShapeReader::read_dimension(std::uint64_t& dimension) {
  return read_count("a dimension", 1, 1000, dimension);
}

// Reads a flag: 0 or 1, plus 10 if a parameter domain follows.
bool G2ShapeReader::read_flag(const char* what, bool& flag, bool& has_domain) {
  skip();
  const char* const at = p_;
  std::int64_t value = 0;
  if (!read_integer(what, value)) return false;
  if (value != 0 && value != 1 && value != 10 && value != 11)
    return fail(at, Code::kSyntax,
                std::string(what) + " must be 0, 1, 10 or 11, not " + std::to_string(value));
  flag = value % 10 == 1;
  has_domain = value >= 10;
  return true;
}

template <std::size_t N>
bool G2ShapeReader::read_spline(std::optional<BSpline<Rational, N>>& spline) {
  skip();
  const char* const at = p_;
  std::uint64_t dimension = 0, is_rational = 0, total = 0;
  if (!read_dimension(dimension) || !read_count("the rational flag", 0, 1, is_rational))
    return false;
  RawSpline<N> raw;
  raw.is_rational = is_rational == 1;
  raw.num_components = static_cast<int>(dimension + is_rational);
  for (std::size_t a = 0; a < N; ++a) {
    std::uint64_t order = 0;
    skip();
    const char* const basis = p_;
    if (!read_count("a number of control points", 1, std::uint64_t{1} << 40, raw.num_control[a]) ||
        !read_count("an order", 1, std::uint64_t{1} << 40, order))
      return false;
    if (order > raw.num_control[a])
      return fail(basis, Code::kBadSpline,
                  "the order " + std::to_string(order) +
                      " is larger than the number of control points, " +
                      std::to_string(raw.num_control[a]));
    if (order > kMaxSplineDegree + 1)
      return fail(basis, Code::kOverLimit,
                  "the degree " + std::to_string(order - 1) + " is over the limit " +
                      std::to_string(kMaxSplineDegree));
    raw.degrees[a] = static_cast<int>(order) - 1;
    if (!read_numbers(raw.num_control[a] + order, raw.knots[a])) return false;
  }
  if (!check_grid(raw.num_control, static_cast<std::uint64_t>(raw.num_components), total) ||
      !read_numbers(total, raw.points))
    return false;
  spline = build(at, std::move(raw));
  return spline.has_value();
}

// Reads dim, scalars, vectors, scalars; then the bounds.
bool G2ShapeReader::read_elementary(std::uint64_t scalars_first, std::uint64_t vectors,
                                    bool is_bounded_flag, std::uint64_t scalars_last) {
  std::uint64_t dimension = 0;
  Numbers ignored;
  if (!read_dimension(dimension) ||
      !read_numbers(scalars_first + vectors * dimension + scalars_last, ignored))
    return false;
  bool flag = false, has_domain = false;
  if (is_bounded_flag) {
    if (!read_flag("the bounded flag", flag, has_domain)) return false;
    const std::uint64_t bounds = flag ? 4 : 2;  // false: unbounded in the second parameter only
    return read_numbers(has_domain ? 2 * bounds : bounds, ignored) &&
           read_flag("the swapped flag", flag, has_domain);
  }
  return read_numbers(4, ignored) && read_flag("the swapped flag", flag, has_domain) &&
         (!has_domain || read_numbers(4, ignored));
}

bool G2ShapeReader::read_line(G2Shape<ExactCurve>& shape) {
  std::uint64_t dimension = 0;
  Numbers place, direction, bounds, domain;
  bool is_bounded = false, has_domain = false, is_reversed = false, unused = false;
  skip();
  const char* const at = p_;
  if (!read_dimension(dimension) || !read_numbers(dimension, place) ||
      !read_numbers(dimension, direction) ||
      !read_flag("the bounded flag", is_bounded, has_domain) ||
      (is_bounded && !read_numbers(2, bounds)) || (has_domain && !read_numbers(2, domain)) ||
      !read_flag("the reversed flag", is_reversed, unused))
    return false;
  if (!is_bounded) {
    shape.reason = "it is unbounded";
    return true;
  }
  if (!has_domain) domain = bounds;
  RawSpline<1> raw;
  raw.num_control = {2};
  raw.degrees = {1};
  raw.knots[0] = {domain[0], domain[0], domain[1], domain[1]};
  raw.num_components = static_cast<int>(dimension);
  if (is_reversed) std::swap(bounds[0], bounds[1]);
  for (const Rational& t : bounds)
    for (std::size_t c = 0; c < dimension; ++c) {
      raw.points.push_back(place[c] + t * direction[c]);
      if (!charge(at, raw.points.back())) return false;
    }
  shape.spline = build(at, std::move(raw));
  return shape.spline.has_value();
}

bool G2ShapeReader::read_curve(std::int64_t type, G2Shape<ExactCurve>& shape) {
  Numbers ignored;
  bool flag = false, has_domain = false;
  std::uint64_t dimension = 0;
  switch (type) {
    case 1:  // in old files
    case kSplineCurve: return read_spline(shape.spline);
    case kLine: return read_line(shape);
    case kCircle:
    case kEllipse:
      shape.reason = kAngles;
      return read_dimension(dimension) &&
             read_numbers((type == kCircle ? 1 : 2) + 3 * dimension + 2, ignored) &&
             read_flag("the reversed flag", flag, has_domain) &&
             (!has_domain || read_numbers(2, ignored));
    case kHyperbola:
    case kParabola:
      shape.reason = "its axes are normalised";
      if (!read_dimension(dimension) ||
          !read_numbers((type == kParabola ? 1 : 2) + 3 * dimension, ignored) ||
          !read_flag("the bounded flag", flag, has_domain) ||
          !read_numbers((flag ? 2u : 0u) + (has_domain ? 2u : 0u), ignored))
        return false;
      return read_flag("the reversed flag", flag, has_domain);
    default:
      return fail(p_, Code::kSyntax,
                  "curves of class " + std::to_string(type) + " are not known here");
  }
}

bool G2ShapeReader::read_plane(G2Shape<ExactSurface>& shape) {
  std::uint64_t dimension = 0;
  Numbers place, normal, x, bounds, domain;
  bool is_bounded = false, has_domain = false, is_swapped = false, unused = false;
  skip();
  const char* const at = p_;
  if (!read_dimension(dimension)) return false;
  if (dimension != 3) return fail(at, Code::kSyntax, "a plane must have dimension 3");
  if (!read_numbers(3, place) || !read_numbers(3, normal) || !read_numbers(3, x) ||
      !read_flag("the bounded flag", is_bounded, has_domain) ||
      (is_bounded && (!read_numbers(4, bounds) || (has_domain && !read_numbers(4, domain)))) ||
      !read_flag("the swapped flag", is_swapped, unused))
    return false;
  if (!is_bounded) {
    shape.reason = "it is unbounded";
    return true;
  }
  if (!has_domain) domain = bounds;
  const Rational along = dot(x, normal);
  for (std::size_t c = 0; c < 3; ++c) x[c] -= along * normal[c];
  Numbers y = {normal[1] * x[2] - normal[2] * x[1], normal[2] * x[0] - normal[0] * x[2],
               normal[0] * x[1] - normal[1] * x[0]};
  if (!normalise(x) || !normalise(y)) {
    shape.reason = "its axes are normalised by an irrational square root";
    return true;
  }
  RawSpline<2> raw;
  raw.num_control = {2, 2};
  raw.degrees = {1, 1};
  raw.num_components = 3;
  for (std::size_t a = 0; a < 2; ++a)
    raw.knots[a] = {domain[2 * a], domain[2 * a], domain[2 * a + 1], domain[2 * a + 1]};
  if (is_swapped) std::swap(raw.knots[0], raw.knots[1]);
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t c = 0; c < 3; ++c)
        raw.points.push_back(place[c] + bounds[is_swapped ? j : i] * x[c] +
                             bounds[2 + (is_swapped ? i : j)] * y[c]);
  for (const Rational& number : raw.points)
    if (!charge(at, number)) return false;
  shape.spline = build(at, std::move(raw));
  return shape.spline.has_value();
}

bool G2ShapeReader::read_extrusion(G2Shape<ExactSurface>& shape) {
  std::uint64_t dimension = 0;
  std::optional<ExactCurve> curve;
  Numbers axis, bounds;
  bool is_bounded = false, is_swapped = false, unused = false;
  skip();
  const char* const at = p_;
  if (!read_dimension(dimension) || !read_spline(curve) || !read_numbers(dimension, axis) ||
      !read_flag("the bounded flag", is_bounded, unused) ||
      !read_numbers(is_bounded ? 4 : 2, bounds) ||
      !read_flag("the swapped flag", is_swapped, unused))
    return false;
  if (static_cast<std::uint64_t>(curve->dimension()) != dimension)
    return fail(at, Code::kBadSpline, "the curve of an extrusion has another dimension");
  const auto& knots = curve->axis(0);
  if (!is_bounded) {
    shape.reason = "it is unbounded";
  } else if (bounds[0] != knots.domain_begin() || bounds[1] != knots.domain_end()) {
    shape.reason = "it is bounded to a part of its curve";
  }
  if (!shape.reason.empty()) return true;
  const std::size_t n = knots.num_control();
  RawSpline<2> raw;
  const std::size_t u = is_swapped ? 1 : 0, v = 1 - u;
  raw.num_control[u] = n;
  raw.num_control[v] = 2;
  raw.degrees[u] = knots.degree;
  raw.degrees[v] = 1;
  raw.knots[u] = knots.knots;
  raw.knots[v] = {bounds[2], bounds[2], bounds[3], bounds[3]};
  raw.num_components = curve->num_components();
  raw.is_rational = curve->is_rational();
  const Rational unit(1);
  for (std::size_t k = 0; k < 2 * n; ++k) {
    const std::size_t i = is_swapped ? k / 2 : k % n, j = is_swapped ? k % 2 : k / n;
    const Rational& w = raw.is_rational ? curve->component(raw.num_components - 1)[i] : unit;
    for (int c = 0; c < raw.num_components; ++c) {
      Rational x = curve->component(c)[i];
      if (c < curve->dimension()) x += w * bounds[2 + j] * axis[static_cast<std::size_t>(c)];
      if (!charge(at, x)) return false;
      raw.points.push_back(std::move(x));
    }
  }
  shape.spline = build(at, std::move(raw));
  return shape.spline.has_value();
}

bool G2ShapeReader::read_surface(std::int64_t type, G2Shape<ExactSurface>& shape) {
  Numbers ignored;
  std::optional<ExactCurve> curve;
  std::uint64_t dimension = 0;
  bool flag = false, unused = false;
  switch (type) {
    case kSplineSurface: return read_spline(shape.spline);
    case kPlane: return read_plane(shape);
    case kLinearExtrusion: return read_extrusion(shape);
    case kCylinder: shape.reason = kAngles; return read_elementary(1, 3, true, 0);
    case kCone: shape.reason = kAngles; return read_elementary(1, 3, true, 1);
    case kSphere: shape.reason = kAngles; return read_elementary(1, 3, false, 0);
    case kTorus: shape.reason = kAngles; return read_elementary(2, 3, false, 1);
    case kDisc: shape.reason = kAngles; return read_elementary(1, 3, false, 5);
    case kRevolution:
      shape.reason = kAngles;
      return read_dimension(dimension) && read_numbers(2 * dimension, ignored) &&
             read_spline(curve) && read_numbers(2, ignored) &&
             read_flag("the swapped flag", flag, unused);
    default:
      return fail(p_, Code::kSyntax,
                  "surfaces of class " + std::to_string(type) + " are not known here");
  }
}

template bool G2ShapeReader::read_spline(std::optional<ExactVolume>&);

}  // namespace veritope
