// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/interval_boxes/boundary_model.h"

#include <cmath>
#include <limits>

#include "robust/base/check.h"
#include "solids/pieces/piece_descent.h"
#include "solids/star_box/star_box.h"

namespace veritope {
namespace {

using Curve = BezierCurve<Rational>;

Rational weight(const Curve& c, std::size_t i) {
  return c.is_rational() ? c.component(2)[i] : Rational(1);
}

// A power of two of at least every |coordinate| of the control points; a weight that is not positive is named later.
Rational reach(const std::vector<std::vector<Curve>>& loops) {
  Rational out(1);
  for (const auto& loop : loops)
    for (const Curve& c : loop)
      for (std::size_t i = 0; i < c.component(0).size(); ++i)
        for (int k = 0; k < 2; ++k)
          while (out * abs(weight(c, i)) < abs(c.component(k)[i]) &&
                 weight(c, i).sign() != Sign::kZero)
            out *= Rational(2);
  return out;
}

// (x, y, z)(u, v) = (1 - v) begin(u) + v end(u), homogeneous.
Result<Patch> ruled(const std::array<std::vector<Rational>, 4>& begin,
                    const std::array<std::vector<Rational>, 4>& end, std::size_t number) {
  const std::size_t n = begin[0].size();
  std::vector<Rational> all;
  for (std::size_t c = 0; c < 4; ++c)
    for (std::size_t i = 0; i < n; ++i) {
      all.push_back(begin[c][i]);
      all.push_back(end[c][i]);
    }
  return make_patch(Patch::Tensor({static_cast<int>(n) - 1, 1}, 4, true, std::move(all)),
                    {PatchOrigin::Kind::kBuilt, number, {}});
}

}  // namespace

Result<BoundaryModel> BoundaryModel::make(PatchComplex complex, MemoryBudget* budget) {
  if (!complex.is_closed_oriented_surface()) {
    std::string why = "the patches are no closed oriented surface";
    if (!complex.findings().empty()) why += ": " + describe(complex, complex.findings().front());
    return Error{Code::kBadArgument, {}, std::move(why)};
  }
  BoundaryModel out;
  out.complex_ = std::make_unique<PatchComplex>(std::move(complex));
  auto forest = PieceForest::make(*out.complex_, PieceForest::FrameChoice::kPlain, budget);
  if (!forest) return forest.error();
  out.forest_ = std::make_unique<PieceForest>(std::move(*forest));
  return out;
}

Result<BoundaryModel> BoundaryModel::make_planar(const std::vector<std::vector<Curve>>& loops) {
  std::vector<Patch> patches;
  for (const auto& loop : loops)
    for (const Curve& c : loop)
      if ((c.num_components() - (c.is_rational() ? 1 : 0)) != 2 || c.degree(0) < 1)
        return Error{Code::kBadArgument, {}, "a curve that is no plane curve of degree 1 or more"};
  const Rational size = reach(loops), top = Rational(2) * size;
  for (const auto& loop : loops) {
    for (const Curve& c : loop) {
      std::array<std::vector<Rational>, 4> low, high, below, above;
      for (std::size_t i = 0; i < c.component(0).size(); ++i) {
        const Rational w = weight(c, i);
        const Rational x = c.component(0)[i], y = c.component(1)[i];
        const Rational at_low[4] = {x, y, -top * w, w}, at_high[4] = {x, y, top * w, w};
        const Rational apex_low[4] = {Rational(0), Rational(0), Rational(-2) * top * w, w},
                       apex_high[4] = {Rational(0), Rational(0), Rational(2) * top * w, w};
        for (std::size_t k = 0; k < 4; ++k) {
          low[k].push_back(at_low[k]), high[k].push_back(at_high[k]);
          below[k].push_back(apex_low[k]), above[k].push_back(apex_high[k]);
        }
      }
      for (const auto& [begin, end] :
           {std::pair(&below, &low), std::pair(&low, &high), std::pair(&high, &above)}) {
        auto patch = ruled(*begin, *end, patches.size());
        if (!patch) return patch.error();
        patches.push_back(std::move(*patch));
      }
    }
  }
  auto complex = make_patch_complex(std::move(patches));
  if (!complex) return complex.error();
  auto out = make(std::move(*complex));
  if (!out) return out.error();
  out->dimension_ = 2;
  out->window_ = std::ldexp(nearest_double(size), out->forest_->scale() - 20);
  return out;
}

std::optional<Box3d> BoundaryModel::to_forest(const Box3d& box) const {
  Box3d out = box;
  const int scale = forest_->scale();
  for (std::size_t k = 0; k < 3; ++k) {
    if (k == 2 && is_planar()) {
      out.lo[k] = -window_, out.hi[k] = window_;
      continue;
    }
    for (double* const x : {&out.lo[k], &out.hi[k]}) {
      const double before = *x;
      *x = std::ldexp(before, scale);
      if (!std::isfinite(*x) || std::ldexp(*x, -scale) != before) return std::nullopt;
    }
  }
  return out;
}

Box3d BoundaryModel::from_forest(const Box3d& box) const {
  Box3d out = box;
  for (std::size_t k = 0; k < 3; ++k) {
    out.lo[k] = std::ldexp(box.lo[k], -forest_->scale());
    out.hi[k] = std::ldexp(box.hi[k], -forest_->scale());
  }
  if (is_planar()) out.lo[2] = 0, out.hi[2] = 0;
  return out;
}

namespace {

// Computes the signs from the net of the piece itself.
std::array<int, 3> own_normal_signs(PieceForest& forest, PieceForest::Id piece) {
  const PieceForest::Node node = forest.node(piece);
  const PieceForest::Form& form = forest.form(node.patch);
  const std::uint32_t sides = form.shape.is_triangle ? 3 : 4;
  const auto is_collapsed = [&](std::uint32_t s) {
    return (form.collapsed >> s & 1) != 0 && forest.side_of_patch(node, s);
  };
  for (std::uint32_t s = 0; s < sides; ++s)
    if (is_collapsed(s) && is_collapsed((s + 1) % sides)) return {};
  const double* const g = forest.approx_determinants(piece);
  const std::size_t n = form.determinant.count();
  std::array<int, 3> out;
  for (std::size_t k = 0; k < 3; ++k) {
    const double error = forest.determinant_error(piece, k + 1);
    bool positive = true, negative = true;
    forest.for_each_kept(node, [&](std::size_t i) {
      positive = positive && g[(k + 1) * n + i] < -error;  // G_k+1 = -w^3 n_k
      negative = negative && g[(k + 1) * n + i] > error;
    });
    out[k] = positive == negative ? 0 : positive ? 1 : -1;
  }
  return out;
}

}  // namespace

std::array<int, 3> BoundaryModel::normal_signs(PieceForest::Id piece) {
  if (normal_signs_.size() <= piece) normal_signs_.resize(forest_->num_nodes());
  if (!normal_signs_[piece].is_known) {
    const PieceForest::Id parent = forest_->node(piece).parent;
    std::array<int, 3> signs{};
    if (parent != PieceForest::kNone) signs = normal_signs(parent);
    if (signs[0] == 0 || signs[1] == 0 || signs[2] == 0) {
      const auto own = own_normal_signs(*forest_, piece);
      for (std::size_t k = 0; k < 3; ++k)
        if (signs[k] == 0) signs[k] = own[k];
    }
    normal_signs_[piece].is_known = true;
    for (std::size_t k = 0; k < 3; ++k)
      normal_signs_[piece].sign[k] = static_cast<std::int8_t>(signs[k]);
  }
  return known_normal_signs(piece);
}

std::array<int, 3> BoundaryModel::known_normal_signs(PieceForest::Id piece) const {
  for (; piece != PieceForest::kNone; piece = forest_->node(piece).parent)
    if (piece < normal_signs_.size() && normal_signs_[piece].is_known) {
      const auto& s = normal_signs_[piece].sign;
      return {s[0], s[1], s[2]};
    }
  return {};
}

std::optional<int> winding_number(PieceForest& forest, const Point3d& at) {
  // Two directions for the curves that end on a half-line of the count; either is right.
  for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
    Box3d ray{at, at};
    ray.hi[axis] = std::numeric_limits<double>::infinity();
    std::vector<PieceForest::Id> met;  // none of which holds the ray's origin
    if (!descend_to(forest, ray, 100'000, [&](PieceForest::Id id) {
          if (meets(forest.node(id).hull, {at, at})) return PieceStep::kSplit;
          met.push_back(id);
          return PieceStep::kTaken;
        }))
      continue;
    StarBox line{ray, at, at};
    line.outside[axis] += 1;
    if (line.outside[axis] == line.inside[axis]) continue;
    if (const auto w = crossing_number(forest, met, line)) return w;
  }
  return std::nullopt;
}

}  // namespace veritope
