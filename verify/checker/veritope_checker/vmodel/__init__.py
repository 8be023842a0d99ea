# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claims vmodel-1 (docs/certificates/vmodel.md) and vmodel-invalid-1 (docs/certificates/vmodel-invalid.md)."""
