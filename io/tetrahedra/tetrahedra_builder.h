// SPDX-License-Identifier: LGPL-3.0-or-later
// io/tetrahedra/tetrahedra_builder.h: points with the numbers that a file gives them, and tetrahedra of these.
#pragma once
#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>

#include "io/tetrahedra/read_tetrahedra.h"
#include "io/tetrahedra/words.h"

namespace veritope {

class TetrahedraBuilder {
 public:
  static constexpr std::uint64_t kMost = std::uint64_t{1} << 24;  ///< points; and tetrahedra

  /// Fails for a number that another point has.
  bool add_point(std::uint64_t number, std::array<Rational, 3> at, Words& words) {
    if (file_.points.size() == kMost)
      return words.fail(Code::kOverLimit, "more than " + std::to_string(kMost) + " points");
    if (!number_.try_emplace(number, static_cast<std::uint32_t>(file_.points.size())).second)
      return words.fail(Code::kSyntax, "a second point has the number " + std::to_string(number));
    file_.points.push_back(std::move(at));
    return true;
  }
  /// Takes four numbers of points, to be resolved when all points are known.
  bool take_tetrahedron(Words& words) {
    if (corners_.size() == kMost)
      return words.fail(Code::kOverLimit, "more than " + std::to_string(kMost) + " tetrahedra");
    std::array<std::uint64_t, 4> corners{};
    for (std::uint64_t& c : corners)
      if (!words.take_integer("a corner", 0, kAny, c)) return false;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (corners[i] == corners[j])
          return words.fail(Code::kSyntax, "a tetrahedron has the corner " +
                                               std::to_string(corners[i]) + " twice");
    corners_.push_back(corners);
    return true;
  }
  void ignore(const std::string& what, std::uint64_t count) {
    if (count > 0) file_.ignored.emplace_back(what, count);
  }
  static constexpr std::uint64_t kAny = ~std::uint64_t{0};

  /// At the end of the file.
  Result<TetrahedraFile> finish(Words& words) {
    if (words.is_failed()) return words.error();
    for (std::size_t t = 0; t < corners_.size(); ++t) {
      TetrahedronCorners out{};
      for (std::size_t k = 0; k < 4; ++k) {
        const auto at = number_.find(corners_[t][k]);
        if (at == number_.end()) {
          words.fail(Code::kIndexOutOfRange,
                     "tetrahedron " + std::to_string(t) + ", counted from 0, has the corner " +
                         std::to_string(corners_[t][k]) + ", the number of no point");
          return words.error();
        }
        out[k] = at->second;
      }
      file_.tetrahedra.push_back(out);
    }
    if (file_.tetrahedra.empty()) {
      words.fail(Code::kEmpty, "the file has no tetrahedron");
      return words.error();
    }
    return std::move(file_);
  }

 private:
  TetrahedraFile file_;
  std::vector<std::array<std::uint64_t, 4>> corners_;
  std::unordered_map<std::uint64_t, std::uint32_t> number_;
};

}  // namespace veritope
