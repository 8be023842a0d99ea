// SPDX-License-Identifier: LGPL-3.0-or-later
// io/mesh/stl_ascii_reader.cc: reading rule v1, section 2, ASCII.
#include <array>

#include "io/mesh/stl_reader.h"
#include "io/mesh/text_reader.h"

namespace veritope {
namespace {

class StlAsciiReader : TextReader {
 public:
  StlAsciiReader(const Source& source, const ReadLimits& limits)
      : TextReader(source, limits, kTokenEnd) {}

  Result<ParsedMesh> read() {
    p_ = skip_space(skip_byte_order_mark(source_), source_.end);
    while (p_ < source_.end) {
      if (!read_block()) return take_error();
      p_ = skip_space(p_, source_.end);
    }
    flush();
    if (sink_.num_facets() == 0) {
      return error_at_line(source_, source_.end, Code::kEmpty, "the file ends without a facet");
    }
    ParsedMesh parsed;
    IgnoredCounts ignored;
    ignored.add("normals", sink_.num_facets());
    parsed.mesh = sink_.take();
    parsed.report.variant = "stl-ascii";
    parsed.report.file_vertices = parsed.mesh.positions.size();
    parsed.report.ignored = ignored.take();
    return parsed;
  }

 private:
  // Returns true and moves past the token if it is `word`. REQUIRES p_ at a token.
  bool take_word(std::string_view word) {
    const char* const last = skip_token(p_, kTokenEnd);
    if (!is_word(std::string_view(p_, static_cast<std::size_t>(last - p_)), word)) return false;
    p_ = last;
    return true;
  }

  bool expect(const char* word) {
    p_ = skip_space(p_, source_.end);
    return (p_ < source_.end && take_word(word)) ||
           fail_expected(p_, std::string("'") + word + "'");
  }

  // Reads from one `solid` to after the line of its `endsolid`.
  bool read_block() {
    if (!expect("solid")) return false;
    p_ = find_eol(p_);
    for (;;) {
      p_ = skip_space(p_, source_.end);
      if (p_ < source_.end && take_word("endsolid")) break;
      if (p_ >= source_.end || !take_word("facet")) {
        return fail_expected(p_, "'facet' or 'endsolid'");
      }
      if (!read_facet()) return false;
    }
    p_ = find_eol(p_);
    return true;
  }

  // Reads what follows the word `facet`.
  bool read_facet() {
    const char* const facet = p_;
    for (int normal = 0;; ++normal) {  // at most `normal` and three numbers, which are ignored
      p_ = skip_space(p_, source_.end);
      if (p_ < source_.end && take_word("outer")) break;
      if (p_ >= source_.end || normal == 4) return fail_expected(p_, "'outer'");
      p_ = skip_token(p_, kTokenEnd);
    }
    if (!expect("loop")) return false;
    for (int i = 0; i < 3; ++i) {
      if (!(expect("vertex") && read_corner())) return false;
    }
    if (!(expect("endloop") && expect("endfacet"))) return false;
    if (++num_facets_ > std::min(limits_.max_faces, kMaxVertices / 3)) return fail_faces(facet);
    return true;
  }

  bool read_corner() {
    double xyz[3];
    for (double& value : xyz) {
      p_ = skip_space(p_, source_.end);
      if (p_ >= source_.end) return fail_expected(p_, "a decimal number");
      if (!read_decimal(p_, value)) return false;
    }
    if (filled_ == corners_.size()) flush();
    corners_[filled_++] = {xyz[0] + 0.0, xyz[1] + 0.0, xyz[2] + 0.0};
    return true;
  }

  void flush() {
    sink_.add({corners_.data(), filled_});
    filled_ = 0;
  }

  const char* p_ = nullptr;
  CornerSink sink_;
  std::array<Vec3d, CornerSink::kBatch> corners_;
  std::size_t filled_ = 0;
  std::uint64_t num_facets_ = 0;
};

}  // namespace

Result<ParsedMesh> read_stl_ascii(const Source& source, const ReadLimits& limits) {
  return StlAsciiReader(source, limits).read();
}

}  // namespace veritope
