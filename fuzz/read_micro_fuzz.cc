// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/read_micro_fuzz.cc: any bytes as a microstructure. What is read keeps all rules and is written in a canonical
// form, which reads back as the same bytes; what is refused has a line.
#include <cstdint>
#include <string>

#include "io/micro/read_micro.h"
#include "io/micro/write_micro.h"
#include "robust/base/check.h"

namespace {

using namespace veritope;

Result<MicroFile> read(std::span<const std::uint8_t> bytes) {
  static const std::string name = "model.vmicro";
  const ByteBuffer buffer = copy_to_buffer(bytes);
  return read_micro(MicroFormat::kMicro, source_of(buffer, name), {});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Result<MicroFile> file = read({data, size});
  if (!file) {
    VT_CHECK(file.error().place.line.has_value(), "an error without a line");
    return 0;
  }
  VT_CHECK(validate(file->micro).has_value(), "what is read breaks a rule");
  const std::string written = write_micro(file->micro);
  const Result<MicroFile> again =
      read({reinterpret_cast<const std::uint8_t*>(written.data()), written.size()});
  VT_CHECK(again.has_value(), "the canonical form is refused");
  VT_CHECK(write_micro(again->micro) == written, "the canonical form changes when it is read");
  return 0;
}
