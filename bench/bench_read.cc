// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_read.cc: reading and merging 1.1 million facets from the page cache, in nanoseconds a facet.
// Subject: read_mesh_file with one thread, SHA-256 apart (row hash_*). Peer: CGAL::IO::read_polygon_soup, for STL with
// the merging of equal points (the other formats keep their indices there, so the peer does less). Medians of 7, in turns.
// The mesh: the bunny of the real models after two Loop steps, or without them an icosahedron after eight.
#include <unistd.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "io/read_mesh.h"
#include "io/write_mesh.h"

namespace {

using veritope::TriangleMesh;
using veritope::Vec3d;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

constexpr int kRuns = 7;

[[noreturn]] void stop(const std::string& why) {
  std::fprintf(stderr, "bench_read: %s\n", why.c_str());
  std::exit(1);
}

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

Vec3d combine(double s, const Vec3d& a, double t, const Vec3d& b) {
  return {s * a.x + t * b.x, s * a.y + t * b.y, s * a.z + t * b.z};
}

// One step of Loop's scheme on a closed surface: generic positions, four facets for one, near ones near in the file.
TriangleMesh loop_step(const TriangleMesh& mesh) {
  TriangleMesh fine;
  const std::size_t num = mesh.positions.size();
  fine.positions.resize(num);
  std::vector<Vec3d> ring(num);
  std::vector<int> valence(num);
  std::map<Edge, std::uint32_t> middle;
  std::vector<std::map<std::uint32_t, std::uint32_t>> middles(num);
  const auto middle_of = [&](std::uint32_t a, std::uint32_t b) {
    auto& slot = middles[std::min(a, b)];
    const auto [at, is_new] = slot.try_emplace(std::max(a, b), 0);
    if (is_new) {
      at->second = static_cast<std::uint32_t>(fine.positions.size());
      fine.positions.push_back(combine(0.375, mesh.positions[a], 0.375, mesh.positions[b]));
    }
    return at->second;
  };
  for (const auto& [a, b, c] : mesh.faces) {
    const std::uint32_t ab = middle_of(a, b), bc = middle_of(b, c), ca = middle_of(c, a);
    fine.faces.insert(fine.faces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    for (const auto& [v, next, opposite] : {std::array{a, b, ab}, {b, c, bc}, {c, a, ca}}) {
      ring[v] = combine(1, ring[v], 1, mesh.positions[next]);
      ++valence[v];
      const std::uint32_t third = a ^ b ^ c ^ v ^ next;
      fine.positions[opposite] =
          combine(1, fine.positions[opposite], 0.125, mesh.positions[third]);
    }
  }
  for (std::size_t v = 0; v < num; ++v) {
    const double beta = valence[v] == 3 ? 3.0 / 16 : 3.0 / (8 * std::max(valence[v], 1));
    fine.positions[v] = combine(1 - beta * valence[v], mesh.positions[v], beta, ring[v]);
  }
  return fine;
}

TriangleMesh icosahedron() {
  const double g = 1.618033988749895;
  TriangleMesh mesh;
  mesh.positions = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0}, {0, -1, g}, {0, 1, g},
                    {0, -1, -g}, {0, 1, -g}, {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
  mesh.faces = {{0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                {11, 10, 2}, {10, 7, 6}, {7, 1, 8}, {3, 9, 4}, {3, 4, 2}, {3, 2, 6}, {3, 6, 8},
                {3, 8, 9}, {4, 9, 5}, {2, 4, 11}, {6, 2, 10}, {8, 6, 7}, {9, 8, 1}};
  return mesh;
}

TriangleMesh make_mesh() {
  const char* data = std::getenv("VERITOPE_DATA");
  const std::string folder = data != nullptr ? data : "../shared/data";
  auto bunny = veritope::read_mesh_file(folder + "/mesh/solid1/thingiCSG__bunny_remap.off", {});
  TriangleMesh mesh = bunny ? std::move(bunny->mesh) : icosahedron();
  for (int step = bunny ? 2 : 8; step > 0; --step) mesh = loop_step(mesh);
  return mesh;
}

// OBJ and OFF with %.17g, as most programs write them.
void write_text(const std::string& path, const TriangleMesh& mesh, bool is_obj) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (file == nullptr) stop("cannot write " + path);
  if (!is_obj) std::fprintf(file, "OFF\n%zu %zu 0\n", mesh.positions.size(), mesh.faces.size());
  for (const Vec3d& p : mesh.positions) {
    std::fprintf(file, "%s%.17g %.17g %.17g\n", is_obj ? "v " : "", p.x, p.y, p.z);
  }
  const unsigned base = is_obj ? 1 : 0;
  for (const auto& f : mesh.faces) {
    std::fprintf(file, "%s %u %u %u\n", is_obj ? "f" : "3", f[0] + base, f[1] + base, f[2] + base);
  }
  if (std::fclose(file) != 0) stop("cannot write " + path);
}

void write_file(const std::string& path, const TriangleMesh& mesh, const std::string& variant) {
  if (variant == "obj" || variant == "off") return write_text(path, mesh, variant == "obj");
  const auto options = veritope::write_options_from_name(variant).value();
  const auto status = veritope::write_mesh_file(path, mesh, options);
  if (!status) stop(to_string(status.error()));
}

void read_with_cgal(const std::string& path, bool merges) {
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  if (!CGAL::IO::read_polygon_soup(path, points, polygons)) stop("CGAL cannot read " + path);
  if (!merges) return;
  CGAL::Polygon_mesh_processing::merge_duplicate_points_in_polygon_soup(points, polygons);
}

struct Format {
  const char* name;
  const char* variant;
  const char* extension;
};

void measure(const Format& format, const std::string& folder, const TriangleMesh& mesh,
             bool with_peer) {
  const std::string path = folder + "/mesh." + format.extension;
  write_file(path, mesh, format.variant);
  std::vector<double> ours, hash, peer;
  for (int run = 0; run < kRuns; ++run) {
    const auto file = veritope::read_mesh_file(path, {});
    if (!file) stop(to_string(file.error()));
    if (file->mesh.faces.size() != mesh.faces.size()) stop("wrong number of facets");
    ours.push_back(file->seconds_read + file->seconds_parse);
    hash.push_back(file->seconds_hash);
    const bool merges = std::string(format.extension) == "stl";
    if (with_peer) peer.push_back(seconds_of([&] { read_with_cgal(path, merges); }));
  }
  std::filesystem::remove(path);
  const double scale = 1e9 / static_cast<double>(mesh.faces.size());
  const double a = median(ours) * scale;
  if (with_peer) {
    const double b = median(peer) * scale;
    std::printf("{\"row\":\"read_%s\",\"ours\":%.1f,\"peer\":%.1f,\"unit\":\"ns\",\"ratio\":%.4f}\n",
                format.name, a, b, a / b);
  } else {
    std::printf("{\"row\":\"read_%s\",\"ours\":%.1f,\"peer\":null,\"unit\":\"ns\"}\n", format.name, a);
  }
  std::printf("{\"row\":\"hash_%s\",\"ours\":%.1f,\"peer\":null,\"unit\":\"ns\"}\n", format.name,
              median(hash) * scale);
  std::fflush(stdout);
}

}  // namespace

// usage: bench_read [--alone]   --alone: without the peer
int main(int argc, char** argv) {
  const bool with_peer = !(argc > 1 && std::string(argv[1]) == "--alone");
  const TriangleMesh mesh = make_mesh();
  std::fprintf(stderr, "%zu facets, %zu vertices\n", mesh.faces.size(), mesh.positions.size());
  const auto folder = std::filesystem::temp_directory_path() /
                      ("veritope-bench-read-" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  for (const Format& format : {Format{"stl_binary", "stl-binary", "stl"}, Format{"obj", "obj", "obj"},
                               Format{"off", "off", "off"},
                               Format{"ply_binary", "ply-binary-little-endian", "ply"},
                               Format{"ply_ascii", "ply-ascii", "ply"},
                               Format{"stl_ascii", "stl-ascii", "stl"}}) {
    measure(format, folder.string(), mesh, with_peer);
  }
  std::filesystem::remove_all(folder);
}
