// SPDX-License-Identifier: LGPL-3.0-or-later
// io/mesh/ply_binary_reader.cc: reading rule v1, section 4, binary bodies.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "io/mesh/ply_reader.h"

namespace veritope {
namespace {

template <typename T>
T load(const char* p, bool is_big) {
  unsigned char bytes[sizeof(T)];
  std::memcpy(bytes, p, sizeof(T));
  if (is_big) std::reverse(bytes, bytes + sizeof(T));
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

std::int64_t load_integer(PlyType type, const char* p, bool is_big) {
  switch (type) {
    case PlyType::kInt8: return load<std::int8_t>(p, is_big);
    case PlyType::kUint8: return load<std::uint8_t>(p, is_big);
    case PlyType::kInt16: return load<std::int16_t>(p, is_big);
    case PlyType::kUint16: return load<std::uint16_t>(p, is_big);
    case PlyType::kInt32: return load<std::int32_t>(p, is_big);
    default: return load<std::uint32_t>(p, is_big);
  }
}

double load_number(PlyType type, const char* p, bool is_big) {
  if (type == PlyType::kFloat32) return load<float>(p, is_big);
  if (type == PlyType::kFloat64) return load<double>(p, is_big);
  return static_cast<double>(load_integer(type, p, is_big));
}

class PlyBinaryReader {
 public:
  PlyBinaryReader(const Source& source, const ReadLimits& limits, const PlyHeader& header)
      : source_(source),
        header_(header),
        p_(header.body),
        is_big_(header.encoding == PlyEncoding::kBigEndian),
        lists_(limits, header.num_vertices) {}

  Result<ParsedMesh> read() {
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;  // its instances have no bytes
      if (!read_element(element)) return std::move(*error_);
    }
    return lists_.finish(source_, header_, std::move(positions_), std::move(normals_), p_);
  }

 private:
  std::uint64_t left() const { return static_cast<std::uint64_t>(source_.end - p_); }

  bool read_element(const PlyElement& element) {
    switch (ply_role(element)) {
      case PlyRole::kVertices: return read_vertices(element);
      case PlyRole::kOther: return skip_element(element);
      default: return read_lists(element);
    }
  }

  bool skip_element(const PlyElement& element) {
    if (!element.has_lists())
      return skip_bytes(element.least_size(header_.encoding), element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (!skip_properties(element, 0, element.properties.size())) return false;
    }
    return true;
  }

  bool skip_bytes(std::uint64_t size, std::uint64_t count) {
    if (count > left() / size) return fail_truncated(size, count);
    p_ += size * count;
    return true;
  }

  bool skip_properties(const PlyElement& element, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const PlyProperty& property = element.properties[i];
      std::uint64_t count = 1;
      if (property.count_type && !read_count(*property.count_type, count)) return false;
      if (!skip_bytes(ply_type_size(property.type), count)) return false;
    }
    return true;
  }

  bool read_count(PlyType type, std::uint64_t& count) {
    const char* const at = p_;
    if (!skip_bytes(ply_type_size(type), 1)) return false;
    const std::int64_t value = load_integer(type, at, is_big_);
    if (value < 0) return fail(at, Code::kSyntax, "a list of length " + std::to_string(value));
    count = static_cast<std::uint64_t>(value);
    return true;
  }

  // Where x, y, z and the normal of an instance are; without a normal only the first three.
  using Places = std::array<const char*, 6>;

  // Finds them in the instance at p_, and moves past it. Lists make their positions differ between instances.
  bool find_places(const PlyElement& element, Places& places) {
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (header_.xyz[axis] == k) places[axis] = p_;
        if (header_.normal && (*header_.normal)[axis] == k) places[3 + axis] = p_;
      }
      if (!skip_properties(element, k, k + 1)) return false;
    }
    return true;
  }

  bool read_vertices(const PlyElement& element) {
    positions_.reserve(element.count);
    const bool has_lists = element.has_lists();
    const std::uint64_t stride = element.least_size(header_.encoding);
    if (!has_lists && element.count > left() / stride) return fail_truncated(stride, element.count);
    Places places{};
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (has_lists || i == 0) {
        if (!find_places(element, places)) return false;
      } else {
        for (std::size_t k = 0; k < (header_.normal ? 6 : 3); ++k) places[k] += stride;
        p_ += stride;
      }
      if (!read_values(element, header_.xyz, places.data(), positions_)) return false;
      if (header_.normal &&
          !read_values(element, header_.normal->data(), places.data() + 3, normals_))
        return false;
    }
    return true;
  }

  // Three numbers, of the properties with these numbers.
  bool read_values(const PlyElement& element, const std::size_t* properties,
                   const char* const* places, std::vector<Vec3d>& out) {
    double values[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      values[axis] = load_number(element.properties[properties[axis]].type, places[axis], is_big_);
      if (!std::isfinite(values[axis])) return fail_not_finite(places[axis], values[axis]);
    }
    // + 0.0 turns -0 into +0.
    out.push_back({values[0] + 0.0, values[1] + 0.0, values[2] + 0.0});
    return true;
  }

  bool read_lists(const PlyElement& element) {
    const std::size_t number = ply_index_list(element);
    const PlyProperty& list = element.properties[number];
    const PlyRole role = ply_role(element);
    if (role == PlyRole::kFaces) lists_.reserve(element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      std::uint64_t length = 0;
      if (!skip_properties(element, 0, number) || !read_count(*list.count_type, length)) {
        return false;
      }
      if (!(role == PlyRole::kFaces && length == 3 ? read_triangle(list.type)
                                                   : read_list(role, list.type, length))) {
        return false;
      }
      if (!skip_properties(element, number + 1, element.properties.size())) return false;
    }
    return true;
  }

  bool read_list(PlyRole role, PlyType type, std::uint64_t length) {
    const char* const at = p_;
    const std::size_t size = ply_type_size(type);
    if (!skip_bytes(size, length)) return false;
    indices_.resize(length);
    for (std::uint64_t k = 0; k < length; ++k) {
      indices_[k] = load_integer(type, at + k * size, is_big_);
    }
    const auto fault = lists_.add(role, indices_);
    return !fault || fail(at, fault->code, fault->message);
  }

  // A fast version of read_list for the usual case.
  bool read_triangle(PlyType type) {
    const char* const at = p_;
    const std::size_t size = ply_type_size(type);
    if (!skip_bytes(size, 3)) return false;
    std::array<std::int64_t, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = load_integer(type, at + k * size, is_big_);
    if (lists_.add_triangle(corners)) return true;
    const auto fault = lists_.add(PlyRole::kFaces, corners);  // names the fault
    return !fault || fail(at, fault->code, fault->message);
  }

  bool fail(const char* at, Code code, std::string message) {
    error_ = error_at_byte(source_, at, code, std::move(message));
    return false;
  }
  bool fail_truncated(std::uint64_t size, std::uint64_t count) {
    return fail(p_, Code::kTruncated,
                std::to_string(count) + " values of " + std::to_string(size) +
                    " bytes should stand here, but only " + std::to_string(left()) +
                    " bytes are left");
  }
  bool fail_not_finite(const char* at, double value) {
    const char* const word = std::isnan(value) ? "NaN" : (value > 0 ? "inf" : "-inf");
    return fail(at, Code::kNotFinite, std::string("the coordinate is ") + word);
  }

  const Source& source_;
  const PlyHeader& header_;
  const char* p_;
  const bool is_big_;
  PlyLists lists_;
  std::vector<Vec3d> positions_, normals_;
  std::vector<std::int64_t> indices_;
  std::optional<Error> error_;
};

}  // namespace

Result<ParsedMesh> read_ply_binary(const Source& source, const ReadLimits& limits,
                                   const PlyHeader& header) {
  return PlyBinaryReader(source, limits, header).read();
}

}  // namespace veritope
