// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/points_checker_fuzz.cc: gives any mesh or spline model, any answers file and any certificate to the C++ checker,
// which must not crash, and whose accepted claims about points must be true: rational arithmetic of the kernel and rays
// in random directions decide about meshes, the kernel's classifier about patches. The input is the size of the model
// and that of the answers (4 bytes each, little-endian), the model, the answers, the certificate. The mutator changes
// each of them, and then corrects the statement's sizes, hashes and numbers of lines.
#include <algorithm>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "fuzz/certificate_input.h"
#include "fuzz/decision_laws.h"
#include "io/base/exact_number.h"
#include "io/read_model.h"
#include "solids/classify/patch_classifier.h"
#include "tests/support/checker_call.h"
#include "tests/support/exact_geometry.h"
#include "verify/certify/file_patches.h"
#include "verify/certify/stand_in.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace veritope::fuzz {
namespace {

struct PointsInput : Input {
  std::string answers;

  static PointsInput decode(const std::uint8_t* data, std::size_t size) {
    PointsInput in;
    if (size < 8) return in;
    std::size_t n[2] = {0, 0};
    for (std::size_t i = 0; i < 8; ++i) n[i / 4] |= std::size_t{data[i]} << (8 * (i % 4));
    const char* const text = reinterpret_cast<const char*>(data) + 8;
    n[0] = std::min({n[0], size - 8, kMaxModel});
    n[1] = std::min({n[1], size - 8 - n[0], kMaxModel});
    in.model.assign(text, n[0]);
    in.answers.assign(text + n[0], n[1]);
    in.certificate.assign(text + n[0] + n[1], size - 8 - n[0] - n[1]);
    return in;
  }
  std::string encode() const {
    std::string out;
    for (const std::size_t n : {model.size(), answers.size()})
      for (int i = 0; i < 4; ++i) out += static_cast<char>(n >> (8 * i) & 255u);
    return out + model + answers + certificate;
  }
};

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

using Words = std::array<std::string, 6>;

Words words_of(const std::string& line) {
  std::istringstream words(line);
  Words word;
  for (std::string& w : word) words >> w;
  return word;
}

// False if the kernel does not read a coordinate.
bool read_point(const Words& word, bool nearest, RVec& p) {
  for (std::size_t k = 0; k < 3; ++k) {
    const ReadLimits limits{.max_digits = 4096};
    double rounded = 0;
    const bool is_decimal = word[k].find_first_of("/xX") == std::string::npos;
    if (nearest && is_decimal) {
      if (DecimalReader({.max_digits = 4096, .max_exponent = ~0u}).read_slowly(word[k], rounded) !=
          DecimalFault::kNone)
        return false;
      p[k] = Rational::from_double(rounded);
    } else if (read_exact_number(word[k], limits, p[k]) != DecimalFault::kNone) {
      return false;
    }
  }
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

class Mutator {
 public:
  Mutator(PointsInput in, unsigned seed) : in_(std::move(in)), random_(seed) {}
  PointsInput take() { return std::move(in_); }

  void change() {
    const std::size_t line = std::min(in_.certificate.find('\n'), in_.certificate.size());
    switch (pick(10)) {
      case 0: change_statement(line); break;
      case 1:
      case 2: change_byte(in_.certificate, line); break;
      case 3: change_byte(in_.model, in_.model.size() / 4); break;
      case 4: change_digit(in_.model, random_); break;
      case 5: change_byte(in_.answers, 0); break;
      case 6: change_digit(in_.answers, random_); break;
      case 7: replace_word(); break;
      case 8: in_.certificate.insert(body_place(line), 1, static_cast<char>(pick(8))); break;
      default:
        if (in_.certificate.size() > line + 1) in_.certificate.erase(body_place(line), 1);
    }
  }
  void correct() {
    make_hashes_true(in_);
    std::size_t counts[3] = {0, 0, 0};
    std::istringstream lines(in_.answers);
    for (std::string line; std::getline(lines, line); ++counts[0]) {
      counts[1] += line.find(" on ") != std::string::npos;
      counts[2] += line.find(" undecided ") != std::string::npos;
    }
    const std::size_t end = std::min(in_.certificate.find('\n'), in_.certificate.size());
    std::string statement = in_.certificate.substr(0, end);
    set(statement, "answers_sha256", hash(in_.answers));
    set(statement, "answers_bytes", std::to_string(in_.answers.size()));
    set(statement, "points", std::to_string(counts[0]));
    set(statement, "on", std::to_string(counts[1]));
    set(statement, "undecided", std::to_string(counts[2]));
    in_.certificate = statement + in_.certificate.substr(end);
  }

 private:
  std::size_t pick(std::size_t n) { return random_below(random_, n); }
  std::size_t body_place(std::size_t line) {
    const std::size_t first = std::min(line + 1, in_.certificate.size());
    return first + pick(in_.certificate.size() - first);
  }
  void change_byte(std::string& text, std::size_t from) {
    if (from >= text.size()) return;
    char& c = text[from + pick(text.size() - from)];
    switch (pick(3)) {
      case 0: c = static_cast<char>(pick(128)); break;
      case 1: c = static_cast<char>(c + (pick(2) == 0 ? 1 : -1)); break;
      default: c = static_cast<char>(c ^ (1 << pick(8)));
    }
  }
  // Puts a word where another one is, or a copy of a line at the end.
  void replace_word() {
    static const char* const kWords[] = {
        "in",   "out",       "on",   "-",      "undecided", "0",    "1",
        "-1",   "2",         "1/3",  "-2/7",   "0.5",       ".1",   "1e4",
        "1e-9", "0x1p-1000", "4e-9", "0x1p99", "0x1.8p0",   "-1.5", "1e-4000"};
    std::string& text = in_.answers;
    if (text.empty()) return;
    const std::size_t at = pick(text.size());
    const std::size_t begin =
        text.find_last_of(" \n", at) == text.npos ? 0 : text.find_last_of(" \n", at) + 1;
    const std::size_t end = std::min(text.find_first_of(" \n", begin), text.size());
    if (pick(4) != 0) {
      text.replace(begin, end - begin, kWords[pick(std::size(kWords))]);
    } else {
      const std::size_t first = text.find_last_of('\n', at == 0 ? 0 : at - 1);
      const std::size_t line = first == text.npos ? 0 : first + 1;
      text += text.substr(line, text.find('\n', line) - line) + "\n";
      in_.certificate += static_cast<char>(pick(6));
      if (const std::size_t body = in_.certificate.find('\n') + 13; body < in_.certificate.size())
        ++in_.certificate[body];
    }
  }
  void change_statement(std::size_t line) {
    std::string statement = in_.certificate.substr(0, line);
    const std::string rest = in_.certificate.substr(line);
    static const char* const kFlags[] = {"as_indexed", "winding"};
    switch (pick(4)) {
      case 0: set(statement, kFlags[pick(2)], pick(2) == 0 ? "true" : "false"); break;
      case 1: set(statement, "decimals", pick(2) == 0 ? "nearest" : "exact"); break;
      case 2: {
        static const char* const kFormats[] = {
            "stl", "obj",  "ply",         "off",       "vjson",    "itd",
            "g2",  "mfem", "vjson-faces", "itd-faces", "g2-faces", "mfem-faces"};
        set(statement, "subject_format", kFormats[pick(std::size(kFormats))]);
        break;
      }
      default: change_byte(statement, 0);
    }
    in_.certificate = statement + rest;
  }

  PointsInput in_;
  std::mt19937 random_;
};

}  // namespace
}  // namespace veritope::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  veritope::fuzz::check(veritope::fuzz::PointsInput::decode(data, size));
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  using namespace veritope::fuzz;
  if (seed % 16 == 0) return LLVMFuzzerMutate(data, size, max_size);
  Mutator mutator(PointsInput::decode(data, size), seed);
  for (unsigned n = 1 + seed / 16 % 3; n > 0; --n) mutator.change();
  if (seed % 16 != 1) mutator.correct();
  const std::string bytes = mutator.take().encode();
  if (bytes.size() > max_size) return size;
  std::memcpy(data, bytes.data(), bytes.size());
  return bytes.size();
}
