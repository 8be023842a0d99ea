// SPDX-License-Identifier: LGPL-3.0-or-later
// Laws that hold for every mesh: what a lossless file says is read back bit for bit, however its text is laid out.
#include <bit>
#include <cmath>
#include <cstdlib>

#include "io/mesh/write_mesh.h"
#include "tests/io/io_test_util.h"

#include <rapidcheck/gtest.h>  // needs gtest before it

namespace veritope {
namespace {

using io_test::content;

// Fixed seed; VT_TEST_SCALE multiplies the cases. RapidCheck reads this once, before the first property.
const int kConfigured = [] {
  const char* const scale = std::getenv("VT_TEST_SCALE");
  const int cases = 200 * std::max(1, scale != nullptr ? std::atoi(scale) : 1);
  const std::string parameters = "seed=20 max_success=" + std::to_string(cases);
  return ::setenv("RC_PARAMS", parameters.c_str(), 0);
}();

// Any finite binary64, with extreme exponents as likely as ordinary ones; -0 excepted.
rc::Gen<double> coordinate() {
  const auto any = rc::gen::map(rc::gen::arbitrary<std::uint64_t>(), [](std::uint64_t bits) {
    const auto value = std::bit_cast<double>(bits);
    return std::isfinite(value) ? value + 0.0 : 1.0;
  });
  const auto model = rc::gen::map(rc::gen::inRange(-1000000, 1000000),
                                  [](int i) { return static_cast<double>(i) / 1000; });
  const auto single = rc::gen::map(rc::gen::inRange(-1000000, 1000000), [](int i) {
    return static_cast<double>(static_cast<float>(i) / 1000);
  });
  return rc::gen::oneOf(any, model, single);
}

// As a reader would leave it: at least one triangle; positions may repeat and be unreferenced.
TriangleMesh any_mesh() {
  TriangleMesh mesh;
  const auto num = *rc::gen::inRange<std::size_t>(1, 40);
  for (std::size_t i = 0; i < num; ++i) {
    mesh.positions.push_back({*coordinate(), *coordinate(), *coordinate()});
  }
  const auto num_faces = *rc::gen::inRange<std::size_t>(1, 60);
  const auto id = rc::gen::inRange<std::uint32_t>(0, static_cast<std::uint32_t>(num));
  for (std::size_t f = 0; f < num_faces; ++f) mesh.faces.push_back({*id, *id, *id});
  return mesh;
}

TriangleMesh read_back(std::string_view bytes, MeshFormat format, bool as_indexed) {
  ModelReadOptions options;
  options.as_indexed = as_indexed;
  auto file = io_test::read(format, bytes, options);
  RC_ASSERT(file.has_value());
  return std::move(file->mesh);
}

void expect_same(const TriangleMesh& a, const TriangleMesh& b) {
  RC_ASSERT(a.faces == b.faces);
  RC_ASSERT(a.positions.size() == b.positions.size());
  for (std::size_t i = 0; i < a.positions.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      RC_ASSERT(std::bit_cast<std::uint64_t>(a.positions[i][axis]) ==
                std::bit_cast<std::uint64_t>(b.positions[i][axis]));
    }
  }
}

// Every blank becomes blanks, every line end this one; empty lines and comments where the format has them.
std::string laid_out_anew(const std::string& text, const std::string& eol, bool has_comments) {
  std::string result;
  for (const char c : text) {
    const auto dice = *rc::gen::inRange(0, 8);
    if (c == ' ') {
      result += dice == 0 ? "\t" : (dice == 1 ? " \v\f " : " ");
    } else if (c == '\n') {
      if (dice == 2) result += "  ";
      if (dice == 3 && has_comments) result += " # v 1 2 3";
      result += eol;
      if (dice == 4) result += eol + " " + eol;
      if (dice == 5 && has_comments) result += "# f 1 2 3" + eol;
    } else {
      result += c;
    }
  }
  return result;
}

RC_GTEST_PROP(RoundTrip, KeepsEveryBitInEveryLosslessVariant, ()) {
  const TriangleMesh mesh = any_mesh();
  for (const std::string& name : write_variant_names()) {
    const WriteOptions options = write_options_from_name(name).value();
    if (!loss_of(mesh, options).is_lossless()) continue;
    const std::string bytes = mesh_to_bytes(mesh, options).value();
    expect_same(read_back(bytes, options.format, true), mesh);
  }
}

RC_GTEST_PROP(RoundTrip, StlAsciiKeepsTheTrianglesAsPoints, ()) {
  const TriangleMesh mesh = any_mesh();
  const std::string text =
      mesh_to_bytes(mesh, write_options_from_name("stl-ascii").value()).value();
  const TriangleMesh back = read_back(text, MeshFormat::kStl, false);
  RC_ASSERT(back.faces.size() == mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      RC_ASSERT(back.positions[back.faces[f][k]] == mesh.positions[mesh.faces[f][k]]);
    }
  }
  // What is read from an STL is written to an STL without a loss.
  RC_ASSERT(loss_of(back, write_options_from_name("stl-ascii").value()).is_lossless());
}

RC_GTEST_PROP(RoundTrip, FloatFilesHoldTheNearestFloats, ()) {
  const TriangleMesh mesh = any_mesh();
  for (const char* name : {"ply-binary-little-endian-float", "ply-binary-big-endian-float"}) {
    const WriteOptions options = write_options_from_name(name).value();
    const LossReport loss = loss_of(mesh, options);
    const auto bytes = mesh_to_bytes(mesh, options);
    RC_ASSERT(bytes.has_value() == std::isfinite(loss.max_displacement));
    if (!bytes) continue;
    const TriangleMesh back = read_back(bytes.value(), options.format, true);
    double largest = 0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const Vec3d &p = mesh.positions[i], &q = back.positions[i];
      for (int axis = 0; axis < 3; ++axis) RC_ASSERT(q[axis] == static_cast<float>(p[axis]));
      largest = std::max(largest, std::hypot(p.x - q.x, p.y - q.y, p.z - q.z));
    }
    RC_ASSERT(loss.max_displacement >= largest * (1 - 1e-15));
    RC_ASSERT(loss.max_displacement <= largest * (1 + 1e-15));
    RC_ASSERT(loss.coordinates_change == (largest > 0));
  }
}

RC_GTEST_PROP(TextLayout, LineEndsBlanksAndCommentsDoNotMatter, ()) {
  const TriangleMesh mesh = any_mesh();
  const std::string eol = *rc::gen::elementOf(std::vector<std::string>{"\n", "\r", "\r\n"});
  for (const char* name : {"obj", "off", "stl-ascii"}) {
    const WriteOptions options = write_options_from_name(name).value();
    const std::string text = mesh_to_bytes(mesh, options).value();
    const bool has_comments = options.format != MeshFormat::kStl;
    expect_same(read_back(laid_out_anew(text, eol, has_comments), options.format, true),
                read_back(text, options.format, true));
  }
}

RC_GTEST_PROP(TextLayout, PlyBodiesMayBeLaidOutAnew, ()) {
  const TriangleMesh mesh = any_mesh();
  const std::string text =
      mesh_to_bytes(mesh, write_options_from_name("ply-ascii").value()).value();
  const std::size_t body = text.find("end_header\n") + 11;
  const std::string eol = *rc::gen::elementOf(std::vector<std::string>{"\n", "\r", "\r\n"});
  std::string header;
  for (const char c : text.substr(0, body)) header += c == '\n' ? eol : std::string(1, c);
  expect_same(
      read_back(header + laid_out_anew(text.substr(body), eol, false), MeshFormat::kPly, true),
      mesh);
}

RC_GTEST_PROP(Truncation, EveryPrefixIsReadOrRefusedButNeverWrong, ()) {
  const TriangleMesh mesh = any_mesh();
  const std::vector<std::string> names = write_variant_names();
  const WriteOptions options = write_options_from_name(*rc::gen::elementOf(names)).value();
  const auto bytes = mesh_to_bytes(mesh, options);
  if (!bytes) return;
  const std::string& text = bytes.value();
  const auto cut = *rc::gen::inRange<std::size_t>(1, text.size());
  const auto file = io_test::read(options.format, text.substr(0, text.size() - cut));
  // Text formats without counts may end early; nothing else may.
  if (file && options.format == MeshFormat::kObj) return;
  if (!file) return;
  RC_ASSERT(cut <= 30);  // a shorter last number, or only the tail of `endsolid veritope`
}

RC_GTEST_PROP(Corruption, AnyByteChangeEndsInAMeshOrAnError, ()) {
  const TriangleMesh mesh = any_mesh();
  const std::vector<std::string> names = write_variant_names();
  const WriteOptions options = write_options_from_name(*rc::gen::elementOf(names)).value();
  const auto bytes = mesh_to_bytes(mesh, options);
  if (!bytes) return;
  std::string text = bytes.value();
  const int num_changes = *rc::gen::inRange(1, 4);
  for (int i = 0; i < num_changes; ++i) {
    text[*rc::gen::inRange<std::size_t>(0, text.size())] = *rc::gen::arbitrary<char>();
  }
  const auto file = io_test::read(options.format, text);
  if (!file) return;
  RC_ASSERT(!file->mesh.faces.empty());
  for (const auto& face : file->mesh.faces) {
    for (const std::uint32_t v : face) RC_ASSERT(v < file->mesh.positions.size());
  }
  for (const Vec3d& p : file->mesh.positions) {
    for (int axis = 0; axis < 3; ++axis) {
      RC_ASSERT(std::isfinite(p[axis]) && !(p[axis] == 0 && std::signbit(p[axis])));
    }
  }
}

}  // namespace
}  // namespace veritope
