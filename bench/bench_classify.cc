// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_classify.cc [MODEL]: ns a point of the classifiers. Meshes: beside CGAL's Side_of_triangle_mesh and, if
// it is there, Embree's parity, for points that are uniform in the box and within 1e-3 and 1e-7 of the diagonal from
// the surface. Patches: beside Open CASCADE's BRepClass3d_SolidClassifier, if it is there, uniform and within 1e-3 and
// 1e-9. One thread. The peers' different answers are counted; CGAL's and the soaks confirm ours.
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "bench/models.h"
#include "bench/patch_side_peers.h"
#include "bench/side_peers.h"
#include "bench/stopwatch.h"
#include "models/patch_shapes.h"
#include "robust/base/check.h"
#include "robust/base/random.h"
#include "solids/classify/mesh_classifier.h"
#include "solids/classify/patch_classifier.h"
#include "solids/polyhedron/box_order.h"
#include "splines/de_casteljau.h"

namespace veritope::bench {
namespace {

constexpr std::size_t kUniform = 1'000'000, kNear = 100'000;
constexpr int kRuns = 3;

std::vector<Vec3d> uniform_points(const Box3d& box, Random& random) {
  std::vector<Vec3d> out(kUniform);
  for (Vec3d& p : out) {
    double c[3];
    for (std::size_t k = 0; k < 3; ++k) c[k] = box.lo[k] + random.unit() * (box.hi[k] - box.lo[k]);
    p = {c[0], c[1], c[2]};
  }
  return out;
}

// Within `distance` of a random point of a random facet.
std::vector<Vec3d> near_points(const TriangleMesh& mesh, double distance, Random& random) {
  std::vector<Vec3d> out(kNear);
  const auto offset = [&] { return distance * (2 * random.unit() - 1) / std::sqrt(3.0); };
  for (Vec3d& p : out) {
    const auto& t = mesh.faces[random.below(mesh.faces.size())];
    double s = random.unit(), r = random.unit();
    if (s + r > 1) s = 1 - s, r = 1 - r;
    const auto mix = [&](double a, double b, double c) {
      return a + s * (b - a) + r * (c - a) + offset();
    };
    const Vec3d &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    p = {mix(a.x, b.x, c.x), mix(a.y, b.y, c.y), mix(a.z, b.z, c.z)};
  }
  return out;
}

double least_ns(const std::function<void()>& work) {
  double least = 0;
  for (int i = 0; i < kRuns; ++i) {
    const Stopwatch watch;
    work();
    least = i == 0 ? watch.ns() : std::min(least, watch.ns());
  }
  return least;
}

Side side_of(const PointAnswer& a) {
  return a.is_on() ? Side::kOn : a.winding != 0 ? Side::kIn : Side::kOut;
}

template <typename Peer>
std::vector<Side> answers_of(const Peer& peer, const std::vector<Vec3d>& points, double& ns) {
  std::vector<Side> out(points.size());
  const Stopwatch watch;
  for (std::size_t i = 0; i < points.size(); ++i) out[i] = peer(points[i]);
  ns = watch.ns() / static_cast<double>(points.size());
  return out;
}

std::size_t num_different(const std::vector<PointAnswer>& ours, const std::vector<Side>& theirs) {
  std::size_t out = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) out += side_of(ours[i]) != theirs[i] ? 1 : 0;
  return out;
}

void rows(const std::string& name) {
  const TriangleMesh mesh = named_model(name);
  const double facets = static_cast<double>(mesh.faces.size());
  const Stopwatch build;
  const auto made = MeshClassifier::make(mesh);
  const double build_ns = build.ns() / facets;
  VT_CHECK(static_cast<bool>(made), "the benchmark's models are closed");
  const Stopwatch build_cgal;
  const CgalSides cgal(mesh);
  const double cgal_build_ns = build_cgal.ns() / facets;
  std::printf(
      "{\"row\":\"classify_%s_build_vs_cgal\",\"ours\":%.1f,\"peer\":%.1f,\"unit\":\"ns/facet\","
      "\"bytes_a_facet\":%.1f,\"cells\":%llu}\n",
      name.c_str(), build_ns, cgal_build_ns, static_cast<double>(made->lookup().bytes) / facets,
      static_cast<unsigned long long>(made->lookup().cells));
#ifdef VERITOPE_BENCH_EMBREE
  const EmbreeSides embree(mesh);
#endif
  const Box3d box = bounding_box_of_faces(mesh, 1);
  const double diagonal =
      std::hypot(box.hi[0] - box.lo[0], box.hi[1] - box.lo[1], box.hi[2] - box.lo[2]);
  for (const char* const kind : {"uniform", "1e-3", "1e-7"}) {
    Random random(1);
    const bool is_uniform = kind[0] == 'u';
    const auto points = is_uniform ? uniform_points(box, random)
                                   : near_points(mesh, std::atof(kind) * diagonal, random);
    std::vector<PointAnswer> ours(points.size());
    const double ns =
        least_ns([&] { made->classify(points, ours, 1); }) / static_cast<double>(points.size());
    const auto print = [&](const char* peer, double peer_ns, double peer_build, std::size_t wrong) {
      std::printf(
          "{\"row\":\"classify_%s_%s_vs_%s\",\"ours\":%.1f,\"peer\":%.1f,\"unit\":\"ns/"
          "point\",\"different\":%zu",
          name.c_str(), kind, peer, ns, peer_ns, wrong);
      // Points after which our longer building has paid.
      if (peer_build > 0 && peer_ns > ns)
        std::printf(",\"pays_after\":%.0f",
                    std::max(0.0, (build_ns - peer_build) * facets / (peer_ns - ns)));
      std::printf("}\n");
      std::fflush(stdout);
    };
    double peer_ns = 0;
    const std::size_t different = num_different(ours, answers_of(cgal, points, peer_ns));
    print("cgal", peer_ns, cgal_build_ns, different);
#ifdef VERITOPE_BENCH_EMBREE
    print("embree", peer_ns, 0, num_different(ours, answers_of(embree, points, peer_ns)));
#endif
  }
}

// ---- patches

struct CurvedModel {
  const char* name;
  patch_shapes::Patches patches;
};

std::vector<CurvedModel> curved_models() {
  return {{"sphere", patch_shapes::sphere()},
          {"torus", patch_shapes::torus(3, 1)},
          {"cylinder", patch_shapes::frustum(1, 1, 2)}};
}

// Within `distance` of a random point of a random patch.
std::vector<Vec3d> near_points(const patch_shapes::Patches& patches, double distance,
                               std::size_t count, Random& random) {
  std::vector<Vec3d> out(count);
  const auto offset = [&] { return distance * (2 * random.unit() - 1) / std::sqrt(3.0); };
  for (Vec3d& p : out) {
    const Patch& patch = patches[random.below(patches.size())];
    const Bezier<double, 2> map = [&] {
      std::vector<double> values;
      for (const Rational& x : patch.tensor().coefficients()) values.push_back(nearest_double(x));
      return Bezier<double, 2>(patch.tensor().degrees(), patch.tensor().num_components(),
                               patch.is_rational(), std::move(values));
    }();
    const auto f = evaluate(map, std::array<double, 2>{random.unit(), random.unit()});
    const double w = patch.is_rational() ? f[3] : 1;
    p = {f[0] / w + offset(), f[1] / w + offset(), f[2] / w + offset()};
  }
  return out;
}

void rows(const CurvedModel& model) {
  const PatchComplex complex = make_patch_complex(model.patches).value();
  const Stopwatch build;
  const PatchClassifier made = PatchClassifier::make(complex, true);
  const double build_s = build.ns() * 1e-9;
  Box3d box = empty_box();
  for (Vec3d& p : [&] {
         Random random(2);
         return near_points(model.patches, 0, 10'000, random);
       }())
    add(to_point(p), &box);
  const double diagonal =
      std::hypot(box.hi[0] - box.lo[0], box.hi[1] - box.lo[1], box.hi[2] - box.lo[2]);
#ifdef VERITOPE_BENCH_OCCT
  const Stopwatch build_peer;
  const OcctSides peer(model.patches);
  const double peer_build_s = build_peer.ns() * 1e-9;
  VT_CHECK(peer.is_closed(), "Open CASCADE sews the benchmark's models");
#endif
  for (const char* const kind : {"uniform", "1e-3", "1e-9"}) {
    Random random(1);
    const bool is_uniform = kind[0] == 'u';
    const auto points =
        is_uniform ? uniform_points(box, random)
                   : near_points(model.patches, std::atof(kind) * diagonal, 20'000, random);
    std::vector<PointAnswer> ours(points.size());
    const double ns =
        least_ns([&] { made.classify(points, ours, 1); }) / static_cast<double>(points.size());
    std::printf(
        "{\"row\":\"classify_%s_%s_vs_occt\",\"ours\":%.1f,\"unit\":\"ns/point\","
        "\"build_s\":%.3f,\"bytes\":%llu",
        model.name, kind, ns, build_s, static_cast<unsigned long long>(made.lookup().bytes));
#ifdef VERITOPE_BENCH_OCCT
    constexpr std::size_t kPeerPoints = 2'000;  // it takes a fifth of a millisecond for each
    const std::vector<Vec3d> some(points.begin(), points.begin() + kPeerPoints);
    double peer_ns = 0;
    const auto theirs = answers_of(peer, some, peer_ns);
    const std::vector<PointAnswer> of_some(ours.begin(), ours.begin() + kPeerPoints);
    std::printf(
        ",\"peer\":%.1f,\"ratio\":%.0f,\"different\":%zu,\"of\":%zu,\"peer_build_s\":%.3f,"
        "\"pays_after\":%.0f",
        peer_ns, peer_ns / ns, num_different(of_some, theirs), kPeerPoints, peer_build_s,
        std::max(0.0, (build_s - peer_build_s) * 1e9 / (peer_ns - ns)));
#endif
    std::printf("}\n");
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace veritope::bench

int main(int argc, char** argv) {
  for (const char* const name : {"bunny70k", "blade199k", "loop1115k"})
    if (argc < 2 || std::string(argv[1]) == name) veritope::bench::rows(std::string(name));
  for (const auto& model : veritope::bench::curved_models())
    if (argc < 2 || std::string(argv[1]) == model.name) veritope::bench::rows(model);
  return 0;
}
