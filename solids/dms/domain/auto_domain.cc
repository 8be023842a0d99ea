// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/domain/auto_domain.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>

#include "solids/dms/dms_identity.h"
#include "solids/dms/domain/domain_samples.h"
#include "solids/dms/domain/refine_mesh.h"
#include "solids/dms/domain/refine_places.h"
#include "solids/dms/domain/tetrahedra_cover.h"
#include "solids/tetrahedra/boundary_classes.h"
#include "solids/tetrahedra/delaunay.h"
#include "solids/tetrahedra/occupancy.h"

namespace veritope {
namespace {

const Rational kFeatureCosine(Integer(3), Integer(4));  // squared, of 30 degrees
constexpr double kFilledShare = 0.9;

std::vector<DmsPoint> exact_places(std::span<const ExactPoint3> points) {
  std::vector<DmsPoint> out;
  for (const ExactPoint3& p : points) out.push_back(p.at());
  return out;
}

class AutoBuilder {
 public:
  AutoBuilder(std::span<const ExactPoint3> points, const AutoDomainOptions& options)
      : points_(points), options_(options), places_(exact_places(points)) {
    for (const ExactPoint3& p : points) near_.push_back(p.rounded());
  }

  Result<AutoDomain> run() {
    auto delaunay = delaunay_tetrahedra(points_);
    if (!delaunay) return delaunay.error();
    tetrahedra_ = std::move(delaunay.value().tetrahedra);
    out_.spacing = median_spacing();
    const Result<Occupancy> occupancy = find_occupancy(points_, tetrahedra_);
    if (!occupancy || fills_hull(*occupancy)) return finish_hull();
    for (const std::uint32_t t : occupancy->kept) object_.push_back(tetrahedra_[t]);
    return sample_object();
  }

 private:
  double median_spacing() const {
    const std::vector<std::uint32_t> neighbours = nearest_neighbours(points_, tetrahedra_);
    std::vector<double> distances;
    for (std::uint32_t i = 0; i < neighbours.size(); ++i)
      if (neighbours[i] != i) distances.push_back(approx_distance(near_[i], near_[neighbours[i]]));
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    return *middle;
  }
  double volume(const TetrahedronCorners& t) const {
    return approx_volume({&points_[t[0]], &points_[t[1]], &points_[t[2]], &points_[t[3]]});
  }
  TetrahedralComplex complex_of(const std::vector<TetrahedronCorners>& tetrahedra) const {
    return TetrahedralComplex(tetrahedra, static_cast<std::uint32_t>(points_.size()));
  }

  bool fills_hull(const Occupancy& occupancy) const {
    double all = 0, kept = 0;
    for (const TetrahedronCorners& t : tetrahedra_) all += volume(t);
    std::vector<TetrahedronCorners> object;
    for (const std::uint32_t t : occupancy.kept) {
      kept += volume(tetrahedra_[t]);
      object.push_back(tetrahedra_[t]);
    }
    return kept >= kFilledShare * all && boundary_euler(complex_of(object)) == 2;
  }
  static std::int64_t boundary_euler(const TetrahedralComplex& complex) {
    std::set<std::uint32_t> vertices;
    std::set<VertexPair> edges;
    for (const TetrahedronFace f : complex.boundary()) {
      const auto v = complex.vertices(f);
      vertices.insert(v.begin(), v.end());
      for (std::size_t k = 0; k < 3; ++k) edges.insert(std::minmax(v[k], v[(k + 1) % 3]));
    }
    return static_cast<std::int64_t>(vertices.size()) - static_cast<std::int64_t>(edges.size()) +
           static_cast<std::int64_t>(complex.boundary().size());
  }

  // The corners of the hull; vertices inside of its facets and edges are not needed.
  Result<AutoDomain> finish_hull() {
    std::set<std::uint32_t> corners;
    const TetrahedralComplex complex = complex_of(tetrahedra_);
    for (const TetrahedronFace f : complex.boundary())
      for (const std::uint32_t v : complex.vertices(f)) corners.insert(v);
    const std::vector<std::uint32_t> numbers(corners.begin(), corners.end());
    const auto delaunay = delaunay_of(numbers);
    if (!delaunay) return delaunay.error();
    RefineMesh mesh(std::vector<ExactPoint3>(points_.begin(), points_.end()), *delaunay);
    for (bool goes_on = true; goes_on;) {
      goes_on = false;
      for (const std::uint32_t v : numbers)
        if (mesh.is_corner(v) && mesh.remove_vertex(v)) goes_on = true;
    }
    return finish(AutoDomainKind::kHull, mesh.tetrahedra(), 0);
  }

  // In numbers of points.
  Result<std::vector<TetrahedronCorners>> delaunay_of(
      const std::vector<std::uint32_t>& numbers) const {
    std::vector<ExactPoint3> chosen;
    for (const std::uint32_t v : numbers) chosen.push_back(points_[v]);
    auto made = delaunay_tetrahedra(std::span<const ExactPoint3>(chosen));
    if (!made) return made.error();
    for (TetrahedronCorners& t : made.value().tetrahedra)
      for (std::uint32_t& v : t) v = numbers[v];
    return std::move(made.value().tetrahedra);
  }

  Result<AutoDomain> sample_object() {
    const TetrahedraCover inside(points_, object_);
    std::vector<std::uint32_t> samples = first_samples();
    std::optional<AutoDomain> best;
    for (int round = 1; round <= options_.max_rounds; ++round) {
      const auto kept = tetrahedra_inside(samples, inside);
      if (!kept) return kept.error();
      const std::vector<std::uint32_t> outside = points_outside(*kept);
      out_.rounds = round;
      if (!kept->empty() && (!best || outside.size() < best->outside)) {
        Result<AutoDomain> made = finish(AutoDomainKind::kOccupancy, *kept, outside.size());
        if (!made) return made.error();
        best = std::move(*made);
      }
      if (outside.empty() || !add(outside, samples)) break;
    }
    // Samples that are too sparse for their object: the object itself is a domain, too.
    if (!best) return finish(AutoDomainKind::kOccupancy, object_, points_outside(object_).size());
    return std::move(*best);
  }

  // Corners, feature lines, smooth parts of the boundary, and the inside of the object.
  std::vector<std::uint32_t> first_samples() const {
    const TetrahedralComplex complex = complex_of(object_);
    const auto edges = feature_edges(points_, complex, kFeatureCosine);
    const auto classes = classes_by_features(points_, complex, edges, kFeatureCosine);
    const double h = out_.spacing;
    std::set<std::uint32_t> chosen;
    for (const auto& line : feature_lines(edges, classes)) {
      // Noise makes short lines of edges between points of a smooth part.
      if (line.size() < 4) continue;
      for (const std::uint32_t v : sample_feature_line(near_, line, h / 2, 6 * h)) chosen.insert(v);
    }
    std::vector<std::uint32_t> surface, interior;
    for (std::uint32_t v = 0; v < classes.size(); ++v) {
      if (complex.tetrahedra_at(v).empty()) continue;
      (classes[v] == VertexClass::kInterior ? interior : surface).push_back(v);
    }
    const std::vector<std::uint32_t> lines(chosen.begin(), chosen.end());
    for (const std::uint32_t v : sample_surface(near_, approx_curvatures(near_, complex), surface,
                                                lines, {3 * h, 6 * h, 0.5}))
      chosen.insert(v);
    for (const std::uint32_t v : sample_interior(near_, interior, options_.interior_samples))
      chosen.insert(v);
    return {chosen.begin(), chosen.end()};
  }

  // The Delaunay tetrahedra of samples with their barycentre in the object, with a boundary that is a 2-manifold.
  Result<std::vector<TetrahedronCorners>> tetrahedra_inside(
      const std::vector<std::uint32_t>& samples, const TetrahedraCover& object) const {
    const auto all = delaunay_of(samples);
    if (!all) return all.error();
    std::vector<bool> kept;
    for (const TetrahedronCorners& t : *all) {
      Vec3d centre{0, 0, 0};
      for (const std::uint32_t v : t)
        centre = {centre.x + near_[v].x / 4, centre.y + near_[v].y / 4, centre.z + near_[v].z / 4};
      kept.push_back(object.contains(ExactPoint3(centre)));
    }
    trim_to_manifold(complex_of(*all), order_by_longest_edge(points_, *all), kept);
    std::vector<TetrahedronCorners> out;
    for (std::size_t t = 0; t < all->size(); ++t)
      if (kept[t]) out.push_back((*all)[t]);
    return out;
  }

  std::vector<std::uint32_t> points_outside(const std::vector<TetrahedronCorners>& kept) const {
    std::vector<std::uint32_t> out;
    const TetrahedraCover cover(points_, kept);
    for (std::uint32_t v = 0; v < points_.size(); ++v)
      if (!cover.contains(points_[v])) out.push_back(v);
    return out;
  }

  // Some of the data outside, at least three distances apart; false if there is nothing to add.
  bool add(const std::vector<std::uint32_t>& outside, std::vector<std::uint32_t>& samples) const {
    std::vector<std::uint32_t> candidates;
    for (const std::uint32_t v : outside)
      if (!std::binary_search(samples.begin(), samples.end(), v)) candidates.push_back(v);
    const std::vector<double> flat(points_.size(), 0);
    const auto more =
        sample_surface(near_, flat, candidates, {}, {3 * out_.spacing, 3 * out_.spacing, 1});
    if (more.empty() || samples.size() + more.size() > options_.max_samples) return false;
    samples.insert(samples.end(), more.begin(), more.end());
    std::sort(samples.begin(), samples.end());
    return true;
  }

  Result<AutoDomain> finish(AutoDomainKind kind, const std::vector<TetrahedronCorners>& tetrahedra,
                            std::size_t outside) {
    AutoDomain out = out_;
    Result<DmsModel> model = identity_dms(places_, tetrahedra);
    if (!model) return model.error();
    out.model = std::move(*model);
    out.kind = kind;
    out.samples = out.model.clouds.size();
    out.outside = outside;
    out.data_tetrahedra = tetrahedra_;
    return out;
  }

  std::span<const ExactPoint3> points_;
  const AutoDomainOptions& options_;
  std::vector<DmsPoint> places_;
  std::vector<Vec3d> near_;
  std::vector<TetrahedronCorners> tetrahedra_, object_;
  AutoDomain out_;
};

}  // namespace

const char* auto_domain_name(AutoDomainKind kind) {
  return kind == AutoDomainKind::kHull ? "hull" : "occupancy";
}

Result<AutoDomain> auto_domain(std::span<const ExactPoint3> points,
                               const AutoDomainOptions& options) {
  return AutoBuilder(points, options).run();
}

}  // namespace veritope
