// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/trees_fuzz.cc: any bytes as a tree of volumes. Errors have a line; what is built is a model that is written and
// reads back as the same, with positive weights and within the limits.
#include <cstdint>
#include <string>

#include "io/splines/read_splines.h"
#include "io/splines/write_splines.h"
#include "io/trees/build_tree.h"
#include "io/trees/tree_reader.h"
#include "robust/base/check.h"
#include "solids/volumes/primitives.h"

namespace {

using namespace veritope;

// One volume and one of its faces, whatever the path.
Result<SplineModel> load(const std::string& path) {
  if (path.empty()) return Error{Code::kCannotOpen, {}, "no such file"};
  const Cells cells = cylinder_cells(Rational(1), Rational(2)).value();
  SplineModel model = model_of_cells({cells[1]});
  model.entities.push_back({side_of(cells[1], 2, 0), {}, {}, {}});
  return model;
}

void check_cells(const BuiltTree& built) {
  VT_CHECK(!built.cells.empty() && built.cells.size() <= kMaxTreeCells,
           "a number of cells beyond the limits");
  for (const CellVolume& cell : built.cells) {
    VT_CHECK(cell.dimension() >= 3, "a cell that is not in space");
    if (!cell.is_rational()) continue;
    for (const Rational& w : cell.component(cell.dimension()))
      VT_CHECK(w.sign() == Sign::kPositive, "a weight that is not positive");
  }
  const SplineModel model = model_of_cells(built.cells);
  const std::string text = spline_json_bytes(model), name = "out.vjson";
  if (text.size() > 200000) return;
  const ByteBuffer bytes =
      copy_to_buffer({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
  ReadLimits wide;
  wide.max_digits = wide.max_exponent = 1000000;
  const Result<SplineFile> again = read_splines(SplineFormat::kJson, source_of(bytes, name), wide);
  VT_CHECK(again.has_value() && again->model == model, "the volumes do not read back");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string name = "tree.json";
  const ByteBuffer buffer = copy_to_buffer({data, size});
  ReadLimits limits;
  limits.max_digits = 40;
  limits.max_exponent = 40;
  const Result<TreeFile> tree = read_tree(source_of(buffer, name), limits);
  if (!tree) {
    VT_CHECK(tree.error().place.line.has_value(), "an error without a line");
    return 0;
  }
  const Result<BuiltTree> built = build_tree(*tree, name, load);
  if (built) {
    check_cells(*built);
  } else {
    VT_CHECK(built.error().place.line.has_value(), "an error without a line");
    VT_CHECK(built.error().message.starts_with("/root"), "an error without a pointer");
  }
  return 0;
}
