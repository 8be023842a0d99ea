// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/trees/build_tree.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "io/base/source.h"
#include "io/splines/number_budget.h"
#include "io/trees/tree_files_internal.h"
#include "solids/volumes/axis_turn.h"
#include "solids/volumes/boolean_sum.h"
#include "solids/volumes/placed.h"
#include "solids/volumes/primitives.h"
#include "solids/volumes/ruled.h"
#include "solids/volumes/swept.h"

namespace veritope {
namespace {

using Surfaces = std::vector<CellSurface>;

// The pointer of an error: that of the key with which its sentence begins, "radius must be", "path: no", "rotate/axis".
std::string pointer_of(const TreeNode& node, const std::string& sentence) {
  const std::string word = sentence.substr(0, sentence.find_first_of(" :"));
  for (const TreeKey& key : node.op->keys)
    if (key.name == word.substr(0, word.find('/'))) return node.pointer + "/" + word;
  return node.pointer;
}

std::size_t numbers_of(const Cells& cells) {
  std::size_t sum = 0;
  for (const CellVolume& cell : cells) sum += cell.coefficients().size();
  return sum;
}

std::uint64_t bytes_of(const Cells& cells) {
  std::uint64_t sum = 0;
  for (const CellVolume& cell : cells)
    for (const Rational& x : cell.coefficients()) sum += NumberBudget::bytes_of(x);
  return sum;
}

class TreeBuilder {
 public:
  TreeBuilder(const TreeFile& tree, const std::string& name, const LoadSplines& load)
      : name_(name), budget_(tree.bytes), files_(load, budget_) {}

  Result<BuiltTree> run(const TreeNode& root) {
    Result<Cells> cells = build(root);
    if (!cells) return cells.error();
    out_.cells = std::move(*cells);
    out_.num_files = files_.count();
    return std::move(out_);
  }

 private:
  Error at_node(const TreeNode& node, Error error) const {
    if (!error.place.file.empty()) return error;  // of a node below
    constexpr std::size_t kMostText = 400;        // numbers may be long
    const std::string pointer = pointer_of(node, error.message);
    if (error.message.size() > kMostText)
      error.message.replace(kMostText, error.message.npos, "...");
    error.message = pointer + ": " + error.message;
    error.place.file = name_;
    error.place.line = node.line;
    return error;
  }

  Result<Cells> build(const TreeNode& node) {
    ++out_.num_nodes;
    Result<Cells> cells = make(node);
    if (!cells) return at_node(node, cells.error());
    if (cells->size() > kMaxTreeCells)
      return at_node(node, over("more than " + std::to_string(kMaxTreeCells) + " cells"));
    if (const Status fits = check_size(numbers_of(*cells), bytes_of(*cells)); !fits)
      return at_node(node, fits.error());
    return cells;
  }
  Status check_size(std::size_t numbers, std::uint64_t bytes) const {
    if (numbers > kMaxTreeNumbers)
      return over("more than " + std::to_string(kMaxTreeNumbers) + " coefficients");
    return bytes > budget_.left() ? Status(over(budget_.message())) : ok_status();
  }
  static Error over(std::string what) { return {Code::kOverLimit, {}, std::move(what)}; }

  Result<Cells> make(const TreeNode& node) {
    const std::string_view op = node.op->name;
    if (op == "box") return box_cells(node.point("min"), node.point("max"));
    if (op == "cylinder") return cylinder(node);
    if (op == "cone")
      return cone_cells(node.number("bottom"), node.number("top"), node.number("height"));
    if (op == "torus") return torus_cells(node.number("major"), node.number("minor"));
    if (op == "sphere") return sphere(node);
    if (op == "trivariate") return trivariate(node);
    if (op == "file") return files_.volumes(node);
    if (op == "glue") return glue(node);
    if (op == "place") return place(node);
    if (op == "split") return split_cells(node);
    return constructed(node);
  }

  // One cell from surfaces.
  Result<Cells> constructed(const TreeNode& node) {
    Result<Surfaces> surfaces = surfaces_of(node);
    if (!surfaces) return surfaces.error();
    Result<CellVolume> cell = from_surfaces(node, std::move(*surfaces));
    if (!cell) return cell.error();
    return Cells{std::move(*cell)};
  }
  Result<CellVolume> from_surfaces(const TreeNode& node, Surfaces surfaces) {
    const std::string_view op = node.op->name;
    if (op == "extrude") return extruded(surfaces[0], node.point("vector"));
    if (op == "tube") return tube(surfaces[0]);
    if (op == "revolve") return revolve(node, surfaces[0]);
    if (op == "ruled") {
      if (surfaces.size() != 2)
        return bad_argument("surfaces of a ruled volume must be two, not " +
                            std::to_string(surfaces.size()));
      return ruled(surfaces[0], surfaces[1]);
    }
    if (op == "sweep") return sweep(node, std::move(surfaces));
    SixFaces faces = {surfaces[0], surfaces[1], surfaces[2], surfaces[3], surfaces[4], surfaces[5]};
    const bool* const arranges = node.find<bool>("arrange");
    return arranges != nullptr && *arranges ? boolean_sum_in_any_order(faces)
                                            : boolean_sum(std::move(faces));
  }

  static Result<bool> is_one_cell(const TreeNode& node) {
    const auto* const cells = node.find<std::string>("cells");
    if (cells == nullptr || *cells == "one") return cells != nullptr;
    return bad_argument("cells must be 'one', if anything, not " + quoted(*cells));
  }
  static Result<Cells> cylinder(const TreeNode& node) {
    const Result<bool> is_one = is_one_cell(node);
    if (!is_one) return is_one.error();
    return (*is_one ? one_cell_cylinder : cylinder_cells)(node.number("radius"),
                                                          node.number("height"));
  }
  static Result<Cells> sphere(const TreeNode& node) {
    const Result<bool> is_one = is_one_cell(node);
    if (!is_one) return is_one.error();
    return (*is_one ? one_cell_sphere : sphere_cells)(node.number("radius"));
  }

  static Result<Cells> trivariate(const TreeNode& node) {
    const auto& volume = node.at<ExactVolume>("shape");
    if (const Status fits = check_cell_volume(volume); !fits) return fits.error();
    return Cells{volume};
  }

  Result<Surfaces> surfaces_of(const TreeNode& node) {
    const std::vector<SurfaceSource>* sources = nullptr;
    for (const char* const key : {"surface", "surfaces", "sections", "faces"})
      if (const auto* const found = node.find<std::vector<SurfaceSource>>(key)) sources = found;
    Surfaces out;
    std::size_t numbers = 0;
    std::uint64_t bytes = 0;
    for (const SurfaceSource& source : *sources) {
      if (const auto* const map = std::get_if<ExactSurface>(&source.what)) {
        out.push_back(*map);
      } else {
        const TreeNode& file = *std::get<std::shared_ptr<const TreeNode>>(source.what);
        ++out_.num_nodes;
        Result<CellSurface> surface = files_.surface(file);
        if (!surface) return at_node(file, surface.error());
        out.push_back(std::move(*surface));
      }
      if (const Status in = check_cell_surface(out.back()); !in) {
        Error error = in.error();
        error.message = source.pointer + ": " + error.message;
        error.place.file = name_;
        error.place.line = node.line;
        return error;
      }
      for (const Rational& x : out.back().coefficients()) bytes += NumberBudget::bytes_of(x);
      if (const Status fits = check_size(numbers += out.back().coefficients().size(), bytes); !fits)
        return fits.error();
    }
    return out;
  }

  Result<CellVolume> revolve(const TreeNode& node, const CellSurface& surface) {
    const auto* const degrees = node.find<std::vector<Rational>>("degrees");
    const TurnAxis axis{node.point("point"), node.point("axis")};
    const Result<Turn> turn = make_turn(axis.direction, degrees ? (*degrees)[0] : Rational(360));
    if (!turn) return turn.error();
    if (degrees) note_angle(node, turn->degrees, turn->error);
    return revolved(surface, axis, *turn);
  }
  void note_angle(const TreeNode& node, const Rational& degrees, const Rational& error) {
    TreeNote note{node.pointer, std::string(node.op->name), degrees, error, {}, {}};
    out_.notes.push_back(std::move(note));
  }

  static Result<CellVolume> sweep(const TreeNode& node, Surfaces surfaces) {
    const auto& mode = node.at<std::string>("mode");
    if (mode != "interpolate" && mode != "approximate")
      return bad_argument("mode must be 'interpolate' or 'approximate', not " + quoted(mode));
    const auto degree = std::min<std::uint64_t>(node.at<std::uint64_t>("degree"), 1000);
    return swept(std::move(surfaces), node.at<std::vector<Rational>>("parameters"),
                 static_cast<int>(degree),
                 mode == "interpolate" ? SweepMode::kInterpolate : SweepMode::kApproximate);
  }

  Result<Cells> glue(const TreeNode& node) {
    Cells all;
    std::size_t numbers = 0;
    std::uint64_t bytes = 0;
    for (const auto& child : node.at<TreeNodes>("of")) {
      Result<Cells> cells = build(*child);
      if (!cells) return cells.error();
      if (const Status fits = check_size(numbers += numbers_of(*cells), bytes += bytes_of(*cells));
          !fits)
        return fits.error();
      for (CellVolume& cell : *cells) all.push_back(std::move(cell));
    }
    return all;
  }

  Result<Placement> placement_of(const TreeNode& node) {
    const auto* const matrix = node.find<std::vector<Rational>>("matrix");
    const auto* const scale = node.find<std::vector<Rational>>("scale");
    const auto* const rotate = node.find<RotationValue>("rotate");
    const bool translates = node.values.contains("translate");
    if ((matrix != nullptr) == (scale != nullptr || rotate != nullptr || translates))
      return bad_argument(matrix ? "matrix stands alone, without scale, rotate and translate"
                                 : "matrix, scale, rotate or translate is required");
    Placement placement;
    if (matrix) {
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) placement.linear[i][j] = (*matrix)[4 * i + j];
        placement.shift[i] = (*matrix)[4 * i + 3];
      }
    }
    if (scale)
      for (std::size_t i = 0; i < 3; ++i)
        placement.linear[i][i] = (*scale)[scale->size() == 3 ? i : 0];
    if (determinant(placement).sign() == Sign::kZero)
      return bad_argument(matrix ? "matrix is singular: its image is flat" : "scale must not be 0");
    if (rotate) {
      const Result<Rotation> rotation =
          make_rotation({rotate->point, rotate->axis}, rotate->degrees);
      if (!rotation) {
        const bool is_axis = rotate->axis == CellPoint{};
        return bad_argument(is_axis ? "rotate/axis must not be 0" : rotation.error().message);
      }
      placement = after(rotation->placement, placement);
      note_angle(node, rotate->degrees, rotation->error);
    }
    if (translates) placement = after(translation(node.point("translate")), placement);
    return placement;
  }

  Result<Cells> place(const TreeNode& node) {
    const Result<Placement> placement = placement_of(node);
    if (!placement) return placement.error();
    if (node.values.contains("matrix")) {
      TreeNote note{node.pointer, std::string(node.op->name),         {},
                    {},           distance_from_rotation(*placement), determinant(*placement)};
      out_.notes.push_back(std::move(note));
    }
    Result<Cells> cells = build(*node.at<TreeNodes>("of")[0]);
    if (!cells) return cells.error();
    for (CellVolume& cell : *cells) cell = placed(cell, *placement);
    return cells;
  }

  Result<Cells> split_cells(const TreeNode& node) {
    const auto& axis = node.at<std::string>("axis");
    if (axis != "u" && axis != "v" && axis != "w")
      return bad_argument("axis must be 'u', 'v' or 'w', not " + quoted(axis));
    const Result<Cells> cells = build(*node.at<TreeNodes>("of")[0]);
    if (!cells) return cells.error();
    Cells out;
    std::size_t numbers = 0;
    std::optional<Error> whole;  // why the first cell that is not cut stays whole
    for (const CellVolume& cell : *cells) {
      const std::size_t first = out.size();
      const auto parts = split(cell, static_cast<std::size_t>(axis[0] - 'u'), node.number("at"));
      if (parts) {
        out.insert(out.end(), parts.value().begin(), parts.value().end());
      } else {
        if (!whole) whole = parts.error();
        out.push_back(cell);
      }
      for (std::size_t i = first; i < out.size(); ++i) numbers += out[i].coefficients().size();
      if (const Status fits = check_size(numbers, 0); !fits) return fits.error();
    }
    if (out.size() == cells->size()) return *whole;
    return out;
  }

  const std::string& name_;
  NumberBudget budget_;
  TreeFiles files_;
  BuiltTree out_;
};

}  // namespace

Result<BuiltTree> build_tree(const TreeFile& tree, const std::string& name,
                             const LoadSplines& load) {
  return TreeBuilder(tree, name, load).run(*tree.root);
}

SplineModel model_of_cells(const std::vector<CellVolume>& cells) {
  SplineModel model;
  for (const CellVolume& cell : cells) model.entities.push_back({cell, {}, {}, {}});
  return model;
}

}  // namespace veritope
