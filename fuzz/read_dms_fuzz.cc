// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/read_dms_fuzz.cc: any bytes as a simplex-spline solid. What is read keeps all rules and is written in a
// canonical form, which reads back as the same bytes; small models without defects have values that add up; what is
// refused has a line.
#include <cstdint>
#include <string>

#include "io/dms/read_dms.h"
#include "io/dms/write_dms.h"
#include "robust/base/check.h"
#include "solids/dms/dms_defects.h"
#include "solids/dms/dms_evaluator.h"

namespace {

using namespace veritope;

Result<DmsFile> read(std::span<const std::uint8_t> bytes) {
  static const std::string name = "model.vdms";
  const ByteBuffer buffer = copy_to_buffer(bytes);
  return read_dms(DmsFormat::kDms, source_of(buffer, name), {});
}

bool is_small(const DmsModel& model) { return model.degree <= 3 && model.tetrahedra.size() <= 4; }

// At the barycentre of each tetrahedron of `places`, whose domain is the same set, the model has a value.
void check_values_at(const DmsModel& places, const DmsModel& model) {
  DmsEvaluator evaluator(model);
  for (const TetrahedronCorners& t : places.tetrahedra) {
    DmsPoint middle;
    for (const std::uint32_t v : t)
      for (std::size_t c = 0; c < 3; ++c) middle[c] += places.clouds[v][0][c] / Rational(4);
    const auto place = evaluator.locate(middle);
    VT_CHECK(place.has_value(), "a barycentre lies in the domain");
    VT_CHECK(evaluator.evaluate(*place).value.size() == model.num_components(),
             "a value has a number for each component");
  }
}

void check_values(const DmsModel& model) {
  if (!is_small(model)) return;
  for (const DmsModel& own : model.attribute_domain)
    if (!is_small(own)) return;
  if (find_dms_defects(model).count > 0) return;
  check_values_at(model, model);
  for (const DmsModel& own : model.attribute_domain) {
    check_values_at(own, own);
    check_values_at(own, model);
    check_values_at(model, own);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Result<DmsFile> file = read({data, size});
  if (!file) {
    VT_CHECK(file.error().place.line.has_value(), "an error without a line");
    return 0;
  }
  VT_CHECK(validate(file->model).has_value(), "what is read breaks a rule");
  const std::string written = write_dms(file->model);
  const Result<DmsFile> again =
      read({reinterpret_cast<const std::uint8_t*>(written.data()), written.size()});
  VT_CHECK(again.has_value(), "the canonical form is refused");
  VT_CHECK(again->model == file->model, "the canonical form is another model");
  VT_CHECK(write_dms(again->model) == written, "the canonical form changes when it is read");
  check_values(file->model);
  return 0;
}
