// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "solid_points.h"

#include "patch_cone.h"

namespace {

bool is_mesh(const std::string& format) {
  return format == "stl" || format == "obj" || format == "ply" || format == "off";
}

Ratio ratio_of(int64_t key) {  // of a binary64 number
  if (key == 0) return Ratio();
  Big n;
  n.m.push_back(key_mantissa(key));
  n.neg = key < 0;
  return scaled(Ratio(n), key_exponent(key) - 1075);
}

Bounds3 box_of(const MeshPoints& mesh) {
  Bounds3 r;
  for (int k = 0; k < 3; ++k) {
    r.lo[k] = ratio_of(mesh.box().min[k]);
    r.hi[k] = ratio_of(mesh.box().max[k]);
  }
  return r;
}

Bounds3 box_of(const PatchSurface& surface) {
  Bounds3 r;
  bool is_first = true;
  for (const Patch& p : surface.patches())
    for (size_t i = 0; i < p.net.size(); i += 4, is_first = false)
      for (size_t k = 0; k < 3; ++k) {
        const Ratio x(p.net[i + k], p.net[i + 3]);
        if (is_first || compare(x, r.lo[k]) < 0) r.lo[k] = x;
        if (is_first || compare(r.hi[k], x) < 0) r.hi[k] = x;
      }
  return r;
}

}  // namespace

SolidPoints::SolidPoints(const Expression::Solid& solid, bool as_indexed, uint64_t body_size,
                         Bytes* bytes) {
  if (is_mesh(solid.format)) {
    model_.reset(new Model(read_model(solid.bytes, solid.format, as_indexed)));
    require(bytes->body.natural(4) == model_->faces(), "B1", "the solid's number of triangles is",
            model_->faces());
    require(bytes->body.natural(4) == model_->vertices(), "B1", "the solid's number of vertices is",
            model_->vertices());
    mesh_.reset(new MeshPoints(*model_));
    require(mesh_->is_closed(), "P1", "the triangles of a solid are no closed chain");
    box_ = box_of(*mesh_);
    return;
  }
  const bool by_faces = bytes->at_most(bytes->body.natural(1), 1, "there is no reading") == 1;
  const std::string format = solid.format + (by_faces ? "-faces" : "");
  surface_.reset(new PatchSurface(read_spline_model(solid.bytes, format), solid.bytes.size()));
  surface_->read_counts(bytes);
  surface_->read_breaks(body_size, bytes);
  surface_->glue();
  box_ = box_of(*surface_);
}

bool SolidPoints::box_holds(const AnsweredPoint& q) const {
  for (int k = 0; k < 3; ++k) {
    const Coordinate& c = q.coordinates()[k];
    if (mesh_ != nullptr ? c.below < mesh_->box().min[k] || mesh_->box().max[k] < c.above
                         : q.compare_with(k, box_.lo[k]) < 0 || q.compare_with(k, box_.hi[k]) > 0)
      return false;
  }
  return true;
}

PlaceOnPatch SolidPoints::read_on(const AnsweredPoint& q, Bytes* bytes, SolidWork* work) const {
  if (surface_ != nullptr) {
    const PlaceOnPatch place = surface_->read_place(bytes);
    work->patches.begin_point();
    surface_->check_on(q.exact(), place, q.where, &work->patches);
    return place;
  }
  const uint64_t face = bytes->body.varint();
  require(face < model_->faces(), "B1", "there is no triangle", face);
  work->triangles.add(1);
  if (!mesh_->is_on(Point(q.coordinates(), mesh_->lattice()), uint32_t(face)))
    throw Rejected{"P2", "the triangle of its code does not contain the point" + q.where};
  return PlaceOnPatch();
}

void SolidPoints::check_off(const AnsweredPoint& q, int direction, int64_t f,
                            SolidWork* work) const {
  int64_t found = 0;
  if (surface_ != nullptr) {
    work->patches.begin_point();
    found = surface_->winding(q.exact(), direction, q.where, &work->patches);
  } else {
    const Point point(q.coordinates(), mesh_->lattice());
    const MeshPoints::Winding w = mesh_->winding(point, direction, false, &work->triangles);
    if (w.is_on) throw Rejected{"P3", "a triangle contains the point" + q.where};
    found = w.sum;
  }
  if (found != f)
    throw Rejected{"P4", "the winding number of a solid is " + std::to_string(found) + q.where};
}

// The corners of a triangle minus the point, times a positive number.
std::vector<BigVec> SolidPoints::corners(const AnsweredPoint& q, uint32_t face) const {
  std::vector<BigVec> r(3);
  const int64_t twos = 1075 - mesh_->lattice().low;
  const Big scale = twos < 0 ? shifted(q.exact().d, -twos) : q.exact().d;
  for (size_t i = 0; i < 3; ++i)
    for (size_t k = 0; k < 3; ++k) {
      const int64_t key = model_->key[3 * size_t(model_->tri[3 * size_t(face) + i]) + k];
      Big x;
      if (key != 0) x.m.push_back(key_mantissa(key));
      x.neg = key < 0;
      x = shifted(x, key_exponent(key) - mesh_->lattice().low);
      r[i].x[k] = scale * x - (twos > 0 ? shifted(q.exact().n[k], twos) : q.exact().n[k]);
    }
  return r;
}

bool SolidPoints::find_cone(const AnsweredPoint& q, const PlaceOnPatch& place, SolidWork* work,
                            Cone* cone) const {
  if (surface_ != nullptr) {
    work->patches.begin_point();
    return find_patch_cone(*surface_, q.exact(), place, &work->patches, cone);
  }
  std::vector<uint32_t> faces =
      mesh_->triangles_at(Point(q.coordinates(), mesh_->lattice()), &work->triangles);
  std::sort(faces.begin(), faces.end());
  for (uint32_t f : faces) add_polygon(corners(q, f), cone);
  return true;
}
