// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/trees/tree_files_internal.h"

#include <utility>
#include <variant>

namespace veritope {
namespace {

// The entity that the node names; null: all.
Result<const SplineEntity*> entity_of(const TreeNode& node, const SplineModel& model) {
  const auto* const number = node.find<std::uint64_t>("entity");
  if (number == nullptr) return static_cast<const SplineEntity*>(nullptr);
  if (*number < model.entities.size()) return &model.entities[*number];
  return bad_argument("entity must be less than " + std::to_string(model.entities.size()) +
                      ", the number of entities of the file, not " + std::to_string(*number));
}

std::string entity_number(const SplineModel& model, const SplineEntity& entity) {
  return std::to_string(&entity - model.entities.data());
}

}  // namespace

Result<const SplineModel*> TreeFiles::file_of(const TreeNode& node) {
  const auto& path = node.at<std::string>("path");
  const auto found = files_.find(path);
  if (found != files_.end()) return &found->second;
  Result<SplineModel> model = load_(path);
  if (!model) {
    Error error = model.error();
    error.message = "path: " + to_string(error);
    error.place = {};
    return error;
  }
  for (const SplineEntity& entity : model->entities)
    for_each_spline(entity, [&](const auto& spline) {
      for (const Rational& x : spline.coefficients()) budget_.give_back(NumberBudget::bytes_of(x));
    });
  return &files_.emplace(path, std::move(*model)).first->second;
}

Result<Cells> TreeFiles::volumes(const TreeNode& node) {
  const Result<const SplineModel*> model = file_of(node);
  if (!model) return model.error();
  const Result<const SplineEntity*> one = entity_of(node, **model);
  if (!one) return one.error();
  Cells cells;
  for (const SplineEntity& entity : (*model)->entities) {
    if (*one != nullptr && *one != &entity) continue;
    const auto* const volume = std::get_if<ExactVolume>(&entity.shape);
    if (volume == nullptr)
      return bad_argument("entity " + entity_number(**model, entity) + " of the file is a " +
                          spline_kind_name(entity) + ", no volume");
    if (const Status fits = check_cell_volume(*volume); !fits) return fits.error();
    cells.push_back(*volume);
  }
  if (cells.empty()) return bad_argument("path: the file has no volume");
  return cells;
}

Result<CellSurface> TreeFiles::surface(const TreeNode& node) {
  const Result<const SplineModel*> model = file_of(node);
  if (!model) return model.error();
  Result<const SplineEntity*> one = entity_of(node, **model);
  if (!one) return one.error();
  if (*one == nullptr && (*model)->entities.size() != 1)
    return bad_argument("entity is required, since the file has " +
                        std::to_string((*model)->entities.size()) + " entities");
  const SplineEntity& entity = *one == nullptr ? (*model)->entities[0] : **one;
  if (const auto* const surface = std::get_if<ExactSurface>(&entity.shape)) return *surface;
  return bad_argument("entity " + entity_number(**model, entity) + " of the file is a " +
                      spline_kind_name(entity) + ", no surface");
}

}  // namespace veritope
