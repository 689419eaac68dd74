/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "loader/plugin_loader.h"

#include "host/grainjet_version.h"
#include "loader/plugin_file.h"
#include "loader/style_maps.h"

#include <liggghts/lammps.h>
#include <liggghts/comm.h>
#include <liggghts/error.h>

#include <stdio.h>

#include <cstring>

using namespace LAMMPS_NS;

namespace {

void print(LAMMPS *lmp, const std::string &line)
{
  if (lmp->comm->me != 0) return;
  if (lmp->screen) fprintf(lmp->screen, "%s\n", line.c_str());
  if (lmp->logfile) fprintf(lmp->logfile, "%s\n", line.c_str());
}

std::string title(const liggghtsplugin_style &style)
{
  return std::string(style.kind) + " " + style.name;
}

std::string text(const char *string)
{
  return string ? string : "not stated";
}

}

/* ---------------------------------------------------------------------- */

grainjet::PluginLoader &grainjet::PluginLoader::instance()
{
  static PluginLoader loader;
  return loader;
}

/* ---------------------------------------------------------------------- */

void grainjet::PluginLoader::load(LAMMPS *lmp, const std::string &name)
{
  const std::string path = plugin_file::find(lmp, name);

  const Plugin *known = loaded(path);
  const Plugin plugin = known ? *known : Plugin{path, plugin_file::open(lmp, path)};

  // all names are looked at before one is entered: a refused plugin leaves nothing behind
  check(lmp, plugin);
  for (int i = 0; i < plugin.description->nstyles; i++)
    style_maps::enter(lmp, plugin.description->styles[i]);

  if (known) {
    print(lmp, "Plugin " + path + " is loaded already");
    return;
  }
  plugins.push_back(plugin);
  for (int i = 0; i < plugin.description->nstyles; i++)
    print(lmp, "Plugin style " + title(plugin.description->styles[i]) + " from " + path);
}

/* ---------------------------------------------------------------------- */

void grainjet::PluginLoader::list(LAMMPS *lmp) const
{
  print(lmp, "Grainjet " GRAINJET_VERSION);
  if (plugins.empty()) {
    print(lmp, "No plugins are loaded");
    return;
  }
  print(lmp, "Loaded plugins:");
  for (const Plugin &plugin : plugins) {
    print(lmp, "  " + plugin.path);
    for (int i = 0; i < plugin.description->nstyles; i++) {
      const liggghtsplugin_style &style = plugin.description->styles[i];
      print(lmp, "    " + title(style) + ": " + text(style.info) + " (author: " + text(style.author) + ")");
    }
  }
}

/* ---------------------------------------------------------------------- */

void grainjet::PluginLoader::clear(LAMMPS *lmp)
{
  for (const Plugin &plugin : plugins)
    for (int i = 0; i < plugin.description->nstyles; i++) {
      const liggghtsplugin_style &style = plugin.description->styles[i];
      const std::string user = style_maps::user(lmp, style);
      if (!user.empty()) {
        const std::string why = "plugin clear: fix " + user + " is of style " + style.name +
          " from " + plugin.path + ". Use 'unfix " + user + "' or 'clear' first";
        lmp->error->all(FLERR, why.c_str());
      }
    }

  for (const Plugin &plugin : plugins)
    for (int i = 0; i < plugin.description->nstyles; i++)
      style_maps::remove(lmp, plugin.description->styles[i]);
  plugins.clear();
}

/* ---------------------------------------------------------------------- */

void grainjet::PluginLoader::restore(LAMMPS *lmp) const
{
  for (const Plugin &plugin : plugins)
    for (int i = 0; i < plugin.description->nstyles; i++)
      style_maps::enter(lmp, plugin.description->styles[i]);
}

/* ---------------------------------------------------------------------- */

const grainjet::PluginLoader::Plugin *grainjet::PluginLoader::loaded(const std::string &path) const
{
  for (const Plugin &plugin : plugins)
    if (plugin.path == path) return &plugin;
  return NULL;
}

/* ----------------------------------------------------------------------
   where a taken style name comes from, for the error message
------------------------------------------------------------------------- */

std::string grainjet::PluginLoader::source_of(const liggghtsplugin_style &wanted) const
{
  for (const Plugin &plugin : plugins)
    for (int i = 0; i < plugin.description->nstyles; i++) {
      const liggghtsplugin_style &style = plugin.description->styles[i];
      if (strcmp(style.kind, wanted.kind) == 0 && strcmp(style.name, wanted.name) == 0)
        return "the plugin " + plugin.path;
    }
  return "LIGGGHTS itself";
}

/* ---------------------------------------------------------------------- */

void grainjet::PluginLoader::check(LAMMPS *lmp, const Plugin &plugin) const
{
  for (int i = 0; i < plugin.description->nstyles; i++) {
    const liggghtsplugin_style &style = plugin.description->styles[i];
    std::string why;
    switch (style_maps::find(lmp, style)) {
    case style_maps::Entry::FREE:
    case style_maps::Entry::SAME:
      continue;
    case style_maps::Entry::OTHER:
      why = "plugin load: '" + plugin.path + "' brings " + title(style) + ", which " +
        source_of(style) + " has already. Load only one of them";
      break;
    case style_maps::Entry::UNKNOWN_KIND:
      why = "plugin load: '" + plugin.path + "' brings a style of unknown kind '" +
        text(style.kind) + "' (known: fix, command). Build it again with this Grainjet";
      break;
    }
    lmp->error->all(FLERR, why.c_str());
  }
}
