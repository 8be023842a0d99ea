// SPDX-License-Identifier: LGPL-3.0-or-later
// io/mesh/ply_ascii_reader.cc: reading rule v1, section 4, ASCII bodies.
#include "io/mesh/ply_reader.h"
#include "io/mesh/text_reader.h"

namespace veritope {
namespace {

class PlyAsciiReader : TextReader {
 public:
  PlyAsciiReader(const Source& source, const ReadLimits& limits, const PlyHeader& header)
      : TextReader(source, limits, kTokenEnd),
        header_(header),
        p_(header.body),
        lists_(limits, header.num_vertices) {}

  Result<ParsedMesh> read() {
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;  // its instances have no tokens
      const PlyRole role = ply_role(element);
      const bool has_triangles = role == PlyRole::kFaces || role == PlyRole::kStrips;
      const std::size_t list = has_triangles ? ply_index_list(element) : 0;
      for (std::uint64_t i = 0; i < element.count; ++i) {
        const bool is_right = role == PlyRole::kVertices ? read_vertex(element)
                              : role == PlyRole::kOther
                                  ? skip_properties(element, 0, element.properties.size())
                                  : read_list(role, element, list);
        if (!is_right) return take_error();
      }
    }
    return lists_.finish(source_, header_, std::move(positions_), std::move(normals_), p_);
  }

 private:
  bool next_token() {
    p_ = skip_space(p_, source_.end);
    return p_ < source_.end || fail_expected(p_, "a number");
  }

  // Where the value of a property of a vertex goes; null: nowhere.
  double* target(std::size_t property, double* xyz, double* normal) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (header_.xyz[axis] == property) return xyz + axis;
      if (header_.normal && (*header_.normal)[axis] == property) return normal + axis;
    }
    return nullptr;
  }

  bool read_vertex(const PlyElement& element) {
    double xyz[3] = {0, 0, 0}, normal[3] = {0, 0, 0};
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      double* const value = target(i, xyz, normal);
      if (value == nullptr) {
        if (!skip_properties(element, i, i + 1)) return false;
      } else if (!(next_token() && read_decimal(p_, *value))) {
        return false;
      }
    }
    positions_.push_back({xyz[0] + 0.0, xyz[1] + 0.0, xyz[2] + 0.0});
    if (header_.normal) normals_.push_back({normal[0] + 0.0, normal[1] + 0.0, normal[2] + 0.0});
    return true;
  }

  bool skip_properties(const PlyElement& element, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      std::uint64_t num_tokens = 1;
      if (element.properties[i].count_type && !read_count(num_tokens)) return false;
      for (; num_tokens > 0; --num_tokens) {
        if (!next_token()) return false;
        p_ = skip_token(p_, kTokenEnd);
      }
    }
    return true;
  }

  bool read_count(std::uint64_t& count) {
    if (!next_token()) return false;
    const char* const token = p_;
    ScannedInteger value;
    if (!read_integer(p_, value)) return false;
    if (!value.is_below(UINT64_MAX)) {
      return fail(token, Code::kSyntax, "a list of length " + quoted_token(token, text_end_));
    }
    count = value.magnitude;
    const std::uint64_t left = source_.size() - source_.offset(p_);
    if (count > left / 2) {
      return fail(token, Code::kTruncated,
                  "a list of " + std::to_string(count) + " values, but only " +
                      std::to_string(left) + " bytes follow");
    }
    return true;
  }

  bool read_list(PlyRole role, const PlyElement& element, std::size_t number) {
    if (!skip_properties(element, 0, number)) return false;
    std::uint64_t length = 0;
    if (!read_count(length)) return false;
    const char* const list = p_;
    indices_.clear();
    for (; length > 0; --length) {
      if (!read_index()) return false;
    }
    if (const auto fault = lists_.add(role, indices_)) {
      return fail(list, fault->code, fault->message);
    }
    return skip_properties(element, number + 1, element.properties.size());
  }

  bool read_index() {
    if (!next_token()) return false;
    ScannedInteger index;
    if (!read_integer(p_, index)) return false;
    // A value that does not fit is out of range, too.
    const auto size = static_cast<std::int64_t>(
        std::min<std::uint64_t>(index.magnitude, std::uint64_t{INT64_MAX}));
    indices_.push_back(index.is_negative ? -size : size);
    return true;
  }

  const PlyHeader& header_;
  const char* p_;
  PlyLists lists_;
  std::vector<Vec3d> positions_, normals_;
  std::vector<std::int64_t> indices_;
};

}  // namespace

Result<ParsedMesh> read_ply_ascii(const Source& source, const ReadLimits& limits,
                                  const PlyHeader& header) {
  return PlyAsciiReader(source, limits, header).read();
}

}  // namespace veritope
