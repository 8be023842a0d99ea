// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_model.h"

#include <algorithm>

#include "robust/base/check.h"

namespace veritope {

std::vector<std::string> all_attributes(const DmsModel& model) {
  std::vector<std::string> out = model.attributes;
  for (const DmsModel& own : model.attribute_domain)
    out.insert(out.end(), own.attributes.begin(), own.attributes.end());
  return out;
}

std::optional<DmsComponent> find_attribute(const DmsModel& model, std::string_view name) {
  for (std::size_t a = 0; a < model.attributes.size(); ++a)
    if (model.attributes[a] == name) return DmsComponent{&model, model.num_coordinates + a};
  for (const DmsModel& own : model.attribute_domain)
    if (auto found = find_attribute(own, name)) return found;
  return std::nullopt;
}

std::optional<std::size_t> find_control(const DmsModel& model,
                                        std::span<const std::uint32_t> vertices) {
  const auto n = static_cast<std::size_t>(model.degree);
  VT_CHECK(!model.control.is_separate && vertices.size() == n,
           "shared control points have as many vertices as the degree");
  const std::vector<std::uint32_t>& at = model.control.at;
  std::size_t low = 0, high = at.size() / n;
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    const auto entry = std::span(at).subspan(middle * n, n);
    if (std::lexicographical_compare(entry.begin(), entry.end(), vertices.begin(),
                                     vertices.end())) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  if (low == at.size() / n) return std::nullopt;
  const auto entry = std::span(at).subspan(low * n, n);
  if (!std::equal(entry.begin(), entry.end(), vertices.begin())) return std::nullopt;
  return low;
}

std::vector<std::uint32_t> control_vertices(const TetrahedronCorners& tetrahedron,
                                            const TetrahedralIndex& beta) {
  std::vector<std::uint32_t> vertices;
  for (std::size_t m = 0; m < 4; ++m)
    vertices.insert(vertices.end(), static_cast<std::size_t>(beta[m]), tetrahedron[m]);
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

std::size_t control_of(const DmsModel& model, std::uint32_t tetrahedron,
                       const TetrahedralIndex& beta) {
  if (model.control.is_separate)
    return tetrahedron * num_tetrahedral_indices(model.degree) + tetrahedral_index(beta);
  const auto found = find_control(model, control_vertices(model.tetrahedra[tetrahedron], beta));
  VT_CHECK(found.has_value(), "every multiset of vertices of a tetrahedron has a control point");
  return *found;
}

std::string to_string(const TetrahedralIndex& index) {
  std::string text = "(";
  for (std::size_t m = 0; m < 4; ++m) text += (m > 0 ? "," : "") + std::to_string(index[m]);
  return text + ")";
}

}  // namespace veritope
