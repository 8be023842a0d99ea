// SPDX-License-Identifier: LGPL-3.0-or-later
// io/mesh/ply_check.cc: whether a PLY header announces a mesh, and whether the bytes after it can
// hold that mesh.
#include <array>

#include "io/mesh/parsed_mesh.h"
#include "io/mesh/ply_header.h"

namespace veritope {
namespace {

Error at_element(const Source& source, const PlyElement& element, Code code, std::string message) {
  return error_at_line(source, element.line, code, std::move(message));
}

std::string announced(const PlyElement& element) {
  return std::to_string(element.count) + " instances of " + quoted(element.name) + " announced";
}

Status check_size(const Source& source, const PlyHeader& header) {
  std::uint64_t left = source.size() - source.offset(header.body);
  if (header.encoding == PlyEncoding::kAscii) ++left;  // the last token may end with the file
  for (const PlyElement& element : header.elements) {
    const std::uint64_t size = element.least_size(header.encoding);
    if (size > 0 && element.count > left / size) {
      return at_element(source, element, Code::kTruncated,
                        announced(element) + ", but at most " + std::to_string(left / size) +
                            " fit into the rest of the file");
    }
    left -= element.count * size;
  }
  return ok_status();
}

Status check_limits(const Source& source, const ReadLimits& limits, const PlyHeader& header) {
  for (const PlyElement& element : header.elements) {
    if (ply_role(element) == PlyRole::kFaces && element.count > limits.max_faces) {
      return at_element(source, element, Code::kOverLimit,
                        over_limit("faces", "--max-faces", limits.max_faces));
    }
    if (ply_role(element) == PlyRole::kVertices && element.count > kMaxVertices) {
      return at_element(source, element, Code::kOverLimit,
                        "more than " + std::to_string(kMaxVertices) + " vertices");
    }
  }
  return ok_status();
}

Status check_vertices(const Source& source, const PlyElement& element, PlyHeader& header) {
  constexpr std::array<const char*, 3> kNames = {"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::optional<std::size_t> number = element.find(kNames[axis], false);
    if (!number) {
      return at_element(source, element, Code::kSyntax,
                        std::string("element vertex needs one scalar property ") + kNames[axis]);
    }
    header.xyz[axis] = *number;
  }
  header.num_vertices = element.count;
  return ok_status();
}

Status check_faces(const Source& source, const PlyElement& element) {
  std::size_t num_lists = 0;
  bool is_integer_list = false;
  for (const PlyProperty& property : element.properties) {
    if (!property.count_type) continue;
    if (property.name != "vertex_indices" && property.name != "vertex_index") continue;
    ++num_lists;
    is_integer_list = is_ply_integer(property.type);
  }
  if (num_lists == 1 && is_integer_list) return ok_status();
  return at_element(source, element, Code::kSyntax,
                    "element " + quoted(element.name) +
                        " needs one list of integers vertex_indices (or vertex_index)");
}

}  // namespace

std::size_t ply_index_list(const PlyElement& element) {
  const std::optional<std::size_t> number = element.find("vertex_indices", true);
  return number ? *number : element.find("vertex_index", true).value();
}

Status check_ply_header(const Source& source, const ReadLimits& limits, PlyHeader& header) {
  std::array<int, 4> times{};
  for (const PlyElement& element : header.elements) {
    const PlyRole role = ply_role(element);
    const int count = ++times[static_cast<std::size_t>(role)];
    if (role == PlyRole::kOther) continue;
    if (count > 1) {
      return at_element(source, element, Code::kSyntax, "a second element " + quoted(element.name));
    }
    const Status status = role == PlyRole::kVertices ? check_vertices(source, element, header)
                                                     : check_faces(source, element);
    if (!status) return status;
  }
  if (times[static_cast<std::size_t>(PlyRole::kVertices)] == 0) {
    return error_at_line(source, header.body - 1, Code::kSyntax, "no element vertex is announced");
  }
  if (times[static_cast<std::size_t>(PlyRole::kFaces)] == 0 &&
      times[static_cast<std::size_t>(PlyRole::kStrips)] == 0) {
    return error_at_line(source, header.body - 1, Code::kEmpty,
                         "neither element face nor element tristrips is announced");
  }
  if (const Status fits = check_size(source, header); !fits) return fits;
  return check_limits(source, limits, header);
}

}  // namespace veritope
