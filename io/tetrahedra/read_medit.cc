// SPDX-License-Identifier: LGPL-3.0-or-later
#include <array>
#include <string_view>
#include <utility>

#include "io/tetrahedra/tetrahedra_builder.h"

namespace veritope {
namespace {

// Sections whose items are integers, with the number of these.
struct MeditSection {
  std::string_view name;
  std::uint64_t words;
};
constexpr std::array<MeditSection, 11> kIgnoredSections{{{"Edges", 3},
                                                         {"Triangles", 4},
                                                         {"Quadrilaterals", 5},
                                                         {"Corners", 1},
                                                         {"RequiredVertices", 1},
                                                         {"Ridges", 1},
                                                         {"RequiredEdges", 1},
                                                         {"RequiredTriangles", 1},
                                                         {"Normals", 3},
                                                         {"Tangents", 3},
                                                         {"NormalAtVertices", 2}}};

class MeditReader {
 public:
  MeditReader(const Source& source, const ReadLimits& limits) : words_(source, limits) {}

  Result<TetrahedraFile> read() {
    if (begin())
      while (words_.has_word() && words_.word() != "End" && section()) {
      }
    return builder_.finish(words_);
  }

 private:
  bool begin() {
    if (!words_.has_word() || words_.word() != "MeshVersionFormatted")
      return words_.fail(Code::kSyntax, "the file does not begin with MeshVersionFormatted");
    words_.skip_word();
    std::uint64_t version = 0;
    return words_.take_integer("the version", 1, 4, version);
  }

  bool section() {
    const std::string name(words_.word());
    for (const auto& [unique, is_read] :
         {std::pair{"Vertices", &has_vertices_}, std::pair{"Tetrahedra", &has_tetrahedra_}})
      if (name == unique && std::exchange(*is_read, true))
        return words_.fail(Code::kSyntax, "the file has a second section " + name);
    words_.skip_word();
    std::uint64_t count = 0;
    if (name == "Dimension") return words_.take_integer("the dimension", 3, 3, count);
    if (!is_known(name))
      return words_.fail(Code::kSyntax, "the section " + quoted(name) + " is not known");
    if (!words_.take_integer("the number of items", 0, TetrahedraBuilder::kAny, count))
      return false;
    if (name == "Vertices") return vertices(count);
    if (name == "Tetrahedra") return tetrahedra(count);
    for (const MeditSection& s : kIgnoredSections)
      if (name == s.name) {
        builder_.ignore(name, count);
        for (; count > 0; --count)
          if (!words_.skip_words(s.words)) return false;
      }
    return true;
  }
  static bool is_known(std::string_view name) {
    if (name == "Vertices" || name == "Tetrahedra") return true;
    for (const MeditSection& s : kIgnoredSections)
      if (name == s.name) return true;
    return false;
  }

  bool vertices(std::uint64_t count) {
    for (; count > 0; --count) {
      std::array<Rational, 3> at;
      if (!words_.take_point(at) || !words_.skip_words(1) ||
          !builder_.add_point(++num_points_, std::move(at), words_))
        return false;
    }
    return true;
  }
  bool tetrahedra(std::uint64_t count) {
    for (; count > 0; --count)
      if (!builder_.take_tetrahedron(words_) || !words_.skip_words(1)) return false;
    return true;
  }

  Words words_;
  TetrahedraBuilder builder_;
  std::uint64_t num_points_ = 0;
  bool has_vertices_ = false, has_tetrahedra_ = false;
};

}  // namespace

Result<TetrahedraFile> read_medit(const Source& source, const ReadLimits& limits) {
  return MeditReader(source, limits).read();
}

}  // namespace veritope
