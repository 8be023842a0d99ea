// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/plane_classification.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "robust/base/parallel.h"
#include "splines/knot_insertion.h"

namespace veritope::cli {
namespace {

// Word, f and shell; loops have no shells.
std::string plane_answer(const PlaneAnswer& answer, bool is_winding) {
  if (answer.is_on()) return " on - -\n";
  const char* const word = is_winding ? " - " : answer.is_in() ? " in " : " out ";
  return word + std::to_string(answer.winding) + " -\n";
}

void count_plane_answer(const PlaneAnswer& answer, bool is_winding,
                        report::ClassifyReport& report) {
  ++report.points;
  if (answer.is_on())
    ++report.on;
  else if (!is_winding)
    ++(answer.is_in() ? report.in : report.out);
}

}  // namespace

bool is_plane_model(const ModelFile& file) {
  const auto* const splines = std::get_if<SplineFile>(&file);
  if (splines == nullptr || splines->model.entities.empty()) return false;
  return std::all_of(splines->model.entities.begin(), splines->model.entities.end(),
                     [](const SplineEntity& entity) {
                       const auto* const curve = std::get_if<ExactCurve>(&entity.shape);
                       return curve != nullptr && curve->dimension() == 2;
                     });
}

Result<PlaneRegion> plane_region_of(const ModelFile& file) {
  const SplineModel& model = std::get<SplineFile>(file).model;
  std::vector<PlaneArc> arcs;
  std::vector<std::uint64_t> entities;  // of each arc
  for (std::size_t i = 0; i < model.entities.size(); ++i)
    for (PlaneArc::Curve& piece :
         bezier_pieces(std::get<ExactCurve>(model.entities[i].shape)).pieces) {
      Result<PlaneArc> arc = PlaneArc::make(std::move(piece));
      if (!arc) {
        Error error = arc.error();
        error.place.entity = i;
        return error;
      }
      arcs.push_back(std::move(*arc));
      entities.push_back(i);
    }
  Result<PlaneRegion> made = PlaneRegion::make(std::move(arcs));
  if (made) return made;
  Error error = made.error();
  if (error.place.entity) error.place.entity = entities[*error.place.entity];
  return error;
}

Status classify_points(const PlaneRegion& region, PointSource& source, unsigned jobs,
                       bool is_winding, const WriteAnswers& write, report::ClassifyReport& report) {
  PointBatch batch;
  std::vector<PointIn<2>> points;
  std::vector<PlaneAnswer> answers;
  std::string lines;
  for (;;) {
    if (const Status status = source.next(batch); !status) return status;
    if (batch.size() == 0) return ok_status();
    points.clear();
    for (const Vec3d& p : batch.points)
      points.push_back({Rational::from_double(p.x), Rational::from_double(p.y)});
    for (const auto& [at, point] : batch.exact) points[at] = {point[0], point[1]};
    answers.resize(batch.size());
    parallel_for(batch.size(), 64, jobs, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) answers[i] = region.classify(points[i]);
    });
    lines.clear();
    for (std::size_t i = 0; i < batch.size(); ++i) {
      lines.append(batch.text(i)).append(plane_answer(answers[i], is_winding));
      count_plane_answer(answers[i], is_winding, report);
    }
    if (const Status status = write(lines); !status) return status;
  }
}

}  // namespace veritope::cli
