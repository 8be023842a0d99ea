// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/star_box_certificate.h: the star-box certificate, versions 1 and 2, as plain data, and its encoding.
// The pages: docs/certificates/star-box.md and star-box-2.md. Integers and bytes only; nothing here decides anything.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "verify/format/patch_entities.h"

namespace veritope::certificate {

inline constexpr std::string_view kStarBoxClaim = "star-box-1";
inline constexpr std::string_view kReversedShellClaim = "star-box-turned-1";
inline constexpr std::string_view kStarBoxMagic = "VTSB";  ///< of collar-1, too
inline constexpr std::string_view kStarBox2Claim = "star-box-2";
inline constexpr std::string_view kReversedShell2Claim = "star-box-turned-2";
inline constexpr std::string_view kStarBox2Magic = "VTS2";  ///< of collar-2, too

/// The rows of the matrix A of boxes {x : l <= A x <= h}. Frame 0 of a body is the unit matrix and is not stored.
struct StarFrame {
  std::array<std::array<std::int64_t, 3>, 3> rows{};
};
/// c- and c+ in units of 2^(exponent + point_shift).
struct StarSheet {
  std::array<std::int64_t, 3> inside{}, outside{};
  std::vector<std::uint8_t> signs;  ///< of the box's separators: 0 none, 1 plus, 2 minus
};
/// A polynomial of degree 1 to 3, with 4, 10 or 20 coefficients, of y1^a y2^b y3^c, c fastest: y = (x - o) /
/// 2^(exponent + point_shift + shift), where o is c- of the first sheet.
struct StarSeparator {
  std::uint8_t degree = 1;
  std::int64_t shift = 0;
  std::vector<std::int64_t> coefficients;
};
/// A box, in units of 2^(exponent + shift), where exponent is the body's.
struct StarBoxItem {
  bool is_mesh = false;  ///< then there are no sheets
  std::uint64_t shift = 0;
  std::array<std::int64_t, 3> low{};
  std::array<std::uint64_t, 3> size{};
  std::uint64_t point_shift = 0;  ///< version 1: equals shift
  std::vector<StarSheet> sheets;  ///< version 1: one
  std::uint64_t frame = 0;        ///< this and the separators: version 2 only
  std::vector<StarSeparator> separators;
};

/// Symbols in preorder: kSplit, or the leaf's box.
inline constexpr std::int64_t kSplit = -1;

struct WalkPoint {
  std::uint64_t shift = 0;
  std::array<std::int64_t, 3> at{};
};
/// What follows the first point of a polyline.
struct WalkPath {
  std::vector<WalkPoint> points;
  std::uint8_t end = 0;  ///< 0..5: to infinity along +x -x +y -y +z -z; 6: to a box
  std::uint64_t end_box = 0;
  bool ends_outside = false;
};
struct StarWalk {
  std::uint64_t box = 0;
  bool starts_outside = true;
  WalkPath path;
};

struct StarBoxBody {
  int version = 1;  ///< 1 or 2
  std::vector<PatchEntity> entities;
  std::vector<std::array<std::uint8_t, 2>> roots;  ///< a, b of each patch
  std::int64_t exponent = 0;
  std::vector<StarFrame> frames;  ///< from the first one on; version 2 only
  std::vector<StarBoxItem> boxes;
  std::vector<std::int64_t> trees;  ///< the trees of all roots of all patches, one after the other
  std::vector<StarWalk> walks;
};

/// What a star-box certificate states beside its claim.
struct StarBoxQuantities {
  std::uint64_t patches = 0, edges = 0, vertices = 0, shells = 0, bodies = 0, genus = 0;
};

Bytes encode(const StarBoxBody& body);
/// The whole certificate. `subject.reading_rule` and `as_indexed` are not used.
/// @param winding nothing: the claim is kStarBoxClaim or kStarBox2Claim, by the body's version; else
/// kReversedShellClaim or kReversedShell2Claim, and this is the winding number of the last walk's inner side
Bytes encode(const Subject& subject, const StarBoxQuantities& quantities, const StarBoxBody& body,
             std::optional<std::int64_t> winding = {});

namespace internal {
class ByteReader;
/// Reads what follows the entities in a body of `out.version` with this many patches.
void read(ByteReader& r, std::uint64_t patches, StarBoxBody& out);
/// A whole body of version 2, which needs neither its statement nor its model.
std::optional<StarBoxBody> read_star_box_2(ByteReader r);
WalkPath read_path(ByteReader& r);
/// The levels of the leaves of all trees, in order.
std::vector<std::uint8_t> leaf_levels(const StarBoxBody& body);
}  // namespace internal

}  // namespace veritope::certificate
