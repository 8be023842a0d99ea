// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_dms_domains.cc: --folder F [--facets N] [--file NAME] [--parts P]. With P each domain is refined, too,
// until no tetrahedron has more than a P-th of the mesh's volume. The domains of the valid meshes of a folder with at
// most N facets, 20,000 unless given: how many are made, and why not the others. A made domain that is not the mesh,
// exactly, is a failure. One JSON line.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "bench/stopwatch.h"
#include "io/read_model.h"
#include "solids/dms/domain/mesh_domain.h"
#include "solids/dms/domain/refine_domain.h"
#include "solids/polyhedron/validity.h"
#include "tests/support/mesh_domain_check.h"

namespace veritope::bench {
namespace {

struct Tally {
  std::uint64_t files = 0, conforming = 0, wrong = 0;
  std::uint64_t tetrahedra = 0, steiner = 0, facets = 0, bits = 0;
  std::uint64_t refined = 0, inserted = 0, taken_away = 0;
  std::map<std::string, std::uint64_t> reasons;
};

// Numerators and denominators.
std::uint64_t most_bits(const DmsModel& model) {
  std::uint64_t bits = 0;
  for (const DmsCloud& cloud : model.clouds)
    for (const Rational& x : cloud[0])
      bits = std::max({bits, x.numerator().bit_length(), x.denominator().bit_length()});
  return bits;
}

// Whether the refined domain is the mesh, and within its limit.
bool refine(const std::string& name, const TriangleMesh& mesh, const MeshDomain& domain,
            std::uint64_t parts, Tally& tally) {
  RefineLimits limits;
  limits.max_volume = six_volumes(mesh) / Rational(6 * parts);
  limits.num_fixed = domain.from_mesh;
  Stopwatch watch;
  const Result<RefinedDomain> out = refine_domain(domain.model, limits);
  const double seconds = 1e-9 * watch.ns();
  if (!out) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), out.error().message.c_str());
    return false;
  }
  const std::string fault = mesh_domain_fault(mesh, out->model);
  std::fprintf(stderr,
               "  refined: %s, %zu taken away, %zu + %zu inserted, %zu tetrahedra, %.2f s %s\n",
               refine_end_name(out->end), out->removed, out->on_boundary, out->inside,
               out->model.tetrahedra.size(), seconds, fault.c_str());
  tally.refined += out->end == RefineEnd::kLimits && fault.empty();
  tally.inserted += out->on_boundary + out->inside;
  tally.taken_away += out->removed;
  return fault.empty();
}

void make(const std::string& name, const TriangleMesh& mesh, std::uint64_t parts, Tally& tally) {
  ++tally.files;
  Stopwatch watch;
  const Result<MeshDomain> made = domain_of_mesh(mesh, {});
  const double seconds = 1e-9 * watch.ns();
  if (!made) {
    ++tally.reasons[code_name(made.error().code)];
    std::fprintf(stderr, "%s: %s\n", name.c_str(), made.error().message.c_str());
    return;
  }
  const std::string fault = mesh_domain_fault(mesh, made->model);
  const std::uint64_t bits = most_bits(made->model);
  std::fprintf(stderr,
               "%s: %zu facets, %zu vertices, %zu tetrahedra, %zu + %zu Steiner, %llu cuts, %zu "
               "cells, %llu bits, %.2f s %s\n",
               name.c_str(), mesh.faces.size(), made->model.clouds.size(),
               made->model.tetrahedra.size(), made->steiner_on_mesh, made->steiner_inside,
               static_cast<unsigned long long>(made->cuts), made->cells,
               static_cast<unsigned long long>(bits), seconds, fault.c_str());
  const bool is_right = fault.empty() && (parts == 0 || refine(name, mesh, *made, parts, tally));
  ++(is_right ? tally.conforming : tally.wrong);
  tally.tetrahedra += made->model.tetrahedra.size();
  tally.steiner += made->steiner_on_mesh + made->steiner_inside;
  tally.facets += mesh.faces.size();
  tally.bits = std::max(tally.bits, bits);
}

void run(const std::string& folder, std::uint64_t most_facets, const std::string& only,
         std::uint64_t parts, Tally& tally) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& path : files) {
    if (path.filename().string().find(only) == std::string::npos) continue;
    if (path.extension() == ".tsv" || path.extension() == ".md") continue;
    const Result<MeshFile> file = read_mesh_file(path.string(), {});
    if (!file || file->mesh.faces.size() > most_facets) continue;
    if (!decide_validity(file->mesh, {}).is_valid) continue;
    make(path.filename().string(), file->mesh, parts, tally);
  }
}

}  // namespace
}  // namespace veritope::bench

int main(int argc, char** argv) {
  using namespace veritope;
  std::string folder, only;
  std::uint64_t facets = 20'000, parts = 0;
  bench::read_arguments(
      argc, argv,
      {{"--folder", &folder}, {"--facets", &facets}, {"--file", &only}, {"--parts", &parts}});
  bench::Tally tally;
  bench::run(folder, facets, only, parts, tally);
  std::string reasons;
  for (const auto& [reason, count] : tally.reasons)
    reasons += (reasons.empty() ? "\"" : ",\"") + reason + "\":" + std::to_string(count);
  const auto number = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
  std::printf(
      "{\"name\":\"dms_domains\",\"value\":%.3f,\"goal\":\">= 0.6 of the files, 0 "
      "wrong\",\"files\":%llu,\"conforming\":%llu,\"wrong\":%llu,\"reasons\":{%s},\"facets\":%llu,"
      "\"tetrahedra\":%llu,\"steiner\":%llu,\"bits\":%llu,\"refined\":%llu,\"inserted\":%llu,"
      "\"taken_away\":%llu}\n",
      tally.files == 0 ? 0.0
                       : static_cast<double>(tally.conforming) / static_cast<double>(tally.files),
      number(tally.files), number(tally.conforming), number(tally.wrong), reasons.c_str(),
      number(tally.facets), number(tally.tetrahedra), number(tally.steiner), number(tally.bits),
      number(tally.refined), number(tally.inserted), number(tally.taken_away));
  return tally.wrong == 0 && tally.files > 0 ? 0 : 1;
}
