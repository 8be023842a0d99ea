// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/patch_certificate_text.h: certificates about spline models (star-box-1, star-box-turned-1, collar-1,
// patch-invalid-1) as text. The pages: docs/certificates/star-box.md, collar.md, patch-invalid.md.
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace veritope::certificate {

/// Does the statement make one of the four claims? Nothing else is looked at.
bool is_patch_certificate(std::span<const unsigned char> bytes);

/// A text that a person can read: the statement, key by key, then a summary of the body; lists longer than `max_items` are cut, and
/// say so. The layout alone is looked at: nothing is checked. A body does not say which entities are surfaces; their number is the
/// greatest one with which the body is complete and has the patches that are stated.
/// @return nothing, and a sentence in `why`, if there is no such number. Counts are compared with the bytes left; memory is linear
/// in the bytes. @cost one pass, and one more for each number of surfaces that is tried in vain.
std::optional<std::string> explain_patch_certificate(std::span<const unsigned char> bytes,
                                                     std::size_t max_items, std::string& why);

}  // namespace veritope::certificate
