// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/cover_question.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "verify/certify/obstacle.h"
#include "verify/certify/patch_decision.h"
#include "verify/certify/piece_neighbours.h"

namespace veritope {

const char* const kOutOfRangeText =
    "the model lies too far from the origin for its size, or has parts of too different sizes: "
    "coordinates of boxes, in units of the least one, would have over 60 bits, or these units be "
    "out of range";

namespace {

using Why = UncoveredPiece::Why;

std::string text_of(Why why) {
  switch (why) {
    case Why::kNoCentres:
      return "no point pair sees all patches near this piece from both sides: a fold, a contact, a "
             "cusp, or a vertex whose normals lie in no open half-space";
    case Why::kCrossings:
      return "several sheets pass near this piece: a crossing, a contact, or a gap that is too "
             "small";
    case Why::kTooDeep:
      return "too many patches, or pieces of very different sizes, meet near this piece";
    case Why::kTooFine: return kOutOfRangeText;
    case Why::kBudget: return "the number of boxes that may be tried is spent";
    case Why::kMemory: return "the memory that the search may take is spent";
    case Why::kStopped: return "the search was stopped";
  }
  return "";
}

const char* code_of(Why why) {
  switch (why) {
    case Why::kBudget: return open_code::kBudget;
    case Why::kMemory: return open_code::kMemory;
    case Why::kTooFine: return open_code::kOutOfRange;
    default: return open_code::kNoStarBox;
  }
}

// Units become too short only where larger boxes failed, unless whole patches are too small.
std::string reason(const UncoveredPiece& piece) {
  if (piece.why != Why::kTooFine || !piece.above || *piece.above == Why::kTooFine)
    return text_of(piece.why);
  return text_of(*piece.above) +
         "; coordinates of smaller boxes, in units of the least one, would have over 60 bits";
}

// "40,000".
std::string with_commas(std::size_t n) {
  std::string out = std::to_string(n);
  for (std::size_t at = out.size(); at > 3; at -= 3) out.insert(at - 3, ",");
  return out;
}

std::string two_digits(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%#.2g", v);
  return text;
}

// Pieces with a common point of the surface are parts of one edge or fold, however small the distance of their middles.
bool is_gap(const PieceForest& forest, const UncoveredPiece& piece) {
  const auto& [own, other] = piece.facing;
  return piece.why != Why::kTooFine && own != PieceForest::kNone &&
         !are_neighbours(forest, own, other);
}

std::string angle_text(const UncoveredPiece& piece) {
  if (piece.least_cosine >= 0.99) return "";
  char text[80];
  std::snprintf(text, sizeof text, "; normals near it differ by up to %.0f degrees",
                std::acos(std::clamp(piece.least_cosine, -1.0, 1.0)) * 57.29577951308232);
  return text;
}

std::string tried_text(std::size_t tried) {
  return "; " + with_commas(tried) + (tried == 1 ? " box tried" : " boxes tried");
}

// A limit of the options ended the search: what it had done.
bool is_limit(Why why) { return why == Why::kBudget || why == Why::kMemory; }
std::string reached_text(const StarCover& cover) {
  return "; " + with_commas(cover.tried) + " boxes were tried, and " +
         with_commas(cover.boxes.size()) + " are proved";
}

std::string gap_text(double distance) {
  return distance > 0 ? "two sheets run approximately " + two_digits(distance) + " apart here"
                      : "two sheets meet here, or their distance is too small to be told from 0";
}

}  // namespace

PatchPart part_of_piece(const PieceForest& forest, PieceForest::Id piece) {
  const PieceForest::Node& node = forest.node(piece);
  const PieceForest::Form& form = forest.form(node.patch);
  PatchPart out;
  out.patch = node.patch;
  const auto add = [&](std::uint64_t i, int bits) {
    out.parameters.push_back(
        {std::ldexp(static_cast<double>(i), -bits), std::ldexp(static_cast<double>(i + 1), -bits)});
  };
  if (!form.shape.is_triangle) {
    add(node.i, form.root_bits[0] + node.level);
    add(node.j, form.root_bits[1] + node.level);
    return out;
  }
  const std::uint64_t down = node.is_upside_down ? 1 : 0;
  const std::uint64_t sum = (std::uint64_t{1} << node.level) - 1 + 2 * down;
  for (const std::uint64_t i : {sum - node.i - node.j, node.i, node.j}) add(i - down, node.level);
  return out;
}

CoverQuestion cover_question(PieceForest& forest, const StarCover& cover) {
  const UncoveredPiece& piece = cover.uncovered.front();
  const PieceForest::Node node = forest.node(piece.piece);
  CoverQuestion out;
  out.finding.code = code_of(piece.why);
  out.finding.place.patch = node.patch;
  out.finding.place.shell = forest.complex().shell(node.patch);
  out.finding.place.box = forest.in_model(node.hull);
  const bool is_spent = is_limit(piece.why);
  const std::string tried = is_spent ? reached_text(cover) : tried_text(cover.tried);
  if (!is_gap(forest, piece)) {
    out.finding.message = reason(piece) + tried + (is_spent ? "" : angle_text(piece));
    return out;
  }
  const double distance = gap_in_model(forest, piece.facing[0], piece.facing[1]);
  out.finding.witness.approx_distance = distance;
  out.finding.message =
      (is_spent ? text_of(piece.why) + "; " : "") + gap_text(distance) + tried + angle_text(piece);
  for (const PieceForest::Id id : piece.facing) out.facing.push_back(part_of_piece(forest, id));
  return out;
}

}  // namespace veritope
