// SPDX-License-Identifier: LGPL-3.0-or-later
// V-models of real files: numbers of cells, gluing, orientation and determinants beside what is known about them.
#include <gtest/gtest.h>

#include "io/read_model.h"
#include "solids/patches/patch_complex.h"
#include "solids/vmodel/jacobian_sign.h"
#include "solids/vmodel/v_faces.h"
#include "tests/support/paths.h"

namespace veritope {
namespace {

using Kind = JacobianFinding::Kind;

struct Known {
  const char* file;
  std::uint64_t cells, internal, reversed, zeros;
  std::vector<Kind> findings;
  bool is_closed;  // the border is a closed oriented surface
};

std::vector<VVolume> volumes_of(const SplineModel& model) {
  std::vector<VVolume> out;
  for (const SplineEntity& entity : model.entities)
    if (const auto* volume = std::get_if<ExactVolume>(&entity.shape)) out.push_back(*volume);
  return out;
}

TEST(VModelFiles, AreGluedAndDecidedAsIsKnown) {
  const std::vector<Known> all{
      {"mfem__ball-nurbs.mesh", 7, 18, 0, 0, {}, true},
      {"mfem__beam-hex-nurbs.mesh", 2, 1, 0, 0, {}, true},
      {"mfem__two-cubes-nurbs.mesh", 2, 1, 0, 0, {}, true},
      {"mfem__two-cubes-nurbs-rot.mesh", 2, 1, 0, 0, {}, true},
      {"mfem__two-cubes-nurbs-autoedge.mesh", 2, 1, 0, 0, {}, true},
      {"mfem__cube-nurbs.mesh", 1, 0, 0, 0, {}, true},
      {"mfem__cube-nurbs_2.mesh", 1, 0, 0, 0, {}, true},
      {"gismo__fichera.xml", 7, 9, 4, 0, {}, true},
      {"gismo__cylinder.xml", 1, 1, 1, 0, {}, true},
      {"gismo__GshapedVolume.xml", 1, 0, 1, 4, {}, true},
      {"iritprim__ns_cylinder_rational.itd", 5, 8, 2, 0, {}, true},
      {"iritprim__ns_sphere_rational.itd", 7, 18, 1, 0, {}, true},
      {"iritprim__ns_cone_rational.itd", 5, 4, 2, 8, {Kind::kFlat}, true},
      {"iritprim__ns_sphere_poly.itd", 7, 4, 7, 0, std::vector<Kind>(6, Kind::kFolded), false},
      {"iritprim__ns_cylinder_poly.itd", 5, 4, 2, 0, {}, false},
  };
  std::size_t seen = 0;
  for (const Known& known : all) {
    SCOPED_TRACE(known.file);
    const auto file = read_spline_file(test::data_dir() + "/cad/" + known.file, {});
    if (!file) continue;
    ++seen;
    const VModel model = make_v_model(volumes_of(file->model), VOrientation::kAuto).value();
    EXPECT_EQ(model.num_cells(), known.cells);
    EXPECT_EQ(model.counts().internal, known.internal);
    EXPECT_EQ(model.counts().reversed, known.reversed);
    EXPECT_TRUE(model.forbidden().empty());
    EXPECT_TRUE(model.copies().empty());
    const VDeterminants d = decide_determinants(model);
    std::vector<Kind> kinds;
    for (const JacobianFinding& f : d.findings) kinds.push_back(f.kind);
    EXPECT_EQ(kinds, known.findings);
    EXPECT_EQ(d.num_zeros, known.zeros);
    const PatchComplex border =
        make_patch_complex(patches_of(border_of(model)).value(), PatchOrientation::kKeep).value();
    EXPECT_EQ(border.is_closed_oriented_surface(), known.is_closed);
  }
  if (seen == 0)
    GTEST_SKIP() << "1 test skipped: no real splines in " << test::data_dir() << " (VERITOPE_DATA)";
}

}  // namespace
}  // namespace veritope
