/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "loader/library_file.h"

#include <errno.h>
#include <link.h>
#include <string.h>

#include <algorithm>
#include <fstream>
#include <vector>

namespace {

typedef unsigned long long Bytes;

// `count` entries of a table at a place of the file; shorter where the file ends
template <class Entry> std::vector<Entry> table(std::ifstream &file, Bytes place, Bytes count)
{
  std::vector<Entry> entries(count);
  file.clear();
  file.seekg(static_cast<std::streamoff>(place));
  file.read(reinterpret_cast<char *>(entries.data()), static_cast<std::streamsize>(count * sizeof(Entry)));
  entries.resize(static_cast<Bytes>(file.gcount()) / sizeof(Entry));
  return entries;
}

std::string too_short(Bytes size, Bytes needed)
{
  return "it ends after " + std::to_string(size) + " bytes and should have " + std::to_string(needed);
}

}

/* ---------------------------------------------------------------------- */

std::string grainjet::library_file::damage(const std::string &path)
{
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) return std::string("it cannot be read (") + strerror(errno) + ")";
  const Bytes size = static_cast<Bytes>(file.tellg());
  if (size == 0) return "it is empty";

  const std::vector<ElfW(Ehdr)> headers = table<ElfW(Ehdr)>(file, 0, 1);
  if (headers.empty() || memcmp(headers[0].e_ident, ELFMAG, SELFMAG) != 0 ||
      headers[0].e_ident[EI_CLASS] != (sizeof(void *) == 8 ? ELFCLASS64 : ELFCLASS32) ||
      headers[0].e_phentsize != sizeof(ElfW(Phdr)))
    return "";
  const ElfW(Ehdr) &header = headers[0];

  // what is mapped into memory
  const auto segments = table<ElfW(Phdr)>(file, header.e_phoff, header.e_phnum);
  Bytes needed = header.e_phoff + Bytes(header.e_phnum) * sizeof(ElfW(Phdr));
  bool mapped = false;
  for (const ElfW(Phdr) &segment : segments) {
    if (segment.p_type == PT_LOAD) mapped = true;
    if (segment.p_type == PT_LOAD || segment.p_type == PT_DYNAMIC)
      needed = std::max<Bytes>(needed, segment.p_offset + segment.p_filesz);
  }

  // The table of sections is the last thing in a file. Its place is known and its
  // contents are not zero, so it tells of an end that is missing or was never written.
  const bool has_sections = header.e_shoff && header.e_shentsize == sizeof(ElfW(Shdr));
  if (has_sections)
    needed = std::max<Bytes>(needed, header.e_shoff + Bytes(header.e_shnum) * sizeof(ElfW(Shdr)));
  if (size < needed) return too_short(size, needed);
  if (!mapped) return "its table of segments holds nothing to load";
  if (!has_sections) return "";

  const auto sections = table<ElfW(Shdr)>(file, header.e_shoff, header.e_shnum);
  if (header.e_shstrndx >= sections.size() || sections[header.e_shstrndx].sh_type != SHT_STRTAB)
    return "its table of sections was not written, so parts before it may be missing too";
  return "";
}
