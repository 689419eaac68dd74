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
#include <utility>
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

// the kind of machine that a header names; empty if it is none that is known here, as in a damaged file
std::string machine(const ElfW(Ehdr) &header)
{
  const std::pair<int, const char *> known[] = {{EM_X86_64, "x86-64"}, {EM_386, "i386"}, {EM_AARCH64, "aarch64"},
    {EM_ARM, "arm"}, {EM_RISCV, "RISC-V"}, {EM_PPC64, "ppc64"}, {EM_S390, "s390"}, {EM_MIPS, "MIPS"}};
  for (const auto &kind : known)
    if (header.e_machine == kind.first)
      return std::string(kind.second) + (header.e_ident[EI_CLASS] == ELFCLASS64 ? ", 64 bits" : ", 32 bits") +
        (header.e_ident[EI_DATA] == ELFDATA2LSB ? "" : ", big endian");
  return "";
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

/* ---------------------------------------------------------------------- */

std::string grainjet::library_file::foreign(const std::string &path)
{
  // the kind of machine stands at the same place in the header of all classes
  std::ifstream file(path, std::ios::binary), program("/proc/self/exe", std::ios::binary);
  const std::vector<ElfW(Ehdr)> theirs = table<ElfW(Ehdr)>(file, 0, 1), ours = table<ElfW(Ehdr)>(program, 0, 1);
  if (theirs.empty() || ours.empty() || memcmp(theirs[0].e_ident, ELFMAG, SELFMAG) != 0) return "";
  const std::string kind = machine(theirs[0]), here = machine(ours[0]);
  return kind.empty() || kind == here ? "" : "is for another kind of machine (" + kind + "; this one is " + here + "): build it on this one";
}
