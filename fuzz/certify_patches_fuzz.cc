// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/certify_patches_fuzz.cc: a small patch model, changed as the bytes say, is written, read again, decided and
// certified. The C++ checker must accept its certificate, whatever the verdict.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "fuzz/pulled_patches.h"
#include "tests/certify/patch_round_trip.h"
#include "tests/support/checker_call.h"

namespace veritope::fuzz {
namespace {

void check(const Patches& patches) {
  PatchDecisionOptions options;
  options.cover.max_level = 7;
  options.cover.max_boxes = 400;
  options.tolerance = 0.1;
  const CertifiedPatches c = certified_patches(patches, options);
  if (c.decision.open) return;
  const std::string answer = check_in_process(c.file, std::string(c.bytes.begin(), c.bytes.end()));
  if (answer.substr(0, 7) == "ACCEPT ") return;
  std::fprintf(stderr, "%s\n%s\n", answer.c_str(), c.file.c_str());
  std::abort();
}

}  // namespace
}  // namespace veritope::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace veritope::fuzz;
  if (size == 0 || size > 81) return 0;
  Pulled model(shape(data[0]));
  for (std::size_t i = 1; i + 4 <= size; i += 4) model.change(data + i);
  check(model.patches());
  return 0;
}
