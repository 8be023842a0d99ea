// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope micro.
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "cli/commands.h"
#include "cli/micro_curves.h"
#include "cli/micro_emit.h"
#include "cli/micro_options.h"
#include "cli/micro_solid.h"
#include "cli/output_plan.h"
#include "cli/progress.h"
#include "io/formats.h"
#include "io/mesh/write_mesh.h"
#include "io/micro/write_micro.h"
#include "io/read_model.h"
#include "io/splines/volumes.h"
#include "io/splines/write_splines.h"
#include "report/micro_run_report.h"
#include "report/report_text.h"
#include "report/text_style.h"
#include "robust/base/stopwatch.h"
#include "solids/micro/doubled_grids.h"
#include "solids/micro/measure/cage_scale.h"
#include "solids/micro/measure/micro_volume.h"
#include "solids/micro/mesh/micro_mesh.h"
#include "solids/micro/micro_grid.h"
#include "solids/micro/synthesis/filter_tiles.h"
#include "solids/micro/synthesis/material.h"
#include "solids/micro/synthesis/tile_places.h"
#include "solids/micro/synthesis/wall_thickness.h"
#include "solids/vmodel/v_parts.h"
#include "verify/certify/tile_certifier.h"
#include "verify/certify/vmodel_certifier.h"
#include "verify/format/sha256.h"

namespace veritope::cli {
namespace {

// What a number of a wall may be before the tile is analysed: half the edge of a cap, inside a cell.
constexpr std::array<std::int32_t, 2> kCapLimits = {1, kMaxWallNumber / 2 - 1};

class MicroRun {
 public:
  MicroRun(const MicroOptions& options, StandardOutput& out)
      : options_(options), out_(out), progress_(true) {
    report_.is_open = is_open();
  }

  ExitCode run() {
    if (const Status status = check_outputs(); !status) return fail(status.error());
    for (const auto step :
         {&MicroRun::read_tiles, &MicroRun::read_cage, &MicroRun::read_solid, &MicroRun::fill,
          &MicroRun::analyse, &MicroRun::filter, &MicroRun::nest, &MicroRun::build,
          &MicroRun::connect, &MicroRun::find_topology, &MicroRun::add_materials,
          &MicroRun::measure, &MicroRun::make_mesh, &MicroRun::emit})
      if (const ExitCode exit = (this->*step)(); exit != kExitValid) return conclude(exit);
    return conclude(write());
  }

 private:
  // Whether the tiles are curves and sheets, of which only composed splines are written.
  bool is_open() const { return !options_.output.has_value(); }
  std::vector<std::string> inputs() const {
    std::vector<std::string> out = {*options_.cage};
    if (options_.model) out.push_back(*options_.model);
    for (const TileChoice& tile : options_.tiles)
      if (const auto* const file = std::get_if<TileFile>(&tile)) out.push_back(file->path);
    if (options_.nest)
      if (const auto* const file = std::get_if<TileFile>(&options_.nest->tile))
        out.push_back(file->path);
    return out;
  }
  Status check_outputs() const {
    const Result<OutputPlan> plan = plan_outputs(inputs(), std::nullopt, options_.json);
    if (!plan) return plan.error();
    std::vector<std::pair<std::string, std::string>> outputs;  // options and files
    for (const auto& [option, path] :
         {std::pair{"--output", &options_.output}, std::pair{"--list", &options_.list},
          std::pair{"--mesh", &options_.mesh}, std::pair{"--emit", &options_.emit}}) {
      if (!path->has_value()) continue;
      if (const Status status = check_output(option, **path, inputs(), *plan, options_.json);
          !status)
        return status;
      for (const auto& [other, taken] : outputs)
        if (taken == **path || same_target(taken, **path))
          return bad_argument(other + " and " + option + " would both write " + **path);
      outputs.emplace_back(option, **path);
    }
    return try_outputs(
        *plan, {options_.json, options_.output, options_.list, options_.mesh, options_.emit});
  }

  ExitCode refuse(const Error& error) {
    progress_.clear();
    complain(harmless(to_string(error)));
    return kExitUnreadable;
  }
  ExitCode refuse_cells(Error error) {
    if (error.code == Code::kOverLimit) error.message += " (--max-tiles)";
    return refuse(error);
  }
  // Nothing is written.
  ExitCode refute(MicroRunReport::Defect defect, ExitCode exit = kExitInvalid) {
    progress_.clear();
    complain(harmless(defect.message));
    report_.defects.push_back(std::move(defect));
    return exit;
  }

  ExitCode read_cage() {
    progress_.phase(*options_.cage, "certifying the cage");
    Stopwatch watch;
    Result<SplineFile> file = read_spline_file(*options_.cage, options_.reading);
    if (!file) return refuse(file.error());
    report_.cage = {*options_.cage, file->sha256, file->bytes};
    Result<std::vector<ExactVolume>> volumes = volumes_of(*file);
    if (!volumes) {
      Error error = volumes.error();
      error.place.file = *options_.cage;
      return refuse(error);
    }
    for (ExactVolume& v : *volumes) v = space_of(std::move(v));
    file->model = {};
    for (const ExactVolume& v : *volumes) file->model.entities.push_back({v, {}, std::nullopt, {}});
    const ExitCode exit = take_cage(*file, std::move(*volumes), *options_.cage + ": the cage");
    report_.seconds.cage = watch.lap();
    return exit;
  }
  // The volumes are those of the file.
  ExitCode take_cage(const SplineFile& file, std::vector<ExactVolume> volumes,
                     const std::string& name) {
    CertifyOptions certify;
    certify.orientation = PatchOrientation::kAuto;
    certify.jobs = static_cast<unsigned>(options_.reading.jobs);
    const auto answer = certify_vmodel(file, certify);
    if (!answer)
      return refute({"cage", {}, {}, {}, name + " is not one of which a certificate can speak"},
                    kExitUndecided);
    const Certified& certified = answer->certified;
    if (certified.verdict != Verdict::kValid)
      return refute({"cage",
                     {},
                     {},
                     {},
                     name + " is " + verdict_name(certified.verdict) + ": " +
                         text_of(certified.findings.front())},
                    certified.verdict == Verdict::kInvalid ? kExitInvalid : kExitUndecided);
    Result<VModel> model = make_v_model(volumes, VOrientation::kAuto);
    if (!model) return refuse(model.error());
    model_.emplace(std::move(*model));
    cage_ = std::move(volumes);
    return kExitValid;
  }
  static ExactVolume space_of(ExactVolume volume) {
    SplineModel one;
    one.entities.push_back({std::move(volume), {}, std::nullopt, {}});
    if (has_attributes(one)) one = without_attributes(one);
    return std::get<ExactVolume>(one.entities[0].shape);
  }

  ExitCode read_solid() {
    if (!options_.model) return kExitValid;
    progress_.phase(*options_.model, "certifying the model");
    Result<std::unique_ptr<const MicroSolid>> solid =
        MicroSolid::read(*options_.model, options_.reading);
    if (!solid) return refuse(solid.error());
    solid_ = std::move(*solid);
    report_.model = MicroRunReport::File{*options_.model, solid_->sha256(), solid_->bytes()};
    if (solid_->fault())
      return refute({"model", {}, {}, {}, *options_.model + ": " + *solid_->fault()},
                    solid_->is_undecided() ? kExitUndecided : kExitInvalid);
    return contain();
  }
  ExitCode contain() {
    const Result<std::optional<MicroSolid::Escape>> found = solid_->escape_from(*model_);
    if (!found) return refuse(found.error());
    if (!found->has_value()) return kExitValid;
    const MicroSolid::Escape& escape = **found;
    MicroRunReport::Defect defect{"cage", {}, {}, {}, *options_.model + ": " + escape.message};
    if (escape.face) {
      defect.wall = v_face_name(*escape.face % 6);
      defect.message += "; it may meet the face " + *defect.wall + " of volume " +
                        std::to_string(*escape.face / 6);
    }
    return refute(std::move(defect), escape.is_certain ? kExitInvalid : kExitUndecided);
  }

  ExitCode read_tiles() {
    choices_ = options_.tiles;
    if (options_.nest) choices_.push_back(options_.nest->tile);
    const Status read = read_tile_files(options_.reading, is_open(), choices_);
    if (options_.nest) {
      nested_tile_ = std::move(choices_.back());
      choices_.pop_back();
    }
    return read ? kExitValid : refuse(read.error());
  }
  ExitCode fill() {
    if (options_.counts.size() > 1 && options_.counts.size() != cage_.size())
      return fail(bad_argument("--counts has numbers for " +
                               std::to_string(options_.counts.size()) +
                               " volumes, and the cage has " + std::to_string(cage_.size())));
    if (options_.doubled_from)
      if (const auto glued = find_halved_neighbour())
        return refute({"cage", {}, {}, v_face_name(5), *glued});
    std::optional<Error> misplaced;
    Result<Microstructure> filled = filled_cage(
        [&, places = places()](const VVolume& volume, const MicroGrid& grid, std::uint64_t cell) {
          if (options_.doubled_from && is_before_doubling(volume, grid, cell))
            return Result<std::size_t>(choices_.size());
          if (places == nullptr) return Result<std::size_t>(0);
          Result<std::size_t> number = (*places)(volume, grid, cell);
          if (!number) misplaced = number.error();
          return number;
        });
    if (misplaced) return refute({"place", {}, {}, {}, misplaced->message});
    if (!filled) return refuse_cells(filled.error());
    take(std::move(*filled));
    if (!options_.thickness || !micro_.has_walls()) return kExitValid;
    const Status numbered = number_walls_by(*options_.thickness, *model_, kCapLimits, micro_);
    return numbered ? kExitValid : refute({"thickness", {}, {}, {}, numbered.error().message});
  }
  // Says which face w1 is glued to a face that is no w1: halved cells would meet whole ones there.
  std::optional<std::string> find_halved_neighbour() const {
    for (std::size_t c = 0; c < cage_.size(); ++c) {
      const VFaceRole& role = model_->face(c, 5);
      if (role.is_glued() && role.mate % 6 != 5)
        return "cells of half the width do not fit: the face w1 of volume " + std::to_string(c) +
               " is glued to the face " + v_face_name(role.mate % 6) + " of volume " +
               std::to_string(role.mate / 6);
    }
    return std::nullopt;
  }
  void take(Microstructure filled) {
    micro_ = std::move(filled);
    if (solid_) micro_.model = MicroModelName{stored_name(*options_.model), report_.model->sha256};
    report_.cells = 0;
    for (const MicroGrid& grid : micro_.grids) report_.cells += grid.tiles.size();
    report_.kinds = micro_.tiles.size();
  }
  Result<Microstructure> filled_cage(const ChooseTile& choose) const {
    Result<std::vector<MicroGrid>> grids =
        options_.doubled_from ? make_doubled_grids(cage_, options_.counts.front(),
                                                   *options_.doubled_from, options_.max_tiles)
                              : make_micro_grids(cage_, options_.counts, options_.max_tiles);
    if (!grids) return grids.error();
    return fill_grids(cage_, *model_, std::move(*grids), makers(), choose);
  }
  // What makes the tiles, and at the end, if cells are doubled, the tile before them.
  std::vector<TileOfArms> makers() const {
    const auto range = range_of_walls();
    std::vector<TileOfArms> out;
    for (const TileChoice& choice : choices_)
      out.push_back([&choice, range](unsigned arms) { return make_tile(choice, arms, range); });
    if (options_.doubled_from)
      out.push_back([&first = choices_.front(), range](unsigned arms) {
        return make_bifurcation(first, arms, range);
      });
    return out;
  }
  std::optional<std::array<std::int32_t, 2>> range_of_walls() const {
    return options_.thickness ? std::optional(kCapLimits) : std::nullopt;
  }
  std::shared_ptr<TilePlaces> places() const {
    if (!options_.place) return nullptr;
    return std::make_shared<TilePlaces>(*options_.place, choices_.size());
  }

  ExitCode analyse() {
    if (is_open()) {
      for (const MicroTile& tile : micro_.tiles) tiles_.push_back(analysis_of_open(tile));
      return kExitValid;
    }
    for (std::size_t k = 0; k < micro_.tiles.size(); ++k) {
      auto analysed = analyse_tile(micro_.tiles[k]);
      if (const auto* d = std::get_if<TileDefect>(&analysed))
        return refute({d->condition,
                       k,
                       {},
                       d->wall ? std::optional(v_face_name(static_cast<std::size_t>(*d->wall)))
                               : std::nullopt,
                       "tile " + micro_.tiles[k].name + ": " + d->condition + ", " +
                           defect_in_words(*d) + ": " + d->message});
      tiles_.push_back(std::get<AnalysedTile>(std::move(analysed)));
      if (tiles_.back().is_star()) continue;
      const auto boxes = star_boxes_of(tiles_.back().tile);
      if (const auto* const finding = std::get_if<Finding>(&boxes))
        return refute({"F3",
                       k,
                       {},
                       {},
                       "tile " + micro_.tiles[k].name +
                           ": F3, the patches do not bound one solid: " + finding->code + ": " +
                           finding->message});
    }
    return kExitValid;
  }

  ExitCode filter() {
    report_.kept = report_.cells;
    if (!solid_) return kExitValid;
    progress_.phase(*options_.model, "filtering tiles");
    Stopwatch watch;
    Result<TileFilter> filter = solid_->filter();
    if (!filter) return refuse(filter.error());
    filter_.emplace(std::move(*filter));
    Result<std::vector<GridStatus>> found =
        filter_tiles_to(*filter_, static_cast<unsigned>(options_.reading.jobs), micro_);
    if (!found) return refuse(found.error());
    statuses_ = std::move(*found);
    std::array<std::uint64_t, 5> counts{};
    for (const GridStatus& grid : statuses_)
      for (std::size_t s = 0; s < counts.size(); ++s) counts[s] += grid.counts[s];
    report_.kept = counts[static_cast<std::size_t>(CellStatus::kKept)];
    report_.crossing = counts[static_cast<std::size_t>(CellStatus::kCrossing)];
    report_.touching = counts[static_cast<std::size_t>(CellStatus::kTouching)];
    report_.outside = counts[static_cast<std::size_t>(CellStatus::kOutside)];
    report_.undecided = counts[static_cast<std::size_t>(CellStatus::kUndecided)];
    clear_unused_walls(micro_);
    report_.seconds.filter = watch.lap();
    return kExitValid;
  }

  // The tiles that are left become the cage of other ones. They lie in the model, so their parts do, too.
  ExitCode nest() {
    if (!options_.nest || report_.kept == 0) return kExitValid;
    progress_.phase(*options_.output, "composing the inner cage");
    Stopwatch watch;
    Result<std::vector<VVolume>> volumes = nested_cage(micro_, choices_, range_of_walls());
    if (!volumes) return refuse(volumes.error());
    report_.seconds.compose = watch.lap();
    SplineFile file;
    file.format = SplineFormat::kJson;
    for (const VVolume& v : *volumes) file.model.entities.push_back({v, {}, std::nullopt, {}});
    file.bytes = spline_json_bytes(file.model).size();
    progress_.phase(*options_.output, "certifying the inner cage");
    const ExitCode exit = take_cage(file, std::move(*volumes), "the cage of the outer tiles");
    report_.seconds.cage += watch.lap();
    return exit == kExitValid ? fill_nested() : exit;
  }
  ExitCode fill_nested() {
    report_.outer = MicroRunReport::Outer{report_.cells,    report_.kept,    report_.crossing,
                                          report_.touching, report_.outside, report_.undecided,
                                          cage_.size()};
    report_.crossing = report_.touching = report_.outside = report_.undecided = 0;
    const TileOfArms maker = [this](unsigned arms) {
      return make_tile(*nested_tile_, arms, std::nullopt);
    };
    Result<Microstructure> filled =
        fill_cage(cage_, *model_, options_.nest->counts, maker, options_.max_tiles);
    if (!filled) return refuse_cells(filled.error());
    take(std::move(*filled));
    report_.kept = report_.cells;
    statuses_.clear();
    tiles_.clear();
    return analyse();
  }

  ExitCode build() {
    if (is_open()) return build_of_curves();
    if (!solid_ || !options_.bridge.is_wanted || options_.nest) return kExitValid;
    progress_.phase(*options_.model, "building bridges");
    Stopwatch watch;
    Result<BridgeReport> built =
        solid_->bridge(*model_, tiles_, bridge_options(solid_->default_skin()),
                       options_.bridge.are_in_space, micro_);
    if (!built) return refuse(built.error());
    report_.bridges = std::move(*built);
    report_.seconds.bridge = watch.lap();
    return kExitValid;
  }

  BridgeOptions bridge_options(double default_skin) const {
    BridgeOptions out;
    out.alpha = options_.bridge.alpha;
    out.skin = options_.skin ? *options_.skin : default_skin;
    out.jobs = static_cast<unsigned>(options_.reading.jobs);
    return out;
  }
  // From the free ends of curves; sheets have none.
  ExitCode build_of_curves() {
    if (!solid_ || !options_.bridge.is_wanted || !has_curves(micro_)) return kExitValid;
    progress_.phase(*options_.model, "building bridges");
    Stopwatch watch;
    Result<CurveBridges> built =
        bridge_curves(*solid_, *filter_, micro_, bridge_options(solid_->default_skin()));
    if (!built) return refuse(built.error());
    report_.bridges = std::move(built->report);
    curve_bridges_ = std::move(built->bridges);
    report_.seconds.bridge = watch.lap();
    return kExitValid;
  }

  ExitCode connect() {
    if (!options_.wants_connected) return kExitValid;
    auto found = report_.bridges ? keep_bridged_components(*model_, tiles_, micro_)
                                 : keep_largest_component(*model_, tiles_, micro_);
    if (const auto* d = std::get_if<MicroDefect>(&found)) return refute_structure(*d);
    floating_ = std::get<0>(std::move(found));
    for (const auto& cells : floating_) report_.floating += cells.size();
    report_.kept -= report_.floating;
    clear_unused_walls(micro_);
    return kExitValid;
  }

  ExitCode find_topology() {
    if (is_open()) return kExitValid;
    progress_.phase(*options_.output, "joining tiles");
    Stopwatch watch;
    auto topology = topology_of(micro_, *model_, tiles_);
    report_.seconds.topology = watch.lap();
    if (const auto* d = std::get_if<MicroDefect>(&topology)) return refute_structure(*d);
    report_.counts = std::get<MicroCounts>(topology);
    return kExitValid;
  }
  ExitCode refute_structure(const MicroDefect& d) {
    MicroRunReport::Defect defect{
        d.condition, {}, {}, {}, std::string(d.condition) + ": " + d.message};
    if (!d.walls.empty()) {
      const CellWall& w = d.walls.front();
      const auto at = micro_.grids[w.grid].shape().index_of(w.cell);
      defect.cell = {micro_.grids[w.grid].volume, at[0], at[1], at[2]};
      defect.wall = v_face_name(static_cast<std::size_t>(w.wall));
    }
    return refute(std::move(defect));
  }

  ExitCode add_materials() {
    for (const auto& [name, formula] : options_.materials) {
      Result<MicroMaterial> material = material_by(formula, name, micro_);
      if (!material)
        return refute({"material", {}, {}, {}, name + ": " + material.error().message});
      micro_.materials.push_back(std::move(*material));
    }
    return kExitValid;
  }

  // Numbers beyond binary64 leave no bounds, and are no reason to write nothing.
  ExitCode measure() {
    if (report_.kept == 0 || is_open()) return kExitValid;
    progress_.phase(*options_.output, "measuring");
    Stopwatch watch;
    if (const auto v = volume_of(micro_, *model_, static_cast<unsigned>(options_.reading.jobs))) {
      report_.volume = bounds_of(v->solid);
      if (std::isfinite(v->density.hi())) report_.density = bounds_of(v->density);
    }
    if (const auto s = scale_of(micro_, *model_)) report_.scale = {s->lo, s->hi};
    if (solid_ && (options_.json || options_.output != "-")) {
      const auto c = solid_->clearance_of(micro_, static_cast<unsigned>(options_.reading.jobs));
      if (c && *c) report_.clearance = {(*c)->lo, (*c)->hi};
    }
    report_.seconds.measure = watch.lap();
    return kExitValid;
  }
  static MicroRunReport::Bounds bounds_of(const Interval& x) { return {x.lo(), x.hi()}; }

  // The mesh as its file will be read, if that bounds a solid with the numbers of the microstructure.
  ExitCode make_mesh() {
    report_.wants_surface = options_.mesh || options_.emit;
    if (!options_.mesh || report_.kept == 0) return kExitValid;
    progress_.phase(*options_.mesh, "making the mesh");
    Stopwatch watch;
    const Result<MicroMesh> made =
        mesh_of(micro_, *model_, tiles_,
                {*options_.chord, static_cast<unsigned>(options_.reading.jobs), kMaxMicroFacets});
    if (!made) return refuse(made.error());
    const WriteOptions how = default_write_options(*mesh_format_of(*options_.mesh));
    Result<std::string> bytes = mesh_to_bytes(made->mesh, how);
    if (!bytes) return refuse(bytes.error());
    mesh_bytes_ = std::move(*bytes);
    if (const std::string why = fault_of_mesh(*made); !why.empty())
      return refute({"mesh", {}, {}, {}, *options_.mesh + ": nothing is written, because " + why},
                    kExitUndecided);
    report_.mesh =
        MicroRunReport::Mesh{file_of(*options_.mesh, mesh_bytes_), made->mesh.faces.size(),
                             made->mesh.positions.size(), made->distance};
    report_.seconds.mesh = watch.lap();
    return kExitValid;
  }
  std::string fault_of_mesh(const MicroMesh& made) const {
    ModelReadOptions reading;
    reading.format = *mesh_format_of(*options_.mesh);
    reading.jobs = options_.reading.jobs;
    reading.limits.max_faces = kMost32;
    reading.limits.max_bytes = kMost64;
    const auto* const begin = reinterpret_cast<const unsigned char*>(mesh_bytes_.data());
    Result<MeshFile> file = read_mesh_bytes({begin, mesh_bytes_.size()}, *options_.mesh, reading);
    if (!file) return "the mesh would not be read: " + file.error().message;
    CertifyOptions certify;
    certify.jobs = static_cast<unsigned>(reading.jobs);
    const Result<Certified> certified = veritope::certify(ModelFile(std::move(*file)), certify);
    if (!certified) return certified.error().message;
    if (certified->verdict != Verdict::kValid)
      return std::string("the mesh would be ") + verdict_name(certified->verdict) + " (" +
             text_of(certified->findings.front()) + "); a smaller --chord may help";
    const MeshCounts& n = std::get<MeshFacts>(certified->facts).decision.counts;
    if (n.shells != report_.counts->shells || n.genus != report_.counts->genus)
      return "the mesh has other numbers of shells or another genus than the microstructure";
    return "";
  }
  static MicroRunReport::File file_of(const std::string& path, const std::string& bytes) {
    return {path,
            to_hex(sha256({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()})),
            bytes.size()};
  }
  static std::optional<MeshFormat> mesh_format_of(const std::string& path) {
    const ModelFormat* const format = format_from_path(path, ModelKind::kMesh);
    const auto* const id = format == nullptr ? nullptr : std::get_if<MeshFormat>(&format->id);
    return id == nullptr ? std::nullopt : std::optional(*id);
  }
  // The composed surface, beside its place until all is well.
  ExitCode emit() {
    if (!options_.emit || report_.kept == 0) return kExitValid;
    progress_.phase(*options_.emit, "composing");
    Stopwatch watch;
    const Result<ComposedSurface> surface = ComposedSurface::make(micro_, *model_, tiles_);
    if (!surface) return refuse(surface.error());
    Result<StreamedOutput> output = StreamedOutput::open(*options_.emit);
    if (!output) return fail(output.error());
    emitted_.emplace(std::move(*output));
    if (const Status made = emit_surface(*surface, micro_, curve_bridges_,
                                         static_cast<unsigned>(options_.reading.jobs), *emitted_);
        !made)
      return refuse(made.error());
    report_.composed =
        MicroRunReport::Composed{{*options_.emit, emitted_->sha256(), emitted_->num_bytes()},
                                 surface->num_patches(),
                                 surface->num_curves(),
                                 micro_.num_bridges() - surface->bridges_left_out().size(),
                                 surface->bridges_left_out()};
    report_.seconds.compose = watch.lap();
    return kExitValid;
  }

  ExitCode write() {
    if (is_open()) return write_open();
    progress_.phase(*options_.output, "writing");
    if (const Status valid = validate(micro_); !valid) return refuse(valid.error());
    const std::string bytes = write_micro(micro_);
    progress_.clear();
    if (report_.mesh)
      if (const Status meshed = write_output(*options_.mesh, mesh_bytes_, out_); !meshed)
        return fail(meshed.error());
    if (emitted_)
      if (const Status committed = emitted_->commit(out_); !committed)
        return fail(committed.error());
    Status written = write_output(*options_.output, bytes, out_);
    if (!written && *options_.output != "-") return fail(written.error());
    report_.output = file_of(*options_.output, bytes);
    if (options_.list) written = write_output(*options_.list, list_text(), out_);
    if (!written && *options_.list != "-") return fail(written.error());
    const std::uint64_t undecided =
        report_.undecided + (report_.outer ? report_.outer->undecided : 0);
    return undecided == 0 ? kExitValid : kExitUndecided;
  }
  ExitCode write_open() {
    progress_.clear();
    if (emitted_)
      if (const Status committed = emitted_->commit(out_); !committed)
        return fail(committed.error());
    if (options_.list)
      if (const Status written = write_output(*options_.list, list_text(), out_);
          !written && *options_.list != "-")
        return fail(written.error());
    return report_.undecided == 0 ? kExitValid : kExitUndecided;
  }
  std::string list_text() const {
    std::string out = "volume,i,j,k,status\n";
    for (std::size_t g = 0; g < micro_.grids.size(); ++g) {
      const MicroGrid& grid = micro_.grids[g];
      const Grid<3> shape = grid.shape();
      std::size_t next = 0;  // among the floating tiles, which are in the order of cells
      for (std::size_t c = 0; c < grid.tiles.size(); ++c) {
        const auto at = shape.index_of(c);
        out += std::to_string(grid.volume);
        for (const std::size_t i : at) out += "," + std::to_string(i);
        const bool floats =
            !floating_.empty() && next < floating_[g].size() && floating_[g][next] == c;
        next += floats;
        const CellStatus status = statuses_.empty() ? CellStatus::kKept : statuses_[g].status[c];
        out += std::string(",") + (floats ? "floating" : cell_status_name(status)) + "\n";
      }
    }
    return out;
  }

  ExitCode conclude(ExitCode exit) {
    progress_.clear();
    const bool is_read = exit != kExitUnreadable && exit != kExitUsage;
    if (options_.json != "-" && options_.output != "-")
      out_.write(fold(micro_run_text(report_), verdict_width()));
    if (!options_.json || !is_read) return exit;
    const Status status = write_output(*options_.json, micro_run_json(report_), out_);
    return status || *options_.json == "-" ? exit : fail(status.error());
  }

  const MicroOptions& options_;
  StandardOutput& out_;
  Progress progress_;
  MicroRunReport report_;
  std::vector<ExactVolume> cage_;
  std::optional<VModel> model_;
  std::unique_ptr<const MicroSolid> solid_;
  std::vector<TileChoice> choices_;
  std::optional<TileChoice> nested_tile_;
  Microstructure micro_;
  std::vector<AnalysedTile> tiles_;
  std::optional<TileFilter> filter_;
  std::vector<GridStatus> statuses_;
  std::vector<CurveBridge> curve_bridges_;
  std::vector<std::vector<std::uint64_t>> floating_;  // cells, by grids
  std::string mesh_bytes_;
  std::optional<StreamedOutput> emitted_;
};

}  // namespace

RunCommand declare_micro(OptionSet& set) {
  const auto o = std::make_shared<MicroOptions>();
  declare_micro_options(set, o);
  return [o](StandardOutput& out) { return MicroRun(*o, out).run(); };
}

}  // namespace veritope::cli
