// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/contact_solver.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "robust/simplest.h"
#include "verify/certify/affine_patch.h"
#include "verify/certify/sheet_tangents_internal.h"

namespace veritope {
namespace {

using internal::cross;
using internal::dot;
using internal::largest;
using internal::length_of;
using internal::tangents;
using internal::Tangents;
using Vector = internal::Vector3;

constexpr int kMostContactSteps = 16, kMostFeet = 3;
constexpr double kLastContactStep = 0x1p-42;
// Ranges are left by no more than this many times their lengths.
constexpr double kContactReach = 4;
// Sheets touch if they are apart by less than this part of the longest tangent, and the sine of the angle between a
// tangent of one and the tangent plane of the other is less.
constexpr double kTouching = 0x1p-36, kTangent = 0x1p-20;
// Derivatives of angles are central differences over twice this distance of parameters: where sheets nearly coincide,
// those of one nearly cancel those of the other.
constexpr double kDifference = 0x1p-17;
// A column that depends on those before it up to this part of its length is left out: its parameter is not moved.
constexpr double kDependent = 0x1p-33;
// The distances from a parameter within which the simplest fraction is taken, least first.
constexpr std::array<double, 5> kTolerances = {0x1p-44, 0x1p-36, 0x1p-28, 0x1p-20, 0x1p-12};
constexpr double kSamePlace = 0x1p-16;  // of places that were tested before

// Two approximations of one place of one patch.
bool is_same_place(const std::array<SheetPlace, 2>& at) {
  return at[0].patch == at[1].patch && std::abs(at[0].at[0] - at[1].at[0]) < kSamePlace &&
         std::abs(at[0].at[1] - at[1].at[1]) < kSamePlace;
}

Rational simple_near(double t, double tolerance) {
  if (t <= tolerance) return Rational(0);
  if (t >= 1 - tolerance) return Rational(1);
  const Rational middle = Rational::from_double(t), width = Rational::from_double(tolerance);
  return simplest_between(middle - width, middle + width);
}

std::array<PatchPlace, 2> simple_places(const std::array<SheetPlace, 2>& at,
                                        const std::array<bool, 4>& is_fixed, double tolerance) {
  std::array<PatchPlace, 2> out;
  for (std::size_t j = 0; j < 4; ++j) {
    out[j / 2].patch = at[j / 2].patch;
    const double t = parameter(at, j);
    out[j / 2].at[j % 2] = is_fixed[j] ? Rational::from_double(t) : simple_near(t, tolerance);
  }
  return out;
}

// The first corner of a triangle has many parameters.
bool has_own_parameters(const PatchComplex& complex, const PatchPlace& place) {
  return !complex.patch(place.patch).is_triangle() || place.at[0].sign() != Sign::kZero;
}
// Ways to look at a range: what is fixed, and where.
struct Stance {
  std::array<double, 2> at;
  std::array<bool, 2> is_fixed;
};
std::vector<Stance> stances(const SheetRange& range) {
  std::array<std::vector<std::pair<double, bool>>, 2> choices;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto& [lo, hi] = range.at[axis];
    // Where a parameter is not determined it stays: a short one.
    const double grid = std::exp2(std::floor(std::log2(std::max(hi - lo, 0x1p-60))) - 1);
    choices[axis].push_back({std::nearbyint(0.5 * (lo + hi) / grid) * grid, false});
    if (lo == 0) choices[axis].push_back({0, true});
    if (hi == 1) choices[axis].push_back({1, true});
  }
  std::vector<Stance> out;
  for (const auto& [s, s_fixed] : choices[0])
    for (const auto& [t, t_fixed] : choices[1]) out.push_back({{s, t}, {s_fixed, t_fixed}});
  return out;
}
double length_of(const SheetRange& range) {
  return std::max(range.at[0][1] - range.at[0][0], range.at[1][1] - range.at[1][0]);
}

}  // namespace

/// Values that vanish at a contact, and their derivatives by the four parameters.
struct ContactSolver::Equations {
  static constexpr std::size_t kMost = 5;
  std::size_t count = 3;
  std::array<double, kMost> value{};
  std::array<std::array<double, kMost>, 4> column{};

  bool is_contact() const {
    for (std::size_t i = 0; i < count; ++i)
      if (!(std::abs(value[i]) <= (i < 3 ? kTouching : kTangent))) return false;
    return true;
  }
};

namespace {

using Column = std::array<double, 5>;

double product(const Column& a, const Column& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

// The step of the parameters that solves the equations best, by Gram and Schmidt with the longest column first. On the
// first call, `fixed` becomes true for those whose columns depend on others.
std::array<double, 4> best_step(std::array<Column, 4> columns, Column value,
                                std::array<bool, 4>* fixed, bool is_first) {
  std::array<double, 4> unit{}, length{};
  std::vector<std::size_t> open, taken;
  for (std::size_t j = 0; j < 4; ++j) {
    if ((*fixed)[j]) continue;
    unit[j] = std::sqrt(product(columns[j], columns[j]));
    if (!(unit[j] > 0)) {
      if (is_first) (*fixed)[j] = true;
      continue;
    }
    for (double& v : columns[j]) v /= unit[j];
    open.push_back(j);
  }
  std::array<Column, 4> basis;
  std::array<std::array<double, 4>, 4> part{};  // of column j along basis i
  std::array<double, 4> goal{};
  while (!open.empty()) {
    for (const std::size_t j : open) length[j] = product(columns[j], columns[j]);
    const auto best = std::max_element(open.begin(), open.end(), [&](std::size_t a, std::size_t b) {
      return length[a] < length[b];
    });
    const std::size_t j = *best;
    if (!(length[j] > kDependent * kDependent)) {
      if (is_first)
        for (const std::size_t k : open) (*fixed)[k] = true;
      break;
    }
    open.erase(best);
    const std::size_t n = taken.size();
    basis[n] = columns[j];
    for (double& v : basis[n]) v /= std::sqrt(length[j]);
    part[n][j] = std::sqrt(length[j]);
    for (const std::size_t k : open) {
      part[n][k] = product(basis[n], columns[k]);
      for (std::size_t i = 0; i < 5; ++i) columns[k][i] -= part[n][k] * basis[n][i];
    }
    goal[n] = product(basis[n], value);
    for (std::size_t i = 0; i < 5; ++i) value[i] -= goal[n] * basis[n][i];
    taken.push_back(j);
  }
  std::array<double, 4> step{};
  for (std::size_t n = taken.size(); n-- > 0;) {
    double sum = goal[n];
    for (std::size_t m = n + 1; m < taken.size(); ++m) sum -= part[n][taken[m]] * step[taken[m]];
    step[taken[n]] = sum / part[n][taken[n]];
  }
  for (std::size_t j = 0; j < 4; ++j)
    if (unit[j] > 0) step[j] /= unit[j];
  return step;
}

}  // namespace

// A - B over the longest tangent; and where one sheet is free in both parameters, the sines of the angles between its
// tangent plane and the tangents of the other along free parameters.
ContactSolver::Equations ContactSolver::equations_at(const Places& at, const Fixed& is_fixed) {
  const std::array<const SheetMaps::Sheet*, 2> sheets{&maps_.sheet(at[0].patch),
                                                      &maps_.sheet(at[1].patch)};
  const std::array<Tangents, 2> here{tangents(sheets[0]->map, at[0].at),
                                     tangents(sheets[1]->map, at[1].at)};
  Equations out;
  double unit = 0;
  for (const Tangents& t : here) unit = std::max({unit, largest(t.along[0]), largest(t.along[1])});
  for (std::size_t k = 0; k < 3; ++k) {
    out.value[k] =
        ((sheets[0]->origin[k] - sheets[1]->origin[k]) + (here[0].at[k] - here[1].at[k])) / unit;
    for (std::size_t j = 0; j < 4; ++j)
      out.column[j][k] = (j < 2 ? 1 : -1) * here[j / 2].along[j % 2][k] / unit;
  }
  const std::size_t face = !is_fixed[0] && !is_fixed[1] ? 0 : 1, other = 1 - face;
  if (is_fixed[2 * face] || is_fixed[2 * face + 1]) return out;
  const auto sine = [](const Tangents& plane, const Vector& tangent) {
    const Vector n = cross(plane.along[0], plane.along[1]);
    return dot(n, tangent) / (length_of(n) * length_of(tangent));
  };
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (is_fixed[2 * other + axis]) continue;
    const std::size_t row = out.count++;
    out.value[row] = sine(here[face], here[other].along[axis]);
    for (std::size_t j = 0; j < 4; ++j) {
      if (is_fixed[j]) continue;
      const auto moved_by = [&](double distance) {
        std::array<double, 2> to = at[j / 2].at;
        to[j % 2] += distance;
        const Tangents there = tangents(sheets[j / 2]->map, to);
        return j / 2 == face ? sine(there, here[other].along[axis])
                             : sine(here[face], there.along[axis]);
      };
      out.column[j][row] = (moved_by(kDifference) - moved_by(-kDifference)) / (2 * kDifference);
    }
  }
  return out;
}

// Moves the second place to the foot of the perpendicular from the first: where two sheets nearly coincide, their
// angles are known only there.
void ContactSolver::drop_foot(Places* at) {
  const SheetMaps::Sheet &a = maps_.sheet((*at)[0].patch), &b = maps_.sheet((*at)[1].patch);
  const Vector above = tangents(a.map, (*at)[0].at).at;
  for (int step = 0; step < kMostFeet; ++step) {
    const Tangents below = tangents(b.map, (*at)[1].at);
    Vector difference;
    for (std::size_t k = 0; k < 3; ++k)
      difference[k] = (a.origin[k] - b.origin[k]) + (above[k] - below.at[k]);
    const auto d = internal::foot_step(difference, below.along[0], below.along[1]);
    if (!d) return;
    for (std::size_t i = 0; i < 2; ++i) {
      double& t = (*at)[1].at[i];
      t = std::clamp(t + (*d)[i], 0.0, 1.0);
    }
    if (std::max(std::abs((*d)[0]), std::abs((*d)[1])) < kLastContactStep) return;
  }
}

// Newton's method; parameters that the equations do not determine become fixed.
bool ContactSolver::settle(Places* at, Fixed* is_fixed, double reach) {
  const Places start = *at;
  double last = HUGE_VAL;
  Fixed moved = *is_fixed;
  for (int step = 0; step < kMostContactSteps; ++step) {
    if (std::none_of(moved.begin(), moved.end(), [](bool is) { return is; })) drop_foot(at);
    const Equations e = equations_at(*at, *is_fixed);
    const std::array<double, 4> d = best_step(e.column, e.value, &moved, step == 0);
    double length = 0;
    for (std::size_t j = 0; j < 4; ++j) {
      double& t = parameter(at, j);
      t = std::clamp(t - d[j], 0.0, 1.0);
      length = std::max(length, std::abs(d[j]));
      if (!(std::abs(t - parameter(start, j)) <= reach)) return false;
    }
    if (length <= kLastContactStep || (length < 0x1p-20 && !(length < 0.5 * last))) break;
    last = length;
  }
  const bool is_contact = equations_at(*at, *is_fixed).is_contact();
  *is_fixed = moved;
  return is_contact;
}

std::optional<MeetingWitness> ContactSolver::solve(const SheetRange& a, const SheetRange& b) {
  const double reach = kContactReach * std::max(length_of(a), length_of(b));
  for (const Stance& s : stances(a))
    for (const Stance& t : stances(b)) {
      if (num_solved >= kMostSolved || num_tested >= kMostTested) return std::nullopt;
      const Places at{SheetPlace{a.patch, s.at}, SheetPlace{b.patch, t.at}};
      const Fixed is_fixed{s.is_fixed[0], s.is_fixed[1], t.is_fixed[0], t.is_fixed[1]};
      if (auto found = solve_from(at, is_fixed, reach)) return found;
    }
  return std::nullopt;
}

std::optional<MeetingWitness> ContactSolver::solve_from(Places at, Fixed is_fixed, double reach) {
  ++num_solved;
  if (!settle(&at, &is_fixed, reach) || is_same_place(at)) return std::nullopt;
  const auto is_near = [&](const Places& other) {
    for (std::size_t j = 0; j < 4; ++j)
      if (other[j / 2].patch != at[j / 2].patch ||
          !(std::abs(parameter(other, j) - parameter(at, j)) < kSamePlace))
        return false;
    return true;
  };
  if (std::any_of(tested_.begin(), tested_.end(), is_near)) return std::nullopt;
  tested_.push_back(at);
  if (is_one_point(simple_places(at, is_fixed, kSamePlace))) return std::nullopt;
  ++num_tested;
  return prove(at, is_fixed);
}

// Whether the surface glues the places to each other: most solutions lie where neighbours meet.
bool ContactSolver::is_one_point(const std::array<PatchPlace, 2>& places) {
  const PatchComplex& complex = maps_.forest().complex();
  if (!is_glued_) is_glued_ = is_glued(complex);
  return *is_glued_ && are_one_point(complex, places[0], places[1]);
}

std::optional<MeetingWitness> ContactSolver::prove(const Places& at, const Fixed& is_fixed) {
  const PatchComplex& complex = maps_.forest().complex();
  const auto proof = [&](PatchPlace a, PatchPlace b) -> std::optional<MeetingWitness> {
    if (!has_short_numbers(a) || !has_short_numbers(b)) return std::nullopt;
    if (point_of(complex, a) != point_of(complex, b)) return std::nullopt;
    if (!is_in_open_domain(a)) std::swap(a, b);
    if (!on_borders_ && !(is_in_open_domain(a) && has_own_parameters(complex, b)))
      return std::nullopt;
    MeetingWitness out{MeetingWitness::Cause::kContact, {std::move(a), std::move(b)}};
    if (broken_condition(complex, out)) return std::nullopt;
    return out;
  };
  // The place of the other patch that has the same image.
  const auto opposite = [&](const PatchPlace& place,
                            std::size_t other) -> std::optional<PatchPlace> {
    const auto map = AffinePatch::make(complex.patch(at[other].patch));
    if (!map) return std::nullopt;
    const auto parameters = map->parameters_of(point_of(complex, place));
    if (!parameters) return std::nullopt;
    return PatchPlace{at[other].patch, *parameters};
  };
  std::array<PatchPlace, 2> last;
  for (const double tolerance : kTolerances) {
    const std::array<PatchPlace, 2> simple = simple_places(at, is_fixed, tolerance);
    if (simple == last) continue;
    last = simple;
    if (auto found = proof(simple[0], simple[1])) return found;
    for (std::size_t i = 0; i < 2; ++i)
      if (auto other = opposite(simple[i], 1 - i))
        if (auto found = proof(simple[i], std::move(*other))) return found;
  }
  return std::nullopt;
}

SheetRange range_of_piece(const PieceForest& forest, PieceForest::Id piece) {
  const PieceForest::Node& node = forest.node(piece);
  const PieceForest::Form& form = forest.form(node.patch);
  SheetRange out;
  out.patch = node.patch;
  const auto part = [](std::uint64_t i, int bits) {
    return std::ldexp(static_cast<double>(i), -bits);
  };
  if (!form.shape.is_triangle) {
    const std::array<int, 2> bits{form.root_bits[0] + node.level, form.root_bits[1] + node.level};
    out.at[0] = {part(node.i, bits[0]), part(node.i + 1, bits[0])};
    out.at[1] = {part(node.j, bits[1]), part(node.j + 1, bits[1])};
    return out;
  }
  // A corner has s = b + c and t = c / s; corner 0 of the patch has any t.
  out.at = {{{1, 0}, {1, 0}}};
  for (int corner = 0; corner < 3; ++corner) {
    const std::uint64_t one = node.is_upside_down ? ~std::uint64_t{0} : 1;
    const std::uint64_t b = node.i + (corner == 1 ? one : 0), c = node.j + (corner == 2 ? one : 0);
    const double s = part(b + c, node.level);
    const bool is_pole = b + c == 0;
    const double t = is_pole ? 0 : static_cast<double>(c) / static_cast<double>(b + c);
    out.at[0] = {std::min(out.at[0][0], s), std::max(out.at[0][1], s)};
    out.at[1] = {std::min(out.at[1][0], t), std::max(out.at[1][1], is_pole ? 1 : t)};
  }
  return out;
}

}  // namespace veritope
