// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope chain.
#include <memory>
#include <optional>

#include "cli/chain_origin.h"
#include "cli/chain_picture.h"
#include "cli/checker_process.h"
#include "cli/commands.h"
#include "cli/decided_model.h"
#include "cli/output_plan.h"
#include "report/chain_report.h"
#include "report/report_text.h"
#include "solids/chain/base_side.h"
#include "solids/chain/literal_chain.h"
#include "solids/chain/normal_chain.h"
#include "solids/chain/origin_cost.h"

namespace veritope::cli {
namespace {

struct ChainOptions {
  InputOptions input;
  ChainOrigin origin;
  std::optional<std::string> json, output;
  bool no_check = false;
};

void declare(OptionSet& set, ChainOptions& o) {
  declare_file(set, "MODEL", o.input, "a model in any format");
  set.option(
      "--origin", "X,Y,Z|auto",
      [&o](const std::string& text) { return take_origin(text, o.origin); },
      "the origin of the simplices (0,0,0)");
  set.text("-o,--output", o.output, "write the cells, for viewers: .vtu");
  declare_json(set, o.json, "write the counts");
  declare_jobs(set, o.input.reading.jobs);
  set.flag("--no-check", o.no_check, "do not run veritope-check");
  declare_format(set, o.input);
  declare_reading(set, o.input.reading);
}

ChainReport::Hypothesis as_reported(const LiteralHypothesis& h) {
  return {h.holds(), h.places, h.violations, h.undecided, h.first};
}

// The costs of the origin in use, of 0, of places of the box, and of the best candidate; each point once.
std::vector<ChainReport::Origin> table_of(const OriginCosts& costs, const ExactPoint& used,
                                          const OriginCost& best) {
  std::vector<ChainReport::Origin> out;
  const auto add = [&](const std::string& name, const ExactPoint& p, const CellTests& tests) {
    for (ChainReport::Origin& o : out)
      if (o.point == p) {
        o.name += ", " + name;
        return;
      }
    out.push_back({name, p, tests.value});
  };
  const auto add_corner = [&](const std::string& name, const Point3d& p) {
    ExactPoint exact;
    for (std::size_t k = 0; k < 3; ++k) exact[k] = Rational::from_double(p[k]);
    add(name, exact, costs.at(exact));
  };
  add("in use", used, costs.at(used));
  const ExactPoint zero;
  add("0,0,0", zero, costs.at(zero));
  add_corner("centre", approx_centre(costs.box()));
  add_corner("lower corner", costs.box().lo);
  add_corner("upper corner", costs.box().hi);
  add("auto", best.origin, best.tests);
  return out;
}

class ChainRun {
 public:
  ChainRun(const ChainOptions& options, StandardOutput& out)
      : options_(options), out_(out), progress_(true) {}

  ExitCode run() {
    if (const Status status = check_outputs(); !status) return fail(status.error());
    if (options_.output && !options_.output->ends_with(".vtu"))
      return complain(harmless("the name " + *options_.output + " does not end in .vtu")),
             kExitUsage;
    CertifySettings settings;
    settings.reading = options_.input.reading;
    settings.certify.jobs = static_cast<unsigned>(options_.input.reading.jobs);
    if (!options_.no_check) {
      const Result<std::string> checker = find_checker();
      if (!checker) return complain(checker.error().message), kExitUsage;
      settings.checker = *checker;
    }
    DecidedModel model;
    const ExitCode exit =
        take_decided_model(path(), std::move(settings), "no chain is made: ", progress_, model);
    if (exit != kExitValid) return exit;
    progress_.phase(shown_path(path()), "making chains");
    report_.path = path();
    report_.sha256 = model.sha256;
    fill(*model.complex);
    const ExitCode written = write_cells(*model.complex);
    progress_.clear();
    if (written != kExitValid) return written;
    if (options_.json != "-") out_.write(fold(chain_text(report_), verdict_width()));
    return write_json();
  }

 private:
  const std::string& path() const { return options_.input.files[0]; }

  Status check_outputs() const {
    const Result<OutputPlan> plan = plan_outputs(options_.input.files, std::nullopt, options_.json);
    if (!plan) return plan.error();
    if (options_.output)
      if (const Status status = check_output("--output", *options_.output, options_.input.files,
                                             *plan, options_.json);
          !status)
        return status;
    return try_outputs(*plan, {options_.json, options_.output});
  }

  void fill(const PatchComplex& complex) {
    const OriginCosts costs(complex);
    const OriginCost best = costs.best();
    report_.origin = options_.origin.is_auto ? best.origin : options_.origin.point;
    const CellCounts simplices = count_simplices(complex, report_.origin);
    report_.simplices = {simplices.plus, simplices.minus, simplices.zero, 0, 0};
    const auto jobs = static_cast<unsigned>(options_.input.reading.jobs);
    const BaseSideCounts sides = count_base_sides(complex.patches(), jobs);

    report_.free_form = {sides.plus, sides.minus, sides.zero, sides.mixed, sides.open};
    report_.is_normal =
        true;  // CHAIN-1: f is the winding number, which is 0 or 1 for a VALID model
    const LiteralChain chain(complex);
    const LiteralHypotheses literal = chain.hypotheses(jobs);
    report_.planes_share_lines = as_reported(literal.planes_share_lines);
    report_.curves_in_planes = as_reported(literal.curves_in_planes);
    report_.graphs = as_reported(literal.graphs);
    fill(chain.cells(jobs));
    report_.origins = table_of(costs, report_.origin, best);
  }

  void fill(const LiteralCells& cells) {
    report_.plus_cells = cells.plus;
    report_.minus_cells = cells.minus;
    report_.split = cells.split;
    report_.undecided_cells = cells.undecided;
    report_.without_wedge = cells.without_wedge;
    report_.connected = as_reported(cells.connected);
    report_.on_one_side = as_reported(cells.on_one_side);
    report_.with_vertices_on_patch = as_reported(cells.with_vertices_on_patch);
    for (const RefusedCell& cell : cells.refused)
      report_.refused.push_back({cell.figure, cell.why});
  }

  ExitCode write_cells(const PatchComplex& complex) {
    if (!options_.output) return kExitValid;
    progress_.phase(shown_path(path()), "writing");
    const Result<std::string> bytes = chain_picture(complex, report_.origin);
    if (!bytes) return refuse(bytes.error());
    const Status status = write_output(*options_.output, *bytes, out_);
    return status ? kExitValid : refuse(status.error());
  }

  ExitCode write_json() {
    if (!options_.json) return kExitValid;
    const Status status = write_output(*options_.json, chain_json(report_), out_);
    return status || *options_.json == "-" ? kExitValid : refuse(status.error());
  }

  ExitCode refuse(const Error& error) {
    progress_.clear();
    complain(harmless(to_string(error)));
    return kExitUnreadable;
  }

  const ChainOptions& options_;
  StandardOutput& out_;
  Progress progress_;
  ChainReport report_;
};

}  // namespace

RunCommand declare_chain(OptionSet& set) {
  const auto o = std::make_shared<ChainOptions>();
  declare(set, *o);
  return [o](StandardOutput& out) { return ChainRun(*o, out).run(); };
}

}  // namespace veritope::cli
