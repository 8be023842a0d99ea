// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/expression_checker_fuzz.cc: gives any chain file, any answers file and any certificate to the C++ checker, which
// must not crash, and whose accepted words of expressions must be those of the kernel's classifier. Chain files may
// name four files: three solids, and an expression of two of them.
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "fuzz/points_input.h"
#include "io/chains/chain_file.h"
#include "io/read_model.h"
#include "solids/expression/expression_classifier.h"
#include "tests/support/checker_call.h"
#include "verify/certify/file_patches.h"
#include "verify/certify/stand_in.h"

namespace veritope::fuzz {
namespace {

std::string block_off(const char* const x[2]) {
  std::string out = "OFF\n8 6 0\n";
  for (unsigned i = 0; i < 8; ++i)
    out += std::string(x[i & 1u]) + ((i & 2u) != 0 ? " 1" : " 0") + ((i & 4u) != 0 ? " 1" : " 0") +
           "\n";
  return out + "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 1 3 7 5\n4 3 2 6 7\n4 2 0 4 6\n";
}

// The six faces of [0, 1] x [1, 2] x [0, 1], as bilinear patches.
std::string cube_vjson() {
  static const int kFaces[6][4] = {{0, 2, 1, 3}, {4, 5, 6, 7}, {0, 1, 4, 5},
                                   {1, 3, 5, 7}, {3, 2, 7, 6}, {2, 0, 6, 4}};
  std::string out = R"({"format": "veritope-spline-1", "groups": [], "entities": [)";
  for (int f = 0; f < 6; ++f) {
    out += f == 0 ? "" : ", ";
    out += R"({"kind": "surface", "group": null, "attributes": [], "shape": {"degrees": [1, 1], )"
           R"("periodic": [false, false], "knots": [["0", "0", "1", "1"], ["0", "0", "1", "1"]], )"
           R"("rational": false, "components": 3, "points": [)";
    for (int k = 0; k < 4; ++k) {
      // The last axis runs fastest: points 0, 2, 1, 3 of the list above.
      const int i = kFaces[f][k == 1 ? 2 : k == 2 ? 1 : k];
      out += std::string(k == 0 ? "" : ", ") + "[\"" + std::to_string(i & 1) + "\", \"" +
             std::to_string(1 + (i >> 1 & 1)) + "\", \"" + std::to_string(i >> 2) + "\"]";
    }
    out += "]}}";
  }
  return out + "]}";
}

std::string operand_text(const std::string& name, const std::string& path, const std::string& bytes,
                         const std::string& format) {
  return R"({"name": ")" + name + R"(", "path": ")" + path + R"(", "sha256": ")" + hash(bytes) +
         R"(", "format": ")" + format + R"("})";
}

const std::map<std::string, std::string>& files() {
  static const std::map<std::string, std::string>* const all = [] {
    const char* const left[] = {"0", "1"};
    const char* const right[] = {"1", "2"};
    auto* const out = new std::map<std::string, std::string>;
    (*out)["a.off"] = block_off(left);
    (*out)["b.off"] = block_off(right);
    (*out)["c.vjson"] = cube_vjson();
    (*out)["d.json"] =
        R"({"schema": "veritope-chain-1", "tool": "", "expression": "A - !B", "operands": [)" +
        operand_text("A", "a.off", (*out)["a.off"], "off") + ", " +
        operand_text("B", "b.off", (*out)["b.off"], "off") +
        R"(], "box": ["-1", "-1", "-1", "3", "2", "2"], "boundary": "not certified"})";
    return out;
  }();
  return *all;
}

std::string read_file(const std::string& name) {
  const auto at = files().find(name);
  if (at == files().end()) throw ::Refused{"does not exist"};
  return at->second;
}

std::span<const unsigned char> bytes_of(const std::string& text) {
  return {reinterpret_cast<const unsigned char*>(text.data()), text.size()};
}

std::shared_ptr<const Operand> make_operand(const std::string& name) {
  auto file = read_model_bytes(bytes_of(files().at(name)), name, {});
  if (!file) return nullptr;
  if (auto* const mesh = std::get_if<MeshFile>(&*file)) return mesh_operand(std::move(mesh->mesh));
  const auto& splines = std::get<SplineFile>(*file);
  auto patches = patches_of(splines, std::nullopt);
  return patches ? patch_operand(std::move(patches->complex)) : nullptr;
}

// Formulas of files, as the kernel understands them.
class Kernel {
 public:
  std::vector<std::shared_ptr<const Operand>> solids;

  std::optional<Formula> formula_of(const std::string& text) {
    const ByteBuffer bytes = copy_to_buffer(bytes_of(text));
    const Result<ChainFile> chain = read_chain(source_of(bytes, "e.json"), kLimits);
    if (!chain) return std::nullopt;
    std::vector<Formula> operands;
    for (const ChainOperand& o : chain->operands) {
      const auto at = std::ranges::find_if(
          files(), [&](const auto& file) { return hash(file.second) == o.sha256; });
      if (at == files().end()) return std::nullopt;
      std::optional<Formula> formula =
          o.format == "chain" ? formula_of(at->second) : variable_of(at->first);
      if (!formula) return std::nullopt;
      operands.push_back(std::move(*formula));
    }
    const Formula box =
        chain->tree.has_complement() ? box_variable(chain->box) : Formula::constant(true);
    return chain->tree.formula(operands, box);
  }

 private:
  static constexpr ReadLimits kLimits{};

  Formula variable_of(const std::string& name) {
    static auto* const made = new std::map<std::string, std::shared_ptr<const Operand>>;
    std::shared_ptr<const Operand>& operand = (*made)[name];
    if (operand == nullptr) operand = make_operand(name);
    return add(name, operand);
  }
  Formula box_variable(const ExactBox<3>& box) {
    std::string text;
    for (std::size_t k = 0; k < 3; ++k)
      text += box[k].lo.to_string() + " " + box[k].hi.to_string() + " ";
    return add(text, box_operand(box));
  }
  Formula add(const std::string& name, const std::shared_ptr<const Operand>& operand) {
    const auto [at, is_new] = variables_.emplace(name, static_cast<std::uint32_t>(solids.size()));
    if (is_new) solids.push_back(operand);
    return Formula::variable(at->second);
  }

  std::map<std::string, std::uint32_t> variables_;
};

[[noreturn]] void fail_with(const std::string& why) {
  std::fprintf(stderr, "%s\n", why.c_str());
  std::abort();
}

const char* text_of(PointWord word) {
  return word == PointWord::kIn ? "in" : word == PointWord::kOn ? "on" : "out";
}

void check_expression_input(const PointsInput& in) {
  const std::string answer = check_in_process(in.model, in.certificate, in.answers, read_file);
  if (answer.starts_with("BUG ")) fail_with(answer);
  const std::string statement = in.certificate.substr(0, in.certificate.find('\n'));
  if (!answer.starts_with("ACCEPT points-1") || get(statement, "subject_format") != "chain") return;
  if (!answer.ends_with(" 0 not covered")) return;  // nothing is claimed of some points
  Kernel kernel;
  const std::optional<Formula> formula = kernel.formula_of(in.model);
  if (!formula) return;  // the kernel has other limits of numbers and depth
  const ExpressionClassifier classifier(*formula, kernel.solids);
  std::istringstream lines(in.answers);
  std::string line;
  for (int n = 0; n < 20 && std::getline(lines, line); ++n) {
    const Words word = words_of(line);
    ExactPoint p;
    if (word[3] == "undecided") continue;
    if (!read_point(word, get(statement, "decimals") == "nearest", p))
      fail_with(answer + "\nbut the kernel does not read " + line);
    const PointWord found = classifier.classify(p);
    if (found != PointWord::kUndecided && text_of(found) != word[3])
      fail_with(answer + "\nbut the kernel finds " + text_of(found) + ": " + line);
  }
}

}  // namespace
}  // namespace veritope::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  veritope::fuzz::check_expression_input(veritope::fuzz::PointsInput::decode(data, size));
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  return veritope::fuzz::mutate_points(data, size, max_size, seed);
}
