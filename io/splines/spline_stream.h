// SPDX-License-Identifier: LGPL-3.0-or-later
// io/splines/spline_stream.h: spline files that are written in parts, for models that are too large for one string.
#pragma once
#include <string>
#include <vector>

#include "io/splines/write_splines.h"

namespace veritope {

/// The file of a model with these groups is begin(), the texts of its parts that have entities, separator() between
/// neighbours, and end(): the bytes of spline_bytes(model, format). Several threads may make texts.
/// REQUIRES .vjson or .itd; of .itd, all entities of a group in one part.
class SplineStream {
 public:
  explicit SplineStream(SplineFormat format, std::vector<SplineGroup> groups = {});

  const std::string& begin() const { return begin_; }
  /// The text of some entities, neighbours in the model. REQUIRES at least one, whose groups are those of the stream.
  std::string part(std::vector<SplineEntity> entities) const;
  const std::string& separator() const { return separator_; }
  const std::string& end() const { return end_; }

 private:
  SplineFormat format_;
  std::vector<SplineGroup> groups_;
  std::string begin_, separator_, end_;
};

}  // namespace veritope
