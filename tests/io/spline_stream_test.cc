// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/spline_stream.h"

#include <gtest/gtest.h>

#include "splines/bspline_pieces.h"

namespace veritope {
namespace {

SplineEntity surface(int number) {
  BezierSurface<Rational> map({1, 2}, 3, false);
  for (std::size_t n = 0; n < map.coefficients().size(); ++n)
    map.coefficients()[n] = Rational(static_cast<std::int64_t>(n) * number) / Rational(3);
  return {to_bspline(map), {}, std::nullopt, {}};
}

TEST(SplineStream, PartsAreTheBytesOfTheWholeModel) {
  for (const SplineFormat format : {SplineFormat::kJson, SplineFormat::kItd}) {
    const SplineStream stream(format);
    SplineModel whole;
    EXPECT_EQ(stream.begin() + stream.end(),
              format == SplineFormat::kItd ? "" : spline_bytes(whole, format));
    std::string text = stream.begin();
    for (int part = 1; part <= 3; ++part) {
      SplineModel entities;
      for (int n = 0; n < part; ++n) entities.entities.push_back(surface(10 * part + n));
      if (part > 1) text += stream.separator();
      text += stream.part(entities.entities);
      whole.entities.insert(whole.entities.end(), entities.entities.begin(),
                            entities.entities.end());
      EXPECT_EQ(text + stream.end(), spline_bytes(whole, format));
    }
  }
}

TEST(SplineStream, PartsMayBeInGroups) {
  for (const SplineFormat format : {SplineFormat::kJson, SplineFormat::kItd}) {
    SplineModel whole;
    whole.groups = {{"bridges", {}, std::nullopt}, {"others", {}, std::nullopt}};
    const SplineStream stream(format, whole.groups);
    std::string text = stream.begin();
    for (std::size_t part = 0; part < 3; ++part) {
      std::vector<SplineEntity> entities;
      for (int n = 0; n < 3; ++n) {
        entities.push_back(surface(static_cast<int>(10 * part) + n));
        if (part > 0) entities.back().group = part - 1;
      }
      whole.entities.insert(whole.entities.end(), entities.begin(), entities.end());
      if (part > 0) text += stream.separator();
      text += stream.part(std::move(entities));
      EXPECT_EQ(text + stream.end(), spline_bytes(whole, format));
    }
  }
}

}  // namespace
}  // namespace veritope
