// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/fast_spline_internal.h: the tables of fast_spline.h and its kernels. A kernel's file is compiled with the
// flags of its instruction set, and so includes nothing that the linker could share with files that must run
// everywhere.
#pragma once
#include <cstddef>
#include <cstdint>

namespace veritope::internal {

/// For rational maps, where the bound is made of the value (docs/bounds/fast_spline.md, 6).
inline constexpr double kFastQuotientRel = 0x1p-52, kFastQuotientSlack = 0x1.00000000001p0,
                        kFastQuotientFloor = 0x1p-1000;

/// One axis: `pieces` cells, breaks[i] <= u < breaks[i + 1] for the binary64 numbers u of cell i, the last one closed.
/// u lies in bucket trunc((u - breaks[0]) * per_bucket), and then in one of the cells
/// first[bucket] .. first[bucket + 1].
struct FastAxis {
  const double* breaks;        // pieces + 1
  const double* origin;        // the cell's begin, rounded down
  const double* rate;          // 1 / its length, to nearest
  const double* slope_scale;   // degree / its length, to nearest
  const std::uint32_t* first;  // buckets + 2
  double per_bucket;
  std::size_t pieces, buckets;
  int degree;
};

/// Lanes of four components, the last ones 0; those of a piece are [block][coefficient][4]. The bounds of a piece are,
/// for each component, that of the value and then those of the partial derivatives by each axis.
struct FastSplineTables {
  FastAxis axis[3];
  const double* coefficients;
  const double* bounds;
  const double*
      inverse_weight;  // upper bounds of 1 / w, one for each piece; null for polynomial maps
  std::size_t num_coefficients;  // of a piece and component
  int num_components;            // includes the weight, which is the last one

  bool is_rational() const { return inverse_weight != nullptr; }
  std::size_t dimension() const {
    return static_cast<std::size_t>(num_components) - (is_rational() ? 1 : 0);
  }
  /// The number of blocks of four components each, the last block filled up.
  std::size_t num_blocks() const { return (static_cast<std::size_t>(num_components) + 3) / 4; }
};

/// out: as in fast_spline.h; null where not wanted.
struct FastOut {
  double* value;
  double* value_bound;
  double* partial;
  double* partial_bound;
};

using FastKernel = void (*)(const FastSplineTables& tables, const double* const* at, std::size_t n,
                            const FastOut& out);
inline constexpr int kFastDegrees = 5;  // unrolled for equal degrees 1 .. 5; entry 0: any degrees
struct FastKernels {
  FastKernel value[3][kFastDegrees + 1];  // [number of axes - 1][degree]
  FastKernel jet[3][kFastDegrees + 1];
};
extern const FastKernels kFastBaseline;
// Null where the compiler cannot generate such code.
const FastKernels* fast_avx2();

}  // namespace veritope::internal
