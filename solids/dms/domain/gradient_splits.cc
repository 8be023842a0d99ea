// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/domain/gradient_splits.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "robust/base/check.h"
#include "solids/dms/dms_make.h"
#include "solids/dms/domain/refine_mesh.h"
#include "solids/dms/domain/refine_places.h"
#include "solids/dms/domain/tetrahedra_cover.h"

namespace veritope {
namespace {

using Gradient = std::array<double, 3>;

double square_of(const Gradient& g) { return g[0] * g[0] + g[1] * g[1] + g[2] * g[2]; }

class Splitter {
 public:
  Splitter(const DmsModel& domain, std::span<const ExactPoint3> points,
           std::span<const Gradient> gradients)
      : points_(points),
        gradients_(gradients),
        per_point_(points.empty() ? 0 : gradients.size() / points.size()),
        mesh_(vertices_of(domain), domain.tetrahedra) {
    data_.resize(mesh_.complex().num_slots());
    deviation_.resize(data_.size(), 0);
    const TetrahedraCover cover(mesh_.points(), domain.tetrahedra);
    std::set<std::array<Rational, 3>> vertices;
    for (const ExactPoint3& p : mesh_.points()) vertices.insert(p.at());
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      if (vertices.contains(points[i].at())) continue;
      if (const auto t = cover.find(points[i])) data_[*t].push_back(i);
    }
    for (std::uint32_t t = 0; t < data_.size(); ++t) measure(t);
  }

  std::size_t run(double threshold, std::size_t most, std::size_t max_tetrahedra) {
    const double least = threshold * *std::max_element(deviation_.begin(), deviation_.end());
    std::size_t inserted = 0;
    while (inserted < most) {
      const auto worst = std::max_element(deviation_.begin(), deviation_.end());
      if (!(*worst > 0) || *worst < least) break;
      const auto t = static_cast<std::uint32_t>(worst - deviation_.begin());
      const std::optional<RefineCavity> cavity = cavity_in(t);
      if (!cavity) {
        *worst = 0;  // its data are where others became vertices
        continue;
      }
      if (mesh_.complex().num_tetrahedra() - cavity->ball.size() + cavity->shell.size() >
          max_tetrahedra)
        break;
      insert(*cavity);
      ++inserted;
    }
    return inserted;
  }

  DmsModel model() const {
    DmsModel out;
    for (const ExactPoint3& p : mesh_.points()) out.clouds.push_back({p.at()});
    out.tetrahedra = mesh_.tetrahedra();
    set_control_by_rule(out, DmsControlRule::kGreville, {});
    return out;
  }

 private:
  static std::vector<ExactPoint3> vertices_of(const DmsModel& domain) {
    std::vector<ExactPoint3> out;
    for (const DmsCloud& cloud : domain.clouds) out.emplace_back(cloud[0]);
    return out;
  }
  double steepness(std::uint32_t i) const {
    double sum = 0;
    for (std::size_t a = 0; a < per_point_; ++a) sum += square_of(gradients_[i * per_point_ + a]);
    return sum;
  }

  void measure(std::uint32_t t) {
    deviation_[t] = 0;
    const std::vector<std::uint32_t>& data = data_[t];
    if (data.empty()) return;
    double sum = 0;
    for (std::size_t a = 0; a < per_point_; ++a) {
      Gradient mean{};
      for (const std::uint32_t i : data)
        for (std::size_t k = 0; k < 3; ++k)
          mean[k] += gradients_[i * per_point_ + a][k] / static_cast<double>(data.size());
      for (const std::uint32_t i : data) {
        Gradient d = gradients_[i * per_point_ + a];
        for (std::size_t k = 0; k < 3; ++k) d[k] -= mean[k];
        sum += square_of(d);
      }
    }
    const TetrahedronCorners& c = mesh_.complex().corners(t);
    const auto& p = mesh_.points();
    const double volume = approx_volume({&p[c[0]], &p[c[1]], &p[c[2]], &p[c[3]]});
    deviation_[t] = std::sqrt(sum / static_cast<double>(data.size())) * std::cbrt(volume);
    if (!std::isfinite(deviation_[t])) deviation_[t] = 0;
  }

  // The cavity of the steepest datum in the tetrahedron that is no vertex.
  std::optional<RefineCavity> cavity_in(std::uint32_t t) {
    std::vector<std::uint32_t> order = data_[t];
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t i, std::uint32_t j) { return steepness(i) > steepness(j); });
    for (const std::uint32_t i : order) {
      chosen_ = i;
      if (auto cavity = mesh_.find_cavity(points_[i], t)) return cavity;
    }
    return std::nullopt;
  }

  void insert(const RefineCavity& cavity) {
    std::vector<std::uint32_t> data;
    for (const std::uint32_t t : cavity.ball) {
      data.insert(data.end(), data_[t].begin(), data_[t].end());
      data_[t].clear();
      deviation_[t] = 0;
    }
    const std::vector<std::uint32_t> added = mesh_.insert(points_[chosen_], cavity);
    data_.resize(mesh_.complex().num_slots());
    deviation_.resize(data_.size(), 0);
    std::erase(data, chosen_);
    std::sort(data.begin(), data.end());
    for (const std::uint32_t i : data) {
      const auto holds = [&](std::uint32_t t) {
        for (TetrahedronFace f = 4 * t; f < 4 * t + 4; ++f)
          if (mesh_.side(f, points_[i]) == Sign::kNegative) return false;
        return true;
      };
      const auto at = std::find_if(added.begin(), added.end(), holds);
      VT_CHECK(at != added.end(), "the cone contains the data of its cavity");
      data_[*at].push_back(i);
    }
    for (const std::uint32_t t : added) measure(t);
  }

  std::span<const ExactPoint3> points_;
  std::span<const Gradient> gradients_;
  std::size_t per_point_;
  RefineMesh mesh_;
  std::vector<std::vector<std::uint32_t>>
      data_;  // for each slot the data in its tetrahedron that are no vertices
  std::vector<double> deviation_;
  std::uint32_t chosen_ = 0;
};

}  // namespace

std::vector<Gradient> approx_gradients(std::span<const ExactPoint3> points,
                                       std::span<const TetrahedronCorners> tetrahedra,
                                       std::span<const double> values) {
  std::vector<Gradient> out(points.size());
  std::vector<double> weight(points.size(), 0);
  for (const TetrahedronCorners& t : tetrahedra) {
    const double volume =
        approx_volume({&points[t[0]], &points[t[1]], &points[t[2]], &points[t[3]]});
    // 6 volume grad = the sum over faces of the value at the opposite corner times the inward normal.
    Gradient sum{};
    for (std::size_t m = 0; m < 4; ++m) {
      const auto& face = kTetrahedronFaces[m];
      const Vec3d &a = points[t[face[0]]].rounded(), &b = points[t[face[1]]].rounded(),
                  &c = points[t[face[2]]].rounded();
      const Vec3d u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
      const double value = values[t[m]];
      sum[0] -= value * (u.y * v.z - u.z * v.y);
      sum[1] -= value * (u.z * v.x - u.x * v.z);
      sum[2] -= value * (u.x * v.y - u.y * v.x);
    }
    if (!(volume > 0)) continue;
    for (const std::uint32_t v : t) {
      weight[v] += volume;
      for (std::size_t k = 0; k < 3; ++k) out[v][k] += sum[k] / 6;
    }
  }
  for (std::size_t i = 0; i < out.size(); ++i)
    for (double& x : out[i]) x = weight[i] > 0 ? x / weight[i] : 0;
  return out;
}

Result<GradientSplits> split_by_gradients(const DmsModel& domain,
                                          std::span<const ExactPoint3> points,
                                          std::span<const Gradient> gradients, double threshold,
                                          std::size_t most, std::size_t max_tetrahedra) {
  if (!has_manifold_boundary(domain.tetrahedra))
    return bad_argument("an edge of the boundary belongs to more than two of its faces");
  Splitter splitter(domain, points, gradients);
  GradientSplits out;
  out.inserted = splitter.run(threshold, most, max_tetrahedra);
  out.model = splitter.model();
  return out;
}

}  // namespace veritope
