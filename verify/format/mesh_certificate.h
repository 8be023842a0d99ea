// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/mesh_certificate.h: the certificates about meshes, version 1, as plain data; their encoding and a text
// dump. The pages: docs/certificates/mesh.md, mesh-reversed.md. Integers and bytes only; nothing here decides anything.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace veritope::certificate {

using Bytes = std::vector<unsigned char>;

inline constexpr std::string_view kFormatName = "veritope-certificate-1";
inline constexpr std::string_view kValidClaim = "mesh-valid-1";
inline constexpr std::string_view kInvalidClaim = "mesh-invalid-1";
inline constexpr std::string_view kReversedClaim = "mesh-reversed-1";
inline constexpr std::string_view kValidMagic = "VTMV", kInvalidMagic = "VTMI",
                                  kReversedMagic = "VTMR";

/// The file that a certificate speaks about, and how it was read.
struct Subject {
  std::string sha256;  ///< 64 lower-case hex digits
  std::uint64_t bytes = 0;
  std::string format;  ///< "stl", "obj", "ply", "off"
  bool as_indexed = false;
  std::string reading_rule;  ///< the rule's text
  std::string tool;          ///< the program that wrote the certificate
};

/// What a valid certificate states beside its claim.
struct Quantities {
  std::uint64_t vertices = 0, edges = 0, faces = 0, shells = 0, bodies = 0, genus = 0;
  std::string volume;  ///< "p/q"
};

/// A separating direction for the pair of nodes that is met as number `index` (step 3 of the walk).
struct Separator {
  std::uint64_t index = 0;
  std::array<std::int32_t, 3> direction{};
};

/// The body of mesh-valid-1; see section 3 of the page.
struct ValidBody {
  std::uint32_t num_vertex_ids = 0;
  std::vector<std::uint32_t> order;
  std::vector<std::uint8_t> stars;
  std::vector<std::array<std::int32_t, 3>> star_vectors;
  std::vector<Separator> separators;  ///< indices ascend
  std::vector<std::uint8_t> codes;
  std::vector<std::uint8_t> nesting;
};

/// The body of mesh-reversed-1: which triangles are reversed, and what shows that the others and these bound a solid.
struct ReversedBody {
  Bytes
      reversed;  ///< bit f mod 8 of byte f / 8: triangle f is reversed; as many bytes as the triangles need
  ValidBody solid;
};

/// A natural number, least significant byte first, last byte not zero.
using Natural = std::vector<unsigned char>;

/// One witness of mesh-invalid-1. Which fields are used depends on the rule; see section 7 of the page.
struct Witness {
  std::uint8_t rule = 0;  ///< 1..9
  std::uint32_t first = 0,
                second = 0;        ///< faces (1, 2, 7; 8, 9: first), vertices (3, 4, 5; 6: first)
  std::uint8_t axis = 0;           ///< 8, 9
  std::array<Natural, 6> weights;  ///< 7: of the first face, then of the second
};

struct InvalidBody {
  std::uint32_t num_faces = 0, num_vertex_ids = 0;
  std::vector<Witness> witnesses;  ///< rules ascend, at least one
};

Bytes encode(const ValidBody& body);
Bytes encode(const InvalidBody& body);
/// REQUIRES body.reversed to have a bit for each triangle of body.solid.order.
Bytes encode(const ReversedBody& body);

/// A whole certificate: statement, line feed, body.
Bytes encode(const Subject& subject, const Quantities& quantities, const ValidBody& body);
Bytes encode(const Subject& subject, const InvalidBody& body);
/// @param reversed_shells  shells all of whose triangles are reversed
Bytes encode(const Subject& subject, const Quantities& quantities, const ReversedBody& body,
             std::uint64_t reversed_shells);

/// A decoded certificate: exactly one of the bodies.
struct Certificate {
  std::string statement;  ///< the line of JSON
  std::optional<ValidBody> valid{};
  std::optional<InvalidBody> invalid{};
  std::optional<ReversedBody> reversed{};
};

/// Decodes the layout alone: neither the statement's values nor the claim are examined. Counts are compared with the
/// bytes left before anything is allocated. @return nothing, and a sentence in `why`, if the bytes are no certificate.
std::optional<Certificate> decode(std::span<const unsigned char> bytes, std::string& why);

/// A text that a person can read: the statement, key by key, then the body; lists longer than `max_items` are cut, and
/// say so.
std::string explain(const Certificate& certificate, std::size_t max_items);
std::string explain(const ValidBody& body, std::string_view claim, std::size_t max_items);
std::string explain(const InvalidBody& body, std::string_view claim, std::size_t max_items);
std::string explain(const ReversedBody& body, std::string_view claim, std::size_t max_items);

namespace internal {
class ByteReader;
/// A whole body, with its magic.
std::optional<ValidBody> read_valid(ByteReader body);
std::optional<InvalidBody> read_invalid(ByteReader body);
std::optional<ReversedBody> read_reversed(ByteReader body);
}  // namespace internal

}  // namespace veritope::certificate
