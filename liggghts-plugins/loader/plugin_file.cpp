/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "loader/plugin_file.h"

#include "loader/host_build.h"
#include "loader/library_file.h"

#include <liggghts/lammps.h>
#include <liggghts/comm.h>
#include <liggghts/error.h>

#include <dlfcn.h>
#include <fcntl.h>
#include <limits.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <sstream>
#include <utility>
#include <vector>

using namespace LAMMPS_NS;

namespace {

typedef std::vector<std::pair<std::string, std::string>> Places;   // folder, what it is

void add(Places &places, const std::string &folder, const char *what)
{
  for (const auto &place : places)
    if (place.first == folder) return;
  if (!folder.empty()) places.emplace_back(folder, what);
}

std::string absolute(const std::string &path)
{
  if (path.empty()) return path;
  char *real = realpath(path.c_str(), NULL);
  if (!real) return path;
  const std::string result = real;
  free(real);
  return result;
}

bool is_file(const std::string &path)
{
  struct stat info;
  return stat(path.c_str(), &info) == 0 && S_ISREG(info.st_mode);
}

std::string loader_folder()
{
  const std::string file = grainjet::plugin_file::loader();
  return file.substr(0, file.rfind('/'));
}

Places search_places()
{
  Places places;
  add(places, absolute("."), "working folder");
  const char *variable = getenv("LIGGGHTS_PLUGIN_PATH");
  std::istringstream list(variable ? variable : "");
  for (std::string folder; std::getline(list, folder, ':');)
    add(places, absolute(folder), "LIGGGHTS_PLUGIN_PATH");
  add(places, loader_folder(), "beside the loader");
  return places;
}

// path of the file, or empty and why there is none
std::string search(const std::string &name, std::string &why)
{
  if (name.find('/') != std::string::npos) {
    if (is_file(name)) return absolute(name);
    why = "there is no file '" + name + "' (working folder: " + absolute(".") +
      "). Check the path, or give only the file name to have it searched for";
    return "";
  }

  const Places places = search_places();
  for (const auto &place : places)
    if (is_file(place.first + "/" + name)) return absolute(place.first + "/" + name);

  why = "there is no file '" + name + "' in";
  for (const auto &place : places) why += " " + place.first + " (" + place.second + "),";
  why.back() = '.';
  why += " Check the name, or add the folder of the file to LIGGGHTS_PLUGIN_PATH";
  return "";
}

// The name under which the linker takes the file. In a name with a slash it replaces $LIB
// and the like, also where they are part of a folder's name; then the file is opened here and
// stays so, since the linker remembers names.
std::string linker_name(const std::string &path)
{
  if (path.find('$') == std::string::npos) return path;
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  return file < 0 ? path : "/proc/self/fd/" + std::to_string(file);
}

std::string linker_words()
{
  const char *reason = dlerror();
  return reason ? reason : "no reason given";
}

// version of Grainjet that an opened library carries, empty if none
std::string stamp(void *file)
{
  const void *text = dlsym(file, "liggghtsplugin_grainjet");
  return text ? static_cast<const char *>(text) : "";
}

// why an opened library is not to be used here, empty if it is
std::string refusal(void *file)
{
  const auto init = reinterpret_cast<liggghtsplugin_initfunc>(dlsym(file, "liggghtsplugin_init"));
  const std::string grainjet = stamp(file);
  if (init && grainjet != GRAINJET_VERSION)
    return " was built with " + (grainjet.empty() ? "an earlier Grainjet (it states no version)" : "Grainjet " + grainjet) +
      ", but this is Grainjet " GRAINJET_VERSION " (" + grainjet::plugin_file::loader() +
      "). Build it again with this one. If it is a part of Grainjet, " GRAINJET_ANEW;

  const liggghtsplugin_description *description = init ? init() : NULL;
  if (!description || !description->host)
    return " is a library but not a LIGGGHTS plugin (it has no working entry point "
      "liggghtsplugin_init). Is this the file you meant?";
  const std::string misfit = grainjet::host_build::misfit(description->host);
  return misfit.empty() ? "" : " " + misfit;
}

// description of the plugin, or NULL and why it was refused
const liggghtsplugin_description *examine(const std::string &path, std::string &why)
{
  why = grainjet::library_file::foreign(path);
  if (!why.empty()) {
    why = "'" + path + "' " + why;
    return NULL;
  }

  // the linker maps what a file claims to hold, and the program dies where it does not
  why = grainjet::library_file::damage(path);
  if (!why.empty()) {
    why = "'" + path + "' is damaged: " + why + ". Build it or copy it again";
    return NULL;
  }

  // lazily at first: a plugin for another host may need functions that are missing
  // here, and its stamp explains that better than the name of a symbol
  const std::string name = linker_name(path);
  void *file = dlopen(name.c_str(), RTLD_LAZY | RTLD_LOCAL);
  if (!file) {
    why = "'" + path + "' cannot be loaded: " + linker_words() +
      ". It must be a plugin library compiled on this kind of machine for this LIGGGHTS, "
      "and the libraries it needs must be found through LD_LIBRARY_PATH";
    return NULL;
  }

  why = refusal(file);
  dlclose(file);
  if (!why.empty()) {
    why = "'" + path + "'" + why;
    return NULL;
  }

  file = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (file) return reinterpret_cast<liggghtsplugin_initfunc>(dlsym(file, "liggghtsplugin_init"))();
  why = "'" + path + "' does not fit this LIGGGHTS: " + linker_words() + ". Build it again for this LIGGGHTS";
  return NULL;
}

// the same string on all ranks of the world: that of the given rank
void broadcast(LAMMPS *lmp, std::string &text, int from)
{
  int length = static_cast<int>(text.size());
  MPI_Bcast(&length, 1, MPI_INT, from, lmp->world);
  text.resize(length);
  if (length) MPI_Bcast(&text[0], length, MPI_CHAR, from, lmp->world);
}

}

/* ---------------------------------------------------------------------- */

void grainjet::plugin_file::agree(LAMMPS *lmp, std::string why)
{
  int me, nprocs;
  MPI_Comm_rank(lmp->world, &me);
  MPI_Comm_size(lmp->world, &nprocs);
  const int complains = why.empty() ? nprocs : me;
  int first;
  MPI_Allreduce(&complains, &first, 1, MPI_INT, MPI_MIN, lmp->world);
  if (first == nprocs) return;
  if (nprocs > 1) why += " (on rank " + std::to_string(me) + ")";
  broadcast(lmp, why, first);
  lmp->error->all(FLERR, why.c_str());
}

/* ---------------------------------------------------------------------- */

std::string grainjet::plugin_file::find(LAMMPS *lmp, const std::string &name)
{
  std::string path, why;
  if (lmp->comm->me == 0) path = search(name, why);
  broadcast(lmp, why, 0);
  if (!why.empty()) lmp->error->all(FLERR, ("plugin load: " + why).c_str());
  broadcast(lmp, path, 0);
  return path;
}

/* ---------------------------------------------------------------------- */

const liggghtsplugin_description *grainjet::plugin_file::open(LAMMPS *lmp, const std::string &path)
{
  std::string why;
  const liggghtsplugin_description *description = examine(path, why);
  agree(lmp, why.empty() ? "" : "plugin load: " + why);
  return description;
}

/* ---------------------------------------------------------------------- */

std::string grainjet::plugin_file::version(const std::string &path)
{
  void *file = dlopen(path.c_str(), RTLD_LAZY | RTLD_NOLOAD);
  return file ? stamp(file) : "";
}

/* ---------------------------------------------------------------------- */

std::string grainjet::plugin_file::loader()
{
  Dl_info info;
  if (!dladdr(reinterpret_cast<void *>(&loader_folder), &info) || !info.dli_fname) return "";
  return absolute(info.dli_fname);
}
