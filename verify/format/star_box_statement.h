// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/star_box_statement.h: what the claims about patches write alike. Internal to verify/format.
#pragma once
#include "verify/format/byte_stream.h"
#include "verify/format/star_box_certificate.h"
#include "verify/format/statement_writer.h"

namespace veritope::certificate::internal {

void write(ByteWriter& w, const WalkPath& path);

/// The keys that all claims on top of star boxes have; more may follow. `bytes`: the whole body.
StatementWriter state_star_boxes(const Subject& subject, std::string_view claim,
                                 const StarBoxQuantities& quantities, const StarBoxBody& body,
                                 const Bytes& bytes);

}  // namespace veritope::certificate::internal
