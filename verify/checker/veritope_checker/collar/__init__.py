# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claims collar-1 and collar-2 (docs/certificates/collar.md, collar-2.md)."""
