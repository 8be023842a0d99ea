# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claim collar-1 (docs/certificates/collar.md)."""
