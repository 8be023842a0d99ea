// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/dms/read_dms_moves.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "io/splines/spline_json_lexer.h"
#include "solids/dms/dms_knots.h"
#include "solids/dms/dms_validity.h"

namespace veritope {
namespace {

constexpr std::size_t kMaxMoves = std::size_t{1} << 20, kMaxMoveItems = std::size_t{1} << 16;
constexpr std::size_t kMaxNodesOfAxis = 64, kMaxFieldTerms = 16;

struct MoveKind {
  std::string_view name;
  std::array<std::string_view, 6> keys;
};
constexpr std::array<MoveKind, 5> kMoveKinds{
    {{"control", {"at", "tetrahedron", "beta", "by", "to"}},
     {"coefficient", {"at", "tetrahedron", "beta", "attribute", "by", "to"}},
     {"knot", {"vertex", "knot", "by", "to"}},
     {"lattice", {"box", "degree", "counts", "nodes"}},
     {"skeleton", {"attribute", "skeletons", "round"}}}};

class DmsMoveReader : SplineJsonLexer {
 public:
  DmsMoveReader(const Source& source, const ReadLimits& limits, const DmsModel& model)
      : SplineJsonLexer(source, limits), model_(model) {}
  using SplineTextReader::take_error;

  bool read() {
    const bool ok = read_list(
        [this] { return is_within(moves_.size() + 1, kMaxMoves, "moves") && read_move(); });
    return ok && (is_at_end() || fail_expected("the end of the file"));
  }
  std::vector<DmsMove> take_moves() { return std::move(moves_); }

 private:
  // What the keys of one move said.
  struct Draft {
    const char* at = nullptr;
    const MoveKind* kind = nullptr;
    std::vector<std::string> keys;
    std::vector<std::uint32_t> vertices, beta;
    std::uint64_t tetrahedron = 0, vertex = 0, knot = 0;
    std::size_t attribute = 0;
    DmsPoint amount;  // a coefficient is its first number
    std::array<DmsPoint, 2> box;
    std::array<std::uint64_t, 3> degree{}, counts{};
    std::vector<DmsLattice::Node> nodes;
    std::vector<const char*> nodes_at;
    std::vector<DmsSkeleton> skeletons;
    std::uint64_t round_bits = 0;

    bool has(std::string_view key) const { return std::ranges::find(keys, key) != keys.end(); }
  };

  bool is_within(std::size_t count, std::size_t most, const char* what) {
    return count <= most ||
           fail(p_, Code::kOverLimit, "more than " + std::to_string(most) + " " + what);
  }
  bool accept(const char* at, const Status& status) {
    return status.has_value() || fail_with(at, status.error());
  }

  bool read_move();
  bool read_kind(Draft& draft);
  bool read_part(const std::string& key, Draft& draft);
  bool require(const Draft& draft, std::initializer_list<std::string_view> keys);
  bool finish(Draft& draft);
  bool finish_lattice(Draft& draft);
  std::optional<std::size_t> find_control_of(const Draft& draft);

  bool read_coordinate(Rational& number) {
    skip();
    const char* const at = p_;
    return read_exact(number) && accept(at, check_dms_number(number));
  }
  bool read_point(DmsPoint& point) {
    return read_counted("a point", 3, [&](std::size_t c) { return read_coordinate(point[c]); });
  }
  bool read_polynomial(std::vector<Rational>& into);
  bool read_attribute(std::size_t& attribute);
  bool read_node(Draft& draft);
  bool read_skeleton(DmsSkeleton& skeleton);
  bool read_polyline(std::vector<DmsPoint>& corners);
  bool read_ellipsoid(DmsEllipsoid& ellipsoid);

  const DmsModel& model_;
  std::vector<DmsMove> moves_;
};

bool DmsMoveReader::read_move() {
  Draft draft;
  skip();
  draft.at = p_;
  const bool ok = read_members([&](const std::string& key, const char* at) {
    if (!draft.kind)
      return key == "move" ? read_kind(draft)
                           : fail(at, Code::kSyntax, "the first key of a move must be 'move'");
    if (key.empty() || std::ranges::find(draft.kind->keys, key) == draft.kind->keys.end())
      return fail(at, Code::kSyntax,
                  "unknown key " + quoted(key) + " of a move of kind " + quoted(draft.kind->name));
    draft.keys.push_back(key);
    return read_part(key, draft);
  });
  if (!ok) return false;
  if (!draft.kind) return fail(draft.at, Code::kSyntax, "the key 'move' is missing");
  return finish(draft);
}

bool DmsMoveReader::read_kind(Draft& draft) {
  skip();
  const char* const at = p_;
  std::string name;
  if (!read_string(name)) return false;
  for (const MoveKind& kind : kMoveKinds)
    if (kind.name == name) draft.kind = &kind;
  return draft.kind != nullptr ||
         fail(at, Code::kSyntax,
              "a move must be 'control', 'coefficient', 'knot', 'lattice' or 'skeleton', not " +
                  quoted(name));
}

bool DmsMoveReader::read_part(const std::string& key, Draft& draft) {
  const auto naturals = [&](const char* what, std::size_t count, std::uint64_t most, auto take,
                            std::uint64_t least = 0) {
    return read_counted(what, count, [&](std::size_t) {
      std::uint64_t n = 0;
      return read_natural(what, most, n, least) && (take(n), true);
    });
  };
  const auto into = [](std::vector<std::uint32_t>& list) {
    return [&list](std::uint64_t n) { list.push_back(static_cast<std::uint32_t>(n)); };
  };
  if (key == "at")
    return naturals("the place of a control point", static_cast<std::size_t>(model_.degree),
                    kMaxDmsVertices - 1, into(draft.vertices));
  if (key == "beta") return naturals("beta", 4, kMaxDmsDegree, into(draft.beta));
  if (key == "tetrahedron")
    return read_natural("a tetrahedron", model_.tetrahedra.size() - 1, draft.tetrahedron);
  if (key == "vertex") return read_natural("a vertex", model_.clouds.size() - 1, draft.vertex);
  if (key == "knot") return read_natural("a knot", kMaxDmsDegree, draft.knot);
  if (key == "round") return read_natural("round", kMaxRoundBits, draft.round_bits);
  if (key == "attribute") return read_attribute(draft.attribute);
  if (key == "by" || key == "to")
    return draft.kind->name == "coefficient" ? read_coordinate(draft.amount[0])
                                             : read_point(draft.amount);
  if (key == "box")
    return read_counted("a box", 2, [&](std::size_t i) { return read_point(draft.box[i]); });
  const auto along_axes = [](std::array<std::uint64_t, 3>& numbers) {
    return [&numbers, a = std::size_t{0}](std::uint64_t n) mutable { numbers.at(a++) = n; };
  };
  if (key == "degree")
    return naturals("the degree of a lattice", 3, kMaxDmsDegree, along_axes(draft.degree), 1);
  if (key == "counts")
    return naturals("the counts of a lattice", 3, kMaxNodesOfAxis, along_axes(draft.counts), 2);
  if (key == "nodes") return read_list([&] { return read_node(draft); });
  return read_list([&] {
    return is_within(draft.skeletons.size() + 1, kMaxMoveItems, "skeletons") &&
           read_skeleton(draft.skeletons.emplace_back());
  });
}

bool DmsMoveReader::read_attribute(std::size_t& attribute) {
  skip();
  const char* const at = p_;
  std::string name;
  if (!read_string(name)) return false;
  const auto found = std::ranges::find(model_.attributes, name);
  attribute = static_cast<std::size_t>(found - model_.attributes.begin());
  const auto own = find_attribute(model_, name);
  if (own && own->spline != &model_)
    return fail(at, Code::kIndexOutOfRange,
                "the attribute " + quoted(name) +
                    " has a domain of its own, whose control points are not moved");
  return found != model_.attributes.end() ||
         fail(at, Code::kIndexOutOfRange, "the model has no attribute " + quoted(name));
}

bool DmsMoveReader::read_node(Draft& draft) {
  skip();
  draft.nodes_at.push_back(p_);
  if (!is_within(draft.nodes_at.size(), kMaxMoveItems, "nodes")) return false;
  DmsLattice::Node& node = draft.nodes.emplace_back();
  return read_object({"at", "by"}, [&](std::size_t key) {
    if (key == 1) return read_point(node.by);
    return read_counted("the place of a node", 3, [&](std::size_t a) {
      std::uint64_t n = 0;
      if (!read_natural("a number of a node", kMaxNodesOfAxis - 1, n)) return false;
      node.at[a] = static_cast<std::size_t>(n);
      return true;
    });
  });
}

bool DmsMoveReader::read_polynomial(std::vector<Rational>& into) {
  skip();
  const char* const at = p_;
  const bool ok = read_list([&] {
    return is_within(into.size() + 1, kMaxFieldTerms, "terms of a polynomial") &&
           read_coordinate(into.emplace_back());
  });
  return ok && (!into.empty() || fail(at, Code::kSyntax, "a polynomial has at least one term"));
}

bool DmsMoveReader::read_polyline(std::vector<DmsPoint>& corners) {
  skip();
  const char* const at = p_;
  const bool ok = read_list([&] {
    return is_within(corners.size() + 1, kMaxMoveItems, "points of a polyline") &&
           read_point(corners.emplace_back());
  });
  return ok && (!corners.empty() || fail(at, Code::kSyntax, "a polyline has at least one point"));
}

bool DmsMoveReader::read_ellipsoid(DmsEllipsoid& ellipsoid) {
  skip();
  const char* const at = p_;
  const bool ok = read_object({"centre", "axes"}, [&](std::size_t key) {
    if (key == 0) return read_point(ellipsoid.centre);
    return read_counted("the axes of an ellipsoid", 3,
                        [&](std::size_t a) { return read_point(ellipsoid.axes[a]); });
  });
  if (!ok) return false;
  const auto& a = ellipsoid.axes;
  return dot_product(a[0], cross_product(a[1], a[2])).sign() != Sign::kZero ||
         fail(at, Code::kBadArgument, "the axes of an ellipsoid must not lie in one plane");
}

bool DmsMoveReader::read_skeleton(DmsSkeleton& skeleton) {
  skip();
  const char* const at = p_;
  std::size_t shapes = 0;
  const bool ok = read_object(
      {"over", "under", "weight", "point", "polyline", "ellipsoid"},
      [&](std::size_t key) {
        shapes += key > 2;
        switch (key) {
          case 0: return read_polynomial(skeleton.over);
          case 1: return read_polynomial(skeleton.under);
          case 2: return read_coordinate(skeleton.weight);
          case 3: return read_point(skeleton.shape.emplace<0>(1)[0]);
          case 4: return read_polyline(skeleton.shape.emplace<0>());
          default: return read_ellipsoid(skeleton.shape.emplace<1>());
        }
      },
      4);
  return ok && (shapes == 1 ||
                fail(at, Code::kSyntax,
                     "a skeleton has one of the keys 'point', 'polyline' and 'ellipsoid'"));
}

bool DmsMoveReader::require(const Draft& draft, std::initializer_list<std::string_view> keys) {
  for (const std::string_view key : keys)
    if (!draft.has(key))
      return fail(draft.at, Code::kSyntax, "the key " + quoted(key) + " is missing");
  return true;
}

// The number of the control point that 'at', or 'tetrahedron' and 'beta', name.
std::optional<std::size_t> DmsMoveReader::find_control_of(const Draft& draft) {
  if (!model_.control.is_separate) {
    if (draft.has("tetrahedron") || draft.has("beta")) {
      fail(draft.at, Code::kSyntax, "the model's control points are shared: 'at' names them");
      return std::nullopt;
    }
    if (!require(draft, {"at"})) return std::nullopt;
    auto vertices = draft.vertices;
    std::ranges::sort(vertices);
    const auto found = find_control(model_, vertices);
    if (!found)
      fail(draft.at, Code::kIndexOutOfRange, "no tetrahedron has a control point at 'at'");
    return found;
  }
  if (draft.has("at")) {
    fail(draft.at, Code::kSyntax,
         "the model's control points are separate: 'tetrahedron' and 'beta' name them");
    return std::nullopt;
  }
  if (!require(draft, {"tetrahedron", "beta"})) return std::nullopt;
  TetrahedralIndex beta{};
  int sum = 0;
  for (std::size_t m = 0; m < 4; ++m) sum += beta[m] = static_cast<int>(draft.beta[m]);
  if (sum != model_.degree) {
    fail(draft.at, Code::kIndexOutOfRange,
         "the numbers of 'beta' must add up to " + std::to_string(model_.degree));
    return std::nullopt;
  }
  return control_of(model_, static_cast<std::uint32_t>(draft.tetrahedron), beta);
}

bool DmsMoveReader::finish_lattice(Draft& draft) {
  if (!require(draft, {"box", "degree", "counts", "nodes"})) return false;
  DmsLattice out;
  out.low = std::move(draft.box[0]);
  out.high = std::move(draft.box[1]);
  for (std::size_t a = 0; a < 3; ++a) {
    if (out.high[a] <= out.low[a])
      return fail(draft.at, Code::kBadArgument, "the corners of a box must ascend along each axis");
    if (draft.degree[a] < 1 || draft.degree[a] > kMaxDmsDegree ||
        draft.counts[a] <= draft.degree[a])
      return fail(draft.at, Code::kBadArgument,
                  "a lattice has degrees from 1 to 9, and more nodes than its degree along each "
                  "axis");
    out.degree[a] = static_cast<int>(draft.degree[a]);
    out.counts[a] = static_cast<std::size_t>(draft.counts[a]);
    for (std::size_t i = 0; i < draft.nodes.size(); ++i)
      if (draft.nodes[i].at[a] >= out.counts[a])
        return fail(draft.nodes_at[i], Code::kIndexOutOfRange,
                    "a node has the number " + std::to_string(draft.nodes[i].at[a]) + " of " +
                        std::to_string(out.counts[a]) + " along axis " + std::to_string(a));
  }
  out.nodes = std::move(draft.nodes);
  moves_.emplace_back(std::move(out));
  return true;
}

bool DmsMoveReader::finish(Draft& draft) {
  if (draft.kind->name == "lattice") return finish_lattice(draft);
  if (draft.kind->name == "skeleton") {
    if (!require(draft, {"attribute", "skeletons"})) return false;
    DmsSkeletonMove move{draft.attribute, std::move(draft.skeletons), std::nullopt};
    if (draft.has("round")) move.round_bits = draft.round_bits;
    moves_.emplace_back(std::move(move));
    return true;
  }
  if (draft.has("by") == draft.has("to"))
    return fail(draft.at, Code::kSyntax, "a move has one of the keys 'by' and 'to'");
  const bool is_place = draft.has("to");
  if (draft.kind->name == "knot") {
    if (!require(draft, {"vertex", "knot"})) return false;
    const auto vertex = static_cast<std::uint32_t>(draft.vertex);
    const std::size_t size = model_.clouds[vertex].size();
    if (draft.knot >= size)
      return fail(draft.at, Code::kIndexOutOfRange,
                  "knot " + std::to_string(draft.knot) + " of vertex " + std::to_string(vertex) +
                      ", whose cloud has " + std::to_string(size));
    moves_.emplace_back(DmsKnotMove{
        vertex, static_cast<std::size_t>(draft.knot), {std::move(draft.amount), is_place}});
    return true;
  }
  if (draft.kind->name == "coefficient" && !require(draft, {"attribute"})) return false;
  const auto control = find_control_of(draft);
  if (!control) return false;
  if (draft.kind->name == "control")
    moves_.emplace_back(DmsControlMove{*control, {std::move(draft.amount), is_place}});
  else
    moves_.emplace_back(
        DmsCoefficientMove{*control, draft.attribute, std::move(draft.amount[0]), is_place});
  return true;
}

}  // namespace

Result<std::vector<DmsMove>> read_dms_moves(const Source& source, const ReadLimits& limits,
                                            const DmsModel& model) {
  DmsMoveReader reader(source, limits, model);
  if (!reader.read()) return reader.take_error();
  return reader.take_moves();
}

}  // namespace veritope
