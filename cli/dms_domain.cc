// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope dms domain.
#include <algorithm>
#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "cli/dms_domain_input.h"
#include "cli/dms_domain_mesh.h"
#include "cli/dms_domain_refinement.h"
#include "cli/dms_verbs.h"
#include "cli/point_source.h"
#include "cli/progress.h"
#include "io/dms/write_dms.h"
#include "report/decimal_text.h"
#include "report/dms_domain_report.h"
#include "report/text_style.h"
#include "robust/base/stopwatch.h"
#include "solids/dms/dms_defects.h"
#include "solids/dms/dms_identity.h"
#include "solids/dms/dms_validity.h"
#include "solids/tetrahedra/boundary_classes.h"
#include "solids/tetrahedra/delaunay.h"
#include "solids/tetrahedra/occupancy.h"
#include "solids/tetrahedra/tetrahedron_angles.h"
#include "verify/format/sha256.h"

namespace veritope::cli {
namespace {

struct DmsDomainOptions {
  std::string input;
  std::optional<std::string> output, json;
  bool is_hull = false, no_check = false;
  std::optional<std::uint64_t> max_vertices, max_points;
  RefineLimits limits;
  ModelReadOptions reading;
};

// Edges whose facets' normals enclose more than 30 degrees are features.
const Rational kFeatureSquaredCosine(Integer(3), Integer(4));

Error bad_point(const std::string& input, std::size_t number, const Error& why) {
  Error out{Code::kOverLimit, {}, "point " + std::to_string(number) + ": " + why.message};
  out.place.file = input == "-" ? "standard input" : input;
  return out;
}

Result<std::vector<ExactPoint3>> read_points(const DmsDomainOptions& o) {
  auto source = open_points(o.input, Decimals::kExact, o.reading.limits);
  if (!source) return source.error();
  std::vector<ExactPoint3> points;
  for (PointBatch batch;;) {
    if (const Status status = (*source)->next(batch); !status) return status.error();
    if (batch.size() == 0) return points;
    auto exact = batch.exact.begin();
    for (std::size_t i = 0; i < batch.size(); ++i) {
      if (exact != batch.exact.end() && exact->first == i) {
        for (const Rational& x : exact->second)
          if (const Status status = check_dms_number(x); !status)
            return bad_point(o.input, points.size(), status.error());
        points.emplace_back(std::move((exact++)->second));
      } else {
        points.emplace_back(batch.points[i]);
      }
    }
  }
}

class DmsDomainRun {
 public:
  DmsDomainRun(const DmsDomainOptions& options, StandardOutput& out)
      : options_(options), out_(out) {}

  ExitCode run() {
    if (const Status status =
            try_dms_outputs(files_of_domain_input(options_.input), options_.output, options_.json);
        !status)
      return fail(status.error());
    Stopwatch watch;
    const Result<DomainInput> kind = kind_of_domain_input(options_.input, options_.reading);
    if (!kind) return fail(kind.error());
    if (*kind != DomainInput::kPoints && options_.is_hull)
      return complain("--hull is for points, and this is " +
                      std::string(*kind == DomainInput::kMesh ? "a mesh" : "a file of tetrahedra")),
             kExitUsage;
    const ExitCode exit = *kind == DomainInput::kPoints ? take_points()
                          : *kind == DomainInput::kMesh ? take_mesh()
                                                        : take_tetrahedra();
    if (!is_written_) return exit;
    report_.seconds = watch.lap();
    if (*options_.output != "-" && options_.json != "-") out_.write(fold(text(), verdict_width()));
    if (!options_.json) return exit;
    const Status written = write_output(*options_.json, dms_domain_json(report_), out_);
    return written ? exit : fail(written.error());
  }

 private:
  ExitCode take_points() {
    const Result<std::vector<ExactPoint3>> points = read_points(options_);
    if (!points) return fail(points.error());
    auto delaunay = with_progress(options_.input, "making tetrahedra", [&] {
      return delaunay_tetrahedra(std::span<const ExactPoint3>(*points));
    });
    if (!delaunay) return refuse(delaunay.error());
    report_.points = points->size();
    for (std::uint32_t i = 0; i < points->size(); ++i)
      if (delaunay->same_as[i] != i) ++report_.duplicates;
    std::vector<TetrahedronCorners> tetrahedra = std::move(delaunay.value().tetrahedra);
    if (!options_.is_hull)
      if (const Status status = keep_occupied(*points, tetrahedra); !status)
        return refuse(status.error());
    report_.is_delaunay = true;
    std::vector<DmsPoint> places;
    places.reserve(points->size());
    for (const ExactPoint3& p : *points) places.push_back(p.at());
    return write_identity(places, tetrahedra);
  }

  ExitCode take_mesh() {
    MeshDomainChoice choice{options_.input, options_.reading, options_.max_vertices,
                            options_.no_check};
    Progress progress(true);
    MeshDomain domain;
    const ExitCode exit = take_mesh_domain(choice, progress, domain);
    if (exit != kExitValid) return exit;
    report_.points = domain.from_mesh;
    report_.steiner = domain.steiner_on_mesh + domain.steiner_inside;
    return take_domain(domain.model, domain.from_mesh);
  }

  ExitCode take_tetrahedra() {
    const Result<TetrahedraFile> file = read_tetrahedra(options_.input, options_.reading);
    if (!file) return fail(file.error());
    report_.points = file->points.size();
    std::vector<TetrahedronCorners> tetrahedra = file->tetrahedra;
    turn_to_positive(file->points, tetrahedra);
    return write_identity(file->points, tetrahedra);
  }

  // Points of which no domain can be made.
  ExitCode refuse(const Error& error) const {
    complain(harmless(options_.input + ": " + error.message));
    return error.code == Code::kBadArgument ? kExitInvalid : kExitUnreadable;
  }

  Status keep_occupied(const std::vector<ExactPoint3>& points,
                       std::vector<TetrahedronCorners>& tetrahedra) {
    const Result<Occupancy> occupancy = find_occupancy(points, tetrahedra);
    if (!occupancy) return occupancy.error();
    std::vector<TetrahedronCorners> kept;
    for (const std::uint32_t t : occupancy->kept) kept.push_back(tetrahedra[t]);
    for (const RemovedTetrahedron& r : occupancy->removed)
      report_.removed.push_back({tetrahedra[r.tetrahedron], reason_name(r.reason)});
    for (const std::uint32_t t : occupancy->filled) report_.filled.push_back(tetrahedra[t]);
    tetrahedra = std::move(kept);
    return ok_status();
  }

  ExitCode write_identity(std::span<const DmsPoint> places,
                          std::span<const TetrahedronCorners> tetrahedra) {
    const Result<DmsModel> model = identity_dms(places, tetrahedra);
    if (!model) return refuse(model.error());
    const DmsDefects defects = find_dms_defects(*model, 1);
    if (defects.count == 0) return take_domain(*model, model->clouds.size());
    complain(harmless(options_.input + ": " + fault_name(defects.first[0].fault) + ": " +
                      to_string(defects.first[0])));
    return kExitInvalid;
  }

  // Refines the domain if a limit is given. @param num_fixed  vertices of the input, the first ones
  ExitCode take_domain(const DmsModel& domain, std::size_t num_fixed) {
    RefineLimits limits = options_.limits;
    if (!has_limit(limits)) return write_domain(domain);
    limits.num_fixed = num_fixed;
    if (options_.max_points) limits.max_points = *options_.max_points;
    const Result<RefinedDomain> refined =
        with_progress(options_.input, "refining", [&] { return refine_domain(domain, limits); });
    if (!refined) return refuse(refined.error());
    report_.refinement = describe_refinement(limits, *refined);
    report_.steiner += report_.refinement->inserted - report_.refinement->taken_away;
    report_.is_delaunay = report_.is_delaunay && options_.is_hull && is_delaunay(refined->model);
    const ExitCode exit = write_domain(refined->model);
    return exit == kExitValid && refined->end != RefineEnd::kLimits ? kExitUndecided : exit;
  }

  static bool is_delaunay(const DmsModel& hull) {
    std::vector<ExactPoint3> points;
    for (const DmsCloud& cloud : hull.clouds) points.emplace_back(cloud[0]);
    return is_locally_delaunay(
        points, TetrahedralComplex(hull.tetrahedra, static_cast<std::uint32_t>(points.size())));
  }

  ExitCode write_domain(const DmsModel& model) {
    const std::string bytes = write_dms(model);
    if (const Status written = write_output(*options_.output, bytes, out_); !written)
      return fail(written.error());
    is_written_ = true;
    report_.input = options_.input;
    report_.path = *options_.output;
    report_.sha256 =
        to_hex(sha256({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}));
    report_.bytes = bytes.size();
    report_.vertices = model.clouds.size();
    report_.tetrahedra = model.tetrahedra.size();
    if (options_.json) describe(model);
    return kExitValid;
  }

  void describe(const DmsModel& model) {
    std::vector<ExactPoint3> points;
    points.reserve(model.clouds.size());
    for (const DmsCloud& cloud : model.clouds) points.emplace_back(cloud[0]);
    double least = std::numbers::pi;
    for (const TetrahedronCorners& t : model.tetrahedra)
      least = std::min(least, approx_min_dihedral(shape_of(
                                  {&points[t[0]], &points[t[1]], &points[t[2]], &points[t[3]]})));
    report_.min_dihedral = least * 180 / std::numbers::pi;
    const TetrahedralComplex complex(model.tetrahedra, static_cast<std::uint32_t>(points.size()));
    const auto edges = feature_edges(points, complex, kFeatureSquaredCosine);
    const auto classes = classes_by_features(points, complex, edges, kFeatureSquaredCosine);
    const std::vector<double> angles = approx_solid_angles(points, complex);
    for (std::uint32_t v = 0; v < points.size(); ++v)
      if (classes[v] != VertexClass::kInterior)
        report_.classes.push_back(
            {v, class_name(classes[v]), class_name(class_by_solid_angle(angles[v])), angles[v]});
    report_.feature_lines = feature_lines(edges, classes);
  }

  std::string text() const {
    return "wrote  " + unbroken(harmless(*options_.output)) + "  " +
           counted(report_.tetrahedra, "tetrahedron", "tetrahedra") + ", " +
           counted(report_.vertices, "vertex", "vertices") +
           (report_.duplicates > 0
                ? ", " + counted(report_.duplicates, "repeated point", "repeated points")
                : "") +
           (report_.steiner > 0 ? ", " + std::to_string(report_.steiner) + " of them added" : "") +
           (report_.removed.empty()
                ? ""
                : ", " + std::to_string(report_.removed.size()) + " of the hull removed") +
           "\n" + (report_.refinement ? dms_refinement_text(report_) : "");
  }

  const DmsDomainOptions& options_;
  StandardOutput& out_;
  DmsDomainReport report_;
  bool is_written_ = false;
};

}  // namespace

RunCommand declare_dms_domain(OptionSet& set) {
  const auto o = std::make_shared<DmsDomainOptions>();
  declare_plain_file(
      set, "IN", o->input,
      "points, three numbers a line (- is standard input);\na mesh; or tetrahedra of "
      "TetGen, MEDIT or Gmsh");
  set.output("-o,--output", o->output, "write the model, .vdms; - is standard output");
  set.flag("--hull", o->is_hull,
           "keep all of the convex hull of points; without it those\ntetrahedra whose edges have "
           "their middles near points");
  set.number("--max-vertices", o->max_vertices, {4, kMaxDmsVertices},
             "limit: vertices that cuts by a mesh may make (1000000)");
  declare_refinement(set, o->limits, o->max_points);
  set.flag("--no-check", o->no_check, "do not run veritope-check on a mesh");
  declare_json(set, o->json, "write what was made");
  declare_reading(set, o->reading);
  set.hide("--as-indexed");
  set.rule([o]() -> std::string {
    if (o->max_points && !has_limit(o->limits))
      return "--max-points needs --max-volume or --max-radius-edge";
    return o->output ? "" : "-o OUT.vdms is required, the file of the model";
  });
  return [o](StandardOutput& out) { return DmsDomainRun(*o, out).run(); };
}

}  // namespace veritope::cli
