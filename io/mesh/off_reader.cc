// SPDX-License-Identifier: LGPL-3.0-or-later
// io/mesh/off_reader.cc: reading rule v1, section 5.
#include "io/mesh/parsed_mesh.h"
#include "io/mesh/text_reader.h"

namespace veritope {
namespace {

class OffReader : TextReader {
 public:
  OffReader(const Source& source, const ReadLimits& limits)
      : TextReader(source, limits, kTokenEndOrComment), sink_(limits.max_faces) {}

  Result<ParsedMesh> read() {
    if (!(read_header() && read_vertices() && read_faces())) return take_error();
    ParsedMesh parsed;
    parsed.report.variant = "off";
    parsed.report.file_vertices = num_vertices_;
    parsed.mesh.positions = std::move(positions_);
    take_faces(sink_, parsed);
    ignored_.add("vertex lines with more values", long_vertices_);
    ignored_.add("face lines with more values", long_faces_);
    p_ = skip_space(p_, source_.end);
    ignored_.add("bytes behind the last face", source_.size() - source_.offset(p_));
    parsed.report.ignored = ignored_.take();
    skip_to_token();  // a comment says nothing about the counts
    const std::string faces = num_faces_ == 1 ? " face" : " faces";
    notice_rest(p_ < source_.end ? source_.size() - source_.offset(p_) : 0,
                "the stated " + std::to_string(num_faces_) + faces, parsed.report);
    return parsed;
  }

 private:
  // Moves p_ past blanks, line ends and comments.
  void skip_to_token() {
    for (;;) {
      p_ = skip_space(p_, source_.end);
      if (*p_ != '#') return;  // the padding contains no #
      p_ = find_eol(p_);
    }
  }

  // Moves to the end of the line; true if it passed more than blanks and a comment.
  bool skip_rest() {
    if (is_eol(*p_)) return false;
    p_ = skip_blanks(p_);
    const bool more = !has_class(*p_, kEolClass | kHashClass);
    p_ = find_eol(p_);
    return more;
  }

  bool read_keyword() {
    p_ = skip_byte_order_mark(source_);
    skip_to_token();
    const char* const token = p_;
    p_ = skip_token(p_, ends_);
    std::string_view word(token, static_cast<std::size_t>(p_ - token));
    for (const std::string_view prefix : {"ST", "C", "N"}) {
      if (word.starts_with(prefix)) word.remove_prefix(prefix.size());
    }
    if (word == "OFF") return true;
    if (token >= source_.end) return fail(token, Code::kEmpty, "the file holds no token");
    return fail_expected(token, "the keyword OFF");
  }

  bool read_count(std::uint64_t& count, const char* what) {
    skip_to_token();
    const char* const token = p_;
    if (std::string_view(p_, 6) == "BINARY") {
      return fail(token, Code::kForeignFormat, "binary OFF is not supported");
    }
    ScannedInteger value;
    if (!read_integer(p_, value)) return false;
    if (value.is_negative && value.magnitude > 0) {
      return fail(token, Code::kSyntax,
                  std::string(what) + " is negative: " + quoted_token(token, text_end_));
    }
    count = value.magnitude;
    return true;
  }

  bool read_header() {
    if (!read_keyword()) return false;
    skip_to_token();
    const char* const counts = p_;
    if (!read_count(num_vertices_, "the number of vertices")) return false;
    skip_to_token();
    const char* const second = p_;
    if (!read_count(num_faces_, "the number of faces")) return false;
    p_ = find_eol(p_);
    // The shortest lines are "0 0 0" and "3 0 0 0"; only the last one may lack its line end.
    const std::uint64_t left = source_.size() - source_.offset(p_);
    if (num_vertices_ > left / 6 || num_faces_ > (left - num_vertices_ * 6) / 8) {
      return fail(counts, Code::kTruncated,
                  quoted_token(counts, text_end_) + " vertices and " +
                      quoted_token(second, text_end_) + " faces announced, but only " +
                      std::to_string(left) + " bytes follow");
    }
    if (num_faces_ == 0) return fail(counts, Code::kEmpty, "there is no face");
    if (num_faces_ > limits_.max_faces) return fail_faces(counts);
    if (num_vertices_ > kMaxVertices) return fail_vertices(counts);
    return true;
  }

  bool read_vertices() {
    positions_.resize(num_vertices_);
    for (Vec3d& position : positions_) {
      skip_to_token();
      if (!read_position(p_, position)) return false;
      long_vertices_ += skip_rest() ? 1 : 0;
    }
    return true;
  }

  bool read_faces() {
    sink_.faces.reserve(num_faces_);
    for (std::uint64_t i = 0; i < num_faces_; ++i) {
      if (!read_face()) return false;
    }
    return true;
  }

  bool read_face() {
    skip_to_token();
    const char* const line = p_;
    ScannedInteger size;
    if (!read_integer(p_, size)) return false;
    if (!size.is_below(UINT64_MAX) || size.magnitude < 3) {
      return fail(line, Code::kSyntax, "a face with " + quoted_token(line, text_end_) + " corners");
    }
    std::uint32_t corners[3];
    if (size.magnitude > 3) return read_polygon(size.magnitude);
    for (std::uint32_t& corner : corners) {
      if (!read_corner(corner)) return false;
    }
    long_faces_ += skip_rest() ? 1 : 0;
    return sink_.add_triangle(corners[0], corners[1], corners[2]) || fail_faces(line);
  }

  bool read_polygon(std::uint64_t size) {
    const char* const line = p_;
    corners_.clear();
    for (std::uint64_t i = 0; i < size; ++i) {
      corners_.push_back(0);
      if (!read_corner(corners_.back())) return false;
    }
    long_faces_ += skip_rest() ? 1 : 0;
    return sink_.add_polygon(corners_) || fail_faces(line);
  }

  bool read_corner(std::uint32_t& corner) {
    p_ = skip_blanks(p_);
    const char* const token = p_;
    ScannedInteger index;
    if (!read_integer(p_, index)) return false;
    if (!index.is_below(num_vertices_)) {
      return fail(token, Code::kIndexOutOfRange,
                  "vertex index " + quoted_token(token, text_end_) + ", but there are " +
                      std::to_string(num_vertices_) + " vertices");
    }
    corner = static_cast<std::uint32_t>(index.magnitude);
    return true;
  }

  const char* p_ = nullptr;
  std::uint64_t num_vertices_ = 0;
  std::uint64_t num_faces_ = 0;
  std::vector<Vec3d> positions_;
  std::vector<std::uint32_t> corners_;
  FaceSink sink_;
  IgnoredCounts ignored_;
  std::uint64_t long_vertices_ = 0;
  std::uint64_t long_faces_ = 0;
};

}  // namespace

Result<ParsedMesh> read_off(const Source& source, const ReadLimits& limits) {
  return OffReader(source, limits).read();
}

}  // namespace veritope
