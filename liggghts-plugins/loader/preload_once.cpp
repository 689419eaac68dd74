/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* Only in the library for the stock program, which the launcher preloads: takes this
   library out of LD_PRELOAD as soon as LIGGGHTS is started, so that programs started by
   LIGGGHTS (`shell`, gzip for dumps, daemons of MPI) run without it. If `liggghts` is a
   wrapper script, its shell is passed over. Also lets no message be lost in a pipe, and stops
   if LIGGGHTS would not call this library, which a user would see as an unknown command: it is
   a part of the program, or another library comes first. */

#include "loader/interposition.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

namespace {

// Whether the running program holds LIGGGHTS in itself. It is no more than a text that LIGGGHTS states its
// version with; programs that come by here otherwise, as shells, have none
bool is_liggghts()
{
  std::ifstream program("/proc/self/exe", std::ios::binary);
  const std::string content((std::istreambuf_iterator<char>(program)), std::istreambuf_iterator<char>());
  const std::string name = "LIGGGHTS-", end = ", compiled ";
  for (size_t at = content.find(name); at != content.npos; at = content.find(name, at + 1)) {
    const size_t stated = content.find(end, at);
    if (stated != content.npos && stated - at < 64 && content.find('\0', at) > stated) return true;
  }
  return false;
}

[[noreturn]] void stop(const std::string &fault)
{
  fprintf(stderr, "ERROR: The plugin loader does not work: %s\n", fault.c_str());
  _exit(1);
}

__attribute__((constructor)) void leave_ld_preload()
{
  // a function of the host; its library is in place before constructors run
  if (!dlsym(RTLD_DEFAULT, "_ZN9LAMMPS_NS6LAMMPS11post_createEv")) {
    if (is_liggghts())
      stop(grainjet::interposition::program() + " holds LIGGGHTS in itself instead of using a shared library (as `make auto` builds "
        "it), so no function can be put in the place of one of its own. Build LIGGGHTS as a shared library, docs/loader.md");
    return;
  }

  // An error of one rank ends all of them at once, and with them what waits in the buffer of a
  // screen that goes to a file or a pipe: the message
  setvbuf(stdout, NULL, _IOLBF, 0);

  const std::string fault = grainjet::interposition::loader_fault();
  if (!fault.empty()) stop(fault + ". Start LIGGGHTS with liggghts-plugins, and without that library");

  const char *variable = getenv("LD_PRELOAD");
  Dl_info info;
  if (!variable || !dladdr(reinterpret_cast<void *>(&leave_ld_preload), &info)) return;

  // the launcher's descriptor for a file that LD_PRELOAD cannot name
  const std::string self = info.dli_fname, opened = "/proc/self/fd/";
  if (self.compare(0, opened.size(), opened) == 0) fcntl(atoi(self.c_str() + opened.size()), F_SETFD, FD_CLOEXEC);

  const std::string list = variable;
  std::string rest;
  for (size_t begin = 0; begin < list.size();) {
    const size_t end = std::min(list.find_first_of(" :", begin), list.size());
    const std::string entry = list.substr(begin, end - begin);
    if (!entry.empty() && entry != self) rest += (rest.empty() ? "" : ":") + entry;
    begin = end + 1;
  }
  if (rest.empty()) unsetenv("LD_PRELOAD");
  else setenv("LD_PRELOAD", rest.c_str(), 1);
}

}
