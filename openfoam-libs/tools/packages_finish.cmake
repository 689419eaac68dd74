# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Run by cpack when all files of a package lie in place: strips libraries; the package of Debian gets its
# changelogs and compressed pages as Debian has them.

cmake_policy(VERSION 3.18)
set(place ${CPACK_TEMPORARY_INSTALL_DIRECTORY})

# run(<command>...): stop if it fails
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE failed)
  if(failed)
    list(JOIN ARGN " " words)
    message(FATAL_ERROR "failed: ${words}")
  endif()
endfunction()

file(GLOB_RECURSE objects LIST_DIRECTORIES false ${place}/*.so)
foreach(object ${objects})
  if(NOT IS_SYMLINK ${object})
    run(${CPACK_GRAINJET_STRIP} --strip-unneeded --remove-section=.comment ${object})
  endif()
endforeach()
# files of a checkout may be writable for a group
run(chmod -R u=rwX,go=rX ${place})

set(doc ${place}/usr/share/doc/grainjet)
if(EXISTS ${doc})
  file(RENAME ${doc}/docs/CHANGELOG.md ${doc}/changelog)
  file(CREATE_LINK ../changelog.gz ${doc}/docs/CHANGELOG.md.gz SYMBOLIC)
  # the first entry of the changelog is that of this version
  file(READ ${doc}/changelog changes)
  string(REGEX MATCH "\n## ([0-9.]+), ([0-9-]+)\n" line "${changes}")
  if(NOT CMAKE_MATCH_1 STREQUAL CPACK_PACKAGE_VERSION)
    message(FATAL_ERROR "docs/CHANGELOG.md begins with version '${CMAKE_MATCH_1}', this is ${CPACK_PACKAGE_VERSION}: add its entry")
  endif()
  execute_process(COMMAND date -u -R -d ${CMAKE_MATCH_2} OUTPUT_VARIABLE day OUTPUT_STRIP_TRAILING_WHITESPACE)
  file(WRITE ${doc}/changelog.Debian "grainjet (${CPACK_PACKAGE_VERSION}-1) unstable; urgency=medium\n\n"
    "  * Version ${CPACK_PACKAGE_VERSION}, see changelog.gz.\n\n -- ${CPACK_PACKAGE_CONTACT}  ${day}\n")
  run(gzip -9n ${doc}/changelog ${doc}/changelog.Debian ${place}/usr/share/man/man1/liggghts-plugins.1)
  run(chmod -R u=rwX,go=rX ${doc})
endif()
