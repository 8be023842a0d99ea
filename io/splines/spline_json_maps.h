// SPDX-License-Identifier: LGPL-3.0-or-later
// io/splines/spline_json_maps.h: splines and triangles in our exact text form, docs/formats/spline-json.md. The
// readers of that form and of trees of volumes include it.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "io/splines/spline_json_lexer.h"

namespace veritope {

class SplineJsonMaps : protected SplineJsonLexer {
 protected:
  using SplineJsonLexer::SplineJsonLexer;

  /// A curve, a surface or a volume.
  template <std::size_t N>
  bool read_map(std::optional<BSpline<Rational, N>>& spline);
  bool read_triangle(std::optional<ExactTriangle>& triangle);
  /// Or null.
  bool read_optional_curve(std::optional<ExactCurve>& curve);

 private:
  struct RawNet {
    const char* at = nullptr;
    bool is_rational = false;
    std::int64_t components = 0;
    std::uint64_t num_points = 0;
    std::size_t per_point = 0;  // numbers in the first
    bool is_even = true;        // and in all others
    std::vector<Rational> points;
  };
  struct RawMap : RawNet {
    std::vector<std::int64_t> degrees;
    std::vector<bool> periodic;
    std::vector<std::vector<Rational>> knots;
  };
  bool read_points(RawNet& raw);
  bool check_components(const RawNet& raw);
  std::vector<Rational> take_coefficients(RawNet& raw);
  bool check_weights(const RawNet& raw, std::span<const Rational> weights);
  bool read_raw(RawMap& raw);
  template <std::size_t N>
  bool finish(RawMap& raw, std::optional<BSpline<Rational, N>>& spline);
};

}  // namespace veritope
