// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/read_obj_fuzz.cc: any bytes as OBJ.
#include "fuzz/read_laws.h"
#include "fuzz/read_mutator.h"
#include "fuzz/reader_agreement.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  veritope::fuzz::check_reader(veritope::MeshFormat::kObj, {data, size});
  veritope::fuzz::check_agreement(veritope::MeshFormat::kObj, {data, size});
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  static constexpr std::string_view kWords[] = {"v",       "f",      "fo",    "vn",   "vt",
                                                "#",       "usemtl", "1/1/1", "2//3", "f 1 2 3",
                                                "v 0 0 0", "-1//-1", "g",     "\\\n", "3/1\\\n"};
  return veritope::fuzz::mutate(data, size, max_size, seed, kWords, [](veritope::fuzz::Mutator& m) {
    m.pick(3) == 0 ? m.change_line(m.text().size()) : m.change_token(m.text().size());
  });
}
