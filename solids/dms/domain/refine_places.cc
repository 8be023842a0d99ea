// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/domain/refine_places.h"

#include <algorithm>
#include <cmath>

namespace veritope {
namespace {

constexpr int kMostSteps = 20'000;  // of a walk
constexpr int kShortDigits = 9;     // of a place, relative to the size around it

Vec3d offset(const Vec3d& a, const Vec3d& b) { return {b.x - a.x, b.y - a.y, b.z - a.z}; }
double product(const Vec3d& a, const Vec3d& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec3d across_both(const Vec3d& a, const Vec3d& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Vec3d sum_of(double i, const Vec3d& a, double j, const Vec3d& b) {
  return {i * a.x + j * b.x, i * a.y + j * b.y, i * a.z + j * b.z};
}
double norm(const Vec3d& a) { return std::hypot(a.x, a.y, a.z); }
bool is_finite(const Vec3d& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

// The multiple of 2^exponent that is nearest to x, if that is a binary64 number.
double on_grid(double x, int exponent) {
  return std::ldexp(std::nearbyint(std::ldexp(x, -exponent)), exponent);
}

}  // namespace

double approx_volume(const std::array<const ExactPoint3*, 4>& p) {
  std::array<Vec3d, 3> e;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto component = [&](std::size_t k) {
      return nearest_double(p[i + 1]->at()[k] - p[0]->at()[k]);
    };
    e[i] = {component(0), component(1), component(2)};
  }
  return product(e[0], across_both(e[1], e[2])) / 6;
}

double approx_distance(const Vec3d& a, const Vec3d& b) { return norm(offset(a, b)); }

bool is_in_diametral_sphere(const Vec3d& c, const Vec3d& a, const Vec3d& b) {
  return product(offset(c, a), offset(c, b)) < 0;
}

ApproxSphere approx_circumsphere(const std::array<Vec3d, 4>& t) {
  const Vec3d u = offset(t[0], t[1]), v = offset(t[0], t[2]), w = offset(t[0], t[3]);
  const Vec3d vw = across_both(v, w), wu = across_both(w, u), uv = across_both(u, v);
  const double twice = 2 * product(u, vw);
  const Vec3d to =
      sum_of(1 / twice, sum_of(product(u, u), vw, product(v, v), wu), product(w, w) / twice, uv);
  return {sum_of(1, t[0], 1, to), norm(to)};
}

ApproxSphere approx_circumcircle(const std::array<Vec3d, 3>& t) {
  const Vec3d u = offset(t[0], t[1]), v = offset(t[0], t[2]);
  const Vec3d n = across_both(u, v);
  const double twice = 2 * product(n, n);
  const Vec3d to =
      sum_of(product(u, u) / twice, across_both(v, n), product(v, v) / twice, across_both(n, u));
  return {sum_of(1, t[0], 1, to), norm(to)};
}

ExactPoint3 short_point(const Vec3d& at, double size) {
  const int exponent = std::ilogb(size) - kShortDigits;
  return ExactPoint3(
      Vec3d{on_grid(at.x, exponent), on_grid(at.y, exponent), on_grid(at.z, exponent)});
}

std::optional<ExactPoint3> short_point_in_plane(const std::array<ExactPoint3, 3>& frame,
                                                const Vec3d& at, double size) {
  const Vec3d u = offset(frame[0].rounded(), frame[1].rounded());
  const Vec3d v = offset(frame[0].rounded(), frame[2].rounded());
  const Vec3d r = offset(frame[0].rounded(), at), n = across_both(u, v);
  const double square = product(n, n);
  const double s = product(across_both(r, v), n) / square;
  const double t = product(across_both(u, r), n) / square;
  const double length = std::max(norm(u), norm(v));
  if (!std::isfinite(s) || !std::isfinite(t) || !(size > 0) || !(length > 0)) return std::nullopt;
  const int exponent = std::min(0, std::ilogb(size / length)) - kShortDigits - 1;
  const Rational i = Rational::from_double(on_grid(s, exponent));
  const Rational j = Rational::from_double(on_grid(t, exponent));
  std::array<Rational, 3> out = frame[0].at();
  for (std::size_t k = 0; k < 3; ++k)
    out[k] += i * (frame[1].at()[k] - frame[0].at()[k]) + j * (frame[2].at()[k] - frame[0].at()[k]);
  return ExactPoint3(std::move(out));
}

ExactPoint3 point_between(const ExactPoint3& a, const ExactPoint3& b, double part) {
  const Rational r = Rational::from_double(on_grid(part, -10));
  std::array<Rational, 3> out = a.at();
  for (std::size_t k = 0; k < 3; ++k) out[k] += r * (b.at()[k] - a.at()[k]);
  return ExactPoint3(std::move(out));
}

namespace {

// Along the segment from the barycentre, in binary64; the last steps are exact.
class Walker {
 public:
  Walker(const RefineMesh& mesh, const ExactPoint3& to) : mesh_(mesh), to_(to) {}

  RefineWalk walk(std::uint32_t t) {
    Vec3d from{};
    for (const std::uint32_t v : mesh_.complex().corners(t))
      from = sum_of(1, from, 0.25, mesh_.points()[v].rounded());
    if (!is_finite(from) || !is_finite(to_.rounded())) return {};
    TetrahedronFace entered = LinkedTetrahedra::kNoFace;
    for (int i = 0; i < kMostSteps; ++i) {
      const TetrahedronFace exit = exit_of(t, entered, from);
      if (exit == LinkedTetrahedra::kNoFace) return settle(t);
      if (mesh_.is_on_boundary(exit)) return end_at(exit);
      entered = mesh_.complex().across(exit);
      t = face_tetrahedron(entered);
    }
    return {};
  }

 private:
  // The face with the target on its other side that the segment crosses first.
  TetrahedronFace exit_of(std::uint32_t t, TetrahedronFace entered, const Vec3d& from) const {
    TetrahedronFace out = LinkedTetrahedra::kNoFace;
    double first = HUGE_VAL;
    for (TetrahedronFace f = 4 * t; f < 4 * t + 4; ++f) {
      if (f == entered) continue;
      const auto v = mesh_.complex().vertices(f);
      const Vec3d& a = mesh_.points()[v[0]].rounded();
      const Vec3d n = across_both(offset(a, mesh_.points()[v[1]].rounded()),
                                  offset(a, mesh_.points()[v[2]].rounded()));
      const double target = product(n, offset(a, to_.rounded()));
      if (!(target > 0)) continue;
      const double here = product(n, offset(a, from));
      const double at = here / (here - target);
      if (at < first) first = at, out = f;
    }
    return out;
  }
  RefineWalk end_at(TetrahedronFace f) const {
    if (mesh_.side(f, to_) == Sign::kNegative) return {RefineWalk::End::kBlocked, f};
    return settle(face_tetrahedron(f));
  }
  RefineWalk settle(std::uint32_t t) const {
    for (int i = 0; i < 32; ++i) {
      TetrahedronFace left = LinkedTetrahedra::kNoFace;
      for (TetrahedronFace f = 4 * t; f < 4 * t + 4; ++f)
        if (mesh_.side(f, to_) == Sign::kNegative) left = f;
      if (left == LinkedTetrahedra::kNoFace) return {RefineWalk::End::kInside, t};
      if (mesh_.is_on_boundary(left)) return {RefineWalk::End::kBlocked, left};
      t = face_tetrahedron(mesh_.complex().across(left));
    }
    return {};
  }

  const RefineMesh& mesh_;
  const ExactPoint3& to_;
};

}  // namespace

RefineWalk walk_to(const RefineMesh& mesh, std::uint32_t from, const ExactPoint3& to) {
  return Walker(mesh, to).walk(from);
}

}  // namespace veritope
