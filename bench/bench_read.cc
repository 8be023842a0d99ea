// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_read.cc: reading and merging 1.1 million facets from the page cache, in nanoseconds a facet. Subject:
// read_mesh_file with one thread, without SHA-256 (rows hash_*). Peer: CGAL::IO::read_polygon_soup; for STL also the
// merging of equal points (for the other formats the peer keeps the indices, and so does less). Medians of 7, in turn.
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
#include <string>
#include <vector>

#include "bench/models.h"
#include "io/mesh/write_mesh.h"
#include "io/read_model.h"

namespace {

using veritope::TriangleMesh;
using veritope::Vec3d;

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
    std::printf(
        "{\"row\":\"read_%s\",\"ours\":%.1f,\"peer\":%.1f,\"unit\":\"ns\",\"ratio\":%.4f}\n",
        format.name, a, b, a / b);
  } else {
    std::printf("{\"row\":\"read_%s\",\"ours\":%.1f,\"peer\":null,\"unit\":\"ns\"}\n", format.name,
                a);
  }
  std::printf("{\"row\":\"hash_%s\",\"ours\":%.1f,\"peer\":null,\"unit\":\"ns\"}\n", format.name,
              median(hash) * scale);
  std::fflush(stdout);
}

}  // namespace

// usage: bench_read [--alone]   --alone: without the peer
int main(int argc, char** argv) {
  const bool with_peer = !(argc > 1 && std::string(argv[1]) == "--alone");
  const TriangleMesh mesh = veritope::bench::named_model("loop1115k");
  std::fprintf(stderr, "%zu facets, %zu vertices\n", mesh.faces.size(), mesh.positions.size());
  const auto folder = std::filesystem::temp_directory_path() /
                      ("veritope-bench-read-" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  for (const Format& format :
       {Format{"stl_binary", "stl-binary", "stl"}, Format{"obj", "obj", "obj"},
        Format{"off", "off", "off"}, Format{"ply_binary", "ply-binary-little-endian", "ply"},
        Format{"ply_ascii", "ply-ascii", "ply"}, Format{"stl_ascii", "stl-ascii", "stl"}}) {
    measure(format, folder.string(), mesh, with_peer);
  }
  std::filesystem::remove_all(folder);
}
