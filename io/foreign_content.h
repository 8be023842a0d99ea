// SPDX-License-Identifier: LGPL-3.0-or-later
// io/foreign_content.h: contents that are known by name and that no reader of ours takes.
#pragma once
#include <optional>
#include <string>

#include "io/base/source.h"

namespace veritope {

/// kEmpty or kForeignFormat with the name of what it is, whatever the format asked for; else nothing. These are
/// contents that the reading rule (docs/certificates/reading-rule-1.md) refuses in every format: packed data and wide
/// characters.
std::optional<Error> refuse_foreign(const Source& source);

/// "a STEP file", "a glTF file", ...: formats of models that are not read yet; empty if it is none of them. Asked only
/// if the content is none of the formats that are read, so that it never takes a file away from a reader.
std::string unread_format(const Source& source);

/// A guess for messages, never for decisions: text of two bytes a character without a mark.
bool looks_like_utf16(const Source& source);

}  // namespace veritope
