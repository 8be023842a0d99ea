# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The checker in Python: veritope_check.py beside this folder starts it. Each claim has a row in claims.py."""
