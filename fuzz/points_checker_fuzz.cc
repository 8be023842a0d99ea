// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/points_checker_fuzz.cc: gives any mesh or spline model, any answers file and any certificate to the C++ checker,
// which must not crash, and whose accepted claims about points must be true: rational arithmetic of the kernel and rays
// in random directions decide about meshes, the kernel's classifier about patches.
#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "fuzz/decision_laws.h"
#include "fuzz/points_input.h"
#include "io/read_model.h"
#include "solids/classify/patch_classifier.h"
#include "tests/support/checker_call.h"
#include "tests/support/exact_geometry.h"
#include "verify/certify/file_patches.h"
#include "verify/certify/stand_in.h"

namespace veritope::fuzz {
namespace {

using oracle::cross;
using oracle::dot;
using oracle::RTriangle;
using oracle::RVec;
using oracle::operator-;

bool is_between(const RVec& p, const RVec& a, const RVec& b) {
  const RVec e = b - a, d = p - a;
  return oracle::is_zero(cross(e, d)) && oracle::sgn(dot(d, e)) >= 0 && dot(d, e) <= dot(e, e) &&
         (!oracle::is_zero(e) || oracle::is_zero(d));
}
bool contains(const RTriangle& t, const RVec& p) {
  const RVec n = oracle::normal_of(t);
  if (oracle::is_zero(n))
    return is_between(p, t[0], t[1]) || is_between(p, t[1], t[2]) || is_between(p, t[2], t[0]);
  if (oracle::sgn(dot(n, p - t[0])) != 0) return false;
  for (std::size_t i = 0; i < 3; ++i)
    if (oracle::sgn(dot(n, cross(t[(i + 1) % 3] - t[i], p - t[i]))) < 0) return false;
  return true;
}

// Fails unless what the line says is true.
void check_line(const TriangleMesh& mesh, const std::string& line, bool nearest,
                const std::string& answer) {
  const Words word = words_of(line);
  if (word[3] == "undecided") return;
  RVec p;
  if (!read_point(word, nearest, p)) fail(answer + "\nbut the kernel does not read " + line, mesh);
  bool is_on = false;
  std::vector<std::uint32_t> facets;  // those that are not degenerate
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const RTriangle t = oracle::rational_triangle(mesh, f);
    is_on = is_on || contains(t, p);
    if (!oracle::is_zero(oracle::normal_of(t))) facets.push_back(f);
  }
  if (is_on != (word[3] == "on")) fail(answer + "\nbut wrong: " + line, mesh);
  if (is_on) return;
  Random random(1);
  const int winding = oracle::winding_number(mesh, facets, p, random);
  if (std::to_string(winding) != word[4])
    fail(answer + "\nbut winding " + std::to_string(winding) + ": " + line, mesh);
}

[[noreturn]] void fail(const std::string& why) {
  std::fprintf(stderr, "%s\n", why.c_str());
  std::abort();
}

// The patches as the kernel cuts them; nothing if there are many, or none that it finds closed: certificates may cut
// surfaces into smaller ones.
std::unique_ptr<const PatchComplex> closed_patches(const std::string& bytes, std::string format) {
  const bool by_faces = format.ends_with("-faces");
  if (by_faces) format.resize(format.size() - 6);
  const auto file = read_model_bytes(
      std::span(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()),
      "model." + (format == "mfem" ? "mesh" : format), {});
  if (!file || !std::holds_alternative<SplineFile>(*file)) return nullptr;
  const auto& splines = std::get<SplineFile>(*file);
  const auto stand_in = stand_in_of(splines);
  if (!stand_in || stand_in->has_value() != by_faces) return nullptr;
  if (by_faces && !(*stand_in)->is_by_own_faces()) return nullptr;
  auto patches =
      by_faces ? file_patches((*stand_in)->file.model, PatchOrientation::kKeep, (*stand_in)->faces)
               : file_patches(splines.model, PatchOrientation::kKeep);
  constexpr std::size_t kMostPatches = 100;
  if (!patches || patches->complex == nullptr ||
      patches->complex->patches().size() > kMostPatches ||
      !patches->complex->is_closed_oriented_surface())
    return nullptr;
  return std::move(patches->complex);
}

// A model and its look-up, which takes longer to make than all else.
struct Known {
  std::unique_ptr<const PatchComplex> complex;  // may be null
  std::optional<PatchClassifier> classifier;
};
const Known& known_model(const std::string& bytes, const std::string& format) {
  constexpr std::size_t kMostKept = 8;
  static std::map<std::string, Known>* const all = new std::map<std::string, Known>;
  if (all->size() >= kMostKept) all->clear();
  const auto [at, is_new] = all->try_emplace(format + hash(bytes));
  if (is_new) {
    at->second.complex = closed_patches(bytes, format);
    if (at->second.complex != nullptr)
      at->second.classifier.emplace(PatchClassifier::make(*at->second.complex, false));
  }
  return at->second;
}

void check_patches(const PointsInput& in, const std::string& statement, const std::string& answer) {
  const Known& model = known_model(in.model, get(statement, "subject_format"));
  if (!model.classifier) return;
  std::istringstream lines(in.answers);
  std::string line;
  for (int n = 0; n < 20 && std::getline(lines, line); ++n) {
    const Words word = words_of(line);
    if (word[3] == "undecided") continue;
    RVec p;
    if (!read_point(word, get(statement, "decimals") == "nearest", p))
      fail(answer + "\nbut the kernel does not read " + line);
    const PointAnswer found = model.classifier->classify(ExactPoint{p[0], p[1], p[2]});
    if (!found.is_decided) continue;
    if (found.is_on() != (word[3] == "on") ||
        (!found.is_on() && std::to_string(found.winding) != word[4]))
      fail(answer + "\nbut the kernel finds winding " + std::to_string(found.winding) + ": " +
           line);
  }
}

void check(const PointsInput& in) {
  const std::string answer = check_in_process(in.model, in.certificate, in.answers);
  if (answer.substr(0, 4) == "BUG ") {
    std::fprintf(stderr, "%s\n", answer.c_str());
    std::abort();
  }
  if (answer.substr(0, 15) != "ACCEPT points-1") return;
  const std::string statement = in.certificate.substr(0, in.certificate.find('\n'));
  static const std::string_view kMeshes[] = {"stl", "obj", "ply", "off"};
  if (std::ranges::find(kMeshes, get(statement, "subject_format")) == std::end(kMeshes))
    return check_patches(in, statement, answer);
  ModelReadOptions options;
  options.as_indexed = get(statement, "as_indexed") == "true";
  options.limits = {~std::uint64_t{0}, ~std::uint64_t{0} >> 1, ~std::uint32_t{0} >> 1,
                    ~std::uint32_t{0} >> 1};
  const auto bytes =
      std::span(reinterpret_cast<const unsigned char*>(in.model.data()), in.model.size());
  const auto file = read_mesh_bytes(bytes, "model." + get(statement, "subject_format"), options);
  if (!file) {
    std::fprintf(stderr, "%s\nbut the kernel refuses the model\n", answer.c_str());
    std::abort();
  }
  if (file.value().mesh.faces.size() > 100) return;
  std::istringstream lines(in.answers);
  std::string line;
  for (int n = 0; n < 20 && std::getline(lines, line); ++n)
    check_line(file.value().mesh, line, get(statement, "decimals") == "nearest", answer);
}

}  // namespace
}  // namespace veritope::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  veritope::fuzz::check(veritope::fuzz::PointsInput::decode(data, size));
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  return veritope::fuzz::mutate_points(data, size, max_size, seed);
}
