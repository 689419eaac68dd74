/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "loader/host_build.h"

#include "loader/host_function.h"

#include <link.h>
#include <string.h>

#include <cctype>
#include <cstdint>
#include <fstream>
#include <string_view>
#include <vector>

namespace {

typedef std::uint32_t Word;

// The library of LIGGGHTS as it lies in memory
struct Image {
  ElfW(Addr) inside;                      // an address in it
  std::string build;                      // its build ID, empty if it has none
  std::vector<std::string_view> constants;  // what cannot be written to
};

std::string build_id(const char *notes, std::size_t size, std::size_t align)
{
  const auto padded = [align](std::size_t n) { return (n + align - 1) / align * align; };
  for (std::size_t at = 0; at + sizeof(ElfW(Nhdr)) <= size;) {
    ElfW(Nhdr) note;
    memcpy(&note, notes + at, sizeof(note));
    const char *name = notes + at + sizeof(note);
    const unsigned char *content = reinterpret_cast<const unsigned char *>(notes + at + padded(sizeof(note) + note.n_namesz));
    if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4 && memcmp(name, "GNU", 4) == 0) {
      std::string id;
      for (Word n = 0; n < note.n_descsz; n++) {
        const char *digits = "0123456789abcdef";
        id += digits[content[n] / 16];
        id += digits[content[n] % 16];
      }
      return id;
    }
    at += padded(sizeof(note) + note.n_namesz) + padded(note.n_descsz);
  }
  return "";
}

// called for each library of the process; the result ends the search
int examine(dl_phdr_info *library, size_t, void *result)
{
  Image &image = *static_cast<Image *>(result);
  bool found = false;
  for (int n = 0; n < library->dlpi_phnum; n++) {
    const ElfW(Phdr) &part = library->dlpi_phdr[n];
    const ElfW(Addr) begin = library->dlpi_addr + part.p_vaddr;
    if (part.p_type == PT_LOAD && image.inside >= begin && image.inside < begin + part.p_memsz) found = true;
  }
  for (int n = 0; found && n < library->dlpi_phnum; n++) {
    const ElfW(Phdr) &part = library->dlpi_phdr[n];
    const char *memory = reinterpret_cast<const char *>(library->dlpi_addr + part.p_vaddr);
    if (part.p_type == PT_NOTE && image.build.empty())
      image.build = build_id(memory, part.p_filesz, part.p_align == 8 ? 8 : 4);
    if (part.p_type == PT_LOAD && (part.p_flags & PF_R) && !(part.p_flags & (PF_W | PF_X)))
      image.constants.push_back(std::string_view(memory, part.p_filesz));
  }
  return found;
}

Image host_image()
{
  Image image = {reinterpret_cast<ElfW(Addr)>(grainjet::host_landmark()), "", {}};
  if (image.inside) dl_iterate_phdr(examine, &image);
  return image;
}

// what the program cksum prints for a file: CRC-32 of its bytes and its length
std::string checksum(const std::string &path)
{
  Word table[256];
  for (Word n = 0; n < 256; n++) {
    Word crc = n << 24;
    for (int bit = 0; bit < 8; bit++) crc = (crc << 1) ^ (crc >> 31 ? 0x04C11DB7 : 0);
    table[n] = crc;
  }
  Word crc = 0;
  const auto take = [&](unsigned char byte) { crc = (crc << 8) ^ table[(crc >> 24) ^ byte]; };

  std::ifstream file(path, std::ios::binary);
  std::vector<char> block(1 << 16);
  std::uint64_t size = 0;
  do {
    file.read(block.data(), static_cast<std::streamsize>(block.size()));
    for (std::streamsize n = 0; n < file.gcount(); n++) take(static_cast<unsigned char>(block[n]));
    size += static_cast<std::uint64_t>(file.gcount());
  } while (file);
  for (std::uint64_t rest = size; rest; rest >>= 8) take(static_cast<unsigned char>(rest & 255));
  return std::to_string(static_cast<Word>(~crc)) + " " + std::to_string(size);
}

// "LIGGGHTS-PUBLIC 3.8.0" of the text "LIGGGHTS-PUBLIC 3.8.0, compiled ..." in the library
std::string version(const Image &image)
{
  const std::string_view name = "LIGGGHTS-", end = ", compiled";
  for (const std::string_view part : image.constants)
    for (std::size_t at = part.find(name); at != part.npos; at = part.find(name, at + 1)) {
      std::size_t last = at + name.size();
      while (last < part.size() && (isalnum(static_cast<unsigned char>(part[last])) || part[last] == '.' || part[last] == ' ')) last++;
      if (part.compare(last, end.size(), end) == 0) return std::string(part.substr(at, last - at));
    }
  return "LIGGGHTS of unknown version";
}

std::string identity_of(const Image &image)
{
  if (!image.build.empty()) return "build " + image.build;
  Dl_info info;
  if (!image.inside || !dladdr(reinterpret_cast<void *>(image.inside), &info)) return "";
  return "checksum " + checksum(info.dli_fname);
}

}

/* ---------------------------------------------------------------------- */

std::string grainjet::host_build::identity()
{
  return identity_of(host_image());
}

/* ---------------------------------------------------------------------- */

std::string grainjet::host_build::stamp()
{
  const Image image = host_image();
  return version(image) + ", " + identity_of(image);
}

/* ---------------------------------------------------------------------- */

std::string grainjet::host_build::misfit(const std::string &stamp)
{
  // the library does not change while it runs
  static const std::string end = ", " + identity();
  if (stamp.size() >= end.size() && stamp.compare(stamp.size() - end.size(), end.size(), end) == 0) return "";
  return "was built for " + stamp + ", but this is " + host_build::stamp() +
    ". The classes of two builds of LIGGGHTS may differ. Build it again for this LIGGGHTS: ./Allwmake in Grainjet's folder "
    "for its own parts";
}
