/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "events_file.h"

#include "output_file.h"

#include <cerrno>
#include <cstring>
#include <unistd.h>

using namespace grainjet;

/* ---------------------------------------------------------------------- */

EventsFile::~EventsFile()
{
  if (file_) fclose(file_);
}

/* ---------------------------------------------------------------------- */

std::string EventsFile::fault(const char *action) const
{
  return std::string("cannot ") + action + " '" + path_ + "': " + strerror(errno);
}

/* ---------------------------------------------------------------------- */

std::string EventsFile::create()
{
  const std::string fault = OutputFile::check_own(path_, line_, owner_);
  if (!fault.empty()) return fault;
  if (unlink(path_.c_str()) != 0 && errno != ENOENT) return this->fault("write events file");
  file_ = fopen(path_.c_str(), "ax");
  if (!file_) return this->fault("write events file");
  return write(line_ + "\n");
}

/* ---------------------------------------------------------------------- */

std::string EventsFile::resume(double size)
{
  const std::string foreign = OutputFile::check_kind(path_);
  if (!foreign.empty()) return foreign;
  file_ = fopen(path_.c_str(), "a+");
  if (!file_) return fault("continue events file");
  // it must be the file that was written then: one that has a line's end at that place
  fseek(file_, static_cast<long>(size) - 1, SEEK_SET);
  if (fgetc(file_) != '\n' || !OutputFile::check_own(path_, line_, owner_).empty())
    return "events file '" + path_ + "' is not the one written before the restart; move it "
      "away or give another path";
  if (ftruncate(fileno(file_), static_cast<off_t>(size)) != 0)
    return fault("shorten events file");
  fseek(file_, 0, SEEK_END);
  size_ = size;
  return "";
}

/* ---------------------------------------------------------------------- */

std::string EventsFile::append(const std::vector<std::string> &lines)
{
  const std::size_t page = 4096;    // handed over in pieces that a kill hardly cuts
  std::string text, failure;
  for (const std::string &line : lines) {
    if (text.size() + line.size() + 1 > page) {
      failure = write(text);
      if (!failure.empty()) return failure;
      text.clear();
    }
    text += line;
    text += '\n';
  }
  return write(text);
}

/* ---------------------------------------------------------------------- */

std::string EventsFile::write(const std::string &text)
{
  if (fwrite(text.data(), 1, text.size(), file_) != text.size() || fflush(file_) != 0)
    return fault("write to events file");
  size_ += text.size();
  return "";
}
