/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* Only in the library for the stock program, which the launcher preloads: takes this
   library out of LD_PRELOAD as soon as LIGGGHTS is started, so that programs started by
   LIGGGHTS (`shell`, gzip for dumps, daemons of MPI) run without it. If `liggghts` is a
   wrapper script, its shell is passed over. Also lets no message be lost in a pipe, and stops
   if LIGGGHTS would not call this library, which a user would see as an unknown command. */

#include "loader/interposition.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <string>

namespace {

__attribute__((constructor)) void leave_ld_preload()
{
  // a function of the host; its library is in place before constructors run
  if (!dlsym(RTLD_DEFAULT, "_ZN9LAMMPS_NS6LAMMPS11post_createEv")) return;

  // An error of one rank ends all of them at once, and with them what waits in the buffer of a
  // screen that goes to a file or a pipe: the message
  setvbuf(stdout, NULL, _IOLBF, 0);

  const std::string fault = grainjet::interposition::loader_fault();
  if (!fault.empty()) {
    fprintf(stderr, "ERROR: The plugin loader does not work: %s. Start LIGGGHTS with liggghts-plugins, and without that "
            "library\n", fault.c_str());
    _exit(1);
  }

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
