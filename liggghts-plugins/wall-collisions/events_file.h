/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_EVENTS_FILE_H
#define GRAINJET_EVENTS_FILE_H

#include <cstdio>
#include <string>
#include <vector>

namespace grainjet {

/* The file with one line per finished collision. Written by one rank, whole lines at a
   time and flushed, so that a killed run leaves a readable file that lacks no more than
   what had not been handed over. All functions return an empty string, or what went
   wrong.                                                                             */
class EventsFile {
 public:

  // line: the first one of the file; owner: the style of the fix that writes it
  EventsFile(const std::string &path, const std::string &line, const std::string &owner)
    : path_(path), line_(line), owner_(owner), file_(NULL), size_(0) {}
  ~EventsFile();
  EventsFile(const EventsFile &) = delete;
  EventsFile &operator=(const EventsFile &) = delete;

  // A new file with its first line. An older one of the fix gives way as a whole, since it
  // can have other names (hard links) by which somebody keeps it.
  std::string create();

  // Goes on behind the first `size` bytes of the file, as it was when a restart file was
  // written: lines of collisions that are about to happen again are cut off
  std::string resume(double size);

  // one line per collision, without its end
  std::string append(const std::vector<std::string> &lines);

  double size() const { return size_; }    // bytes
  FILE *file() const { return file_; }

 private:

  std::string path_, line_, owner_;
  FILE *file_;
  double size_;

  std::string write(const std::string &);
  std::string fault(const char *action) const;
};

}

#endif
