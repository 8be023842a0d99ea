// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/read_dms_moves_fuzz.cc: any bytes as a script of moves for a model of one tetrahedron, with shared control
// points or, if the first byte is odd, with separate ones. What is read is applied or refused, and leaves a model that
// keeps all rules; what is refused by the reader has a line.
#include <cstdint>
#include <string>

#include "io/dms/read_dms_moves.h"
#include "robust/base/check.h"
#include "solids/dms/dms_make.h"
#include "solids/dms/dms_moves.h"

namespace {

using namespace veritope;

DmsModel model_of(bool is_separate) {
  DmsModel model{
      2, {"a"}, {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}, {{0, 1, 2, 3}}, {}};
  model.clouds[1].insert(model.clouds[1].end(), 2, {2, 0, 0});
  set_control_by_rule(model, DmsControlRule::kGreville, std::vector<Rational>(4));
  if (!is_separate) return model;
  const DmsModel shared = model;
  model.control = {true, {}, {}};
  for_each_tetrahedral_index(2, [&](const TetrahedralIndex& beta) {
    const auto value = shared.value(control_of(shared, 0, beta));
    model.control.values.insert(model.control.values.end(), value.begin(), value.end());
  });
  return model;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  static const std::string name = "moves.json";
  DmsModel model = model_of(data[0] % 2 == 1);
  const ByteBuffer buffer = copy_to_buffer({data + 1, size - 1});
  const auto moves = read_dms_moves(source_of(buffer, name), {}, model);
  if (!moves) {
    VT_CHECK(moves.error().place.line.has_value(), "an error without a line");
    return 0;
  }
  for (const DmsMove& move : *moves)
    if (!apply_move(model, move)) return 0;
  VT_CHECK(validate(model).has_value(), "a move breaks a rule of the file");
  return 0;
}
