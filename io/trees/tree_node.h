// SPDX-License-Identifier: LGPL-3.0-or-later
// io/trees/tree_node.h: what a tree of volumes holds before anything is built. Format: docs/formats/trees.md.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/splines/spline_model.h"

namespace veritope {

/// What the value of a key is.
enum class TreeValueKind {
  kNumber,    ///< a JSON integer, or a string as in .vjson
  kNumbers,   ///< a list of them
  kPoint,     ///< of three
  kScale,     ///< a number or a point
  kMatrix,    ///< three rows of four
  kCount,     ///< a JSON integer >= 0
  kText,      ///< a string
  kFlag,      ///< true or false
  kShape,     ///< a volume as in .vjson
  kSurface,   ///< a surface as in .vjson, or a node "file"
  kSurfaces,  ///< a list of them
  kSixFaces,  ///< an object of six, u0 to w1, or a list of six
  kRotation,  ///< {"axis", "point", "degrees"}
  kNode,      ///< a node
  kNodes,     ///< a list of them
};

struct TreeKey {
  std::string_view name;
  TreeValueKind kind;
  bool is_required = true;
};

/// The kinds of nodes and their keys.
struct TreeOp {
  std::string_view name;
  std::vector<TreeKey> keys;
};
std::span<const TreeOp> tree_ops();

struct TreeNode;

/// Shared, as values of an incomplete type.
using TreeNodes = std::vector<std::shared_ptr<const TreeNode>>;

struct SurfaceSource {
  std::string pointer;
  std::variant<std::shared_ptr<const TreeNode>, ExactSurface> what;  ///< the node is a "file"
};

struct RotationValue {
  std::array<Rational, 3> axis{}, point{};
  Rational degrees;
};

using TreeValue = std::variant<std::vector<Rational>,  // numbers, points, scales, matrices
                               std::uint64_t,          // counts
                               std::string, bool, ExactVolume, std::vector<SurfaceSource>,
                               RotationValue, TreeNodes>;

struct TreeNode {
  const TreeOp* op = nullptr;
  std::string pointer;  ///< RFC 6901: "/root/of/2"
  std::uint64_t line = 0;
  std::map<std::string, TreeValue, std::less<>> values;

  /// The value of a key, or null if it is not there. REQUIRES the type of the key's kind.
  template <typename T>
  const T* find(std::string_view key) const {
    const auto at = values.find(key);
    return at == values.end() ? nullptr : &std::get<T>(at->second);
  }
  template <typename T>
  const T& at(std::string_view key) const {
    return std::get<T>(values.find(key)->second);
  }
  const Rational& number(std::string_view key) const { return at<std::vector<Rational>>(key)[0]; }
  std::array<Rational, 3> point(std::string_view key) const {
    const auto& v = at<std::vector<Rational>>(key);
    return {v[0], v[1], v[2]};
  }
};

struct TreeFile {
  std::shared_ptr<const TreeNode> root;
  std::uint64_t bytes = 0;
};

}  // namespace veritope
