// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_thin.cc: [--base B] [--digits N] [--seconds S] [--only ROWS]. Measures certificates of thin walls.
// Models: every family of models/thin_shapes.h with gaps of B^-1 to B^-N (10, 6), holes of tori and of a plate, and
// free-form sheets; or the rows whose names start with ROWS. Each row: seconds from the model's bytes to the
// certificate, boxes, those with several sheets, bytes of the certificate, seconds of the C++ checker as a program,
// memory. A decision ends after S (60) seconds, or a quarter of that after a wider gap of its family had no proof, or
// four times that for free-form sheets; its row gives the reason.
#include <malloc.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "bench/arguments.h"
#include "io/read_model.h"
#include "io/splines/patch_model.h"
#include "io/splines/write_splines.h"
#include "models/thin_shapes.h"
#include "verify/certify/file_patches.h"
#include "verify/certify/patch_certifier.h"

namespace {

using namespace veritope;
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}
// The most memory that the program had since the last call of forget_peak, where the kernel can forget it.
double peak_mib() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (double kib = 0; word == "VmHWM:" && status >> kib) return kib / 1024;
  return 0;
}
void forget_peak() {
  malloc_trim(0);  // what earlier models took
  std::ofstream("/proc/self/clear_refs") << 5;
}

class Bench {
 public:
  Bench(fs::path programs)
      : checker_(programs / "veritope-check"),
        folder_(fs::temp_directory_path() / ("veritope_thin_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~Bench() { fs::remove_all(folder_); }

  // Returns whether it was proved.
  bool measure(const std::string& name, double gap, const patch_shapes::Patches& patches,
               double most_seconds) {
    const std::string model = spline_json_bytes(model_of(patches));
    forget_peak();
    const Clock::time_point start = Clock::now();
    const SplineFile file = std::get<SplineFile>(
        read_model_bytes({reinterpret_cast<const unsigned char*>(model.data()), model.size()},
                         "model.vjson", {})
            .value());
    FilePatches read = file_patches(file.model, PatchOrientation::kKeep).value();
    FileDecisionOptions options;
    options.search.cover.stops_at = [&](PieceForest::Id, std::size_t) {
      return seconds_since(start) > most_seconds;
    };
    const FileDecision decided = decide_file_patches(read, options);
    const PatchDecision& d = decided.decision;
    certificate::Bytes certificate;
    if (d.is_valid) certificate = make_patch_certificate(read, decided, subject_of(file, "bench"));
    const double seconds = seconds_since(start);
    std::size_t num_framed = 0, num_several = 0;
    for (const CoverBox& b : d.cover.boxes) {
      num_framed += b.framed ? 1 : 0;
      num_several += b.framed && b.framed->sheets.sheets.size() > 1 ? 1 : 0;
    }
    double check_seconds = 0;
    bool is_accepted = false;
    if (d.is_valid) {
      const Clock::time_point checking = Clock::now();
      is_accepted = check(model, std::string(certificate.begin(), certificate.end()));
      check_seconds = seconds_since(checking);
    }
    std::printf(
        "{\"row\":\"%s-%g\",\"ours\":%.3f,\"peer\":null,\"unit\":\"s\",\"valid\":%s,\"why\":\"%s\","
        "\"tried\":%zu,\"boxes\":%zu,\"framed\":%zu,\"several_sheets\":%zu,\"bytes\":%zu,"
        "\"check_s\":%.3f,\"accepted\":%s,\"peak_mib\":%.0f}\n",
        name.c_str(), gap, seconds, d.is_valid ? "true" : "false",
        d.is_valid               ? ""
        : seconds > most_seconds ? "time"
        : d.open                 ? d.open->code.c_str()
                                 : "refuted",
        d.boxes_tried, d.cover.boxes.size(), num_framed, num_several, certificate.size(),
        check_seconds, is_accepted ? "true" : "false", peak_mib());
    std::fflush(stdout);
    return d.is_valid;
  }

 private:
  bool check(const std::string& model, const std::string& certificate) {
    const fs::path model_path = folder_ / "model.vjson", path = folder_ / "model.cert";
    std::ofstream(model_path, std::ios::binary) << model;
    std::ofstream(path, std::ios::binary) << certificate;
    const std::string command =
        "'" + checker_.string() + "' '" + model_path.string() + "' '" + path.string() + "' >&2";
    return std::system(command.c_str()) == 0;
  }

  fs::path checker_, folder_;
};

}  // namespace

int main(int argc, char** argv) {
  int base = 10, digits = 6;
  double seconds = 60;
  std::string only;
  bench::read_arguments(
      argc, argv,
      {{"--base", &base}, {"--digits", &digits}, {"--seconds", &seconds}, {"--only", &only}});
  Bench bench(fs::read_symlink("/proc/self/exe").parent_path());
  const auto is_wanted = [&](const std::string& row) {
    return row.compare(0, only.size(), only) == 0;
  };
  for (const thin_shapes::Family& family : thin_shapes::families()) {
    Rational gap(1);
    bool is_proved = true;
    for (int i = 1; i <= digits && is_wanted(family.name); ++i) {
      gap /= Rational(base);
      is_proved &= bench.measure(family.name, nearest_double(gap),
                                 family.make(gap, thin_shapes::Walls::kApart),
                                 is_proved ? seconds : seconds / 4);
    }
  }
  for (int bits = 4; bits <= 20 && is_wanted("torus-with-hole"); bits += 4) {
    const Rational hole = Rational::power_of_two(-bits);
    bench.measure("torus-with-hole", nearest_double(hole),
                  patch_shapes::torus(Rational(1) + hole, 1), seconds);
  }
  const Rational tiny = Rational(1) / Rational(10'000);
  if (is_wanted("plate-with-hole-turned"))
    bench.measure("plate-with-hole-turned", nearest_double(tiny),
                  thin_shapes::turned(thin_shapes::plate_with_hole(tiny)), seconds);
  for (const int part : {50, 1000})
    if (is_wanted("sheet-50x50"))
      bench.measure("sheet-50x50", 1.0 / part,
                    thin_shapes::spline_sheet(50, Rational(1) / Rational(part)), 4 * seconds);
  for (const double gap : {1e-2, 1e-3})
    if (is_wanted("pn-shell"))
      bench.measure("pn-shell", gap, thin_shapes::pn_shell(gap), 4 * seconds);
  return 0;
}
