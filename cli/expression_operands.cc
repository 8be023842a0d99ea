// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/expression_operands.h"
#include "cli/model_files.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "cli/decided_model.h"
#include "cli/model_input.h"
#include "cli/output.h"
#include "io/formats.h"
#include "report/report_text.h"
#include "report/text_style.h"
#include "robust/base/check.h"
#include "solids/polyhedron/box_order.h"
#include "verify/certify/stand_in.h"
#include "verify/format/sha256.h"

namespace veritope::cli {
namespace {

std::string true_name(const std::string& path) {
  std::error_code none;
  return std::filesystem::weakly_canonical(path, none).string();
}

bool is_in_interior(const ExactBox<3>& inner, const ExactBox<3>& box) {
  for (std::size_t k = 0; k < 3; ++k)
    if (inner[k].lo <= box[k].lo || box[k].hi <= inner[k].hi) return false;
  return true;
}

ExactBox<3> box_around(const TriangleMesh& mesh) {
  const Box3d box = bounding_box_of_faces(mesh, 1);
  ExactBox<3> out;
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = {Rational::from_double(box.lo[k]), Rational::from_double(box.hi[k])};
  return out;
}

// Around the control points.
ExactBox<3> box_around(const PatchComplex& complex) {
  ExactBox<3> out;
  bool is_first = true;
  for (const Patch& patch : complex.patches())
    for (std::size_t i = 0; i < patch.num_control(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        Rational x = patch.component(static_cast<int>(k))[i];
        if (patch.is_rational()) x /= patch.component(3)[i];
        out[k] = is_first ? ExactInterval{x, x} : hull(out[k], ExactInterval{x, x});
      }
      is_first = false;
    }
  return out;
}

// The verdict with some of its defects.
std::string verdict_text(const FileReport& report) {
  constexpr std::size_t kMostShown = 5;
  std::string out = verdict_line(report, TextOptions());
  for (std::size_t i = 0; i < std::min(kMostShown, report.defects.size()); ++i)
    out += "  " + report.defects[i].code + " " + text_of(report.defects[i]) + "\n";
  if (report.verdict) out += "  veritope certify " + shown_path(report.path) + " says more\n";
  while (out.ends_with('\n')) out.pop_back();
  return out;
}

}  // namespace

bool is_chain_file(const std::string& path) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none)) return false;
  std::vector<char> begin(kMostChainStart);
  std::ifstream file(path, std::ios::binary);
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(file.gcount()));
  const ByteBuffer bytes =
      copy_to_buffer({reinterpret_cast<const unsigned char*>(begin.data()), begin.size()});
  return looks_like_chain(source_of(bytes, path));
}

ExactBox<3> hull_of(const std::vector<ExpressionOperand>& operands) {
  ExactBox<3> out = operands.front().box;
  for (const ExpressionOperand& o : operands)
    for (std::size_t k = 0; k < 3; ++k) out[k] = hull(out[k], o.box[k]);
  return out;
}

std::nullopt_t ExpressionOperands::refuse(ExitCode exit, const std::string& text) {
  progress_.clear();
  complain(text);
  exit_ = first_of(exit_, exit);
  return std::nullopt;
}

std::optional<ExpressionOperand> ExpressionOperands::load(const std::string& path,
                                                          const std::string& label) {
  return load(path, label, nullptr);
}

std::optional<ExpressionOperand> ExpressionOperands::load_chain(const std::string& path) {
  return load(path, "", nullptr);
}

std::optional<ExpressionOperand> ExpressionOperands::load(const std::string& path,
                                                          const std::string& label,
                                                          const ChainOperand* expected) {
  const std::string begin = label.empty() ? "" : label + ": ";
  if (std::find(open_.begin(), open_.end(), true_name(path)) != open_.end())
    return refuse(kExitUnreadable, begin + harmless(path) + " is an operand of itself");
  progress_.phase(shown_path(path), "reading");
  const Result<ModelBytes> bytes = load_model(path, settings_.reading);
  if (!bytes) return refuse(kExitUnreadable, begin + harmless(to_string(bytes.error())));
  files_.push_back(path);
  const std::string sha =
      to_hex(sha256({bytes->bytes.data(), static_cast<std::size_t>(bytes->bytes.size())}));
  if (expected != nullptr && sha != expected->sha256)
    return refuse(kExitUnreadable,
                  begin + harmless(path) +
                      " has changed since the expression was made: its SHA-256 is " + sha +
                      ", not " + expected->sha256);
  const bool is_chain = expected != nullptr
                            ? expected->format == kChainFormat
                            : looks_like_chain(source_of(bytes->bytes, bytes->name));
  std::optional<FormatId> format;
  if (!is_chain && expected != nullptr) {
    const ModelFormat* const row = format_from_name(expected->format);
    if (row == nullptr)
      return refuse(kExitUnreadable,
                    begin + "there is no format " + veritope::quoted(expected->format));
    format = row->id;
  } else if (!is_chain) {
    ModelReadOptions any = settings_.reading;
    any.format.reset();
    const Result<FormatId> chosen = choose_format(*bytes, any);
    if (!chosen) return refuse(kExitUnreadable, begin + harmless(to_string(chosen.error())));
    format = *chosen;
  }
  const std::string name(is_chain ? kChainFormat : model_format(*format).name);
  if (const auto found = known_.find({sha, name}); found != known_.end()) return found->second;
  std::optional<ExpressionOperand> out =
      is_chain ? read_chain_of(path, *bytes, begin) : decide(path, begin, format, sha);
  if (out) {
    out->sha256 = sha;
    out->format = name;
    out->bytes = bytes->bytes.size();
    if (!is_chain) sources_.back().bytes = out->bytes;
  }
  return known_[{sha, name}] = std::move(out);
}

std::optional<ExpressionOperand> ExpressionOperands::read_chain_of(const std::string& path,
                                                                   const ModelBytes& bytes,
                                                                   const std::string& begin) {
  const Result<ChainFile> chain =
      read_chain(source_of(bytes.bytes, bytes.name), settings_.reading.limits);
  if (!chain) return refuse(kExitUnreadable, begin + harmless(to_string(chain.error())));
  if (open_.size() >= kMostDepth)
    return refuse(kExitUnreadable, begin + harmless(path) + ": more than " +
                                       std::to_string(kMostDepth) + " chain files in each other");
  open_.push_back(true_name(path));
  std::vector<ExpressionOperand> operands;
  std::vector<std::string> names;
  for (const ChainOperand& o : chain->operands) {
    names.push_back(o.name);
    auto operand = load(beside(path, o.path), begin + harmless(path) + ": operand " + o.name, &o);
    if (operand) operands.push_back(std::move(*operand));
  }
  open_.pop_back();
  if (operands.size() < chain->operands.size()) return std::nullopt;
  Result<ExpressionOperand> out = combine({&chain->tree, &operands, &names, chain->box});
  if (!out) return refuse(kExitUnreadable, begin + harmless(path) + ": " + out.error().message);
  return std::move(*out);
}

Result<ExpressionOperand> ExpressionOperands::combine(const BoundExpression& e) {
  std::vector<ExpressionSize> sizes;
  for (std::size_t i = 0; i < e.operands->size(); ++i) {
    sizes.push_back((*e.operands)[i].size);
    if (!is_in_interior((*e.operands)[i].box, e.box))
      return bad_argument("the operand " + (*e.names)[i] + " is not in the interior of the box");
  }
  ExpressionOperand out;
  out.size = e.tree->size(sizes);
  if (!out.size.is_allowed())
    return Error{Code::kOverLimit,
                 {},
                 "the expression has " + std::to_string(out.size.leaves) + " operands and depth " +
                     std::to_string(out.size.depth) + "; at most " + std::to_string(kMostLeaves) +
                     " and " + std::to_string(kMostDepth) + " are allowed"};
  std::vector<Formula> formulas;
  for (const ExpressionOperand& o : *e.operands) formulas.push_back(o.formula);
  const Formula box =
      e.tree->has_complement() ? Formula::variable(variable_of(e.box)) : Formula::constant(true);
  out.formula = e.tree->formula(formulas, box);
  out.box = e.box;
  return out;
}

std::optional<ExpressionOperand> ExpressionOperands::decide(const std::string& path,
                                                            const std::string& begin,
                                                            std::optional<FormatId> format,
                                                            const std::string& sha256) {
  CertifySettings settings = settings_;
  settings.reading.format = format;
  ModelFile model;
  settings.model = &model;
  const CertifiedFile done = certify_file(path, settings, {}, progress_);
  progress_.clear();
  if (done.report.verdict != Verdict::kValid)
    return refuse(done.report.exit, begin + verdict_text(done.report));
  if (done.report.sha256 != sha256)
    return refuse(kExitUnreadable, begin + harmless(path) + " changed while it was read");
  if (const Status status = require_surface(model, path); !status)
    return refuse(kExitUnreadable, begin + harmless(to_string(status.error())));
  ExpressionSolid source;
  ExpressionOperand out;
  solid_names_.push_back(harmless(path));
  if (auto* const mesh = std::get_if<MeshFile>(&model)) {
    if (mesh->copy) exclude_from_certificates(path, "the checkers read meshes, not these polygons");
    out.box = source.box = box_around(mesh->mesh);
    out.formula = add(std::move(mesh->mesh), std::move(source));
    return out;
  }
  const auto& file = std::get<SplineFile>(model);
  const Result<std::optional<StandIn>> stand_in = stand_in_of(file);
  VT_CHECK(static_cast<bool>(stand_in), "a valid model of volumes has boundary faces");
  Result<FilePatches> patches = patches_of(file, *stand_in);
  VT_CHECK(patches && patches->complex, "a valid model has patches");
  if (*stand_in ? (*stand_in)->is_copy() : !is_read_by_checkers(file))
    exclude_from_certificates(path, "the checkers do not read this file, but a copy");
  else if (file.beyond_default_limits)
    exclude_from_certificates(path, "the file has longer numbers than certificates may be about");
  source.is_by_faces = *stand_in && (*stand_in)->is_by_own_faces();
  source.entities = std::move(patches->entities);
  out.box = source.box = box_around(*patches->complex);
  out.formula = add(std::move(patches->complex), std::move(source));
  has_patches_ = true;
  return out;
}

Formula ExpressionOperands::add(Solid solid, ExpressionSolid source) {
  const auto variable = static_cast<std::uint32_t>(solids_.size());
  solids_.push_back(std::move(solid));
  sources_.push_back(std::move(source));
  return Formula::variable(variable);
}

void ExpressionOperands::exclude_from_certificates(const std::string& path,
                                                   const std::string& why) {
  if (no_certificate_.empty()) no_certificate_ = path + ": " + why;
}

std::uint32_t ExpressionOperands::variable_of(const ExactBox<3>& box) {
  std::string text;
  for (std::size_t k = 0; k < 3; ++k)
    text += box[k].lo.to_string() + " " + box[k].hi.to_string() + " ";
  const auto [at, is_new] = boxes_.emplace(text, static_cast<std::uint32_t>(solids_.size()));
  if (is_new) {
    ExpressionSolid source;
    source.box = box;
    add(box, std::move(source));
    solid_names_.emplace_back("the box");
  }
  return at->second;
}

std::optional<ExactBox<3>> ExpressionOperands::box_of(const Formula& formula) const {
  std::optional<ExactBox<3>> out;
  for (const std::uint32_t variable : formula.variables()) {
    const Solid& solid = solids_[variable];
    ExactBox<3> box;
    if (const auto* const mesh = std::get_if<TriangleMesh>(&solid))
      box = box_around(*mesh);
    else if (const auto* const own = std::get_if<ExactBox<3>>(&solid))
      box = *own;
    else
      box = box_around(*std::get<std::unique_ptr<const PatchComplex>>(solid));
    out = out ? hull(*out, box) : std::move(box);
  }
  return out;
}

std::vector<ExpressionSolid> ExpressionOperands::take_solids() {
  for (std::size_t i = 0; i < solids_.size(); ++i) {
    std::shared_ptr<const Operand>& out = sources_[i].operand;
    if (auto* const mesh = std::get_if<TriangleMesh>(&solids_[i]))
      out = mesh_operand(std::move(*mesh));
    else if (const auto* const box = std::get_if<ExactBox<3>>(&solids_[i]))
      out = box_operand(*box);
    else
      out = patch_operand(std::move(std::get<std::unique_ptr<const PatchComplex>>(solids_[i])));
  }
  solids_.clear();
  return std::move(sources_);
}

}  // namespace veritope::cli
