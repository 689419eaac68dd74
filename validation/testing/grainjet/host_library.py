# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Copies of the installed LIGGGHTS library that look like other builds of it.

A copy lies in a folder of its own under the name that programs ask for; LD_LIBRARY_PATH brings it
into a run. Its functions are unchanged, so whatever refuses it has read its stamp.
"""

import pathlib
import re
import shutil
import struct
import subprocess

from grainjet.programs import ENV, ROOT


def _linked():
    """Name and path of the library of the program liggghts in PATH, as the program asks for it."""
    found = subprocess.run(["bash", "-c", 'ldd "$(command -v liggghts)"'], check=True, stdout=subprocess.PIPE, text=True,
                           env=ENV)
    return re.search(r"(libliggghts\S*) => (\S+)", found.stdout).groups()


def installed():
    """The library of the program liggghts in PATH."""
    return pathlib.Path(_linked()[1]).resolve()


def _said(option):
    """What host-version prints of the LIGGGHTS that is built for."""
    return subprocess.run([ROOT / "liggghts-plugins/loader/host-version", option], check=True, stdout=subprocess.PIPE,
                          text=True, env=ENV).stdout.strip()


def part(option):
    """A part of the LIGGGHTS that is built for: -program, -library, -headers."""
    return pathlib.Path(_said(option))


def flags():
    """What is compiled with against it, as words."""
    return _said("-flags").split()


def sections(content):
    """{name: (offset of its header, its offset in the file, size)} of a 64-bit ELF file."""
    table, = struct.unpack_from("<Q", content, 0x28)
    size, number, names = struct.unpack_from("<HHH", content, 0x3A)
    headers = [(table + n * size, *struct.unpack_from("<IIQQQQ", content, table + n * size)) for n in range(number)]
    strings = headers[names][5]
    result = {}
    for header, name, _, _, _, offset, length in headers:
        end = content.index(b"\0", strings + name)
        result[content[strings + name:end].decode()] = (header, offset, length)
    return result


def copy(folder, change):
    """Put a copy into the folder, changed by change(content as bytearray, sections); its path."""
    content = bytearray(installed().read_bytes())
    change(content, sections(content))
    folder.mkdir(parents=True)
    path = folder / _linked()[0]
    path.write_bytes(content)
    return path


def root(folder, change=lambda content, parts: None):
    """A folder for LIGGGHTS_ROOT: program, changed library, and a link to the headers."""
    (folder / "bin").mkdir(parents=True)
    shutil.copy(part("-program"), folder / "bin/liggghts")
    copy(folder / "lib", change)
    (folder / "include").mkdir()
    (folder / "include/liggghts").symlink_to(part("-headers") / "liggghts")
    return folder


def other_version(name):
    """A change: another build that states another version, in 21 letters."""
    def change(content, parts):
        known = b"LIGGGHTS-PUBLIC 3.8.0"
        if len(name) != len(known) or known + b", compiled" not in content:
            raise AssertionError(f"the version of {installed()} cannot be changed to {name}")
        content[:] = content.replace(known + b", compiled", name.encode() + b", compiled")
        other_build(content, parts)
    return change


def foreign(path):
    """Make a file one for aarch64, as far as its header says."""
    content = bytearray(path.read_bytes())
    struct.pack_into("<H", content, 18, 183)
    path.write_bytes(content)


def other_build(content, parts):
    """Another build ID: the last byte of the note is turned round."""
    _, offset, length = parts[".note.gnu.build-id"]
    content[offset + length - 1] ^= 0xFF


def no_build(content, parts):
    """No build ID: the type of the note is one that nobody knows."""
    _, offset, _ = parts[".note.gnu.build-id"]
    struct.pack_into("<I", content, offset + 8, 0x7777)


def symbolic(content, parts):
    """As linked with -Bsymbolic: the library calls its own functions, whoever defines them too."""
    DT_FLAGS, DF_SYMBOLIC = 30, 2
    _, offset, length = parts[".dynamic"]
    for at in range(offset, offset + length, 16):
        tag, value = struct.unpack_from("<qQ", content, at)
        if tag == DT_FLAGS:
            struct.pack_into("<Q", content, at + 8, value | DF_SYMBOLIC)
            return
    raise AssertionError("the library has no entry DT_FLAGS to change")
