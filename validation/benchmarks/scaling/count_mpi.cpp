/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* Counts what a program hands to MPI, by rank: messages, their bytes and destinations, collective calls. Loaded
   before the program's own libraries (LD_PRELOAD), by the profiling interface of MPI (PMPI). A call within MPI is
   not seen; neither is a call that MPI makes for a collective one.

   At MPI_Finalize, or at its end where it does not start MPI, each rank writes <GRAINJET_MPI_COUNTS>.<rank>, a line per kind of call:

     message <calls> <bytes> <site> <ranks that they went to, joined by commas>
     tree <calls> <bytes> <site> <the same>     messages of OpenFOAM's own reductions, from rank to rank
     up <calls> <bytes> <site>                  those of them to a lower rank: a rank other than 0 sends one for each
                                                value that is gathered
     <name of the collective> <calls> <bytes of this rank> <site>
     memory <resident memory without that of files, kB>

   site: the functions of Grainjet's libraries that lead to the call, innermost first, or the library that calls.

   Numbers of calls do not depend on how fast the machine is, so that more ranks than cores tell what a cluster
   would see. Probes and tests for messages do, and are not counted.                                  */

#include <mpi.h>

#include <cxxabi.h>
#include <dlfcn.h>
#include <execinfo.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

struct Count { long calls = 0; double bytes = 0; };
struct Messages : Count { std::set<int> ranks; };

std::map<std::string, Messages> messages;    // by "message site" or "tree site"
std::map<std::string, Count> collectives;    // by "name site"

double bytes(int count, MPI_Datatype type)
{
  int size = 0;
  if (type != MPI_DATATYPE_NULL) PMPI_Type_size(type, &size);
  return 1.0 * count * size;
}

// Rank of all, of a rank of a communicator
int world(int rank, MPI_Comm comm)
{
  MPI_Group mine, all;
  PMPI_Comm_group(comm, &mine);
  PMPI_Comm_group(MPI_COMM_WORLD, &all);
  int result = MPI_PROC_NULL;
  PMPI_Group_translate_ranks(mine, 1, &rank, all, &result);
  PMPI_Group_free(&mine);
  PMPI_Group_free(&all);
  return result;
}

const char *file_of(const Dl_info &info)
{
  const char *slash = info.dli_fname ? strrchr(info.dli_fname, '/') : nullptr;
  return slash ? slash + 1 : info.dli_fname ? info.dli_fname : "?";
}

// openfoam: does OpenFOAM's own communication make the call?
struct Site { std::string name; bool openfoam = false; };

Site site_of(const std::vector<void *> &frames)
{
  Site site;
  std::string library, functions, last;
  int named = 0;
  for (void *frame : frames) {
    Dl_info info;
    if (!dladdr(frame, &info)) continue;
    const std::string file = file_of(info);
    if (file.find("libcountmpi") == 0) continue;
    if (library.empty()) library = file;
    if (!info.dli_sname) continue;
    int status;
    char *name = abi::__cxa_demangle(info.dli_sname, nullptr, nullptr, &status);
    std::string text = status == 0 ? name : info.dli_sname;
    free(name);

    if (file.find("libliggghtsCoupling") != 0 && file.find("plugin.so") == std::string::npos) continue;
    text = text.substr(0, text.find('('));
    // the type that a template returns stands before its name
    int depth = 0;
    size_t begin = 0;
    for (size_t k = 0; k < text.size(); k++) {
      depth += (text[k] == '<') - (text[k] == '>');
      if (text[k] == ' ' && depth == 0) begin = k + 1;
    }
    text = text.substr(begin);
    if (text == last || named == 4) continue;
    functions += (named++ ? "<-" : "") + text;
    last = text;
  }
  site.openfoam = library.find("libPstream") == 0;
  site.name = functions.empty() ? library : functions;
  for (char &c : site.name) if (c == ' ') c = '_';
  return site;
}

// Found once for each way to a call: looking up names takes far longer than MPI
const Site &site()
{
  static std::map<std::vector<void *>, Site> known;
  void *frames[64];
  const int n = backtrace(frames, 64);
  const std::vector<void *> key(frames, frames + n);
  auto found = known.find(key);
  if (found == known.end()) found = known.emplace(key, site_of(key)).first;
  return found->second;
}

void collective(const char *name, double size)
{
  Count &count = collectives[std::string(name) + " " + site().name];
  count.calls++;
  count.bytes += size;
}

// OpenFOAM sends to neighbours without waiting. Where it waits for each message it passes something from rank to rank
// for all of them: reduce, gather, scatter
void message(int count, MPI_Datatype type, int to, MPI_Comm comm, bool waits)
{
  if (to == MPI_PROC_NULL) return;
  const Site &from = site();
  const int rank = world(to, comm);
  const bool tree = waits && from.openfoam;
  Messages &here = messages[(tree ? "tree " : "message ") + from.name];
  here.calls++;
  here.bytes += bytes(count, type);
  here.ranks.insert(rank);
  int me;
  PMPI_Comm_rank(MPI_COMM_WORLD, &me);
  if (tree && rank < me) collective("up", bytes(count, type));
}

void write(int me)
{
  static bool written = false;
  const char *path = getenv("GRAINJET_MPI_COUNTS");
  if (!path || written) return;
  written = true;
  FILE *out = fopen((std::string(path) + "." + std::to_string(me)).c_str(), "w");
  if (!out) return;
  const auto line = [out](const std::string &key, const Count &count) {
    const size_t blank = key.find(' ');
    fprintf(out, "%s %ld %.0f %s", key.substr(0, blank).c_str(), count.calls, count.bytes, key.substr(blank + 1).c_str());
  };
  for (const auto &entry : messages) {
    line(entry.first, entry.second);
    const char *between = " ";
    for (const int rank : entry.second.ranks) {
      fprintf(out, "%s%d", between, rank);
      between = ",";
    }
    fprintf(out, "\n");
  }
  for (const auto &entry : collectives) {
    line(entry.first, entry.second);
    fprintf(out, "\n");
  }
  if (FILE *status = fopen("/proc/self/status", "r")) {
    char line[256];
    long kb;
    while (fgets(line, sizeof(line), status))
      if (sscanf(line, "RssAnon: %ld", &kb) == 1) fprintf(out, "memory %ld\n", kb);
    fclose(status);
  }
  fclose(out);
}

// A solver on one rank does not start MPI
__attribute__((destructor)) void at_exit()
{
  write(0);
}

}

#define SEND(Name) \
  int MPI_##Name(const void *b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c) \
  { message(n, t, to, c, true); return PMPI_##Name(b, n, t, to, tag, c); }

#define ISEND(Name) \
  int MPI_##Name(const void *b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c, MPI_Request *r) \
  { message(n, t, to, c, false); return PMPI_##Name(b, n, t, to, tag, c, r); }

extern "C" {

SEND(Send)
SEND(Bsend)
SEND(Ssend)
SEND(Rsend)
ISEND(Isend)
ISEND(Ibsend)
ISEND(Issend)
ISEND(Irsend)

int MPI_Sendrecv(const void *b, int n, MPI_Datatype t, int to, int tag, void *rb, int rn, MPI_Datatype rt, int from, int rtag,
  MPI_Comm c, MPI_Status *s)
{
  message(n, t, to, c, true);
  return PMPI_Sendrecv(b, n, t, to, tag, rb, rn, rt, from, rtag, c, s);
}

int MPI_Barrier(MPI_Comm c)
{
  collective("Barrier", 0);
  return PMPI_Barrier(c);
}

int MPI_Bcast(void *b, int n, MPI_Datatype t, int root, MPI_Comm c)
{
  collective("Bcast", bytes(n, t));
  return PMPI_Bcast(b, n, t, root, c);
}

int MPI_Reduce(const void *b, void *r, int n, MPI_Datatype t, MPI_Op op, int root, MPI_Comm c)
{
  collective("Reduce", bytes(n, t));
  return PMPI_Reduce(b, r, n, t, op, root, c);
}

int MPI_Allreduce(const void *b, void *r, int n, MPI_Datatype t, MPI_Op op, MPI_Comm c)
{
  collective("Allreduce", bytes(n, t));
  return PMPI_Allreduce(b, r, n, t, op, c);
}

int MPI_Ibarrier(MPI_Comm c, MPI_Request *q)
{
  collective("Ibarrier", 0);
  return PMPI_Ibarrier(c, q);
}

int MPI_Iallreduce(const void *b, void *r, int n, MPI_Datatype t, MPI_Op op, MPI_Comm c, MPI_Request *q)
{
  collective("Iallreduce", bytes(n, t));
  return PMPI_Iallreduce(b, r, n, t, op, c, q);
}

int MPI_Scan(const void *b, void *r, int n, MPI_Datatype t, MPI_Op op, MPI_Comm c)
{
  collective("Scan", bytes(n, t));
  return PMPI_Scan(b, r, n, t, op, c);
}

int MPI_Gather(const void *b, int n, MPI_Datatype t, void *r, int rn, MPI_Datatype rt, int root, MPI_Comm c)
{
  collective("Gather", bytes(n, t));
  return PMPI_Gather(b, n, t, r, rn, rt, root, c);
}

int MPI_Gatherv(const void *b, int n, MPI_Datatype t, void *r, const int *rn, const int *at, MPI_Datatype rt, int root, MPI_Comm c)
{
  collective("Gatherv", bytes(n, t));
  return PMPI_Gatherv(b, n, t, r, rn, at, rt, root, c);
}

int MPI_Scatter(const void *b, int n, MPI_Datatype t, void *r, int rn, MPI_Datatype rt, int root, MPI_Comm c)
{
  collective("Scatter", bytes(rn, rt));
  return PMPI_Scatter(b, n, t, r, rn, rt, root, c);
}

int MPI_Scatterv(const void *b, const int *n, const int *at, MPI_Datatype t, void *r, int rn, MPI_Datatype rt, int root, MPI_Comm c)
{
  collective("Scatterv", bytes(rn, rt));
  return PMPI_Scatterv(b, n, at, t, r, rn, rt, root, c);
}

int MPI_Reduce_scatter(const void *b, void *r, const int *n, MPI_Datatype t, MPI_Op op, MPI_Comm c)
{
  int ranks;
  PMPI_Comm_size(c, &ranks);
  double size = 0;
  for (int i = 0; i < ranks; i++) size += bytes(n[i], t);
  collective("Reduce_scatter", size);
  return PMPI_Reduce_scatter(b, r, n, t, op, c);
}

int MPI_Allgather(const void *b, int n, MPI_Datatype t, void *r, int rn, MPI_Datatype rt, MPI_Comm c)
{
  collective("Allgather", bytes(n, t));
  return PMPI_Allgather(b, n, t, r, rn, rt, c);
}

int MPI_Allgatherv(const void *b, int n, MPI_Datatype t, void *r, const int *rn, const int *at, MPI_Datatype rt, MPI_Comm c)
{
  collective("Allgatherv", bytes(n, t));
  return PMPI_Allgatherv(b, n, t, r, rn, at, rt, c);
}

int MPI_Alltoall(const void *b, int n, MPI_Datatype t, void *r, int rn, MPI_Datatype rt, MPI_Comm c)
{
  int ranks;
  PMPI_Comm_size(c, &ranks);
  collective("Alltoall", ranks * bytes(n, t));
  return PMPI_Alltoall(b, n, t, r, rn, rt, c);
}

int MPI_Alltoallv(const void *b, const int *n, const int *at, MPI_Datatype t, void *r, const int *rn, const int *rat,
  MPI_Datatype rt, MPI_Comm c)
{
  int ranks;
  PMPI_Comm_size(c, &ranks);
  double size = 0;
  for (int i = 0; i < ranks; i++) size += bytes(n[i], t);
  collective("Alltoallv", size);
  return PMPI_Alltoallv(b, n, at, t, r, rn, rat, rt, c);
}

int MPI_Finalize()
{
  int me;
  PMPI_Comm_rank(MPI_COMM_WORLD, &me);
  write(me);
  return PMPI_Finalize();
}

}
