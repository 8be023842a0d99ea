// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_classify_pn.cc: --points N --seed S: classifies points with respect to PN triangles over real meshes.
// Uniform points are compared with MeshClassifier on a fine tessellation, unless they lie within its deviation from the
// patches; points on the patches at rational parameters must be on them; points 2^-60 and 2^-300 beside those must be
// in or out as the patches' normals say. One JSON line a figure.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "bench/models.h"
#include "bench/stopwatch.h"
#include "robust/base/random.h"
#include "solids/classify/mesh_classifier.h"
#include "solids/classify/patch_classifier.h"
#include "solids/patches/pn_mesh.h"
#include "splines/bezier_triangle.h"

namespace veritope::bench {
namespace {

constexpr int kSteps = 8;  // of the tessellation, along each side

struct PnSolid {
  std::vector<Patch> patches;
  TriangleMesh tessellation;
  double deviation = 0;  // of the tessellation from the patches, at most
};

Vec3d minus(const Vec3d& a, const Vec3d& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec3d cross(const Vec3d& a, const Vec3d& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(const Vec3d& a, const Vec3d& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double length(const Vec3d& a) { return std::sqrt(dot(a, a)); }

std::vector<Vec3d> vertex_normals(const TriangleMesh& mesh) {
  std::vector<Vec3d> out(mesh.positions.size());
  for (const auto& t : mesh.faces) {
    const Vec3d &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const Vec3d n = cross(minus(b, a), minus(c, a));
    for (const std::uint32_t v : t) out[v] = {out[v].x + n.x, out[v].y + n.y, out[v].z + n.z};
  }
  return out;
}

Vec3d control(const BezierTriangle<double>& map, int j, int k) {
  const std::size_t i = triangle_index(j, k);
  return {map.component(0)[i], map.component(1)[i], map.component(2)[i]};
}

// Ten times the greatest second derivative, times the square of a step: far more than chords can miss by.
double deviation_of(const BezierTriangle<double>& map) {
  double most = 0;
  for_each_triangle_index(1, [&](int, int j, int k) {
    const auto at = [&](int a, int b) { return control(map, j + a, k + b); };
    const auto second = [&](const Vec3d& p, const Vec3d& q, const Vec3d& r, const Vec3d& s) {
      return length(minus(minus(p, q), minus(r, s)));
    };
    most = std::max({most, second(at(2, 0), at(1, 0), at(1, 0), at(0, 0)),
                     second(at(0, 2), at(0, 1), at(0, 1), at(0, 0)),
                     second(at(1, 1), at(1, 0), at(0, 1), at(0, 0))});
  });
  return 10 * 6 * most / (kSteps * kSteps);
}

Vec3d point_at(const BezierTriangle<double>& map, double b, double c) {
  std::vector<double> work;
  Vec3d out{};
  double* const to[3] = {&out.x, &out.y, &out.z};
  for (int k = 0; k < 3; ++k) {
    work.assign(map.component(k).begin(), map.component(k).end());
    for (int degree = 3; degree > 0; --degree)
      internal::set_argument(work.data(), degree, Barycentric<double>{1 - b - c, b, c});
    *to[k] = work.front();
  }
  return out;
}

// Each patch has vertices of its own in the tessellation; equal ones are joined by their places along common edges.
class Tessellation {
 public:
  explicit Tessellation(const TriangleMesh& base) : base_(base) {}

  void add(std::size_t face, const BezierTriangle<double>& map, TriangleMesh& out) {
    const auto& t = base_.faces[face];
    std::vector<std::uint32_t> ids;
    for (int row = 0; row <= kSteps; ++row)
      for (int k = 0; k <= row; ++k) {
        const std::array<int, 3> at{kSteps - row, row - k, k};
        ids.push_back(id_of(face, t, at, map, out));
      }
    const auto id = [&](int row, int k) {
      return ids[static_cast<std::size_t>(row * (row + 1) / 2 + k)];
    };
    for (int row = 0; row < kSteps; ++row)
      for (int k = 0; k <= row; ++k) {
        out.faces.push_back({id(row, k), id(row + 1, k), id(row + 1, k + 1)});
        if (k < row) out.faces.push_back({id(row, k), id(row + 1, k + 1), id(row, k + 1)});
      }
  }

 private:
  std::uint32_t id_of(std::size_t face, const std::array<std::uint32_t, 3>& corners,
                      const std::array<int, 3>& at, const BezierTriangle<double>& map,
                      TriangleMesh& out) {
    std::vector<std::uint64_t> key;
    for (std::size_t e = 0; e < 3; ++e)
      if (at[e] > 0) key.push_back(std::uint64_t{corners[e]} << 8 | static_cast<unsigned>(at[e]));
    std::sort(key.begin(), key.end());
    if (key.size() == 3) key.push_back(face);
    const auto [found, is_new] =
        ids_.emplace(std::move(key), static_cast<std::uint32_t>(out.positions.size()));
    if (is_new)
      out.positions.push_back(point_at(map, at[1] / double{kSteps}, at[2] / double{kSteps}));
    return found->second;
  }

  const TriangleMesh& base_;
  std::map<std::vector<std::uint64_t>, std::uint32_t> ids_;
};

PnSolid pn_solid(const TriangleMesh& mesh) {
  const auto normals = vertex_normals(mesh);
  const PnMesh<double> pn = rounded(make_pn_mesh(mesh, normals).value()).value();
  PnSolid out;
  Tessellation tessellation(mesh);
  for (std::size_t f = 0; f < pn.num_faces(); ++f) {
    const BezierTriangle<double> map = pn.points(f);
    std::vector<Rational> exact;
    for (const double x : map.coefficients()) exact.push_back(Rational::from_double(x));
    out.patches.push_back(make_patch(Patch::Triangle(3, 3, false, std::move(exact))).value());
    out.deviation = std::max(out.deviation, deviation_of(map));
    tessellation.add(f, map, out.tessellation);
  }
  return out;
}

double squared_distance(const Vec3d& p, const std::array<Vec3d, 3>& t) {
  // The least over a grid would do; the exact one is by regions: the plane, then the sides.
  const Vec3d u = minus(t[1], t[0]), v = minus(t[2], t[0]), w = minus(p, t[0]);
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w),
               det = uu * vv - uv * uv;
  if (det > 0) {
    const double s = (vv * uw - uv * vw) / det, r = (uu * vw - uv * uw) / det;
    if (s >= 0 && r >= 0 && s + r <= 1) {
      const Vec3d n = cross(u, v);
      return dot(n, w) * dot(n, w) / dot(n, n);
    }
  }
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < 3; ++e) {
    const Vec3d &a = t[e], &b = t[(e + 1) % 3], d = minus(b, a), x = minus(p, a);
    const double along = std::clamp(dot(d, x) / std::max(dot(d, d), 1e-300), 0.0, 1.0);
    const Vec3d y = minus(x, {along * d.x, along * d.y, along * d.z});
    least = std::min(least, dot(y, y));
  }
  return least;
}

using Triple = std::array<Rational, 3>;

Triple values_of(const Patch::Triangle& map, const Barycentric<Rational>& at, int degree_left,
                 const Barycentric<Rational>* direction) {
  Triple out;
  for (int c = 0; c < 3; ++c) {
    std::vector<Rational> work(map.component(c).begin(), map.component(c).end());
    int degree = map.degree();
    if (direction != nullptr) internal::set_argument(work.data(), degree--, *direction);
    for (; degree > degree_left; --degree) internal::set_argument(work.data(), degree, at);
    out[static_cast<std::size_t>(c)] = work.front();
  }
  return out;
}

class Soak {
 public:
  Soak(std::uint64_t points, std::uint64_t seed) : points_(points), random_(seed) {}

  void run(const std::string& name, const TriangleMesh& mesh) {
    const PnSolid solid = pn_solid(mesh);
    const PatchComplex complex = make_patch_complex(solid.patches).value();
    const Stopwatch watch;
    const PatchClassifier classifier = PatchClassifier::make(complex, true);
    const double build = watch.ns() * 1e-9;
    const auto reference = MeshClassifier::make(solid.tessellation);
    Tally uniform, on, off;
    Box3d box = empty_box();
    for (const Vec3d& p : solid.tessellation.positions) add(to_point(p), &box);
    std::vector<Vec3d> points(points_);
    for (Vec3d& p : points) {
      const auto some = [&](std::size_t k) {
        return box.lo[k] + random_.unit() * (box.hi[k] - box.lo[k]);
      };
      p = {some(0), some(1), some(2)};
    }
    std::vector<PointAnswer> answers(points.size()), expected(points.size());
    const Stopwatch ours;
    classifier.classify(points, answers, 1);
    const double ns = ours.ns() / static_cast<double>(points.size());
    const Stopwatch both;
    classifier.classify(points, expected, 2);
    const double ns_of_two = both.ns() / static_cast<double>(points.size());
    reference->classify(points, expected, 1);
    for (std::size_t i = 0; i < points.size(); ++i) {
      ++uniform.points;
      if (!answers[i].is_decided) ++uniform.undecided;
      if (answers[i].winding == expected[i].winding) continue;
      if (is_near(solid, points[i]))
        ++uniform.unsure;
      else
        ++uniform.wrong;
    }
    for (std::uint64_t i = 0; i < std::max<std::uint64_t>(points_ / 100, 1); ++i)
      ask_beside(solid, classifier, on, off);
    report(name, "uniform", uniform);
    report(name, "on", on);
    report(name, "off", off);
    std::printf(
        "{\"name\":\"classify_pn_%s_speed\",\"patches\":%zu,\"build_s\":%.2f,\"ns_a_point\":%.0f,"
        "\"two_threads\":%.2f}\n",
        name.c_str(), solid.patches.size(), build, ns, ns / ns_of_two);
    std::fflush(stdout);
  }

  std::uint64_t num_bad() const { return bad_; }

 private:
  struct Tally {
    std::uint64_t points = 0, wrong = 0, undecided = 0, unsure = 0;
  };

  static bool is_near(const PnSolid& solid, const Vec3d& p) {
    const double most = 4 * solid.deviation * solid.deviation;
    const TriangleMesh& mesh = solid.tessellation;
    return std::any_of(mesh.faces.begin(), mesh.faces.end(), [&](const auto& t) {
      return squared_distance(
                 p, {mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]}) < most;
    });
  }

  // A point of a patch, and the points beside it along its normal.
  void ask_beside(const PnSolid& solid, const PatchClassifier& classifier, Tally& on, Tally& off) {
    const Patch& patch = solid.patches[random_.below(solid.patches.size())];
    const auto some = [&] {
      return Rational(static_cast<std::int64_t>(1 + random_.below(40))) / Rational(97);
    };
    const Rational b = some(), c = some();
    const Barycentric<Rational> at{Rational(1) - b - c, b, c}, u{-1, 1, 0}, v{-1, 0, 1};
    const Triple p = values_of(patch.triangle(), at, 0, nullptr),
                 s = values_of(patch.triangle(), at, 0, &u),
                 t = values_of(patch.triangle(), at, 0, &v);
    count(classifier.classify(p), true, 0, on);
    for (const int bits : {60, 300})
      for (const int side : {-1, 1}) {
        Triple q = p;
        for (std::size_t k = 0; k < 3; ++k) {
          const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
          // The normal's length is of the order of a face's area: far below 1 for these models, or the offset is not
          // small; so it is rounded to short numbers first.
          const Rational n = s[i] * t[j] - s[j] * t[i];
          q[k] += Rational(side) * Rational::from_double(nearest_double(n)) *
                  Rational::power_of_two(-bits);
        }
        count(classifier.classify(q), false, side < 0 ? 1 : 0, off);
      }
  }

  static void count(const PointAnswer& a, bool is_on, int winding, Tally& tally) {
    ++tally.points;
    if (!a.is_decided)
      ++tally.undecided;
    else if (a.is_on() != is_on || (!is_on && a.winding != winding))
      ++tally.wrong;
  }

  void report(const std::string& solid, const char* kind, const Tally& t) {
    std::printf(
        "{\"name\":\"classify_pn_%s_%s_wrong_or_undecided\",\"value\":%llu,\"goal\":\"0\","
        "\"points\":%llu,"
        "\"unsure\":%llu}\n",
        solid.c_str(), kind, static_cast<unsigned long long>(t.wrong + t.undecided),
        static_cast<unsigned long long>(t.points), static_cast<unsigned long long>(t.unsure));
    bad_ += t.wrong + t.undecided;
  }

  std::uint64_t points_;
  Random random_;
  std::uint64_t bad_ = 0;
};

}  // namespace
}  // namespace veritope::bench

int main(int argc, char** argv) {
  using namespace veritope;
  std::uint64_t points = 100'000, seed = 1;
  bench::read_arguments(argc, argv, {{"--points", &points}, {"--seed", &seed}});
  bench::Soak soak(points, seed);
  for (const char* const name :
       {"releases__knot", "releases__larger_sphere", "vcglib__fertility_tri"})
    soak.run(name, bench::data_model("solid1/" + std::string(name) + ".off"));
  return soak.num_bad() == 0 ? 0 : 1;
}
