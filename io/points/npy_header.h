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
  std::size_t num_columns = 3;  ///< 3, or 2 of points of the plane
  std::size_t row_bytes() const { return num_columns * (is_double ? 8 : 4); }
};

/// Whether the bytes begin like an .npy file.
bool looks_like_npy(std::span<const unsigned char> bytes);
/// The most bytes that a header may have here.
inline constexpr std::size_t kMostNpyHeader = std::size_t{1} << 16;

/// Reads the header of a file whose first bytes are given: all of them, or kMostNpyHeader.
/// @param num_columns  that the array must have: 3 or 2
/// @error kSyntax if it is no header; kForeignFormat for arrays that are not (n, num_columns) of float64 or float32 in
///        C order
Result<NpyHeader> read_npy_header(std::span<const unsigned char> bytes,
                                  std::size_t num_columns = 3);

/// A row: numbers that may be NaN or infinite; z is 0 if there are two.
Vec3d npy_row(const NpyHeader& header, const unsigned char* row);

}  // namespace veritope
