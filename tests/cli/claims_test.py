# SPDX-License-Identifier: LGPL-3.0-or-later
"""Every claim that the checkers decide is certified through the command line, and both accept the certificate."""
import sys
import unittest

from support import BIN, CHECKER_PY, ROOT, Folder

sys.path.insert(0, str(ROOT / "tests" / "support"))
from every_claim import assert_every_claim                # noqa: E402


class Claims(Folder):
    def test_both_checkers_accept_a_certificate_of_every_claim(self):
        assert_every_claim(self, BIN / "veritope", [(BIN / "veritope-check",), (sys.executable, CHECKER_PY)], self.folder)


if __name__ == "__main__":
    unittest.main()
