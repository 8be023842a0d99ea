// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_classify.cc: --points N --seed S [--file MESH]... : classifies points with respect to valid meshes and
// compares with CGAL's exact answers; then with respect to sums of unit cubes, where arithmetic knows the answers.
// Points: random, on facets, on edges, on vertices, and with two coordinates of a vertex. One JSON line a figure.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "bench/side_peers.h"
#include "io/mesh/read_mesh.h"
#include "io/read_model.h"
#include "robust/base/random.h"
#include "solids/classify/mesh_classifier.h"
#include "solids/polyhedron/box_order.h"
#include "solids/polyhedron/validity.h"

namespace veritope::bench {
namespace {

enum Kind { kUniform, kOnFacet, kOnEdge, kVertex, kTwoCoordinates, kNumKinds };
constexpr const char* kNames[kNumKinds] = {"uniform", "on_facets", "on_edges", "vertices",
                                           "two_coordinates"};

struct Tally {
  std::uint64_t points = 0, on = 0, wrong = 0;
};

Vec3d point_of(Kind kind, const TriangleMesh& mesh, const Box3d& box, Random& random) {
  const auto& t = mesh.faces[random.below(mesh.faces.size())];
  const Vec3d &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
  const auto between = [&](std::size_t k) {
    return box.lo[k] + random.unit() * (box.hi[k] - box.lo[k]);
  };
  double s = random.unit(), r = kind == kOnFacet ? random.unit() : 0;
  if (s + r > 1) s = 1 - s, r = 1 - r;
  const auto mix = [&](double x, double y, double z) { return x + s * (y - x) + r * (z - x); };
  switch (kind) {
    case kUniform: return {between(0), between(1), between(2)};
    case kVertex: return a;
    case kTwoCoordinates:
      switch (random.below(3)) {
        case 0: return {between(0), a.y, a.z};
        case 1: return {a.x, between(1), a.z};
        default: return {a.x, a.y, between(2)};
      }
    default: return {mix(a.x, b.x, c.x), mix(a.y, b.y, c.y), mix(a.z, b.z, c.z)};
  }
}

Side side_of(const PointAnswer& a) {
  return a.is_on() ? Side::kOn : a.winding != 0 ? Side::kIn : Side::kOut;
}

class Soak {
 public:
  Soak(std::uint64_t points, std::uint64_t seed) : points_(points), random_(seed) {}

  // CGAL's rays do not end for a cube of 1e150.
  static bool is_for_cgal(const TriangleMesh& mesh) {
    const double size = extent(bounding_box_of_faces(mesh, 1));
    return 1e-100 < size && size < 1e100;
  }

  void against_cgal(const std::string& path, const TriangleMesh& mesh) {
    if (!is_for_cgal(mesh)) return;
    const CgalSides peer(mesh);
    compare(path, mesh, [&](const Vec3d& p) { return peer(p); });
  }

  // Cubes of the lattice as one chain: a point is in if all cells around it are, on if some are.
  void against_arithmetic(int size) {
    std::set<std::array<int, 3>> cells;
    for (int i = 0; i < size * size * size / 2; ++i)
      cells.insert({static_cast<int>(random_.below(size)), static_cast<int>(random_.below(size)),
                    static_cast<int>(random_.below(size))});
    const TriangleMesh mesh = cubes(cells);
    const auto is_cell = [&](double x, double y, double z) {
      return cells.count({static_cast<int>(x), static_cast<int>(y), static_cast<int>(z)}) != 0;
    };
    compare("cubes", mesh, [&](const Vec3d& p) {
      std::size_t in = 0;
      for (int i = 0; i < 8; ++i) {
        const auto low = [&](double c, int bit) {
          return (i >> bit & 1) != 0 ? std::ceil(c) - 1 : std::floor(c);
        };
        in += is_cell(low(p.x, 0), low(p.y, 1), low(p.z, 2)) ? 1 : 0;
      }
      return in == 0 ? Side::kOut : in == 8 ? Side::kIn : Side::kOn;
    });
  }

  std::uint64_t report() const {
    std::uint64_t wrong = 0;
    for (int k = 0; k < kNumKinds; ++k) {
      const Tally& t = tallies_[k];
      std::printf(
          "{\"name\":\"classify_meshes_%s_wrong\",\"value\":%llu,\"goal\":\"0\",\"points\":%llu,"
          "\"on\":%llu,\"models\":%d}\n",
          kNames[k], static_cast<unsigned long long>(t.wrong),
          static_cast<unsigned long long>(t.points), static_cast<unsigned long long>(t.on),
          models_);
      wrong += t.wrong;
    }
    return wrong;
  }

 private:
  // The outer squares of the cells, which face outward, each in two triangles.
  static TriangleMesh cubes(const std::set<std::array<int, 3>>& cells) {
    TriangleMesh out;
    std::map<std::array<int, 3>, std::uint32_t> ids;
    const auto id = [&](const std::array<int, 3>& v) {
      const auto [at, is_new] = ids.emplace(v, static_cast<std::uint32_t>(out.positions.size()));
      if (is_new) out.positions.push_back({double(v[0]), double(v[1]), double(v[2])});
      return at->second;
    };
    for (const auto& c : cells)
      for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end) {
          std::array<int, 3> beside = c;
          beside[axis] += end != 0 ? 1 : -1;
          if (cells.count(beside) != 0) continue;
          std::array<std::uint32_t, 4> q{};
          for (int i = 0; i < 4; ++i) {
            std::array<int, 3> v = c;
            v[axis] += end;
            v[(axis + 1) % 3] += i == 1 || i == 2 ? 1 : 0;
            v[(axis + 2) % 3] += i >= 2 ? 1 : 0;
            q[i] = id(v);
          }
          if (end == 0) std::swap(q[1], q[3]);
          out.faces.push_back({q[0], q[1], q[2]});
          out.faces.push_back({q[0], q[2], q[3]});
        }
    return out;
  }

  template <typename Truth>
  void compare(const std::string& name, const TriangleMesh& mesh, const Truth& truth) {
    const auto classifier = MeshClassifier::make(mesh);
    if (!classifier) return;
    ++models_;
    const Box3d box = bounding_box_of_faces(mesh, 1);
    for (int k = 0; k < kNumKinds; ++k) {
      std::fprintf(stderr, "%s, %zu facets: %s\n", name.c_str(), mesh.faces.size(), kNames[k]);
      std::vector<Vec3d> points(k == kUniform ? points_ : points_ / 10);
      for (Vec3d& p : points) p = point_of(static_cast<Kind>(k), mesh, box, random_);
      std::vector<PointAnswer> answers(points.size());
      classifier->classify(points, answers, 1);
      for (std::size_t i = 0; i < points.size(); ++i) {
        const bool is_wrong = side_of(answers[i]) != truth(points[i]);
        tallies_[k].wrong += is_wrong ? 1 : 0;
        tallies_[k].on += answers[i].is_on() ? 1 : 0;
        if (is_wrong)
          std::fprintf(stderr, "%s: %a %a %a\n", name.c_str(), points[i].x, points[i].y,
                       points[i].z);
      }
      tallies_[k].points += points.size();
    }
  }

  std::uint64_t points_;
  Random random_;
  Tally tallies_[kNumKinds];
  int models_ = 0;
};

}  // namespace
}  // namespace veritope::bench

int main(int argc, char** argv) {
  using namespace veritope;
  std::uint64_t points = 200000, seed = 1;
  std::string folder = std::getenv("VERITOPE_DATA") != nullptr
                           ? std::string(std::getenv("VERITOPE_DATA")) + "/mesh"
                           : "../shared/data/mesh";
  bench::read_arguments(argc, argv,
                        {{"--points", &points}, {"--seed", &seed}, {"--folder", &folder}});
  bench::Soak soak(points, seed);
  for (const int size : {3, 6, 12}) soak.against_arithmetic(size);
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  for (const std::string& path : paths) {
    const auto file = read_model_file(path, {});
    const auto* mesh = file ? std::get_if<MeshFile>(&*file) : nullptr;
    if (mesh == nullptr || !decide_validity(mesh->mesh, {}).is_valid) continue;
    soak.against_cgal(path, mesh->mesh);
  }
  return soak.report() == 0 ? 0 : 1;
}
