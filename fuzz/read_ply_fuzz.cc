// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/read_ply_fuzz.cc: any bytes as PLY, in all three encodings.
#include "fuzz/read_laws.h"
#include "fuzz/read_mutator.h"
#include "fuzz/reader_agreement.h"

namespace {

constexpr std::string_view kWords[] = {
    "ply",
    "format ascii 1.0",
    "format binary_little_endian 1.0",
    "format binary_big_endian 1.0",
    "ascii",
    "binary_little_endian",
    "binary_big_endian",
    "comment",
    "obj_info",
    "element",
    "vertex",
    "face",
    "tristrips",
    "property",
    "list",
    "char",
    "uchar",
    "short",
    "ushort",
    "int",
    "uint",
    "float",
    "double",
    "int8",
    "uint8",
    "int16",
    "uint16",
    "int32",
    "uint32",
    "float32",
    "float64",
    "x",
    "y",
    "z",
    "vertex_indices",
    "vertex_index",
    "end_header",
    "element face 1\nproperty list uchar int vertex_indices\n",
    "element other 2\nproperty int a\n",
    "element tristrips 1\nproperty list int int vertex_indices\n",
    "property list uchar float extra\n"};

void change(veritope::fuzz::Mutator& m) {
  const std::size_t end = m.text().find("end_header");
  const std::size_t body = end == std::string::npos ? m.text().size() : end + 11;
  if (m.pick(3) == 0) return m.change_token(std::min(body, m.text().size()));
  if (m.pick(3) == 0) return m.change_line(std::min(body, m.text().size()));
  if (body >= m.text().size()) return m.change_token(m.text().size());
  if (m.text().find("format ascii") != std::string::npos) return m.change_token(m.text().size());
  const std::size_t left = m.text().size() - body;
  const std::size_t sizes[] = {1, 2, 4, 8};
  const std::size_t size = sizes[m.pick(4)];
  if (m.pick(5) == 0) return m.change_block(body + m.pick(left), size);
  m.change_binary(body + m.pick(left), size);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  veritope::fuzz::check_reader(veritope::MeshFormat::kPly, {data, size});
  veritope::fuzz::check_agreement(veritope::MeshFormat::kPly, {data, size});
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  return veritope::fuzz::mutate(data, size, max_size, seed, kWords, change);
}
