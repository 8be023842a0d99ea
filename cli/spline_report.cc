// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/spline_report.h"

#include <new>

#include "io/formats.h"
#include "io/splines/write_splines.h"

namespace veritope::cli {
namespace {

// By the control points of a spline or triangle.
template <typename Map>
void grow(std::vector<ExactInterval>& box, const Map& s) {
  for (std::size_t i = 0; i < s.component(0).size(); ++i)
    for (int c = 0; c < s.dimension(); ++c) {
      const auto k = static_cast<std::size_t>(c);
      Rational x = s.component(c)[i];
      if (s.is_rational()) x /= s.component(s.dimension())[i];
      if (k == box.size())
        box.push_back({x, x});
      else
        box[k] = hull(box[k], {x, x});
    }
}

std::vector<std::string> lossless_formats(const SplineFile& file) {
  std::vector<std::string> names;
  for (const ModelFormat& row : model_formats()) {
    if (row.kind() != ModelKind::kSplines || row.write == nullptr) continue;
    const SplineFormat format = std::get<SplineFormat>(row.id);
    const SplineLoss loss = spline_loss(file.model, format, spline_bytes(file.model, format));
    if (loss.shapes.empty() && loss.dropped.empty() && !loss.unreadable)
      names.emplace_back(row.name);
  }
  return names;
}

}  // namespace

std::vector<ExactInterval> control_box(const SplineEntity& entity) {
  std::vector<ExactInterval> box;
  if (const auto* t = std::get_if<TrimmedSurface>(&entity.shape)) {
    grow(box, t->surface);
  } else if (const auto* b = std::get_if<SplineBrep>(&entity.shape)) {
    for (const BrepFace& face : b->faces) grow(box, face.surface);
  } else if (const auto* triangle = std::get_if<ExactTriangle>(&entity.shape)) {
    grow(box, *triangle);
  } else {
    for_each_spline(entity, [&](const auto& s) { grow(box, s); });
  }
  return box;
}

void unite(std::vector<ExactInterval>& box, const std::vector<ExactInterval>& other) {
  for (std::size_t k = 0; k < other.size(); ++k)
    if (k == box.size())
      box.push_back(other[k]);
    else
      box[k] = hull(box[k], other[k]);
}

SplineReport spline_report(const std::string& path, ModelInput& input) {
  SplineReport report;
  report.path = path;
  try {
    Result<ModelFile> file = input.take();
    if (file) {
      report.file = std::get<SplineFile>(std::move(*file));
      report.lossless = lossless_formats(*report.file);
      return report;
    }
    report.fault = finding_of(file.error());
    report.exit = kExitUnreadable;
  } catch (const std::bad_alloc&) {
    report.file.reset();
    report.fault = fault_of("out-of-memory", "not enough memory for this file");
    report.exit = kExitUndecided;
  }
  return report;
}

}  // namespace veritope::cli
