// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/kept_copy.h: the models that certify --certificate kept beside certificates.
#pragma once
#include <optional>
#include <string>

namespace veritope::cli {

/// The SHA-256 of a file that looks like a copy that certify kept beside a certificate: its name is that of the
/// certificate followed by the format of a copy (part.cert.vjson beside part.cert), and the certificate speaks of
/// exactly its bytes. Nothing for other files. Whoever leaves such a file out must know that a model with this copy was
/// certified: the two files alone may have been put there by anybody.
std::optional<std::string> kept_copy_sha256(const std::string& path);

}  // namespace veritope::cli
