// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_identity.h"

#include <cstddef>
#include <string>

#include "solids/dms/dms_validity.h"

namespace veritope {

Result<DmsModel> identity_dms(std::span<const DmsPoint> points,
                              std::span<const TetrahedronCorners> tetrahedra) {
  if (tetrahedra.empty()) return bad_argument("a domain needs a tetrahedron");
  constexpr std::uint32_t kNone = 0xffffffffu;
  std::vector<std::uint32_t> number(points.size(), kNone);
  for (const TetrahedronCorners& t : tetrahedra)
    for (const std::uint32_t v : t) number[v] = 0;
  DmsModel model;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (number[v] == kNone) continue;
    for (const Rational& c : points[v])
      if (const Status status = check_dms_number(c); !status) {
        Error error = status.error();
        error.place.vertex = v;
        return error;
      }
    number[v] = static_cast<std::uint32_t>(model.clouds.size());
    model.clouds.push_back({points[v]});
    model.control.at.push_back(number[v]);
    model.control.values.insert(model.control.values.end(), points[v].begin(), points[v].end());
  }
  model.tetrahedra.assign(tetrahedra.begin(), tetrahedra.end());
  for (TetrahedronCorners& t : model.tetrahedra)
    for (std::uint32_t& v : t) v = number[v];
  if (const Status status = validate(model); !status) return status.error();
  return model;
}

}  // namespace veritope
