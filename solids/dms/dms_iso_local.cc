// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_iso_local.h"

#include <algorithm>
#include <optional>

#include "solids/dms/dms_change.h"

namespace veritope {
namespace {

constexpr std::size_t kMaxKeptFrames = std::size_t{1} << 16;  // some 700 bytes each

bool has_vertices_of(const TetrahedronCorners& other, const TetrahedralIndex& beta,
                     const TetrahedronCorners& tetrahedron) {
  for (std::size_t m = 0; m < 4; ++m)
    if (beta[m] > 0 &&
        std::find(tetrahedron.begin(), tetrahedron.end(), other[m]) == tetrahedron.end())
      return false;
  return true;
}

}  // namespace

DmsIsoLocal::DmsIsoLocal(const DmsModel& model, const DmsKnotTable& knots, std::size_t component,
                         const Rational& level)
    : model_(model), knots_(knots), component_(component), level_(level) {}

Rational DmsIsoLocal::control(std::uint32_t tetrahedron, const TetrahedralIndex& beta) const {
  return model_.value(control_of(model_, tetrahedron, beta))[component_];
}

bool DmsIsoLocal::is_collapsed(std::uint32_t tetrahedron) const {
  const TetrahedronCorners& t = model_.tetrahedra[tetrahedron];
  return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) {
    for (int i = 1; i < model_.degree; ++i)
      if (knots_.number(v, i) != knots_.number(v, 0)) return false;
    return true;
  });
}

std::vector<DmsPoint> DmsIsoLocal::knots_of(std::uint32_t tetrahedron,
                                            const TetrahedralIndex& beta) const {
  std::vector<DmsPoint> out;
  for (std::size_t m = 0; m < 4; ++m)
    for (int i = 0; i < beta[m]; ++i)
      out.push_back(model_.knot(model_.tetrahedra[tetrahedron][m], i));
  return out;
}

const DmsIsoLocal::Frame& DmsIsoLocal::frame(const DmsSupport& support) {
  const std::uint64_t key = knots_.key(support);
  const auto found = frames_.find(key);
  if (found != frames_.end()) return found->second;
  if (frames_.size() >= kMaxKeptFrames) frames_.clear();
  std::array<DmsPoint, 4> points;
  for (std::size_t m = 0; m < 4; ++m)
    points[m] = model_.knot(model_.tetrahedra[support.tetrahedron][m], support.gamma[m]);
  return frames_.emplace(key, simplex_frame<Rational>({0, 1, 2, 3}, points, Sign::kPositive))
      .first->second;
}

void DmsIsoLocal::add_rests(std::uint32_t tetrahedron, const BPatch<Rational>& own,
                            std::span<const DmsSupport> supports, DmsIsoForm& out) {
  const auto corners = knots_.corners(tetrahedron);
  std::unordered_map<std::uint64_t, Rational> excess;  // of control points over the blossom
  const auto excess_of = [&](std::uint32_t t, const TetrahedralIndex& beta) -> const Rational& {
    const auto [found, is_new] =
        excess.try_emplace(t * num_tetrahedral_indices(model_.degree) + tetrahedral_index(beta));
    const bool is_shared =
        !model_.control.is_separate &&
        has_vertices_of(model_.tetrahedra[t], beta, model_.tetrahedra[tetrahedron]);
    if (is_new && !is_shared) found->second = control(t, beta) - own.blossom(knots_of(t, beta))[0];
    return found->second;
  };
  bool is_polynomial = true;
  for (const DmsSupport& support : supports) {
    out.supports.push_back(support);
    if (support.tetrahedron == tetrahedron) {
      out.rests.insert(out.rests.end(), 4, Interval(0.0));
      continue;
    }
    std::array<Rational, 4> at_knots;
    bool is_zero = true;
    for (std::size_t m = 0; m < 4; ++m) {
      at_knots[m] = excess_of(support.tetrahedron, raised(support.gamma, m));
      is_zero = is_zero && at_knots[m].sign() == Sign::kZero;
    }
    if (is_zero) {
      out.rests.insert(out.rests.end(), 4, Interval(0.0));
      continue;
    }
    is_polynomial = false;
    for (const DmsPoint& corner : corners) {
      const auto lambda = frame(support).barycentric(corner);
      Rational value;
      for (std::size_t m = 0; m < 4; ++m) value += lambda[m] * at_knots[m];
      out.rests.push_back(enclose(value));
    }
  }
  out.shares.assign(out.rests.size(), 0);
  if (is_polynomial) out.supports.clear(), out.rests.clear(), out.shares.clear();
}

DmsIsoForm DmsIsoLocal::form(std::uint32_t tetrahedron, std::span<const DmsSupport> supports) {
  DmsIsoForm out;
  const bool has_others = std::any_of(supports.begin(), supports.end(), [&](const DmsSupport& s) {
    return s.tetrahedron != tetrahedron;
  });
  const bool is_bernstein = is_collapsed(tetrahedron);
  std::optional<BPatch<Rational>> own;
  if (has_others || !is_bernstein)
    own.emplace(patch_of_tetrahedron(model_, tetrahedron, component_, 1));
  const auto corners = knots_.corners(tetrahedron);
  for_each_tetrahedral_index(model_.degree, [&](const TetrahedralIndex& beta) {
    if (is_bernstein) {
      out.coefficients.push_back(enclose(control(tetrahedron, beta) - level_));
      return;
    }
    std::vector<DmsPoint> points;
    for (std::size_t m = 0; m < 4; ++m)
      points.insert(points.end(), static_cast<std::size_t>(beta[m]), corners[m]);
    out.coefficients.push_back(enclose(own->blossom(points)[0] - level_));
  });
  if (has_others) add_rests(tetrahedron, *own, supports, out);
  return out;
}

}  // namespace veritope
