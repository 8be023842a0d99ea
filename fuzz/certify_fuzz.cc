// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/certify_fuzz.cc: a small mesh is written, read again, decided and certified. The C++ checker must accept the
// certificate, M7 must be right pair by pair, and two threads must give the same bytes. The mutator knows places,
// facets and parts.
#include <cstring>

#include "fuzz/decision_laws.h"
#include "fuzz/mesh_input.h"
#include "tests/certify/round_trip.h"
#include "tests/support/checker_call.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace veritope;
  const fuzz::MeshInput in = fuzz::MeshInput::decode(data, size);
  const bool as_indexed = (in.options & fuzz::MeshInput::kAsIndexed) != 0;
  constexpr std::size_t kMaxDefects = 2;  // listing more is slow at extreme scales
  const CertifiedMesh c = certified(in.mesh(), as_indexed, 1, kMaxDefects);
  fuzz::check_decision(c.mesh, c.report);
  const std::string answer = check_in_process(c.file, c.certificate());
  const std::string want = c.report.is_valid ? "ACCEPT mesh-valid-1" : "ACCEPT mesh-invalid-1";
  if (answer.substr(0, want.size()) != want) fuzz::fail(answer, c.mesh);
  if (certificate::explain(c.decoded(), 4).empty()) fuzz::fail("no explanation", c.mesh);
  if ((in.options & fuzz::MeshInput::kTwoJobs) != 0) {
    const CertifiedMesh two = certified(in.mesh(), as_indexed, 2, kMaxDefects);
    if (two.bytes != c.bytes) fuzz::fail("another certificate with two threads", c.mesh);
    if (full_text(two.report) != full_text(c.report))
      fuzz::fail("another report with two threads", c.mesh);
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  using namespace veritope::fuzz;
  if (seed % 8 == 0) return LLVMFuzzerMutate(data, size, max_size);
  MeshMutator mutator(MeshInput::decode(data, size), seed);
  for (unsigned n = 1 + seed / 8 % 4; n > 0; --n) mutator.change();
  const auto bytes = mutator.take().encode();
  if (bytes.size() > max_size) return size;
  std::memcpy(data, bytes.data(), bytes.size());
  return bytes.size();
}
