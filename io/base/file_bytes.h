// SPDX-License-Identifier: LGPL-3.0-or-later
// io/base/file_bytes.h: a whole file, or standard input, in memory.
#pragma once
#include <cstdint>
#include <string>

#include "io/base/byte_buffer.h"
#include "robust/base/result.h"

namespace veritope {

/// Reads to the end, so a file that grows or shrinks meanwhile is taken as it was read; nothing is mapped.
/// @error kCannotOpen with the reason; for a directory, FIFO, socket or device its name. kOverLimit.
Result<ByteBuffer> read_file_bytes(const std::string& path, std::uint64_t max_bytes);

/// Reads the bytes of an open descriptor, which stays open. `size_hint`: expected bytes, 0 if unknown.
Result<ByteBuffer> read_descriptor(int descriptor, const std::string& name, std::uint64_t size_hint,
                                   std::uint64_t max_bytes);

}  // namespace veritope
