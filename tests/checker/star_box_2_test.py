#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The C++ checker of star-box certificates of version 2 against the Python one, whose tests it runs: same exit code, same condition."""
import unittest

import judges
import star_box_2_body_test as body
import star_box_2_flat_test as flat
import star_box_2_sheets_test as sheets
import star_box_2_test as sound
import star_box_2_turned_test as turned
import star_box_long_test as long

judges.judge(sound.vc)
SoundModels, Hostile, Body, Leaves = sound.SoundModels, sound.Hostile, body.Body, body.Leaves
Sheets, Walks, FlatPatches, Turned, LongNumbers = sheets.Sheets, sheets.Walks, flat.FlatPatches, turned.Turned, long.LongNumbers

if __name__ == "__main__":
    unittest.main()
