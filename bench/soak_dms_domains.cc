// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_dms_domains.cc: --folder F [--facets N] [--file NAME]. The domains of the valid meshes of a folder with at
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
#include "solids/polyhedron/validity.h"
#include "tests/support/mesh_domain_check.h"

namespace veritope::bench {
namespace {

struct Tally {
  std::uint64_t files = 0, conforming = 0, wrong = 0;
  std::uint64_t tetrahedra = 0, steiner = 0, facets = 0, bits = 0;
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

void make(const std::string& name, const TriangleMesh& mesh, Tally& tally) {
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
  ++(fault.empty() ? tally.conforming : tally.wrong);
  tally.tetrahedra += made->model.tetrahedra.size();
  tally.steiner += made->steiner_on_mesh + made->steiner_inside;
  tally.facets += mesh.faces.size();
  tally.bits = std::max(tally.bits, bits);
}

void run(const std::string& folder, std::uint64_t most_facets, const std::string& only,
         Tally& tally) {
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
    make(path.filename().string(), file->mesh, tally);
  }
}

}  // namespace
}  // namespace veritope::bench

int main(int argc, char** argv) {
  using namespace veritope;
  std::string folder, only;
  std::uint64_t facets = 20'000;
  bench::read_arguments(argc, argv,
                        {{"--folder", &folder}, {"--facets", &facets}, {"--file", &only}});
  bench::Tally tally;
  bench::run(folder, facets, only, tally);
  std::string reasons;
  for (const auto& [reason, count] : tally.reasons)
    reasons += (reasons.empty() ? "\"" : ",\"") + reason + "\":" + std::to_string(count);
  const auto number = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
  std::printf(
      "{\"name\":\"dms_domains\",\"value\":%.3f,\"goal\":\">= 0.6 of the files, 0 "
      "wrong\",\"files\":%llu,\"conforming\":%llu,\"wrong\":%llu,\"reasons\":{%s},\"facets\":%llu,"
      "\"tetrahedra\":%llu,\"steiner\":%llu,\"bits\":%llu}\n",
      tally.files == 0 ? 0.0
                       : static_cast<double>(tally.conforming) / static_cast<double>(tally.files),
      number(tally.files), number(tally.conforming), number(tally.wrong), reasons.c_str(),
      number(tally.facets), number(tally.tetrahedra), number(tally.steiner), number(tally.bits));
  return tally.wrong == 0 && tally.files > 0 ? 0 : 1;
}
