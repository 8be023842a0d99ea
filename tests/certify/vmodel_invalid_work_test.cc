// SPDX-License-Identifier: LGPL-3.0-or-later
// The limits of docs/certificates/vmodel-invalid.md: the prover makes no certificate that checkers refuse.
#include "verify/certify/vmodel_invalid_work.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "io/splines/write_splines.h"
#include "tests/certify/patch_round_trip.h"
#include "tests/support/checker_call.h"
#include "tests/support/v_cells.h"
#include "verify/certify/certify.h"

namespace veritope {
namespace {

using v_cells::cube;

// A cube whose axes are [0, 1 + 2^-bits]: their only interval is as long as a number of `bits` bits.
VVolume on_long_axes(VVolume cell, int bits) {
  for (std::size_t a = 0; a < 3; ++a)
    cell = with_domain(cell, a, Rational(0), Rational(1) + Rational::power_of_two(-bits)).value();
  return cell;
}
// What the C++ checker says of the certificate; empty without a certificate.
std::string judged_by_checker(const std::vector<VVolume>& cells) {
  SplineModel model;
  for (const VVolume& cell : cells) model.entities.push_back({cell, {}, {}, {}});
  const std::string file = spline_json_bytes(model);
  const Certified c = certify(ModelFile(spline_file_of(file))).value();
  if (c.certificate.empty()) return "";
  return check_in_process(c.copy ? c.copy->bytes : file,
                          std::string(c.certificate.begin(), c.certificate.end()));
}

TEST(VInvalidWork, KnotsThatAreTooLongAreBeyondTheLimit) {
  const std::array<Rational, 2> all = {Rational(0), Rational(1)};
  for (const int bits : {500, 3000}) {
    const VModel model =
        make_v_model({on_long_axes(cube(0, 0, 0), bits)}, VOrientation::kKeep).value();
    const bool is_short = bits == 500;
    VInvalidWork box(model, 1000), flat(model, 1000), arc(model, 1000), near(model, 1000);
    box.add_box(VBox{0, {}, {all, all, all}});
    flat.add_flat(0, {});
    arc.add_arc(VArc{0, 0, 0, 0, all});
    near.add_cells_near({Rational(0), Rational(0), Rational(0)});
    for (const VInvalidWork* const work : {&box, &flat, &arc, &near})
      EXPECT_EQ(work->fits(), is_short) << bits;
  }
}

TEST(VInvalidWork, WhatIsCertifiedIsAcceptedHoweverLongTheKnotsAre) {
  const auto has_long_axes = [](std::vector<VVolume> cells, int bits) {
    for (VVolume& cell : cells) cell = on_long_axes(std::move(cell), bits);
    return judged_by_checker(cells);
  };
  for (const int bits : {100, 1000, 2047, 2048, 2049, 3000})
    for (const auto& cells :
         {std::vector{cube(0, 0, 0), cube(1, 1, 0)}, std::vector{cube(0, 0, 0), cube(1, 1, 1)},
          std::vector{cube(0, 0, 0), cube(0, 0, 0)}}) {
      const std::string answer = has_long_axes(cells, bits);
      EXPECT_EQ(answer.substr(0, 6), answer.empty() ? "" : "ACCEPT") << bits << ": " << answer;
      if (bits == 100) {
        EXPECT_FALSE(answer.empty());
      }
    }
}

}  // namespace
}  // namespace veritope
