// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/inside/inside_solid_internal.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "interval/box_geometry.h"
#include "interval/upward.h"
#include "robust/base/check.h"
#include "solids/classify/mesh_classifier.h"
#include "solids/classify/patch_classifier.h"
#include "solids/micro/surface/patch_surface.h"
#include "solids/micro/surface/triangle_surface.h"

namespace veritope::internal {

namespace {

// Levels of the octree in which points are looked up: few points are asked for.
constexpr int kLookupLevels = 6;

// The spot between points of which two differences span its plane.
SurfaceSpot spot_at(const Point3d& at, const Point3d& u, const Point3d& v) {
  const Point3d n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  return {at, {n[0] / length, n[1] / length, n[2] / length}, std::sqrt(length)};
}
Point3d between(const Point3d& a, const Point3d& b) {
  return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
}

class MeshSolid final : public InsideSolid {
 public:
  MeshSolid(const InsideModel& model, MeshClassifier classifier)
      : surface_(*model.mesh), classifier_(std::move(classifier)), depths_(model.shells.depth) {
    facets_.resize(depths_.size());
    for (std::uint32_t f = 0; f < model.mesh->faces.size(); ++f)
      facets_[model.shells.shell_of_face[f]].push_back(f);
  }

  const SolidSurface& surface() const override { return surface_; }
  Value3 value(const Box3d& box) const override { return classifier_.value(box); }
  PointAnswer classify(const ExactPoint& point) const override {
    return classifier_.classify(point);
  }
  const std::vector<std::uint32_t>& depths() const override { return depths_; }
  std::uint32_t first_source(std::uint32_t shell) const override { return facets_[shell].front(); }
  Box3d box_of_shell(std::uint32_t shell) const override {
    Box3d out = empty_box();
    for (const std::uint32_t f : facets_[shell]) out = hull(out, surface_.box(f));
    return out;
  }
  std::vector<SurfaceSpot> spots(std::uint32_t shell, std::size_t most) const override {
    const auto& facets = facets_[shell];
    std::vector<SurfaceSpot> out;
    for (std::size_t i = 0; i < facets.size(); i += facets.size() / most + 1) {
      std::array<Point3d, 3> p;
      for (std::size_t k = 0; k < 3; ++k) p[k] = to_point(surface_.corners(facets[i])[k]);
      Point3d middle;
      for (std::size_t c = 0; c < 3; ++c) middle[c] = (p[0][c] + p[1][c] + p[2][c]) / 3;
      out.push_back(spot_at(middle, between(p[0], p[1]), between(p[0], p[2])));
    }
    return out;
  }
  std::string name(std::uint32_t source) const override {
    return "triangle " + std::to_string(source);
  }
  const char* sources() const override { return "triangles"; }

 private:
  TriangleSurface surface_;
  MeshClassifier classifier_;
  std::vector<std::uint32_t> depths_;
  std::vector<std::vector<std::uint32_t>> facets_;  // by shells
};

class PatchSolid final : public InsideSolid {
 public:
  explicit PatchSolid(const PatchComplex& complex)
      : complex_(complex),
        surface_(complex),
        classifier_(PatchClassifier::make(complex, true, kLookupLevels)),
        depths_(classifier_.depths()) {
    nodes_.resize(complex.shells().size());
    const auto& nodes = surface_.nodes();
    for (std::uint32_t n = 0; n < nodes.size(); ++n)
      nodes_[complex.shell(nodes[n].piece().patch())].push_back(n);
  }

  const SolidSurface& surface() const override { return surface_; }
  Value3 value(const Box3d& box) const override { return classifier_.value(box); }
  PointAnswer classify(const ExactPoint& point) const override {
    return classifier_.classify(point);
  }
  const std::vector<std::uint32_t>& depths() const override { return depths_; }
  std::uint32_t first_source(std::uint32_t shell) const override {
    return complex_.shells()[shell].first_patch;
  }
  Box3d box_of_shell(std::uint32_t shell) const override {
    Box3d out = empty_box();
    for (const std::uint32_t n : nodes_[shell]) out = hull(out, surface_.nodes()[n].points().box);
    return out;
  }
  std::vector<SurfaceSpot> spots(std::uint32_t shell, std::size_t most) const override {
    const auto& nodes = nodes_[shell];
    std::vector<SurfaceSpot> out;
    for (std::size_t i = 0; i < nodes.size(); i += nodes.size() / most + 1) {
      std::array<Point3d, 4> p;
      for (std::size_t k = 0; k < 4; ++k)
        p[k] = approx_middle(surface_.nodes()[nodes[i]].piece().corners()[k]);
      out.push_back(spot_at(p[0], between(p[0], p[3]), between(p[1], p[2])));
      const double reach = out.back().size * 0x1p-10;  // a node may be bent
      for (std::size_t c = 0; c < 3; ++c) out.back().at[c] += reach * out.back().normal[c];
    }
    return out;
  }
  std::string name(std::uint32_t source) const override {
    return to_string(complex_.patch(source).origin());
  }
  const char* sources() const override { return "patches of the model"; }

 private:
  const PatchComplex& complex_;
  PatchSurface surface_;
  PatchClassifier classifier_;
  std::vector<std::uint32_t> depths_;
  std::vector<std::vector<std::uint32_t>> nodes_;  // by shells
};

}  // namespace

std::unique_ptr<const InsideSolid> inside_solid(const InsideModel& model) {
  Result<MeshClassifier> classifier =
      MeshClassifier::make(*model.mesh, &model.shells, LookupDetail::kForBoxes);
  VT_CHECK(classifier.has_value(), "the mesh of a solid is closed");
  return std::make_unique<const MeshSolid>(model, std::move(*classifier));
}
std::unique_ptr<const InsideSolid> inside_solid(const PatchComplex& complex) {
  return std::make_unique<const PatchSolid>(complex);
}

}  // namespace veritope::internal
