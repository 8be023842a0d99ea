// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_invalid_body.cc: B1 and B2 of docs/certificates/dms-invalid.md.
#include "dms_bytes.h"
#include "dms_invalid.h"

namespace {

struct DmsFindingBytes : DmsBytes {
  DmsFindingBytes(const DmsModel& m, const Body& bytes) : DmsBytes(bytes), model(m) {}

  const DmsModel& model;
  DmsFinding f;

  size_t byte() { return size_t(body.natural(1)); }
  size_t byte(uint64_t most, const char* why) {
    return size_t(at_most(body.natural(1), most, why));
  }
  size_t tet() {
    return size_t(at_most(varint(), model.file.tetrahedra.size() - 1, "there is no tetrahedron"));
  }
  void tets(int n) {
    for (; n > 0; --n) f.tetrahedra.push_back(tet());
  }
  void face() {
    const size_t t = tet();
    f.faces.push_back(DmsNamedFace{t, int(byte(3, "a tetrahedron has no face"))});
  }
  void vertices(int n) {
    for (; n > 0; --n)
      f.vertices.push_back(at_most(varint(), model.clouds.size() - 1, "there is no vertex"));
  }
  void index() {
    DmsIndex g;
    for (int& i : g) i = int(byte());
    f.indices.push_back(g);
  }
  void numbers(size_t n) {
    for (; n > 0; --n) f.numbers.push_back(rational());
  }
  void core() {  // kind 3
    tets(1);
    const size_t n = byte(4, "the number of tetrahedra W is");
    require(n >= 1, "B1", "there is no tetrahedron W");
    for (size_t i = 0; i < n; ++i) {
      index();
      f.replaced.push_back(byte(3, "a tetrahedron has no corner"));
      numbers(1);
    }
  }
  void hull() {  // kind 4
    face();
    DmsIndex g = {{0, 0, 0, 0}};
    for (size_t c = 1; c < 4; ++c) g[c] = int(byte());
    f.indices.push_back(g);
    tets(1);
    numbers(size_t(g[1] + g[2] + g[3] + 3));
  }
  void leaf() {
    tets(1);
    numbers(12);
    f.planes.push_back(planes());
  }
  void crossing() {  // kind 12
    for (int i = 0; i < 2; ++i) {
      face();
      numbers(9);
      f.planes.push_back(planes());
    }
    for (RestrictedPatch& s : f.crossing.sheet)
      for (Part& t : s.t) t = read_interval(this);
    for (auto& row : f.crossing.y)
      for (Big& y : row) y = Big(zigzag());
  }
  void witness() {
    switch (f.kind) {
      case kTetReversed: return tets(1);
      case kTetFaceOverused: return face(), face();
      case kCloudDegenerate: return tets(1), index();
      case kCloudNoCore: return core();
      case kCloudInside: return hull();
      case kNegativeJacobian: return numbers(3);
      case kZeroJacobian: return leaf();
      case kEdgeOverused: return vertices(2);
      case kSeveralFans: return vertices(1);
      case kFacesMeet: return face(), face(), numbers(6);
      case kTetrahedraMeet: return tets(2), numbers(3);
      case kImagesMeet: return numbers(6);
      case kImagesCross: return crossing();
      default: return leaf(), numbers(3);
    }
  }
};

}  // namespace

DmsFinding read_dms_finding(const DmsModel& model, const Body& body) {
  DmsFindingBytes b(model, body);
  require(b.body.begins_with("VTDI"), "B1", "another magic number");
  require(b.body.natural(4) == model.file.tetrahedra.size(), "B1", "the file's tetrahedra are",
          model.file.tetrahedra.size());
  b.f.kind = unsigned(b.byte(kImageCovers, "there is no kind"));
  b.witness();
  if (b.f.needs_map()) {
    const uint64_t faces = b.body.count(1);
    require(faces == model.faces.size(), "B1", "the faces of the boundary are", model.faces.size());
    while (b.f.boundary.size() < faces) b.f.boundary.push_back(b.planes());
  }
  b.end();

  if (b.f.needs_map()) check_dms_file(model.file);
  check_short(b.f.numbers, kMostDmsBodyBits);
  for (const std::vector<Ratio>& v : b.f.planes) check_short(v, kMostDmsBodyBits);
  for (const std::vector<Ratio>& v : b.f.boundary) check_short(v, kMostDmsBodyBits);
  return std::move(b.f);
}
