# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Vectors of three exact numbers."""

def sub(a, b):
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]

def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]

def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
