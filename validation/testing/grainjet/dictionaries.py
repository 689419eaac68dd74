# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of an OpenFOAM case: written, changed and read as text.

The mesh and the fields here are those of small cases: one block, ascii.
"""

import pathlib
import re

HEADER = "FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n"

# sides of a block and their vertices, in the order of blockMesh
SIDES = {"xlo": "(0 4 7 3)", "xhi": "(1 2 6 5)", "ylo": "(0 1 5 4)",
         "yhi": "(3 7 6 2)", "zlo": "(0 3 2 1)", "zhi": "(4 5 6 7)"}


def write(path, text, kind="dictionary"):
    """Write a file with its header, and the folder that it lies in."""
    path = pathlib.Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(HEADER.format(kind, path.name) + text + ("" if text.endswith("\n") else "\n"))


def write_all(folder, texts):
    """Write {path below the case: text}."""
    for path, text in texts.items():
        write(pathlib.Path(folder) / path, text)


def write_field(folder, name, dimensions, internal, boundary):
    """Write 0/<name>. dimensions: the powers of kg, m and s, as "0 1 -1", or all in brackets. internal: a value, as 0.1 or
    "(0 0 1)", or what comes behind internalField. boundary: the text between the braces, or {patch or
    pattern: entries}."""
    if not dimensions.startswith("["):
        dimensions = f"[{dimensions} 0 0 0 0]"
    text = str(internal)
    kind = "Vector" if "(" in text and "List<scalar>" not in text else "Scalar"
    if not text.startswith(("uniform", "nonuniform")):
        text = "uniform " + text
    if not isinstance(boundary, str):
        boundary = "\n".join((patch if patch.isidentifier() else f'"{patch}"') + f" {{ {lines} }}"
                             for patch, lines in boundary.items())
    write(pathlib.Path(folder) / "0" / name,
          f"dimensions {dimensions}; internalField {text};\nboundaryField\n{{\n{boundary}\n}}\n",
          f"vol{kind}Field")


def entries(values):
    """Lines `key value;` of {key: value}; None leaves an entry out, a dictionary in braces has no semicolon."""
    return "".join(f"{key} {value}{'' if str(value).startswith('{') else ';'}\n"
                   for key, value in values.items() if value is not None)


def vector(values):
    """(x y z) with all digits."""
    return "(" + " ".join(repr(float(v)) for v in values) + ")"


def nonuniform(values):
    """The values of a field behind internalField: numbers or rows of numbers, or their text."""
    rows = [v if isinstance(v, str) else vector(v) if hasattr(v, "__len__") else repr(v) for v in values]
    kind = "vector" if rows[0].startswith("(") else "scalar"
    return f"nonuniform List<{kind}> {len(rows)}\n(\n" + "\n".join(rows) + "\n)"


def block(low, high, cells, patches, scale=1):
    """blockMeshDict of one block. cells: "10 10 20"; patches: {name: (type and further entries, sides)}, as
    {"ends": ("patch", "zlo zhi")}."""
    (x, y, z), (X, Y, Z) = low, high
    corners = " ".join(f"({a} {b} {c})" for c in (z, Z) for a, b in ((x, y), (X, y), (X, Y), (x, Y)))
    boundary = "".join(f"{name} {{ type {kind}; faces ({' '.join(SIDES[side] for side in sides.split())}); }}\n"
                       for name, (kind, sides) in patches.items())
    return (f"scale {scale};\nvertices ({corners});\n"
            f"blocks (hex (0 1 2 3 4 5 6 7) ({cells}) simpleGrading (1 1 1));\nboundary ({boundary});\n")


def change(path, *pairs):
    """Replace texts in a file; each must be there."""
    path = pathlib.Path(path)
    text = path.read_text()
    for old, new in pairs:
        if old not in text:
            raise AssertionError(f"{path} does not hold: {old}\n{text[:3000]}")
        text = text.replace(old, new)
    path.write_text(text)


def put(path, **values):
    """Other values for entries of a file; each must be there once."""
    path = pathlib.Path(path)
    text = path.read_text()
    for name, value in values.items():
        text, found = re.subn(rf"(?m)((?:^|[;{{])[ \t]*{name}\s+)[^;{{}}]+;", rf"\g<1>{value};", text)
        if found != 1:
            raise AssertionError(f"{path}: {found} entries {name} instead of one")
    path.write_text(text)


def values(path):
    """{key: value} of the entries `key value;` that have a line of their own: numbers, lists of numbers, words."""
    def value(text):
        try:
            return [float(x) for x in text[1:-1].split()] if text[0] == "(" else float(text)
        except ValueError:
            return text
    return {name: value(stated) for name, stated in
            re.findall(r"(?m)^(\w+)\s+([^;\n]+);", pathlib.Path(path).read_text())}


def internal(path):
    """Internal field of an ascii field file as a list of floats or of tuples."""
    text = pathlib.Path(path).read_text()
    start = text.index("internalField")
    rest = text[start:text.index("boundaryField", start)]
    if "nonuniform" not in rest:
        return [_value(rest.split("uniform", 1)[1].split(";")[0])]
    count, body = re.search(r"List<\w+>\s*(\d+)\s*\((.*)\)", rest, re.S).groups()
    values = [_value(word) for word in re.findall(r"\([^()]*\)|[^\s()]+", body)]
    if len(values) != int(count):
        raise AssertionError(f"{path}: {len(values)} values instead of {count}")
    return values


def _value(word):
    word = word.strip()
    if word.startswith("("):
        return tuple(float(c) for c in word.strip("()").split())
    return float(word)


def cells(folder):
    """The number of cells of a mesh."""
    owner = (pathlib.Path(folder) / "constant/polyMesh/owner").read_text()
    return int(re.search(r"nCells:\s*(\d+)", owner)[1])
