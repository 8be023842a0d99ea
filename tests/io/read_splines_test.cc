// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/read_model.h"

#include "io/formats.h"
#include "tests/io/spline_test_util.h"

namespace veritope {
namespace {

using io_test::exact_value;
using io_test::model_of;
using io_test::outcome;
using io_test::read_splines;
using io_test::sample;

const Rational kHalf(Integer(1), Integer(2));

template <typename Spline>
const Spline& shape(const SplineFile& file, std::size_t i) {
  return std::get<Spline>(file.model.entities[i].shape);
}

std::uint64_t left_out(const SplineFile& file, std::string_view what) {
  for (const LeftOut& l : file.left_out)
    if (l.what == what) return l.count;
  return 0;
}

TEST(ReadSplines, ItdGroupsNamesAndAttributesAreATree) {
  const SplineFile file = sample("groups.itd");
  ASSERT_EQ(file.model.groups.size(), 3u);  // the group of the camera holds no spline
  EXPECT_EQ(file.model.groups[0].name, "SCENE");
  EXPECT_EQ(file.model.groups[0].attributes,
            (std::vector<std::string>{"color 5", "rgb \"255,0,0\""}));
  EXPECT_EQ(file.model.groups[1].parent, 0u);
  EXPECT_EQ(file.model.groups[2].name, "CLOSED");
  ASSERT_EQ(file.model.entities.size(), 5u);
  EXPECT_EQ(file.model.entities[1].attributes, (std::vector<std::string>{"texture \"a [b] c\""}));
  EXPECT_EQ(file.model.entities[4].group, std::nullopt);
  EXPECT_EQ(left_out(file, "polygons"), 1u);
  EXPECT_EQ(left_out(file, "matrices"), 1u);
  EXPECT_EQ(left_out(file, "groups without splines"), 1u);
  EXPECT_EQ(file.model.entities[0].place.line, 4u);
}

TEST(ReadSplines, ItdSplinesHaveTheValuesOfTheirFormulas) {
  const SplineFile file = sample("groups.itd");
  // Weights 1, 3/4, 1 in front, multiplied in: (1/4 1 + 1/2 3/4 + 1/4 1/2) / (1/4 + 3/8 + 1/4).
  EXPECT_EQ(exact_value<1>(shape<ExactCurve>(file, 0), {kHalf}), "6/7 3/7");
  // The first index runs fastest: u from (0,0) to (1,0), v to (0,2).
  EXPECT_EQ(exact_value<2>(shape<ExactSurface>(file, 1), {Rational(1), Rational(0)}), "1 0 1/4");
  EXPECT_EQ(exact_value<2>(shape<ExactSurface>(file, 1), {Rational(0), Rational(1)}), "0 2 0");
  // 1 - 2 t + 3 t^2.
  EXPECT_EQ(exact_value<1>(shape<ExactCurve>(file, 3), {kHalf}), "3/4");
  EXPECT_EQ(exact_value<1>(shape<ExactCurve>(file, 3), {Rational(Integer(1), Integer(3))}), "2/3");
  EXPECT_EQ(exact_value<3>(shape<ExactVolume>(file, 4), {Rational(1), Rational(1), Rational(1)}),
            "1 1 2");
  EXPECT_EQ(exact_value<3>(shape<ExactVolume>(file, 4), {Rational(0), Rational(0), Rational(1)}),
            "0 0 1");
}

TEST(ReadSplines, APeriodicAxisRepeatsItsPointsAndCloses) {
  const SplineFile file = sample("groups.itd");
  const auto& s = shape<ExactCurve>(file, 2);
  EXPECT_TRUE(s.axis(0).is_periodic);
  EXPECT_EQ(s.axis(0).num_control(), 6u);
  EXPECT_EQ(s.component(0)[4], s.component(0)[0]);
  EXPECT_EQ(exact_value<1>(s, {Rational(0)}), exact_value<1>(s, {Rational(1)}));
  EXPECT_EQ(exact_value<1>(s, {Rational(0)}), "1/2 0");
  // Knots that do not repeat make it an unclamped axis, the same points.
  const SplineModel other = model_of(
      SplineFormat::kItd, "[CURVE BSPLINE 4 3 E1 [KVP 0 1 2 3 4 5 6 7 9] [0] [1] [2] [3]]");
  const auto& unclamped = std::get<ExactCurve>(other.entities[0].shape);
  EXPECT_FALSE(unclamped.axis(0).is_periodic);
  EXPECT_EQ(unclamped.component(0)[5], Rational(1));
}

TEST(ReadSplines, TrimmingLoopsAndModelsAreKept) {
  const SplineFile file = sample("trimmed.itd");
  const auto& trimmed = shape<TrimmedSurface>(file, 0);
  ASSERT_EQ(trimmed.loops.size(), 1u);
  EXPECT_EQ(exact_value<1>(*trimmed.loops[0][0].parameter, {Rational(Integer(1), Integer(3))}),
            "3/4 1/4");
  const auto& brep = shape<SplineBrep>(file, 1);
  EXPECT_EQ(brep.faces[0].loops, (std::vector<std::vector<std::int64_t>>{{1, -2}}));
  EXPECT_EQ(brep.segments[1].faces, (std::array<std::uint64_t, 2>{1, 0}));
  EXPECT_TRUE(brep.segments[1].space && !brep.segments[1].parameter[1]);
  EXPECT_EQ(count_splines(file.model), (std::array<std::uint64_t, 3>{4, 2, 0}));
}

TEST(ReadSplines, G2ObjectsAreExactWhereNoRootIsNeeded) {
  const SplineFile file = sample("objects.g2");
  ASSERT_EQ(file.model.entities.size(), 6u);
  EXPECT_EQ(file.model.entities[0].attributes, (std::vector<std::string>{"g2-extra 255 0 0 255"}));
  EXPECT_EQ(exact_value<1>(shape<ExactCurve>(file, 0), {kHalf}), "5/7 5/7");
  EXPECT_EQ(exact_value<1>(shape<ExactCurve>(file, 1), {Rational(1)}), "3 2 1");
  // The plane's axes are normalised: (3,4)/5 and (-4,3)/5.
  EXPECT_EQ(exact_value<2>(shape<ExactSurface>(file, 2), {Rational(1), Rational(0)}), "3/5 4/5 1");
  EXPECT_EQ(exact_value<2>(shape<ExactSurface>(file, 2), {kHalf, Rational(1)}), "-4 3 1");
  EXPECT_EQ(exact_value<2>(shape<ExactSurface>(file, 3), {Rational(1), Rational(1)}), "1 1 0");
  EXPECT_EQ(left_out(file, "cylinders"), 1u);
  const auto& trimmed = shape<TrimmedSurface>(file, 4);
  EXPECT_FALSE(trimmed.loops[0][0].space);
  EXPECT_NE(trimmed.loops[0][0].omitted.find("space circle"), std::string::npos);
  // Reversed: it starts at its end.
  EXPECT_EQ(exact_value<1>(*trimmed.loops[0][1].parameter, {Rational(0)}), "1 1");
  EXPECT_EQ(exact_value<3>(shape<ExactVolume>(file, 5), {Rational(1), Rational(0), Rational(0)}),
            "1");
}

TEST(ReadSplines, APlaneWithIrrationalAxesIsLeftOutWithItsReason) {
  const auto file =
      read_splines(SplineFormat::kG2, "250 1 0 0\n3\n0 0 0\n0 0 1\n1 1 0\n1\n0 1 0 1\n0\n");
  ASSERT_TRUE(file);
  EXPECT_TRUE(file->model.entities.empty());
  ASSERT_EQ(file->left_out.size(), 1u);
  EXPECT_TRUE(file->left_out[0].is_geometry);
  EXPECT_NE(file->left_out[0].reason.find("irrational"), std::string::npos);
}

TEST(ReadSplines, GismoWeightsAreMultipliedInAndCommentsHoldNothing) {
  const SplineFile file = sample("surface.xml");
  ASSERT_EQ(file.model.entities.size(), 2u);
  EXPECT_EQ(file.model.groups[0].name, "quarter");
  EXPECT_EQ(exact_value<2>(shape<ExactSurface>(file, 0), {kHalf, Rational(0)}), "2/3 2/3 0");
  EXPECT_EQ(exact_value<1>(shape<ExactCurve>(file, 1), {Rational(Integer(1), Integer(4))}),
            "1/2 1/2");
  EXPECT_EQ(left_out(file, "geometries of type THBSpline2"), 1u);
}

TEST(ReadSplines, AGismoGeometryWithoutATypeIsCalledThat) {
  const auto file = read_splines(SplineFormat::kGismo,
                                 "<xml><Geometry><Geometry type=\"BSpline\"/></Geometry></xml>");
  ASSERT_TRUE(file);
  EXPECT_EQ(left_out(*file, "geometries without a type"), 1u);
}

TEST(ReadSplines, XmlOfAnotherProgramIsNoEmptyGismoFile) {
  for (const std::string name : {"COLLADA", "html"}) {
    const std::string text = "<?xml version=\"1.0\"?><!-- --><" + name + "></" + name + ">";
    const auto file = read_splines(SplineFormat::kGismo, text);
    ASSERT_FALSE(file) << text;
    EXPECT_EQ(file.error().code, Code::kForeignFormat);
    EXPECT_NE(file.error().message.find("<" + name + ">"), std::string::npos);
  }
}

TEST(ReadSplines, MfemPatchesMayBeCartesian) {
  const SplineFile file = sample("patches.mesh");
  EXPECT_EQ(exact_value<2>(shape<ExactSurface>(file, 0), {kHalf, Rational(1)}), "1 4/3");
  EXPECT_EQ(file.model.entities[0].attributes, (std::vector<std::string>{"attribute 7"}));
}

TEST(ReadSplines, MfemNumbersControlPointsByVerticesEdgesFacesAndPatches) {
  const SplineFile file = sample("two_cubes.mesh");
  const auto &a = shape<ExactVolume>(file, 0), &b = shape<ExactVolume>(file, 1);
  // The second brick starts at vertex 5 and runs back along x and y: its knots are turned with it.
  EXPECT_EQ(b.axis(0).knots[3], Rational(Integer(3), Integer(4)));
  EXPECT_EQ(b.axis(1).knots[2], Rational(Integer(3), Integer(4)));
  EXPECT_EQ(a.axis(1).knots[2], Rational(Integer(1), Integer(4)));
  EXPECT_EQ(exact_value<3>(b, {Rational(0), Rational(0), Rational(0)}), "2 1 0");
  // They share a face, point by point and weight by weight.
  const Grid<3> ga = a.grid(), gb = b.grid();
  for (int c = 0; c < 4; ++c)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 2; ++k)
        EXPECT_EQ(a.component(c)[ga.at({2, j, k})], b.component(c)[gb.at({3, 2 - j, k})])
            << c << " " << j << " " << k;
  // The net of each is monotone: no point is out of its row.
  for (std::size_t i = 0; i + 1 < 4; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 2; ++k) {
        const std::size_t p = gb.at({i, j, k}), q = gb.at({i + 1, j, k});
        EXPECT_LT(b.component(0)[q] / b.component(3)[q], b.component(0)[p] / b.component(3)[p])
            << i << j << k;
      }
}

struct Refusal {
  SplineFormat format;
  const char* text;
  const char* outcome;
};

TEST(ReadSplines, BadFilesAreRefusedWithEntityAndLine) {
  using enum SplineFormat;
  const Refusal kRefusals[] = {
      {kItd, "[OBJECT A\n[CURVE BSPLINE 2 2 E1 [KV 0 0 1 1] [0] [nan]]]", "not-finite@2#0"},
      {kItd, "[CURVE BSPLINE 2 2 P1 [KV 0 0 1 1] [1 0] [0 1]]", "bad-spline@1#0"},
      {kItd, "[CURVE BSPLINE 2 2 P1 [KV 0 0 1 1] [1 0] [-1 1]]", "bad-spline@1#0"},
      {kItd, "[CURVE BSPLINE 2 2 E1 [KV 0 1 0 1] [0] [1]]", "bad-spline@1#0"},
      {kItd, "[CURVE BSPLINE 2 2 E1 [KV 0 0 0 1] [0] [1]]", "bad-spline@1#0"},
      {kItd, "[CURVE BSPLINE 2 3 E1 [KV 0 0 0 1 1] [0] [1]]", "bad-spline@1#0"},
      {kItd, "[CURVE BSPLINE 2 2\nE1 [KV 0 0 1] [0] [1]]", "bad-spline@2#0"},
      {kItd, "[CURVE BSPLINE 2 2 E1 [KV 0 0 1 1 1] [0] [1]]", "syntax@1#0"},
      {kItd, "[CURVE BSPLINE 2 2 E1 [KV 0 0 1 1] [0] [1 2]]", "syntax@1#0"},
      {kItd, "[CURVE BSPLINE 2 2 E1 [KV 0 0 1 1] [0]]", "syntax@1#0"},
      {kItd, "[CURVE BEZIER 2 E0 [0] [1]]", "syntax@1#0"},
      {kItd, "[CURVE BEZIER 1 E1 [0]]", "bad-spline@1#0"},
      {kItd, "[CURVE BEZIER 99999999 E1 [0]]", "over-limit@1#0"},
      {kItd, "[CURVE BSPLINE 99999999 2 E1 [KV 0 0 1]", "truncated@1#0"},
      {kItd,
       "[SURFACE BSPLINE 9 9 2 2 E3 [KV 0 0 1 2 3 4 5 6 7 8 8][KV 0 0 1 2 3 4 5 6 7 8 8] [0 0 0]",
       "truncated@1#0"},
      {kItd, "[CURVE BEZIER -2 E1 [0]]", "syntax@1#0"},
      {kItd, "[CURVE BEZIER 2 E1 [0]", "truncated@1#0"},
      {kItd, "[OBJECT A\n[POLYGON 3 [0 0 0]", "truncated@2"},
      {kItd, "[OBJECT A\n[OBJECT B]\n", "truncated@1"},
      {kItd, "[OBJECT [a \"b]\n] ]", "truncated@1"},
      {kItd, "[OBJECT A B]", "syntax@1"},
      {kItd, "[SPHERE 1]", "syntax@1"},
      {kItd, "\n\nhello", "syntax@3"},
      {kItd, "a comment, and then the file was cut\n", "syntax@1"},
      {kItd, "\n \n", "truncated@3"},
      {kItd, "[CURVE BEZIER 2 E1 [0] [1]]\n[MODEL 0 1 [MDLTSEG 0 1 0]]", "over-limit@2#1"},
      {kItd, "[MODEL 1 0 [MDLTSRF 1 [SURFACE BEZIER 2 2 E1 [0][0][0][0]] [MDLLOOP 1]]]",
       "index-out-of-range@1#0"},
      {kG2, "100 1 0 0\n1 0\n2 2\n0 0 1\n", "truncated@5#0"},
      {kG2, "100 1 0 0\n1 0\n2 2\n0 0 1 1\n0 1\n100 1 0 0\n1 1\n2 2\n0 0 1 1\n0 1\n0 0\n",
       "bad-spline@7#1"},
      {kG2, "100 1 0 0\n1 0\n2 3\n", "bad-spline@3#0"},
      {kG2, "200 1 0 0\n3 0\n1000000 2\n", "truncated@3#0"},
      {kG2, "999 1 0 0\n", "syntax@1#0"},
      {kG2, "210 1 0 0\n200\n1 0\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n0 0 0 0\n1\n1 0\n0 155 0\n",
       "syntax@11#0"},
      {kG2, "hello", "syntax@1#0"},
      {kMfem, "MFEM NURBS mesh v2.0\n", "syntax@1"},
      {kMfem,
       "MFEM NURBS mesh v1.0\ndimension 1\nelements 1\n1 1 0 5\nboundary 0\nedges 0\nvertices 2\n",
       "index-out-of-range@4"},
      {kMfem, "MFEM NURBS mesh v1.0\ndimension 1\nelements 1\n1 3 0 1 2 3\n", "syntax@4"},
      {kMfem,
       "MFEM NURBS mesh v1.0\ndimension 1\nelements 1\n1 1 0 1\nboundary 0\nedges 1\n3 0 "
       "1\nvertices 2\nknotvectors 1\n1 2 0 0 1 1\nweights",
       "index-out-of-range@6"},
      {kMfem,
       "MFEM NURBS mesh v1.0\ndimension 1\nelements 1\n1 1 0 1\nboundary 0\nedges 1\n0 0 "
       "1\nvertices 2\nknotvectors 1\n1 2 0 0 1 1\nperiodic 1",
       "syntax@11"},
      {kMfem,
       "MFEM NURBS mesh v1.0\ndimension 1\nelements 1\n1 1 0 1\nboundary 0\nedges 0\nvertices "
       "2\npatches\nknotvectors 1\n2 2 0 0 1 1 1",
       "bad-spline@10#0"},
      {kGismo,
       "<xml><Geometry type=\"BSpline\">\n<Basis type=\"BSplineBasis\"><KnotVector degree=\"1\">0 "
       "0 1 1</KnotVector></Basis>\n</Geometry></xml>",
       "syntax@1#0"},
      {kGismo,
       "<xml><Geometry type=\"BSpline\"><KnotVector degree=\"1\">0 0 1 1</KnotVector><coefs "
       "geoDim=\"1\">0 1 2</coefs></Geometry></xml>",
       "bad-spline@1#0"},
      {kGismo, "<xml><Geometry type=\"BSpline\"><KnotVector degree=\"1\">0 0 1 1</KnotVector>",
       "truncated@1#0"},
      {kGismo, "<xml><Geometry type=\"BSpline\"></xml>", "syntax@1#0"},
      {kGismo, "<xml>\n<Geometry type=\"BSpline\"><KnotVector degree=\"99\">0 1</KnotVector>",
       "over-limit@2#0"},
      {kGismo, "<xml><!-- ", "truncated@1"},
      {kGismo, "<xml><Geometry type=\"BSpline\">\n<Geometry type=\"BSpline\"/></Geometry></xml>",
       "syntax@2#0"},
      {kGismo, "<!DOCTYPE a []><xml/>", "syntax@1"},
      {kJson, "{\"format\": \"veritope-spline-2\"", "unknown-format@1"},
      {kJson, "{\"format\": \"veritope-spline-1\", \"groups\": [], \"entities\": [{}]}",
       "syntax@1#0"},
      {kJson,
       "{\"format\": \"veritope-spline-1\", \"groups\": [{\"name\": \"\", \"parent\": 0, "
       "\"attributes\": []}]",
       "index-out-of-range@1"},
      {kJson, "{\"format\": \"veritope-spline-1\", \"groups\": [], \"entities\": []} x",
       "syntax@1"},
      {kJson, "{\"format\": \"veritope-spline-1\", \"groups\": [], \"groups\": []", "syntax@1"},
      {kJson, "{\"format\": \"\\ud800\"", "syntax@1"},
      // VT and FF are blanks in the other formats, and no blanks in JSON.
      {kJson, "{\v\"format\": \"veritope-spline-1\", \"groups\": [], \"entities\": []}",
       "syntax@1"},
      {kJson, "\f{\"format\": \"veritope-spline-1\", \"groups\": [], \"entities\": []}",
       "syntax@1"},
      {kJson, "{\"format\": \"veritope-spline-1\", \"groups\": [\f], \"entities\": []}",
       "syntax@1"},
      {kJson, "{\"format\": \"veritope-spline-1\", \"groups\": [], \"entities\": []}\v",
       "syntax@1"},
  };
  for (const Refusal& r : kRefusals) {
    const auto file = read_splines(r.format, r.text);
    EXPECT_EQ(outcome(file), r.outcome) << r.text << "\n" << (file ? "" : to_string(file.error()));
  }
}

// A file whose entity 0, in line 2, is a triangle.
std::string triangle_file(const std::string& shape) {
  return "{\"format\": \"veritope-spline-1\", \"groups\": [], \"entities\": [\n{\"kind\": "
         "\"triangle\", \"group\": null, \"attributes\": [], \"shape\": " +
         shape + "}]}";
}
std::string triangle_shape(const char* degree, const char* rational, const char* components,
                           const std::string& points) {
  return std::string("{\"degree\": ") + degree + ", \"rational\": " + rational +
         ", \"components\": " + components + ", \"points\": [" + points + "]}";
}

TEST(ReadSplines, TrianglesHaveTheirPointsInTheOrderOfTriangleIndex) {
  // b_ijk = (i, j, k), of weight 1 + i + 2 j.
  std::string points;
  for (const char* p :
       {"\"2\", \"0\", \"0\", \"3\"", "\"1\", \"1\", \"0\", \"4\"", "\"1\", \"0\", \"1\", \"2\"",
        "\"0\", \"2\", \"0\", \"5\"", "\"0\", \"1\", \"1\", \"3\"", "\"0\", \"0\", \"2\", \"1\""})
    points += std::string(points.empty() ? "" : ", ") + "[" + p + "]";
  const SplineModel model = io_test::model_of(
      SplineFormat::kJson, triangle_file(triangle_shape("2", "true", "4", points)));
  ASSERT_EQ(model.entities.size(), 1u);
  EXPECT_STREQ(spline_kind_name(model.entities[0]), "triangle");
  EXPECT_EQ(count_triangles(model), 1u);
  EXPECT_EQ(count_splines(model), (std::array<std::uint64_t, 3>{}));
  const auto& t = std::get<ExactTriangle>(model.entities[0].shape);
  EXPECT_TRUE(t.is_rational());
  ASSERT_EQ(t.degree(), 2);
  for_each_triangle_index(2, [&](int i, int j, int k) {
    const int expected[] = {i, j, k, 1 + i + 2 * j};
    for (int c = 0; c < 4; ++c)
      EXPECT_EQ(t.component(c)[triangle_index(j, k)], Rational(expected[c])) << i << j << k << c;
  });
}

TEST(ReadSplines, TrianglesThatAreNoneAreRefusedWithLineAndEntity) {
  const std::string three = "[\"0\", \"0\", \"1\"], [\"1\", \"0\", \"1\"], [\"0\", \"1\", \"1\"]";
  const auto refused = [&](const std::string& shape) {
    return outcome(read_splines(SplineFormat::kJson, triangle_file(shape)));
  };
  EXPECT_EQ(refused(triangle_shape("1", "false", "3", three)), "ok");
  EXPECT_EQ(refused(triangle_shape("1", "true", "3", three)), "ok");
  for (const char* degree : {"0", "-1", "-9000000000000000000"})
    EXPECT_NE(refused(triangle_shape(degree, "false", "3", three)), "ok") << degree;
  EXPECT_EQ(refused(triangle_shape("0", "false", "3", three)), "bad-spline@2#0");
  EXPECT_EQ(refused(triangle_shape("-1", "false", "3", three)), "bad-spline@2#0");
  EXPECT_EQ(refused(triangle_shape("64", "false", "3", three)), "over-limit@2#0");
  EXPECT_EQ(refused(triangle_shape("4000000000000", "false", "3", three)), "over-limit@2#0");
  EXPECT_EQ(refused(triangle_shape("2", "false", "3", three)), "bad-spline@2#0");
  EXPECT_EQ(refused(triangle_shape("1", "false", "2", three)), "bad-spline@2#0");
  EXPECT_EQ(refused(triangle_shape("1", "false", "-3", three)), "bad-spline@2#0");
  EXPECT_EQ(refused(triangle_shape("1", "true", "1", "[\"1\"], [\"1\"], [\"1\"]")),
            "bad-spline@2#0");
  EXPECT_EQ(refused(triangle_shape("1", "false", "3", "")), "bad-spline@2#0");
  // Two and four numbers are not three each.
  EXPECT_EQ(refused(triangle_shape("1", "false", "3",
                                   "[\"0\", \"0\"], [\"1\", \"0\", \"1\", \"0\"], "
                                   "[\"0\", \"1\", \"1\"]")),
            "bad-spline@2#0");
  for (const char* w : {"0", "-1/2"})
    EXPECT_EQ(refused(triangle_shape("1", "true", "3",
                                     "[\"0\", \"0\", \"1\"], [\"1\", \"0\", \"1\"], [\"0\", "
                                     "\"1\", \"" +
                                         std::string(w) + "\"]")),
              "bad-spline@2#0");
  EXPECT_EQ(refused("{\"degree\": 1, \"rational\": false, \"points\": []}"), "syntax@2#0");
  EXPECT_EQ(refused("{\"degrees\": [1]}"), "syntax@2#0");
}

TEST(ReadSplines, RowsOfPointsMustHaveEqualLengths) {
  EXPECT_EQ(outcome(read_splines(
                SplineFormat::kJson,
                "{\"format\": \"veritope-spline-1\", \"groups\": [], \"entities\": [{\"kind\": "
                "\"curve\", \"group\": null, \"attributes\": [], \"shape\": {\"degrees\": [1], "
                "\"periodic\": [false], \"knots\": [[\"0\", \"0\", \"1\", \"1\"]], \"rational\": "
                "false, \"components\": 2, \"points\": [[\"0\"], [\"1\", \"2\", \"3\"]]}}]}")),
            "bad-spline@1#0");
}

TEST(ReadSplines, EveryPrefixOfASampleIsRefusedOrReadWithoutHarm) {
  for (const char* name : {"groups.itd", "trimmed.itd", "objects.g2", "two_cubes.mesh",
                           "patches.mesh", "surface.xml", "triangles.vjson"}) {
    const std::string text = io_test::slurp(io_test::spline_folder() + name);
    const SplineFormat format = std::get<SplineFormat>(format_from_path(name)->id);
    for (std::size_t size = 1; size < text.size(); ++size) {
      const auto file = read_splines(format, std::string_view(text).substr(0, size));
      EXPECT_TRUE(file || file.error().place.line) << name << " " << size;
    }
  }
}

TEST(ReadSplines, NestingDoesNotGrowTheStack) {
  std::string deep;
  for (int i = 0; i < 300'000; ++i) deep += "[OBJECT ";
  EXPECT_EQ(outcome(read_splines(SplineFormat::kItd, deep)), "truncated@1");
  EXPECT_EQ(outcome(read_splines(SplineFormat::kItd, "[OBJECT " + std::string(300'000, '['))),
            "truncated@1");
  std::string xml = "<xml>";
  for (int i = 0; i < 100'000; ++i) xml += "<a>";
  EXPECT_EQ(outcome(read_splines(SplineFormat::kGismo, xml)), "truncated@1");
  EXPECT_EQ(outcome(read_splines(SplineFormat::kJson, std::string(300'000, '['))), "syntax@1");
}

TEST(ReadSplines, LimitsAreObeyed) {
  ModelReadOptions options;
  options.limits.max_digits = 3;
  EXPECT_EQ(outcome(read_splines(SplineFormat::kItd, "[CURVE BEZIER 2 E1 [0] [1.234]]", options)),
            "over-limit@1#0");
  options.limits = {};
  options.limits.max_exponent = 5;
  EXPECT_EQ(outcome(read_splines(SplineFormat::kItd, "[CURVE BEZIER 2 E1 [0] [1e6]]", options)),
            "over-limit@1#0");
  options.limits.max_bytes = 3;
  EXPECT_EQ(outcome(read_splines(SplineFormat::kItd, "[CURVE", options)), "over-limit");
}

std::string curve_of(std::uint64_t count, const std::string& number) {
  std::string text = "[CURVE BSPLINE " + std::to_string(count) + " 2 E1\n[KV 0";
  for (std::uint64_t i = 0; i < count; ++i) text += " " + std::to_string(i);
  text += " " + std::to_string(count - 1) + "]\n";
  for (std::uint64_t i = 0; i < count; ++i) text += "[" + number + "]";
  return text + "]";
}

std::string sentence(const Result<SplineFile>& file) {
  return file ? "read" : outcome(file) + " " + file.error().message;
}

TEST(ReadSplines, TheNumbersOfAFileHaveABudgetOfMemory) {
  // 60,000 times 1700 bytes, of 900,000.
  const std::string refused =
      sentence(read_splines(SplineFormat::kItd, curve_of(60'000, "1e4096")));
  EXPECT_NE(refused.find("over-limit@3#0 the file's numbers take more than"), refused.npos)
      << refused;
  EXPECT_NE(refused.find("'1e4096'"), refused.npos) << refused;
  EXPECT_EQ(sentence(read_splines(SplineFormat::kItd, curve_of(5'000, "-1e-4096"))), "read");
  // What is in the range of binary64 is within the budget however large the file: 77 MB of numbers.
  EXPECT_EQ(sentence(read_splines(SplineFormat::kItd, curve_of(600'000, "1e308"))), "read");
}

TEST(ReadSplines, OneNumberOverTheBudgetIsNotWrittenOut) {
  ModelReadOptions options;
  options.limits.max_exponent = 4'000'000'000;
  const std::string refused =
      sentence(read_splines(SplineFormat::kItd, "[CURVE BEZIER 2 E1 [0] [1e3999999999]]", options));
  EXPECT_NE(refused.find("over-limit@1#0 the file's numbers take more than"), refused.npos)
      << refused;
}

TEST(ReadSplines, NumbersThatAreMadeOfTheFilesNumbersAreInTheBudget) {
  // A weight times 1000 coordinates of two bytes each: 10 MB from 2 KB a point, 20 points.
  std::string xml =
      "<xml>\n<Geometry type=\"Nurbs\"><Basis><KnotVector degree=\"1\">0 0 1 2 3 4 5 6 7 8 9 10 11 "
      "12 13 14 15 16 "
      "17 18 19 19</KnotVector></Basis><weights>";
  for (int i = 0; i < 20; ++i) xml += "1e40000 ";
  xml += "</weights><coefs geoDim=\"1000\">";
  for (int i = 0; i < 20'000; ++i) xml += "1 ";
  ModelReadOptions options;
  options.limits.max_exponent = 40000;
  const auto file = read_splines(SplineFormat::kGismo, xml + "</coefs></Geometry></xml>", options);
  EXPECT_EQ(outcome(file), "over-limit@2#0") << sentence(file);
  // A constant in the power basis is a part of every coefficient.
  std::string power = "[TRIVAR POWER 64 64 8 E1 [1e4096]";
  for (int i = 1; i < 64 * 64 * 8; ++i) power += "[0]";
  EXPECT_EQ(outcome(read_splines(SplineFormat::kItd, power + "]")), "ok");
  power = "[TRIVAR POWER 64 64 64 E1 [1e4096]";
  for (int i = 1; i < 64 * 64 * 64; ++i) power += "[0]";
  EXPECT_EQ(outcome(read_splines(SplineFormat::kItd, power + "]")), "over-limit@1#0");
}

TEST(ReadSplines, FormatsAreFoundByNameAndByContent) {
  for (const char* name : {"groups.itd", "objects.g2", "two_cubes.mesh", "surface.xml"}) {
    const std::string text = io_test::slurp(io_test::spline_folder() + name);
    const auto file = read_spline_bytes(io_test::bytes(text), "no_extension", {});
    ASSERT_TRUE(file) << name;
    EXPECT_EQ(file->format, std::get<SplineFormat>(format_from_path(name)->id));
  }
  EXPECT_EQ(outcome(read_spline_bytes(io_test::bytes("hello"), "x", {})), "unknown-format");
  EXPECT_EQ(outcome(read_spline_bytes(io_test::bytes("\x1f\x8b"), "x.itd", {})), "foreign-format");
  EXPECT_EQ(outcome(read_spline_bytes({}, "x.itd", {})), "empty");
  EXPECT_EQ(outcome(read_spline_file("/nowhere/x.itd", {})), "cannot-open");
  EXPECT_EQ(outcome(read_spline_file("-", {})), "bad-argument");
}

TEST(ReadSplines, TextThatIsNoUtf8IsTakenAsLatin1) {
  const SplineModel model =
      model_of(SplineFormat::kItd, "[OBJECT caf\xe9 [CURVE BEZIER 2 E1 [0] [1]]]");
  EXPECT_EQ(model.groups[0].name, "caf\xc3\xa9");
}

}  // namespace
}  // namespace veritope
