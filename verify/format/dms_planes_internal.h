// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/dms_planes_internal.h: lists of planes and of points in certificates about simplex-spline solids.
// Internal to verify/format.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "verify/format/byte_stream.h"
#include "verify/format/dms_certificate.h"

namespace veritope::certificate::internal {

/// A count, or a failure if the bytes left are too few for it.
inline std::uint64_t read_count(ByteReader& r, std::size_t least_size) {
  const std::uint64_t n = r.varint();
  if (r.ok() && n > r.left() / least_size) r.fail();
  return r.ok() ? n : 0;
}
inline void write_planes(ByteWriter& w, const std::vector<DmsPlaneProof>& planes) {
  w.varint(planes.size());
  for (const DmsPlaneProof& plane : planes) {
    for (const Fraction& x : plane.vector) write_fraction(w, x);
    write_fraction(w, plane.number);
  }
}
inline std::vector<DmsPlaneProof> read_planes(ByteReader& r) {
  constexpr std::size_t kLeastBytesOfPlane = 8;
  std::vector<DmsPlaneProof> out(read_count(r, kLeastBytesOfPlane));
  for (DmsPlaneProof& plane : out) {
    for (Fraction& x : plane.vector) x = read_fraction(r);
    plane.number = read_fraction(r);
  }
  return out;
}

}  // namespace veritope::certificate::internal
