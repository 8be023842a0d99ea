// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/micro_emit.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "io/splines/spline_stream.h"
#include "render/patch_cells.h"
#include "robust/base/parallel.h"
#include "splines/bspline_pieces.h"

namespace veritope::cli {
namespace {

// Cells that are composed before anything of them is written; each thread takes a few at a time. A jack in a tricubic
// volume has some megabytes of exact coefficients.
constexpr std::size_t kCellsInRound = 32, kCellsInChunk = 2;

// Calls make(begin, end), the cells of a chunk, in parallel, and take(made) in the order of the cells.
template <typename Made, typename Make, typename Take>
Status in_rounds(std::size_t num_cells, unsigned jobs, Make make, Take take) {
  for (std::size_t first = 0; first < num_cells; first += kCellsInRound) {
    const std::size_t size = std::min(kCellsInRound, num_cells - first);
    std::vector<Made> made(num_chunks(size, kCellsInChunk));
    parallel_for(size, kCellsInChunk, jobs,
                 [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                   made[chunk] = make(first + begin, first + end);
                 });
    for (Made& m : made)
      if (Status status = take(std::move(m)); !status) return status;
  }
  return ok_status();
}

// REQUIRES that the second degree is 0.
BezierCurve<Rational> curve_of(const BezierSurface<Rational>& s) {
  const auto all = s.coefficients();
  return {{s.degree(0)}, s.num_components(), s.is_rational(), {all.begin(), all.end()}};
}

// The degrees of a bridge are those of a curve: (2, 0).
BezierSurface<Rational> surface_of(const CurveBridge& bridge) {
  BezierSurface<Rational> out({static_cast<int>(bridge.points.size()) - 1, 0}, 3, false);
  for (std::size_t i = 0; i < bridge.points.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) out.component(static_cast<int>(c))[i] = bridge.points[i][c];
  return out;
}
Status emit_splines(const ComposedSurface& surface, const std::vector<CurveBridge>& bridges,
                    SplineFormat format, unsigned jobs, StreamedOutput& output) {
  std::vector<SplineGroup> groups;
  if (!bridges.empty()) groups.push_back({"bridges", {}, std::nullopt});
  const SplineStream stream(format, groups);
  if (Status status = output.write(stream.begin()); !status) return status;
  bool is_first = true;
  const auto write_part = [&](const std::string& text) {
    if (text.empty()) return ok_status();
    if (!std::exchange(is_first, false))
      if (Status between = output.write(stream.separator()); !between) return between;
    return output.write(text);
  };
  Status status = in_rounds<std::string>(
      surface.cells().size(), jobs,
      [&](std::size_t begin, std::size_t end) {
        std::vector<SplineEntity> entities;
        for (auto& patches : surface.compose(begin, end))
          for (ComposedPatch& p : patches)
            if (p.surface.degree(1) == 0)
              entities.push_back({to_bspline(curve_of(p.surface)), {}, std::nullopt, {}});
            else
              entities.push_back({to_bspline(p.surface), {}, std::nullopt, {}});
        return entities.empty() ? std::string() : stream.part(std::move(entities));
      },
      write_part);
  if (status && !bridges.empty()) {
    std::vector<SplineEntity> entities;
    for (const CurveBridge& b : bridges)
      entities.push_back({to_bspline(curve_of(surface_of(b))), {}, 0, {}});
    status = write_part(stream.part(std::move(entities)));
  }
  return status ? output.write(stream.end()) : status;
}

struct MadePart {
  PatchCells::Part part;
  Status status = ok_status();
};
MadePart part_of(const ComposedSurface& surface, std::size_t begin, std::size_t end) {
  MadePart out;
  const auto composed = surface.compose(begin, end);
  for (std::size_t n = begin; n < end; ++n) {
    const ComposedCell& cell = surface.cells()[n];
    for (const ComposedPatch& p : composed[n - begin])
      if (out.status)
        out.status =
            out.part.add(p.surface, {cell.grid, static_cast<std::int64_t>(cell.cell), cell.tile,
                                     p.bridge ? std::int64_t{*p.bridge} : -1, p.patch});
  }
  return out;
}
MadePart part_of(const Microstructure& micro, const std::vector<CurveBridge>& bridges) {
  MadePart out;
  for (std::size_t n = 0; n < bridges.size() && out.status; ++n) {
    const CurveBridge& b = bridges[n];
    out.status = out.part.add(surface_of(b), {b.end.grid, static_cast<std::int64_t>(b.end.cell),
                                              micro.grids[b.end.grid].tiles[b.end.cell] - 1,
                                              static_cast<std::int64_t>(n), 0});
  }
  return out;
}
Status emit_cells(const ComposedSurface& surface, const Microstructure& micro,
                  const std::vector<CurveBridge>& bridges, unsigned jobs, StreamedOutput& output) {
  PatchCells cells({"grid", "cell", "tile", "bridge", "patch"});
  const std::size_t bridge_points = 3 * bridges.size();
  Status status = output.write(PatchCells::begin(surface.num_points() + bridge_points,
                                                 surface.num_patches() + bridges.size()));
  if (status)
    status = in_rounds<MadePart>(
        surface.cells().size(), jobs,
        [&](std::size_t begin, std::size_t end) { return part_of(surface, begin, end); },
        [&](MadePart made) {
          return made.status ? output.write(cells.take(std::move(made.part))) : made.status;
        });
  if (status && !bridges.empty()) {
    MadePart made = part_of(micro, bridges);
    status = made.status ? output.write(cells.take(std::move(made.part))) : made.status;
  }
  if (!status) return status;
  return cells.end([&](std::string_view text) { return output.write(text); });
}

}  // namespace

std::string fault_of_emit_name(const std::string& path) {
  for (const char* const ending : {".vjson", ".itd", ".vtu"})
    if (path.ends_with(ending)) return "";
  return "the name " + path + " ends in no format for composed surfaces: .vjson, .itd or .vtu";
}

Status emit_surface(const ComposedSurface& surface, const Microstructure& micro,
                    const std::vector<CurveBridge>& bridges, unsigned jobs,
                    StreamedOutput& output) {
  if (output.path().ends_with(".vtu")) return emit_cells(surface, micro, bridges, jobs, output);
  return emit_splines(surface, bridges,
                      output.path().ends_with(".itd") ? SplineFormat::kItd : SplineFormat::kJson,
                      jobs, output);
}

}  // namespace veritope::cli
