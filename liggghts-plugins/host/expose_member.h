/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_EXPOSE_MEMBER_H
#define GRAINJET_EXPOSE_MEMBER_H

namespace grainjet {

/* Reads a non-public data member of a host class without touching the host's sources:
   access is not checked where a template is instantiated explicitly (C++17
   [temp.explicit]/12). The tag must be in this namespace, where Expose defines the
   function that the tag declares. Usage:

     namespace grainjet {
     struct Lists {
       using type = int *LAMMPS_NS::Modify::*;
       friend type member(Lists);
     };
     template struct Expose<Lists, &LAMMPS_NS::Modify::list_pre_exchange>;
     }

     int *list = modify->*member(grainjet::Lists());                                */
template<class Tag, typename Tag::type Member>
struct Expose {
  friend typename Tag::type member(Tag) { return Member; }
};

}

#endif
