// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/stand_in.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include "io/read_model.h"
#include "io/splines/patch_model.h"
#include "io/splines/volume_faces.h"
#include "io/splines/volumes.h"
#include "io/splines/write_splines.h"
#include "robust/base/entity_error.h"
#include "solids/vmodel/v_faces.h"
#include "solids/vmodel/v_model.h"

namespace veritope {
namespace {

// How many entities of each kind a model has.
struct Content {
  std::uint64_t surfaces = 0, triangles = 0, volumes = 0;       // in space
  std::uint64_t plane = 0, curves = 0, trimmed = 0, other = 0;  // plane: surfaces and triangles

  explicit Content(const SplineModel& model) {
    for (const SplineEntity& entity : model.entities)
      std::visit([&](const auto& s) { add(s); }, entity.shape);
  }
  bool has_patches() const { return surfaces + triangles != 0; }
  bool is_all_in_space() const { return plane + curves + trimmed + other == 0; }

 private:
  void add(const ExactCurve&) { ++curves; }
  void add(const ExactSurface& s) { ++(s.dimension() == 3 ? surfaces : plane); }
  void add(const ExactTriangle& t) { ++(t.dimension() == 3 ? triangles : plane); }
  void add(const ExactVolume& v) { ++(v.dimension() >= 3 ? volumes : other); }
  void add(const TrimmedSurface&) { ++trimmed; }
  void add(const SplineBrep& brep) { trimmed += brep.faces.size(); }
};

std::string counted(std::uint64_t n, const std::string& noun) {
  return std::to_string(n) + " " + noun + (n == 1 ? "" : "s");
}
// "3 curves and 1 surface".
std::string joined(const std::vector<std::string>& parts) {
  std::string out;
  for (std::size_t i = 0; i < parts.size(); ++i)
    out += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  return out;
}

constexpr std::uint32_t kMostDigits = 1'000'000;

// "7 surfaces", "5 surfaces and 2 triangles".
std::string patches_text(const Content& c) {
  std::vector<std::string> parts;
  if (c.surfaces != 0) parts.push_back(counted(c.surfaces, "surface"));
  if (c.triangles != 0) parts.push_back(counted(c.triangles, "triangle"));
  return joined(parts);
}

bool has_left_out_shapes(const SplineFile& file) {
  for (const LeftOut& l : file.left_out)
    if (l.is_geometry) return true;
  return false;
}
// The first entity that is a volume with fewer than three coordinates. REQUIRES one.
std::size_t first_flat_volume(const SplineModel& model) {
  const auto at =
      std::find_if(model.entities.begin(), model.entities.end(), [](const SplineEntity& e) {
        const auto* const volume = std::get_if<ExactVolume>(&e.shape);
        return volume != nullptr && volume->dimension() < 3;
      });
  return static_cast<std::size_t>(at - model.entities.begin());
}
// The first entity that is no volume with at least three coordinates.
std::size_t first_other(const SplineModel& model) {
  const auto at =
      std::find_if(model.entities.begin(), model.entities.end(), [](const SplineEntity& e) {
        const auto* const volume = std::get_if<ExactVolume>(&e.shape);
        return volume == nullptr || volume->dimension() < 3;
      });
  return static_cast<std::size_t>(at - model.entities.begin());
}
std::string faces_text(std::uint64_t faces, std::uint64_t volumes, std::uint64_t flat) {
  std::string out =
      "the " + counted(faces, "boundary face") + " of its " + counted(volumes, "volume");
  if (flat != 0) out += ", without " + counted(flat, "face") + (flat == 1 ? " that has" : " that have") + " no area";
  return out;
}

// A volume whose hands at the corners and in the middle differ folds, and does not say which side of its faces is
// outside.
std::optional<Error> folded_volume(const SplineModel& model, const VolumeFaces& pieces) {
  for (std::uint64_t e = 0; e < model.entities.size(); ++e) {
    const std::optional<Sign> hand =
        hand_at_corners(std::get<ExactVolume>(model.entities[e].shape));
    const bool is_mirrored = std::binary_search(pieces.mirrored.begin(), pieces.mirrored.end(), e);
    if (hand && (*hand == Sign::kZero || (*hand == Sign::kNegative) == is_mirrored)) continue;
    return error_at_entity(
        Code::kBadArgument, e,
        "the volume is folded: its map keeps the orientation of space in some "
        "places and reverses it in others, and does not say which side of its faces is "
        "outside");
  }
  return std::nullopt;
}

// Patches of a degree over kMaxPatchDegree have no certificate, and a volume of such a degree has such faces.
std::optional<Error> too_high_degree(const SplineModel& model) {
  constexpr std::array<const char*, 3> kParameters = {"u", "v", "w"};
  for (std::uint64_t e = 0; e < model.entities.size(); ++e) {
    const auto& volume = std::get<ExactVolume>(model.entities[e].shape);
    for (std::size_t a = 0; a < 3; ++a)
      if (const int degree = volume.axis(a).degree; degree > kMaxPatchDegree)
        return error_at_entity(Code::kOverLimit, e,
                               "the volume has the degree " + std::to_string(degree) + " along " +
                                   kParameters[a] + ", and certificates are about patches of a " +
                                   "degree of at most " + std::to_string(kMaxPatchDegree));
  }
  return std::nullopt;
}

// The file with its boundary faces as its model; nothing if there is no rule for it, or if the rule finds other faces
// than these.
std::optional<StandIn> in_own_bytes(const SplineFile& file, const VolumeFaces& pieces) {
  if (!is_read_by_checkers(file)) return std::nullopt;
  Result<BoundaryFaces> faces = boundary_faces(file.model);
  if (!faces || !have_same_pieces(*faces, pieces.patches)) return std::nullopt;
  StandIn out;
  out.is_of_volumes = true;
  out.what = faces_text(faces->faces.size(), file.model.entities.size(), faces->num_flat);
  out.faces = std::move(faces->faces);
  out.file.model = std::move(faces->model);
  out.file.format = file.format;
  out.file.bytes = file.bytes;
  out.file.sha256 = file.sha256;
  out.file.beyond_default_limits = file.beyond_default_limits;
  return out;
}

// The border of the V-model, if it glues faces that neither the rule nor equal pieces show to be walls: those whose
// knots differ.
std::optional<VFaces> smaller_border(const SplineModel& model,
                                     const std::vector<VolumeFace>& faces) {
  std::vector<VVolume> cells;
  for (const SplineEntity& e : model.entities) cells.push_back(std::get<ExactVolume>(e.shape));
  const Result<VModel> made = make_v_model(std::move(cells), VOrientation::kAuto);
  if (!made || !made->forbidden().empty()) return std::nullopt;
  VFaces border = border_of(*made);
  const std::vector<VFaceNumber> known = whole_faces(faces);
  const bool is_smaller =
      !border.faces.empty() && border.faces.size() < known.size() &&
      std::includes(known.begin(), known.end(), border.faces.begin(), border.faces.end());
  return is_smaller ? std::optional(std::move(border)) : std::nullopt;
}

void take_border(VFaces border, const SplineModel& volumes, StandIn& out) {
  SplineModel surfaces;
  for (std::size_t i = 0; i < border.faces.size(); ++i) {
    const VFaceNumber f = border.faces[i];
    const std::size_t axis = f % 6 / 2, end = f % 2;
    const auto& across = std::get<ExactVolume>(volumes.entities[f / 6].shape).axis(axis);
    out.faces.push_back(
        {f / 6, axis, end, border.axes[i], end == 0 ? across.domain_begin() : across.domain_end()});
    surfaces.entities.push_back({std::move(border.surfaces[i]), {}, {}, {}});
  }
  out.what = faces_text(border.faces.size(), volumes.entities.size(), 0);
  out.bytes = spline_json_bytes(surfaces);
}

// The place in the user's file of a place in the copy: its lines are not those of the file.
Place place_in_file(const Place& in_copy, const StandIn& copy, const SplineFile& file) {
  if (file.beyond_default_limits) return file.beyond_default_limits->place;
  Place out;
  if (in_copy.entity)
    out.entity = copy.faces.empty() ? *in_copy.entity : copy.faces[*in_copy.entity].volume;
  return out;
}

}  // namespace

std::vector<VFaceNumber> whole_faces(const std::vector<VolumeFace>& faces) {
  std::vector<VFaceNumber> out;
  for (const VolumeFace& f : faces)
    out.push_back(static_cast<VFaceNumber>(6 * f.volume + 2 * f.axis + f.end));
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

SplineFile without_attributes(const SplineFile& file) {
  SplineFile out = file;
  out.model = without_attributes(file.model);
  out.has_converted_shapes =
      out.has_converted_shapes ||
      (are_clamped_volumes(out.model) && !are_clamped_volumes(file.model));
  return out;
}

bool is_read_by_checkers(const SplineFile& file) {
  return file.format != SplineFormat::kGismo && !file.has_converted_shapes;
}

std::optional<std::string> uncovered_shapes(const SplineFile& file) {
  std::vector<std::string> left_out;
  for (const LeftOut& l : file.left_out)
    if (l.is_geometry) left_out.push_back(l.what + " (" + std::to_string(l.count) + ")");
  if (!left_out.empty())
    return "shapes of the file are not read: " + joined(left_out) +
           "; a verdict without them would be about another model";
  const Content c(file.model);
  if (c.trimmed != 0)
    return "trimmed surfaces are not decided: the file has " + std::to_string(c.trimmed) +
           " of them" + "; export its faces untrimmed, or as a mesh";
  if (c.volumes != 0 && c.other != 0)
    return "entity " + std::to_string(first_other(file.model)) +
           " is a volume with fewer than three coordinates: cells of a solid need three";
  if (c.volumes != 0 && (c.has_patches() || !c.is_all_in_space()))
    return "the file has " + counted(c.volumes, "volume") + " and other shapes (entity " +
           std::to_string(first_other(file.model)) +
           " is the first), and does not say which of them bound the solid: veritope convert "
           "--faces --lossy FILE OUT.vjson writes the boundary faces of the volumes alone";
  if (c.is_all_in_space()) return std::nullopt;
  std::vector<std::string> parts;
  if (c.curves != 0) parts.push_back(counted(c.curves, "curve"));
  if (c.plane != 0)
    parts.push_back(std::to_string(c.plane) + (c.plane == 1 ? " patch" : " patches") +
                    " of the plane");
  if (c.other != 0)
    parts.push_back(std::to_string(c.other) + (c.other == 1 ? " volume" : " volumes") +
                    " with fewer than three coordinates (entity " +
                    std::to_string(first_flat_volume(file.model)) +
                    (c.other == 1 ? ")" : " is the first)"));
  if (!c.has_patches()) return "the file has " + joined(parts) + ": such shapes bound no solid";
  return "beside " + patches_text(c) + " the file has " + joined(parts) +
         ": such shapes are no part of a boundary";
}

Result<std::optional<StandIn>> stand_in_of(const SplineFile& file) {
  if (has_attributes(file.model)) return stand_in_of(without_attributes(file));
  const Content c(file.model);
  const bool has_volumes = c.volumes != 0;
  if (has_left_out_shapes(file) || uncovered_shapes(file) || file.model.entities.empty())
    return std::optional<StandIn>();
  if (!has_volumes && is_read_by_checkers(file)) return std::optional<StandIn>();
  StandIn out;
  out.is_of_volumes = has_volumes;
  if (has_volumes) {
    if (auto over = too_high_degree(file.model)) return std::move(*over);
    Result<VolumeFaces> faces = volume_faces(file.model);
    if (!faces) return faces.error();
    if (auto folded = folded_volume(file.model, *faces)) return std::move(*folded);
    std::optional<StandIn> own = in_own_bytes(file, *faces);
    if (auto border = smaller_border(file.model, own ? own->faces : faces->places)) {
      take_border(std::move(*border), file.model, out);
    } else if (own) {
      return own;
    } else {
      out.what = faces_text(faces->patches.size(), c.volumes, faces->num_flat);
      out.bytes = spline_json_bytes(model_of(faces->patches));
      out.faces = std::move(faces->places);
    }
  } else {
    out.what = "its " + patches_text(c);
    out.bytes = spline_json_bytes(file.model);
  }
  ModelReadOptions wide;  // numbers that certificates cannot speak of are found there, and named
  wide.limits.max_digits = wide.limits.max_exponent = kMostDigits;
  Result<SplineFile> read = read_spline_bytes(
      {reinterpret_cast<const unsigned char*>(out.bytes.data()), out.bytes.size()}, "copy.vjson",
      wide);
  if (!read) return read.error();
  out.file = std::move(*read);
  if (auto& beyond = out.file.beyond_default_limits)
    beyond->place = place_in_file(beyond->place, out, file);
  return std::optional<StandIn>(std::move(out));
}

Result<FilePatches> patches_of(const SplineFile& file, const std::optional<StandIn>& stand_in) {
  if (!stand_in) return file_patches(file.model, PatchOrientation::kKeep);
  return file_patches(stand_in->file.model, PatchOrientation::kKeep, stand_in->faces);
}

}  // namespace veritope
