// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/dms_render.h: the part of veritope render that draws simplex-spline solids.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/model_view.h"
#include "cli/option_set.h"
#include "render/dms_rays.h"
#include "render/transfer_function.h"
#include "report/render_report.h"

namespace veritope::cli {

enum class DmsMode { kXray, kVolume, kSlice, kIso };
std::string mode_name(DmsMode mode);  ///< "xray"

struct DmsRenderOptions {
  std::optional<DmsMode> mode;
  std::optional<std::string> attribute;
  std::optional<DmsSlicePlane> plane;
  std::optional<std::vector<TransferNode>> transfer;
  std::optional<std::array<double, 2>> range;
  std::optional<Rational> level, within;
  std::optional<bool> in_domain;
  std::optional<double> absorption, step;
  std::optional<std::uint32_t> isolines;
};

/// --mode and its options, which its line of the help names.
void declare_dms_render(OptionSet& set, DmsRenderOptions& options);
/// The first option of --mode and its options that is given; empty: none.
std::string dms_render_option(const DmsRenderOptions& options);
/// What is wrong with the options together, or nothing. A model without --mode may have --attribute, which is drawn by
/// colours.
std::string dms_render_contradiction(const DmsRenderOptions& options);
/// The sides of a picture without --size.
std::array<std::size_t, 2> dms_picture_size(const DmsRenderOptions& options);

/// Whether rays and planes are in the solid: then its map must be certified.
bool is_in_solid(const DmsRenderOptions& options);

struct DmsDrawing {
  ModelView view;  ///< without bytes if nothing can be drawn: then there is a doubt
  report::DmsPicture facts;
  std::string doubt;  ///< what is not decided; empty: nothing
};
/// Pictures of all modes but kIso.
/// REQUIRES a model without defects, and a certified one if is_in_solid; options that do not contradict each other.
/// @error kBadArgument for an attribute that the model lacks, and as the functions of render/
Result<DmsDrawing> draw_dms(const DmsModel& model, const DmsRenderOptions& options,
                            const PictureOptions& look);

/// The boundary if there is no mode, or the surface of kIso; files for viewers, too.
/// @error likewise, and as find_dms_iso
Result<DmsDrawing> draw_dms_surface(const DmsModel& model, const DmsRenderOptions& options,
                                    ViewKind kind, const PictureOptions& look);

}  // namespace veritope::cli
