// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/read_off_fuzz.cc: any bytes as OFF.
#include "fuzz/read_laws.h"
#include "fuzz/read_mutator.h"
#include "fuzz/reader_agreement.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  veritope::fuzz::check_reader(veritope::MeshFormat::kOff, {data, size});
  veritope::fuzz::check_agreement(veritope::MeshFormat::kOff, {data, size});
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  static constexpr std::string_view kWords[] = {"OFF", "COFF",    "STCNOFF",   "4OFF", "BINARY",
                                                "#",   "3 0 1 2", "4 0 1 2 3", "0 0 0"};
  return veritope::fuzz::mutate(data, size, max_size, seed, kWords, [](veritope::fuzz::Mutator& m) {
    m.pick(3) == 0 ? m.change_line(m.text().size()) : m.change_token(m.text().size());
  });
}
