/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_VERSION_H
#define GRAINJET_VERSION_H

/* The version of Grainjet, with which plugins, loader and coupling are stamped: parts of two
   versions hand each other data of different layout and refuse each other. This is the only place
   of the version: both builds and the packages read it here.                           */
#define GRAINJET_VERSION "0.10.1"

/* What to do where parts of two builds meet, for messages: fits a package and a folder that was built in */
#define GRAINJET_ANEW "install Grainjet again, or run ./Allwmake where you built it"

#endif
