// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/expression/formula_cells.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include "solids/expression/decision_diagram.h"

namespace veritope {
namespace {

constexpr std::size_t kFewLiterals = 12;
constexpr int kMostHalvings = 24;
constexpr std::size_t kFewVariables = 8;
constexpr std::size_t kMostStoredLiterals = std::size_t{1} << 22;
// Nodes of formulas times their depth: a second or less.
constexpr std::size_t kMostFoldingWork = std::size_t{1} << 28;

// A shorter formula of the same function, if it has few variables.
Formula compact(Formula f) {
  if (f.num_literals() <= kFewLiterals || f.variables().size() > kFewVariables) return f;
  const auto diagram = DecisionDiagram::make(f, std::size_t{1} << 14);
  if (!diagram) return f;
  Formula by_cases = diagram->formula();
  return by_cases.num_literals() < f.num_literals() ? by_cases : f;
}

Box3d box_around(const std::vector<std::uint32_t>& variables,
                 const std::vector<std::shared_ptr<const Operand>>& operands) {
  Box3d out = empty_box();
  for (const std::uint32_t v : variables) {
    const ExactBox<3> box = operands[v]->box();
    add({round_down(box[0].lo), round_down(box[1].lo), round_down(box[2].lo)}, &out);
    add({round_up(box[0].hi), round_up(box[1].hi), round_up(box[2].hi)}, &out);
  }
  return out;
}

bool is_within(const Box3d& box, const Vec3d& p) {
  return is_inside({to_point(p), to_point(p)}, box);
}
bool is_within(const Box3d& box, const ExactPoint& p) {
  for (std::size_t k = 0; k < 3; ++k)
    if (p[k] < Rational::from_double(box.lo[k]) || Rational::from_double(box.hi[k]) < p[k])
      return false;
  return true;
}
bool is_below(const Vec3d& p, std::size_t axis, double middle) {
  return p[static_cast<int>(axis)] <= middle;
}
bool is_below(const ExactPoint& p, std::size_t axis, double middle) {
  return p[axis] <= Rational::from_double(middle);
}

}  // namespace

class FormulaCells::Builder {
 public:
  Builder(FormulaCells& out, const std::vector<std::shared_ptr<const Operand>>& operands)
      : out_(out), operands_(operands) {}

  // Large cells first, so that the budget serves all places alike.
  void build(const Formula& formula) {
    parts_.push_back({out_.box_, compact(formula), 0});
    num_literals_ = parts_[0].formula.num_literals();
    depth_ = formula.depth();
    std::deque<std::size_t> open = {0};
    while (!open.empty() && num_cells_ < kMostCells && num_literals_ < kMostStoredLiterals &&
           work_ < kMostFoldingWork) {
      const std::size_t i = open.front();
      open.pop_front();
      if (halve(i)) open.insert(open.end(), {parts_[i].lower, parts_[i].lower + 1});
    }
    put(0);
  }

 private:
  struct Part {
    Box3d box;
    Formula formula;
    int level = 0;
    std::size_t axis = 0, lower = 0;  // the halves are lower and lower + 1; 0: a cell
    double middle = 0;
  };

  bool halve(std::size_t i) {
    const std::size_t literals = parts_[i].formula.num_literals();
    if (literals <= kFewLiterals || parts_[i].level == kMostHalvings) return false;
    Box3d halves[2] = {parts_[i].box, parts_[i].box};
    const std::size_t axis = longest_axis(parts_[i].box);
    const double middle = approx_centre(parts_[i].box)[axis];
    if (!std::isfinite(middle) || !(halves[0].lo[axis] < middle && middle < halves[0].hi[axis]))
      return false;
    halves[0].hi[axis] = halves[1].lo[axis] = middle;
    parts_[i].axis = axis;
    parts_[i].middle = middle;
    parts_[i].lower = parts_.size();
    for (const Box3d& half : halves) {
      work_ += parts_[i].formula.nodes().size() * depth_;
      Formula folded = compact(fold(parts_[i].formula, half));
      num_literals_ += folded.num_literals();
      parts_.push_back({half, std::move(folded), parts_[i].level + 1});
    }
    num_literals_ -= literals;
    parts_[i].formula = Formula::constant(false);
    ++num_cells_;
    return true;
  }

  Formula fold(const Formula& formula, const Box3d& box) const {
    std::vector<std::pair<std::uint32_t, Value3>> values;
    for (const std::uint32_t v : formula.variables())
      values.emplace_back(v, operands_[v]->value(box));
    return formula.folded([&](std::uint32_t v) {
      return std::lower_bound(values.begin(), values.end(), std::pair(v, Value3::kZero))->second;
    });
  }

  std::uint32_t put(std::size_t i) {
    const auto at = static_cast<std::uint32_t>(out_.nodes_.size());
    Part& part = parts_[i];
    out_.nodes_.push_back({part.axis, part.middle, 0, 0});
    if (part.lower == 0) {
      out_.nodes_[at].formula = static_cast<std::uint32_t>(out_.formulas_.size());
      out_.formulas_.push_back(std::move(part.formula));
      return at;
    }
    const std::size_t lower = part.lower;
    put(lower);
    const std::uint32_t upper = put(lower + 1);
    out_.nodes_[at].upper = upper;
    return at;
  }

  FormulaCells& out_;
  const std::vector<std::shared_ptr<const Operand>>& operands_;
  std::deque<Part> parts_;
  std::size_t num_cells_ = 1, num_literals_ = 0, depth_ = 0, work_ = 0;
};

FormulaCells::FormulaCells(const Formula& formula,
                           const std::vector<std::shared_ptr<const Operand>>& operands)
    : box_(box_around(formula.variables(), operands)),
      outside_(formula.folded([](std::uint32_t) { return Value3::kZero; })) {
  Builder(*this, operands).build(formula);
}

// No boundary meets the outside of the box, or a cell in which it was folded, borders included: the operands that are
// folded are constant near every point there.
template <typename Point>
const Formula& FormulaCells::find(const Point& point) const {
  if (!is_within(box_, point)) return outside_;
  std::uint32_t i = 0;
  while (nodes_[i].upper != 0)
    i = is_below(point, nodes_[i].axis, nodes_[i].middle) ? i + 1 : nodes_[i].upper;
  return formulas_[nodes_[i].formula];
}

const Formula& FormulaCells::at(const Vec3d& point) const { return find(point); }
const Formula& FormulaCells::at(const ExactPoint& point) const { return find(point); }

}  // namespace veritope
