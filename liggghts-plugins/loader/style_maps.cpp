/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "loader/style_maps.h"

#include "host/expose_member.h"

#include <liggghts/lammps.h>
#include <liggghts/fix.h>
#include <liggghts/input.h>
#include <liggghts/modify.h>

#include <dlfcn.h>

#include <cstring>
#include <map>

using namespace LAMMPS_NS;

typedef Fix *(*FixCreator)(LAMMPS *, int, char **);
typedef void (*CommandCreator)(LAMMPS *, int, char **);

namespace grainjet {

struct FixMap {
  using type = std::map<std::string, FixCreator> *Modify::*;
  friend type member(FixMap);
};
template struct Expose<FixMap, &Modify::fix_map>;

struct CommandMap {
  using type = std::map<std::string, CommandCreator> *Input::*;
  friend type member(CommandMap);
};
template struct Expose<CommandMap, &Input::command_map>;

}

namespace {

std::map<std::string, FixCreator> &fixes(LAMMPS *lmp)
{
  return *(lmp->modify->*member(grainjet::FixMap()));
}

std::map<std::string, CommandCreator> &commands(LAMMPS *lmp)
{
  return *(lmp->input->*member(grainjet::CommandMap()));
}

bool is(const liggghtsplugin_style &style, const char *kind)
{
  return style.kind && strcmp(style.kind, kind) == 0;
}

template <class Map> std::string file_of(const Map &map, const liggghtsplugin_style &style)
{
  const auto found = map.find(style.name);
  Dl_info info;
  if (found == map.end() || !dladdr(reinterpret_cast<void *>(found->second), &info)) return "";
  return info.dli_fname;
}

template <class Map> grainjet::style_maps::Entry compare(const Map &map, const liggghtsplugin_style &style)
{
  using grainjet::style_maps::Entry;
  const auto found = map.find(style.name);
  if (found == map.end()) return Entry::FREE;
  typedef typename Map::mapped_type Creator;
  return found->second == reinterpret_cast<Creator>(style.creator) ? Entry::SAME : Entry::OTHER;
}

}

/* ---------------------------------------------------------------------- */

grainjet::style_maps::Entry grainjet::style_maps::find(LAMMPS *lmp, const liggghtsplugin_style &style)
{
  if (is(style, "fix")) return compare(fixes(lmp), style);
  if (is(style, "command")) return compare(commands(lmp), style);
  return Entry::UNKNOWN_KIND;
}

/* ---------------------------------------------------------------------- */

void grainjet::style_maps::enter(LAMMPS *lmp, const liggghtsplugin_style &style)
{
  if (is(style, "fix"))
    fixes(lmp)[style.name] = reinterpret_cast<FixCreator>(style.creator);
  else if (is(style, "command"))
    commands(lmp)[style.name] = reinterpret_cast<CommandCreator>(style.creator);
}

/* ---------------------------------------------------------------------- */

void grainjet::style_maps::remove(LAMMPS *lmp, const liggghtsplugin_style &style)
{
  if (find(lmp, style) != Entry::SAME) return;
  if (is(style, "fix")) fixes(lmp).erase(style.name);
  else commands(lmp).erase(style.name);
}

/* ---------------------------------------------------------------------- */

std::string grainjet::style_maps::user(LAMMPS *lmp, const liggghtsplugin_style &style)
{
  if (!is(style, "fix")) return "";
  for (int i = 0; i < lmp->modify->nfix; i++)
    if (strcmp(lmp->modify->fix[i]->style, style.name) == 0) return lmp->modify->fix[i]->id;
  return "";
}

/* ---------------------------------------------------------------------- */

std::string grainjet::style_maps::file(LAMMPS *lmp, const liggghtsplugin_style &style)
{
  return is(style, "fix") ? file_of(fixes(lmp), style) : file_of(commands(lmp), style);
}
