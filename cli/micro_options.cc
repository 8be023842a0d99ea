// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/micro_options.h"

#include <algorithm>

#include "cli/commands.h"
#include "cli/micro_emit.h"
#include "io/formats.h"
#include "io/splines/spline_text_reader.h"
#include "solids/micro/microstructure.h"
#include "solids/micro/synthesis/wall_thickness.h"

namespace veritope::cli {
namespace {

Result<RealFormula> formula_of(const std::string& text) {
  return parse_formula(text,
                       std::vector<std::string>(kWallVariables.begin(), kWallVariables.end()));
}

std::string take_material(const std::string& text, MicroOptions& options) {
  const std::size_t sign = text.find('=');
  if (sign == 0 || sign == text.npos) return "needs NAME=EXPR, not " + text;
  const std::string name = to_utf8(text.substr(0, sign));
  for (const auto& other : options.materials)
    if (other.first == name) return "names " + name + " twice";
  if (options.materials.size() == kMaxMicroMaterials)
    return "is given more than " + std::to_string(kMaxMicroMaterials) + " times";
  Result<RealFormula> formula = formula_of(text.substr(sign + 1));
  if (!formula) return name + " is not a formula: " + formula.error().message;
  options.materials.emplace_back(name, std::move(*formula));
  return "";
}

std::string take_formula(const std::string& text, std::optional<RealFormula>& to) {
  Result<RealFormula> formula = formula_of(text);
  if (!formula) return "is not a formula: " + formula.error().message;
  to = std::move(*formula);
  return "";
}

bool has_jack(const std::vector<TileChoice>& tiles) {
  return std::any_of(tiles.begin(), tiles.end(), [](const TileChoice& t) {
    return std::holds_alternative<JackShape>(t) || std::holds_alternative<JackSheets>(t);
  });
}

// Why -o is missing, or why tiles of curves and sheets cannot have these options: nothing but their composed splines is
// written. Empty if all is well.
std::string fault_of_open_tiles(const MicroOptions& o) {
  const auto open = std::find_if(o.tiles.begin(), o.tiles.end(), is_open_choice);
  if (o.output)
    return open == o.tiles.end()
               ? ""
               : std::string("-o: a .vmicro file holds closed tiles only, and ") +
                     open_choice_name(*open) + " is open; leave -o out, and --emit writes it";
  const bool is_needed = std::any_of(o.tiles.begin(), o.tiles.end(), [](const TileChoice& t) {
    return !is_open_choice(t) && !std::holds_alternative<TileFile>(t);
  });
  if (is_needed) return "-o OUT.vmicro is required, the file of the microstructure";
  if (!o.emit)
    return open == o.tiles.end() ? "-o OUT.vmicro is required, the file of the microstructure; or "
                                   "--emit, for curves and sheets"
                                 : std::string(open_choice_name(*open)) +
                                       " is open: --emit is required, the file of its splines";
  if (o.mesh) return "--mesh needs closed tiles, and -o";
  if (!o.materials.empty()) return "--material needs closed tiles, and -o";
  if (o.wants_connected) return "--connected needs closed tiles, and -o";
  if (o.bridge.is_asked_for(o.skin.has_value()) && !o.tiles.empty() &&
      std::all_of(o.tiles.begin(), o.tiles.end(),
                  [](const TileChoice& t) { return std::holds_alternative<JackSheets>(t); }))
    return "--bridge, --alpha and --skin need closed tiles or curves: sheets get no bridges";
  return "";
}

// Standard output has at most one of the outputs, and the inputs are files.
std::string fault_of_streams(const MicroOptions& o) {
  if (o.cage == "-" || o.model == "-") return "- is not read: the cage and the model need files";
  const char* first = nullptr;
  for (const auto& [option, path] :
       {std::pair{"--output", &o.output}, std::pair{"--mesh", &o.mesh},
        std::pair{"--emit", &o.emit}, std::pair{"--list", &o.list}, std::pair{"--json", &o.json}}) {
    if (*path != "-") continue;
    if (first != nullptr)
      return std::string(first) + " and " + option + " would both write standard output";
    first = option;
  }
  return "";
}

std::string fault_of_micro(const MicroOptions& o) {
  if (std::string why = fault_of_streams(o); !why.empty()) return why;
  if (!o.cage) return "--cage is required, a spline file of volumes";
  if (o.tiles.empty()) return "--tile is required, such as jack";
  if (o.tiles.size() > 1 && !o.place) return "several tiles need --place, a formula";
  if (o.counts.empty()) return "--counts is required, such as 10,10,10";
  if (const std::string why = o.bridge.fault(o.model.has_value(), o.skin.has_value()); !why.empty())
    return why;
  if (o.thickness && !has_jack(o.tiles)) return "--thickness needs a jack or a branch";
  if (o.doubled_from && !std::holds_alternative<JackShape>(o.tiles.front()))
    return "--double needs a jack as its first tile";
  if (o.doubled_from && o.counts.size() > 1) return "--double needs one K,M,N for all volumes";
  if (o.doubled_from && *o.doubled_from >= o.counts.front()[2])
    return "--double needs a layer below the count of layers, " +
           std::to_string(o.counts.front()[2]);
  if (o.nest)
    if (const std::string why = fault_of_nest(o.tiles, o.doubled_from.has_value(),
                                              o.bridge.is_asked_for(o.skin.has_value()));
        !why.empty())
      return why;
  if (const std::string why = fault_of_open_tiles(o); !why.empty()) return why;
  if (o.mesh.has_value() != o.chord.has_value()) return "--mesh and --chord need each other";
  if (o.mesh && format_from_path(*o.mesh, ModelKind::kMesh) == nullptr)
    return "the name " + *o.mesh + " ends in no format of meshes: .stl, .obj, .ply or .off";
  if (o.emit)
    if (const std::string fault = fault_of_emit_name(*o.emit); !fault.empty()) return fault;
  if (!o.output || *o.output == "-" || o.output->ends_with(".vmicro")) return "";
  return "the name " + *o.output + " does not end in .vmicro";
}

}  // namespace

void declare_micro_options(OptionSet& set, const std::shared_ptr<MicroOptions>& o) {
  o->reading.jobs = default_jobs();
  set.text("--cage", o->cage, "a file of volumes, whose parameters hold the cells");
  set.repeatable(
      "--tile", "TILE",
      [o = o.get()](const std::string& text) { return take_tile(text, o->tiles); },
      "jack[,node=1/5], branch, frame, curves3, file; --place E");
  set.option(
      "--counts", "K,M,N",
      [o = o.get()](const std::string& text) { return take_counts_of_volumes(text, o->counts); },
      "cells along each volume's axes; --double w=L: finer ones");
  set.text("--model", o->model, "keep tiles in this solid; --nest T:K,M,N: tiles in tiles");
  set.option(
      "--place", "EXPR",
      [o = o.get()](const std::string& text) { return take_formula(text, o->place); },
      "the number of each cell's tile, from 0");
  set.hide("--place");
  set.option(
      "--double", "w=L",
      [o = o.get()](const std::string& text) { return take_doubling(text, o->doubled_from); },
      "cells half as wide along u and v from layer L of w on");
  set.hide("--double");
  set.option(
      "--nest", "TILE:K,M,N",
      [o = o.get()](const std::string& text) { return take_nest(text, o->nest); },
      "fill each volume of each tile with tiles again");
  set.hide("--nest");
  set.option(
      "--thickness", "EXPR",
      [o = o.get()](const std::string& text) { return take_formula(text, o->thickness); },
      "half the width of arms at each wall, from x y z u v w");
  set.repeatable(
      "--material", "NAME=EXPR",
      [o = o.get()](const std::string& text) { return take_material(text, *o); },
      "a property of the points: a formula, as above");
  declare_bridge(set, o->bridge, o->skin);
  set.output("-o,--output", o->output, "write the microstructure, .vmicro");
  set.output("--mesh", o->mesh, "write its surface as a mesh, within --chord H of it");
  set.length("--chord", "H", o->chord, "how far the mesh may be from the surface");
  set.hide("--chord");
  set.output("--emit", o->emit, "write its surface as splines, .vjson, .itd or .vtu");
  set.output("--list", o->list, "write the status of each cell, CSV");
  declare_json(set, o->json, "write counts and defects");
  set.flag("--connected", o->wants_connected, "keep only the largest part that hangs together");
  set.number("--max-tiles", o->max_tiles, {1, kMaxMicroCells}, "refuse more cells than this");
  declare_jobs(set, o->reading.jobs);
  declare_reading(set, o->reading);
  set.rule([o] { return fault_of_micro(*o); });
}

}  // namespace veritope::cli
