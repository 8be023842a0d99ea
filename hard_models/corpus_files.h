// SPDX-License-Identifier: LGPL-3.0-or-later
// hard_models/corpus_files.h: hard models as the files of a folder, with an index of their answers.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace veritope::hard_models {

struct CorpusFile {
  std::string name;
  std::string bytes;
};
/// The files of one folder. The last one is the index, index.tsv: a line of names, then a line for each model, with
/// tabs between the columns
///   file     name in this folder
///   verdict  VALID or INVALID: the truth
///   exit     the status of `veritope certify`: 0, 1, or 3 where it answers UNDECIDED
///   codes    rules that are broken with their numbers ("M3:4 M7:2"); for patches the code of the finding or of the
///            reason for UNDECIDED; "-" for none
///   bodies, genus   of a valid model, summed over its shells; "-" for an invalid one
///   what     one sentence about the model
struct CorpusFolder {
  std::vector<CorpusFile> files;
  std::size_t num_valid = 0, num_invalid = 0;
};
/// Meshes as .off, with the shortest decimals that read back as the same binary64.
CorpusFolder mesh_corpus(std::uint64_t seed);
/// Models of patches as .vjson, with exact fractions.
CorpusFolder patch_corpus(std::uint64_t seed);

}  // namespace veritope::hard_models
