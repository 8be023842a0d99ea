// SPDX-License-Identifier: LGPL-3.0-or-later
// io/points/npy_header.h: the header of NumPy's .npy files with points.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "predicates/vec.h"
#include "robust/base/result.h"

namespace veritope {

struct NpyHeader {
  std::size_t num_bytes = 0;  ///< of the header; the rows follow
  std::uint64_t num_points = 0;
  bool is_double = true;  ///< false: binary32
  bool is_big_endian = false;
  std::size_t row_bytes() const { return is_double ? 24 : 12; }
};

/// Whether the bytes begin like an .npy file.
bool looks_like_npy(std::span<const unsigned char> bytes);
/// The most bytes that a header may have here.
inline constexpr std::size_t kMostNpyHeader = std::size_t{1} << 16;

/// Reads the header of a file whose first bytes are given: all of them, or kMostNpyHeader.
/// @error kSyntax if it is no header; kForeignFormat for arrays that are not (n, 3) of float64 or float32 in C order
Result<NpyHeader> read_npy_header(std::span<const unsigned char> bytes);

/// A row: three numbers, which may be NaN or infinite.
Vec3d npy_row(const NpyHeader& header, const unsigned char* row);

}  // namespace veritope
