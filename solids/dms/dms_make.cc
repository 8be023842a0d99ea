// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_make.h"

#include <algorithm>
#include <string>
#include <utility>

#include "solids/dms/dms_defects.h"
#include "solids/dms/dms_simplices_internal.h"
#include "solids/dms/dms_validity.h"

namespace veritope {
namespace {

// All multisets of n vertices that have exactly the vertices of the simplex, which are ascending.
template <std::size_t N>
void add_multisets(const std::array<std::uint32_t, N>& simplex, int n,
                   std::vector<std::vector<std::uint32_t>>& out) {
  for_each_tetrahedral_index(n, [&](const TetrahedralIndex& times) {
    std::vector<std::uint32_t> vertices;
    for (std::size_t m = 0; m < 4; ++m) {
      if ((times[m] > 0) != (m < N)) return;
      if (m < N) vertices.insert(vertices.end(), static_cast<std::size_t>(times[m]), simplex[m]);
    }
    out.push_back(std::move(vertices));
  });
}

Status check_identity(const DmsModel& domain) {
  if (domain.degree != 1)
    return bad_argument("a domain must have degree 1, not " + std::to_string(domain.degree));
  if (!domain.attribute_domain.empty())
    return bad_argument("a domain must not have an attribute domain");
  if (domain.control.is_separate) return bad_argument("a domain must have shared control points");
  for (std::size_t c = 0; c < domain.num_control(); ++c) {
    const std::uint32_t v = domain.control.at[c];
    if (!std::ranges::equal(domain.value(c).first(3), domain.clouds[v][0]))
      return bad_argument(
          "the map of a domain must be the identity, and the control point of vertex " +
          std::to_string(v) + " is not at the vertex");
  }
  return ok_status();
}

std::vector<Rational> vertex_attributes_of(const DmsModel& domain) {
  const std::size_t count = domain.attributes.size();
  std::vector<Rational> out(domain.clouds.size() * count);
  for (std::size_t c = 0; c < domain.num_control(); ++c)
    for (std::size_t a = 0; a < count; ++a)
      out[domain.control.at[c] * count + a] = domain.value(c)[3 + a];
  return out;
}

}  // namespace

DmsPoint control_place(const DmsModel& model, std::span<const std::uint32_t> vertices,
                       DmsControlRule rule) {
  DmsPoint sum;
  int times = 0;  // how often the vertex occurred before
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    times = i > 0 && vertices[i] == vertices[i - 1] ? times + 1 : 0;
    const DmsPoint& knot = model.knot(vertices[i], rule == DmsControlRule::kGreville ? times : 0);
    for (std::size_t c = 0; c < 3; ++c) sum[c] += knot[c];
  }
  for (Rational& c : sum) c /= Rational(vertices.size());
  return sum;
}

void set_control_by_rule(DmsModel& model, DmsControlRule rule,
                         std::span<const Rational> vertex_attributes) {
  const internal::DmsSimplices simplices(model.tetrahedra);
  std::vector<std::vector<std::uint32_t>> multisets;
  for (const auto& s : simplices.vertices) add_multisets(s, model.degree, multisets);
  for (const auto& s : simplices.edges) add_multisets(s, model.degree, multisets);
  for (const auto& s : simplices.triangles) add_multisets(s, model.degree, multisets);
  for (const auto& s : simplices.tetrahedra) add_multisets(s, model.degree, multisets);
  std::sort(multisets.begin(), multisets.end());
  model.control = {};
  for (const auto& vertices : multisets) {
    model.control.at.insert(model.control.at.end(), vertices.begin(), vertices.end());
    for (Rational& c : control_place(model, vertices, rule))
      model.control.values.push_back(std::move(c));
    for (std::size_t a = 0; a < model.attributes.size(); ++a) {
      Rational sum;
      for (const std::uint32_t v : vertices)
        sum += vertex_attributes[v * model.attributes.size() + a];
      model.control.values.push_back(sum / Rational(vertices.size()));
    }
  }
}

Result<DmsModel> make_dms(const DmsModel& domain, const DmsMakeOptions& options) {
  if (options.degree < 1 || options.degree > kMaxDmsDegree)
    return check_dms_degree(options.degree < 0 ? 0 : static_cast<std::uint64_t>(options.degree))
        .error();
  if (options.clouds && options.clouds->radius.sign() == Sign::kNegative)
    return bad_argument("the radius of clouds must not be negative");
  if (const Status status = check_identity(domain); !status) return status.error();
  if (const DmsDefects defects = find_dms_defects(domain, 1); defects.count > 0)
    return bad_argument(std::string("the domain has defects: ") +
                        fault_name(defects.first[0].fault) + ": " + to_string(defects.first[0]));
  DmsModel model{options.degree, domain.attributes, domain.clouds, domain.tetrahedra, {}};
  for (DmsCloud& cloud : model.clouds) cloud.resize(1);
  if (options.clouds) internal::draw_clouds(model, *options.clouds);
  set_control_by_rule(model, options.control, vertex_attributes_of(domain));
  for (const DmsCloud& cloud : model.clouds)
    for (const DmsPoint& knot : cloud)
      for (const Rational& c : knot)
        if (const Status status = check_dms_number(c); !status) return status.error();
  for (const Rational& c : model.control.values)
    if (const Status status = check_dms_number(c); !status) return status.error();
  return model;
}

}  // namespace veritope
