// SPDX-License-Identifier: LGPL-3.0-or-later
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Pnt.hxx>

#include "bench/occt_bezier.h"
#include "bench/patch_side_peers.h"

namespace veritope::bench {
namespace {

constexpr double kTolerance = 1e-7;  // Open CASCADE's own

}  // namespace

struct OcctSides::Impl {
  TopoDS_Solid solid;
  bool is_closed = false;
  BRepClass3d_SolidClassifier classifier;
};

OcctSides::OcctSides(std::span<const Patch> patches) : impl_(new Impl) {
  BRepBuilderAPI_Sewing sewing(1e-6);
  for (const Patch& p : patches)
    sewing.Add(BRepBuilderAPI_MakeFace(occt_bezier(p), kTolerance).Face());
  sewing.Perform();
  BRepBuilderAPI_MakeSolid solid;
  for (TopExp_Explorer e(sewing.SewedShape(), TopAbs_SHELL); e.More(); e.Next()) {
    solid.Add(TopoDS::Shell(e.Current()));
    impl_->is_closed = e.Current().Closed();
  }
  if (!solid.IsDone()) return;
  impl_->solid = solid.Solid();
  impl_->classifier.Load(impl_->solid);
}
OcctSides::~OcctSides() = default;

bool OcctSides::is_closed() const { return impl_->is_closed; }

Side OcctSides::operator()(const Vec3d& p) const {
  impl_->classifier.Perform(gp_Pnt(p.x, p.y, p.z), kTolerance);
  switch (impl_->classifier.State()) {
    case TopAbs_IN: return Side::kIn;
    case TopAbs_ON: return Side::kOn;
    default: return Side::kOut;
  }
}

}  // namespace veritope::bench
