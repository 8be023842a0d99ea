// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/spline_stream.h"

#include <utility>

#include "robust/base/check.h"

namespace veritope {

SplineStream::SplineStream(SplineFormat format, std::vector<SplineGroup> groups)
    : format_(format), groups_(std::move(groups)) {
  VT_CHECK(format == SplineFormat::kJson || format == SplineFormat::kItd,
           "a stream of splines is .vjson or .itd");
  if (format == SplineFormat::kItd) return;  // entities follow each other without anything between
  end_ = "]}\n";
  separator_ = ",\n ";
  begin_ = spline_json_bytes({groups_, {}});
  VT_CHECK(begin_.ends_with(end_), "an empty model has an empty list of entities");
  begin_.resize(begin_.size() - end_.size());
}

std::string SplineStream::part(std::vector<SplineEntity> entities) const {
  VT_CHECK(!entities.empty(), "a part has entities");
  const std::string whole = spline_bytes({groups_, std::move(entities)}, format_);
  return whole.substr(begin_.size(), whole.size() - begin_.size() - end_.size());
}

}  // namespace veritope
