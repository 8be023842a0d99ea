// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/mesh/ply_header.h"

#include <algorithm>
#include <array>

#include "io/base/scan.h"

namespace veritope {
namespace {

struct TypeName {
  std::string_view old_name, new_name;
};
constexpr std::array<TypeName, 8> kTypeNames = {{{"char", "int8"},
                                                 {"uchar", "uint8"},
                                                 {"short", "int16"},
                                                 {"ushort", "uint16"},
                                                 {"int", "int32"},
                                                 {"uint", "uint32"},
                                                 {"float", "float32"},
                                                 {"double", "float64"}}};

std::optional<PlyType> type_from_name(std::string_view name) {
  for (std::size_t i = 0; i < kTypeNames.size(); ++i) {
    if (name == kTypeNames[i].old_name || name == kTypeNames[i].new_name) {
      return static_cast<PlyType>(i);
    }
  }
  return std::nullopt;
}

class HeaderParser {
 public:
  explicit HeaderParser(const Source& source) : source_(source), p_(skip_byte_order_mark(source)) {}

  Result<PlyHeader> parse() {
    if (!read_magic() || !read_format()) return std::move(*error_);
    while (next_line()) {
      if (words_.size() == 1 && words_[0] == "end_header") {
        header_.body = p_;
        return std::move(header_);
      }
      if (!read_line()) return std::move(*error_);
    }
    return std::move(*error_);
  }

 private:
  // The line end after `ply` is the line end of the header.
  bool read_magic() {
    const std::string_view text(p_, static_cast<std::size_t>(source_.end - p_));
    if (!text.starts_with("ply") || text.size() < 4 || !is_eol(text[3])) {
      return fail(p_,
                  "the first line must be 'ply', but there is " + quoted_token(p_, source_.end));
    }
    line_ = p_;
    line_end_ = text.substr(3, text.substr(3).starts_with("\r\n") ? 2 : 1);
    p_ += 3 + line_end_.size();
    return true;
  }

  // Splits the next line that is not empty into words_.
  bool next_line() {
    do {
      if (!split_line()) return false;
    } while (words_.empty());
    return true;
  }

  bool split_line() {
    const std::string_view rest(p_, static_cast<std::size_t>(source_.end - p_));
    const std::size_t length = rest.find(line_end_);
    if (length == rest.npos) {
      line_ = source_.end;
      return fail(source_.end, "the header has no line 'end_header'", Code::kTruncated);
    }
    line_ = p_;
    p_ += length + line_end_.size();
    words_.clear();
    const char* const end = line_ + length;
    if (std::find_if(line_, end, is_eol) != end) {
      return fail(line_, "a line of the header ends otherwise than the first");
    }
    for (const char* q = line_; words_.size() < 8;) {
      while (q < end && is_blank(*q)) ++q;
      if (q == end) break;
      const char* const word = q;
      while (q < end && !is_blank(*q)) ++q;
      words_.emplace_back(word, static_cast<std::size_t>(q - word));
    }
    return true;
  }

  bool read_format() {
    if (!next_line()) return false;
    if (words_.size() != 3 || words_[0] != "format" || words_[2] != "1.0") return fail_line();
    if (words_[1] == "ascii") {
      header_.encoding = PlyEncoding::kAscii;
    } else if (words_[1] == "binary_little_endian") {
      header_.encoding = PlyEncoding::kLittleEndian;
    } else if (words_[1] == "binary_big_endian") {
      header_.encoding = PlyEncoding::kBigEndian;
    } else {
      return fail_line();
    }
    return true;
  }

  bool read_line() {
    const std::string_view keyword = words_[0];
    if (keyword == "comment" || keyword == "obj_info") return ++header_.comments, true;
    if (keyword == "element") return read_element() || fail_line();
    if (keyword == "property") return read_property() || fail_line();
    return fail_line();
  }

  bool read_element() {
    if (words_.size() != 3) return false;
    const char* p = words_[2].data();  // a line end or a blank follows
    const ScannedInteger count = scan_integer(p);
    if (!count.is_valid || p != words_[2].data() + words_[2].size()) return false;
    if (count.is_negative && count.magnitude > 0) return false;
    header_.elements.push_back({std::string(words_[1]), count.magnitude, {}, line_});
    return true;
  }

  bool read_property() {
    if (header_.elements.empty()) return false;
    PlyProperty property;
    const bool is_list = words_.size() == 5 && words_[1] == "list";
    if (!is_list && words_.size() != 3) return false;
    if (is_list) {
      property.count_type = type_from_name(words_[2]);
      if (!property.count_type || !is_ply_integer(*property.count_type)) return false;
    }
    const std::optional<PlyType> type = type_from_name(words_[is_list ? 3 : 1]);
    if (!type) return false;
    property.type = *type;
    property.name = words_.back();
    header_.elements.back().properties.push_back(std::move(property));
    return true;
  }

  bool fail(const char* at, std::string message, Code code = Code::kSyntax) {
    error_ = error_at_line(source_, at, code, std::move(message));
    return false;
  }
  bool fail_line() {
    std::string_view line(line_, static_cast<std::size_t>(p_ - line_));
    line.remove_suffix(line_end_.size());
    return fail(line_, "not a line that may stand here in a PLY header: " + quoted(line));
  }

  const Source& source_;
  const char* p_;
  const char* line_ = nullptr;
  std::string_view line_end_;
  std::vector<std::string_view> words_;
  PlyHeader header_;
  std::optional<Error> error_;
};

}  // namespace

std::size_t ply_type_size(PlyType type) {
  constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

bool is_ply_integer(PlyType type) { return type < PlyType::kFloat32; }

std::optional<std::size_t> PlyElement::find(std::string_view property, bool is_list) const {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < properties.size(); ++i) {
    if (properties[i].name != property || properties[i].count_type.has_value() != is_list) continue;
    if (found) return std::nullopt;
    found = i;
  }
  return found;
}

std::uint64_t PlyElement::least_size(PlyEncoding encoding) const {
  if (encoding == PlyEncoding::kAscii) return 2 * properties.size();
  std::uint64_t size = 0;
  for (const PlyProperty& p : properties) size += ply_type_size(p.count_type.value_or(p.type));
  return size;
}

bool PlyElement::has_lists() const {
  for (const PlyProperty& p : properties) {
    if (p.count_type) return true;
  }
  return false;
}

PlyRole ply_role(const PlyElement& element) {
  if (element.name == "vertex") return PlyRole::kVertices;
  if (element.name == "face") return PlyRole::kFaces;
  if (element.name == "tristrips") return PlyRole::kStrips;
  return PlyRole::kOther;
}

Result<PlyHeader> parse_ply_header(const Source& source) { return HeaderParser(source).parse(); }

}  // namespace veritope
