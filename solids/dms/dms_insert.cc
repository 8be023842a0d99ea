// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_insert.h"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "predicates/exact_point.h"
#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_validity.h"

namespace veritope {
namespace {

Status check_new_cloud(const DmsModel& model, const DmsCloud& cloud) {
  if (const Status status = check_dms_cloud_size("the new vertex", model.degree, cloud.size());
      !status)
    return status;
  for (const DmsPoint& knot : cloud)
    for (const Rational& c : knot)
      if (const Status status = check_dms_number(c); !status) return status;
  if (model.clouds.size() + 1 > kMaxDmsVertices)
    return Error{Code::kOverLimit, {}, "the model would have too many vertices"};
  return ok_status();
}

// What the point is inside of: a tetrahedron, a face, an edge; and all tetrahedra that have it.
Result<DmsCut> find_cut(const DmsModel& model, const DmsPoint& point) {
  const auto place = DmsEvaluator(model).locate(point);
  if (!place) return bad_argument("the point is outside of the domain");
  const TetrahedronCorners& corners = model.tetrahedra[place->tetrahedron];
  DmsCut cut;
  for (std::size_t m = 0; m < 4; ++m) {
    std::array<const DmsPoint*, 4> at{};
    for (std::size_t i = 0; i < 4; ++i) at[i] = i == m ? &point : &model.knot(corners[i], 0);
    if (orient3d(ExactPoint3(*at[0]), ExactPoint3(*at[1]), ExactPoint3(*at[2]),
                 ExactPoint3(*at[3])) != Sign::kZero)
      cut.simplex.push_back(corners[m]);
  }
  if (cut.simplex.size() == 1)
    return bad_argument("the point is at vertex " + std::to_string(cut.simplex[0]));
  std::ranges::sort(cut.simplex);
  for (std::uint32_t t = 0; t < model.tetrahedra.size(); ++t) {
    const TetrahedronCorners& other = model.tetrahedra[t];
    if (std::ranges::all_of(cut.simplex, [&](std::uint32_t v) {
          return std::ranges::find(other, v) != other.end();
        }))
      cut.tetrahedra.push_back(t);
  }
  return cut;
}

class DmsInserter {
 public:
  DmsInserter(const DmsModel& model, const DmsCloud& cloud, DmsCut cut)
      : model_(model), vertex_(static_cast<std::uint32_t>(model.clouds.size())) {
    out_.tetrahedron = cut.tetrahedra[0];
    out_.cut = std::move(cut);
    DmsModel& out = out_.model;
    out.degree = model.degree;
    out.attributes = model.attributes;
    out.clouds = model.clouds;
    out.clouds.push_back(cloud);
    out.tetrahedra = model.tetrahedra;
    out.num_coordinates = model.num_coordinates;
    out.attribute_domain = model.attribute_domain;
    for (const std::uint32_t t : out_.cut.tetrahedra) cut_tetrahedron(t);
  }

  Result<DmsInsertion> run() {
    if (out_.model.tetrahedra.size() > kMaxDmsTetrahedra)
      return Error{Code::kOverLimit, {}, "the model would have too many tetrahedra"};
    keep_control();
    for (const std::uint32_t t : out_.cut.tetrahedra) collect_control(t);
    add_control();
    for (const Rational& c : entries_.values)
      if (const Status status = check_dms_number(c); !status) return status.error();
    if (const Status status = set_dms_control(out_.model, std::move(entries_)); !status)
      return status.error();
    out_.defects = find_dms_defects(out_.model);
    if (out_.defects.count > 0) return std::move(out_);
    out_.change.resize(model_.num_components());  // inside of a tetrahedron all is 0 by DMS-3.S1
    if (out_.cut.simplex.size() < 4) out_.change = bound_dms_change(model_, out_.model, out_.cut);
    return std::move(out_);
  }

 private:
  void cut_tetrahedron(std::uint32_t t) {
    const TetrahedronCorners corners = model_.tetrahedra[t];
    bool is_first = true;
    for (std::size_t m = 0; m < 4; ++m) {
      if (!out_.cut.has(corners[m])) continue;
      TetrahedronCorners part = corners;
      part[m] = vertex_;
      if (is_first)
        out_.model.tetrahedra[t] = part;
      else
        out_.model.tetrahedra.push_back(part);
      is_first = false;
    }
  }
  // Whether no part has all these vertices.
  bool is_cut(std::span<const std::uint32_t> vertices) const {
    return std::ranges::all_of(out_.cut.simplex, [&](std::uint32_t v) {
      return std::ranges::find(vertices, v) != vertices.end();
    });
  }
  void keep_control() {
    const auto n = static_cast<std::size_t>(model_.degree);
    for (std::size_t c = 0; c < model_.num_control(); ++c) {
      const auto at = std::span(model_.control.at).subspan(c * n, n);
      if (is_cut(at)) continue;
      entries_.keys.insert(entries_.keys.end(), at.begin(), at.end());
      const auto value = model_.value(c);
      entries_.values.insert(entries_.values.end(), value.begin(), value.end());
    }
  }
  // What the blossom of a tetrahedron says of the control points at the new vertex.
  void collect_control(std::uint32_t t) {
    const TetrahedronCorners& corners = model_.tetrahedra[t];
    const BPatch<Rational> patch = patch_of_tetrahedron(model_, t);
    for (int times = 1; times <= model_.degree; ++times)
      for_each_tetrahedral_index(model_.degree - times, [&](const TetrahedralIndex& rest) {
        std::vector<std::uint32_t> at = control_vertices(corners, rest);
        if (is_cut(at)) return;
        std::vector<DmsPoint> knots;
        for (int i = 0; i < times; ++i) knots.push_back(out_.model.knot(vertex_, i));
        for (std::size_t m = 0; m < 4; ++m)
          for (int i = 0; i < rest[m]; ++i) knots.push_back(model_.knot(corners[m], i));
        at.insert(at.end(), static_cast<std::size_t>(times), vertex_);
        wanted_[std::move(at)].push_back(patch.blossom(knots));
      });
  }
  // Their means.
  void add_control() {
    for (const auto& [at, values] : wanted_) {
      entries_.keys.insert(entries_.keys.end(), at.begin(), at.end());
      for (std::size_t c = 0; c < model_.num_components(); ++c) {
        Rational sum;
        for (const auto& value : values) sum += value[c];
        entries_.values.push_back(sum / Rational(static_cast<std::int64_t>(values.size())));
      }
    }
  }

  const DmsModel& model_;
  std::uint32_t vertex_;
  std::map<std::vector<std::uint32_t>, std::vector<std::vector<Rational>>> wanted_;
  DmsEntries entries_;
  DmsInsertion out_;
};

}  // namespace

Result<DmsInsertion> insert_dms_vertex(const DmsModel& model, const DmsCloud& cloud) {
  if (model.control.is_separate)
    return bad_argument("vertices are inserted into models with shared control points only");
  if (const Status status = check_new_cloud(model, cloud); !status) return status.error();
  Result<DmsCut> cut = find_cut(model, cloud[0]);
  if (!cut) return cut.error();
  return DmsInserter(model, cloud, std::move(*cut)).run();
}

}  // namespace veritope
