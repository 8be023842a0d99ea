// SPDX-License-Identifier: LGPL-3.0-or-later
// io/mesh/loss.cc: what a file would lose, exactly.
// Claim  x - binary32(x) is a binary64 without rounding: it is a multiple of the last bit of x (or 2^-1074) and no
//        larger than |x|, so 53 bits hold it. Squares and sums are then exact integers times 2^-2148.
#include <cmath>
#include <limits>
#include <utility>

#include "io/mesh/mesh_encoder.h"
#include "io/mesh/stl_reader.h"
#include "io/mesh/vertex_table.h"
#include "robust/binary64.h"
#include "robust/integer.h"

namespace veritope {
namespace {

// x * 2^1074. REQUIRES x finite.
Integer scaled(double x) {
  const Binary64 parts = split(x);
  return Integer(parts.mantissa) << static_cast<std::uint64_t>(parts.exponent - kMinExponent);
}

// Sets the result to |d|^2 * 2^2148.
Integer scaled_square(const Vec3d& d) {
  Integer sum;
  for (int axis = 0; axis < 3; ++axis) {
    const Integer component = scaled(d[axis]);
    sum.add_product(component, component);
  }
  return sum;
}

// The least binary64 whose square is at least square / 2^2148.
double root_rounded_up(const Integer& square) {
  Integer root = floor_sqrt(square);
  if (root * root != square) root += Integer(1);
  const std::uint64_t bits = root.bit_length(), drop = bits > 53 ? bits - 53 : 0;
  root.negate().shift_right(drop).negate();  // rounds up
  return std::ldexp(static_cast<double>(root.to_int64()), static_cast<int>(drop) - 1074);
}

double rounded(double value) {
  const std::optional<float> narrow = to_binary32(value);
  return narrow ? *narrow : std::copysign(std::numeric_limits<double>::infinity(), value);
}

Vec3d rounded(const Vec3d& p) { return {rounded(p.x), rounded(p.y), rounded(p.z)}; }

void measure(const TriangleMesh& mesh, LossReport& report) {
  Integer largest;
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
    Integer square = scaled_square(d);
    if (square <= largest) continue;
    largest = std::move(square);
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
