# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The two ways in which a pair of model and certificate fails."""


class Refused(Exception):
    """The reading rule refuses the model: exit 4."""

class Reject(Exception):
    """A condition of the certificate pages fails: exit 1."""

    def __init__(self, condition, why):
        super().__init__(condition, why)
        self.condition, self.why = condition, why
