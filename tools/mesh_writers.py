# SPDX-License-Identifier: LGPL-3.0-or-later
"""Meshes as text and bytes of each format, for tools/make_models.py."""
import struct


def number(value):
    return str(int(value)) if value == int(value) and abs(value) < 1e15 else repr(float(value))


def row(values):
    return " ".join(map(number, values))


def off(mesh, head="OFF"):
    lines = [head, f"{len(mesh.vertices)} {len(mesh.faces)} 0", *map(row, mesh.vertices)]
    return "\n".join(lines + [f"{len(f)} {row(f)}" for f in mesh.faces] + [""]).encode()


def obj(mesh):
    lines = ["v " + row(v) for v in mesh.vertices] + ["f " + row(i + 1 for i in f) for f in mesh.faces]
    return "\n".join(lines + [""]).encode()


def stl_ascii(mesh, name="model", word=str):
    lines = [word("solid ") + name]
    for f in mesh.faces:
        lines += [word("facet normal 0 0 0"),
                  word(" outer loop"), *(word("  vertex ") + row(mesh.vertices[v]) for v in f)]
        lines += [word(" endloop"), word("endfacet")]
    return "\n".join(lines + [word("endsolid ") + name, ""]).encode()


def stl_binary(mesh, header=b"veritope", announced=None):
    data = header.ljust(80, b"\0") + struct.pack("<I", len(mesh.faces) if announced is None else announced)
    for f in mesh.faces:
        data += struct.pack("<12fH", 0, 0, 0, *(c for v in f for c in mesh.vertices[v]), 7)
    return data


def ply_header(form, real, mesh, face_element="face"):
    lines = ["ply", f"format {form} 1.0", "comment made by tools/make_models.py",
             f"element vertex {len(mesh.vertices)}",
             *(f"property {real} {axis}" for axis in "xyz"), f"element {face_element} {len(mesh.faces)}",
             "property list uchar int vertex_indices", "end_header", ""]
    return "\n".join(lines).encode()


def ply_ascii(mesh, **how):
    lines = [*map(row, mesh.vertices), *(f"{len(f)} {row(f)}" for f in mesh.faces), ""]
    return ply_header("ascii", "double", mesh, **how) + "\n".join(lines).encode()


def ply_binary(mesh, order, real):
    data = ply_header("binary_big_endian" if order == ">" else "binary_little_endian", real, mesh)
    for v in mesh.vertices:
        data += struct.pack(order + 3 * real[0], *v)
    for f in mesh.faces:
        data += struct.pack(f"{order}B{len(f)}i", len(f), *f)
    return data
