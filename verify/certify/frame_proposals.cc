// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/frame_proposals.h"

#include <algorithm>
#include <cmath>

#include "verify/certify/piece_samples.h"
#include "verify/certify/sheet_tangents_internal.h"

namespace veritope {
namespace {

using Id = PieceForest::Id;
using internal::cross;
using internal::dot;
using internal::length_of;

constexpr std::size_t kMostFrames = 8;
// A frame that was made for another piece serves this one if its box is thicker by no more than this.
constexpr double kThicker = 1.05, kSameDirection = 0x1p-24;
// The sine of the least angle of a crease, and the cosine from which its faces count as perpendicular.
constexpr double kLeastCrease = 0.5, kRightAngle = 0.999;

// The vector scaled to unit length; nothing if it has no direction in doubles.
std::optional<Point3d> direction(const Point3d& a) {
  const double length = length_of(a);
  if (!(length > 1e-150) || !std::isfinite(length)) return std::nullopt;
  return Point3d{a[0] / length, a[1] / length, a[2] / length};
}

// Whether the frames differ only by the rounding of normals.
bool are_near(const BoxFrame& a, const BoxFrame& b) {
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t k = 0; k < 3; ++k)
      if (std::abs(a.rows()[r][k] - b.rows()[r][k]) > 4) return false;
  return true;
}

// The sine of the angle between the normals of two frames, approximately.
double turn(const SearchFrame& a, const SearchFrame& b) {
  return length_of(cross(a.rows[2], b.rows[2]));
}
// Whether no side of `hull` is much longer than that of `own`.
bool is_as_thin(const Box3d& hull, const Box3d& own) {
  const double least = kSameDirection * extent(own);
  for (std::size_t k = 0; k < 3; ++k)
    if (!(hull.hi[k] - hull.lo[k] <= kThicker * (own.hi[k] - own.lo[k]) + least)) return false;
  return true;
}

}  // namespace

Box3d SearchFrame::in_lengths(const Box3d& in_frame) const {
  Box3d out;
  for (std::size_t k = 0; k < 3; ++k)
    out.lo[k] = in_frame.lo[k] / unit[k], out.hi[k] = in_frame.hi[k] / unit[k];
  return out;
}
Box3d SearchFrame::in_frame(const Box3d& in_lengths) const {
  Box3d out;
  for (std::size_t k = 0; k < 3; ++k)
    out.lo[k] = in_lengths.lo[k] * unit[k], out.hi[k] = in_lengths.hi[k] * unit[k];
  return out;
}

std::optional<Point3d> FrameProposals::unit_normal(Id piece) {
  return direction(metric_.image_of_normal(forest_.approx_normal(piece)));
}

std::optional<SearchFrame> FrameProposals::with_rows(const std::array<Point3d, 3>& rows) const {
  BoxFrame::Rows entries;
  SearchFrame out;
  out.rows = rows;
  for (std::size_t r = 0; r < 3; ++r) {
    const Point3d row = metric_.row_of_image(rows[r]);
    out.unit[r] = kRowLength / length_of(row);
    if (!std::isfinite(out.unit[r])) return std::nullopt;
    for (std::size_t k = 0; k < 3; ++k) entries[r][k] = std::llrint(out.unit[r] * row[k]);
  }
  const auto frame = BoxFrame::make(entries);
  if (!frame) return std::nullopt;
  out.frame = *frame;
  return out;
}

std::optional<SearchFrame> FrameProposals::own(Id piece) {
  const auto normal = unit_normal(piece);
  if (!normal) return std::nullopt;
  Point3d along = metric_.image(longest_chord(forest_, piece, metric_));
  const double part = dot(along, *normal);
  for (std::size_t k = 0; k < 3; ++k) along[k] -= part * (*normal)[k];
  const auto tangent = direction(along);
  if (!tangent) return std::nullopt;
  return with_rows({*tangent, cross(*normal, *tangent), *normal});
}

std::optional<PieceFrame> FrameProposals::with_hull(Id piece, const SearchFrame& frame) {
  const Box3d hull = frame.in_lengths(hull_in_frame(forest_, piece, frame.frame));
  if (!std::isfinite(extent(hull)) || !(extent(hull) > 0)) return std::nullopt;
  return PieceFrame{frame, hull};
}

void FrameProposals::keep(const SearchFrame& frame) {
  if (frames_.size() == kMostFrames) frames_.erase(frames_.begin());
  frames_.push_back(frame);
}

std::optional<PieceFrame> FrameProposals::along(Id piece) {
  const auto frame = own(piece);
  if (!frame) return std::nullopt;
  auto out = with_hull(piece, *frame);
  if (!out) return std::nullopt;
  const double height = out->hull.hi[2] - out->hull.lo[2];
  const double most_turn = kThicker * (height / extent(out->hull)) + kSameDirection;
  for (auto used = frames_.end(); used != frames_.begin();) {
    if (!(turn(*--used, *frame) <= most_turn)) continue;
    const Box3d hull = used->in_lengths(hull_in_frame(forest_, piece, used->frame));
    if (!is_as_thin(hull, out->hull)) continue;
    out = PieceFrame{*used, hull};
    std::rotate(used, used + 1, frames_.end());
    return out;
  }
  keep(*frame);
  return out;
}

std::optional<Point3d> FrameProposals::normal_across_crease(Id piece,
                                                            const std::vector<Id>& around) {
  const auto normal = unit_normal(piece);
  if (!normal) return std::nullopt;
  std::optional<Point3d> out;
  double most = kLeastCrease;
  for (const Id id : around) {
    const auto other = unit_normal(id);
    if (!other) continue;
    const double sine = length_of(cross(*normal, *other));
    if (sine > most) most = sine, out = other;
  }
  return out;
}

std::optional<PieceFrame> FrameProposals::along_crease(Id piece, const Point3d& other_normal,
                                                       const PieceFrame& plain) {
  for (std::size_t r = 0; r < 2; ++r)
    if (std::abs(dot(other_normal, plain.rows[r])) > kRightAngle) return std::nullopt;
  const auto normal = unit_normal(piece);
  const auto crease = normal ? direction(cross(*normal, other_normal)) : std::nullopt;
  if (!crease) return std::nullopt;
  auto frame = with_rows({*crease, other_normal, *normal});
  if (!frame) return std::nullopt;
  const auto known = std::find_if(frames_.begin(), frames_.end(), [&](const SearchFrame& f) {
    return are_near(f.frame, frame->frame);
  });
  if (known == frames_.end())
    keep(*frame);
  else
    frame = *known;
  return with_hull(piece, *frame);
}

}  // namespace veritope
