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

bool is_mesh(const std::string& format) {
  return format == "stl" || format == "obj" || format == "ply" || format == "off";
}
bool is_spline(const std::string& format) {
  for (const char* name : {"vjson", "itd", "g2", "mfem"})
    if (format == name || format == name + std::string("-faces")) return true;
  return false;
}

// The solid M: a mesh or a spline model.
struct GivenSolid {
  explicit GivenSolid(const Statement& s) {
    const std::string& format = s.text.at("model_format");
    try {
      if (is_mesh(format)) {
        mesh.reset(new Model(read_model(s.solid, format, s.flag.at("as_indexed"))));
      } else {
        entities = read_spline_model(s.solid, format);
      }
    } catch (const Refused& r) {
      throw Refused{"the model " + s.solid_name + ": " + r.why};
    }
  }
  // The conditions of the part about it, and I0.
  void check(const Statement& s, const Body& part, uint64_t body_bytes) {
    if (mesh != nullptr) {
      const MeshKind kind = {"VTMV", s.flag.at("as_indexed"), false};
      of_mesh.reset(new SolidMesh(check_solid(kind, mesh.get(), part)));
      surface.reset(new Triangles(*mesh));
      around = around_mesh(*mesh, *of_mesh);
      return;
    }
    of_patches = check_solid_patches(entities, s.solid.size(), part);
    of_patches.bytes = s.solid.size() + body_bytes;
    entities = std::vector<Entity>();
    surface.reset(new SplinePatches(of_patches.grids, of_patches.is_rational, of_patches.unit));
    around = around_patches(of_patches);
  }

  std::unique_ptr<Model> mesh;
  std::unique_ptr<const SolidMesh> of_mesh;
  std::vector<Entity> entities;
  SolidPatches of_patches;
  std::unique_ptr<Obstacle> surface;
  std::unique_ptr<SolidAround> around;
};

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
  require(is_mesh(format) || is_spline(format), "S1", "unknown model_format");
  require(skin == "-" || is_skin(skin), "S1", "skin is no rational number");
}

std::string check_micro_inside(const Statement& s, std::string text, const Body& body) {
  require(s.number.at("model_bytes") == s.solid.size(), "A1", "the model's size is",
          s.solid.size());
  require(s.text.at("model_sha256") == sha256(s.solid.data(), s.solid.size()), "A1",
          "another model");
  MicroFile file = read_micro(text);
  text = std::string();
  GivenSolid solid(s);
  const InsideBody read = read_inside(file, body);
  const CheckedMicro structure =
      check_micro_body(&file, s.number.at("subject_bytes"), read.structure, true);
  solid.check(s, read.solid, body.left());

  VolumeMaps maps(file.cage);
  TileParts parts(file, &maps);
  OffSurface off(&parts, solid.surface.get());
  off.check_cells();
  off.check_bridges();
  off.check_sweeps();
  solid.around->check_shells(structure.shells, &off);
  check_voids(read.voids, &parts, solid.around.get());
  const bool has_skin = s.text.at("skin") != "-";
  require(has_skin == !(file.bridges.empty() && file.sweeps.empty()), "I4",
          "there is a skin without bridges, or the reverse");
  if (has_skin) check_skin(&parts, solid.surface.get(), read_number(s.text.at("skin")));
  return compared(s, structure.numbers);
}
