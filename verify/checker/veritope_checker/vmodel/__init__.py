# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Certificates of V-models: docs/certificates/vmodel.md."""
