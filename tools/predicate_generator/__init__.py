# SPDX-License-Identifier: LGPL-3.0-or-later
"""Makes a predicate from its formula; tools/generate_predicates.py is the program."""
