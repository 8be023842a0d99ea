// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/occt_bezier.h: patches as Open CASCADE's surfaces, rounded. Only for files that are compiled with its headers.
#pragma once
#include <Geom_BezierSurface.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <gp_Pnt.hxx>

#include "solids/patches/patch.h"
#include "splines/bezier_triangle_algebra.h"

namespace veritope::bench {

inline Handle(Geom_BezierSurface) occt_bezier(const Patch& patch) {
  const Patch::Tensor map =
      patch.is_triangle() ? as_tensor_product(patch.triangle()) : patch.tensor();
  const int p = map.degree(0), q = map.degree(1);
  TColgp_Array2OfPnt poles(1, p + 1, 1, q + 1);
  TColStd_Array2OfReal weights(1, p + 1, 1, q + 1);
  for (int i = 0; i <= p; ++i)
    for (int j = 0; j <= q; ++j) {
      const auto k = static_cast<std::size_t>(i * (q + 1) + j);
      const Rational w = map.is_rational() ? map.component(3)[k] : Rational(1);
      const auto at = [&](int c) { return nearest_double(map.component(c)[k] / w); };
      poles.SetValue(i + 1, j + 1, gp_Pnt(at(0), at(1), at(2)));
      weights.SetValue(i + 1, j + 1, nearest_double(w));
    }
  return new Geom_BezierSurface(poles, weights);
}

}  // namespace veritope::bench
