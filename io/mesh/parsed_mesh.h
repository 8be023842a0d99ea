// SPDX-License-Identifier: LGPL-3.0-or-later
// io/mesh/parsed_mesh.h: what one format's reader returns, and the pieces that the readers share.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/base/source.h"
#include "io/mesh/read_mesh.h"

namespace veritope {

/// Ids are 32-bit numbers, and tables need one more value; the same holds for faces.
inline constexpr std::uint64_t kMaxVertices = 0xFFFFFFFE;

/// Counts by name, in the order of first mention. At most kMost names from the file; later ones are "other".
/// Names are cut and escaped as in quoted(); the suffix comes after them.
class IgnoredCounts {
 public:
  static constexpr std::size_t kMost = 64;
  void add(std::string_view name, std::uint64_t count);
  std::vector<std::pair<std::string, std::uint64_t>> take(std::string_view suffix = "");

 private:
  std::vector<std::pair<std::string, std::uint64_t>> counts_;
};

/// Collects triangles and cuts polygons into fans.
class FaceSink {
 public:
  explicit FaceSink(std::uint64_t max_faces) : max_faces_(std::min(max_faces, kMaxVertices)) {}

  /// False if --max-faces would be exceeded.
  bool add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (faces.size() >= max_faces_) return false;
    faces.push_back({a, b, c});
    if (polygons_split > 0) polygon_of_face.push_back(num_polygons_++);
    return true;
  }
  /// REQUIRES at least three corners. False if --max-faces would be exceeded.
  bool add_polygon(std::span<const std::uint32_t> corners);

  std::vector<std::array<std::uint32_t, 3>> faces;
  std::vector<std::uint32_t> polygon_of_face;  ///< filled from the first split polygon on
  std::uint64_t polygons_split = 0;

 private:
  std::uint64_t max_faces_;
  std::uint32_t num_polygons_ = 0;  ///< counted from the first split polygon on
};

/// Without merging, unless the format is STL. The report lacks bytes, distinct and referenced vertices.
struct ParsedMesh {
  TriangleMesh mesh;
  ReadReport report;
  std::vector<std::uint32_t> polygon_of_face;
  std::optional<MeshNormals> normals;
};

/// If `bytes` of them are left, adds the notice "12 more bytes follow <what>: the count may be
/// wrong".
void notice_rest(std::uint64_t bytes, const std::string& what, ReadReport& report);

/// Moves the sink's content into `parsed`.
void take_faces(FaceSink& sink, ParsedMesh& parsed);

Result<ParsedMesh> read_stl(const Source& source, const ReadLimits& limits);
Result<ParsedMesh> read_obj(const Source& source, const ReadLimits& limits, bool with_normals);
Result<ParsedMesh> read_ply(const Source& source, const ReadLimits& limits, bool with_normals);
Result<ParsedMesh> read_off(const Source& source, const ReadLimits& limits);

}  // namespace veritope
