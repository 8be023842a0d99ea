// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/patch_certificate_text_internal.h: bodies about spline models as text, for the table in claims.h.
// Internal to verify/format.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include "verify/format/collar_certificate.h"
#include "verify/format/dms_certificate.h"
#include "verify/format/dms_invalid_certificate.h"
#include "verify/format/micro_certificate.h"
#include "verify/format/micro_inside_certificate.h"
#include "verify/format/patch_invalid_certificate.h"
#include "verify/format/patch_meeting_certificate.h"
#include "verify/format/vmodel_certificate.h"
#include "verify/format/vmodel_invalid_certificate.h"
#include "verify/format/volume_folded_certificate.h"

namespace veritope::certificate {

std::string explain(const StarBoxBody& body, std::string_view claim, std::size_t max_items);
std::string explain(const CollarBody& body, std::string_view claim, std::size_t max_items);
std::string explain(const PatchInvalidBody& body, std::string_view claim, std::size_t max_items);
std::string explain(const PatchMeetingBody& body, std::string_view claim, std::size_t max_items);
std::string explain(const VolumeFoldedBody& body, std::string_view claim, std::size_t max_items);
std::string explain(const VModelBody& body, std::string_view claim, std::size_t max_items);
std::string explain(const VModelInvalidBody& body, std::string_view claim, std::size_t max_items);
std::string explain(const DmsBody& body, std::string_view claim, std::size_t max_items);
std::string explain(const DmsPairsBody& body, std::string_view claim, std::size_t max_items);
std::string explain(const DmsInvalidBody& body, std::string_view claim, std::size_t max_items);
std::string explain(const MicroBody& body, std::string_view claim, std::size_t max_items);
std::string explain(const MicroInsideBody& body, std::string_view claim, std::size_t max_items);

}  // namespace veritope::certificate
