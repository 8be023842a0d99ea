// SPDX-License-Identifier: LGPL-3.0-or-later
// io/splines/write_splines.h: spline models as files, and what a file would lose.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "io/base/read_limits.h"
#include "io/splines/spline_format.h"
#include "io/splines/spline_model.h"
#include "robust/base/result.h"

namespace veritope {

/// The formats that are written: itd, g2, vjson.
bool can_write(SplineFormat format);

/// Canonical: equal models give equal bytes. Numbers that a format's decimals cannot hold, shapes, groups and
/// attributes that it does not know are left out or rounded to the nearest binary64; spline_loss says which.
/// What .itd and .g2 hold reads back within `limits`: a number whose decimal needs more digits is rounded.
/// REQUIRES can_write(format).
std::string spline_bytes(const SplineModel& model, SplineFormat format,
                         const ReadLimits& limits = {});

/// What reading spline_bytes(model, format, limits) back would change, a sentence each: the bytes are read within these
/// limits (max_bytes apart) and compared.
struct SplineLoss {
  std::vector<std::string>
      shapes;  ///< lost or rounded shapes: a conversion with any of these is lossy
  std::vector<std::string>
      dropped;  ///< names, attributes, order of groups: not part of the geometry
  /// Set if the rounded numbers make no spline, no spline is left, or the bytes exceed a limit: this file must not be
  /// written.
  std::optional<Error> unreadable;
};
SplineLoss spline_loss(const SplineModel& model, SplineFormat format, const std::string& bytes,
                       const ReadLimits& limits = {});

/// The three writers.
std::string itd_bytes(const SplineModel& model, const ReadLimits& limits = {});
std::string g2_bytes(const SplineModel& model, const ReadLimits& limits = {});
std::string spline_json_bytes(const SplineModel& model);

/// An exact decimal within the limits if there is one, else the nearest binary64 in the shortest decimal; beyond
/// binary64 17 digits or more, cut.
std::string decimal_or_nearest(const Rational& value, const ReadLimits& limits = {});

/// A name that .itd can hold as one word, and an attribute that it reads back as it is.
bool is_itd_name(const std::string& name);
bool is_itd_attribute(const std::string& text);

}  // namespace veritope
