// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/file_patches.h"

#include <algorithm>
#include <utility>

#include "io/splines/patch_model.h"
#include "robust/base/check.h"
#include "solids/patches/patch_sides.h"
#include "splines/knot_insertion.h"
#include "verify/certify/entity_parts.h"
#include "verify/certify/patch_collar.h"

namespace veritope {
namespace {

// The number of boxes that may be tried in a collar's plain frame for each box in the frame that fits the model.
constexpr std::size_t kBoxesInPlainFrame = 16, kFreeBoxes = 256;

// Whether the pieces on both sides of break number `at` of an axis agree along it.
bool is_broken_at(const PatchSource& source, const PatchEntity& entity, std::size_t axis,
                  std::size_t at) {
  const std::size_t columns = entity.breaks[1].size() - 1;
  const std::size_t others = entity.breaks[1 - axis].size() - 1;
  for (std::size_t k = 0; k < others; ++k) {
    const auto piece = [&](std::size_t i) -> const Patch& {
      return source.patches[entity.first_patch + (axis == 0 ? i * columns + k : k * columns + i)];
    };
    // The side where the parameter is greatest, and the one where it is least.
    const auto before = piece(at - 1).side(axis == 0 ? 1 : 2);
    const auto after = piece(at).side(axis == 0 ? 3 : 0);
    if (!(directed_form(before) == run_backwards(directed_form(after)))) return true;
  }
  return false;
}

void put_torn_knots(const ExactSurface& surface, std::uint64_t number, const PatchSource& source,
                    std::vector<TornKnot>& out) {
  const PatchEntity& entity = source.entities[number];
  TornKnot knot;
  knot.entity = number;
  for (std::size_t a = 0; a < 2; ++a)
    knot.domain[a] = {round_down(entity.breaks[a].front()), round_up(entity.breaks[a].back())};
  for (knot.axis = 0; knot.axis < 2; ++knot.axis) {
    const auto& breaks = entity.breaks[knot.axis];
    const auto& axis = surface.axis(knot.axis);
    for (std::size_t i = 1; i + 1 < breaks.size(); ++i) {
      if (multiplicity(axis, breaks[i]) <= axis.degree) continue;
      knot.at = breaks[i];
      knot.is_broken = is_broken_at(source, entity, knot.axis, i);
      out.push_back(knot);
    }
  }
}

std::size_t end_of(const FilePatches& patches, std::size_t entity) {
  return entity + 1 < patches.entities.size() ? patches.entities[entity + 1].first_patch
                                              : patches.complex->patches().size();
}

// Notes which entities are reversed, and the first one of which only a part is: certificates
// reverse whole entities.
void note_reversed(FilePatches& patches) {
  std::vector<bool> is_reversed(patches.complex->patches().size());
  for (const std::uint32_t p : patches.complex->reversed()) is_reversed[p] = true;
  for (std::size_t e = 0; e < patches.entities.size(); ++e) {
    StarBoxEntity& entity = patches.entities[e];
    const std::size_t first = entity.first_patch, last = end_of(patches, e);
    entity.is_reversed = first < last && is_reversed[first];
    for (std::size_t p = first; p < last; ++p)
      if (is_reversed[p] != entity.is_reversed && !patches.mixed_entity) patches.mixed_entity = e;
  }
}

PatchDecisionOptions with_outer_sides(const FilePatches& patches, PatchDecisionOptions options) {
  // Outer sides are known only of whole entities; without a list all sides count as outer.
  if (!patches.mixed_entity)
    options.outer = outer_sides(patches.entities, patches.complex->patches().size());
  return options;
}

FileDecision decide_in_frame(const FilePatches& patches, const PatchDecisionOptions& options) {
  FileDecision out;
  out.decision = decide_patches(*patches.complex, options, &out.forest);
  return out;
}

FileDecision decide_once(const FilePatches& patches, const FileDecisionOptions& wanted) {
  PatchDecisionOptions options = with_outer_sides(patches, wanted.search);
  options.in_plain_frame = wanted.frame == FrameWanted::kPlain;
  options.with_frames = wanted.frame != FrameWanted::kPlain;
  FileDecision fitted = decide_in_frame(patches, options);
  if (wanted.frame != FrameWanted::kPlainIfCheap || !fitted.decision.is_valid ||
      !may_have_octree(*patches.complex))
    return fitted;
  if (fitted.forest->frame().is_plain() && !fitted.decision.cover.has_several_sheets())
    return fitted;
  options.in_plain_frame = true;
  options.with_frames = false;
  options.cover.max_boxes = std::min(
      options.cover.max_boxes, kBoxesInPlainFrame * (fitted.decision.boxes_tried + kFreeBoxes));
  FileDecision plain = decide_in_frame(patches, options);
  return plain.decision.is_valid ? std::move(plain) : std::move(fitted);
}

// "open-side: edge u = 0, w = 1 of entity 4".
std::string named(const PatchFinding& defect, const EntityParts& parts) {
  constexpr std::size_t kMostNamed = 3;
  const bool is_of_patches = defect.defect == PatchDefect::kRepeatedPatch ||
                             defect.defect == PatchDefect::kWeight ||
                             defect.defect == PatchDefect::kDegree;
  std::string out = defect_name(defect.defect);
  for (std::size_t i = 0; i < std::min(kMostNamed, defect.sides.size()); ++i)
    out += (i == 0 ? ": " : ", ") +
           (is_of_patches ? parts.name_of(defect.sides[i].patch) : parts.name_of(defect.sides[i]));
  return defect.sides.size() > kMostNamed ? out + ", ..." : out;
}

// The shells whose normals point the wrong way, ascending: winding numbers are needed to find them.
std::vector<std::uint32_t> wrong_shells(const ShellWalks& walks) {
  if (walks.walks.empty() || !walks.missing.empty()) return {};
  return shells_to_reverse(walks);
}

// Reverses the entities of these shells; each entity lies in one shell.
void turn(FilePatches& patches, const std::vector<std::uint32_t>& shells) {
  std::vector<std::uint64_t> entities;
  for (std::size_t e = 0; e < patches.entities.size(); ++e) {
    const std::size_t first = patches.entities[e].first_patch;
    if (first == end_of(patches, e)) continue;
    if (std::binary_search(shells.begin(), shells.end(),
                           patches.complex->shell(static_cast<std::uint32_t>(first))))
      entities.push_back(e);
  }
  reverse_entities(patches, entities);
}

}  // namespace

void reverse_entities(FilePatches& patches, std::span<const std::uint64_t> entities) {
  std::vector<Patch> oriented(patches.complex->patches().begin(), patches.complex->patches().end());
  for (const std::uint64_t e : entities) {
    StarBoxEntity& entity = patches.entities[e];
    entity.is_reversed = !entity.is_reversed;
    const std::size_t last = end_of(patches, e);
    for (std::size_t p = entity.first_patch; p < last; ++p) oriented[p] = reversed(oriented[p]);
  }
  patches.complex = std::make_unique<PatchComplex>(make_patch_complex(std::move(oriented)).value());
}

std::vector<std::uint64_t> FilePatches::reversed() const {
  std::vector<std::uint64_t> out;
  for (std::size_t e = 0; e < entities.size(); ++e)
    if (entities[e].is_reversed) out.push_back(e);
  return out;
}

Result<FilePatches> file_patches(const SplineModel& model, PatchOrientation orientation,
                                 std::span<const VolumeFace> faces) {
  VT_CHECK(faces.empty() || faces.size() == model.entities.size(), "a place for each face");
  Result<PatchSource> source = patch_source(model);
  if (!source) return source.error();
  FilePatches out;
  if (!source->foreign.empty()) {
    out.not_covered.emplace();
    out.not_covered->code = "not-covered";
    out.not_covered->place.parts.push_back({*source->foreign.front().place.entity, {}, {}});
    out.not_covered->message = "patches are surfaces and triangles in space; this file has " +
                               to_string(source->foreign.front());
    return out;
  }
  if (source->patches.empty())
    return Error{Code::kEmpty, {}, "there is no surface and no triangle in this file"};
  for (std::size_t e = 0; e < source->entities.size(); ++e) {
    const auto* const surface = std::get_if<ExactSurface>(&model.entities[e].shape);
    if (surface != nullptr) put_torn_knots(*surface, e, *source, out.torn);
    out.entities.push_back({surface != nullptr, false,
                            static_cast<std::uint32_t>(source->entities[e].first_patch),
                            std::move(source->entities[e].breaks)});
    if (!faces.empty()) out.entities.back().face = faces[e];
  }
  Result<PatchComplex> complex = make_patch_complex(std::move(source->patches), orientation);
  if (!complex) return complex.error();
  out.complex = std::make_unique<PatchComplex>(std::move(*complex));
  note_reversed(out);
  return out;
}

std::optional<std::string> open_faces_text(const FilePatches& patches) {
  const PatchComplex& complex = *patches.complex;
  if (!patches.entities.front().face || complex.is_closed_oriented_surface()) return std::nullopt;
  const auto findings = complex.findings();
  const auto first = std::find_if(findings.begin(), findings.end(), [](const PatchFinding& f) {
    return f.defect != PatchDefect::kAdjacentPoles;
  });
  VT_CHECK(first != findings.end(), "what is no surface has a defect");
  return kNoSurfaceText + ("; " + named(*first, EntityParts(complex, patches.entities)));
}

FileDecision decide_file_patches(FilePatches& patches, const FileDecisionOptions& options) {
  VT_CHECK(patches.complex != nullptr, "a file without patches is not decided");
  FileDecision out = decide_once(patches, options);
  if (out.decision.open)
    if (auto text = open_faces_text(patches)) out.decision.open->message = std::move(*text);
  if (!options.may_turn_shells || patches.mixed_entity) return out;
  const std::vector<std::uint32_t> shells = wrong_shells(out.decision.walks);
  if (shells.empty()) return out;
  out = {};  // its forest refers to the complex
  turn(patches, shells);
  return decide_once(patches, options);
}

certificate::Subject subject_of(const SplineFile& file, const std::string& tool, bool by_faces) {
  certificate::Subject out;
  out.sha256 = file.sha256;
  out.bytes = file.bytes;
  out.format = std::string(spline_format_name(file.format)) + (by_faces ? "-faces" : "");
  out.tool = tool;
  return out;
}

certificate::Bytes make_patch_certificate(const FilePatches& patches, const FileDecision& decided,
                                          const certificate::Subject& subject) {
  return make_patch_certificate(*patches.complex, decided.forest, decided.decision,
                                patches.entities, subject);
}

}  // namespace veritope
