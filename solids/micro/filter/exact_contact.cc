// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "solids/micro/filter/exact_contact_internal.h"
#include "solids/micro/filter/separation_internal.h"
#include "splines/bezier_domain.h"
#include "splines/composition_integer.h"

namespace veritope::internal {

namespace {

ExactPoint exact_of(const Vec3d& p) {
  return {Rational::from_double(p.x), Rational::from_double(p.y), Rational::from_double(p.z)};
}
ExactPoint exact_of(const Point3d& p) { return exact_of(Vec3d{p[0], p[1], p[2]}); }
ExactPoint rounded_difference(const ExactPoint& a, const ExactPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
ExactPoint exact_cross(const ExactPoint& a, const ExactPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational exact_dot(const ExactPoint& a, const ExactPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
bool is_zero_vector(const ExactPoint& a) {
  return a[0].sign() == Sign::kZero && a[1].sign() == Sign::kZero && a[2].sign() == Sign::kZero;
}
Point3d approx_of(const ExactPoint& p) {
  return {nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])};
}

// The half-space normal . x >= offset.
struct ExactHalfSpace {
  ExactPoint normal;
  Rational offset;
  Rational height(const ExactPoint& p) const { return exact_dot(normal, p) - offset; }
};

ExactHalfSpace opposite_of(const ExactHalfSpace& h) {
  return {{-h.normal[0], -h.normal[1], -h.normal[2]}, -h.offset};
}

// The part of a convex polygon in the half-space.
std::vector<ExactPoint> clipped(const std::vector<ExactPoint>& polygon, const ExactHalfSpace& h) {
  std::vector<ExactPoint> out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ExactPoint &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const Rational a = h.height(p), b = h.height(q);
    if (a.sign() != Sign::kNegative) out.push_back(p);
    if (to_int(a.sign()) * to_int(b.sign()) >= 0) continue;
    const Rational t = a / (a - b);
    ExactPoint cut;
    for (std::size_t c = 0; c < 3; ++c) cut[c] = p[c] + t * (q[c] - p[c]);
    out.push_back(cut);
  }
  return out;
}

bool is_on_segment(const ExactPoint& p, const ExactPoint& a, const ExactPoint& b) {
  const ExactPoint u = rounded_difference(b, a), w = rounded_difference(p, a);
  const Rational along = exact_dot(u, w);
  return is_zero_vector(exact_cross(u, w)) && along.sign() != Sign::kNegative &&
         along <= exact_dot(u, u);
}

void find_flatness(const Grid<2>& grid, ExactControl* out) {
  const auto& c = out->corners;
  const ExactPoint n = exact_cross(rounded_difference(c[1], c[0]), rounded_difference(c[2], c[0]));
  for (std::size_t i = 0; i < 4; ++i) {
    const ExactPoint turn = exact_cross(rounded_difference(c[(i + 1) % 4], c[i]),
                                        rounded_difference(c[(i + 2) % 4], c[(i + 1) % 4]));
    if (!is_zero_vector(exact_cross(turn, n)) || exact_dot(turn, n).sign() != Sign::kPositive)
      return;
  }
  const ExactHalfSpace plane{n, exact_dot(n, c[0])};
  for (std::size_t k = 0; k < out->points.size(); ++k) {
    const ExactPoint& p = out->points[k];
    if (plane.height(p).sign() != Sign::kZero) return;
    const auto at = grid.index_of(k);
    const bool is_first[2] = {at[0] == 0, at[1] == 0},
               is_last[2] = {at[0] + 1 == grid.size[0], at[1] + 1 == grid.size[1]};
    if ((is_first[1] && !is_on_segment(p, c[0], c[1])) ||
        (is_last[0] && !is_on_segment(p, c[1], c[2])) ||
        (is_last[1] && !is_on_segment(p, c[3], c[2])) ||
        (is_first[0] && !is_on_segment(p, c[0], c[3])))
      return;
  }
  out->is_flat = true;
  out->normal = n;
}

// Whether each control point of a curve lies on the segment of its ends.
bool is_straight_curve(const ExactControl& control) {
  return std::all_of(control.points.begin(), control.points.end(), [&](const ExactPoint& p) {
    return is_on_segment(p, control.corners[0], control.corners[2]);
  });
}

// The control points of a map into space, or false if a weight is not positive.
template <std::size_t N>
bool add_control_points(const Bezier<Rational, N>& map, ExactControl* out) {
  for (std::size_t k = 0; k < map.grid().count(); ++k) {
    ExactPoint p{map.component(0)[k], map.component(1)[k], map.component(2)[k]};
    if (map.is_rational()) {
      const Rational& w = map.component(3)[k];
      if (w.sign() != Sign::kPositive) return false;
      for (Rational& x : p) x /= w;
    }
    out->approx.push_back(approx_of(p));
    out->points.push_back(std::move(p));
  }
  return true;
}

class FacetSeparator {
 public:
  // If both half-spaces of a border hold the piece, `prefers_reversed` chooses the one against the candidate's
  // direction.
  FacetSeparator(const ExactControl& control, bool prefers_reversed)
      : control_(control), prefers_reversed_(prefers_reversed) {
    Box3d box = empty_box();
    for (const Point3d& p : control.approx) add(p, &box);
    tolerance_ = 0x1p-30 * (box.hi[0] - box.lo[0] + box.hi[1] - box.lo[1] + box.hi[2] - box.lo[2]);
    for (std::size_t c = 0; c < 3; ++c)
      tolerance_ += 0x1p-48 * (std::abs(box.lo[c]) + std::abs(box.hi[c]));
    const auto& c = control.corners;
    for (std::size_t i = 0; i < 4; ++i) edges_.push_back(rounded_difference(c[(i + 1) % 4], c[i]));
    normal_ = exact_cross(rounded_difference(c[2], c[0]), rounded_difference(c[3], c[1]));
  }

  enum class Gap { kNone, kTouching, kApart };
  // Whether a plane separates the piece from the facet, and if only one that touches both does, whose half-space is
  // added to half_spaces(), which hold the piece.
  Gap separate(const FacetCorners& facet) {
    std::array<ExactPoint, 3> q;
    for (std::size_t i = 0; i < 3; ++i) q[i] = exact_of(facet[i]);
    std::array<ExactPoint, 3> sides;
    for (std::size_t i = 0; i < 3; ++i) sides[i] = rounded_difference(q[(i + 1) % 3], q[i]);
    for (const ExactHalfSpace& h : half_spaces_)
      if (std::all_of(q.begin(), q.end(),
                      [&](const ExactPoint& p) { return h.height(p).sign() != Sign::kPositive; }))
        return Gap::kTouching;
    const ExactPoint own = exact_cross(sides[0], sides[1]);
    std::vector<ExactPoint> candidates{own, normal_};
    for (std::size_t c = 0; c < 3; ++c) {
      candidates.emplace_back();
      candidates.back()[c] = Rational(1);
    }
    for (const ExactPoint& e : edges_)
      for (const ExactPoint& s : sides) candidates.push_back(exact_cross(e, s));
    for (const ExactPoint& s : sides) candidates.push_back(exact_cross(own, s));
    for (const ExactPoint& e : edges_) candidates.push_back(exact_cross(normal_, e));
    std::optional<ExactHalfSpace> touching;
    for (const ExactPoint& n : candidates)
      for (const bool is_reversed : {prefers_reversed_, !prefers_reversed_}) {
        const ExactPoint d = is_reversed ? ExactPoint{-n[0], -n[1], -n[2]} : n;
        if (!may_separate(approx_of(d), facet)) continue;
        Rational most = exact_dot(d, q[0]);
        for (std::size_t i = 1; i < 3; ++i) most = std::max(most, exact_dot(d, q[i]));
        Sign least = Sign::kPositive;
        for (const ExactPoint& p : control_.points)
          least = std::min(least, (exact_dot(d, p) - most).sign(),
                           [](Sign a, Sign b) { return to_int(a) < to_int(b); });
        if (least == Sign::kPositive) return Gap::kApart;
        if (least == Sign::kZero && !touching) touching = ExactHalfSpace{d, most};
      }
    if (!touching) return Gap::kNone;
    half_spaces_.push_back(std::move(*touching));
    return Gap::kTouching;
  }
  const std::vector<ExactHalfSpace>& half_spaces() const { return half_spaces_; }
  // Whether the piece lies in the border of a half-space, so that the other side is as good.
  bool has_choice() const {
    return std::any_of(half_spaces_.begin(), half_spaces_.end(), [&](const ExactHalfSpace& h) {
      return std::all_of(control_.points.begin(), control_.points.end(),
                         [&](const ExactPoint& p) { return h.height(p).sign() == Sign::kZero; });
    });
  }

 private:
  // Whether the plane separates them, or nearly so: planes that cut deeply need no rationals.
  bool may_separate(const Point3d& d, const FacetCorners& facet) const {
    const auto along = [&](const Point3d& p) { return d[0] * p[0] + d[1] * p[1] + d[2] * p[2]; };
    double most = -HUGE_VAL, least = HUGE_VAL;
    for (const Vec3d& q : facet) most = std::max(most, along(to_point(q)));
    for (const Point3d& p : control_.approx) least = std::min(least, along(p));
    const double size = std::abs(d[0]) + std::abs(d[1]) + std::abs(d[2]);
    return size > 0 && least >= most - tolerance_ * size;
  }

  const ExactControl& control_;
  const bool prefers_reversed_;
  double tolerance_ = 0;
  std::vector<ExactPoint> edges_;
  ExactPoint normal_;
  std::vector<ExactHalfSpace> half_spaces_;
};

// A point that a flat piece and a facet have in common.
std::optional<ExactPoint> common_point(const ExactControl& flat, const FacetCorners& facet) {
  std::vector<ExactPoint> polygon;
  for (const Vec3d& q : facet) polygon.push_back(exact_of(q));
  const auto& c = flat.corners;
  const ExactHalfSpace plane{flat.normal, exact_dot(flat.normal, c[0])};
  polygon = clipped(clipped(polygon, plane), opposite_of(plane));
  for (std::size_t i = 0; i < 4 && !polygon.empty(); ++i) {
    const ExactPoint n = exact_cross(flat.normal, rounded_difference(c[(i + 1) % 4], c[i]));
    polygon = clipped(polygon, {n, exact_dot(n, c[i])});
  }
  if (polygon.empty()) return std::nullopt;
  return polygon.front();
}

// A point that a segment and a facet have in common.
std::optional<ExactPoint> common_point_of_segment(const ExactControl& straight,
                                                  const FacetCorners& facet) {
  std::vector<ExactPoint> line{straight.corners[0], straight.corners[2]};
  std::array<ExactPoint, 3> q;
  for (std::size_t i = 0; i < 3; ++i) q[i] = exact_of(facet[i]);
  const ExactPoint normal =
      exact_cross(rounded_difference(q[1], q[0]), rounded_difference(q[2], q[0]));
  const ExactHalfSpace plane{normal, exact_dot(normal, q[0])};
  line = clipped(clipped(line, plane), opposite_of(plane));
  for (std::size_t i = 0; i < 3 && !line.empty(); ++i) {
    const ExactPoint n = exact_cross(normal, rounded_difference(q[(i + 1) % 3], q[i]));
    line = clipped(line, {n, exact_dot(n, q[i])});
  }
  if (line.empty()) return std::nullopt;
  return line.front();
}

// A point of all open half-spaces, such that the facets not in `touching` miss the hull of it and the piece.
std::optional<ExactPoint> point_beside(const MeshModel& model, const TilePiece& piece,
                                       const ExactControl& control,
                                       const std::vector<ExactHalfSpace>& half_spaces,
                                       std::span<const std::uint32_t> touching) {
  Point3d direction{};
  for (const ExactHalfSpace& h : half_spaces) {
    const Point3d n = approx_of(h.normal);
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (std::size_t c = 0; c < 3; ++c) direction[c] += n[c] / length;
  }
  const Point3d diagonal = approx_of(rounded_difference(control.corners[2], control.corners[0]));
  const double size = std::abs(diagonal[0]) + std::abs(diagonal[1]) + std::abs(diagonal[2]);
  ExactPoint middle;
  for (std::size_t c = 0; c < 3; ++c)
    for (const ExactPoint& p : control.corners) middle[c] += p[c] / Rational(4);
  for (const int exponent : {-3, -8, -16, -26}) {
    const double step = std::ldexp(size, exponent);
    ExactPoint z = middle;
    for (std::size_t c = 0; c < 3; ++c) {
      if (!std::isfinite(step * direction[c])) return std::nullopt;
      z[c] += Rational::from_double(step * direction[c]);
    }
    // A coordinate with few bits is cheaper, and as good.
    const Point3d rounded = approx_of(z);
    if (!std::isfinite(rounded[0] + rounded[1] + rounded[2])) return std::nullopt;
    if (std::all_of(half_spaces.begin(), half_spaces.end(), [&](const ExactHalfSpace& h) {
          return h.height(exact_of(rounded)).sign() == Sign::kPositive;
        }))
      z = exact_of(rounded);
    if (!std::all_of(half_spaces.begin(), half_spaces.end(), [&](const ExactHalfSpace& h) {
          return h.height(z).sign() == Sign::kPositive;
        }))
      return std::nullopt;
    const GrownHull hull(piece, Box3(enclose(z[0]), enclose(z[1]), enclose(z[2])));
    const std::vector<std::uint32_t> near = model.facets_near(hull.box());
    if (std::all_of(near.begin(), near.end(), [&](std::uint32_t f) {
          return std::binary_search(touching.begin(), touching.end(), f) ||
                 hull.is_apart(model.corners(f));
        }))
      return z;
  }
  return std::nullopt;
}

}  // namespace

std::size_t ExactPatches::num_points(std::uint32_t patch) const {
  std::size_t out = 1;
  for (const int d : composed_degrees(cell_.map->degrees(), tile_.patches()[patch].exact.degrees()))
    out *= static_cast<std::size_t>(d) + 1;
  return out;
}

void ExactPatches::restrict_map() {
  if (map_) return;
  map_ = *cell_.map;
  for (std::size_t a = 0; a < 3; ++a) map_ = restricted(*map_, a, cell_.lo[a], cell_.hi[a]);
  patches_.resize(tile_.patches().size());
}

std::optional<ExactControl> ExactPatches::around(const TilePiece& piece) {
  restrict_map();
  if (!around_) {
    around_.emplace();
    if (!add_control_points(*map_, &*around_)) around_->points.clear();
  }
  if (around_->points.empty()) return std::nullopt;
  ExactControl out = *around_;
  constexpr std::array<std::size_t, 4> kCycle{0, 1, 3, 2};
  for (std::size_t i = 0; i < 4; ++i)
    out.corners[i] = cell_.image(
        tile_, {piece.patch, piece.parameter(0, kCycle[i]), piece.parameter(1, kCycle[i])});
  return out;
}

std::optional<ExactControl> ExactPatches::control(const TilePiece& piece) {
  restrict_map();
  auto& patch = patches_[piece.patch];
  if (!patch) patch = compose_by_integers(*map_, tile_.patches()[piece.patch].exact).value();
  BezierSurface<Rational> part = *patch;
  for (std::size_t a = 0; a < 2; ++a)
    part = restricted(part, a, piece.parameter(a, 0), piece.parameter(a, std::size_t{1} << a));
  ExactControl out;
  if (!add_control_points(part, &out)) return std::nullopt;
  const Grid<2> grid = part.grid();
  const std::size_t m = grid.size[0] - 1, n = grid.size[1] - 1;
  out.corners = {out.points[grid.at({0, 0})], out.points[grid.at({m, 0})],
                 out.points[grid.at({m, n})], out.points[grid.at({0, n})]};
  if (n == 0)
    out.is_straight = is_straight_curve(out);
  else
    find_flatness(grid, &out);
  return out;
}

PieceSide exact_side(const MeshModel& model, const TilePiece& piece, const ExactControl& control,
                     std::span<const std::uint32_t> facets, std::optional<ExactPoint>* contact) {
  PieceSide out;
  std::vector<std::uint32_t> touching;
  for (const bool prefers_reversed : {false, true}) {
    FacetSeparator separator(control, prefers_reversed);
    touching.clear();
    for (const std::uint32_t f : facets) {
      const FacetSeparator::Gap gap = separator.separate(model.corners(f));
      if (gap == FacetSeparator::Gap::kNone) return out;
      if (gap == FacetSeparator::Gap::kTouching) touching.push_back(f);
    }
    out.is_apart = touching.empty();
    out.is_decided = out.is_decided || out.is_apart;
    if (out.is_apart) return out;
    std::sort(touching.begin(), touching.end());
    const std::optional<ExactPoint> z =
        point_beside(model, piece, control, separator.half_spaces(), touching);
    const PointAnswer answer = z ? model.classifier().classify(*z) : PointAnswer{};
    if (z && !answer.is_on()) {
      out.is_decided = true;
      (answer.winding != 0 ? out.is_near_inside : out.is_near_outside) = true;
    }
    if (!separator.has_choice()) break;
  }
  for (std::size_t i = 0; i < 4 && !*contact; ++i)
    if (model.classifier().classify(control.corners[i]).is_on()) *contact = control.corners[i];
  for (std::size_t i = 0; i < touching.size() && control.is_flat && !*contact; ++i)
    *contact = common_point(control, model.corners(touching[i]));
  for (std::size_t i = 0; i < touching.size() && control.is_straight && !*contact; ++i)
    *contact = common_point_of_segment(control, model.corners(touching[i]));
  return out;
}

}  // namespace veritope::internal
