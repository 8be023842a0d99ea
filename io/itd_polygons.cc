// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/itd_polygons.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/base/decimal.h"
#include "io/mesh/parsed_mesh.h"
#include "io/mesh/vertex_table.h"
#include "io/splines/itd_lexer.h"
#include "verify/format/sha256.h"

namespace veritope {
namespace {

constexpr std::string_view kPolygons = "polygons", kGroups = "groups without splines";
constexpr std::array<std::string_view, 2> kNoBoundary = {"polylines", "point lists"};

struct Polygons {
  std::vector<Vec3d> positions;                     // no two of them equal
  std::vector<std::vector<std::uint32_t>> corners;  // of each polygon, the outside to the left
  IgnoredCounts ignored;
};

// The structure of the file is known to be sound: read_splines read it.
class PolygonReader : ItdLexer {
 public:
  PolygonReader(const Source& source, const ReadLimits& limits)
      : ItdLexer(source, limits), decimals_(limits) {}
  using SplineTextReader::take_error;

  bool read() {
    std::uint64_t depth = 0;  // of objects
    for (;;) {
      if (depth == 0)
        while (p_ < source_.end && *p_ != '[') ++p_;  // comments between objects
      if (is_at_end()) return true;
      if (!read_item(depth)) return false;
    }
  }

  Polygons take() {
    out_.positions.resize(table_.num_positions());
    out_.ignored.add("attributes of polygons", polygon_attributes_);
    out_.ignored.add("attributes of vertices", vertex_attributes_);
    return std::move(out_);
  }

 private:
  bool read_item(std::uint64_t& depth) {
    if (at(']')) {
      ++p_;
      --depth;
      return true;
    }
    if (at('"')) return skip_string();
    if (!at('[')) {  // a name
      p_ += peek().size();
      return true;
    }
    const char* const open = p_++;
    const std::string_view keyword = peek();
    p_ += keyword == "OBJECT" || keyword == "POLYGON" ? keyword.size() : 0;
    if (keyword == "OBJECT") {
      ++depth;
      return true;
    }
    return keyword == "POLYGON" ? read_polygon(open) : skip_brackets();
  }

  // Skips all [...] that are next.
  bool skip_attributes(std::uint64_t& count) {
    for (; at('['); ++count) {
      ++p_;
      if (!skip_brackets()) return false;
    }
    return true;
  }

  bool read_polygon(const char* open) {
    std::uint64_t size = 0;
    if (!skip_attributes(polygon_attributes_)) return false;
    const char* const at_size = p_;
    if (!read_count("a number of corners", 0, bytes_left(), size)) return false;
    if (size < 3)
      return fail(at_size, Code::kSyntax, "a polygon with " + std::to_string(size) + " corners");
    if (num_triangles_ + (size - 2) > limits_.max_faces)
      return fail(open, Code::kOverLimit, over_limit("faces", "--max-faces", limits_.max_faces));
    num_triangles_ += size - 2;
    std::vector<std::uint32_t> corners;
    while (corners.size() < size) {
      corners.emplace_back();
      if (!read_corner(corners.back())) return false;
    }
    // IRIT's polygons turn clockwise as seen from outside.
    std::reverse(corners.begin() + 1, corners.end());
    out_.corners.push_back(std::move(corners));
    return take_bracket(']');
  }

  bool read_corner(std::uint32_t& id) {
    std::array<double, 3> x{};
    if (!take_bracket('[') || !skip_attributes(vertex_attributes_)) return false;
    for (double& value : x)
      if (!read_decimal(value)) return false;
    if (!take_bracket(']')) return false;
    const Vec3d position{x[0] + 0.0, x[1] + 0.0, x[2] + 0.0};  // -0 becomes +0
    if (out_.positions.size() <= table_.num_positions())
      out_.positions.resize(2 * table_.num_positions() + 8);
    table_.insert(std::span(&position, 1), out_.positions.data(), &id);
    return true;
  }

  // The binary64 that is nearest to the decimal.
  bool read_decimal(double& value) {
    const std::string_view token = peek();
    const auto over = [&](std::string_view what, std::string_view flag, std::uint64_t limit) {
      return fail(p_, Code::kOverLimit, over_limit(what, flag, limit) + ": " + quoted(token));
    };
    switch (decimals_.read_slowly(token, value)) {
      case DecimalFault::kNone: p_ += token.size(); return true;
      case DecimalFault::kSyntax: return fail_expected("a decimal number");
      case DecimalFault::kNotFinite:
        return fail(p_, Code::kNotFinite, "the coordinate " + quoted(token) + " is not finite");
      case DecimalFault::kDigits:
        return over("digits in a number", "--max-digits", limits_.max_digits);
      case DecimalFault::kExponent:
        return over("units in an exponent", "--max-exponent", limits_.max_exponent);
    }
    return false;
  }

  const DecimalReader decimals_;
  VertexTable table_;
  Polygons out_;
  std::uint64_t num_triangles_ = 0, polygon_attributes_ = 0, vertex_attributes_ = 0;
};

void append(double value, std::string& out) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;  // reads back as this number
  out.append(text, end);
}

std::string off_bytes(const Polygons& polygons) {
  std::string out = "OFF\n" + std::to_string(polygons.positions.size()) + " " +
                    std::to_string(polygons.corners.size()) + " 0\n";
  for (const Vec3d& p : polygons.positions) {
    append(p.x, out);
    append(p.y, out += " ");
    append(p.z, out += " ");
    out += "\n";
  }
  for (const auto& corners : polygons.corners) {
    out += std::to_string(corners.size());
    for (const std::uint32_t id : corners) out += " " + std::to_string(id);
    out += "\n";
  }
  return out;
}

}  // namespace

bool holds_only_polygons(const SplineFile& file) {
  bool has_polygons = false;
  for (const LeftOut& l : file.left_out) {
    has_polygons = has_polygons || l.what == kPolygons;
    const bool bounds_nothing =
        std::find(kNoBoundary.begin(), kNoBoundary.end(), l.what) != kNoBoundary.end();
    if (l.is_geometry && l.what != kPolygons && !bounds_nothing) return false;
  }
  return has_polygons && file.model.entities.empty();
}

Result<MeshFile> read_itd_polygons(const Source& source, const SplineFile& splines,
                                   const ReadLimits& limits) {
  PolygonReader reader(source, limits);
  if (!reader.read()) return reader.take_error();
  Polygons polygons = reader.take();
  for (const LeftOut& l : splines.left_out)
    if (l.what != kPolygons && l.what != kGroups) polygons.ignored.add(l.what, l.count);
  MeshCopy copy;
  copy.bytes = off_bytes(polygons);
  copy.sha256 = to_hex(
      sha256({reinterpret_cast<const unsigned char*>(copy.bytes.data()), copy.bytes.size()}));
  copy.what = "its " + std::to_string(polygons.corners.size()) +
              (polygons.corners.size() == 1 ? " polygon" : " polygons");
  const std::string name = "copy.off";
  const ByteBuffer bytes = copy_to_buffer(
      {reinterpret_cast<const unsigned char*>(copy.bytes.data()), copy.bytes.size()});
  Result<MeshFile> file = read_mesh(MeshFormat::kOff, source_of(bytes, name), limits, false);
  if (!file) return file.error();
  ReadReport& report = file->report;
  report.container = spline_format_name(SplineFormat::kItd);
  report.variant = report.container;
  report.bytes = source.size();
  report.ignored = polygons.ignored.take();
  file->copy = std::move(copy);
  return file;
}

}  // namespace veritope
