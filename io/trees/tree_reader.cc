// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/trees/tree_reader.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "io/splines/spline_json_maps.h"

namespace veritope {
namespace {

class TreeReader : SplineJsonMaps {
 public:
  using SplineJsonMaps::SplineJsonMaps;

  Result<TreeFile> run() {
    if (find_ops() && read_file()) return std::move(file_);
    Error error = take_error();
    if (!path_.empty()) error.message = path_ + ": " + error.message;
    return error;
  }

 private:
  using Numbers = std::vector<Rational>;

  /// The text of "op" in the object that begins at `at`.
  struct Op {
    const char* at;
    std::string name;
  };
  // Passes over all brackets and strings once, so that "op" may follow the keys whose meaning depends on it.
  bool find_ops();
  const std::string* op_at(const char* at) const;

  bool read_file();
  bool read_node(std::shared_ptr<const TreeNode>& out);
  bool read_value(TreeNode& node, const TreeKey& key, TreeValue& value);
  bool read_number(Rational& value);
  bool read_numbers(std::size_t count, Numbers& numbers);
  bool read_matrix(Numbers& numbers);
  bool read_surface(SurfaceSource& surface);
  bool read_surfaces(std::vector<SurfaceSource>& surfaces);
  bool read_six_faces(std::vector<SurfaceSource>& faces);
  bool read_rotation(RotationValue& rotation);
  bool read_nodes(TreeNodes& nodes);

  /// Reads the value of a key or an index, whose name is a part of the pointer in errors.
  template <typename Read>
  bool within(const std::string& name, Read read) {
    const std::size_t length = path_.size();
    path_ += '/' + name;
    if (!read()) return false;
    path_.resize(length);
    return true;
  }
  /// A list of at most `most` items; read(i) reads item i.
  template <typename Read>
  bool read_items(Read read) {
    std::size_t i = 0;
    return read_list([&] {
      const std::size_t at = i++;
      return within(std::to_string(at), [&] { return read(at); });
    });
  }
  const char* here() { return skip(), p_; }

  TreeFile file_;
  std::string path_;
  std::size_t depth_ = 0;
  std::vector<Op> ops_;  // in the order of `at`
};

bool TreeReader::find_ops() {
  struct Frame {
    const char* at;
    bool is_object, expects_key;
  };
  std::vector<Frame> open;
  std::string text;
  const char* const start = p_;
  while (!is_at_end()) {
    const char c = *p_;
    if (c == '"') {
      const bool is_key = !open.empty() && open.back().is_object && open.back().expects_key;
      if (!read_string(text)) return false;
      if (!is_key) continue;
      open.back().expects_key = false;
      if (text != "op" || peek() != ":") continue;
      ++p_;
      if (peek() == "\"" && read_string(text)) ops_.push_back({open.back().at, text});
      continue;
    }
    if (c == '{' || c == '[') open.push_back({p_, c == '{', true});
    if ((c == '}' || c == ']') && !open.empty()) open.pop_back();
    if (c == ',' && !open.empty()) open.back().expects_key = true;
    p_ += peek().size();
  }
  p_ = start;
  std::stable_sort(ops_.begin(), ops_.end(), [](const Op& a, const Op& b) { return a.at < b.at; });
  return true;
}

const std::string* TreeReader::op_at(const char* at) const {
  const auto found = std::lower_bound(ops_.begin(), ops_.end(), at,
                                      [](const Op& op, const char* p) { return op.at < p; });
  return found == ops_.end() || found->at != at ? nullptr : &found->name;
}

bool TreeReader::read_file() {
  const bool ok = read_object({"format", "root"}, [&](std::size_t key) {
    if (key == 1) return within("root", [&] { return read_node(file_.root); });
    return within("format", [&] {
      std::string format;
      const char* const at = here();
      if (!read_string(format)) return false;
      return format == "veritope-tree-1" ||
             fail(at, Code::kUnknownFormat,
                  "the format must be 'veritope-tree-1', not " + quoted(format));
    });
  });
  file_.bytes = source_.size();
  return ok && (is_at_end() || fail_expected("the end of the file"));
}

bool TreeReader::read_node(std::shared_ptr<const TreeNode>& out) {
  const char* const at = here();
  if (peek() != "{") return fail_expected("a node, an object with the key 'op',");
  if (++depth_ > kMaxTreeDepth)
    return fail(at, Code::kOverLimit,
                "nodes are nested more than " + std::to_string(kMaxTreeDepth) + " deep");
  const std::string* const name = op_at(at);
  if (name == nullptr) return fail(at, Code::kSyntax, "the key 'op' is missing, or no string");
  const auto op = std::find_if(tree_ops().begin(), tree_ops().end(),
                               [&](const TreeOp& known) { return known.name == *name; });
  if (op == tree_ops().end()) {
    const bool is_boolean = *name == "union" || *name == "intersection" || *name == "difference" ||
                            *name == "subtraction";
    return within("op", [&] {
      return fail(at, Code::kSyntax,
                  is_boolean ? "Boolean operations of volumes are not built yet: " + quoted(*name)
                             : "unknown op " + quoted(*name));
    });
  }
  const auto node = std::make_shared<TreeNode>();
  node->op = &*op;
  node->pointer = path_;
  node->line = line_of(at);
  const bool ok = read_members([&](const std::string& key, const char* key_at) {
    if (key == "op") {
      std::string again;
      return read_string(again);
    }
    const auto known = std::find_if(op->keys.begin(), op->keys.end(),
                                    [&](const TreeKey& k) { return k.name == key; });
    if (known == op->keys.end())
      return fail(key_at, Code::kSyntax,
                  "unknown key " + quoted(key) + " of op " + quoted(op->name));
    return within(key, [&] { return read_value(*node, *known, node->values[key]); });
  });
  if (!ok) return false;
  for (const TreeKey& key : op->keys)
    if (key.is_required && !node->values.contains(key.name))
      return fail(at, Code::kSyntax,
                  "the key " + quoted(key.name) + " of op " + quoted(op->name) + " is missing");
  --depth_;
  out = node;
  return true;
}

bool TreeReader::read_value(TreeNode& node, const TreeKey& key, TreeValue& value) {
  using enum TreeValueKind;
  const auto numbers = [&](std::size_t count) {
    return read_numbers(count, value.emplace<Numbers>());
  };
  switch (key.kind) {
    case kNumber: return read_number(value.emplace<Numbers>().emplace_back());
    case kNumbers: return numbers(0);
    case kPoint: return numbers(3);
    case kScale:
      return peek() == "[" ? numbers(3) : read_number(value.emplace<Numbers>().emplace_back());
    case kMatrix: return read_matrix(value.emplace<Numbers>());
    case kCount:
      return read_count(std::string(key.name).c_str(), 0, std::uint64_t{1} << 53,
                        value.emplace<std::uint64_t>());
    case kText: return read_string(value.emplace<std::string>());
    case kFlag: return read_bool(value.emplace<bool>());
    case kShape: {
      std::optional<ExactVolume> volume;
      if (!read_map(volume)) return false;
      value.emplace<ExactVolume>(std::move(*volume));
      return true;
    }
    case kSurface: return read_surface(value.emplace<std::vector<SurfaceSource>>().emplace_back());
    case kSurfaces: return read_surfaces(value.emplace<std::vector<SurfaceSource>>());
    case kSixFaces: return read_six_faces(value.emplace<std::vector<SurfaceSource>>());
    case kRotation: return read_rotation(value.emplace<RotationValue>());
    case kNode: return read_node(value.emplace<TreeNodes>().emplace_back());
    case kNodes: return read_nodes(value.emplace<TreeNodes>());
  }
  return fail(p_, Code::kSyntax, "unknown kind of value in " + node.pointer);
}

bool TreeReader::read_number(Rational& value) {
  const char* const at = here();
  const std::string_view token = peek();
  if (token == "\"") return read_exact(value);
  const std::string_view digits = token.starts_with('-') ? token.substr(1) : token;
  const bool is_integer = !digits.empty() && std::all_of(digits.begin(), digits.end(), is_digit) &&
                          (digits == "0" || digits[0] != '0');
  if (!is_integer) return fail_expected("a JSON integer, or a number in quotes,");
  p_ += token.size();
  return read_token(at, token, value, read_exact_number);
}

// A list of `count` numbers; 0: any number of them.
bool TreeReader::read_numbers(std::size_t count, Numbers& numbers) {
  const char* const at = here();
  if (!read_items([&](std::size_t) { return read_number(numbers.emplace_back()); })) return false;
  return count == 0 || numbers.size() == count ||
         fail(at, Code::kSyntax,
              std::to_string(count) + " numbers expected, but there are " +
                  std::to_string(numbers.size()));
}

bool TreeReader::read_matrix(Numbers& numbers) {
  const char* const at = here();
  std::size_t rows = 0;
  const bool ok = read_items([&](std::size_t) {
    ++rows;
    Numbers row;
    if (!read_numbers(4, row)) return false;
    numbers.insert(numbers.end(), row.begin(), row.end());
    return true;
  });
  return ok && (rows == 3 || fail(at, Code::kSyntax,
                                  "three rows of four numbers expected, but there are " +
                                      std::to_string(rows) + " rows"));
}

bool TreeReader::read_surface(SurfaceSource& surface) {
  surface.pointer = path_;
  const char* const at = here();
  if (op_at(at) == nullptr) {
    std::optional<ExactSurface> map;
    if (!read_map(map)) return false;
    surface.what = std::move(*map);
    return true;
  }
  std::shared_ptr<const TreeNode> node;
  if (!read_node(node)) return false;
  if (node->op->name != "file")
    return fail(at, Code::kSyntax,
                "a surface, or a node 'file', expected, but there is " + quoted(node->op->name));
  surface.what = std::move(node);
  return true;
}

bool TreeReader::read_surfaces(std::vector<SurfaceSource>& surfaces) {
  return read_items([&](std::size_t) { return read_surface(surfaces.emplace_back()); });
}

bool TreeReader::read_six_faces(std::vector<SurfaceSource>& faces) {
  const char* const at = here();
  if (peek() == "[") {
    if (!read_surfaces(faces)) return false;
    return faces.size() == 6 ||
           fail(at, Code::kSyntax,
                "six surfaces expected, but there are " + std::to_string(faces.size()));
  }
  faces.resize(6);
  constexpr std::array<const char*, 6> kNames = {"u0", "u1", "v0", "v1", "w0", "w1"};
  return read_object({"u0", "u1", "v0", "v1", "w0", "w1"}, [&](std::size_t key) {
    return within(kNames[key], [&] { return read_surface(faces[key]); });
  });
}

bool TreeReader::read_rotation(RotationValue& rotation) {
  const auto point = [&](std::array<Rational, 3>& to) {
    Numbers numbers;
    if (!read_numbers(3, numbers)) return false;
    std::copy(numbers.begin(), numbers.end(), to.begin());
    return true;
  };
  return read_object({"axis", "point", "degrees"}, [&](std::size_t key) {
    if (key == 0) return within("axis", [&] { return point(rotation.axis); });
    if (key == 1) return within("point", [&] { return point(rotation.point); });
    return within("degrees", [&] { return read_number(rotation.degrees); });
  });
}

bool TreeReader::read_nodes(TreeNodes& nodes) {
  const char* const at = here();
  if (!read_items([&](std::size_t) { return read_node(nodes.emplace_back()); })) return false;
  return !nodes.empty() || fail(at, Code::kSyntax, "at least one node expected");
}

}  // namespace

Result<TreeFile> read_tree(const Source& source, const ReadLimits& limits) {
  return TreeReader(source, limits).run();
}

}  // namespace veritope
