// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope dms edit.
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cli/dms_verbs.h"
#include "cli/output_plan.h"
#include "io/base/file_bytes.h"
#include "io/dms/read_dms_moves.h"
#include "io/dms/write_dms.h"
#include "report/text_style.h"
#include "solids/dms/dms_defects.h"
#include "solids/dms/dms_moves.h"

namespace veritope::cli {
namespace {

struct DmsEditChoice {
  std::vector<std::string> files;  // M, SCRIPT
  std::optional<std::string> output;
  ModelReadOptions reading;
};

class DmsEditRun {
 public:
  DmsEditRun(const DmsEditChoice& choice, StandardOutput& out) : choice_(choice), out_(out) {}

  ExitCode run() {
    for (const std::string& input : choice_.files)
      if (input != "-")
        if (const Status status = refuse_same({input}, *choice_.output); !status)
          return fail(status.error());
    if (const Status status = try_output(*choice_.output); !status) return fail(status.error());
    Result<DmsFile> file = read_dms_file(choice_.files[0], choice_.reading);
    if (!file) return fail(file.error());
    if (const DmsDefects defects = find_dms_defects(file->model); defects.count > 0)
      return refuse(dms_refusal(choice_.files[0], defects), kExitInvalid);
    const bool is_standard_input = choice_.files[1] == "-";
    const std::string script = is_standard_input ? "standard input" : choice_.files[1];
    const std::uint64_t most = choice_.reading.limits.max_bytes;
    const Result<ByteBuffer> bytes =
        is_standard_input ? read_descriptor(0, script, 0, most) : read_file_bytes(script, most);
    if (!bytes) return refuse(to_string(bytes.error()), kExitUnreadable);
    const Result<std::vector<DmsMove>> moves =
        read_dms_moves(source_of(*bytes, script), choice_.reading.limits, file->model);
    if (!moves) return refuse(to_string(moves.error()), kExitUnreadable);
    return edit(std::move(file->model), *moves);
  }

 private:
  static ExitCode refuse(const std::string& why, ExitCode exit) {
    complain(harmless(why));
    return exit;
  }

  ExitCode edit(DmsModel model, const std::vector<DmsMove>& moves) {
    bool moves_knots = false;
    for (std::size_t i = 0; i < moves.size(); ++i) {
      if (const Status status = apply_move(model, moves[i]); !status)
        return refuse(
            choice_.files[1] + ": move " + std::to_string(i) + ": " + status.error().message,
            kExitUnreadable);
      moves_knots |= std::holds_alternative<DmsKnotMove>(moves[i]);
    }
    if (moves_knots)
      if (const DmsDefects defects = find_dms_defects(model); defects.count > 0)
        return refuse(dms_refusal("after the moves", defects), kExitInvalid);
    const Status written = write_output(*choice_.output, write_dms(model), out_);
    if (!written) return fail(written.error());
    if (*choice_.output == "-") return kExitValid;
    out_.write(fold("wrote  " + unbroken(harmless(*choice_.output)) + "  " +
                        counted(moves.size(), "move", "moves") + "\n",
                    verdict_width()));
    return kExitValid;
  }

  const DmsEditChoice& choice_;
  StandardOutput& out_;
};

}  // namespace

RunCommand declare_dms_edit(OptionSet& set) {
  const auto o = std::make_shared<DmsEditChoice>();
  set.operands("M SCRIPT", o->files,
               "a model .vdms, and a list of moves, .json; - is standard\ninput, for one of them",
               2);
  set.output("-o,--output", o->output, "write the model, .vdms; - is standard output");
  declare_reading(set, o->reading);
  set.hide("--as-indexed");
  set.rule([o]() -> std::string {
    if (!o->output) return "-o OUT.vdms is required, the file of the model";
    if (o->files.size() == 2 && o->files[0] == "-" && o->files[1] == "-")
      return "only one of M and SCRIPT can be standard input";
    return "";
  });
  return [o](StandardOutput& out) { return DmsEditRun(*o, out).run(); };
}

}  // namespace veritope::cli
