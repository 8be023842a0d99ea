// SPDX-License-Identifier: LGPL-3.0-or-later
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "io/tetrahedra/tetrahedra_builder.h"

namespace veritope {
namespace {

constexpr std::uint64_t kTetrahedron = 4;  // among the types of elements
constexpr std::uint64_t kAny = TetrahedraBuilder::kAny;
// Elements that may accompany tetrahedra and are ignored, with their numbers of nodes: lines, triangles, quadrilaterals
// and points.
constexpr std::array<std::array<std::uint64_t, 2>, 4> kIgnored{{{1, 2}, {2, 3}, {3, 4}, {15, 1}}};

std::optional<std::uint64_t> ignored_nodes(std::uint64_t type) {
  for (const auto& [ignored, nodes] : kIgnored)
    if (ignored == type) return nodes;
  return std::nullopt;
}

class GmshReader {
 public:
  GmshReader(const Source& source, const ReadLimits& limits) : words_(source, limits) {}

  Result<TetrahedraFile> read() {
    if (format())
      while (words_.has_word() && section()) {
      }
    for (const auto& [type, count] : ignored_)
      builder_.ignore("elements of type " + std::to_string(type), count);
    return builder_.finish(words_);
  }

 private:
  bool take_count(const char* what, std::uint64_t& value) {
    return words_.take_integer(what, 0, kAny, value);
  }
  // The first line of a section of version 4.1: blocks, items, and the least and the greatest number of these.
  bool take_header(const char* what, std::uint64_t& blocks, std::uint64_t& items) {
    return take_count("the number of blocks", blocks) && take_count(what, items) &&
           words_.skip_words(2);
  }
  bool agree(const char* items, std::uint64_t announced, std::uint64_t found) {
    return announced == found ||
           words_.fail(Code::kSyntax, "the section announces " + std::to_string(announced) + " " +
                                          items + ", and its blocks have " + std::to_string(found));
  }
  bool expect(std::string_view word) {
    if (!words_.has_word() || words_.word() != word)
      return words_.fail(words_.has_word() ? Code::kSyntax : Code::kTruncated,
                         std::string(word) + " is expected");
    words_.skip_word();
    return true;
  }

  bool format() {
    if (!expect("$MeshFormat")) return false;
    if (words_.has_word() && (words_.word() == "2.2" || words_.word() == "4.1")) {
      is_new_ = words_.word() == "4.1";
      words_.skip_word();
    } else {
      return words_.fail(Code::kForeignFormat, "the version must be 2.2 or 4.1");
    }
    std::uint64_t is_binary = 0;
    if (!words_.take_integer("the type of the file", 0, 1, is_binary)) return false;
    if (is_binary != 0)
      return words_.fail(Code::kForeignFormat, "the file is binary; only text is read");
    return words_.skip_words(1) && expect("$EndMeshFormat");
  }

  bool section() {
    const std::string name(words_.word());
    if (name.size() < 2 || name[0] != '$')
      return words_.fail(Code::kSyntax, "a section is expected, not " + quoted(name));
    words_.skip_word();
    if (name == "$Nodes") return (is_new_ ? new_nodes() : nodes()) && expect("$EndNodes");
    if (name == "$Elements")
      return (is_new_ ? new_elements() : elements()) && expect("$EndElements");
    builder_.ignore("sections " + escaped(name), 1);
    // Names may have blanks and # in them, so lines are skipped whole.
    const std::string end = "$End" + name.substr(1);
    for (;; words_.skip_line()) {
      if (!words_.has_word())
        return words_.fail(Code::kTruncated, "the file ends before " + escaped(end));
      if (words_.word() == end) return words_.skip_words(1);
    }
  }

  bool nodes() {
    std::uint64_t count = 0;
    if (!take_count("the number of nodes", count)) return false;
    for (; count > 0; --count) {
      std::uint64_t number = 0;
      std::array<Rational, 3> at;
      if (!take_count("the number of a node", number) || !words_.take_point(at) ||
          !builder_.add_point(number, std::move(at), words_))
        return false;
    }
    return true;
  }
  bool new_nodes() {
    std::uint64_t blocks = 0, announced = 0, found = 0;
    if (!take_header("the number of nodes", blocks, announced)) return false;
    for (; blocks > 0; --blocks)
      if (!block_of_nodes(found)) return false;
    return agree("nodes", announced, found);
  }
  bool block_of_nodes(std::uint64_t& found) {
    std::uint64_t dimension = 0, parametric = 0, count = 0;
    if (!words_.take_integer("the dimension", 0, 3, dimension) || !words_.skip_words(1) ||
        !words_.take_integer("the flag of parameters", 0, 1, parametric) ||
        !take_count("the number of nodes", count))
      return false;
    found += count;
    std::vector<std::uint64_t> numbers;
    for (std::uint64_t i = 0; i < count; ++i) {
      std::uint64_t number = 0;
      if (!take_count("the number of a node", number)) return false;
      numbers.push_back(number);
    }
    for (const std::uint64_t number : numbers) {
      std::array<Rational, 3> at;
      if (!words_.take_point(at) || !words_.skip_words(parametric * dimension) ||
          !builder_.add_point(number, std::move(at), words_))
        return false;
    }
    return true;
  }

  bool elements() {
    std::uint64_t count = 0;
    if (!take_count("the number of elements", count)) return false;
    for (; count > 0; --count) {
      std::uint64_t type = 0, tags = 0;
      if (!words_.skip_words(1) || !take_type(type) ||
          !words_.take_integer("the number of tags", 0, 1 << 20, tags) ||
          !words_.skip_words(tags) || !take_element(type))
        return false;
    }
    return true;
  }
  bool new_elements() {
    std::uint64_t blocks = 0, announced = 0, found = 0;
    if (!take_header("the number of elements", blocks, announced)) return false;
    for (; blocks > 0; --blocks) {
      std::uint64_t type = 0, count = 0;
      if (!words_.skip_words(2) || !take_type(type) || !take_count("the number of elements", count))
        return false;
      found += count;
      for (; count > 0; --count)
        if (!words_.skip_words(1) || !take_element(type)) return false;
    }
    return agree("elements", announced, found);
  }
  bool take_type(std::uint64_t& type) {
    if (!words_.take_integer("the type of an element", 1, 140, type)) return false;
    if (type == kTetrahedron || ignored_nodes(type)) return true;
    return words_.fail(Code::kForeignFormat,
                       "elements of type " + std::to_string(type) +
                           " are not read; only tetrahedra with four nodes are");
  }
  // Points, lines, triangles and quadrilaterals beside the tetrahedra are ignored.
  bool take_element(std::uint64_t type) {
    if (type == kTetrahedron) return builder_.take_tetrahedron(words_);
    ++ignored_[type];
    return words_.skip_words(*ignored_nodes(type));
  }

  Words words_;
  TetrahedraBuilder builder_;
  bool is_new_ = false;
  std::map<std::uint64_t, std::uint64_t> ignored_;  // for each type
};

}  // namespace

Result<TetrahedraFile> read_gmsh(const Source& source, const ReadLimits& limits) {
  return GmshReader(source, limits).read();
}

const char* tetrahedra_format_name(TetrahedraFormat format) {
  constexpr std::array<const char*, 3> kNames{"tetgen", "medit", "gmsh"};
  return kNames[static_cast<std::size_t>(format)];
}

std::optional<TetrahedraFormat> tetrahedra_format_of(const Source& source) {
  const ReadLimits limits;
  Words words(source, limits);
  if (!words.has_word()) return std::nullopt;
  if (words.word() == "MeshVersionFormatted") return TetrahedraFormat::kMedit;
  if (words.word() == "$MeshFormat") return TetrahedraFormat::kGmsh;
  return std::nullopt;
}

}  // namespace veritope
