// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fast/fast_dms_internal.h: the rounded tables of fast_dms.h and its kernels. Bounds:
// docs/bounds/fast_dms.md. A kernel's file is compiled with the flags of its instruction set, and so includes nothing
// that the linker could share with files that must run everywhere.
#pragma once
#include <cstddef>
#include <cstdint>

namespace veritope::internal {

/// c[0] + c[1] x + c[2] y + c[3] z in the coordinates of a unit. The value that a kernel computes differs from the
/// exact one by at most error[0], and by error[0] + error[1] if the point was rounded to binary64 numbers, as long as
/// the point is in the box for which the errors were made.
struct FastLinear {
  double c[4];
  double error[2];
};

/// Barycentric coordinates.
struct FastFrame {
  FastLinear lambda[4];
};

/// A simplex spline of degree 1, the length of the fibre over a point: max(0, the least of `upper` functions minus
/// the greatest of 0 and `lower` ones), or 0 unless the last `flat` ones are positive. One of degree 0 has one
/// constant upper function and four flat ones.
struct FastLeaf {
  FastLinear g[5];
  std::uint32_t upper, lower, flat;
};

/// The sum of lambda_m of the frame times the value at place part[m]; place 0 has the value 0.
struct FastNode {
  std::uint32_t frame;
  std::uint32_t part[4];
};

/// A basis function N_γ: the value at `at`, times coefficients that contain d(W_γ); they have the number `number`.
struct FastTop {
  std::uint32_t at, frame, number;
  std::uint32_t part
      [4];  ///< the places of the values that the gradient is made of; one of them if control is shared
};

/// What one tetrahedron's sets of knots add on some region. Places: 0, then those of the leaves, then of the nodes.
struct FastUnit {
  const FastLeaf* leaves;
  const FastFrame* frames;
  const std::uint32_t* leaf_ids;
  const std::uint32_t* frame_ids;
  const FastNode* nodes;
  const FastTop* tops;
  std::size_t num_leaves, num_frames, num_nodes, num_tops;
  /// For each top: 4 (shared) or 1 (separate) times `components` coefficients of the value; 1 or 4 times 3 *
  /// components of the gradient, or null. Weights: one for each top, and one for each part of the gradient. They are
  /// at least d(W_γ) times the greatest control point, in units of the model's.
  const double* value;
  const double* gradient;
  const double* value_weight;
  const double* gradient_weight;
  double origin[3], scale;  ///< local coordinates are (u - origin) * scale
  std::size_t components;
  bool is_separate;
};

/// A tetrahedron among those that may contain a point. Lane m is face m; the fourth lane of points is 0.
struct FastSide {
  double low[4], high[4];  ///< its box; from minus to plus infinity in the fourth lane
  double origin[4], scale;
  double c[4][4];      ///< coefficient i of all four barycentric coordinates
  double error[2][4];  ///< as in FastLinear
};

/// What `find` returns instead of a number of a tetrahedron.
inline constexpr std::uint32_t kFastNowhere = 0xffffffffu, kFastUndecided = 0xfffffffeu,
                               kFastUnmade = 0xfffffffdu;

/// Points, coordinate by coordinate, and sums for each of them.
struct FastPoints {
  const double* at[3];
  double* value;     ///< [point][components]
  double* gradient;  ///< [point][components][3]; null if not wanted
  double*
      error;  ///< [point][2]: of the value and the gradient, in units of the greatest control value
  std::uint8_t* is_open;  ///< not 0 if a sign was not decided
};

struct FastCall {
  double rounded;   ///< 1 if points were rounded, else 0
  double slack;     ///< of the sums: as many 2^-53 as there are roundings
  double* scratch;  ///< fast_scratch_size() numbers, aligned to 32 bytes
};

struct FastDmsKernels {
  /// Adds what the unit adds at the points of the list. The second one leaves errors alone.
  void (*bounded)(const FastUnit&, const FastPoints&, const std::uint32_t* list, std::size_t n,
                  const FastCall&);
  void (*plain)(const FastUnit&, const FastPoints&, const std::uint32_t* list, std::size_t n,
                const FastCall&);
  /// lambda[m][i] of points 0 .. n - 1 by a frame in local coordinates; the arrays have room for n rounded up to four.
  void (*barycentric)(const FastFrame& frame, const double* origin, double scale,
                      const double* const* at, std::size_t n, double* const* lambda);
  /// The points with lambda[m][i] <= high[m] for all m. Returns how many; `list` has room for n + 4.
  std::size_t (*select)(const double* const* lambda, std::size_t n, const double* high,
                        std::uint32_t* list);
  /// The first tetrahedron of the list that certainly contains the point, if those before it certainly do not. Its
  /// place in the list is stored; also that of one whose side is null: kFastUnmade. `at` has four numbers.
  std::uint32_t (*find)(const std::uint32_t* list, std::size_t n, const FastSide* const* sides,
                        const double* at, double rounded, std::size_t* place);
};

inline std::size_t fast_scratch_size(const FastUnit& u) {
  return 4 * (2 * (1 + u.num_leaves + u.num_nodes) + 4 * u.num_frames + 4 * u.components);
}

extern const FastDmsKernels kFastDmsBaseline;
/// Null where the compiler or the processor has no AVX2; the caller asks the processor.
const FastDmsKernels* fast_dms_avx2();

}  // namespace veritope::internal
