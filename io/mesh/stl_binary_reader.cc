// SPDX-License-Identifier: LGPL-3.0-or-later
// io/mesh/stl_binary_reader.cc: reading rule v1, section 2, binary.
#include <array>
#include <bit>
#include <cmath>

#include "io/base/scan.h"
#include "io/mesh/stl_reader.h"

namespace veritope {
namespace {

std::array<float, 9> load_corners(const char* facet) {
  std::array<float, 9> values;
  std::memcpy(values.data(), facet + 12, sizeof values);  // after the normal
  return values;
}

// The largest biased exponent means NaN or infinity.
bool is_finite(float value) {
  return (std::bit_cast<std::uint32_t>(value) & 0x7F800000) != 0x7F800000;
}

Error not_finite(const Source& source, const char* facet) {
  const std::array<float, 9> values = load_corners(facet);
  std::size_t i = 0;
  while (is_finite(values[i])) ++i;
  const char* const word = std::isnan(values[i]) ? "NaN" : (values[i] > 0 ? "inf" : "-inf");
  const std::uint64_t index = (source.offset(facet) - kStlHeader) / kStlFacet;
  Error error = error_at_byte(source, facet + 12 + 4 * i, Code::kNotFinite,
                              std::string("the coordinate is ") + word);
  error.place.face = index;
  return error;
}

Status check_size(const Source& source, const ReadLimits& limits) {
  if (source.size() < kStlHeader) {
    return error_at_byte(source, source.end, Code::kTruncated,
                         "neither ASCII (no word 'solid') nor the 84 bytes of a binary header");
  }
  const std::uint64_t num = (stl_binary_size(source) - kStlHeader) / kStlFacet;
  if (source.size() < stl_binary_size(source)) {
    return error_at_byte(source, source.end, Code::kTruncated,
                         std::to_string(num) + " facets announced, but there is room for " +
                             std::to_string((source.size() - kStlHeader) / kStlFacet));
  }
  const char* const count = source.begin + kStlHeader - 4;
  if (num == 0)
    return error_at_byte(
        source, count, Code::kEmpty,
        source.size() == kStlHeader ? "there is no facet" : "the header announces no facet");
  if (num > std::min(limits.max_faces, kMaxVertices / 3)) {
    return error_at_byte(source, count, Code::kOverLimit,
                         over_limit("faces", "--max-faces", limits.max_faces));
  }
  return ok_status();
}

// Bytes that are not a whole number of facets are as likely padding as a sign of a wrong count.
void notice_facets(std::uint64_t bytes, std::uint64_t stated, ReadReport& report) {
  if (bytes == 0 || bytes % kStlFacet != 0) return;
  const std::uint64_t more = bytes / kStlFacet;
  report.notices.push_back(
      {"data-after-end",
       std::to_string(more) + (more == 1 ? " more facet follows" : " more facets follow") +
           " the stated " + std::to_string(stated) + ": the count may be wrong"});
}

}  // namespace

Result<ParsedMesh> read_stl_binary(const Source& source, const ReadLimits& limits) {
  if (const Status size = check_size(source, limits); !size) return size.error();
  const char* facet = source.begin + kStlHeader;
  const char* const end = source.begin + stl_binary_size(source);
  const auto num = static_cast<std::size_t>(end - facet) / kStlFacet;
  CornerSink sink;
  sink.reserve(num);
  std::uint64_t attributes = 0;
  while (facet < end) {
    std::array<Vec3d, CornerSink::kBatch> corners;
    std::size_t filled = 0;
    for (; facet < end && filled < corners.size(); facet += kStlFacet) {
      const std::array<float, 9> v = load_corners(facet);
      bool finite = true;
      for (const float value : v) finite &= is_finite(value);
      if (!finite) return not_finite(source, facet);
      for (std::size_t i = 0; i < 9; i += 3) {
        // + 0.0 turns -0 into +0.
        corners[filled++] = {v[i] + 0.0, v[i + 1] + 0.0, v[i + 2] + 0.0};
      }
      attributes += facet[48] != 0 || facet[49] != 0 ? 1 : 0;
    }
    sink.add({corners.data(), filled});
  }
  ParsedMesh parsed;
  parsed.mesh = sink.take();
  parsed.report.variant = "stl-binary";
  parsed.report.file_vertices = parsed.mesh.positions.size();
  IgnoredCounts ignored;
  ignored.add("normals", num);
  ignored.add("non-zero attributes", attributes);
  ignored.add("bytes behind the last facet", static_cast<std::uint64_t>(source.end - end));
  parsed.report.ignored = ignored.take();
  notice_facets(static_cast<std::uint64_t>(source.end - end), num, parsed.report);
  return parsed;
}

}  // namespace veritope
