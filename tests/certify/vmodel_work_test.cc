// SPDX-License-Identifier: LGPL-3.0-or-later
// The limits of docs/certificates/vmodel.md, at them and beyond them: the prover stops where checkers would refuse, and
// not before.
#include "verify/certify/vmodel_work.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "io/read_model.h"
#include "io/splines/write_splines.h"
#include "tests/support/paths.h"
#include "verify/certify/certify.h"
#include "verify/certify/vmodel_certifier.h"

namespace veritope {
namespace {

using Index = std::array<std::size_t, 3>;
using Axes = std::array<KnotAxis<Rational>, 3>;

Rational power(int n) { return Rational::power_of_two(n); }

KnotAxis<Rational> bezier_axis(int p, const Rational& end = Rational(1)) {
  std::vector<Rational> knots(static_cast<std::size_t>(p) + 1, Rational(0));
  knots.resize(2 * knots.size(), end);
  return {p, std::move(knots)};
}

ExactVolume cell(const Axes& axes, const std::function<Rational(const Index&, std::size_t)>& number,
                 bool is_rational = false) {
  Grid<3> grid;
  for (std::size_t a = 0; a < 3; ++a) grid.size[a] = axes[a].num_control();
  std::vector<Rational> all;
  for (std::size_t c = 0; c < (is_rational ? 4 : 3); ++c)
    for (std::size_t i = 0; i < grid.count(); ++i)
      all.push_back(c == 3 ? Rational(1) : number(grid.index_of(i), c));
  return ExactVolume(axes, is_rational ? 4 : 3, is_rational, std::move(all));
}
// Control points at the integers, but for one coordinate of one of them.
ExactVolume with_number(const Axes& axes, const Index& at, std::size_t component,
                        const Rational& value) {
  return cell(axes, [&](const Index& i, std::size_t c) {
    return i == at && c == component ? value : Rational(static_cast<std::int64_t>(i[c]));
  });
}

std::optional<Finding> refusal(const ExactVolume& volume, std::uint64_t bytes = 1 << 20) {
  const VModel model = make_v_model({volume}, VOrientation::kKeep).value();
  return VModelWork(model, bytes).of_pieces();
}
std::string reason(const ExactVolume& volume) {
  const auto finding = refusal(volume);
  return finding ? finding->message : "";
}

SplineFile file_of(const ExactVolume& volume, std::string* bytes) {
  SplineModel model;
  model.entities.push_back({volume, {}, {}, {}});
  *bytes = spline_json_bytes(model);
  return read_spline_bytes({reinterpret_cast<const unsigned char*>(bytes->data()), bytes->size()},
                           "m.vjson", {})
      .value();
}

// What the two checkers answer, "ACCEPT vmodel-1: ..." or "REJECT B2: ...".
std::vector<std::string> answers(const std::string& model, const certificate::Bytes& bytes) {
  namespace fs = std::filesystem;
  const fs::path folder =
      fs::temp_directory_path() / ("veritope_vmodel_work_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  std::ofstream(folder / "m.vjson", std::ios::binary) << model;
  std::ofstream(folder / "m.cert", std::ios::binary) << std::string(bytes.begin(), bytes.end());
  std::vector<std::string> out;
  for (const std::string& program : {"'" + test::program_dir() + "/veritope-check'",
                                     "'" + test::python() + "' -B '" + test::source_dir() +
                                         "/verify/checker/veritope_check.py'"}) {
    const std::string command = program + " '" + (folder / "m.vjson").string() + "' '" +
                                (folder / "m.cert").string() + "' 2>&1";
    std::FILE* pipe = ::popen(command.c_str(), "r");
    std::string text;
    char part[4096];
    for (std::size_t n; (n = std::fread(part, 1, sizeof part, pipe)) > 0;) text.append(part, n);
    ::pclose(pipe);
    out.push_back(text.substr(0, 300));
  }
  fs::remove_all(folder);
  return out;
}

// The prover certifies the volume, and both checkers accept.
void expect_certified(const ExactVolume& volume, const std::string& what) {
  std::string bytes;
  const SplineFile file = file_of(volume, &bytes);
  const std::optional<VModelAnswer> answer = certify_vmodel(file, {});
  ASSERT_TRUE(answer) << what;
  ASSERT_EQ(answer->certified.verdict, Verdict::kValid)
      << what << ": " << answer->certified.findings.front().message;
  for (const std::string& text : answers(bytes, answer->certified.certificate))
    EXPECT_EQ(text.find("ACCEPT vmodel-1"), 0u) << what << ": " << text;
}

TEST(VModelWork, LetsControlPointsHaveAsManyBitsAsCheckersDo) {
  const Axes axes = {bezier_axis(1), bezier_axis(1), bezier_axis(1)};
  // The common denominator of all is 2^8191, which has 8192 bits, and so has the greatest number, below 2 * 2^8191.
  const Rational last = Rational(1) + power(-8191);
  const ExactVolume at = with_number(axes, {1, 1, 1}, 2, last);
  EXPECT_EQ(reason(at), "");
  expect_certified(at, "8192 bits");
  const ExactVolume beyond = with_number(axes, {1, 1, 1}, 2, Rational(1) + power(-8192));
  EXPECT_NE(reason(beyond).find("control points are longer"), std::string::npos) << reason(beyond);
}

// The lengths of a numerator and of the common denominator, 4401 and 3963 bits, add up to more than 8192; the numbers
// over that denominator do not.
TEST(VModelWork, CountsTheBitsOfNumbersOverTheirCommonDenominator) {
  const Axes axes = {bezier_axis(1), bezier_axis(1), bezier_axis(1)};
  Integer denominator(1);
  for (int i = 0; i < 2500; ++i) denominator *= Integer(3);
  const ExactVolume volume = cell(axes, [&](const Index& i, std::size_t c) {
    const Rational x(static_cast<std::int64_t>(i[c]));
    return c == 0 ? (x * power(4400) + Rational(1)) / Rational(denominator) : x * power(437);
  });
  EXPECT_EQ(reason(volume), "");
  expect_certified(volume, "one denominator");
  const ExactVolume wide = cell(axes, [&](const Index& i, std::size_t c) {
    const Rational x(static_cast<std::int64_t>(i[c]));
    return c == 0 ? x / Rational(denominator) : c == 1 ? x * power(4400) : x;
  });
  EXPECT_NE(reason(wide).find("control points are longer"), std::string::npos) << reason(wide);
}

TEST(VModelWork, LetsKnotsHaveAsManyBitsAsCheckersDo) {
  // The length of the axis has 2048 bits, or one more; the certificate is about nothing else.
  for (const int bits : {2048, 2049}) {
    const Axes axes = {bezier_axis(1, power(bits - 1)), bezier_axis(1), bezier_axis(1)};
    const ExactVolume volume = with_number(axes, {0, 0, 0}, 0, Rational(0));
    if (bits == 2048) {
      EXPECT_EQ(reason(volume), "");
      expect_certified(volume, "knots of 2048 bits");
    } else {
      EXPECT_NE(reason(volume).find("knots are longer"), std::string::npos) << reason(volume);
    }
  }
}

// In the degrees (15, 15, 15) N of a cell without weights has 45^3 = 91,125 coefficients: times 184 bits that is at most
// 2^24, times 185 it is more. The longest number is the common denominator: the weight of every control point.
TEST(VModelWork, LetsPiecesBeAsLongAsCheckersDo) {
  const Axes axes = {bezier_axis(15), bezier_axis(15), bezier_axis(15)};
  for (const int bits : {184, 185}) {
    const std::string why = reason(cell(axes, [&](const Index& i, std::size_t c) {
      return i == Index{0, 0, 0} && c == 0
                 ? power(1 - bits)
                 : Rational(static_cast<std::int64_t>(i[c])) / Rational(16);
    }));
    EXPECT_EQ(why.find("certificates of such degrees") != std::string::npos, bits == 185) << why;
  }
}

// The units are those of the page, for a Bezier cell whose numbers are integers below 2.
TEST(VModelWork, AllowsAsManyUnitsAsThePage) {
  const Axes axes = {bezier_axis(12), bezier_axis(12), bezier_axis(12)};
  const ExactVolume volume = cell(
      axes,
      [&](const Index& i, std::size_t c) {
        return Rational(static_cast<std::int64_t>(i[c])) + (i[c] == 5 ? power(-60) : Rational(0));
      },
      true);
  const std::uint64_t p = 12, m = 13 * 13 * 13, m2 = 25 * 25 * 25, c = 48 * 48 * 48, b = 64;
  const std::uint64_t limbs = 2 + b / 32, d = 3 * 47, t = 1;
  std::uint64_t units = 3 * (1 + p * p * p * (64 + p * p * p * t * t / 8192) / 32), h = b;
  for (int a = 0; a < 3; ++a) {
    const std::uint64_t longer = p * (p + 1) * t;
    units += m * (p + 1) * (32 + (1 + longer / 128) * (1 + h / 64)) / 32;
    h += longer / 2;
  }
  units += 2 + m * 3 * p * b / 4096;
  units += 2 + m2 * m2 * limbs * limbs / 256;
  units += 1 + c * d * 4 * b / 16384;
  const std::uint64_t free = std::uint64_t{1} << 23;
  ASSERT_GT(units, free);
  const std::uint64_t enough = (units - free + 95) / 96;
  EXPECT_FALSE(refusal(volume, enough)) << refusal(volume, enough)->message;
  ASSERT_TRUE(refusal(volume, enough - 1));
  EXPECT_NE(refusal(volume, enough - 1)->message.find("more work"), std::string::npos);
}

}  // namespace
}  // namespace veritope
