// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/pieces/piece_forest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "robust/base/check.h"
#include "solids/pieces/piece_bounds.h"
#include "solids/pieces/piece_net_internal.h"

namespace veritope {

using internal::CommonSign;

namespace {
// The greatest absolute value.
double largest_size(const double* v, std::size_t n) {
  double part[4] = {};  // four independent maxima
  std::size_t i = 0;
  for (; i + 4 <= n; i += 4)
    for (std::size_t j = 0; j < 4; ++j) part[j] = std::max(part[j], std::abs(v[i + j]));
  for (; i < n; ++i) part[0] = std::max(part[0], std::abs(v[i]));
  return std::max({part[0], part[1], part[2], part[3]});
}
double sum_of(const double* v, std::size_t n) {
  double part[4] = {};  // four independent sums
  std::size_t i = 0;
  for (; i + 4 <= n; i += 4)
    for (std::size_t j = 0; j < 4; ++j) part[j] += v[i + j];
  for (; i < n; ++i) part[0] += v[i];
  return part[0] + part[1] + part[2] + part[3];
}
}  // namespace

PieceForest::Layout PieceForest::layout(const Form& form, Part part) {
  if (part == Part::kDeterminants) return {form.determinant, 4, form.determinant.count(), true};
  return {form.shape, form.is_rational ? std::size_t{4} : std::size_t{3}, form.shape.count(),
          false};
}

bool PieceForest::Frame::is_plain() const {
  const Rational zero;
  return scale[0] == scale[1] && scale[1] == scale[2] && shift[0] == zero && shift[1] == zero &&
         shift[2] == zero;
}
int PieceForest::scale() const {
  VT_CHECK(frame_.is_plain(), "one scale is asked of a frame that has several, or a shift");
  return frame_.scale[0];
}
Rational PieceForest::in_frame(std::size_t axis, const Rational& model) const {
  return (model - frame_.shift[axis]) * Rational::power_of_two(frame_.scale[axis]);
}
Rational PieceForest::in_model(std::size_t axis, double framed) const {
  return Rational::from_double(framed) * Rational::power_of_two(-frame_.scale[axis]) +
         frame_.shift[axis];
}
Box3d PieceForest::in_model(const Box3d& box) const {
  Box3d out = box;
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::isfinite(box.lo[k])) out.lo[k] = round_down(in_model(k, box.lo[k]));
    if (std::isfinite(box.hi[k])) out.hi[k] = round_up(in_model(k, box.hi[k]));
  }
  return out;
}

double* PieceForest::net(Id id, Part part) {
  const auto k = static_cast<std::size_t>(part);
  if (nodes_[id].net_ages[k] != store_.age()) make_net(id, part);
  return nodes_[id].nets[k];
}

void PieceForest::make_net(Id id, Part part) {
  if (nodes_[id].parent != kNone)
    quarter(nodes_[id].parent, part);
  else
    make_root_net(id, part);
}

void PieceForest::make_root_net(Id id, Part part) {
  const Node& node = nodes_[id];
  const Form& form = forms_[node.patch];
  const Layout at = layout(form, part);
  const FormShape& s = at.shape;
  const std::vector<double>& whole =
      part == Part::kControl ? form.root_control : form.root_determinants;
  double* const net = store_.take(at.size());
  std::copy(whole.begin(), whole.end(), net);
  at.forget_normal(net);
  std::vector<double> other(at.count);
  for (const int axis : {0, 1})
    for (int bit = form.root_bits[axis]; bit-- > 0;) {
      const bool upper = ((axis == 0 ? node.i : node.j) >> bit & 1) != 0;
      const int degree = axis == 0 ? s.p : s.q, lines = axis == 0 ? s.q : s.p;
      const auto stride = static_cast<std::size_t>(axis == 0 ? s.q + 1 : 1);
      const auto next = static_cast<std::size_t>(axis == 0 ? 1 : s.q + 1);
      for (std::size_t c = 0; c < at.components; ++c) {
        double* const first = net + at.begin(c);
        for (int k = 0; k <= lines; ++k) {
          double* const line = first + static_cast<std::size_t>(k) * next;
          internal::split_keeping_left(line, stride, degree, other.data(), 1, internal::kHalves);
          for (int i = 0; upper && i <= degree; ++i)
            line[static_cast<std::size_t>(i) * stride] = other[static_cast<std::size_t>(i)];
        }
        net[at.error(c)] =
            internal::error_after_halving(net[at.error(c)], net[at.magnitude(c)], degree);
      }
    }
  keep_net(id, part, net);
}

void PieceForest::quarter(Id id, Part part) {
  const double* const from = net(id, part);
  const Layout at = layout(forms_[nodes_[id].patch], part);
  double* const begin = store_.take(4 * at.size());
  double* to[4];
  for (std::size_t c = 0; c < at.components; ++c) {
    for (std::size_t k = 0; k < 4; ++k) to[k] = begin + k * at.size() + at.begin(c);
    if (at.shape.is_triangle)
      internal::quarter_triangle(at.shape.p, from + at.begin(c), to);
    else
      internal::quarter_tensor(at.shape, from + at.begin(c), to);
    const double error = internal::error_after_halving(from[at.error(c)], from[at.magnitude(c)],
                                                       internal::quarter_depth(at.shape));
    for (std::size_t k = 0; k < 4; ++k) {
      double* const child = begin + k * at.size();
      child[at.error(c)] = error;
      child[at.magnitude(c)] = largest_size(to[k], at.count);
    }
  }
  for (Id k = 0; k < 4; ++k) {
    at.forget_normal(begin + k * at.size());
    keep_net(nodes_[id].first_child + k, part, begin + k * at.size());
  }
}

PieceForest::Id PieceForest::children(Id id) {
  if (nodes_[id].first_child != kNone) return nodes_[id].first_child;
  const Node parent = nodes_[id];
  VT_CHECK(may_split(id), "a piece is split too often");
  const Form& form = forms_[parent.patch];
  const bool is_new = free_.empty();
  const Id first = is_new ? static_cast<Id>(nodes_.size()) : free_.back();
  if (!is_new) free_.pop_back();
  for (std::uint8_t k = 0; k < 4; ++k) {
    Node child;
    child.patch = parent.patch, child.parent = id;
    child.level = static_cast<std::uint8_t>(parent.level + 1);
    child.i = 2 * parent.i, child.j = 2 * parent.j;
    if (!form.shape.is_triangle) {
      child.i += k / 2, child.j += k % 2;
    } else {
      // Corner children move towards their corner; the middle one is turned. The first coordinate follows from the sum.
      child.is_upside_down = parent.is_upside_down != (k == 3);
      const bool one_i = k == 1 || k == 3, one_j = k == 2 || k == 3;
      if (parent.is_upside_down)
        child.i -= one_i, child.j -= one_j;
      else
        child.i += one_i, child.j += one_j;
    }
    if (is_new)
      nodes_.push_back(child);
    else
      nodes_[first + k] = child;
  }
  nodes_[id].first_child = first;
  quarter(id, Part::kControl);
  for (Id k = 0; k < 4; ++k) nodes_[first + k].hull = tight_hull(first + k);
  return first;
}

void PieceForest::drop_children(Id id) {
  const Id first = std::exchange(nodes_[id].first_child, kNone);
  if (first == kNone) return;
  for (Id k = 0; k < 4; ++k) {
    drop_children(first + k);
    exact_.erase(first + k);
  }
  free_.push_back(first);
  ++num_drops_;
}

Box3d PieceForest::hull_of(const Form& form, const double* net) const {
  const Layout at = layout(form, Part::kControl);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box3d out;
  const double w_error = at.components == 4 ? net[at.error(3)] : 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double error = net[at.error(c)];
    double lo = kInfinity, hi = -kInfinity;
    for (std::size_t i = 0; i < at.count; ++i) {
      const double x = net[at.begin(c) + i];
      std::array<double, 2> ends;
      if (at.components == 4) {
        const double w = net[at.begin(3) + i];
        if (!internal::is_surely_positive(w, w_error))
          return {{-kInfinity, -kInfinity, -kInfinity}, {kInfinity, kInfinity, kInfinity}};
        ends = internal::hull_ends(x, error, w, w_error);
      } else {
        ends = internal::hull_ends(x, error);
      }
      lo = std::min(lo, ends[0]), hi = std::max(hi, ends[1]);
    }
    const double slack = internal::hull_slack(lo, hi, form.origin[c], at.components == 4);
    out.lo[c] = form.origin[c] + lo - slack;
    out.hi[c] = form.origin[c] + hi + slack;
  }
  return out;
}

PieceForest::Collapsed PieceForest::collapsed_sides(const Node& node, const Form& form) const {
  if (form.collapsed == 0) return Collapsed::kNone;
  const std::uint32_t n = form.shape.is_triangle ? 3 : 4;
  bool is_in[4] = {};
  Collapsed out = Collapsed::kNone;
  for (std::uint32_t s = 0; s < n; ++s) {
    is_in[s] = (form.collapsed >> s & 1) != 0 && side_of_patch(node, s);
    if (is_in[s]) out = Collapsed::kApart;
  }
  for (std::uint32_t s = 0; s < n; ++s)
    if (is_in[s] && is_in[(s + 1) % n]) return Collapsed::kAdjacent;
  return out;
}

bool PieceForest::side_of_patch(const Node& node, std::uint32_t side) const {
  const Form& form = forms_[node.patch];
  if (form.shape.is_triangle) {
    if (node.is_upside_down) return false;
    const std::uint64_t first = (std::uint64_t{1} << node.level) - 1 - node.i - node.j;
    // Side s runs from corner s to corner s + 1: the coordinate of corner s + 2 is 0.
    return (side == 0 ? node.j : side == 1 ? first : node.i) == 0;
  }
  const std::uint64_t rows = std::uint64_t{1} << (form.root_bits[0] + node.level);
  const std::uint64_t columns = std::uint64_t{1} << (form.root_bits[1] + node.level);
  switch (side) {
    case 0: return node.j == 0;
    case 1: return node.i + 1 == rows;
    case 2: return node.j + 1 == columns;
    default: return node.i == 0;
  }
}

bool PieceForest::is_on_side(const Node& node, std::uint32_t corner, std::uint32_t side) const {
  const Form& form = forms_[node.patch];
  if (form.shape.is_triangle) {
    const std::uint64_t whole = std::uint64_t{1} << node.level;
    const std::uint64_t first = (node.is_upside_down ? whole + 1 : whole - 1) - node.i - node.j;
    const std::uint32_t opposite = (side + 2) % 3;
    const std::uint64_t base = opposite == 0 ? first : opposite == 1 ? node.i : node.j;
    if (opposite != corner) return base == 0;
    return node.is_upside_down && base == 1;
  }
  const std::uint64_t i = node.i + (corner == 1 || corner == 2 ? 1 : 0);
  const std::uint64_t j = node.j + (corner >= 2 ? 1 : 0);
  switch (side) {
    case 0: return j == 0;
    case 1: return i == std::uint64_t{1} << (form.root_bits[0] + node.level);
    case 2: return j == std::uint64_t{1} << (form.root_bits[1] + node.level);
    default: return i == 0;
  }
}

Sign3 PieceForest::side_of(Id id, const Point3d& c) {
  const RoundedSide rounded = rounded_side_of(id, c);
  if (is_certain(rounded.sign) || !rounded.may_be_weak) return rounded.sign;
  return exact_side_of(id, c);
}

PieceForest::RoundedSide PieceForest::rounded_side_of(Id id, const Point3d& c) {
  const Node& node = nodes_[id];
  const Form& form = forms_[node.patch];
  const Collapsed collapsed = collapsed_sides(node, form);
  if (collapsed == Collapsed::kAdjacent) return {Sign3::kUncertain, false};
  const double* const net = this->net(id, Part::kDeterminants);
  const Layout at = layout(form, Part::kDeterminants);
  Point3d x;
  for (std::size_t k = 0; k < 3; ++k) x[k] = c[k] - form.origin[k];
  const double* const e = net + at.error(0);
  const double* const m = net + at.magnitude(0);
  const double bound = internal::side_bound(internal::side_sum(e[0], e[1], e[2], e[3], x),
                                            internal::side_sum(m[0], m[1], m[2], m[3], x));
  const double *const g0 = net, *const g1 = net + at.begin(1), *const g2 = net + at.begin(2),
                      *const g3 = net + at.begin(3);
  double lo = std::numeric_limits<double>::infinity(), hi = -lo;
  if (collapsed == Collapsed::kNone) {
    for (std::size_t i = 0; i < at.count; ++i) {
      const double g = internal::side_value(g0[i], g1[i], g2[i], g3[i], x);
      lo = g < lo ? g : lo;
      hi = g > hi ? g : hi;
    }
  } else {
    for_each_kept(node, [&](std::size_t i) {
      const double g = internal::side_value(g0[i], g1[i], g2[i], g3[i], x);
      lo = std::min(lo, g), hi = std::max(hi, g);
    });
  }
  switch (internal::common_sign(lo, hi, bound)) {
    case CommonSign::kPositive: return {Sign3::kPositive, true};
    case CommonSign::kNegative: return {Sign3::kNegative, true};
    case CommonSign::kMixed: return {Sign3::kUncertain, false};
    case CommonSign::kUnknown: break;
  }
  return {};
}

const double* PieceForest::control(Id id) { return net(id, Part::kControl); }
double PieceForest::control_error(Id id, std::size_t component) {
  const Layout at = layout(forms_[nodes_[id].patch], Part::kControl);
  return net(id, Part::kControl)[at.error(component)];
}
double PieceForest::determinant_error(Id id, std::size_t k) {
  const Layout at = layout(forms_[nodes_[id].patch], Part::kDeterminants);
  return net(id, Part::kDeterminants)[at.error(k)];
}
const double* PieceForest::approx_determinants(Id id) { return net(id, Part::kDeterminants); }

Point3d PieceForest::approx_normal(Id id) {
  double* const net = this->net(id, Part::kDeterminants);
  const Layout at = layout(forms_[nodes_[id].patch], Part::kDeterminants);
  double* const known = net + at.normal();
  if (std::isnan(known[0]))
    for (std::size_t k = 0; k < 3; ++k) known[k] = -sum_of(net + at.begin(k + 1), at.count);
  return {known[0], known[1], known[2]};
}

void PieceForest::NetStore::next_block(std::size_t n) {
  VT_CHECK(n <= kBlock, "a net is larger than a block of memory");
  if (block_ == blocks_.size()) {
    share_.resize_anyway((blocks_.size() + 1) * kBlock * sizeof(double));
    blocks_.push_back(std::make_unique_for_overwrite<double[]>(kBlock));
  }
  ++block_;
  used_ = 0;
}

void PieceForest::limit_memory(std::size_t bytes) {
  if (exact_stored_ > kMostExactStored / 4) exact_.clear(), exact_stored_ = 0;
  if (budget() != nullptr) bytes = std::min<std::uint64_t>(bytes, budget()->limit() / 4);
  if (store_.bytes() <= bytes) return;
  store_.take_back();
}

}  // namespace veritope
