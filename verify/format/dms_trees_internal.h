// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/dms_trees_internal.h: what the two versions of certificates of simplex-spline solids share: trees of
// leaves, parts that are star boxes, and the statement. Internal to verify/format.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verify/format/byte_stream.h"
#include "verify/format/dms_certificate.h"

namespace veritope::certificate::internal {

inline constexpr std::size_t kLeastBytesOfTree = 20;

void write_dms_trees(ByteWriter& w, const std::vector<DmsTreeProof>& trees);
std::vector<DmsTreeProof> read_dms_trees(ByteReader& r, std::size_t count);
/// A body of star-box-2 behind its length.
void write_dms_part(ByteWriter& w, const StarBoxBody& boxes);
std::optional<StarBoxBody> read_dms_part(ByteReader& r);
void append_dms_trees(std::string& out, const std::vector<DmsTreeProof>& trees,
                      std::size_t max_items);

/// The statement, with the number of patches or of faces under its name, and the body.
Bytes dms_certificate(const Subject& subject, std::string_view claim, const DmsQuantities& q,
                      const char* patches, const Bytes& body);

}  // namespace veritope::certificate::internal
