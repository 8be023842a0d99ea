# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claims mesh-valid-1 and mesh-invalid-1 (docs/certificates/mesh.md) and mesh-reversed-1
(docs/certificates/mesh-reversed.md)."""
