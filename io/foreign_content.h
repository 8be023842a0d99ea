// SPDX-License-Identifier: LGPL-3.0-or-later
// io/foreign_content.h: contents that we recognise by name, but that none of our readers reads.
#pragma once
#include <optional>
#include <string>

#include "io/base/source.h"

namespace veritope {

/// kEmpty, or kForeignFormat with the name of the content, whatever format was requested; otherwise nothing. These are
/// the contents that the reading rule (docs/certificates/reading-rule-1.md) refuses in every format: packed data and
/// wide characters.
std::optional<Error> refuse_foreign(const Source& source);

/// "a STEP file", "a glTF file", ...: a format of models that is not read yet; empty for other contents. Call it only
/// if the content is in none of the formats that are read, so that it never takes a file away from a reader.
std::string unread_format(const Source& source);

/// A guess for messages, never for decisions: text of two bytes a character without a mark.
bool looks_like_utf16(const Source& source);

/// "it looks like binary data: byte 7 is 0", for a file that a reader of text refused; empty for what may be text.
std::string binary_guess(const Source& source);

}  // namespace veritope
