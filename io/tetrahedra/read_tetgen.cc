// SPDX-License-Identifier: LGPL-3.0-or-later
#include <array>
#include <utility>

#include "io/tetrahedra/tetrahedra_builder.h"

namespace veritope {
namespace {

constexpr std::uint64_t kMostAttributes = 1 << 20;

bool take_nodes(Words& words, TetrahedraBuilder& builder) {
  std::uint64_t count = 0, dimension = 0, attributes = 0, markers = 0;
  if (!words.take_integer("the number of points", 0, TetrahedraBuilder::kAny, count) ||
      !words.take_integer("the dimension", 3, 3, dimension))
    return false;
  if (words.has_word_in_line() &&
      !words.take_integer("the number of attributes", 0, kMostAttributes, attributes))
    return false;
  if (words.has_word_in_line() && !words.take_integer("the number of markers", 0, 1, markers))
    return false;
  builder.ignore("attributes of points", attributes * count);
  builder.ignore("markers of points", markers * count);
  for (; count > 0; --count) {
    std::uint64_t number = 0;
    std::array<Rational, 3> at;
    if (!words.take_integer("the number of a point", 0, TetrahedraBuilder::kAny, number) ||
        !words.take_point(at) || !words.skip_words(attributes + markers) ||
        !builder.add_point(number, std::move(at), words))
      return false;
  }
  return true;
}

bool take_elements(Words& words, TetrahedraBuilder& builder) {
  std::uint64_t count = 0, corners = 0, attributes = 0;
  if (!words.take_integer("the number of tetrahedra", 0, TetrahedraBuilder::kAny, count) ||
      !words.take_integer("the number of corners", 4, 10, corners))
    return false;
  if (corners != 4)
    return words.fail(Code::kForeignFormat, "tetrahedra have " + std::to_string(corners) +
                                                " nodes; only those with four corners are read");
  if (words.has_word_in_line() &&
      !words.take_integer("the number of attributes", 0, kMostAttributes, attributes))
    return false;
  builder.ignore("attributes of tetrahedra", attributes * count);
  for (; count > 0; --count)
    if (!words.skip_words(1) || !builder.take_tetrahedron(words) || !words.skip_words(attributes))
      return false;
  return true;
}

bool expect_end(Words& words) {
  if (words.has_word())
    words.fail(Code::kSyntax, "the file goes on with " + quoted(words.word()) +
                                  " after what its first line announces");
  return !words.is_failed();
}

}  // namespace

Result<TetrahedraFile> read_tetgen(const Source& nodes, const Source& elements,
                                   const ReadLimits& limits) {
  TetrahedraBuilder builder;
  Words node_words(nodes, limits);
  if (!take_nodes(node_words, builder) || !expect_end(node_words)) return node_words.error();
  Words words(elements, limits);
  if (take_elements(words, builder)) expect_end(words);
  return builder.finish(words);
}

}  // namespace veritope
