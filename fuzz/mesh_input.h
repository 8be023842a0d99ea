// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/mesh_input.h: small meshes as bytes, and the reverse: certify_fuzz.cc reads them and its mutator changes them.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "solids/polyhedron/triangle_mesh.h"

namespace veritope::fuzz {

/// Byte 0: options. Byte 1: scale. Byte 2: number of vertices. Then 6 bytes a vertex (a grid byte and a nudge byte for
/// each coordinate), then 3 bytes a face (vertex ids modulo the number of vertices).
struct MeshInput {
  static constexpr std::size_t kMaxVertices = 40, kMaxFaces = 64;
  static constexpr std::uint8_t kAsIndexed = 1, kTwoJobs = 2, kMixedScales = 4;

  std::uint8_t options = 0, scale = 0;
  std::vector<std::array<std::uint8_t, 6>> vertices;
  std::vector<std::array<std::uint8_t, 3>> faces;

  static MeshInput decode(const std::uint8_t* data, std::size_t size) {
    MeshInput in;
    const std::uint8_t* const end = data + size;
    const auto byte = [&]() -> std::uint8_t { return data == end ? 0 : *data++; };
    in.options = byte();
    in.scale = byte();
    in.vertices.resize(1 + byte() % kMaxVertices);
    for (auto& v : in.vertices)
      for (auto& b : v) b = byte();
    while (data != end && in.faces.size() < kMaxFaces) {
      const std::uint8_t a = byte(), b = byte(), c = byte();
      in.faces.push_back({a, b, c});
    }
    if (in.faces.empty()) in.faces.push_back({0, 1, 2});
    return in;
  }

  std::vector<std::uint8_t> encode() const {
    std::vector<std::uint8_t> out{options, scale, static_cast<std::uint8_t>(vertices.size() - 1)};
    for (const auto& v : vertices) out.insert(out.end(), v.begin(), v.end());
    for (const auto& f : faces) out.insert(out.end(), f.begin(), f.end());
    return out;
  }

  /// The grid byte is a signed integer; the nudge byte moves it by ulps, halves, or to an extreme.
  double coordinate(std::uint8_t grid, std::uint8_t nudge) const {
    double v = static_cast<std::int8_t>(grid);
    const int amount = (nudge & 15) - 8;
    switch (nudge == 0 ? 0 : 1 + nudge / 16 % 5) {
      case 0: break;
      case 1: v += amount * 0x1p-3; break;
      case 2: v += amount * 0x1p-40; break;
      case 3:
        for (int i = 0; i < std::abs(amount); ++i) v = std::nextafter(v, amount < 0 ? -1e9 : 1e9);
        break;
      case 4: v /= 3; break;
      default:
        if ((options & kMixedScales) != 0) v = std::ldexp(v, 120 * amount);
    }
    const int exponent = scale == 0 ? 0 : static_cast<int>(scale) * 8 - 1020;
    v = std::ldexp(v, exponent);
    constexpr double kMost = std::numeric_limits<double>::max();
    return std::clamp(v, -kMost, kMost) + 0.0;
  }

  TriangleMesh mesh() const {
    TriangleMesh out;
    for (const auto& v : vertices)
      out.positions.push_back({coordinate(v[0], v[1]), coordinate(v[2], v[3]), coordinate(v[4], v[5])});
    const auto n = static_cast<std::uint32_t>(vertices.size());
    for (const auto& f : faces) out.faces.push_back({f[0] % n, f[1] % n, f[2] % n});
    return out;
  }
};

/// One change at a time, of a kind that fits meshes: places, ids, facets, whole parts.
class MeshMutator {
 public:
  MeshMutator(MeshInput in, unsigned seed) : in_(std::move(in)), random_(seed) {
    for (auto& f : in_.faces)
      for (auto& id : f) id = static_cast<std::uint8_t>(id % in_.vertices.size());
  }

  MeshInput take() { return std::move(in_); }

  void change() {
    switch (pick(13)) {
      case 0: vertex()[2 * pick(3)] = static_cast<std::uint8_t>(pick(9)); break;
      case 1: vertex()[2 * pick(3)] += pick(2) == 0 ? 1 : 255; break;
      case 2: vertex()[2 * pick(3) + 1] = pick(3) == 0 ? 0 : static_cast<std::uint8_t>(pick(256)); break;
      case 3: vertex() = in_.vertices[pick(in_.vertices.size())]; break;  // equal places
      case 4: onto_a_segment(); break;
      case 5: std::swap(face()[0], face()[1]); break;
      case 6: turn_over(); break;
      case 7: face()[pick(3)] = static_cast<std::uint8_t>(pick(in_.vertices.size())); break;
      case 8:
        in_.faces.size() > 1 && pick(2) == 0
            ? in_.faces.erase(in_.faces.begin() +
                              static_cast<std::ptrdiff_t>(pick(in_.faces.size()))),
            void() : add_face(face());
        break;
      case 9: add_tetrahedron(); break;
      case 10: add_copy(); break;
      case 11:
        pick(2) == 0 ? in_.options ^= static_cast<std::uint8_t>(1u << pick(3))
                     : in_.scale = pick(2) == 0 ? 0 : static_cast<std::uint8_t>(pick(256));
        break;
      default: split_face();
    }
  }

 private:
  std::size_t pick(std::size_t n) { return n == 0 ? 0 : random_() % n; }
  std::array<std::uint8_t, 6>& vertex() { return in_.vertices[pick(in_.vertices.size())]; }
  std::array<std::uint8_t, 3>& face() { return in_.faces[pick(in_.faces.size())]; }

  void add_face(std::array<std::uint8_t, 3> f) {
    if (in_.faces.size() < MeshInput::kMaxFaces) in_.faces.push_back(f);
  }
  std::uint8_t add_vertex(const std::array<std::uint8_t, 6>& v) {
    if (in_.vertices.size() == MeshInput::kMaxVertices) return static_cast<std::uint8_t>(pick(in_.vertices.size()));
    in_.vertices.push_back(v);
    return static_cast<std::uint8_t>(in_.vertices.size() - 1);
  }
  static std::uint8_t middle(std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>((static_cast<std::int8_t>(a) + static_cast<std::int8_t>(b)) / 2);
  }
  void onto_a_segment() {
    const auto a = vertex(), b = vertex();
    auto& v = vertex();
    for (std::size_t k = 0; k < 6; k += 2) v[k] = middle(a[k], b[k]), v[k + 1] = 0;
  }
  void turn_over() {
    for (auto& f : in_.faces) std::swap(f[1], f[2]);
  }
  void add_tetrahedron() {
    std::array<std::uint8_t, 4> id{};
    const auto x = static_cast<std::uint8_t>(pick(9)), y = static_cast<std::uint8_t>(pick(9)),
               z = static_cast<std::uint8_t>(pick(9));
    const auto s = static_cast<std::uint8_t>(1 + pick(5));
    id[0] = add_vertex({x, 0, y, 0, z, 0});
    id[1] = add_vertex({static_cast<std::uint8_t>(x + s), 0, y, 0, z, 0});
    id[2] = add_vertex({x, 0, static_cast<std::uint8_t>(y + s), 0, z, 0});
    id[3] = add_vertex({x, 0, y, 0, static_cast<std::uint8_t>(z + s), 0});
    add_face({id[0], id[2], id[1]});
    add_face({id[0], id[1], id[3]});
    add_face({id[1], id[2], id[3]});
    add_face({id[2], id[0], id[3]});
  }
  // Adds a copy of the whole, moved by a small vector and sometimes reversed.
  void add_copy() {
    const std::size_t n = in_.vertices.size(), m = in_.faces.size();
    if (2 * n > MeshInput::kMaxVertices || 2 * m > MeshInput::kMaxFaces) return;
    const std::uint8_t by[3] = {static_cast<std::uint8_t>(pick(7)),
                                static_cast<std::uint8_t>(pick(7)),
                                static_cast<std::uint8_t>(pick(7))};
    const bool over = pick(2) == 0;
    for (std::size_t i = 0; i < n; ++i) {
      auto v = in_.vertices[i];
      for (std::size_t k = 0; k < 3; ++k) v[2 * k] = static_cast<std::uint8_t>(v[2 * k] + by[k]);
      in_.vertices.push_back(v);
    }
    for (std::size_t i = 0; i < m; ++i) {
      auto f = in_.faces[i];
      for (auto& id : f) id = static_cast<std::uint8_t>(id + n);
      if (over) std::swap(f[1], f[2]);
      in_.faces.push_back(f);
    }
  }
  // Splits one face into three around a point near its middle.
  void split_face() {
    if (in_.vertices.size() == MeshInput::kMaxVertices || in_.faces.size() + 2 > MeshInput::kMaxFaces) return;
    const std::size_t at = pick(in_.faces.size());
    const auto f = in_.faces[at];
    const auto &a = in_.vertices[f[0]], &b = in_.vertices[f[1]], &c = in_.vertices[f[2]];
    std::array<std::uint8_t, 6> v{};
    for (std::size_t k = 0; k < 6; k += 2) v[k] = middle(middle(a[k], b[k]), c[k]);
    if (pick(2) == 0) v[2 * pick(3) + 1] = static_cast<std::uint8_t>(pick(256));
    const std::uint8_t m = add_vertex(v);
    in_.faces[at] = {f[0], f[1], m};
    in_.faces.push_back({f[1], f[2], m});
    in_.faces.push_back({f[2], f[0], m});
  }

  MeshInput in_;
  std::mt19937 random_;
};

}  // namespace veritope::fuzz
