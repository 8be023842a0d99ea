// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/sheet_maps.h"

#include <utility>
#include <vector>

#include "verify/certify/crossing_witness.h"

namespace veritope {

const SheetMaps::Sheet& SheetMaps::sheet(std::uint32_t patch) {
  const auto known = sheets_.find(patch);
  if (known != sheets_.end()) return known->second;
  const PieceForest::Form& form = forest_.form(patch);
  const int components = form.is_rational ? 4 : 3;
  const std::size_t n = form.shape.count() * static_cast<std::size_t>(components);
  std::vector<double> control(form.root_control.begin(),
                              form.root_control.begin() + static_cast<std::ptrdiff_t>(n));
  BezierSurface<double> map =
      form.shape.is_triangle ? tensor_of_triangle(BezierTriangle<double>(
                                   form.shape.p, components, form.is_rational, std::move(control)))
                             : BezierSurface<double>({form.shape.p, form.shape.q}, components,
                                                     form.is_rational, std::move(control));
  return sheets_.emplace(patch, Sheet{std::move(map), form.origin}).first->second;
}

}  // namespace veritope
