// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/v_complex_fuzz.cc: any bytes as a sequence of edits of a V-complex, five for each step; or as cuboids with glued
// and collapsed faces. After each step all laws of tests/support/v_complex_edits.h hold.
// The first byte says which: even, edits.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "robust/base/check.h"
#include "tests/support/v_complex_edits.h"
#include "topology/hexahedral_v_complex.h"

namespace {

using namespace veritope;

void check_edits(const std::uint8_t* data, std::size_t size) {
  v_edits::Sequence sequence;
  for (std::size_t i = 0; i + 5 <= size && sequence.size() < 40; i += 5)
    sequence.push_back({data[i], data[i + 1], data[i + 2], data[i + 3], data[i + 4]});
  const std::string fault = v_edits::run(sequence);
  if (fault.empty()) return;
  std::fprintf(stderr, "%s of %s\n", fault.c_str(), v_edits::to_text(sequence).c_str());
  std::abort();
}

// Four bytes for each face: what it is; the cell, the face and the symmetry. Two for collapsed edges.
void check_cuboids(const std::uint8_t* data, std::size_t size) {
  std::vector<HexahedralCell> cells;
  for (std::size_t i = 0; i + 26 <= size && cells.size() < 6; i += 26) {
    HexahedralCell& cell = cells.emplace_back();
    for (std::size_t f = 0; f < 6; ++f) {
      const std::uint8_t* const at = data + i + 4 * f;
      cell.faces[f] = {static_cast<HexahedralFace::Kind>(at[0] % 5), at[1] % 6u, at[2] % 7u,
                       at[3] % 9u};
    }
    for (std::size_t e = 0; e < 12; ++e)
      cell.is_collapsed[e] = (data[i + 24 + e / 8] >> e % 8 & 1) != 0;
  }
  const auto made = hexahedral_v_complex(cells);
  if (!made) return VT_CHECK(made.error().code == Code::kBadArgument, "another error");
  VT_CHECK(made.value().complex.counts().cells == cells.size(), "a cell is lost");
  const std::string fault = v_edits::fault_of(made.value().complex);
  if (fault.empty()) return;
  std::fprintf(stderr, "%s of %zu cuboids\n", fault.c_str(), cells.size());
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  (data[0] % 2 == 0 ? check_edits : check_cuboids)(data + 1, size - 1);
  return 0;
}
