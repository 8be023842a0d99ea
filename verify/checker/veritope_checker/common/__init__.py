# SPDX-License-Identifier: Apache-2.0 OR MIT
"""What every claim needs."""
