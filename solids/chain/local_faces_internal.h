// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/local_faces_internal.h: the faces into which hyperplanes through one point cut the space around it.
// Theory: docs/THEORY.md, CHAIN-2.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "robust/base/sign.h"
#include "solids/chain/cell.h"

namespace veritope::internal {

template <std::size_t Dim>
Rational dot_product(const NormalIn<Dim>& a, const NormalIn<Dim>& b) {
  Rational out;
  for (std::size_t k = 0; k < Dim; ++k) out += a[k] * b[k];
  return out;
}

/// A face, by the side of each hyperplane on which it lies, and points of it: q + t v[0] + t^2 v[1] + ... for small
/// t > 0. Without a vector it is the common flat of all hyperplanes, which contains q.
template <std::size_t Dim>
struct LocalFace {
  std::vector<Sign> sides;
  std::vector<NormalIn<Dim>> vectors;
  bool is_open = false;
};

/// Walks over all faces, lower ones included.
template <std::size_t Dim>
class LocalFaces {
 public:
  /// @param normals  one of each hyperplane
  explicit LocalFaces(std::span<const NormalIn<Dim>> normals) : normals_(normals) {}

  /// Calls visit(face) for every face, for some of them more than once, until it returns false.
  template <typename Visit>
  void visit(Visit visit) const {
    std::vector<NormalIn<Dim>> axes(Dim);
    for (std::size_t k = 0; k < Dim; ++k) axes[k][k] = Rational(1);
    std::vector<Step> steps;
    bool goes_on = true;
    descend(axes, steps, visit, goes_on);
  }

 private:
  // From a flat to its intersection with a hyperplane: a vector of the flat across the latter, and the signs of its
  // products with all normals.
  struct Step {
    NormalIn<Dim> across;
    std::vector<Sign> signs;
  };

  // Within the flat that the vectors span, which the steps led to.
  template <typename Visit>
  void descend(const std::vector<NormalIn<Dim>>& basis, std::vector<Step>& steps, Visit& visit,
               bool& goes_on) const {
    std::vector<std::vector<Rational>> traces;
    for (const NormalIn<Dim>& n : normals_) {
      std::vector<Rational> trace;
      std::size_t across = basis.size();
      for (const NormalIn<Dim>& b : basis) {
        trace.push_back(dot_product<Dim>(n, b));
        if (across == basis.size() && trace.back().sign() != 0) across = trace.size() - 1;
      }
      if (across == basis.size()) continue;  // it contains the flat
      const Rational unit = trace[across];
      for (Rational& x : trace) x /= unit;
      bool is_known = false;
      for (const auto& t : traces) is_known = is_known || t == trace;
      if (is_known) continue;
      traces.push_back(trace);
      steps.push_back(step_along(basis[across]));
      descend(kernel(basis, trace, across), steps, visit, goes_on);
      steps.pop_back();
      if (!goes_on) return;
    }
    if (traces.empty()) climb(steps, visit, goes_on);
  }

  Step step_along(const NormalIn<Dim>& across) const {
    Step out{across, {}};
    for (const NormalIn<Dim>& n : normals_) out.signs.push_back(dot_product<Dim>(n, across).sign());
    return out;
  }

  // From the least flat back, to either side of every hyperplane.
  template <typename Visit>
  void climb(const std::vector<Step>& steps, Visit& visit, bool& goes_on) const {
    LocalFace<Dim> face;
    face.sides.assign(normals_.size(), Sign::kZero);
    climb_from(steps, std::move(face), visit, goes_on);
  }
  template <typename Visit>
  void climb_from(std::span<const Step> steps, LocalFace<Dim> face, Visit& visit,
                  bool& goes_on) const {
    face.is_open = steps.empty();
    goes_on = visit(std::as_const(face));
    if (face.is_open) return;
    for (const Sign side : {Sign::kPositive, Sign::kNegative}) {
      if (!goes_on) return;
      LocalFace<Dim> next = face;
      next.vectors.push_back(steps.back().across);
      if (side < 0)
        for (Rational& x : next.vectors.back()) x.negate();
      for (std::size_t i = 0; i < next.sides.size(); ++i)
        if (next.sides[i] == 0) next.sides[i] = steps.back().signs[i] * side;
      climb_from(steps.first(steps.size() - 1), std::move(next), visit, goes_on);
    }
  }

  // A basis of the vectors with trace . coordinates = 0; trace[across] is 1.
  static std::vector<NormalIn<Dim>> kernel(const std::vector<NormalIn<Dim>>& basis,
                                           const std::vector<Rational>& trace, std::size_t across) {
    std::vector<NormalIn<Dim>> out;
    for (std::size_t i = 0; i < basis.size(); ++i) {
      if (i == across) continue;
      NormalIn<Dim>& v = out.emplace_back(basis[i]);
      for (std::size_t k = 0; k < Dim; ++k) v[k] -= trace[i] * basis[across][k];
    }
    return out;
  }

  std::span<const NormalIn<Dim>> normals_;
};

}  // namespace veritope::internal
