// SPDX-License-Identifier: LGPL-3.0-or-later
#include "bench/models.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <unordered_map>

#include "io/read_model.h"

namespace veritope::bench {
namespace {

using Edge = std::uint64_t;

Edge edge_key(std::uint32_t a, std::uint32_t b) {
  return static_cast<Edge>(std::min(a, b)) << 32 | std::max(a, b);
}

Vec3d combine(double s, const Vec3d& a, double t, const Vec3d& b) {
  return {s * a.x + t * b.x, s * a.y + t * b.y, s * a.z + t * b.z};
}

// Replaces each facet by four, given the new vertex of every edge.
void split_faces(const TriangleMesh& mesh, const std::unordered_map<Edge, std::uint32_t>& middle,
                 TriangleMesh& out) {
  for (const auto& f : mesh.faces) {
    const std::uint32_t m[3] = {middle.at(edge_key(f[0], f[1])), middle.at(edge_key(f[1], f[2])),
                                middle.at(edge_key(f[2], f[0]))};
    out.faces.push_back({f[0], m[0], m[2]});
    out.faces.push_back({f[1], m[1], m[0]});
    out.faces.push_back({f[2], m[2], m[1]});
    out.faces.push_back({m[0], m[1], m[2]});
  }
}

}  // namespace

TriangleMesh data_model(const std::string& name) {
  const char* folder = std::getenv("VERITOPE_DATA");
  auto file = read_mesh_file(
      (folder != nullptr ? std::string(folder) : "../shared/data") + "/mesh/" + name, {});
  if (!file) {
    std::fprintf(stderr, "%s\n", to_string(file.error()).c_str());
    std::exit(4);
  }
  return std::move(file->mesh);
}

TriangleMesh loop_step(const TriangleMesh& mesh) {
  struct EdgeInfo {
    std::uint32_t a, b, opposite[2];
    int faces = 0;
  };
  std::vector<EdgeInfo> edges;
  std::unordered_map<Edge, std::uint32_t> index;
  std::vector<Vec3d> sum(mesh.positions.size());
  std::vector<int> degree(mesh.positions.size());
  for (const auto& f : mesh.faces)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = f[k], b = f[(k + 1) % 3], c = f[(k + 2) % 3];
      const auto [it, fresh] =
          index.try_emplace(edge_key(a, b), static_cast<std::uint32_t>(edges.size()));
      if (fresh) edges.push_back({a, b, {c, c}});
      EdgeInfo& e = edges[it->second];
      e.opposite[e.faces++ > 0 ? 1 : 0] = c;
      sum[a] = combine(1, sum[a], 1, mesh.positions[b]);
      ++degree[a];
    }
  TriangleMesh out;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const double n = std::max(1, degree[v]);
    const double c = 0.375 + 0.25 * std::cos(2 * std::numbers::pi / n);
    const double beta = (0.625 - c * c) / n;
    out.positions.push_back(combine(1 - n * beta, mesh.positions[v], beta, sum[v]));
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const EdgeInfo& e = edges[i];
    const Vec3d near = combine(0.375, mesh.positions[e.a], 0.375, mesh.positions[e.b]);
    const Vec3d far =
        combine(0.125, mesh.positions[e.opposite[0]], 0.125, mesh.positions[e.opposite[1]]);
    index[edge_key(e.a, e.b)] = static_cast<std::uint32_t>(out.positions.size());
    out.positions.push_back(combine(1, near, 1, far));
  }
  split_faces(mesh, index, out);
  return out;
}

TriangleMesh flat_step(const TriangleMesh& mesh) {
  TriangleMesh out;
  out.positions = mesh.positions;
  std::unordered_map<Edge, std::uint32_t> middle;
  for (const auto& f : mesh.faces)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = f[k], b = f[(k + 1) % 3];
      if (middle.try_emplace(edge_key(a, b), static_cast<std::uint32_t>(out.positions.size()))
              .second)
        out.positions.push_back(combine(0.5, mesh.positions[a], 0.5, mesh.positions[b]));
    }
  split_faces(mesh, middle, out);
  return out;
}

TriangleMesh sliver_cylinder(unsigned sides, Caps caps, double length) {
  TriangleMesh m;
  const auto place = [&](double x, double y, double z) {
    const double cx = std::cos(0.3), sx = std::sin(0.3), cy = std::cos(0.5), sy = std::sin(0.5);
    const double u = x * cx - z * sx, w = x * sx + z * cx;
    m.positions.push_back({u, y * cy - w * sy, y * sy + w * cy});
  };
  const std::uint32_t n = sides;
  for (double z : {0.0, length})
    for (std::uint32_t i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n;
      place(std::cos(angle), std::sin(angle), z);
    }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    m.faces.push_back({i, j, n + j});
    m.faces.push_back({i, n + j, n + i});
  }
  const auto cap = [&](std::uint32_t a, std::uint32_t b,
                       std::uint32_t c) {  // counter-clockwise seen from above
    m.faces.push_back({a, c, b});
    m.faces.push_back({n + a, n + b, n + c});
  };
  if (caps == Caps::kCentreFan) {
    place(0, 0, 0);
    place(0, 0, length);
    for (std::uint32_t i = 0; i < n; ++i) {
      m.faces.push_back({2 * n, (i + 1) % n, i});
      m.faces.push_back({2 * n + 1, n + i, n + (i + 1) % n});
    }
  } else if (caps == Caps::kRimFan) {
    for (std::uint32_t i = 1; i + 1 < n; ++i) cap(0, i, i + 1);
  } else {
    for (std::uint32_t l = 0, r = n - 1; l + 1 < r;) {
      cap(l, l + 1, r);
      ++l;
      if (l + 1 < r) {
        cap(l, r - 1, r);
        --r;
      }
    }
  }
  return m;
}

TriangleMesh named_model(const std::string& name) {
  const auto bunny = [] { return data_model("solid1/thingiCSG__bunny_remap.off"); };
  if (name == "bunny70k") return bunny();
  if (name == "blade199k") return data_model("solid1/vtk-data__turbineblade.ply");
  if (name == "loop1115k") return loop_step(loop_step(bunny()));
  if (name == "loop279k") return loop_step(bunny());
  if (name == "flat1115k") return flat_step(flat_step(bunny()));
  const auto begins = [&](const char* start) { return name.rfind(start, 0) == 0; };
  const bool is_plate = begins("plate");
  if (is_plate || begins("sliver"))
    return sliver_cylinder(name.find("80k") != std::string::npos ? 20000 : 5000,
                           name.find("_rim") != std::string::npos      ? Caps::kRimFan
                           : name.find("_zigzag") != std::string::npos ? Caps::kZigzag
                                                                       : Caps::kCentreFan,
                           is_plate ? 0.001 : 10);
  std::fprintf(stderr, "no model %s\n", name.c_str());
  std::exit(2);
}

}  // namespace veritope::bench
