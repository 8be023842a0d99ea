// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/spline_laws.h: what the readers and writers of splines promise for any bytes.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "io/read_model.h"
#include "io/splines/write_splines.h"
#include "render/spline_view.h"
#include "robust/base/check.h"

namespace veritope::fuzz {

inline std::span<const unsigned char> bytes_of(std::string_view text) {
  return {reinterpret_cast<const unsigned char*>(text.data()), text.size()};
}

/// An error has one of the promised codes, a line or a byte, and a sentence.
inline void check_refusal(const Error& error) {
  VT_CHECK(error.place.line || error.place.byte, "a refusal has a place");
  VT_CHECK(!error.message.empty(), "a refusal has a sentence");
  constexpr Code kPromised[] = {Code::kEmpty,           Code::kForeignFormat, Code::kUnknownFormat,
                                Code::kSyntax,          Code::kTruncated,     Code::kNotFinite,
                                Code::kIndexOutOfRange, Code::kOverLimit,     Code::kBadSpline};
  bool is_promised = false;
  for (const Code code : kPromised) is_promised = is_promised || code == error.code;
  VT_CHECK(is_promised, "a refusal has a promised code");
}

/// The JSON is canonical and gives the same model; the other writers' bytes can be read, unless spline_loss says why
/// not.
inline void check_writers(const SplineModel& model) {
  const std::string json = spline_json_bytes(model);
  ModelReadOptions options;
  options.format = SplineFormat::kJson;
  options.limits.max_digits = options.limits.max_exponent = ~std::uint32_t{0};
  const auto back = read_spline_bytes(bytes_of(json), "json", options);
  VT_CHECK(back.has_value() && back->model == model, "JSON holds every model");
  VT_CHECK(spline_json_bytes(back->model) == json, "JSON is canonical");
  for (const SplineFormat format : {SplineFormat::kItd, SplineFormat::kG2}) {
    const std::string bytes = spline_bytes(model, format);
    const SplineLoss loss = spline_loss(model, format, bytes);
    if (!loss.shapes.empty() || loss.unreadable || bytes.empty()) continue;
    options.format = format;
    const auto again = read_spline_bytes(bytes_of(bytes), "again", options);
    VT_CHECK(again.has_value() && again->model.entities.size() == model.entities.size(),
             "nothing is lost in silence");
    VT_CHECK(spline_bytes(again->model, format) == bytes,
             "what is written reads back as the same bytes");
  }
}

inline void check_spline_readers(std::span<const unsigned char> data) {
  for (const SplineFormat format : {SplineFormat::kItd, SplineFormat::kG2, SplineFormat::kMfem,
                                    SplineFormat::kGismo, SplineFormat::kJson}) {
    ModelReadOptions options;
    options.format = format;
    options.limits.max_digits = 100;
    options.limits.max_exponent = 400;
    const auto file = read_spline_bytes(data, "input", options);
    if (!file) {
      check_refusal(file.error());
      continue;
    }
    check_writers(file->model);
    if (data.size() < 2000) {
      ViewOptions view;
      view.chord = 0.25;
      for (const ViewFormat picture : {ViewFormat::kVtu, ViewFormat::kObj, ViewFormat::kGltf})
        (void)view_bytes(file->model, picture, view);
    }
  }
}

}  // namespace veritope::fuzz
