// SPDX-License-Identifier: LGPL-3.0-or-later
// io/mesh/loss.cc: what a file would lose, exactly.
// Claim  x - binary32(x) is a binary64 without rounding: it is a multiple of the last bit of x (or 2^-1074) and no
//        larger than |x|, so 53 bits hold it. Squares and sums are then exact integers times 2^-2148.
#include <gmp.h>

#include <cmath>
#include <limits>

#include "io/mesh/mesh_encoder.h"
#include "io/mesh/stl_reader.h"
#include "io/mesh/vertex_table.h"

namespace veritope {
namespace {

class BigInt {
 public:
  BigInt() { mpz_init(value_); }
  ~BigInt() { mpz_clear(value_); }
  BigInt(const BigInt&) = delete;
  BigInt& operator=(const BigInt&) = delete;
  mpz_ptr get() { return value_; }

 private:
  mpz_t value_;
};

// x * 2^1074. REQUIRES x finite.
void set_scaled(BigInt& result, double x) {
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  mpz_set_d(result.get(), std::ldexp(mantissa, 53));
  const int shift = exponent - 53 + 1074;
  if (shift >= 0) {
    mpz_mul_2exp(result.get(), result.get(), static_cast<mp_bitcnt_t>(shift));
  } else {
    mpz_tdiv_q_2exp(result.get(), result.get(), static_cast<mp_bitcnt_t>(-shift));  // zeros only
  }
}

// Sets the result to |d|^2 * 2^2148.
void set_square(BigInt& result, const Vec3d& d) {
  BigInt component;
  mpz_set_ui(result.get(), 0);
  for (int axis = 0; axis < 3; ++axis) {
    set_scaled(component, d[axis]);
    mpz_addmul(result.get(), component.get(), component.get());
  }
}

// The least binary64 whose square is at least square / 2^2148.
double root_rounded_up(BigInt& square) {
  BigInt root, rest;
  mpz_sqrtrem(root.get(), rest.get(), square.get());
  if (mpz_sgn(rest.get()) != 0) mpz_add_ui(root.get(), root.get(), 1);
  const auto bits = static_cast<int>(mpz_sizeinbase(root.get(), 2));
  const int drop = bits > 53 ? bits - 53 : 0;
  mpz_cdiv_q_2exp(root.get(), root.get(), static_cast<mp_bitcnt_t>(drop));
  return std::ldexp(mpz_get_d(root.get()), drop - 1074);
}

double rounded(double value) {
  const std::optional<float> narrow = to_binary32(value);
  return narrow ? *narrow : std::copysign(std::numeric_limits<double>::infinity(), value);
}

Vec3d rounded(const Vec3d& p) { return {rounded(p.x), rounded(p.y), rounded(p.z)}; }

void measure(const TriangleMesh& mesh, LossReport& report) {
  BigInt largest, square;
  double safe = 0;  // largest component of a displacement that cannot beat `largest`
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3d &p = mesh.positions[i], q = rounded(p);
    if (p == q) continue;
    ++report.moved_vertices;
    const Vec3d d = {p.x - q.x, p.y - q.y, p.z - q.z};
    const double size = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    if (size <= safe) continue;
    if (std::isinf(size)) {
      report.max_displacement = size;
      report.vertex = static_cast<std::uint32_t>(i);
      safe = size;
      continue;
    }
    set_square(square, d);
    if (mpz_cmp(square.get(), largest.get()) <= 0) continue;
    mpz_swap(square.get(), largest.get());
    report.max_displacement = root_rounded_up(largest);
    report.vertex = static_cast<std::uint32_t>(i);
    // |d| <= sqrt(3) size < 1.7321 size; the product is rounded, 2^-50 pays for that.
    safe = report.max_displacement / 1.7321 * (1 - 0x1p-50);
    if (safe < 0x1p-1000) safe = 0;
  }
  report.coordinates_change = report.moved_vertices > 0;
}

// The mesh that a reader would get from an STL with these positions.
TriangleMesh as_stl(const TriangleMesh& mesh, const std::vector<Vec3d>& positions) {
  CornerSink sink;
  sink.reserve(mesh.faces.size());
  for (const auto& face : mesh.faces) {
    const Vec3d corners[3] = {positions[face[0]], positions[face[1]], positions[face[2]]};
    sink.add(corners);
  }
  return sink.take();
}

}  // namespace

LossReport loss_of(const TriangleMesh& mesh, const WriteOptions& options) {
  LossReport report;
  TriangleMesh after;
  after.positions = mesh.positions;
  if (is_rounding(options)) {
    measure(mesh, report);
    for (Vec3d& p : after.positions) p = rounded(p);
  }
  if (report.coordinates_change) {
    report.merged_vertices = count_distinct_positions(mesh) - count_distinct_positions(after);
  }
  report.indexing_changes = report.merged_vertices > 0;
  if (options.format == MeshFormat::kStl) {
    const TriangleMesh read_back = as_stl(mesh, after.positions);
    report.indexing_changes =
        read_back.faces != mesh.faces || read_back.positions.size() != mesh.positions.size();
  }
  return report;
}

}  // namespace veritope
