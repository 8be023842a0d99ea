// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fast/fast_dms.h: a simplex-spline solid prepared for many evaluations in binary64, on request with a
// proved bound of every error.  Bound: docs/bounds/fast_dms.md.  Design: docs/design/0092-fast-simplex-splines.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "predicates/vec.h"
#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_model.h"

namespace veritope {

/// The instruction sets of FastDms; every one computes the same bits.
enum class FastDmsBackEnd { kBaseline, kAvx2 };
bool is_available(FastDmsBackEnd back_end);
FastDmsBackEnd widest_fast_dms_back_end();

struct FastDmsOptions {
  bool with_gradient = false;
  /// Tables of a tetrahedron are made when it has met more points than this; these are evaluated exactly. Nothing: 4,
  /// and four times as many for each degree above 3, where tables cost more.
  std::optional<std::size_t> exact_first;
  /// Tables beyond this are forgotten, though never those of the tetrahedron at hand.
  std::size_t max_bytes = std::size_t{1} << 28;
  /// A point whose bound exceeds this times the greatest control value of a component is evaluated exactly.
  double tolerance = 0x1p-41;
  FastDmsBackEnd back_end = widest_fast_dms_back_end();
};

/// Where results go: point after point, and within a point
///   value, value_bound         num_components() numbers
///   gradient, gradient_bound   the derivatives of the first component along x, y and z, then those of the second, ...
/// A pointer is null if its result is not wanted; value is always wanted, bounds only with what they bound.
struct FastDmsOutput {
  double* value = nullptr;
  double* value_bound = nullptr;
  double* gradient = nullptr;
  double* gradient_bound = nullptr;
  std::uint32_t* tetrahedron = nullptr;
};

/// How points were evaluated.
struct FastDmsCounts {
  std::uint64_t fast = 0;
  std::uint64_t pairs = 0;  ///< with pairs of numbers, as a sign was open or the bound too great
  std::uint64_t outside = 0;
  std::uint64_t open_sign = 0;  ///< exactly, as a plane is too near on which a simplex spline jumps
  std::uint64_t wide = 0;       ///< exactly, as the bound was too great
  std::uint64_t unprepared = 0;  ///< exactly: no tables yet, or numbers out of range
  /// Points, counted above, whose tetrahedron was decided exactly, as a face is too near.
  std::uint64_t near_faces = 0;
  std::uint64_t exact() const { return open_sign + wide + unprepared; }
};

/// Claim    |computed - exact| <= bound for each number, and `tetrahedron` is the one of rule H; exact is what
///          DmsEvaluator gives. Numbers of points that are evaluated exactly are the nearest binary64 ones.
/// Without  value_bound, numbers are those that the call with it gives, but for points with a bound over the tolerance.
/// Outside  of the closed domain values are NaN, bounds infinite, and the tetrahedron kNoTetrahedron.
/// Keeps tables of the tetrahedra that were needed, so one thread at a time. Computes to nearest with gradual underflow
/// whatever the caller's control word is; the same bits on every processor.
class FastDms {
 public:
  static constexpr std::uint32_t kNoTetrahedron = 0xffffffffu;
  /// Points whose exact coordinates the nearest binary64 numbers do not have, by their number, ascending.
  using ExactPoints = std::span<const std::pair<std::size_t, DmsPoint>>;

  /// The model must outlive this. REQUIRES a model that validate() accepts, without defects of its domain and clouds
  /// (solids/dms/dms_defects.h).
  explicit FastDms(const DmsModel& model, const FastDmsOptions& options = {});
  ~FastDms();

  std::size_t num_components() const;

  /// The binary64 points; those in `exact` stand for their exact coordinates, of which they are the nearest numbers.
  /// REQUIRES finite coordinates, gradient only with_gradient.
  /// @cost a cubic point with four components takes a microsecond (docs/benchmarks.md) once tables are made
  void evaluate(std::span<const Vec3d> points, const FastDmsOutput& out, ExactPoints exact = {});

  /// The sums over all calls.
  const FastDmsCounts& counts() const;
  /// Simplex splines that may reach into the tetrahedron, its own among them. @cost makes its tables
  std::size_t num_near(std::uint32_t tetrahedron);

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

/// The numbers between which x is if |x - value| <= bound: value - bound and value + bound, rounded outward; infinite
/// for an infinite bound.
std::array<double, 2> enclosure_of(double value, double bound);

}  // namespace veritope
