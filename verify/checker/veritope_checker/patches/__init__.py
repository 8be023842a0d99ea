# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claims star-box-1, star-box-turned-1 (docs/certificates/star-box.md), star-box-2, star-box-turned-2
(docs/certificates/star-box-2.md), patch-invalid-1 (docs/certificates/patch-invalid.md) and patch-invalid-2
(docs/certificates/patch-invalid-2.md)."""
