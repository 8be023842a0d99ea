// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/bridge/skin_projection_internal.h"

#include <array>
#include <utility>

#include "interval/box_geometry.h"
#include "solids/classify/mesh_projection.h"
#include "solids/classify/patch_classifier.h"
#include "solids/classify/patch_projection.h"
#include "solids/micro/bridge/plain_vectors_internal.h"

namespace veritope::internal {
namespace {

// Parts that may be examined for one point. Where a whole curve is nearest the middle of one place does.
constexpr std::size_t kMostProjectedParts = 2000;
// Levels of the octree in which points are looked up.
constexpr int kSideLevels = 6;

// The direction of `way`, or the opposite one if it points inward.
Point3d outward(const Point3d& way, bool is_way_outward) {
  Point3d out = unit_vector(way);
  if (!is_way_outward)
    for (double& x : out) x = -x;
  return out;
}

class MeshSkin final : public SkinProjection {
 public:
  explicit MeshSkin(const TriangleMesh& mesh) : mesh_(mesh), projection_(mesh) {}

  SkinPoint project(const Point3d& p) const override {
    const MeshProjectionAnswer answer = projection_.project(exact_point(p));
    const NearestPoint& nearest = answer.nearest.front();
    const auto& face = mesh_.faces[nearest.facet];
    std::array<Point3d, 3> q;
    for (std::size_t i = 0; i < 3; ++i) q[i] = to_point(mesh_.positions[face[i]]);
    SkinPoint out;
    for (std::size_t c = 0; c < 3; ++c) out.at[c] = nearest_double(nearest.point[c]);
    out.normal = unit_vector(cross_product(sum_of(q[1], -1, q[0]), sum_of(q[2], -1, q[0])));
    const Point3d way = sum_of(p, -1, out.at);
    if (nearest.feature == MeshFeature::kFacet || !(size_of(way) > 0)) return out;
    out.normal = outward(way, dot_product(out.normal, way) >= 0);
    return out;
  }
  Interval squared_distance(const ExactPoint& p) const override {
    return enclose(projection_.project(p).squared_distance);
  }

 private:
  const TriangleMesh& mesh_;
  MeshProjection projection_;
};

class PatchSkin final : public SkinProjection {
 public:
  explicit PatchSkin(const PatchComplex& complex)
      : projection_(complex), classifier_(PatchClassifier::of_valid_model(complex, kSideLevels)) {}

  // The line to the nearest point is along the normal there; whether the point is inside tells its direction.
  SkinPoint project(const Point3d& p) const override {
    const ExactPoint exact = exact_point(p);
    const PatchProjectionAnswer answer = projection_.project(exact, kMostProjectedParts);
    SkinPoint out;
    out.at = approx_middle(answer.places.front().point);
    out.normal = outward(sum_of(p, -1, out.at), classifier_.classify(exact).winding == 0);
    return out;
  }
  Interval squared_distance(const ExactPoint& p) const override {
    return projection_.project(p, kMostProjectedParts).squared_distance;
  }

 private:
  PatchProjection projection_;
  PatchClassifier classifier_;
};

}  // namespace

std::unique_ptr<const SkinProjection> skin_projection(const TriangleMesh& mesh) {
  return std::make_unique<const MeshSkin>(mesh);
}
std::unique_ptr<const SkinProjection> skin_projection(const PatchComplex& complex) {
  return std::make_unique<const PatchSkin>(complex);
}

ExactPoint exact_point(const Point3d& p) {
  return {Rational::from_double(p[0]), Rational::from_double(p[1]), Rational::from_double(p[2])};
}

double approx_distance(const SkinProjection& skin, const Point3d& p) {
  return std::sqrt(std::max(0.0, approx_middle(skin.squared_distance(exact_point(p)))));
}
double approx_depth(const SkinProjection& skin, const Point3d& p) {
  const SkinPoint at = skin.project(p);
  return -dot_product(at.normal, sum_of(p, -1, at.at));
}

}  // namespace veritope::internal
