// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_inside.cc: the conditions of docs/certificates/micro-inside.md in their order.
#include "micro_inside.h"

#include "../common/sha256.h"
#include "../patches/star_box.h"
#include "micro_claim.h"

namespace {

const size_t kMostSkinDigits = 100;

bool is_digits(const std::string& s) {
  return !s.empty() && s.size() <= kMostSkinDigits &&
         s.find_first_not_of("0123456789") == std::string::npos;
}
bool is_skin(const std::string& s) {
  const size_t slash = s.find('/');
  if (slash == std::string::npos) return is_digits(s);
  const std::string denominator = s.substr(slash + 1);
  return is_digits(s.substr(0, slash)) && is_digits(denominator) &&
         denominator.find_first_not_of('0') != std::string::npos;
}

Model read_solid(const Statement& s) {
  try {
    return read_model(s.solid, s.text.at("model_format"), s.flag.at("as_indexed"));
  } catch (const Refused& r) {
    throw Refused{"the model " + s.solid_name + ": " + r.why};
  }
}

InsideBody read_inside(const MicroFile& file, const Body& body) {  // B1, B2
  Bytes bytes(body);
  InsideBody r = {{nullptr, nullptr}, {nullptr, nullptr}, {}};
  require(bytes.body.begins_with("VTIM"), "B1", "another magic number");
  const uint64_t lengths[2] = {bytes.body.natural(4), bytes.body.natural(4)};
  Body* const parts[2] = {&r.structure, &r.solid};
  for (size_t k = 0; k < 2; ++k) {
    require(lengths[k] <= bytes.body.left(), "B1", "too few bytes for a part:", lengths[k]);
    *parts[k] = Body{bytes.body.p, bytes.body.p + lengths[k]};
    bytes.body.p += lengths[k];
  }
  bool is_short = true;
  for (uint64_t left = bytes.body.count(11); left > 0; --left) {
    VoidEntry v = {bytes.body.natural(4), {}, 0};
    require(v.volume < file.cage.size(), "B1", "there is no volume", v.volume);
    for (Ratio& x : v.x) {
      x = bytes.rational();
      is_short = is_short && std::max(x.n.bits(), x.d.bits()) <= 64;
    }
    v.corner = bytes.at_most(bytes.body.natural(1), 8, "there is no corner");
    r.voids.push_back(v);
  }
  bytes.end();
  require(is_short, "B2", "the x of a void has long numbers");
  return r;
}

}  // namespace

void check_inside_values(const Statement& s) {
  const std::string& hash = s.text.at("model_sha256");
  require(hash.size() == 64 && hash.find_first_not_of("0123456789abcdef") == std::string::npos,
          "S1", "no hash of the model");
  const std::string &format = s.text.at("model_format"), &skin = s.text.at("skin");
  require(format == "stl" || format == "obj" || format == "ply" || format == "off", "S1",
          "unknown model_format");
  require(skin == "-" || is_skin(skin), "S1", "skin is no rational number");
}

std::string check_micro_inside(const Statement& s, std::string text, const Body& body) {
  require(s.number.at("model_bytes") == s.solid.size(), "A1", "the model's size is",
          s.solid.size());
  require(s.text.at("model_sha256") == sha256(s.solid.data(), s.solid.size()), "A1",
          "another model");
  MicroFile file = read_micro(text);
  text = std::string();
  Model model = read_solid(s);
  const InsideBody parts = read_inside(file, body);
  const CheckedMicro structure =
      check_micro_body(&file, s.number.at("subject_bytes"), parts.structure, true);
  const MeshKind kind = {"VTMV", s.flag.at("as_indexed"), false};
  const SolidMesh solid = check_solid(kind, &model, parts.solid);

  const Triangles triangles(model);
  VolumeMaps maps(file.cage);
  OffSurface off(file, triangles, &maps);
  off.check_cells();
  off.check_bridges();
  check_shells(structure.shells, model, &off);
  check_voids(parts.voids, file, model, solid, &maps);
  const bool has_skin = s.text.at("skin") != "-";
  require(has_skin != file.bridges.empty(), "I4",
          "there is a skin without bridges, or the reverse");
  if (has_skin) check_skin(file, triangles, &maps, read_number(s.text.at("skin")));
  return compared(s, structure.numbers);
}
