// SPDX-License-Identifier: LGPL-3.0-or-later
// io/mesh/obj_reader.cc: reading rule v1, section 3.
// A line is first read in place. Only a line with a joint (a backslash before its end) whose meaning may depend on what
// follows is copied without the joint, and read again.
#include <algorithm>

#include "io/mesh/parsed_mesh.h"
#include "io/mesh/text_reader.h"

namespace veritope {
namespace {

class ObjReader : TextReader {
 public:
  ObjReader(const Source& source, const ReadLimits& limits, bool with_normals)
      : TextReader(source, limits, kTokenEndOrComment),
        sink_(limits.max_faces),
        with_normals_(with_normals) {}

  Result<ParsedMesh> read() {
    if (!(read_lines() && check_forward_indices())) return take_error();
    if (sink_.faces.empty()) {
      return error_at_line(source_, source_.end, Code::kEmpty, "the file ends without a face");
    }
    ParsedMesh parsed;
    parsed.report.variant = "obj";
    parsed.report.file_vertices = positions_.size();
    parsed.mesh.positions = std::move(positions_);
    take_faces(sink_, parsed);
    if (largest_normal_ > 0) parsed.normals = std::move(normals_);
    parsed.report.ignored = words_.take(" lines");
    if (long_vertices_ > 0) {
      parsed.report.ignored.emplace_back("v lines with more values", long_vertices_);
    }
    return parsed;
  }

 private:
  enum class Line { kFailed, kUsed, kIgnored };

  bool read_lines() {
    p_ = skip_byte_order_mark(source_);
    while (p_ < source_.end) {
      p_ = skip_blanks(p_);
      if (is_eol(*p_)) {
        ++p_;
      } else if (!read_physical_line()) {
        return false;
      }
    }
    return true;
  }

  bool read_physical_line() {
    const char* const line = p_;
    const Line outcome = read_line();
    p_ = find_eol(p_);
    if (has_joint_before(p_)) {
      if (outcome != Line::kUsed) return read_joined_line(line);
      while (has_joint_before(p_)) p_ = find_eol(skip_eol(p_, source_.end));
      return true;
    }
    if (outcome == Line::kIgnored) count_ignored(line);
    return outcome != Line::kFailed;
  }

  // Whether there is a joint at p_: then what seemed to end the line or a token continues in the next line.
  bool is_at_joint() const { return p_ < text_end_ && is_eol(*p_) && p_[-1] == '\\'; }

  // Whether there is a backslash directly before the line end at `eol`.
  bool has_joint_before(const char* eol) const {
    return eol < source_.end && eol > source_.begin && eol[-1] == '\\';
  }

  // Copies the lines from `line` on without the joints between them, reads the copy, and continues after them.
  bool read_joined_line(const char* line) {
    anchor_ = line;
    joined_.clear();
    const char* eol = find_eol(line);
    for (; has_joint_before(eol); eol = find_eol(line)) {
      joined_.append(line, eol - 1);
      line = skip_eol(eol, source_.end);
    }
    joined_.append(line, eol);
    const std::size_t size = joined_.size();
    joined_.append(ByteBuffer::kPadding, '\n');
    p_ = joined_.data();
    text_end_ = p_ + size;
    p_ = skip_blanks(p_);
    const char* const first = p_;
    const Line outcome = is_eol(*p_) ? Line::kUsed : read_line();
    if (outcome == Line::kIgnored) count_ignored(first);
    p_ = eol;
    text_end_ = source_.end;
    anchor_ = nullptr;
    return outcome != Line::kFailed;
  }

  void count_ignored(const char* line) {
    const char* const last = skip_token(line, ends_);
    words_.add(
        last == line ? "comment" : std::string_view(line, static_cast<std::size_t>(last - line)),
        1);
  }

  // Reads the line at p_, which is not empty, and leaves p_ somewhere in it.
  Line read_line() {
    if (p_[0] == 'v' && is_blank(p_[1])) return used(read_vertex());
    if (p_[0] == 'f' && is_blank(p_[1])) return used(read_face());
    const char* const last = skip_token(p_, ends_);
    const std::string_view word(p_, static_cast<std::size_t>(last - p_));
    if (word == "v") return used(read_vertex());
    if (word == "f" || word == "fo") return used(read_face());
    if (with_normals_ && word == "vn") return used(read_normal());
    return Line::kIgnored;
  }

  static Line used(bool is_right) { return is_right ? Line::kUsed : Line::kFailed; }

  bool read_vertex() {
    const char* const line = p_;
    p_ += 1;
    Vec3d position;
    if (!read_position(p_, position)) return false;
    if (!is_eol(*p_)) {
      p_ = skip_blanks(p_);
      if (*p_ == '\\' && is_eol(p_[1]) && p_ + 1 < text_end_) {
        return fail(p_, Code::kSyntax, "a joint");
      }
      long_vertices_ += has_class(*p_, kEolClass | kHashClass) ? 0 : 1;
    }
    if (positions_.size() >= kMaxVertices) return fail_vertices(line);
    positions_.push_back(position);
    return true;
  }

  bool read_normal() {
    p_ += 2;
    Vec3d normal;
    if (!read_position(p_, normal)) return false;
    if (normals_.values.size() >= kMaxVertices)
      return fail(p_, Code::kOverLimit, "more than 4294967294 normals");
    normals_.values.push_back(normal);
    return true;
  }

  bool read_face() {
    const char* const line = p_;
    p_ = skip_token(p_, ends_);
    corner_normals_.clear();
    std::size_t num = 0;
    for (p_ = skip_blanks(p_); !has_class(*p_, kEolClass | kHashClass); p_ = skip_blanks(p_)) {
      if (num == corners_.size()) corners_.resize(2 * num);
      if (!read_corner(corners_[num++])) return false;
    }
    if (num < 3) {
      return fail(line, Code::kSyntax, "a face with " + std::to_string(num) + " corners");
    }
    if (!sink_.add_polygon({corners_.data(), num})) return fail_faces(line);
    if (with_normals_) add_normals();
    return true;
  }

  // For the fan that FaceSink makes of the polygon.
  void add_normals() {
    const std::vector<std::uint32_t>& n = corner_normals_;
    for (std::size_t i = 1; i + 1 < n.size(); ++i)
      normals_.of_face.push_back({n[0], n[i], n[i + 1]});
  }

  bool read_corner(std::uint32_t& corner) {
    const char* const token = p_;
    const ScannedInteger index = scan_integer(p_);
    const bool ends = has_class(*p_, ends_) || *p_ == '/';
    if (!index.is_valid || !ends || index.num_digits > limits_.max_digits) {
      return fail_integer(token, index);
    }
    const char* const rest = p_;
    if (*p_ == '/') {
      p_ = skip_token(p_, ends_);
      if (is_at_joint()) return fail(token, Code::kSyntax, "a joint");
    }
    if (with_normals_ && !read_corner_normal(token, rest)) return false;
    const std::uint64_t num = positions_.size();
    if (index.magnitude - 1 >= (index.is_negative ? num : kMaxVertices)) {
      return fail_index(token, num);
    }
    corner =
        static_cast<std::uint32_t>(index.is_negative ? num - index.magnitude : index.magnitude - 1);
    if (corner > largest_) {
      largest_ = corner;
      largest_at_ = anchor_ != nullptr ? anchor_ : token;
    }
    return true;
  }

  // The token is v/t/n or v//n; its rest after v ends at p_.
  bool read_corner_normal(const char* token, const char* rest) {
    const char* n = rest < p_ ? std::find(rest + 1, p_, '/') : p_;
    if (n < p_) ++n;
    corner_normals_.push_back(MeshNormals::kNone);
    if (n == p_) return true;
    const ScannedInteger index = scan_integer(n);
    const std::uint64_t num = normals_.values.size();
    if (!index.is_valid || n != p_ || index.num_digits > limits_.max_digits)
      return fail(token, Code::kSyntax,
                  "the number of a normal in " + quoted_token(token, text_end_));
    if (index.magnitude - 1 >= (index.is_negative ? num : kMaxVertices))
      return fail_normal(token, quoted_token(token, text_end_), num);
    const std::uint64_t number = index.is_negative ? num - index.magnitude : index.magnitude - 1;
    corner_normals_.back() = static_cast<std::uint32_t>(number);
    if (number + 1 > largest_normal_) {
      largest_normal_ = number + 1;
      largest_normal_at_ = anchor_ != nullptr ? anchor_ : token;
    }
    return true;
  }

  bool fail_normal(const char* token, const std::string& what, std::uint64_t num) {
    return fail(token, Code::kIndexOutOfRange,
                "the normal of " + what + " (" + std::to_string(num) + " normals)");
  }

  bool fail_index(const char* token, std::uint64_t num) {
    return fail(token, Code::kIndexOutOfRange,
                "vertex index " + quoted_token(token, text_end_) + " (" + std::to_string(num) +
                    " vertices up to here)");
  }

  // Tests indices of vertices that come later in the file than the face: they are known only at the
  // end.
  bool check_forward_indices() {
    if (largest_normal_ > normals_.values.size())
      return fail_normal(largest_normal_at_, std::to_string(largest_normal_),
                         normals_.values.size());
    if (sink_.faces.empty() || largest_ < positions_.size()) return true;
    return fail(largest_at_, Code::kIndexOutOfRange,
                "vertex index " + std::to_string(std::uint64_t{largest_} + 1) + ", but there are " +
                    std::to_string(positions_.size()) + " vertices");
  }

  const char* p_ = nullptr;
  std::vector<Vec3d> positions_;
  std::vector<std::uint32_t> corners_ = std::vector<std::uint32_t>(16);
  FaceSink sink_;
  std::uint32_t largest_ = 0;
  const char* largest_at_ = nullptr;
  bool with_normals_;
  MeshNormals normals_;
  std::vector<std::uint32_t> corner_normals_;  // of the face that is read
  std::uint64_t largest_normal_ = 0;           // counted from 1; 0: no corner has one
  const char* largest_normal_at_ = nullptr;
  std::string joined_;
  IgnoredCounts words_;  ///< first words of ignored lines
  std::uint64_t long_vertices_ = 0;
};

}  // namespace

Result<ParsedMesh> read_obj(const Source& source, const ReadLimits& limits, bool with_normals) {
  return ObjReader(source, limits, with_normals).read();
}

}  // namespace veritope
