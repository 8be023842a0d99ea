// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/read_tetrahedra_fuzz.cc: any bytes as tetrahedra of MEDIT and Gmsh, and, cut at the first line with a semicolon,
// as TetGen's two files. Corners that are read are different points of the file; what is refused has a line.
#include <cstdint>
#include <string>

#include "io/base/byte_buffer.h"
#include "io/tetrahedra/read_tetrahedra.h"
#include "robust/base/check.h"

namespace {

using namespace veritope;

void check(const Result<TetrahedraFile>& file) {
  if (!file) {
    VT_CHECK(file.error().place.line.has_value(), "an error without a line");
    return;
  }
  VT_CHECK(!file->tetrahedra.empty(), "a file without tetrahedra");
  for (const TetrahedronCorners& t : file->tetrahedra)
    for (std::size_t i = 0; i < 4; ++i) {
      VT_CHECK(t[i] < file->points.size(), "a corner that is no point");
      for (std::size_t j = 0; j < i; ++j) VT_CHECK(t[i] != t[j], "a corner twice");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string name = "file";
  const ByteBuffer buffer = copy_to_buffer({data, size});
  const Source source = source_of(buffer, name);
  check(read_medit(source, {}));
  check(read_gmsh(source, {}));
  const std::string text(reinterpret_cast<const char*>(data), size);
  const std::size_t cut = text.find(';');
  if (cut == text.npos) return 0;
  const ByteBuffer nodes = copy_to_buffer({data, cut});
  const ByteBuffer elements = copy_to_buffer({data + cut + 1, size - cut - 1});
  check(read_tetgen(source_of(nodes, name), source_of(elements, name), {}));
  return 0;
}
