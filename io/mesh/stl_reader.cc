// SPDX-License-Identifier: LGPL-3.0-or-later
// io/mesh/stl_reader.cc: reading rule v1, section 2: which kind of STL it is.
#include "io/mesh/stl_reader.h"

#include "io/base/scan.h"

namespace veritope {
namespace {

bool starts_with_solid(const Source& source) {
  const char* const word = skip_space(skip_byte_order_mark(source), source.end);
  const char* const last = word < source.end ? skip_token(word, kTokenEnd) : word;
  return is_word(std::string_view(word, static_cast<std::size_t>(last - word)), "solid");
}

}  // namespace

bool is_stl_binary(const Source& source) {
  if (source.size() >= kStlHeader && source.size() == stl_binary_size(source)) return true;
  return !starts_with_solid(source);
}

std::uint64_t stl_binary_size(const Source& source) {
  std::uint32_t num;
  std::memcpy(&num, source.begin + kStlHeader - 4, 4);
  return kStlHeader + kStlFacet * num;
}

Result<ParsedMesh> read_stl(const Source& source, const ReadLimits& limits) {
  return is_stl_binary(source) ? read_stl_binary(source, limits) : read_stl_ascii(source, limits);
}

}  // namespace veritope
