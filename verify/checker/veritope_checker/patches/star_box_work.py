# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Units of work (the ends of section 6 of star-box.md and star-box-2.md)."""
FREE_UNITS, UNITS_OF_BYTE = 1 << 23, 96
NODES_OF_UNIT = 32                      # of the hierarchy over the roots

def allowed(num_bytes):
    """num_bytes: of the model and the body."""
    return FREE_UNITS + UNITS_OF_BYTE * num_bytes

def bits_at(patch, level):
    p, q = patch.both_degrees
    return patch.bits + (p + q) * (level + max(patch.roots))

def count(patch, times):
    """The number of Bernstein coefficients in degrees that are this multiple of the patch's."""
    p, q = (times * n for n in patch.both_degrees)
    return (p + 1) * (q + 1) if patch.is_tensor else (p + 1) * (p + 2) // 2

def words_of(patch):
    """64 bits each, of four numbers for each control point: what dms-solid.md, D3, counts."""
    return count(patch, 1) * ((patch.bits + 15) // 16)

def of_hull(node):
    return 2 + (count(node.patch, 1) * sum(node.patch.both_degrees) * bits_at(node.patch, node.level) >> 12)

def of_half_curve(node):
    return 16 * of_hull(node)

def of_g(node):
    return 2 + (node.patch.num_g * sum(node.patch.both_degrees) * bits_at(node.patch, node.level) >> 11)

def of_s1(node):
    return 1 + (node.patch.num_g * bits_at(node.patch, node.level) >> 11)

def of_products(patch):
    """Once for each patch."""
    return 1 + (count(patch, 1) * count(patch, 2) * (2 + 2 * patch.bits // 64) ** 2 >> 6)

def of_composition(separator, node):
    d, patch = separator.degree, node.patch
    return 1 + (d * count(patch, 1) * count(patch, d - 1) * limbs(separator, node) ** 2 >> 7)

def of_quarter(separator, node):
    """The composition on the node from that on its parent."""
    p, q = (separator.degree * n for n in node.patch.both_degrees)
    return 2 + (count(node.patch, separator.degree) * (p + q if node.patch.is_tensor else p * p) >> 8)

def limbs(separator, node):
    return 2 + separator.degree * (bits_at(node.patch, node.level) + separator.length) // 64

def of_pair(p, q):
    """For two triangles of these patches in a mesh box."""
    return 4 + ((p.bits + q.bits) ** 2 >> 14)
