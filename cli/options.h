// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/options.h: the command line as data. What it may say: docs/cli.md.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/cover_picture.h"
#include "io/model_file.h"
#include "named_predicates/named_predicate.h"

namespace veritope::cli {

enum class Command {
  kCertify,
  kInfo,
  kConvert,
  kIntersect,
  kProject,
  kCover,
  kExplain,
  kExplainCertificate,
  kPredicate,
  kSelftest,
  kCorpus
};

struct Options {
  Command command = Command::kCertify;
  /// certify, info: inputs; convert: IN; project: SURFACE; explain-certificate: F; predicate: FILE
  std::vector<std::string> files;
  ModelReadOptions reading;                ///< commands that read models
  std::optional<std::string> json;         ///< certify, info, cover --sweep, ...
  std::optional<std::string> certificate;  ///< certify
  std::optional<std::string> picture;      ///< certify
  /// certify; nothing: 20, and pairs of faces are not listed one by one
  std::optional<std::uint64_t> max_defects;
  unsigned jobs = 1;
  bool no_check = false, quiet = false;          ///< certify
  bool orient_auto = false;                      ///< certify, cover, of spline files: --orient auto
  bool collar = false;                           ///< certify, of spline files
  std::optional<double> tolerance;               ///< certify, of spline files: --tolerance
  std::string output;                            ///< convert: OUT; cover: -o, or nothing
  CoverPart cover_part = CoverPart::kCollar;     ///< cover: --what
  std::optional<int> sweep;                      ///< cover: --sweep
  std::optional<double> eps;                     ///< cover: --eps; else chosen by the model's size
  std::optional<std::string> to;                 ///< convert
  bool single_precision = false, lossy = false;  ///< convert
  bool faces = false;                            ///< convert, of volumes
  std::optional<double> chord;                   ///< convert, of splines to obj or gltf
  double gap = 0;                                ///< intersect; 0: chosen by the model's size
  std::uint64_t max_pairs = 200000000;           ///< intersect
  std::optional<std::string> curves;             ///< intersect: -o
  std::string point;                             ///< project: POINT
  std::uint64_t max_boxes = 100000;              ///< project, of each curve and surface
  std::optional<std::string> rule;               ///< explain
  std::uint64_t max_items = 20;                  ///< explain-certificate
  const NamedPredicate* predicate = nullptr;     ///< predicate; null: each line names its own
  bool expect = false, tiers = false;            ///< predicate
  std::uint64_t num_cases = 100000;              ///< selftest, corpus
  std::uint64_t seed = 1;                        ///< selftest, corpus
};

/// What the arguments ask for: a command, or a text to print (help, version), or neither: wrong usage.
struct ParsedArguments {
  std::optional<Options> options;
  std::string text;   ///< to print on standard output
  std::string error;  ///< one sentence
};
ParsedArguments parse_arguments(int argc, const char* const* argv);

}  // namespace veritope::cli
