// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_insert.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "predicates/exact_point.h"
#include "robust/base/check.h"
#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_validity.h"

namespace veritope {
namespace {

Status check_new_cloud(const DmsModel& model, const DmsCloud& cloud) {
  const auto n = static_cast<std::size_t>(model.degree);
  if (cloud.size() != 1 && cloud.size() != n && cloud.size() != n + 1)
    return bad_argument("the new vertex must have 1, " + std::to_string(n) + " or " +
                        std::to_string(n + 1) + " knots, not " + std::to_string(cloud.size()));
  for (const DmsPoint& knot : cloud)
    for (const Rational& c : knot)
      if (const Status status = check_dms_number(c); !status) return status;
  if (model.clouds.size() + 1 > kMaxDmsVertices || model.tetrahedra.size() + 3 > kMaxDmsTetrahedra)
    return Error{Code::kOverLimit, {}, "the model would have too many vertices or tetrahedra"};
  return ok_status();
}

// The tetrahedron that has the point inside.
Result<std::uint32_t> find_around(const DmsModel& model, const DmsPoint& point) {
  const auto place = DmsEvaluator(model).locate(point);
  if (!place) return bad_argument("the point is outside of the domain");
  const TetrahedronCorners& corners = model.tetrahedra[place->tetrahedron];
  std::size_t zeros = 0;
  for (std::size_t m = 0; m < 4; ++m) {
    std::array<const DmsPoint*, 4> at{};
    for (std::size_t i = 0; i < 4; ++i) at[i] = i == m ? &point : &model.knot(corners[i], 0);
    if (orient3d(ExactPoint3(*at[0]), ExactPoint3(*at[1]), ExactPoint3(*at[2]),
                 ExactPoint3(*at[3])) == Sign::kZero)
      ++zeros;
  }
  if (zeros == 0) return place->tetrahedron;
  constexpr std::array<const char*, 3> kPlaces{"on a face", "on an edge", "at a vertex"};
  return bad_argument(std::string("the point is ") + kPlaces.at(zeros - 1) + " of tetrahedron " +
                      std::to_string(place->tetrahedron) + ", not inside of it");
}

bool has_all(std::span<const std::uint32_t> vertices, const TetrahedronCorners& corners) {
  return std::ranges::all_of(
      corners, [&](std::uint32_t v) { return std::ranges::find(vertices, v) != vertices.end(); });
}

class DmsInserter {
 public:
  DmsInserter(const DmsModel& model, const DmsCloud& cloud, std::uint32_t tetrahedron)
      : model_(model),
        corners_(model.tetrahedra[tetrahedron]),
        vertex_(static_cast<std::uint32_t>(model.clouds.size())) {
    out_.tetrahedron = tetrahedron;
    DmsModel& out = out_.model;
    out.degree = model.degree;
    out.attributes = model.attributes;
    out.clouds = model.clouds;
    out.clouds.push_back(cloud);
    out.tetrahedra = model.tetrahedra;
    for (std::size_t m = 0; m < 4; ++m) {
      TetrahedronCorners part = corners_;
      part[m] = vertex_;
      if (m == 0)
        out.tetrahedra[tetrahedron] = part;
      else
        out.tetrahedra.push_back(part);
    }
  }

  Result<DmsInsertion> run() {
    keep_control();
    add_control();
    for (const Rational& c : entries_.values)
      if (const Status status = check_dms_number(c); !status) return status.error();
    if (const Status status = set_dms_control(out_.model, std::move(entries_)); !status)
      return status.error();
    out_.defects = find_dms_defects(out_.model);
    return std::move(out_);
  }

 private:
  // All but those that have all four corners, which no part has.
  void keep_control() {
    const auto n = static_cast<std::size_t>(model_.degree);
    for (std::size_t c = 0; c < model_.num_control(); ++c) {
      const auto at = std::span(model_.control.at).subspan(c * n, n);
      if (has_all(at, corners_)) continue;
      entries_.keys.insert(entries_.keys.end(), at.begin(), at.end());
      const auto value = model_.value(c);
      entries_.values.insert(entries_.values.end(), value.begin(), value.end());
    }
  }
  // Those of the new vertex and at most three of the corners.
  void add_control() {
    const BPatch<Rational> patch = patch_of_tetrahedron(model_, out_.tetrahedron);
    for (int times = 1; times <= model_.degree; ++times)
      for_each_tetrahedral_index(model_.degree - times, [&](const TetrahedralIndex& rest) {
        if (std::ranges::all_of(rest, [](int i) { return i > 0; })) return;
        std::vector<DmsPoint> knots;
        for (int i = 0; i < times; ++i) knots.push_back(out_.model.knot(vertex_, i));
        for (std::size_t m = 0; m < 4; ++m)
          for (int i = 0; i < rest[m]; ++i) knots.push_back(model_.knot(corners_[m], i));
        const auto at = control_vertices(corners_, rest);
        entries_.keys.insert(entries_.keys.end(), at.begin(), at.end());
        entries_.keys.insert(entries_.keys.end(), static_cast<std::size_t>(times), vertex_);
        for (Rational& c : patch.blossom(knots)) entries_.values.push_back(std::move(c));
      });
  }

  const DmsModel& model_;
  TetrahedronCorners corners_;
  std::uint32_t vertex_;
  DmsEntries entries_;
  DmsInsertion out_;
};

}  // namespace

BPatch<Rational> patch_of_tetrahedron(const DmsModel& model, std::uint32_t tetrahedron) {
  const TetrahedronCorners& corners = model.tetrahedra[tetrahedron];
  std::vector<Rational> control;
  for_each_tetrahedral_index(model.degree, [&](const TetrahedralIndex& beta) {
    const auto value = model.value(control_of(model, tetrahedron, beta));
    control.insert(control.end(), value.begin(), value.end());
  });
  return BPatch<Rational>(model.degree, model.num_components(), std::move(control),
                          [&](const TetrahedralIndex& gamma) {
                            std::array<DmsPoint, 4> points;
                            for (std::size_t m = 0; m < 4; ++m)
                              points[m] = model.knot(corners[m], gamma[m]);
                            // No half-open rule asks this frame, so its orientation has no effect.
                            return simplex_frame<Rational>({0, 1, 2, 3}, points, Sign::kPositive);
                          });
}

Result<DmsInsertion> insert_dms_vertex(const DmsModel& model, const DmsCloud& cloud) {
  if (model.control.is_separate)
    return bad_argument("vertices are inserted into models with shared control points only");
  if (const Status status = check_new_cloud(model, cloud); !status) return status.error();
  const Result<std::uint32_t> around = find_around(model, cloud[0]);
  if (!around) return around.error();
  return DmsInserter(model, cloud, *around).run();
}

}  // namespace veritope
