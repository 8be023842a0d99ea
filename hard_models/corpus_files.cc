// SPDX-License-Identifier: LGPL-3.0-or-later
#include "hard_models/corpus_files.h"

#include "hard_models/hard_mesh.h"
#include "hard_models/hard_patches.h"
#include "io/mesh/write_mesh.h"
#include "io/splines/patch_model.h"
#include "io/splines/write_splines.h"

namespace veritope::hard_models {
namespace {

// A line of the index.
struct Row {
  bool is_valid;
  int exit;
  std::string codes;
  int bodies, genus;
  const std::string& what;
};

class FolderBuilder {
 public:
  void add(std::string name, std::string bytes, const Row& row) {
    const auto known = [&](int number) { return row.is_valid ? std::to_string(number) : "-"; };
    index_ += name + "\t" + (row.is_valid ? "VALID" : "INVALID") + "\t" + std::to_string(row.exit) +
              "\t" + (row.codes.empty() ? "-" : row.codes) + "\t" + known(row.bodies) + "\t" +
              known(row.genus) + "\t" + row.what + "\n";
    ++(row.is_valid ? out_.num_valid : out_.num_invalid);
    out_.files.push_back({std::move(name), std::move(bytes)});
  }
  CorpusFolder take() {
    out_.files.push_back({"index.tsv", std::move(index_)});
    return std::move(out_);
  }

 private:
  CorpusFolder out_;
  std::string index_ = "file\tverdict\texit\tcodes\tbodies\tgenus\twhat\n";
};

std::string codes_of(const HardMesh& model) {
  std::string codes;
  for (std::size_t i = 0; i < kNumMeshRules; ++i) {
    if (model.breaks[i] == 0) continue;
    codes += (codes.empty() ? "" : " ") + std::string(rule_text(rule_at(i)).id) + ":" +
             std::to_string(model.breaks[i]);
  }
  return codes;
}

}  // namespace

CorpusFolder mesh_corpus(std::uint64_t seed) {
  FolderBuilder folder;
  const WriteOptions options = default_write_options(MeshFormat::kOff);
  for (const HardMesh& model : hard_meshes(seed)) {
    const bool valid = is_valid(model);
    folder.add(model.name + ".off", mesh_to_bytes(model.mesh, options).value(),
               {valid, valid ? 0 : 1, codes_of(model), model.bodies, model.genus, model.what});
  }
  return folder.take();
}

CorpusFolder patch_corpus(std::uint64_t seed) {
  FolderBuilder folder;
  for (const HardPatches& model : hard_patches(seed)) {
    const int exit = model.answer == Answer::kUndecided ? 3 : (model.is_valid ? 0 : 1);
    folder.add(model.name + ".vjson", spline_json_bytes(model_of(model.patches)),
               {model.is_valid, exit, model.code, model.bodies, model.genus, model.what});
  }
  return folder.take();
}

}  // namespace veritope::hard_models
