// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/dms_cells.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "render/spline_view_internal.h"
#include "render/vtu_text_internal.h"
#include "robust/base/check.h"
#include "robust/base/parallel.h"
#include "solids/dms/dms_parts.h"
#include "solids/dms/dms_piece.h"
#include "solids/dms/dms_restriction.h"

namespace veritope {
namespace {

constexpr int kTetrahedronType = 78;          // VTK_BEZIER_TETRAHEDRON
constexpr std::size_t kTetrahedraInRound = 64;  // a thread's

// For each control point of a part, in VTK's order, its place in the domain and the components there, rounded.
using Part = std::vector<std::vector<double>>;
// The parts of a tetrahedron, or why there are none.
using Parts = Result<std::vector<Part>>;

class PartMaker {
 public:
  PartMaker(const DmsModel& model, const DmsKnotTable& knots, const DmsEvaluator& evaluator,
            std::size_t max_cells)
      : model_(model), knots_(knots), pieces_(model, evaluator), max_cells_(max_cells) {}

  Parts make(std::uint32_t tetrahedron) {
    const auto cells = polynomial_parts(knots_, tetrahedron, max_cells_);
    if (!cells)
      return internal::view_error(Code::kOverLimit, tetrahedron,
                                  "triangles of knots cut the tetrahedron into more than " +
                                      std::to_string(max_cells_) + " cells");
    std::vector<Part> out;
    for (const DmsCell& cell : *cells) {
      const auto components = pieces_.components(cell[0], model_.num_components());
      VT_CHECK(components.has_value(), "parts of tetrahedra are in the domain");
      DmsRestriction map(model_.degree, cell[0], *components);
      for (const auto& corners : cell) out.push_back(part_on(corners, map));
    }
    for (const Part& part : out)
      for (const std::vector<double>& point : part)
        if (!std::all_of(point.begin(), point.end(), [](double x) { return std::isfinite(x); }))
          return internal::view_error(Code::kNotFinite, tetrahedron,
                                      "a control point is too large for binary64");
    return out;
  }

 private:
  Part part_on(const std::array<DmsPoint, 4>& corners, DmsRestriction& map) const {
    const auto components = map.on(corners);
    Part out(num_tetrahedral_indices(model_.degree));
    for_each_tetrahedral_index(model_.degree, [&](const TetrahedralIndex& index) {
      std::vector<double>& point = out[vtk_tetrahedron_index(index)];
      for (std::size_t c = 0; c < 3; ++c) {
        Rational sum;
        for (std::size_t m = 0; m < 4; ++m) sum += Rational(index[m]) * corners[m][c];
        point.push_back(nearest_double(sum / Rational(model_.degree)));
      }
      for (const std::vector<double>& component : components)
        point.push_back(component[tetrahedral_index(index)]);
    });
    return out;
  }

  const DmsModel& model_;
  const DmsKnotTable& knots_;
  DmsPieces pieces_;
  std::size_t max_cells_;
};

class DmsGrid {
 public:
  explicit DmsGrid(const DmsModel& model) : model_(model), values_(model.attributes.size()) {}

  Status add(const Part& part, std::uint32_t tetrahedron) {
    for (const std::vector<double>& point : part) {
      connectivity_ += std::to_string(number_of(point)) + ' ';
      if (numbers_.size() > internal::kMostViewPoints)
        return internal::view_error(Code::kOverLimit, tetrahedron, "more than 33554432 points");
    }
    connectivity_ += '\n';
    num_corners_ += part.size();
    offsets_ += std::to_string(num_corners_) + '\n';
    types_ += std::to_string(kTetrahedronType) + '\n';
    tetrahedra_ += std::to_string(tetrahedron) + '\n';
    for (int a = 0; a < 3; ++a) degrees_ += std::to_string(model_.degree) + (a == 2 ? '\n' : ' ');
    ++num_cells_;
    return ok_status();
  }
  DmsCells write() const {
    using internal::vtu_array;
    std::string out = internal::vtu_begin(numbers_.size(), num_cells_) + "<PointData>\n";
    for (std::size_t a = 0; a < values_.size(); ++a)
      out += vtu_array("Float64", internal::xml_text(model_.attributes[a]), 1, values_[a]);
    out += "</PointData>\n<CellData HigherOrderDegrees=\"HigherOrderDegrees\">\n" +
           vtu_array("Float64", "HigherOrderDegrees", 3, degrees_) +
           vtu_array("Int64", "tetrahedron", 1, tetrahedra_) + "</CellData>\n<Points>\n" +
           vtu_array("Float64", "Points", 3, points_) + "</Points>\n<Cells>\n" +
           vtu_array("Int64", "connectivity", 1, connectivity_) +
           vtu_array("Int64", "offsets", 1, offsets_) + vtu_array("UInt8", "types", 1, types_) +
           "</Cells>\n" + std::string(internal::kVtuEnd);
    return {std::move(out), num_cells_};
  }

 private:
  std::size_t number_of(const std::vector<double>& point) {
    std::string key(point.size() * sizeof(double), '\0');
    for (std::size_t i = 0; i < point.size(); ++i) {
      const double x = point[i] + 0.0;  // -0 becomes 0
      std::memcpy(key.data() + i * sizeof x, &x, sizeof x);
    }
    const auto [at, is_new] = numbers_.try_emplace(std::move(key), numbers_.size());
    if (!is_new) return at->second;
    for (std::size_t c = 0; c < 3; ++c) {
      internal::append_number(points_, point[3 + c]);
      points_ += c == 2 ? '\n' : ' ';
    }
    for (std::size_t a = 0; a < values_.size(); ++a) {
      internal::append_number(values_[a], point[6 + a]);
      values_[a] += '\n';
    }
    return at->second;
  }

  const DmsModel& model_;
  std::unordered_map<std::string, std::size_t> numbers_;  // by the bytes of place and values
  std::uint64_t num_cells_ = 0, num_corners_ = 0;
  std::string points_, connectivity_, offsets_, types_, degrees_, tetrahedra_;
  std::vector<std::string> values_;
};

}  // namespace

Result<DmsCells> dms_cells(const DmsModel& model, const DmsCellsOptions& options) {
  VT_CHECK(model.num_coordinates == 3, "an attribute domain has no shape");
  const DmsKnotTable knots(model);
  const DmsEvaluator evaluator(model);
  DmsGrid grid(model);
  const std::size_t jobs = options.jobs == 0 ? hardware_jobs() : options.jobs;
  const std::size_t in_round = jobs * kTetrahedraInRound;
  for (std::size_t first = 0; first < model.tetrahedra.size(); first += in_round) {
    const std::size_t size = std::min(in_round, model.tetrahedra.size() - first);
    std::vector<std::optional<Parts>> made(size);
    parallel_for(size, kTetrahedraInRound / 8, options.jobs,
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   PartMaker maker(model, knots, evaluator, options.max_cells);
                   for (std::size_t i = begin; i < end; ++i)
                     made[i] = maker.make(static_cast<std::uint32_t>(first + i));
                 });
    for (std::size_t i = 0; i < size; ++i) {
      if (!*made[i]) return made[i]->error();
      for (const Part& part : **made[i])
        if (Status status = grid.add(part, static_cast<std::uint32_t>(first + i)); !status)
          return status.error();
    }
  }
  return grid.write();
}

}  // namespace veritope
