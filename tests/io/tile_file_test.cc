// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/tile_file.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "solids/micro/tile_surface.h"

namespace veritope {
namespace {

MeshFile box_mesh(bool has_polygons) {
  MeshFile out;
  for (int i = 0; i < 8; ++i)
    out.mesh.positions.push_back(
        {(i & 1) * 0.5 + 0.25, (i >> 1 & 1) * 0.5 + 0.25, (i >> 2 & 1) * 0.5 + 0.25});
  const std::array<std::array<std::uint32_t, 4>, 6> faces{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (std::uint32_t f = 0; f < 6; ++f) {
    const auto [a, b, c, d] = faces[f];
    out.mesh.faces.push_back({a, b, c});
    out.mesh.faces.push_back({a, c, d});
    if (has_polygons) out.polygon_of_face.insert(out.polygon_of_face.end(), {f, f});
  }
  return out;
}
MicroTile tile(const MeshFile& file, TileFacets facets = TileFacets::kFewest) {
  return tile_of(ModelFile(file), "a tile", facets).value();
}
bool is_closed(const MicroTile& t) {
  const auto found = surface_of(t);
  return std::holds_alternative<TileSurface>(found) && std::get<TileSurface>(found).euler() == 2;
}

TEST(TileFile, TwoTrianglesInOnePlaneAreOnePatch) {
  for (const bool has_polygons : {false, true}) {
    const MicroTile t = tile(box_mesh(has_polygons));
    EXPECT_EQ(t.name, "a tile");
    EXPECT_EQ(t.patches.size(), 6u);
    EXPECT_TRUE(is_closed(t));
  }
}
TEST(TileFile, ThePatchOfASquareDoesNotDependOnItsDiagonal) {
  MeshFile turned = box_mesh(false);
  turned.mesh.faces[0] = {0, 2, 1}, turned.mesh.faces[1] = {2, 3, 1};
  const auto corners = [](const TilePatch& p) {
    std::vector<TilePoint> out = p.points[0];
    std::sort(out.begin(), out.end());
    return out;
  };
  std::vector<std::vector<TilePoint>> a, b;
  for (const TilePatch& p : tile(box_mesh(false)).patches) a.push_back(corners(p));
  for (const TilePatch& p : tile(turned).patches) b.push_back(corners(p));
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  EXPECT_EQ(a, b);
}
TEST(TileFile, OtherTrianglesHaveACollapsedSideOrAreCutIntoQuadrilaterals) {
  MeshFile file = box_mesh(false);
  file.mesh.positions[7].x += 0.125;  // bends the face x = 3/4 alone
  const MicroTile few = tile(file);
  EXPECT_EQ(few.patches.size(), 5u + 2u);
  EXPECT_TRUE(is_closed(few));
  const MicroTile more = tile(file, TileFacets::kQuadrilaterals);
  EXPECT_EQ(more.patches.size(), 5u * 4 + 2u * 3);
  EXPECT_TRUE(is_closed(more));
  for (const TilePatch& p : more.patches)
    for (std::size_t s = 0; s < kTileSides; ++s) EXPECT_FALSE(side_key(p, s, false).empty());
  // Without triangles there is nothing to be cut.
  EXPECT_EQ(tile(box_mesh(false), TileFacets::kQuadrilaterals).patches.size(), 6u);
}
TEST(TileFile, QuadrilateralsAreStrictlyConvex) {
  // A triangle of the lower face is cut at the middle of its longest side: no two parts have four proper corners.
  MeshFile file = box_mesh(false);
  file.mesh.positions.push_back({0.5, 0.25, 0.25});  // on the edge 0 1
  file.mesh.faces[0] = {0, 2, 8}, file.mesh.faces[1] = {8, 2, 3};
  file.mesh.faces.push_back({8, 3, 1});
  file.mesh.faces[4] = {0, 8, 4}, file.mesh.faces[5] = {8, 5, 4};
  file.mesh.faces.push_back({8, 1, 5});
  const MicroTile t = tile(file);
  EXPECT_TRUE(is_closed(t));
  EXPECT_EQ(t.patches.size(), 4u + 2 * 2);
}

SplineEntity bilinear(std::array<TilePoint, 4> p, bool is_rational = false) {
  KnotAxis<Rational> axis;
  axis.degree = 1;
  axis.knots = {Rational(0), Rational(0), Rational(1), Rational(1)};
  std::vector<Rational> all;
  for (std::size_t c = 0; c < 3; ++c)
    for (const TilePoint& q : p) all.push_back(q[c]);
  if (is_rational) all.insert(all.end(), 4, Rational(1));
  return {ExactSurface({axis, axis}, is_rational ? 4 : 3, is_rational, std::move(all)),
          {},
          std::nullopt,
          {}};
}
TilePoint eighths(int x, int y, int z) {
  return {Rational(x) / Rational(8), Rational(y) / Rational(8), Rational(z) / Rational(8)};
}

TEST(TileFile, EqualPatchesThatFaceEachOtherAreLeftOut) {
  const std::array<TilePoint, 4> wall = {eighths(1, 1, 1), eighths(1, 1, 3), eighths(1, 3, 1),
                                         eighths(1, 3, 3)},
                                 back = {wall[3], wall[1], wall[2], wall[0]},
                                 other = {eighths(2, 1, 1), eighths(2, 1, 3), eighths(2, 3, 1),
                                          eighths(2, 3, 3)};
  SplineFile file;
  file.model.entities = {bilinear(wall), bilinear(back), bilinear(other)};
  EXPECT_EQ(tile_of(ModelFile(file), "", TileFacets::kFewest)->patches.size(), 1u);
  // Two that face one way stay: analyse_tile refuses them.
  file.model.entities[1] = bilinear(wall);
  EXPECT_EQ(tile_of(ModelFile(file), "", TileFacets::kFewest)->patches.size(), 3u);
}

TEST(TileFile, SolidsThatShareATriangleAreOne) {
  for (std::size_t turn = 0; turn < 3; ++turn) {
    MeshFile file;  // two tetrahedra on the triangle 0 1 2, which occurs twice
    file.mesh.positions = {{0.25, 0.25, 0.5},
                           {0.75, 0.25, 0.5},
                           {0.25, 0.75, 0.5},
                           {0.25, 0.25, 0.9},
                           {0.375, 0.375, 0.1}};
    file.mesh.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3},
                       {0, 1, 2}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}};
    auto& face = file.mesh.faces[4];
    std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(turn), face.end());
    const MicroTile t = tile(file);
    EXPECT_EQ(t.patches.size(), 6u);
    EXPECT_TRUE(is_closed(t));
  }
}
// So that the caps of opposite walls are equal.
TEST(TileFile, TrianglesAreEqualWhateverCornerComesFirst) {
  std::vector<std::vector<TilePatch>> all;
  for (std::size_t turn = 0; turn < 3; ++turn) {
    MeshFile file;
    file.mesh.positions = {{0, 0.25, 0.25}, {0, 0.75, 0.25}, {0, 0.25, 0.75}};
    file.mesh.faces = {{0, 2, 1}};
    auto& face = file.mesh.faces[0];
    std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(turn), face.end());
    all.push_back(tile(file).patches);
    EXPECT_EQ(all.back(), all.front());
  }
}

TEST(TileFile, RefusesWhatIsNoTile) {
  const auto error = [](const ModelFile& file) {
    return tile_of(file, "t", TileFacets::kFewest).error();
  };
  EXPECT_EQ(error(ModelFile(MicroFile())).code, Code::kBadArgument);
  EXPECT_EQ(error(ModelFile(SplineFile())).code, Code::kEmpty);
  SplineFile file;
  file.model.entities = {bilinear({}, true)};
  EXPECT_NE(error(file).message.find("is rational"), std::string::npos);
  file.model.entities = {bilinear({})};
  file.left_out.push_back({"trimmed cylinder", "", true, 1});
  EXPECT_NE(error(file).message.find("trimmed cylinder"), std::string::npos);
  MeshFile large;
  large.mesh.positions.resize(3);
  large.mesh.faces.assign(2 * kMaxTilePatches + 1, {0, 1, 2});
  EXPECT_EQ(error(large).code, Code::kOverLimit);
  MeshFile fine;  // more bits than the format has
  fine.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0x1p-200, 0}};
  fine.mesh.faces = {{0, 1, 2}};
  EXPECT_EQ(error(fine).code, Code::kOverLimit);
}

}  // namespace
}  // namespace veritope
