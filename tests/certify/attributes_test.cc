// SPDX-License-Identifier: LGPL-3.0-or-later
// Volumes with attributes, coordinates from the fourth on: certificates say what they say of the volumes without them.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/read_model.h"
#include "io/splines/boundary_faces.h"
#include "io/splines/volumes.h"
#include "io/splines/write_splines.h"
#include "verify/certify/certify.h"
#include "verify/checker/patches/star.h"

namespace veritope {
namespace {

// Two unit cubes side by side, the second one with weights 2; the numbers of the attributes of a control point are
// attribute + 0, 1, ... times the weight.
SplineModel cubes(int attributes, const Rational& attribute) {
  const KnotAxis<Rational> axis{1, {0, 0, 1, 1}};
  SplineModel out;
  for (int cell = 0; cell < 2; ++cell) {
    const bool is_rational = cell == 1;
    const Rational w(cell + 1);
    std::vector<Rational> values;
    for (int c = 0; c < 3 + attributes + (is_rational ? 1 : 0); ++c)
      for (int i = 0; i < 8; ++i)
        values.push_back(c == 3 + attributes ? w
                         : c >= 3            ? (attribute + Rational(c - 3)) * w
                         : c == 0            ? Rational(cell + (i >> 2 & 1)) * w
                                             : Rational(i >> (2 - c) & 1) * w);
    out.entities.push_back({ExactVolume({axis, axis, axis}, 3 + attributes + (is_rational ? 1 : 0),
                                        is_rational, std::move(values)),
                            {},
                            {},
                            {}});
  }
  return out;
}

std::string bytes_of(const SplineModel& model, SplineFormat format) {
  return spline_bytes(model, format, ReadLimits{});
}
SplineFile file_of(const std::string& bytes, const std::string& name) {
  return read_spline_bytes({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()},
                           name, {})
      .value();
}
Certified certified(const std::string& bytes, const std::string& name) {
  const auto read = file_of(bytes, name);
  return certify(read, {}).value();
}
// The certificate without the lines of its statement that have this key.
std::string without(std::string text, const std::string& key) {
  for (std::size_t at; (at = text.find("\"" + key + "\"")) != text.npos;)
    text.erase(at, text.find(',', at) - at);
  return text;
}
std::string but_for_file(const certificate::Bytes& bytes) {
  return without(without(std::string(bytes.begin(), bytes.end()), "subject_sha256"),
                 "subject_bytes");
}

constexpr SplineFormat kFormats[] = {SplineFormat::kJson, SplineFormat::kItd, SplineFormat::kG2};
const char* const kNames[] = {"m.vjson", "m.itd", "m.g2"};

TEST(Attributes, ChangeNothingButTheHashOfTheFile) {
  for (std::size_t f = 0; f < 3; ++f) {
    const Certified plain = certified(bytes_of(cubes(0, 0), kFormats[f]), kNames[f]);
    ASSERT_EQ(plain.verdict, Verdict::kValid) << kNames[f];
    EXPECT_EQ(plain.claim, "vmodel-1");
    certificate::Bytes last = plain.certificate;
    for (const int attributes : {1, 5, 6})
      for (const int value : {-1, 7}) {
        const Certified with =
            certified(bytes_of(cubes(attributes, Rational(value)), kFormats[f]), kNames[f]);
        ASSERT_EQ(with.verdict, Verdict::kValid) << kNames[f] << ' ' << attributes;
        EXPECT_FALSE(with.copy) << kNames[f];
        EXPECT_NE(with.certificate, last);  // it is about another file
        EXPECT_EQ(but_for_file(with.certificate), but_for_file(plain.certificate))
            << kNames[f] << ' ' << attributes << ' ' << value;
        last = with.certificate;
      }
  }
}

TEST(Attributes, AreLeftOutByTheCheckersReaders) {
  for (std::size_t f = 0; f < 3; ++f) {
    const std::string format = spline_format_name(kFormats[f]);
    const auto plain = ::read_volumes(bytes_of(cubes(0, 0), kFormats[f]), format);
    const auto with = ::read_volumes(bytes_of(cubes(4, Rational(3)), kFormats[f]), format);
    ASSERT_EQ(with.size(), plain.size());
    for (std::size_t v = 0; v < with.size(); ++v) {
      ASSERT_EQ(with[v].components, plain[v].components);
      for (std::uint64_t i = 0; i < with[v].places.size(); ++i)
        for (std::size_t c = 0; c < static_cast<std::size_t>(with[v].components); ++c)
          EXPECT_TRUE(with[v].number(i, c).n == plain[v].number(i, c).n &&
                      with[v].number(i, c).d == plain[v].number(i, c).d)
              << format << " volume " << v << " point " << i << " component " << c;
    }
    const auto faces =
        ::read_spline_model(bytes_of(cubes(4, Rational(3)), kFormats[f]), format + "-faces");
    EXPECT_EQ(faces.size(), boundary_faces(cubes(0, 0)).value().model.entities.size());
    EXPECT_EQ(faces.size(), boundary_faces(cubes(4, 3)).value().model.entities.size());
  }
}

// An attribute has at most 8192 bits; the file of a longer one has a copy without attributes.
TEST(Attributes, HaveAsManyBitsAsControlPoints) {
  for (const int bits : {8192, 8193}) {
    SplineModel model = cubes(1, Rational::power_of_two(bits - 1));
    model.entities.pop_back();
    const std::string bytes = bytes_of(model, SplineFormat::kJson);
    const Certified found = certified(bytes, "m.vjson");
    EXPECT_EQ(found.verdict, Verdict::kValid);
    EXPECT_EQ(found.copy.has_value(), bits == 8193);
    EXPECT_EQ(are_clamped_volumes(model), bits == 8192);
    bool is_refused = false;
    try {
      ::read_volumes(bytes, "vjson");
    } catch (const ::Refused&) {
      is_refused = true;
    }
    EXPECT_EQ(is_refused, bits == 8193);
  }
}

TEST(Attributes, OfFewerThanThreeCoordinatesThereAreNone) {
  SplineModel model = cubes(0, 0);
  const KnotAxis<Rational> axis{1, {0, 0, 1, 1}};
  model.entities.push_back(
      {ExactVolume({axis, axis, axis}, 2, false, std::vector<Rational>(16)), {}, {}, {}});
  const Certified found = certified(bytes_of(model, SplineFormat::kJson), "m.vjson");
  EXPECT_EQ(found.verdict, Verdict::kUndecided);
  ASSERT_FALSE(found.findings.empty());
  EXPECT_EQ(found.findings[0].code, "not-covered");
  EXPECT_NE(found.findings[0].message.find("entity 2"), std::string::npos)
      << found.findings[0].message;
}

TEST(Attributes, MoreThanItdHoldsAreNamed) {
  const SplineModel model = cubes(7, 0);
  const std::string bytes = bytes_of(model, SplineFormat::kItd);
  const SplineLoss loss = spline_loss(model, SplineFormat::kItd, bytes, ReadLimits{});
  ASSERT_TRUE(loss.unreadable);
  EXPECT_NE(loss.unreadable->message.find("entity 0 has 10 coordinates"), std::string::npos)
      << loss.unreadable->message;
  const std::string other = bytes_of(model, SplineFormat::kG2);
  const SplineLoss none = spline_loss(model, SplineFormat::kG2, other, ReadLimits{});
  EXPECT_FALSE(none.unreadable);
  EXPECT_TRUE(none.shapes.empty());
}

}  // namespace
}  // namespace veritope
