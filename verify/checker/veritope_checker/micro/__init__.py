# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claim microstructure-1 (docs/certificates/microstructure.md)."""
