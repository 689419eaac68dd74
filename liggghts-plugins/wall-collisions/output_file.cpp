/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "output_file.h"

#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace grainjet {

/* ---------------------------------------------------------------------- */

static std::string cannot_write(const std::string &path)
{
  const int reason = errno;
  const std::size_t slash = path.rfind('/');
  std::string text = "cannot write file '" + path + "': " + strerror(reason);
  if (reason == ENOENT && slash != std::string::npos)
    text += "; make the folder '" + path.substr(0, slash) + "' first";
  return text;
}

/* ---------------------------------------------------------------------- */

static bool same_node(const struct stat &p, const struct stat &q)
{
  return p.st_dev == q.st_dev && p.st_ino == q.st_ino;
}

/* ----------------------------------------------------------------------
   folder without links and detours, and name
------------------------------------------------------------------------- */

static std::string place(const std::string &path)
{
  const std::size_t slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
  char real[PATH_MAX];
  if (!realpath(folder.c_str(), real)) return path;
  return std::string(real) + "/" + path.substr(slash == std::string::npos ? 0 : slash + 1);
}

/* ---------------------------------------------------------------------- */

std::string OutputFile::check_kind(const std::string &path)
{
  struct stat status;
  if (lstat(path.c_str(), &status) != 0) return errno == ENOENT ? "" : cannot_write(path);
  std::string kind;
  if (S_ISLNK(status.st_mode)) kind = "a symbolic link";
  else if (S_ISDIR(status.st_mode)) kind = "a directory";
  else if (!S_ISREG(status.st_mode)) kind = "a device, pipe or socket";
  if (!kind.empty())
    return "'" + path + "' is " + kind + "; give the path of a regular file, or of none yet";
  return access(path.c_str(), W_OK) == 0 ? "" : cannot_write(path);
}

/* ----------------------------------------------------------------------
   names of columns without those of the temperature
------------------------------------------------------------------------- */

static const char TEMPERATURE[] = ",temperature";

static std::string other_columns(std::string line)
{
  std::size_t at;
  while ((at = line.find(TEMPERATURE)) != std::string::npos)
    line.erase(at, line.find(',', at + 1) - at);
  return line;
}

/* ---------------------------------------------------------------------- */

std::string OutputFile::check_own(const std::string &path, const std::string &line,
  const std::string &owner, bool cut)
{
  const std::string fault = check_kind(path);
  if (!fault.empty()) return fault;
  FILE *file = fopen(path.c_str(), "r");
  if (!file) return errno == ENOENT ? "" : cannot_write(path);
  const std::string own = line + "\n";
  const std::size_t more = 200;    // room for the columns of the temperature
  std::string begin(own.size() + more, '\0');
  begin.resize(fread(&begin[0], 1, begin.size(), file));
  fclose(file);
  const std::string found = begin.substr(0, own.size());
  if (found == own || (cut && own.compare(0, found.size(), found) == 0)) return "";
  const std::size_t end = begin.find('\n');
  if (end != std::string::npos && other_columns(begin.substr(0, end)) == other_columns(line)) return "";
  return "'" + path + "' exists and was not written by fix " + owner + ", so it is not "
    "overwritten; move it away or give another path";
}

/* ---------------------------------------------------------------------- */

std::string OutputFile::check_open(const std::string &path, FILE *except)
{
  struct stat status;
  DIR *list = stat(path.c_str(), &status) == 0 ? opendir("/proc/self/fd") : NULL;
  if (!list) return "";
  bool found = false;
  while (const dirent *entry = readdir(list)) {
    const int number = atoi(entry->d_name);
    struct stat opened;
    if (entry->d_name[0] == '.' || (except && number == fileno(except))) continue;
    if (fstat(number, &opened) == 0 && same_node(opened, status)) found = true;
  }
  closedir(list);
  if (!found) return "";
  return "'" + path + "' is in use by this run, as input script, log or output of another "
    "command; give another path";
}

/* ---------------------------------------------------------------------- */

std::string OutputFile::check_folder(const std::string &path)
{
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL, 0666);
  if (file < 0) return errno == EEXIST ? "" : cannot_write(path);
  close(file);
  unlink(path.c_str());
  return "";
}

/* ----------------------------------------------------------------------
   A path as a list of what stands at each place: a star is one digit and then any number of them
------------------------------------------------------------------------- */

static const char DIGIT = '\1', DIGITS = '\2';

static std::string tokens(const std::string &path)
{
  std::string list;
  for (const char c : path) {
    if (c == '*') (list += DIGIT) += DIGITS;
    else list += c;
  }
  return list;
}

/* ----------------------------------------------------------------------
   Is there a path that is both, from places i and j on?
------------------------------------------------------------------------- */

static bool is_digit(char c)
{
  return c == DIGIT || (c >= '0' && c <= '9');
}

static bool overlap(const std::string &p, const std::string &q, std::size_t i = 0, std::size_t j = 0)
{
  const char a = i < p.size() ? p[i] : '\0', b = j < q.size() ? q[j] : '\0';
  if (a == DIGITS)
    return overlap(p, q, i + 1, j) || ((is_digit(b) || b == DIGITS) && overlap(p, q, i, j + 1));
  if (b == DIGITS) return overlap(p, q, i, j + 1) || (is_digit(a) && overlap(p, q, i + 1, j));
  if (a == '\0' || b == '\0') return a == b;
  const bool alike = a == b || (a == DIGIT && is_digit(b)) || (b == DIGIT && is_digit(a));
  return alike && overlap(p, q, i + 1, j + 1);
}

/* ---------------------------------------------------------------------- */

bool OutputFile::same(const std::string &p, const std::string &q)
{
  struct stat first, second;
  if (stat(p.c_str(), &first) == 0 && stat(q.c_str(), &second) == 0
      && same_node(first, second))
    return true;
  return overlap(tokens(place(p)), tokens(place(q)));
}

/* ---------------------------------------------------------------------- */

std::string OutputFile::temporary(const std::string &path)
{
  return path + ".new";
}

/* ---------------------------------------------------------------------- */

std::string OutputFile::replace(const std::string &path, const std::string &line,
  const std::string &owner, const std::string &text, bool &left)
{
  const std::string fresh = temporary(path);
  std::string fault = check_own(fresh, line, owner, true);
  if (!fault.empty()) return fault;
  unlink(fresh.c_str());
  FILE *file = fopen(fresh.c_str(), "wx");
  if (!file) return cannot_write(fresh);
  bool good = fwrite(text.data(), 1, text.size(), file) == text.size();
  if (fclose(file) != 0) good = false;
  if (!good) {
    fault = cannot_write(fresh);
    unlink(fresh.c_str());
    return fault;
  }
  left = !check_own(path, line, owner).empty();
  if (left || rename(fresh.c_str(), path.c_str()) == 0) return "";
  return cannot_write(path);
}

}
