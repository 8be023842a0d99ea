// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/star_box_statement.h: the part of statements that claims about patches share. Internal to
// verify/format.
#pragma once
#include "verify/format/byte_stream.h"
#include "verify/format/star_box_certificate.h"
#include "verify/format/statement_writer.h"

namespace veritope::certificate::internal {

void write(ByteWriter& w, const WalkPath& path);

/// The keys that all claims based on star boxes have; the caller may add more. `bytes`: the whole
/// body.
StatementWriter state_star_boxes(const Subject& subject, std::string_view claim,
                                 const StarBoxQuantities& quantities, const StarBoxBody& body,
                                 const Bytes& bytes);

}  // namespace veritope::certificate::internal
