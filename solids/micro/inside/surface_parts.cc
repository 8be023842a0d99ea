// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/inside/surface_parts_internal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <unordered_map>
#include <utility>

#include "interval/box_geometry.h"
#include "interval/upward.h"
#include "solids/classify/patch_cuts.h"
#include "solids/classify/triangle_bound.h"
#include "solids/micro/surface/node_points.h"

namespace veritope::internal {
namespace {

// Parts of patches that are cut in advance.
constexpr std::size_t kSharedParts = 4096;

Point3d difference_of(const Point3d& a, const Point3d& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Point3d approx_normal(const Point3d& a, const Point3d& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// A lower bound of the distance between the points and the hull of the corners, grown by the excess, from the planes
// across a direction, either way. 0 if they do not part them.
template <std::size_t N>
double gap_along(const Point3d& d, const NodePoints& points, const std::array<Box3, N>& corners,
                 const Point3d& excess) {
  if (!std::isfinite(d[0] + d[1] + d[2])) return 0;
  double least = HUGE_VAL, most = -HUGE_VAL;
  const auto &x = points.middles[0], &y = points.middles[1], &z = points.middles[2];
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double at = d[0] * x[i] + d[1] * y[i] + d[2] * z[i];
    least = std::min(least, at);
    most = std::max(most, at);
  }
  const Box3 n{Interval(d[0]), Interval(d[1]), Interval(d[2])};
  const Interval length = norm(n);
  if (!(length.lo() > 0)) return 0;
  Interval grown;
  for (std::size_t c = 0; c < 3; ++c) grown += Interval(std::abs(d[c])) * Interval(excess[c]);
  double lo = HUGE_VAL, hi = -HUGE_VAL;
  for (const Box3& p : corners) {
    const Interval at = dot(n, p);
    lo = std::min(lo, at.lo());
    hi = std::max(hi, at.hi());
  }
  const double slack = dot_slack(d, points);
  if (!std::isfinite(slack) || !std::isfinite(least) || !std::isfinite(most) ||
      !std::isfinite(lo) || !std::isfinite(hi))
    return 0;
  const Interval off = grown + Interval(slack), above = Interval(least) - Interval(hi) - off,
                 below = Interval(lo) - Interval(most) - off;
  const double best = std::max(above.lo(), below.lo());
  return best > 0 ? (Interval(best) / length).lo() : 0;
}

Box3 exact_point(const Vec3d& p) { return Box3(Interval(p.x), Interval(p.y), Interval(p.z)); }

class MeshParts;
class MeshView final : public DistanceView {
 public:
  explicit MeshView(const MeshParts& parts) : parts_(parts) {}
  const Box3d& box(std::uint32_t part) const override;
  double gap(std::uint32_t part, const NodePoints& points, double enough) const override;
  double reach(std::uint32_t part, const Box3& point) const override;
  std::uint32_t halves(std::uint32_t) override { return kNoHalves; }

 private:
  const MeshParts& parts_;
};

class MeshParts final : public DistanceParts {
 public:
  explicit MeshParts(const TriangleMesh& mesh) : mesh_(mesh) {
    std::vector<Box3d> boxes;
    boxes.reserve(mesh.faces.size());
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
      Box3d box = empty_box();
      for (const Vec3d& p : corners(f)) add(to_point(p), &box);
      boxes.push_back(box);
    }
    set_boxes(std::move(boxes));
  }
  std::unique_ptr<DistanceView> view() const override { return std::make_unique<MeshView>(*this); }

  std::array<Vec3d, 3> corners(std::uint32_t facet) const {
    const auto& t = mesh_.faces[facet];
    return {mesh_.positions[t[0]], mesh_.positions[t[1]], mesh_.positions[t[2]]};
  }
  const Box3d& box(std::uint32_t facet) const { return box_of_shared(facet); }

 private:
  const TriangleMesh& mesh_;
};

const Box3d& MeshView::box(std::uint32_t part) const { return parts_.box(part); }

// Directions: the axes, the triangle's normal, and that from the triangle to the middle of the points.
double MeshView::gap(std::uint32_t part, const NodePoints& points, double enough) const {
  double best = least_distance(parts_.box(part), points.box);
  if (best >= enough) return best;
  const std::array<Vec3d, 3> t = parts_.corners(part);
  const std::array<Box3, 3> corners = {exact_point(t[0]), exact_point(t[1]), exact_point(t[2])};
  const Point3d a = to_point(t[0]), b = difference_of(to_point(t[1]), a),
                c = difference_of(to_point(t[2]), a), middle = approx_centre(points.box);
  best = std::max(best, gap_along(approx_normal(b, c), points, corners, {}));
  if (best >= enough) return best;
  const std::array<double, 2> weights = near_weights(middle, t);
  Point3d to_middle = difference_of(middle, a);
  for (std::size_t k = 0; k < 3; ++k) to_middle[k] -= weights[0] * b[k] + weights[1] * c[k];
  return std::max(best, gap_along(to_middle, points, corners, {}));
}

double MeshView::reach(std::uint32_t part, const Box3& point) const {
  return distance_bound(point, parts_.corners(part));
}

class PatchParts;
class PatchView final : public DistanceView {
 public:
  explicit PatchView(const PatchParts& parts) : parts_(parts) {}
  const Box3d& box(std::uint32_t part) const override { return piece(part).box(); }
  double gap(std::uint32_t part, const NodePoints& points, double enough) const override;
  double reach(std::uint32_t part, const Box3& point) const override;
  std::uint32_t halves(std::uint32_t part) override;

 private:
  const PatchPiece& piece(std::uint32_t part) const;

  const PatchParts& parts_;
  std::deque<PatchPiece> own_;
  std::unordered_map<std::uint32_t, std::uint32_t> halves_of_;  // the first one
};

class PatchParts final : public DistanceParts {
 public:
  explicit PatchParts(const PatchComplex& complex) {
    const ScopedUpward upward;
    pieces_ = pieces_of(complex, kSharedParts);
    std::vector<Box3d> boxes;
    for (const PatchPiece& piece : pieces_) boxes.push_back(piece.box());
    set_boxes(std::move(boxes));
  }
  std::unique_ptr<DistanceView> view() const override { return std::make_unique<PatchView>(*this); }
  const std::vector<PatchPiece>& pieces() const { return pieces_; }

 private:
  std::vector<PatchPiece> pieces_;
};

const PatchPiece& PatchView::piece(std::uint32_t part) const {
  const auto& shared = parts_.pieces();
  return part < shared.size() ? shared[part] : own_[part - shared.size()];
}

double PatchView::gap(std::uint32_t part, const NodePoints& points, double enough) const {
  const PatchPiece& p = piece(part);
  double best = least_distance(p.box(), points.box);
  if (best >= enough) return best;
  std::array<Point3d, 4> corner;
  for (std::size_t i = 0; i < 4; ++i) corner[i] = approx_middle(p.corners()[i]);
  const Point3d normal =
      approx_normal(difference_of(corner[3], corner[0]), difference_of(corner[2], corner[1]));
  Point3d to_middle = approx_centre(points.box);
  for (std::size_t c = 0; c < 3; ++c)
    to_middle[c] -= 0.25 * (corner[0][c] + corner[1][c] + corner[2][c] + corner[3][c]);
  best = std::max(best, gap_along(normal, points, p.corners(), p.excess()));
  if (best >= enough) return best;
  return std::max(best, gap_along(to_middle, points, p.corners(), p.excess()));
}

// The corners are points of the part.
double PatchView::reach(std::uint32_t part, const Box3& point) const {
  double best = HUGE_VAL;
  for (const Box3& corner : piece(part).corners()) best = std::min(best, norm(point - corner).hi());
  return best;
}

std::uint32_t PatchView::halves(std::uint32_t part) {
  if (const auto known = halves_of_.find(part); known != halves_of_.end()) return known->second;
  if (!piece(part).can_halve()) return kNoHalves;
  auto [low, high] = piece(part).halves(piece(part).longer_axis());
  const auto first = static_cast<std::uint32_t>(parts_.pieces().size() + own_.size());
  own_.push_back(std::move(low));
  own_.push_back(std::move(high));
  halves_of_.emplace(part, first);
  return first;
}

}  // namespace

double least_distance(const Box3d& a, const Box3d& b) {
  Interval sum;
  for (std::size_t c = 0; c < 3; ++c) {
    const double gap = std::max({(Interval(a.lo[c]) - Interval(b.hi[c])).lo(),
                                 (Interval(b.lo[c]) - Interval(a.hi[c])).lo(), 0.0});
    sum += sqr(Interval(gap));
  }
  return sqrt(sum).lo();
}

std::unique_ptr<const DistanceParts> DistanceParts::of(const TriangleMesh& mesh) {
  return std::make_unique<const MeshParts>(mesh);
}
std::unique_ptr<const DistanceParts> DistanceParts::of(const PatchComplex& complex) {
  return std::make_unique<const PatchParts>(complex);
}

}  // namespace veritope::internal
