# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The parts that every claim needs."""
