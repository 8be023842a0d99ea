// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/checker_fuzz.cc: gives any model and any certificate to the C++ checker, which must not crash, and whose
// accepted claims must be true. The input is the size of the model (4 bytes, little-endian), the model, the
// certificate. The mutator changes either, and then corrects the statement's sizes and hashes, so that changes get past
// S3 and S4.
#include <algorithm>
#include <cstring>
#include <random>
#include <string>
#include <string_view>

#include "fuzz/certificate_input.h"
#include "fuzz/decision_laws.h"
#include "io/read_model.h"
#include "solids/polyhedron/reversal.h"
#include "tests/support/checker_call.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace veritope::fuzz {
namespace {

void check(const Input& in) {
  const std::string answer = check_in_process(in.model, in.certificate);
  if (answer.substr(0, 4) == "BUG ") {
    std::fprintf(stderr, "%s\n", answer.c_str());
    std::abort();
  }
  if (answer.substr(0, 7) != "ACCEPT ") return;
  const std::string statement = in.certificate.substr(0, in.certificate.find('\n'));
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
  const TriangleMesh& mesh = file.value().mesh;
  if (mesh.faces.size() > 400) return;
  ValidityReport report = decide_validity(mesh, {1, 1});
  check_decision(mesh, report);
  const auto number = [&](const char* key, std::uint64_t want) {
    if (get(statement, key) != std::to_string(want))
      fail(std::string(key) + " is " + std::to_string(want) + "\n" + statement, mesh);
  };
  const bool claims_reversed = get(statement, "claim") == "mesh-reversed-1";
  if (claims_reversed) {
    if (!is_valid_once_reversed(report)) fail(answer + "\nbut " + summary(report), mesh);
    ReversedSolid solid = reverse_to_solid(mesh, std::move(report), 1);
    number("reversed", solid.reversal.faces);
    number("reversed_shells", solid.reversal.whole_shells);
    report = std::move(solid.report);
  }
  const bool claims_valid = claims_reversed || get(statement, "claim") == "mesh-valid-1";
  if (claims_valid != report.is_valid) fail(answer + "\nbut " + summary(report), mesh);
  if (!claims_valid) {
    // A witness of M8 or M9 proves INVALID, but not which of the two rules is broken.
    for (std::size_t k = 0; k < 7; ++k)
      if (get(statement, "rules").find("M" + std::to_string(k + 1)) != std::string::npos &&
          report.rule_counts[k] == 0)
        fail(answer + "\nbut " + summary(report), mesh);
    return;
  }
  number("vertices", report.counts.referenced_vertices);
  number("edges", report.counts.edges);
  number("faces", report.counts.faces);
  number("shells", report.counts.shells);
  number("bodies", report.counts.bodies.value());
  number("genus", static_cast<std::uint64_t>(report.counts.genus.value()));
  const Rational& v = report.volume.value();
  if (get(statement, "volume") != v.numerator().to_string() + "/" + v.denominator().to_string())
    fail("volume\n" + statement, mesh);
}

class Mutator {
 public:
  Mutator(Input in, unsigned seed) : in_(std::move(in)), random_(seed) {}
  Input take() { return std::move(in_); }

  void change() {
    const std::size_t line = std::min(in_.certificate.find('\n'), in_.certificate.size());
    switch (pick(10)) {
      case 0: change_statement(line); break;
      case 1: swap_words(line); break;
      case 2:
      case 3:
      case 4: change_byte(in_.certificate, line); break;
      case 5: change_byte(in_.model, in_.model.size() / 4); break;
      case 6: change_double(); break;
      case 7: change_digit(in_.model, random_); break;
      case 8: in_.certificate.insert(body_place(line), 1, static_cast<char>(pick(16))); break;
      default:
        if (in_.certificate.size() > line + 1) in_.certificate.erase(body_place(line), 1);
    }
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
      case 0: c = static_cast<char>(pick(40)); break;
      case 1: c = static_cast<char>(c + (pick(2) == 0 ? 1 : -1)); break;
      default: c = static_cast<char>(c ^ (1 << pick(8)));
    }
  }
  // Swaps two 4-byte words of the body, such as two entries of the order of the leaves.
  void swap_words(std::size_t line) {
    if (in_.certificate.size() < line + 21) return;
    const std::size_t words = (in_.certificate.size() - line - 13) / 4;
    const std::size_t a = line + 13 + 4 * pick(words), b = line + 13 + 4 * pick(words);
    if (std::max(a, b) + 4 > in_.certificate.size() || a == b) return;
    std::swap_ranges(in_.certificate.begin() + static_cast<std::ptrdiff_t>(a),
                     in_.certificate.begin() + static_cast<std::ptrdiff_t>(a + 4),
                     in_.certificate.begin() + static_cast<std::ptrdiff_t>(b));
  }
  // Changes a number at a multiple of 4 bytes before the end, where a binary model has coordinates.
  void change_double() {
    const std::size_t header = in_.model.find("end_header\n");
    if (header == in_.model.npos || in_.model.size() < header + 11 + 8) return;
    const std::size_t n = (in_.model.size() - header - 11) / 8, at = header + 11 + 8 * pick(n);
    double v = 0;
    std::memcpy(&v, in_.model.data() + at, 8);
    switch (pick(5)) {
      case 0: v = static_cast<double>(pick(7)) - 3; break;
      case 1: v = -v; break;
      case 2: v += 1; break;
      case 3: v *= 1 + 0x1p-52; break;
      default: std::memcpy(&v, in_.model.data() + header + 11 + 8 * pick(n), 8);
    }
    std::memcpy(in_.model.data() + at, &v, 8);
  }
  void change_statement(std::size_t line) {
    static const char* const kNumbers[] = {"vertices", "edges",  "faces",
                                           "shells",   "bodies", "genus"};
    std::string statement = in_.certificate.substr(0, line);
    const std::string rest = in_.certificate.substr(line);
    switch (pick(6)) {
      case 0: set(statement, kNumbers[pick(6)], std::to_string(pick(20))); break;
      case 1:
        set(statement, "volume", std::to_string(pick(20)) + "/" + std::to_string(1 + pick(6)));
        break;
      case 2: set(statement, "as_indexed", pick(2) == 0 ? "true" : "false"); break;
      case 3: set(statement, "rules", "M" + std::to_string(1 + pick(9))); break;
      case 4: {
        static const char* const kFormats[] = {"stl", "obj", "ply", "off"};
        set(statement, "subject_format", kFormats[pick(4)]);
        break;
      }
      default: change_byte(statement, 0);
    }
    in_.certificate = statement + rest;
  }

  Input in_;
  std::mt19937 random_;
};

}  // namespace
}  // namespace veritope::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  veritope::fuzz::check(veritope::fuzz::Input::decode(data, size));
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  using namespace veritope::fuzz;
  if (seed % 16 == 0) return LLVMFuzzerMutate(data, size, max_size);
  Mutator mutator(Input::decode(data, size), seed);
  for (unsigned n = 1 + seed / 16 % 3; n > 0; --n) mutator.change();
  Input in = mutator.take();
  if (seed % 16 != 1) make_hashes_true(in);
  const std::string bytes = in.encode();
  if (bytes.size() > max_size) return size;
  std::memcpy(data, bytes.data(), bytes.size());
  return bytes.size();
}
