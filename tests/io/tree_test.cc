// SPDX-License-Identifier: LGPL-3.0-or-later
// Trees of volumes: what is read, what is built, and what is refused with a pointer.
#include <gtest/gtest.h>

#include <string>

#include "io/splines/spline_model.h"
#include "io/trees/build_tree.h"
#include "io/trees/tree_reader.h"
#include "robust/base/stopwatch.h"
#include "solids/volumes/placed.h"
#include "solids/volumes/primitives.h"
#include "splines/bspline_domain.h"

namespace veritope {
namespace {

const std::string kName = "t.json";
const std::string kSquare =
    R"({"degrees":[1,1],"periodic":[false,false],"knots":[["0","0","1","1"],["0","0","1","1"]],
"rational":false,"components":3,"points":[["0","0","0"],["0","1","0"],["1","0","0"],["1","1","0"]]})";

Rational q(int p, int r = 1) { return Rational(Integer(p), Integer(r)); }

std::string tree(const std::string& root) {
  return R"({"format":"veritope-tree-1","root":)" + root + "}";
}

Result<TreeFile> read(const std::string& text, const ReadLimits& limits = {}) {
  const ByteBuffer buffer =
      copy_to_buffer({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
  return read_tree(source_of(buffer, kName), limits);
}

// A file "box" of one volume, "square" of a surface.
Result<SplineModel> load(const std::string& path) {
  SplineModel model;
  const Cells box = box_cells({q(0), q(0), q(0)}, {q(1), q(1), q(1)}).value();
  if (path == "box") model.entities.push_back({box[0], {}, {}, {}});
  if (path == "both") {
    model.entities.push_back({box[0], {}, {}, {}});
    model.entities.push_back({side_of(box[0], 2, 1), {}, {}, {}});
  }
  if (model.entities.empty()) return Error{Code::kCannotOpen, {}, "no such file"};
  return model;
}

Result<BuiltTree> build(const std::string& root) {
  const Result<TreeFile> file = read(tree(root));
  if (!file) return file.error();
  return build_tree(*file, kName, load);
}

Cells cells_of(const std::string& root) {
  Result<BuiltTree> built = build(root);
  EXPECT_TRUE(built) << to_string(built.error());
  return built ? built->cells : Cells();
}

std::string refusal(const Result<BuiltTree>& built) {
  return built ? "built" : built.error().message;
}

TEST(Trees, PrimitivesAreThoseOfTheLibrary) {
  EXPECT_EQ(cells_of(R"({"op":"box","min":[0,"1/2",-3],"max":[1,"0.75","1e1"]})"),
            box_cells({q(0), q(1, 2), q(-3)}, {q(1), q(3, 4), q(10)}).value());
  EXPECT_EQ(cells_of(R"({"radius":2,"height":5,"op":"cylinder"})"),
            cylinder_cells(q(2), q(5)).value());
  EXPECT_EQ(cells_of(R"({"op":"cylinder","radius":2,"height":5,"cells":"one"})"),
            one_cell_cylinder(q(2), q(5)).value());
  EXPECT_EQ(cells_of(R"({"op":"cone","bottom":2,"top":0,"height":5})"),
            cone_cells(q(2), q(0), q(5)).value());
  EXPECT_EQ(cells_of(R"({"op":"torus","major":2,"minor":1})"), torus_cells(q(2), q(1)).value());
  EXPECT_EQ(cells_of(R"({"op":"sphere","radius":"0x1p-1"})"), sphere_cells(q(1, 2)).value());
  EXPECT_EQ(cells_of(R"({"op":"sphere","radius":1,"cells":"one"})"), one_cell_sphere(q(1)).value());
}

TEST(Trees, NodesInNodesAreBuiltInTheirOrder) {
  const Cells glued = cells_of(
      R"({"of":[{"op":"place","translate":[1,0,0],"of":{"op":"file","path":"box"}},
                {"op":"file","path":"both","entity":0},{"op":"sphere","radius":3}],"op":"glue"})");
  ASSERT_EQ(glued.size(), 9u);
  const CellVolume box = box_cells({q(0), q(0), q(0)}, {q(1), q(1), q(1)}).value()[0];
  EXPECT_EQ(glued[0], placed(box, translation({q(1), q(0), q(0)})));
  EXPECT_EQ(glued[1], box);
  EXPECT_EQ(glued[2], sphere_cells(q(3)).value()[0]);
  const Cells parts =
      cells_of(R"({"op":"split","axis":"v","at":"1/4","of":{"op":"file","path":"box"}})");
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[1].axis(1).domain_begin(), q(1, 4));
  EXPECT_EQ(
      cells_of(R"({"op":"split","axis":"v","at":"1/2","of":{"op":"split","axis":"v","at":"1/4",
                         "of":{"op":"file","path":"box"}}})")
          .size(),
      3u);
}

TEST(Trees, PlaceScalesThenTurnsThenMoves) {
  const Result<BuiltTree> built = build(
      R"({"op":"place","of":{"op":"file","path":"box"},"translate":[10,0,0],"scale":[2,3,4],
          "rotate":{"axis":[0,0,2],"point":[0,0,0],"degrees":90}})");
  ASSERT_TRUE(built);
  Placement want = translation({q(10), q(0), q(0)});
  want.linear = {CellPoint{q(0), q(-3), q(0)}, CellPoint{q(2), q(0), q(0)},
                 CellPoint{q(0), q(0), q(4)}};
  const CellVolume box = box_cells({q(0), q(0), q(0)}, {q(1), q(1), q(1)}).value()[0];
  EXPECT_EQ(built->cells[0], placed(box, want));
  ASSERT_EQ(built->notes.size(), 1u);
  EXPECT_EQ(built->notes[0].pointer, "/root");
  EXPECT_EQ(*built->notes[0].error, q(0));
  const Result<BuiltTree> matrix = build(
      R"({"op":"place","of":{"op":"file","path":"box"},"matrix":[[0,-3,0,10],[2,0,0,0],[0,0,4,0]]})");
  ASSERT_TRUE(matrix);
  EXPECT_EQ(matrix->cells[0], built->cells[0]);
  EXPECT_EQ(*matrix->notes[0].determinant, q(24));
  EXPECT_EQ(*matrix->notes[0].distance_from_rotation, q(15));
}

TEST(Trees, ConstructorsTakeSurfacesAndFiles) {
  const CellVolume box = box_cells({q(0), q(0), q(0)}, {q(1), q(1), q(1)}).value()[0];
  EXPECT_EQ(cells_of(R"({"op":"extrude","surface":)" + kSquare + R"(,"vector":[0,0,1]})"),
            Cells{box});
  EXPECT_EQ(cells_of(R"({"op":"ruled","surfaces":[)" + kSquare +
                     R"(,{"op":"file","path":"both","entity":1}]})"),
            Cells{box});
  EXPECT_EQ(
      cells_of(R"({"op":"sweep","degree":1,"mode":"interpolate","parameters":[0,1],"sections":[)" +
               kSquare + R"(,{"path":"both","entity":1,"op":"file"}]})"),
      Cells{box});
  const Cells turned = cells_of(R"({"op":"revolve","surface":)" + kSquare +
                                R"(,"point":[-1,0,0],"axis":[0,1,0],"degrees":"45.5"})");
  ASSERT_EQ(turned.size(), 1u);
  EXPECT_EQ(turned[0].grid().size[2], 3u);
  SplineModel model = model_of_cells(turned);
  EXPECT_EQ(std::get<ExactVolume>(model.entities[0].shape), turned[0]);
}

TEST(Trees, RefuseWithThePointerOfTheParameter) {
  const std::string box = R"({"op":"file","path":"box"})";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {R"({"op":"glue","of":[)" + box + "," + box + R"(,{"op":"sphere","radius":-1}]})",
       "/root/of/2/radius: radius must be positive, not -1"},
      {R"({"op":"torus","major":1,"minor":2})",
       "/root/minor: minor must be less than major, and they are 2 and 1"},
      {R"({"op":"sphere"})", "/root: the key 'radius' of op 'sphere' is missing"},
      {R"({"op":"sphere","radius":1,"colour":2})", "/root: unknown key 'colour' of op 'sphere'"},
      {R"({"op":"sphere","radius":1,"radius":2})", "/root: the key 'radius' occurs twice"},
      {R"({"op":"sphere","radius":0.5})",
       "/root/radius: a JSON integer, or a number in quotes, expected, but there is '0.5'"},
      {R"({"op":"sphere","radius":01})",
       "/root/radius: a JSON integer, or a number in quotes, expected, but there is '01'"},
      {R"({"op":"sphere","radius":1,"cells":"two"})",
       "/root/cells: cells must be 'one', if anything, not 'two'"},
      {R"({"op":"ball","radius":1})", "/root/op: unknown op 'ball'"},
      {R"({"op":"union","of":[]})",
       "/root/op: Boolean operations of volumes are not built yet: 'union'"},
      {R"({"radius":1})", "/root: the key 'op' is missing, or no string"},
      {R"([1])", "/root: a node, an object with the key 'op', expected, but there is '['"},
      {R"({"op":"glue","of":[]})", "/root/of: at least one node expected"},
      {R"({"op":"box","min":[0,0],"max":[1,1,1]})",
       "/root/min: 3 numbers expected, but there are 2"},
      {R"({"op":"file","path":"none"})", "/root/path: path: no such file"},
      {R"({"op":"file","path":"both"})",
       "/root/entity: entity 1 of the file is a surface, no volume"},
      {R"({"op":"file","path":"box","entity":7})",
       "/root/entity: entity must be less than 1, the number of entities of the file, not 7"},
      {R"({"op":"extrude","vector":[0,0,0],"surface":)" + kSquare + "}",
       "/root/vector: vector must not be 0"},
      {R"({"op":"extrude","vector":[0,0,1],"surface":)" + box + "}",
       "/root/surface/entity: entity 0 of the file is a volume, no surface"},
      {R"({"op":"ruled","surfaces":[)" + kSquare + "]}",
       "/root/surfaces: surfaces of a ruled volume must be two, not 1"},
      {R"({"op":"revolve","point":[0,0,0],"axis":[0,0,0],"surface":)" + kSquare + "}",
       "/root/axis: axis must not be 0"},
      {R"({"op":"revolve","point":[0,0,0],"axis":[0,1,0],"degrees":0,"surface":)" + kSquare + "}",
       "/root/degrees: degrees must be more than 0 and at most 360, not 0"},
      {R"({"op":"revolve","point":["1/2",0,0],"axis":[0,1,0],"surface":)" + kSquare + "}",
       "/root/surface: surface crosses the axis of revolution: it is on one side at (u, v) = (0, "
       "0) and on the "
       "other at (u, v) = (5/8, 0)"},
      {R"({"op":"sweep","degree":1,"mode":"fit","parameters":[0,1],"sections":[)" + kSquare + "," +
           kSquare + "]}",
       "/root/mode: mode must be 'interpolate' or 'approximate', not 'fit'"},
      {R"({"op":"tube","surface":)" + kSquare + "}",
       "/root/surface: surface is closed along neither of its axes"},
      {R"({"op":"place","of":)" + box + "}",
       "/root: matrix, scale, rotate or translate is required"},
      {R"({"op":"place","of":)" + box + R"(,"scale":0})", "/root/scale: scale must not be 0"},
      {R"({"op":"place","of":)" + box +
           R"(,"rotate":{"axis":[0,0,0],"point":[0,0,0],"degrees":1}})",
       "/root/rotate/axis: rotate/axis must not be 0"},
      {R"({"op":"place","of":)" + box + R"(,"matrix":[[1,0,0,0],[0,1,0,0],[1,1,0,0]]})",
       "/root/matrix: matrix is singular: its image is flat"},
      {R"({"op":"place","of":)" + box + R"(,"matrix":[[1,0,0,0],[0,1,0,0]]})",
       "/root/matrix: three rows of four numbers expected, but there are 2 rows"},
      {R"({"op":"split","axis":"x","at":0,"of":)" + box + "}",
       "/root/axis: axis must be 'u', 'v' or 'w', not 'x'"},
      {R"({"op":"split","axis":"u","at":1,"of":)" + box + "}",
       "/root/at: at must lie inside of the domain, from 0 to 1, and it is 1"},
      {R"({"op":"boolean-sum","faces":[)" + kSquare + "]}",
       "/root/faces: six surfaces expected, but there are 1"},
      {R"({"op":"boolean-sum","arrange":true,"faces":[)" + kSquare + "," + kSquare + "," + kSquare +
           "," + kSquare + "," + kSquare + "," + kSquare + "]}",
       "/root/faces: faces are not those of a cuboid: their sides do not agree in pairs"},
      {R"({"op":"trivariate","shape":)" + kSquare + "}",
       "/root/shape: degrees, periodic and knots must have 3 entries"},
  };
  for (const auto& [root, want] : cases) {
    EXPECT_EQ(refusal(build(root)), want) << root;
  }
}

TEST(Trees, RefuseWhatIsNoTree) {
  const auto refused = [](const std::string& text) {
    const auto file = read(text);
    return file ? std::string("read")
                : std::string(code_name(file.error().code)) + ": " + file.error().message;
  };
  EXPECT_EQ(refused(""), "truncated: '{' expected, but there is the end of the file");
  EXPECT_EQ(refused("{}"), "syntax: the key 'format' is missing");
  EXPECT_EQ(refused(R"({"format":"veritope-tree-2","root":{}})"),
            "unknown-format: /format: the format must be 'veritope-tree-1', not 'veritope-tree-2'");
  EXPECT_EQ(refused(tree(R"({"op":"sphere","radius":1})") + "x"),
            "syntax: the end of the file expected, but there is 'x'");
  EXPECT_EQ(refused(R"({"format":"veritope-tree-1","root":{"op":"sphere","radius":"1)"),
            "truncated: a string does not end");
  ReadLimits limits;
  limits.max_digits = 3;
  const auto file = read(tree(R"({"op":"sphere","radius":"1.2345"})"), limits);
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, Code::kOverLimit);
  EXPECT_EQ(file.error().place.line, 1u);
}

TEST(Trees, HaveADepthAndNoOther) {
  const auto nested = [](int depth, const std::string& open, const std::string& close) {
    std::string text;
    for (int i = 1; i < depth; ++i) text += open;
    text += R"({"op":"file","path":"box"})";
    for (int i = 1; i < depth; ++i) text += close;
    return text;
  };
  EXPECT_TRUE(build(nested(100, R"({"op":"glue","of":[)", "]}")));
  EXPECT_TRUE(build(nested(100, R"({"of":[)", R"(],"op":"glue"})")));
  const std::string message = refusal(build(nested(101, R"({"op":"glue","of":[)", "]}")));
  EXPECT_TRUE(message.ends_with(": nodes are nested more than 100 deep")) << message;
  // Brackets alone do not end the program, and no work is done twice for each level.
  EXPECT_FALSE(read(tree(std::string(1000000, '['))));
  EXPECT_FALSE(read(tree(nested(20000, R"({"of":[)", R"(],"op":"glue"})"))));
}

// 400 spheres, each with numbers of a thousand digits, take more
// than 64 MiB.
TEST(Trees, StopWhenTheirNumbersTakeTooMuchMemory) {
  const std::string factor = "\"1" + std::string(998, '0') + "1\"";
  const auto spheres = [&](int count) {
    std::string of;
    for (int i = 0; i < count; ++i)
      of += std::string(i == 0 ? "" : ",") + R"({"op":"place","scale":)" + factor +
            R"(,"of":{"op":"sphere","radius":1}})";
    return build(R"({"op":"glue","of":[)" + of + "]}");
  };
  EXPECT_TRUE(spheres(10));
  const Result<BuiltTree> many = spheres(400);
  ASSERT_FALSE(many);
  EXPECT_EQ(many.error().code, Code::kOverLimit);
  EXPECT_TRUE(many.error().message.starts_with("/root: the file's numbers take more than"))
      << many.error().message;
}

}  // namespace
}  // namespace veritope
