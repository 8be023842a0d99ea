// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/kept_copy.h: the models that certify --certificate kept beside certificates.
#pragma once
#include <string>

namespace veritope::cli {

/// Whether the file is the copy that certify kept beside a certificate: its name is that of the certificate followed by
/// the format of a copy (part.cert.vjson beside part.cert), and the certificate speaks of exactly its bytes. The answer
/// is no for a file that was changed since, and for one that merely has such a name.
bool is_kept_copy(const std::string& path);

}  // namespace veritope::cli
