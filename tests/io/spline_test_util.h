// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/io/spline_test_util.h: spline files written as text in a test, and exact values.
#pragma once
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "io/read_model.h"
#include "splines/de_casteljau.h"
#include "splines/knot_insertion.h"
#include "tests/io/io_test_util.h"
#include "tests/support/paths.h"

namespace veritope::io_test {

inline Result<SplineFile> read_splines(SplineFormat format, std::string_view text,
                                       ModelReadOptions options = {}) {
  options.format = format;
  return read_spline_bytes(bytes(text), "model", options);
}

inline SplineModel model_of(SplineFormat format, std::string_view text) {
  auto file = read_splines(format, text);
  EXPECT_TRUE(file) << (file ? "" : to_string(file.error()));
  return file ? std::move(file->model) : SplineModel{};
}

inline std::string spline_folder() { return test::source_dir() + "/tests/models/splines/"; }

inline SplineFile sample(const std::string& name) {
  auto file = read_spline_file(spline_folder() + name, {});
  EXPECT_TRUE(file) << (file ? "" : to_string(file.error()));
  return file ? std::move(*file) : SplineFile{};
}

/// "code@line", "code@line#entity", or "ok".
inline std::string outcome(const Result<SplineFile>& file) {
  if (file) return "ok";
  const Place& place = file.error().place;
  std::string text = code_name(file.error().code);
  if (place.line) text += "@" + std::to_string(*place.line);
  if (place.entity) text += "#" + std::to_string(*place.entity);
  return text;
}

/// "p/q p/q ...": the point at fractions of the domain, weights divided out.
template <std::size_t N>
std::string exact_value(const BSpline<Rational, N>& s, const std::array<Rational, N>& fraction) {
  const auto cut = bezier_pieces(s);
  std::array<std::size_t, N> cell;
  std::array<Rational, N> t;
  for (std::size_t a = 0; a < N; ++a) {
    const auto& breaks = cut.breaks[a];
    const Rational u = breaks.front() + fraction[a] * (breaks.back() - breaks.front());
    cell[a] = 0;
    while (cell[a] + 2 < breaks.size() && breaks[cell[a] + 1] < u) ++cell[a];
    t[a] = (u - breaks[cell[a]]) / (breaks[cell[a] + 1] - breaks[cell[a]]);
  }
  const auto values = evaluate(cut.at(cell), t);
  std::string text;
  for (int c = 0; c < s.dimension(); ++c) {
    const Rational x = s.is_rational() ? values[static_cast<std::size_t>(c)] / values.back()
                                       : values[static_cast<std::size_t>(c)];
    text += (c == 0 ? "" : " ") + x.to_string();
  }
  return text;
}

}  // namespace veritope::io_test
