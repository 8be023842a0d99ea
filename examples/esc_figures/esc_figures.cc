// SPDX-License-Identifier: LGPL-3.0-or-later
// Figures 11 to 19 of [GRF03] with free-form solids of our own: a stomach and a ring (11), points of a part of the
// chain of their union, intersection and difference (12, 14, 16: those that are not in the result are red), points of
// the results (13, 15, 17), a third solid (18) and its points in a grid of 25^3 (19). Prints exact counts.
//   example_esc_figures MESHES [PICTURES]
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "examples/esc_figures/chain_part.h"
#include "io/pn_model.h"
#include "io/read_model.h"
#include "io/splines/patch_model.h"
#include "render/cast_solid.h"
#include "render/png.h"

using namespace veritope;

namespace {

PatchComplex complex_of(const std::string& mesh) {
  ModelReadOptions options;
  options.with_normals = true;
  const SplineModel model = pn_model(read_mesh_file(mesh, options).value()).value();
  return make_patch_complex(patch_source(model).value().patches).value();
}

// A solid, twice: for the chain, and for the classifier.
struct Solid {
  explicit Solid(const std::string& mesh)
      : complex(complex_of(mesh)),
        operand(patch_operand(std::make_unique<const PatchComplex>(complex_of(mesh)))) {}
  PatchComplex complex;
  std::shared_ptr<const Operand> operand;
};

ExactBox<3> box(const std::array<int, 6>& eighths) {
  ExactBox<3> out;
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = {Rational(eighths[k]) / Rational(8), Rational(eighths[k + 3]) / Rational(8)};
  return out;
}
const ExactBox<3> kBothBox = box({-14, -12, -15, 15, 12, 14}),
                  kJackBox = box({-12, -12, -12, 12, 12, 12});
constexpr std::uint32_t kManyPoints = 32, kPointsOfFigure19 = 25;
constexpr Point3d kView = {-4, 8, -3};

class Figures {
 public:
  explicit Figures(std::string folder) : folder_(std::move(folder)) {
    look_.width = 800, look_.height = 600;
    look_.view = kView;
    look_.jobs = 0;
  }

  void solid(const char* name, const SolidProbe& probe, const ExactBox<3>& bounds) const {
    if (folder_.empty()) return;
    Box3d around;
    for (std::size_t k = 0; k < 3; ++k)
      around.lo[k] = round_down(bounds[k].lo), around.hi[k] = round_up(bounds[k].hi);
    write(name, cast_solid(probe, around, look_).value());
  }
  void grid(const char* name, const PointGrid& grid) const {
    if (!folder_.empty()) write(name, draw_point_grid(grid, look_).value());
  }

 private:
  void write(const char* name, const Image& image) const {
    std::ofstream file(std::filesystem::path(folder_) / (std::string(name) + ".png"),
                       std::ios::binary);
    file << png_bytes(image);
  }
  std::string folder_;
  PictureOptions look_;
};

void print_points(const char* figure, const char* what, const PointGrid& grid) {
  std::printf("%s  %-38s %5llu in, %llu on, %5llu out, %llu undecided\n", figure, what,
              static_cast<unsigned long long>(grid.count(GridMark::kIn)),
              static_cast<unsigned long long>(grid.count(GridMark::kOn)),
              static_cast<unsigned long long>(grid.count(GridMark::kNone)),
              static_cast<unsigned long long>(grid.count(GridMark::kUndecided)));
}

// f of a chain from those of its operands at a point.
using Combine = std::function<int(int f1, int f2)>;

// The points where the chain of a part of solid 1 and all of solid 2 does not vanish.
class PartialResult {
 public:
  PartialResult(const Solid& first, const Solid& second)
      : second_(*second.operand),
        // The outer half of the patches, seen from an origin between the stomach's ends.
        part_(first.complex, static_cast<std::uint32_t>(first.complex.patches().size()) / 2,
              static_cast<std::uint32_t>(first.complex.patches().size()),
              {0.4375, 0.15625, 0.90625}) {}

  void show(const char* figure, const char* what, const Combine& f, const PointGrid& result,
            const Figures& figures) const {
    PointGrid shown(kBothBox, kManyPoints);
    unsigned walls = 0;
    for (std::uint32_t i = 0; i < kManyPoints; ++i)
      for (std::uint32_t j = 0; j < kManyPoints; ++j)
        for (std::uint32_t k = 0; k < kManyPoints; ++k) {
          const Vec3d q = point_of(shown, i, j, k);
          const auto f1 = part_.value(q);
          const Value3 f2 = second_.value(q);
          if (!f1 || !is_constant(f2)) {
            ++walls;
            continue;
          }
          if (f(*f1, f2 == Value3::kOne ? 1 : 0) == 0) continue;
          const bool is_right = result.mark(i, j, k) == GridMark::kIn;
          shown.set(i, j, k, is_right ? GridMark::kIn : GridMark::kExcess);
        }
    std::printf("%s  %-38s %5llu of the result, %llu of them not in it: red, %u on walls\n", figure,
                what, static_cast<unsigned long long>(shown.count(GridMark::kIn)),
                static_cast<unsigned long long>(shown.count(GridMark::kExcess)), walls);
    figures.grid((std::string("figure") + figure).c_str(), shown);
  }

 private:
  static Vec3d point_of(const PointGrid& grid, std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    const ExactPoint p = grid.point(i, j, k);  // multiples of 2^-9
    return {nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])};
  }
  const Operand& second_;
  ChainPart part_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return std::fprintf(stderr, "usage: example_esc_figures MESHES [PICTURES]\n"), 2;
  const std::filesystem::path meshes(argv[1]);
  const Figures figures(argc > 2 ? argv[2] : "");
  const Solid stomach((meshes / "stomach.obj").string()), ring((meshes / "ring.off").string()),
      jack((meshes / "jack.obj").string());
  const Formula a = Formula::variable(0), b = Formula::variable(1);
  const auto classifier = [&](const Formula& formula) {
    return ExpressionClassifier(formula, {stomach.operand, ring.operand});
  };
  figures.solid("figure11_stomach", ExpressionProbe(classifier(a)), kBothBox);
  figures.solid("figure11_ring", ExpressionProbe(classifier(b)), kBothBox);

  std::printf("32^3 points of [-7/4,15/8] x [-3/2,3/2] x [-15/8,7/4]\n");
  const PartialResult partial(stomach, ring);
  struct Row {
    const char *part, *result, *name, *solid;
    Formula formula;
    Combine f;
  };
  const std::vector<Row> rows = {
      {"12", "13", "union", "union", Formula::any_of({a, b}),
       [](int f1, int f2) { return f1 + f2 - f1 * f2; }},
      {"14", "15", "intersection", "intersection", Formula::all_of({a, b}),
       [](int f1, int f2) { return f1 * f2; }},
      {"16", "17", "difference", "difference", Formula::all_of({a, b.negated()}),
       [](int f1, int f2) { return f1 - f1 * f2; }},
  };
  for (const Row& row : rows) {
    const ExpressionClassifier result = classifier(row.formula);
    const ExpressionProbe probe(result);
    const PointGrid grid = classify_grid(probe, kBothBox, kManyPoints, 0);
    partial.show(row.part, (std::string("part of the chain of the ") + row.name).c_str(), row.f,
                 grid, figures);
    print_points(row.result, row.name, grid);
    figures.grid((std::string("figure") + row.result).c_str(), grid);
    figures.solid((std::string("figure") + row.result + "_solid").c_str(), probe, kBothBox);
  }

  std::printf("25^3 points of [-3/2,3/2]^3\n");
  const ExpressionClassifier of_jack(a, {jack.operand});
  const ExpressionProbe probe(of_jack);
  const PointGrid grid = classify_grid(probe, kJackBox, kPointsOfFigure19, 0);
  print_points("19", "third solid", grid);
  figures.solid("figure18", probe, kJackBox);
  figures.grid("figure19", grid);
  return 0;
}
