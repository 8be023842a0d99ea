// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/centre_search.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace veritope {
namespace {

// A linear program in x, y, z, t: maximise t under rows r·(x, y, z, t) + s >= 0. Seidel's incremental method; the
// bounds of the variables are rows of `bounds`, from which each recursion starts. Few rows: deepest_point adds them one
// by one.
constexpr int kDimension = 4;
using Row = std::array<double, kDimension + 1>;  // coefficients, then the constant
// This is only a search: a wrong tolerance loses a candidate, and what is found is proved elsewhere (has_star_signs).
constexpr double kFlat = 1e-12, kSlack = 1e-13;

struct Program {
  int dimension;
  Row objective;
  std::array<double, kDimension> lo, hi;
};

// The greatest depth t at (x, y, z) in the box.
Program program_in(const Box3d& box) {
  Program out{kDimension, {0, 0, 0, 1, 0}, {}, {}};
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    out.lo[i] = box.lo[i], out.hi[i] = box.hi[i];
    size = std::max(size, box.hi[i] - box.lo[i]);
  }
  out.lo[3] = -4 * size, out.hi[3] = 4 * size;
  return out;
}

// Puts the optimum into x[0 .. dimension); false if the program has no optimum.
bool solve(const Program& program, const std::vector<Row>& rows, std::size_t num_rows, double* x) {
  const int d = program.dimension;
  for (int i = 0; i < d; ++i) {
    if (program.lo[i] > program.hi[i]) return false;
    x[i] = program.objective[i] >= 0 ? program.hi[i] : program.lo[i];
  }
  for (std::size_t k = 0; k < num_rows; ++k) {
    double value = rows[k][kDimension], scale = std::abs(value);
    for (int i = 0; i < d; ++i) {
      value += rows[k][i] * x[i];
      scale = std::max(scale, std::abs(rows[k][i] * x[i]));
    }
    if (value >= -kSlack * scale) continue;
    // The optimum lies in the plane of row k: its variable of greatest coefficient is expressed by the others.
    int pivot = 0;
    for (int i = 1; i < d; ++i)
      if (std::abs(rows[k][i]) > std::abs(rows[k][pivot])) pivot = i;
    if (std::abs(rows[k][pivot]) < kFlat) return false;
    const auto substituted = [&](const Row& r) {
      Row out{};
      const double f = r[pivot] / rows[k][pivot];
      for (int i = 0, to = 0; i < d; ++i)
        if (i != pivot) out[to++] = r[i] - f * rows[k][i];
      out[kDimension] = r[kDimension] - f * rows[k][kDimension];
      return out;
    };
    Program less{d - 1, substituted(program.objective), {}, {}};
    for (int i = 0, to = 0; i < d; ++i)
      if (i != pivot) less.lo[to] = program.lo[i], less.hi[to] = program.hi[i], ++to;
    std::vector<Row> reduced;
    for (const bool upper : {false, true}) {  // the bounds of the eliminated variable
      Row bound{};
      bound[pivot] = upper ? -1 : 1;
      bound[kDimension] = upper ? program.hi[pivot] : -program.lo[pivot];
      reduced.push_back(substituted(bound));
    }
    for (std::size_t j = 0; j < k; ++j) reduced.push_back(substituted(rows[j]));
    double y[kDimension] = {};
    if (d == 1) {
      x[0] = -rows[k][kDimension] / rows[k][0];
      for (const Row& r : reduced)
        if (r[kDimension] < -kFlat) return false;
      continue;
    }
    if (!solve(less, reduced, reduced.size(), y)) return false;
    double at_pivot = rows[k][kDimension];
    for (int i = 0, from = 0; i < d; ++i)
      if (i != pivot) x[i] = y[from++], at_pivot += rows[k][i] * x[i];
    x[pivot] = -at_pivot / rows[k][pivot];
  }
  return true;
}

// Maximises the depth t in the half-spaces that are not at_border; the others are met up to kBorderDepth. Returns x, y,
// z and t.
constexpr int kMostRounds = 60;
std::optional<std::array<double, kDimension>> deepest_beside_borders(
    const std::vector<HalfSpace>& half_spaces, const std::vector<bool>& at_border,
    Program program) {
  std::array<double, kDimension> x{};
  for (int i = 0; i < kDimension; ++i)
    x[i] = i < 3 ? 0.5 * (program.lo[i] + program.hi[i]) : program.hi[i];
  std::vector<Row> rows;
  for (int round = 0; round < kMostRounds; ++round) {
    double most = std::max(0.1 * x[3], 0.25 * kBorderDepth);  // the greatest violation
    std::optional<Row> worst;
    for (std::size_t i = 0; i < half_spaces.size(); ++i) {
      const HalfSpace& h = half_spaces[i];
      const double value = h.a[0] * x[0] + h.a[1] * x[1] + h.a[2] * x[2] + h.b;
      const double violation = (at_border[i] ? -kBorderDepth : x[3]) - value;
      if (!(violation > most)) continue;
      most = violation;
      worst = at_border[i] ? Row{h.a[0], h.a[1], h.a[2], 0, h.b + kBorderDepth}
                           : Row{h.a[0], h.a[1], h.a[2], -1, h.b};
    }
    if (!worst) return x;
    rows.push_back(*worst);
    if (!solve(program, rows, rows.size(), x.data()) || x[3] < -kBorderDepth) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

double least_depth(const std::vector<HalfSpace>& half_spaces, const Point3d& point) {
  double out = std::numeric_limits<double>::infinity();
  for (const HalfSpace& h : half_spaces)
    out = std::min(out, h.a[0] * point[0] + h.a[1] * point[1] + h.a[2] * point[2] + h.b);
  return out;
}

std::optional<DeepestPoint> deepest_point(const std::vector<HalfSpace>& half_spaces,
                                          const Box3d& box, double enough, double* bound) {
  constexpr int kMaxRounds = 40;
  const Program program = program_in(box);
  const Point3d centre = approx_centre(box);
  double x[kDimension] = {centre[0], centre[1], centre[2], program.hi[3]};
  std::vector<Row> rows;
  if (bound != nullptr) *bound = program.hi[3];
  for (int round = 0; round < kMaxRounds; ++round) {
    double worst = x[3];
    const HalfSpace* worst_one = nullptr;
    for (const HalfSpace& h : half_spaces) {
      const double value = h.a[0] * x[0] + h.a[1] * x[1] + h.a[2] * x[2] + h.b;
      if (value < worst) worst = value, worst_one = &h;
    }
    if (worst_one == nullptr || worst > 0.9 * x[3]) {
      if (!(worst > enough)) return std::nullopt;
      return DeepestPoint{{x[0], x[1], x[2]}, worst};
    }
    rows.push_back({worst_one->a[0], worst_one->a[1], worst_one->a[2], -1, worst_one->b});
    const bool is_solved = solve(program, rows, rows.size(), x);
    if (bound != nullptr) *bound = is_solved ? x[3] : 0;
    if (!is_solved || !(x[3] > enough)) return std::nullopt;
  }
  return std::nullopt;
}

bool is_surely_shallow(const std::vector<HalfSpace>& half_spaces, const Box3d& box, double enough) {
  constexpr double kNearly = 1 - 1e-6;  // far beyond the tolerances of the linear programs
  double bound = 0;                     // 0 if a linear program had no optimum
  return !deepest_point(half_spaces, box, enough, &bound) && bound != 0 && bound < kNearly * enough;
}

// Half-spaces that stop the depth at 0 are met at their borders, one group after the other.
std::optional<DeepestPointOrZeros> deepest_point_or_zeros(const std::vector<HalfSpace>& half_spaces,
                                                          const Box3d& box, double enough) {
  constexpr int kMostGroups = 6;
  const Program program = program_in(box);
  std::vector<bool> at_border(half_spaces.size());
  for (int group = 0; group < kMostGroups; ++group) {
    const auto x = deepest_beside_borders(half_spaces, at_border, program);
    if (!x) return std::nullopt;
    const Point3d point{(*x)[0], (*x)[1], (*x)[2]};
    if ((*x)[3] > enough) return DeepestPointOrZeros{point, group > 0};
    if ((*x)[3] > kBorderDepth) return std::nullopt;
    for (std::size_t i = 0; i < half_spaces.size(); ++i)
      if (least_depth({half_spaces[i]}, point) < 2 * kBorderDepth) at_border[i] = true;
  }
  return std::nullopt;
}

}  // namespace veritope
