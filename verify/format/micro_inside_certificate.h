// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/micro_inside_certificate.h: the certificate of a microstructure inside a solid as plain data, and its
// encoding. The page: docs/certificates/micro-inside.md. Integers and bytes only; nothing here decides anything.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "verify/format/mesh_certificate.h"
#include "verify/format/micro_certificate.h"
#include "verify/format/star_box_certificate.h"

namespace veritope::certificate {

inline constexpr std::string_view kMicroInsideClaim = "micro-inside-1";
inline constexpr std::string_view kMicroInsideMagic = "VTIM";

/// A point behind a void of the model, in the parameters of a volume.
struct VoidEntry {
  std::uint32_t volume = 0;
  std::array<Fraction, 3> x;
  std::uint8_t corner = 8;  ///< of its cell; 8: that cell is empty
};
struct MicroInsideBody {
  MicroBody structure;  ///< about the microstructure
  /// A body of mesh-valid-1, or of star-box-2, about the model.
  std::variant<ValidBody, StarBoxBody> solid;
  std::vector<VoidEntry> voids;
};

/// What the statement says of the model, and of the bridges' ends.
struct InsideStatement {
  std::string sha256;  ///< 64 lower-case hexadecimal digits
  std::uint64_t bytes = 0;
  std::string format;  ///< "stl", "obj", "ply" or "off", or a format of splines
  std::string reading_rule;
  bool as_indexed = false;
  std::string skin = "-";  ///< a rational number; "-": no bridges
};

Bytes encode(const MicroInsideBody& body);
/// The whole certificate. `subject.reading_rule` and `subject.as_indexed` are not used.
Bytes encode(const Subject& subject, const MicroQuantities& quantities,
             const InsideStatement& model, const MicroInsideBody& body);
namespace internal {
std::optional<MicroInsideBody> read_micro_inside(ByteReader r);
}  // namespace internal

}  // namespace veritope::certificate
