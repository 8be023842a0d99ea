// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/read_stl_fuzz.cc: any bytes as STL, ASCII or binary.
#include "fuzz/read_laws.h"
#include "fuzz/read_mutator.h"
#include "fuzz/reader_agreement.h"

namespace {

constexpr std::size_t kHeader = 84, kFacet = 50;
constexpr std::string_view kWords[] = {
    "solid",
    "facet",
    "normal",
    "outer",
    "loop",
    "vertex",
    "endloop",
    "endfacet",
    "endsolid",
    "SOLID",
    "facet outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet",
    "vertex 0 0 0",
    "endsolid\nsolid x\n"};

// Makes the count at byte 80 fit the size, or nearly fit it.
void fit_count(veritope::fuzz::Mutator& m) {
  std::string& text = m.text();
  if (text.size() < kHeader) text.resize(kHeader, ' ');
  if (m.pick(2) == 0) text.resize(text.size() - (text.size() - kHeader) % kFacet);
  auto count = static_cast<std::uint32_t>((text.size() - kHeader) / kFacet);
  if (m.pick(4) == 0) count += static_cast<std::uint32_t>(m.pick(3)) - 1;
  std::memcpy(text.data() + 80, &count, 4);
}

void change_binary(veritope::fuzz::Mutator& m) {
  const std::size_t num = m.text().size() < kHeader ? 0 : (m.text().size() - kHeader) / kFacet;
  const std::size_t facet = kHeader + kFacet * m.pick(num);
  switch (m.pick(4)) {
    case 0: m.change_block(facet, kFacet); break;
    case 1: m.change_binary(80, 4); return;
    default: m.change_binary(facet + 4 * m.pick(12), 4); break;
  }
  fit_count(m);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  veritope::fuzz::check_reader(veritope::MeshFormat::kStl, {data, size});
  veritope::fuzz::check_agreement(veritope::MeshFormat::kStl, {data, size});
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  return veritope::fuzz::mutate(data, size, max_size, seed, kWords, [](veritope::fuzz::Mutator& m) {
    // A zero byte is a sign of binary data.
    if (m.text().find('\0') != std::string::npos) return change_binary(m);
    m.pick(3) == 0 ? m.change_line(m.text().size()) : m.change_token(m.text().size());
  });
}
