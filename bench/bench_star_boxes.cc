// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_star_boxes.cc: [most patches]. Growth of the search for star boxes: models of approximately 1,000, 10,000
// and 100,000 patches, one thread: seconds to make the complex and to decide, boxes, bytes of the boxes' and trees'
// part of the certificate, nodes, MiB at the peak. Then, for every model of patch_shapes that touches itself, seconds
// until the search ends without an answer.
#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "bench/stopwatch.h"
#include "models/patch_shapes.h"
#include "verify/certify/patch_decision.h"
#include "verify/certify/star_box_certifier.h"

namespace {

using namespace veritope;
using patch_shapes::Patches;

double peak_mib() {
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  return static_cast<double>(use.ru_maxrss) / 1024;
}

// Each patch counts as an entity of its own.
std::size_t certificate_bytes(const PieceForest& forest, const PatchDecision& decision) {
  std::vector<StarBoxEntity> entities;
  for (std::uint32_t p = 0; p < forest.num_patches(); ++p) {
    StarBoxEntity entity;
    entity.is_surface = !forest.complex().patch(p).is_triangle();
    entity.first_patch = p;
    if (entity.is_surface) entity.breaks = {{{0, 1}, {0, 1}}};
    entities.push_back(std::move(entity));
  }
  return make_star_box_certificate(forest, decision.cover, decision.walks, entities, {}).size();
}

void measure(const std::string& name, const Patches& patches) {
  const bench::Stopwatch making;
  const PatchComplex complex = make_patch_complex(patches).value();
  const double make = making.ns() * 1e-9;
  std::optional<PieceForest> forest;
  const bench::Stopwatch deciding;
  const PatchDecision decision = decide_patches(complex, {}, &forest);
  const double decide = deciding.ns() * 1e-9;
  std::printf(
      "{\"row\":\"%s\",\"ours\":%.3f,\"peer\":null,\"unit\":\"s\",\"patches\":%zu,\"complex_s\":%."
      "3f,"
      "\"valid\":%s,\"tried\":%zu,\"boxes\":%zu,\"tested\":%zu,\"nodes\":%zu,\"bytes\":%zu,\"peak_"
      "mib\":%.0f}\n",
      name.c_str(), decide, patches.size(), make, decision.is_valid ? "true" : "false",
      decision.boxes_tried, decision.cover.boxes.size(), decision.cover.tested_pieces,
      forest->num_nodes(), decision.is_valid ? certificate_bytes(*forest, decision) : 0,
      peak_mib());
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const long most = argc > 1 ? std::atol(argv[1]) : 100000;
  measure("pn-torus-192", patch_shapes::pn_torus(12, 8));
  for (const int n : {1, 3, 10})  // squares: approximately 10^3, 10^4, 10^5 patches
    if (1000L * n * n <= most) {
      measure("grid-torus", patch_shapes::grid_torus(40 * n, 25 * n));
      measure("pn-torus", patch_shapes::pn_torus(25 * n, 20 * n));
    }
  for (const patch_shapes::Shape& shape : patch_shapes::broken_shapes())
    if (shape.truth == patch_shapes::Truth::kTouching) measure(shape.name, shape.patches);
  return 0;
}
