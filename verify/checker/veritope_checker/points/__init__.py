# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claim points-1 (docs/certificates/points.md)."""
