// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/domain/refine_domain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <utility>

#include "solids/dms/dms_make.h"
#include "solids/dms/dms_similarity.h"
#include "solids/dms/domain/refine_mesh.h"
#include "solids/dms/domain/refine_places.h"
#include "solids/dms/domain/short_vertices.h"

namespace veritope {
namespace {

constexpr std::array<std::array<std::size_t, 2>, 6> kEdges{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
constexpr double kLeastPart =
    0.05;  // of a triangle's barycentric coordinates, for a vertex inside of it
// A vertex that is inserted because a tetrahedron is too long makes no edge shorter than this times the shortest one of
// the tetrahedron. So edges do not become shorter and shorter where no vertex helps.
constexpr double kLeastEdge = 1;
// For a tetrahedron that is too large the bound is this times the cube root of the limit.
constexpr double kLeastSize = 0.25;

class Refiner {
 public:
  Refiner(const DmsModel& domain, const RefineLimits& limits)
      : limits_(limits), mesh_(points_of(domain), domain.tetrahedra) {
    if (limits.max_volume) volume_ = nearest_double(*limits.max_volume);
    if (limits.max_radius_edge) ratio_ = nearest_double(*limits.max_radius_edge);
  }

  RefinedDomain run() {
    remove_vertices();
    if (limits_.max_radius_edge) small_.emplace(mesh_);
    for (std::uint32_t t = 0; t < mesh_.complex().num_slots(); ++t)
      if (mesh_.complex().is_used(t)) note(t);
    while (!queue_.empty()) {
      const Bad bad = queue_.top();
      queue_.pop();
      if (!is_current(bad)) continue;
      if (added_ >= limits_.max_points) {
        end_ = RefineEnd::kBudget;
        break;
      }
      if (!improve(bad.tetrahedron)) {
        end_ = RefineEnd::kStuck;
      } else if (is_current(bad)) {
        queue_.push(bad);
      }
    }
    return finish();
  }

 private:
  struct Bad {
    bool is_large = false;
    double excess = 0;
    std::uint32_t tetrahedron = 0, stamp = 0;
    friend bool operator<(const Bad& a, const Bad& b) {
      if (a.is_large != b.is_large) return b.is_large;
      return a.excess != b.excess ? a.excess < b.excess : a.tetrahedron > b.tetrahedron;
    }
  };

  static std::vector<ExactPoint3> points_of(const DmsModel& domain) {
    std::vector<ExactPoint3> out;
    for (const DmsCloud& cloud : domain.clouds) out.emplace_back(cloud[0]);
    return out;
  }
  const Vec3d& at(std::uint32_t v) const { return mesh_.points()[v].rounded(); }
  std::array<Vec3d, 4> places(std::uint32_t t) const {
    const TetrahedronCorners& c = mesh_.complex().corners(t);
    return {at(c[0]), at(c[1]), at(c[2]), at(c[3])};
  }
  std::array<const ExactPoint3*, 4> exact(std::uint32_t t) const {
    std::array<const ExactPoint3*, 4> out{};
    for (std::size_t m = 0; m < 4; ++m) out[m] = &mesh_.points()[mesh_.complex().corners(t)[m]];
    return out;
  }
  bool is_current(const Bad& bad) const {
    return mesh_.complex().is_used(bad.tetrahedron) && stamps_[bad.tetrahedron] == bad.stamp;
  }

  bool is_protected(std::uint32_t t) const {
    const TetrahedronCorners& c = mesh_.complex().corners(t);
    const auto& e = kEdges[shortest_edge(t)];
    return small_->is_between(mesh_, c[e[0]], c[e[1]]);
  }
  double edge_length(std::uint32_t t, std::size_t e) const {
    const TetrahedronCorners& c = mesh_.complex().corners(t);
    return approx_distance(at(c[kEdges[e][0]]), at(c[kEdges[e][1]]));
  }
  std::size_t shortest_edge(std::uint32_t t) const {
    std::size_t out = 0;
    for (std::size_t e = 1; e < 6; ++e)
      if (edge_length(t, e) < edge_length(t, out)) out = e;
    return out;
  }
  double approx_ratio(std::uint32_t t) const {
    return approx_circumsphere(places(t)).radius / edge_length(t, shortest_edge(t));
  }

  // Until no vertex that may go can.
  void remove_vertices() {
    for (std::size_t before = removed_ + 1; before != removed_;) {
      before = removed_;
      for (std::size_t v = mesh_.points().size(); v-- > limits_.num_fixed;)
        if (mesh_.is_corner(static_cast<std::uint32_t>(v)) &&
            mesh_.remove_vertex(static_cast<std::uint32_t>(v)))
          ++removed_;
    }
  }

  // Queues the tetrahedron if it is over a limit and not protected.
  void note(std::uint32_t t) {
    if (stamps_.size() <= t) stamps_.resize(mesh_.complex().num_slots(), 0);
    ++stamps_[t];
    const bool is_large = is_over_volume(exact(t), limits_);
    if (!is_large && (!is_over_ratio(exact(t), limits_) || is_protected(t))) return;
    const double excess = is_large ? approx_volume(exact(t)) / volume_ : approx_ratio(t) / ratio_;
    queue_.push({is_large, std::isfinite(excess) ? excess : HUGE_VAL, t, stamps_[t]});
  }

  // Inserts a vertex because of the tetrahedron; not always in it. False if no place is found.
  bool improve(std::uint32_t t) {
    const bool is_large = is_over_volume(exact(t), limits_);
    const double shortest = edge_length(t, shortest_edge(t));
    least_edge_ = is_large ? kLeastSize * std::cbrt(volume_) : kLeastEdge * shortest;
    if (improve_at_centre(t, shortest)) return true;
    if (is_large) least_edge_ = 0;  // halves the tetrahedron, whatever it looks like
    return split_longest(t);
  }
  bool improve_at_centre(std::uint32_t t, double shortest) {
    const ApproxSphere sphere = approx_circumsphere(places(t));
    if (!std::isfinite(sphere.radius) || !(shortest > 0)) return false;
    const ExactPoint3 centre = short_point(sphere.centre, shortest);
    const RefineWalk walk = walk_to(mesh_, t, centre);
    if (walk.end == RefineWalk::End::kBlocked) return split_face(walk.at);
    if (walk.end == RefineWalk::End::kLost) return false;
    const auto cavity = mesh_.find_cavity(centre, walk.at);
    if (!cavity) return false;
    if (const auto face = face_near(centre.rounded(), *cavity); face && split_face(*face))
      return true;
    return !is_near_vertex(centre.rounded(), *cavity, shortest / 2) && insert(centre, *cavity);
  }

  // The face of the boundary in whose least sphere the place lies, or with a segment in whose diametral sphere.
  std::optional<TetrahedronFace> face_near(const Vec3d& c, const RefineCavity& cavity) const {
    std::optional<TetrahedronFace> out;
    double largest = 0;
    for (const TetrahedronFace f : cavity.shell) {
      if (!mesh_.is_on_boundary(f)) continue;
      const auto v = mesh_.complex().vertices(f);
      const ApproxSphere circle = approx_circumcircle({at(v[0]), at(v[1]), at(v[2])});
      const bool is_near =
          approx_distance(c, circle.centre) < circle.radius || segment_near(c, f).has_value();
      if (is_near && circle.radius > largest) largest = circle.radius, out = f;
    }
    return out;
  }
  // The longest segment of the face in whose diametral sphere the place lies.
  std::optional<std::size_t> segment_near(const Vec3d& c, TetrahedronFace f) const {
    const auto v = mesh_.complex().vertices(f);
    std::optional<std::size_t> out;
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = v[k], b = v[(k + 1) % 3];
      if (!mesh_.is_segment(a, b) || !is_in_diametral_sphere(c, at(a), at(b))) continue;
      if (const double d = approx_distance(at(a), at(b)); d > longest) longest = d, out = k;
    }
    return out;
  }
  bool is_near_vertex(const Vec3d& c, const RefineCavity& cavity, double distance) const {
    for (const TetrahedronFace f : cavity.shell)
      for (const std::uint32_t v : mesh_.complex().vertices(f))
        if (approx_distance(c, at(v)) < distance) return true;
    return false;
  }

  // A vertex near the centre of the face's circle if that is inside of the face, and near no segment; else on an edge.
  bool split_face(TetrahedronFace f) {
    const auto v = mesh_.complex().vertices(f);
    const ApproxSphere circle = approx_circumcircle({at(v[0]), at(v[1]), at(v[2])});
    std::size_t longest = 0;
    std::array<double, 3> square{};
    for (std::size_t k = 0; k < 3; ++k) {
      square[k] = std::pow(approx_distance(at(v[k]), at(v[(k + 1) % 3])), 2);
      if (square[k] > square[longest]) longest = k;
    }
    if (const auto k = segment_near(circle.centre, f))
      return split_edge(face_tetrahedron(f), v[*k], v[(*k + 1) % 3]);
    const double next = square[(longest + 1) % 3] + square[(longest + 2) % 3];
    if (std::isfinite(circle.radius) && next > (1 + kLeastPart) * square[longest]) {
      const auto p =
          short_point_in_plane(mesh_.frame(mesh_.facet(f)), circle.centre,
                               std::sqrt(*std::min_element(square.begin(), square.end())));
      if (p && mesh_.side(f, *p) == Sign::kZero && is_inside(f, *p)) {
        const auto cavity = mesh_.find_cavity(*p, face_tetrahedron(f));
        if (cavity && insert(*p, *cavity)) return true;
      }
    }
    return split_edge(face_tetrahedron(f), v[longest], v[(longest + 1) % 3]);
  }
  bool is_inside(TetrahedronFace f, const ExactPoint3& p) const {
    for (TetrahedronFace g = 4 * face_tetrahedron(f); g < 4 * face_tetrahedron(f) + 4; ++g)
      if (g != f && mesh_.side(g, p) != Sign::kPositive) return false;
    return true;
  }

  bool split_longest(std::uint32_t t) {
    std::size_t longest = 0;
    for (std::size_t e = 1; e < 6; ++e)
      if (edge_length(t, e) > edge_length(t, longest)) longest = e;
    const TetrahedronCorners& c = mesh_.complex().corners(t);
    return split_edge(t, c[kEdges[longest][0]], c[kEdges[longest][1]]);
  }
  // At the middle; a segment that ends at one small angle at a power of two from there, so that segments at a vertex
  // are cut at equal distances.
  bool split_edge(std::uint32_t t, std::uint32_t a, std::uint32_t b) {
    double part = 0.5;
    if (small_ && mesh_.is_segment(a, b) && small_->is_apex(a) != small_->is_apex(b)) {
      if (small_->is_apex(b)) std::swap(a, b);
      const double length = approx_distance(at(a), at(b));
      part = std::exp2(std::round(std::log2(length / 2))) / length;
    }
    const ExactPoint3 p = point_between(mesh_.points()[a], mesh_.points()[b], part);
    const auto cavity = mesh_.find_cavity(p, t);
    return cavity && insert(p, *cavity);
  }

  bool insert(const ExactPoint3& p, const RefineCavity& cavity) {
    if (num_bits(p) > kMaxDmsBits || is_near_vertex(p.rounded(), cavity, least_edge_)) return false;
    const std::vector<std::uint32_t> added = mesh_.insert(p, cavity);
    ++added_;
    if (!cavity.opened.empty()) ++on_boundary_;
    for (const std::uint32_t t : added) note(t);
    return true;
  }

  RefinedDomain finish() {
    RefinedDomain out;
    out.on_boundary = on_boundary_;
    out.inside = added_ - on_boundary_;
    std::uint32_t number = 0;
    for (std::uint32_t t = 0; t < mesh_.complex().num_slots(); ++t) {
      if (!mesh_.complex().is_used(t)) continue;
      if (is_over_volume(exact(t), limits_)) ++out.over_volume;
      if (is_over_ratio(exact(t), limits_)) {
        if (is_protected(t))
          out.protected_tetrahedra.push_back(number);
        else
          ++out.over_radius_edge;
      }
      out.largest_volume = std::max(out.largest_volume, approx_volume(exact(t)));
      out.largest_radius_edge = std::max(out.largest_radius_edge, approx_ratio(t));
      ++number;
    }
    out.end = out.over_volume + out.over_radius_edge == 0 ? RefineEnd::kLimits : end_;
    if (small_) out.small_angles = small_->list();
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t v = 0; v < mesh_.points().size(); ++v) {
      numbers.push_back(static_cast<std::uint32_t>(out.model.clouds.size()));
      if (mesh_.is_corner(v)) out.model.clouds.push_back({mesh_.points()[v].at()});
    }
    out.removed = removed_;
    out.model.tetrahedra = mesh_.tetrahedra();
    for (TetrahedronCorners& t : out.model.tetrahedra)
      for (std::uint32_t& v : t) v = numbers[v];
    set_control_by_rule(out.model, DmsControlRule::kGreville, {});
    return out;
  }

  const RefineLimits& limits_;
  RefineMesh mesh_;
  std::optional<SmallAngles> small_;
  double volume_ = 0, ratio_ = 0;
  double least_edge_ = 0;  // that a new vertex may make
  std::vector<std::uint32_t> stamps_;
  std::priority_queue<Bad> queue_;
  std::size_t added_ = 0, on_boundary_ = 0, removed_ = 0;
  RefineEnd end_ = RefineEnd::kLimits;
};

}  // namespace

Result<RefinedDomain> refine_domain(const DmsModel& domain, const RefineLimits& limits) {
  if (limits.max_volume && limits.max_volume->sign() != Sign::kPositive)
    return bad_argument("a volume must be positive, not " + limits.max_volume->to_string());
  if (limits.max_radius_edge && *limits.max_radius_edge < Rational(1))
    return bad_argument("a ratio of circumradius and edge must be at least 1, not " +
                        limits.max_radius_edge->to_string());
  if (!has_manifold_boundary(domain.tetrahedra))
    return bad_argument("an edge of the boundary belongs to more than two of its faces");
  std::vector<DmsPoint> vertices;
  for (const DmsCloud& cloud : domain.clouds) vertices.push_back(cloud[0]);
  const DmsSimilarity units = similarity_of(vertices);
  if (units.is_identity()) return Refiner(domain, limits).run();
  RefineLimits scaled = limits;
  if (scaled.max_volume) *scaled.max_volume *= Rational::power_of_two(-3 * units.exponent);
  RefinedDomain out = Refiner(units.to_unit(domain), scaled).run();
  out.model = units.from_unit(std::move(out.model));
  out.largest_volume = std::ldexp(out.largest_volume, static_cast<int>(3 * units.exponent));
  return out;
}

}  // namespace veritope
