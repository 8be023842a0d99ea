# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claims ball-1 and ball-invalid-1."""
