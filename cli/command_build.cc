// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope build.
#include <algorithm>
#include <memory>
#include <utility>

#include "cli/commands.h"
#include "cli/model_files.h"
#include "cli/output_plan.h"
#include "io/base/file_bytes.h"
#include "io/read_model.h"
#include "io/splines/write_splines.h"
#include "io/trees/build_tree.h"
#include "io/trees/tree_reader.h"
#include "report/build_report.h"
#include "report/text_style.h"
#include "robust/base/stopwatch.h"
#include "verify/format/sha256.h"

namespace veritope::cli {
namespace {

struct BuildOptions {
  std::string tree;
  ModelReadOptions reading;
  std::optional<std::string> output, json;
};

std::string hex_digest(const char* begin, std::size_t size) {
  return to_hex(sha256({reinterpret_cast<const unsigned char*>(begin), size}));
}

class BuildRun {
 public:
  BuildRun(const BuildOptions& options, StandardOutput& out) : options_(options), out_(out) {}

  ExitCode run() {
    if (const Status status = check_outputs(); !status) return fail(status.error());
    const Result<ByteBuffer> bytes =
        read_file_bytes(options_.tree, options_.reading.limits.max_bytes);
    if (!bytes) return refuse(bytes.error());
    const auto source = source_of(*bytes, options_.tree);
    report_.sha256 = hex_digest(source.begin, source.size());
    const Result<TreeFile> tree = read_tree(source, options_.reading.limits);
    if (!tree) return refuse(tree.error());
    const Result<BuiltTree> built =
        build_tree(*tree, options_.tree, [this](const std::string& path) { return load(path); });
    if (!built) return refuse(built.error());
    return write(*built);
  }

 private:
  const std::string& path() const { return *options_.output; }

  // What is wrong with a tree is wrong with a file, whichever function says so.
  static ExitCode refuse(const Error& error) {
    complain(harmless(to_string(error)));
    return kExitUnreadable;
  }

  Status check_outputs() const {
    const std::vector<std::string> inputs = {options_.tree};
    const Result<OutputPlan> plan = plan_outputs(inputs, std::nullopt, options_.json);
    if (!plan) return plan.error();
    if (const Status status = check_output("--output", path(), inputs, *plan, options_.json);
        !status)
      return status;
    return try_outputs(*plan, {options_.json, path()});
  }

  Result<SplineModel> load(const std::string& file) const {
    const std::string found = beside(options_.tree, file);
    if (same_target(found, path()))
      return bad_argument("the tree reads " + found + ", which is the file to be written");
    Result<SplineFile> model = read_spline_file(found, options_.reading);
    if (!model) return model.error();
    return std::move(model->model);
  }

  // Whether numbers are so short that the file can be read back: a number below 10^most has at most `most` digits, and
  // 10^1000 more than 3321 bits.
  Status check_lengths(const BuiltTree& built) const {
    const ReadLimits& limits = options_.reading.limits;
    const std::uint64_t most = std::uint64_t{limits.max_digits} + limits.max_exponent;
    const std::uint64_t bits = most * 3321 / 1000;
    for (std::size_t i = 0; i < built.cells.size(); ++i)
      for (const Rational& x : built.cells[i].coefficients())
        if (std::max(x.numerator().bit_length(), x.denominator().bit_length()) > bits) {
          Error error{Code::kOverLimit,
                      {},
                      "not written, it would not be read back: cell " + std::to_string(i) +
                          " has a number of more than " + std::to_string(most) +
                          " digits (--max-digits)"};
          error.place.file = path();
          return error;
        }
    return ok_status();
  }

  ExitCode write(const BuiltTree& built) {
    if (const Status fits = check_lengths(built); !fits) return fail(fits.error());
    const std::string bytes = spline_json_bytes(model_of_cells(built.cells));
    const Status written = write_output(path(), bytes, out_);
    if (!written && path() != "-") return fail(written.error());
    report_.path = options_.tree;
    report_.output_path = path();
    report_.output_sha256 = hex_digest(bytes.data(), bytes.size());
    report_.output_bytes = bytes.size();
    report_.cells = built.cells.size();
    for (const CellVolume& cell : built.cells) report_.control_points += cell.grid().count();
    report_.nodes = built.num_nodes;
    report_.files = built.num_files;
    for (const TreeNote& n : built.notes)
      report_.notes.push_back(
          {n.pointer, n.op, n.degrees, n.error, n.distance_from_rotation, n.determinant});
    report_.seconds = watch_.lap();
    if (options_.json != "-" && path() != "-")
      out_.write(fold(build_text(report_), verdict_width()));
    if (!options_.json) return kExitValid;
    const Status status = write_output(*options_.json, build_json(report_), out_);
    return status || *options_.json == "-" ? kExitValid : fail(status.error());
  }

  const BuildOptions& options_;
  StandardOutput& out_;
  BuildReport report_;
  Stopwatch watch_;
};

}  // namespace

RunCommand declare_build(OptionSet& set) {
  const auto o = std::make_shared<BuildOptions>();
  declare_plain_file(set, "TREE", o->tree, "a tree of volumes, JSON");
  set.output("-o,--output", o->output, "write the volumes, one a cell: a spline file, .vjson");
  declare_json(set, o->json, "write counts and angles");
  declare_reading(set, o->reading);
  set.rule([o]() -> std::string {
    if (!o->output) return "-o OUT.vjson is required, the file of the volumes";
    if (*o->output == "-" || o->output->ends_with(".vjson")) return "";
    return "the name " + *o->output + " does not end in .vjson";
  });
  return [o](StandardOutput& out) { return BuildRun(*o, out).run(); };
}

}  // namespace veritope::cli
