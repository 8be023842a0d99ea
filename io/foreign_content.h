// SPDX-License-Identifier: LGPL-3.0-or-later
// io/base/foreign_content.h: what the first bytes of a file say that no reader of ours takes.
#pragma once
#include <optional>

#include "io/base/source.h"

namespace veritope {

/// kEmpty or kForeignFormat with the name of what it is, whatever the format asked for; else nothing.
std::optional<Error> refuse_foreign(const Source& source);

/// A guess for messages, never for decisions: text of two bytes a character without a mark.
bool looks_like_utf16(const Source& source);

}  // namespace veritope
