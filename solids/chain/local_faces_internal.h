// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/local_faces_internal.h: the faces into which hyperplanes through one point cut the space around it.
// Theory: docs/THEORY.md, CHAIN-2.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "robust/base/sign.h"
#include "solids/chain/cell.h"

namespace veritope::internal {

/// A face: the points q + t v[0] + t^2 v[1] + ... for small t > 0 lie in it; without a vector the point q itself, or
/// the common line or plane of all hyperplanes.
template <std::size_t Dim>
using FaceFlag = std::vector<NormalIn<Dim>>;

template <std::size_t Dim>
Rational dot_product(const NormalIn<Dim>& a, const NormalIn<Dim>& b) {
  Rational out;
  for (std::size_t k = 0; k < Dim; ++k) out += a[k] * b[k];
  return out;
}

/// On which side of a hyperplane the face lies.
template <std::size_t Dim>
Sign side_of_face(const NormalIn<Dim>& normal, const FaceFlag<Dim>& face) {
  for (const NormalIn<Dim>& v : face)
    if (const Sign s = dot_product<Dim>(normal, v).sign(); s != 0) return s;
  return Sign::kZero;
}

/// Walks over all chains of faces, one in the closure of the next, from the least face to an open one.
template <std::size_t Dim>
class LocalFaces {
 public:
  /// @param normals  of the hyperplanes; multiples of one are one hyperplane
  explicit LocalFaces(const std::vector<NormalIn<Dim>>& normals) : normals_(normals) {}

  /// The flags of all open faces, some of them more than once. The first vectors of a flag are those of a lower face,
  /// and all lower faces occur in this way.
  std::vector<FaceFlag<Dim>> open_faces() const {
    std::vector<NormalIn<Dim>> axes(Dim);
    for (std::size_t k = 0; k < Dim; ++k) axes[k][k] = Rational(1);
    return open_faces_of(axes);
  }

 private:
  // Within the flat that the vectors span.
  std::vector<FaceFlag<Dim>> open_faces_of(const std::vector<NormalIn<Dim>>& basis) const {
    std::vector<FaceFlag<Dim>> out;
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
      for (FaceFlag<Dim>& flag : open_faces_of(kernel(basis, trace, across)))
        for (const bool is_ahead : {true, false}) {
          FaceFlag<Dim> next = flag;
          next.push_back(basis[across]);
          if (!is_ahead)
            for (Rational& x : next.back()) x.negate();
          out.push_back(std::move(next));
        }
    }
    if (traces.empty()) out.emplace_back();
    return out;
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

  const std::vector<NormalIn<Dim>>& normals_;
};

}  // namespace veritope::internal
