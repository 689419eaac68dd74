/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "loader/host_build.h"

#include "loader/host_function.h"

#include <link.h>
#include <mpi.h>
#include <string.h>

#include <cctype>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string_view>
#include <vector>

#if defined(LIGGGHTSPLUGIN_HOST) && defined(OPEN_MPI)
static_assert(std::string_view(LIGGGHTSPLUGIN_HOST).find(" OpenMPI") != std::string_view::npos,
              "LIGGGHTS was built with another MPI than this mpi.h, Open MPI's: both must be the same");
#elif defined(LIGGGHTSPLUGIN_HOST)
static_assert(std::string_view(LIGGGHTSPLUGIN_HOST).find(" OpenMPI") == std::string_view::npos,
              "LIGGGHTS was built with Open MPI, but this mpi.h is another's: both must be the same");
#endif

namespace {

typedef std::uint32_t Word;

// the one that all classes are known of
const char *const supported = "LIGGGHTS-PUBLIC 3.8.0";

// The library of LIGGGHTS as it lies in memory
struct HostImage {
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
  HostImage &image = *static_cast<HostImage *>(result);
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

HostImage host_image()
{
  HostImage image = {reinterpret_cast<ElfW(Addr)>(grainjet::host_landmark()), "", {}};
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
std::string version(const HostImage &image)
{
  const std::string_view name = "LIGGGHTS-", end = ", compiled";
  for (const std::string_view part : image.constants)
    for (std::size_t at = part.find(name); at != part.npos; at = part.find(name, at + 1)) {
      std::size_t last = at + name.size();
      while (last < part.size() && (isalnum(static_cast<unsigned char>(part[last])) || strchr(". -_", part[last]))) last++;
      if (part.compare(last, end.size(), end) == 0) return std::string(part.substr(at, last - at));
    }
  return "LIGGGHTS of unknown version";
}

// what host-version finds by nm, in the same words
std::string options(const HostImage &image)
{
  Dl_info info, found;
  if (!image.inside || !dladdr(reinterpret_cast<void *>(image.inside), &info)) return "";
  void *file = dlopen(info.dli_fname, RTLD_LAZY | RTLD_NOLOAD);
  const auto has = [&](const char *symbol) {
    const void *place = dlsym(file ? file : RTLD_DEFAULT, symbol);
    return place && dladdr(place, &found) && found.dli_fbase == info.dli_fbase;
  };

  std::string words = has("_ZN9LAMMPS_NS6Modify15addstep_computeEi") ? "SMALLSMALL" :
    has("_ZN9LAMMPS_NS6Domain5unmapEPdl") ? "BIGBIG" : "SMALLBIG";
  words += has("_ZN9LAMMPS_NS6LAMMPSC1EiPPcP19ompi_communicator_t") ? " OpenMPI" : has("MPI_Init") ? " no-MPI" : " MPICH";
  if (has("_ZN9LAMMPS_NS19AtomVecSuperquadricC1EPNS_6LAMMPSE")) words += " superquadrics";
  if (has("_ZN9LAMMPS_NS7DumpVTKC1EPNS_6LAMMPSE")) words += " VTK";
  return words;
}

// the options in a stamp: what lies between its first and its last comma
std::string options_of(const std::string &stamp)
{
  const std::size_t begin = stamp.find(", "), end = stamp.rfind(", ");
  return begin == stamp.npos || begin == end ? "" : stamp.substr(begin + 2, end - begin - 2);
}

// the words of the first that are not in the second
std::string only_in(const std::string &first, const std::string &second)
{
  std::istringstream words(first);
  std::string result;
  for (std::string word; words >> word;)
    if ((" " + second + " ").find(" " + word + " ") == std::string::npos) result += " " + word;
  return result;
}

// in what the stamps of two builds differ, as sentences
std::string difference(const std::string &one, const std::string &other)
{
  const std::string first = options_of(one), second = options_of(other);
  const std::string lost = first.empty() ? "" : only_in(first, second), added = first.empty() ? "" : only_in(second, first);
  if (lost.empty() && added.empty()) return ". The classes of two builds of LIGGGHTS may differ";
  return (lost.empty() ? "" : ". Only the former has" + lost) + (added.empty() ? "" : ". Only the latter has" + added) +
    ". Calls and classes of the two differ";
}

std::string identity_of(const HostImage &image)
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
  const HostImage image = host_image();
  return version(image) + ", " + options(image) + ", " + identity_of(image);
}

/* ---------------------------------------------------------------------- */

std::string grainjet::host_build::misfit(const std::string &stamp)
{
  // the library does not change while it runs
  static const std::string end = ", " + identity();
  if (stamp.size() >= end.size() && stamp.compare(stamp.size() - end.size(), end.size(), end) == 0) return "";

  const std::string here = host_build::stamp(), known = std::string(supported) + ",";
  std::string text = "was built for " + stamp + ", but this is " + here;
  if (here.compare(0, known.size(), known) != 0)
    return text + ". Grainjet is for the public version 3.8.0 only (" + supported + "), since classes of other versions differ";
  return text + difference(stamp, here) + ". Build it again for this LIGGGHTS (a part of Grainjet: install a package "
    "made for it, or run ./Allwmake where you built Grainjet). If another LIGGGHTS is meant, LIGGGHTS_ROOT names it";
}
