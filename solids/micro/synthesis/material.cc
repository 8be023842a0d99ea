// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/synthesis/material.h"

#include <map>
#include <utility>
#include <vector>

#include "interval/formula/formula_evaluator.h"
#include "solids/micro/synthesis/formula_point_internal.h"
#include "splines/de_boor.h"

namespace veritope {
namespace {

class MaterialEvaluator {
 public:
  MaterialEvaluator(const RealFormula& formula, const Microstructure& micro)
      : formula_(formula), evaluator_(formula), micro_(micro) {
    for (std::size_t k = 3; k < 6; ++k) has_parameters_ = has_parameters_ || formula.depends_on(k);
  }

  Result<std::int64_t> value_at(std::size_t grid, const std::array<std::size_t, 3>& corner) {
    const VVolume& volume = micro_.cage[micro_.grids[grid].volume];
    std::array<Rational, 3> at;
    bool is_on_face = false;
    for (std::size_t a = 0; a < 3; ++a) {
      at[a] = micro_.grids[grid].breaks[a][corner[a]];
      is_on_face = is_on_face || at[a] == volume.axis(a).domain_begin() ||
                   at[a] == volume.axis(a).domain_end();
    }
    // Parameters differ between faces that are one in space; the place in space is what they have in common.
    if (!is_on_face || !has_parameters_) return evaluated(grid, corner, volume, at);
    std::vector<Rational> place = point(volume, at).value();
    if (const auto known = known_.find(place); known != known_.end()) return known->second;
    const Result<std::int64_t> value = evaluated(grid, corner, volume, at);
    if (value) known_.emplace(std::move(place), *value);
    return value;
  }

 private:
  Result<std::int64_t> evaluated(std::size_t grid, const std::array<std::size_t, 3>& corner,
                                 const VVolume& volume, const std::array<Rational, 3>& at) {
    const std::uint64_t index =
        (std::uint64_t{grid} << 40) + micro_.grids[grid].corner_shape().at(corner);
    const Result<RoundedValue> value =
        evaluator_.round_to_multiple(internal::formula_values(formula_, volume, at), index);
    const auto about = [&](const std::string& what) {
      return bad_argument("corner (" + std::to_string(corner[0]) + ", " +
                          std::to_string(corner[1]) + ", " + std::to_string(corner[2]) +
                          ") of grid " + std::to_string(grid) + ": " + what);
    };
    if (!value) return about(value.error().message);
    if (value->open.has_value()) return about(value->open->message);
    if (value->multiple > kMaxMaterialNumber || value->multiple < -kMaxMaterialNumber)
      return about("the value " + std::to_string(value->multiple) +
                   "/2^20 is not below 2^32 in absolute value");
    return value->multiple;
  }

  const RealFormula& formula_;
  FormulaEvaluator evaluator_;
  const Microstructure& micro_;
  bool has_parameters_ = false;
  std::map<std::vector<Rational>, std::int64_t> known_;  // by places in space
};

}  // namespace

Result<MicroMaterial> material_by(const RealFormula& formula, std::string name,
                                  const Microstructure& micro) {
  MaterialEvaluator evaluator(formula, micro);
  MicroMaterial out;
  out.name = std::move(name);
  for (std::size_t g = 0; g < micro.grids.size(); ++g) {
    const Grid<3> corners = micro.grids[g].corner_shape();
    std::vector<std::int64_t>& values = out.values.emplace_back();
    values.reserve(corners.count());
    for (std::size_t c = 0; c < corners.count(); ++c) {
      const Result<std::int64_t> value = evaluator.value_at(g, corners.index_of(c));
      if (!value) return value.error();
      values.push_back(*value);
    }
  }
  return out;
}

}  // namespace veritope
