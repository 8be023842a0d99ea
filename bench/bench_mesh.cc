// SPDX-License-Identifier: LGPL-3.0-or-later
// The mesh decision compared with CGAL's, and what certificates and checkers cost. One JSON row a line; figures in
// docs/benchmarks.md.
#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "bench/cgal_peer.h"
#include "bench/models.h"
#include "robust/base/check.h"
#include "solids/polyhedron/validity.h"

namespace veritope::bench {
namespace {

constexpr int kRuns = 7;
constexpr int kAttempts = 60;       // to get seven runs with two threads
constexpr double kTwoCores = 1.15;  // two_thread_slowdown() on two cores, with some noise

double median(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v[v.size() / 2];
}

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// "peer" is null without a peer.
void row(const std::string& name, double ours, double peer, const char* unit,
         const std::string& more = "") {
  char buffer[64];
  std::string line = "{\"row\":\"" + name + "\",\"ours\":";
  std::snprintf(buffer, sizeof buffer, "%.6g", ours);
  line += buffer;
  line += ",\"peer\":";
  if (peer > 0) {
    std::snprintf(buffer, sizeof buffer, "%.6g", peer);
    line += buffer;
  } else {
    line += "null";
  }
  std::printf("%s,\"unit\":\"%s\"%s}\n", line.c_str(), unit, more.c_str());
  std::fflush(stdout);
}

ValidityReport decide(const TriangleMesh& mesh, unsigned jobs) {
  ValidityOptions options;
  options.jobs = jobs;
  ValidityReport report = decide_validity(mesh, options);
  VT_CHECK(report.is_valid, "the benchmark's models are valid");
  return report;
}

// The time of the parts of one run, as a JSON object in ns a facet.
std::string breakdown(const DecisionTimes& t, double facets) {
  char buffer[256];
  const double ns = 1e9 / facets;
  std::snprintf(buffer, sizeof buffer,
                ",\"parts\":{\"incidence\":%.0f,\"signs\":%.0f,\"topology\":%.0f,\"stars\":%.0f,"
                "\"boxes\":%.0f,"
                "\"pairs\":%.0f,\"volume\":%.0f,\"nesting\":%.0f}",
                t.incidence * ns, t.signs * ns, t.topology * ns, t.stars * ns, t.boxes * ns,
                t.pairs * ns, t.volume * ns, t.nesting * ns);
  return buffer;
}

// Eight independent chains of integer operations: as many as a core can execute at a time.
std::uint64_t busy_work(std::uint64_t seed) {
  std::uint64_t x = seed, y = 2, z = 3, w = 4, a = 5, b = 6, c = 7, d = 8;
  for (int i = 0; i < 4'000'000; ++i) {
    x = (x ^ y) + 0x123456789u;
    y = (y ^ 0x55555u) + z;
    z = (z + w) ^ a;
    w += x >> 3;
    a += b ^ 0x77u;
    b ^= c + 3;
    c += d ^ 5u;
    d ^= a + 9;
  }
  return x ^ y ^ z ^ w ^ a ^ b ^ c ^ d;
}

// The time of two threads of busy work divided by that of one: 1 on two cores, 2 on two hardware threads of one core.
// Virtual machines switch between the two, so every run with two threads lies between two of these measurements.
double two_thread_slowdown() {
  std::atomic<std::uint64_t> sink{0};
  const double alone = seconds([&] { sink += busy_work(1); });
  const double together = seconds([&] {
    std::thread other([&] { sink += busy_work(2); });
    sink += busy_work(3);
    other.join();
  });
  return together / alone;
}

// Ours with one thread, ours with two, and CGAL's, in turn; medians. The parts are those of the last run. A run with
// two threads counts if the machine had two cores during it. At most kAttempts runs are made; if there never were two
// cores, all of them count ("cores":1).
void decision_rows(const std::string& name, bool with_peer) {
  const TriangleMesh mesh = named_model(name);
  const double facets = static_cast<double>(mesh.faces.size());
  const auto cgal = with_peer ? std::make_unique<CgalMesh>(mesh) : nullptr;
  std::vector<double> one, two, one_beside, crowded, peer;
  DecisionTimes parts_of_one, parts_of_two;
  for (int i = 0; i < kRuns; ++i) {
    one.push_back(seconds([&] { parts_of_one = decide(mesh, 1).seconds; }) * 1e9 / facets);
    if (with_peer)
      peer.push_back(seconds([&] { VT_CHECK(cgal->is_valid_solid(), "CGAL agrees"); }) * 1e9 /
                     facets);
  }
  for (int i = 0; i < kAttempts && two.size() < kRuns; ++i) {
    const double before = two_thread_slowdown();
    const double with_one = seconds([&] { decide(mesh, 1); }) * 1e9 / facets;
    DecisionTimes parts;
    const double with_two = seconds([&] { parts = decide(mesh, 2).seconds; }) * 1e9 / facets;
    if (std::max(before, two_thread_slowdown()) > kTwoCores) {
      crowded.push_back(with_two);
      continue;
    }
    one_beside.push_back(with_one);
    two.push_back(with_two);
    parts_of_two = parts;
  }
  row("decision_" + name + "_vs_cgal", median(one), with_peer ? median(peer) : 0, "ns/facet",
      breakdown(parts_of_one, facets));
  const bool two_cores = !two.empty();
  row("decision_" + name + "_two_threads_vs_one", median(two_cores ? two : crowded),
      median(two_cores ? one_beside : one), "ns/facet",
      breakdown(parts_of_two, facets) + (two_cores ? ",\"cores\":2" : ",\"cores\":1") +
          ",\"runs\":" + std::to_string(two.size()));
}

// A line of /proc/self/status, in bytes.
double status_bytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind(key + ":", 0) == 0) return std::atof(line.c_str() + key.size() + 1) * 1024;
  return 0;
}

// Peak memory of the decision, the mesh's arrays included, in a process of its own. The memory that making the model
// needed is returned to the system, and the peak reset, before the decision starts.
void memory_row(const std::string& name) {
  int ends[2];
  VT_CHECK(pipe(ends) == 0, "pipe");
  const pid_t child = fork();
  if (child == 0) {
    const double before = status_bytes("VmRSS");
    const TriangleMesh mesh = named_model(name);
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5";
    const double held = status_bytes("VmRSS") - before;
    decide(mesh, 1);
    const double facets = static_cast<double>(mesh.faces.size());
    const double figures[2] = {(status_bytes("VmHWM") - before) / facets, held / facets};
    _exit(write(ends[1], figures, sizeof figures) == static_cast<ssize_t>(sizeof figures) ? 0 : 1);
  }
  double figures[2] = {0, 0};
  VT_CHECK(read(ends[0], figures, sizeof figures) == static_cast<ssize_t>(sizeof figures),
           "the child's figures");
  waitpid(child, nullptr, 0);
  close(ends[0]);
  close(ends[1]);
  char more[64];
  std::snprintf(more, sizeof more, ",\"model_alone\":%.0f", figures[1]);
  row("memory_" + name, figures[0], 0, "bytes/facet", more);
}

}  // namespace
}  // namespace veritope::bench

int main(int argc, char** argv) {
  using namespace veritope::bench;
  const std::vector<std::string> with_peer{"bunny70k", "blade199k", "loop1115k", "flat1115k",
                                           "sliver20k"};
  const std::vector<std::string> alone{"loop279k",      "sliver80k",        "sliver20k_rim",
                                       "sliver80k_rim", "sliver20k_zigzag", "sliver80k_zigzag",
                                       "plate20k_rim",  "plate80k_rim",     "plate80k_zigzag"};
  const auto wanted = [&](const std::string& name) { return argc < 2 || name == argv[1]; };
  for (const auto& name : {"blade199k", "loop1115k"})
    if (wanted(name)) memory_row(name);
  for (const auto& name : with_peer)
    if (wanted(name)) decision_rows(name, true);
  for (const auto& name : alone)
    if (wanted(name)) decision_rows(name, false);
  return 0;
}
