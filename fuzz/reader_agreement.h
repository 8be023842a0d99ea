// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/reader_agreement.h: the kernel's readers and the C++ checker's, which share no code, must read the same mesh
// from any bytes.
#pragma once
#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include "io/read_model.h"
#include "robust/base/check.h"
#include "verify/checker/mesh/mesh.h"

namespace veritope::fuzz {

/// The model that the checker reads; nothing if it refuses.
inline std::optional<::Model> model_of_checker(const std::string& bytes, MeshFormat format,
                                               bool as_indexed) {
  try {
    return ::read_model(bytes, mesh_format_name(format), as_indexed);
  } catch (const ::Refused&) {
    return std::nullopt;
  }
}

/// The checker's keys: integers in the order of the coordinates.
inline std::int64_t checker_key(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  constexpr std::uint64_t kSign = std::uint64_t{1} << 63;
  return (bits & kSign) != 0 ? -static_cast<std::int64_t>(bits & ~kSign)
                             : static_cast<std::int64_t>(bits);
}

/// Law 5. The checker has no limits for numbers, so they are lifted here; files over another limit are not compared.
inline void check_agreement(MeshFormat format, std::span<const std::uint8_t> bytes) {
  const std::string text(bytes.begin(), bytes.end());
  for (const bool as_indexed : {false, true}) {
    ModelReadOptions options;
    options.format = format;
    options.as_indexed = as_indexed;
    options.limits.max_digits = std::numeric_limits<std::uint32_t>::max();
    options.limits.max_exponent = std::numeric_limits<std::uint32_t>::max();
    const Result<MeshFile> file = read_mesh_bytes(bytes, "fuzz", options);
    if (!file && file.error().code == Code::kOverLimit) continue;
    const std::optional<::Model> model = model_of_checker(text, format, as_indexed);
    VT_CHECK(file.has_value() == model.has_value(),
             file ? "the checker refuses what we read" : "the checker reads what we refuse");
    if (!file) continue;
    const TriangleMesh& mesh = file.value().mesh;
    VT_CHECK(model->faces() == mesh.faces.size() && model->vertices() == mesh.positions.size(),
             "the checker reads other numbers");
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
      for (int axis = 0; axis < 3; ++axis)
        VT_CHECK(model->key[3 * v + static_cast<std::size_t>(axis)] ==
                     checker_key(mesh.positions[v][axis]),
                 "the checker reads another coordinate");
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i)
        VT_CHECK(model->tri[3 * f + i] == mesh.faces[f][i], "the checker reads another triangle");
  }
}

}  // namespace veritope::fuzz
