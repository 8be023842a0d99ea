// SPDX-License-Identifier: LGPL-3.0-or-later
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Solid.hxx>

#include "bench/occt_bezier.h"
#include "bench/patch_tile_peers.h"

namespace veritope::bench {
namespace {

constexpr double kTileTolerance = 1e-7;  // Open CASCADE's own

}  // namespace

struct OcctTiles::Tile::Faces {
  TopoDS_Compound shape;
  gp_Pnt corner;
};

OcctTiles::Tile::Tile(std::span<const BezierSurface<Rational>> patches) : faces_(new Faces) {
  TopoDS_Builder builder;
  builder.MakeCompound(faces_->shape);
  for (const BezierSurface<Rational>& map : patches) {
    const Handle(Geom_BezierSurface) surface = occt_bezier(make_patch(map).value());
    faces_->corner = surface->Pole(1, 1);
    builder.Add(faces_->shape, BRepBuilderAPI_MakeFace(surface, kTileTolerance).Face());
  }
}
OcctTiles::Tile::~Tile() = default;

struct OcctTiles::Impl {
  TopoDS_Shape shell;
  BRepClass3d_SolidClassifier classifier;
};

OcctTiles::OcctTiles(std::span<const Patch> patches) : impl_(new Impl) {
  BRepBuilderAPI_Sewing sewing(1e-6);
  for (const Patch& p : patches)
    sewing.Add(BRepBuilderAPI_MakeFace(occt_bezier(p), kTileTolerance).Face());
  sewing.Perform();
  impl_->shell = sewing.SewedShape();
  BRepBuilderAPI_MakeSolid solid;
  for (TopExp_Explorer e(impl_->shell, TopAbs_SHELL); e.More(); e.Next())
    solid.Add(TopoDS::Shell(e.Current()));
  if (solid.IsDone()) impl_->classifier.Load(solid.Solid());
}
OcctTiles::~OcctTiles() = default;

bool OcctTiles::is_inside(const Tile& tile) const {
  const BRepExtrema_DistShapeShape distance(tile.faces_->shape, impl_->shell);
  if (!distance.IsDone() || distance.Value() <= kTileTolerance) return false;
  impl_->classifier.Perform(tile.faces_->corner, kTileTolerance);
  return impl_->classifier.State() == TopAbs_IN;
}

}  // namespace veritope::bench
