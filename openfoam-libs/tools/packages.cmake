# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What is packed and where it goes. `./Allwmake -package` calls it; what users do with it: docs/installing.md.
#   archive   grainjet-<version>-<OpenFOAM>-<processor>.tar.xz: one folder with the same parts as the one that is
#             built in, for any place
#   debian    grainjet_<version>_<architecture>.deb: only if LIGGGHTS and OpenFOAM are packages, on which it depends

set(GRAINJET_FOAM_USER_LIBBIN ${GRAINJET_LIB} CACHE PATH "Folder of Grainjet's OpenFOAM libraries")
set(GRAINJET_FOAM_LIBBIN /usr/lib CACHE PATH "Folder of the OpenFOAM that they are linked with")
set(GRAINJET_FOAM_VERSION v1912 CACHE STRING "Version of that OpenFOAM")

# names the builds that plugins and libraries belong to; the cases compare it (cases/common/job.sh)
get_directory_property(host DIRECTORY liggghts-plugins DEFINITION LIGGGHTS_HOST)
file(WRITE ${CMAKE_BINARY_DIR}/built-for "OpenFOAM ${GRAINJET_FOAM_VERSION}\n${host}\n")

# grainjet_install(<component> <folder of plugins and libraries> <of cases, programs> <of pages>)
function(grainjet_install component binaries data pages)
  set(part COMPONENT ${component} EXCLUDE_FROM_ALL)
  set(read_only PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
  install(TARGETS liggghtsloader hertzcgplugin collisionstatsplugin platestatsplugin surfacestatsplugin fluidforceplugin fluidheatplugin
    grainmotionplugin wallroughnessplugin
    LIBRARY DESTINATION ${binaries} ${part} ${read_only})
  foreach(name jetTurbulenceModels jetVoFphaseTurbulenceModels jetTwoPhaseMixtureTurbulenceModels
      particleSamplingPlanes liggghtsCoupling)
    install(FILES ${GRAINJET_FOAM_USER_LIBBIN}/lib${name}.so DESTINATION ${binaries} ${part})
  endforeach()
  # not with every OpenFOAM
  install(FILES ${GRAINJET_FOAM_USER_LIBBIN}/libjetReactingPhaseTurbulenceModels.so DESTINATION ${binaries} ${part}
    OPTIONAL)

  install(PROGRAMS liggghts-plugins/loader/liggghts-plugins DESTINATION ${data}/bin ${part})
  install(FILES environment ${CMAKE_BINARY_DIR}/built-for DESTINATION ${data} ${part})
  # without tests and what a run leaves behind
  install(DIRECTORY cases DESTINATION ${data} ${part} USE_SOURCE_PERMISSIONS
    REGEX "/(tests|runs|__pycache__|results|postProcessing|polyMesh|particles|VTK|begun|\\.gitignore)$" EXCLUDE
    REGEX "/(log\\.|processor|stage\\.)[^/]*$" EXCLUDE
    REGEX "\\.foam$" EXCLUDE
    REGEX "/((quickJet|elbow|coldSpray)(/spinUp)?|fluidBed|waterJet|sandblast|jetMill|coldSpray/isentropic)/(0|0\\.[0-9][^/]*|[1-9][^/]*)$" EXCLUDE
    REGEX "/quickJet/spinUp/constant$" EXCLUDE)
  install(DIRECTORY validation/plots DESTINATION ${data}/validation ${part} USE_SOURCE_PERMISSIONS
    REGEX "/(tests|__pycache__)$" EXCLUDE)
  install(DIRECTORY validation/testing/grainjet DESTINATION ${data}/validation/testing ${part}
    REGEX "/(tests|__pycache__)$" EXCLUDE)
  install(DIRECTORY docs DESTINATION ${pages} ${part} USE_SOURCE_PERMISSIONS
    REGEX "/(tests|site|build-site|__pycache__)$" EXCLUDE)
  install(FILES README.md DESTINATION ${pages} ${part})
endfunction()

# grainjet_link(<component> <file> <what it points to>)
function(grainjet_link component file target)
  install(CODE "
    set(link \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${file}\")
    get_filename_component(folder \"\${link}\" DIRECTORY)
    file(MAKE_DIRECTORY \"\${folder}\")
    file(CREATE_LINK ${target} \"\${link}\" SYMBOLIC)" COMPONENT ${component} EXCLUDE_FROM_ALL)
endfunction()

grainjet_install(archive lib . .)
install(FILES COPYING DESTINATION . COMPONENT archive EXCLUDE_FROM_ALL)

# The coupling looks for plugins beside its real file, so all libraries lie in one folder. Solvers find those
# of OpenFOAM by links among the system's libraries, Python its package by one, and pages and cases each other.
set(system_libraries lib/${CMAKE_LIBRARY_ARCHITECTURE})
grainjet_install(debian ${system_libraries}/grainjet share/grainjet share/doc/grainjet)
grainjet_link(debian share/grainjet/lib ../../${system_libraries}/grainjet)
grainjet_link(debian share/grainjet/docs ../doc/grainjet/docs)
grainjet_link(debian share/doc/grainjet/cases ../../grainjet/cases)
grainjet_link(debian bin/liggghts-plugins ../share/grainjet/bin/liggghts-plugins)
grainjet_link(debian lib/python3/dist-packages/grainjet ../../../share/grainjet/validation/testing/grainjet)
foreach(name jetTurbulenceModels jetVoFphaseTurbulenceModels jetTwoPhaseMixtureTurbulenceModels
    jetReactingPhaseTurbulenceModels particleSamplingPlanes liggghtsCoupling)
  if(NOT name STREQUAL jetReactingPhaseTurbulenceModels OR EXISTS ${GRAINJET_FOAM_USER_LIBBIN}/lib${name}.so)
    grainjet_link(debian ${system_libraries}/lib${name}.so grainjet/lib${name}.so)
  endif()
endforeach()
set(debian ${CMAKE_CURRENT_LIST_DIR}/debian)
install(FILES ${debian}/copyright DESTINATION share/doc/grainjet COMPONENT debian EXCLUDE_FROM_ALL)
install(FILES ${debian}/lintian-overrides DESTINATION share/lintian/overrides RENAME grainjet
  COMPONENT debian EXCLUDE_FROM_ALL)
install(FILES ${debian}/liggghts-plugins.1 DESTINATION share/man/man1 COMPONENT debian EXCLUDE_FROM_ALL)

# package_of(<variable> <file>): "name version" of the package that a file is of, empty if there is none
function(package_of variable file)
  set(found "")
  get_filename_component(file "${file}" REALPATH)
  execute_process(COMMAND dpkg-query -S "${file}" OUTPUT_VARIABLE owner ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed)
    string(REGEX REPLACE "[:,].*" "" owner "${owner}")
    execute_process(COMMAND dpkg-query -W -f "\${Version}" ${owner} OUTPUT_VARIABLE version)
    set(found ${owner} ${version})
  endif()
  set(${variable} "${found}" PARENT_SCOPE)
endfunction()

# ./Allwmake has built all of it before
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
set(CPACK_PACKAGE_NAME grainjet)
set(CPACK_PACKAGE_VENDOR "The Grainjet developers")
# whoever makes the package is asked about it; Debian's own tools read this variable too
set(maker grainjet@localhost)
if(DEFINED ENV{DEBEMAIL})
  set(maker $ENV{DEBEMAIL})
endif()
set(CPACK_PACKAGE_CONTACT "The Grainjet developers <${maker}>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "coarse-grained CFD-DEM for particle-laden jets")
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_PACKAGE_FILE_NAME grainjet-${PROJECT_VERSION}-openfoam-${GRAINJET_FOAM_VERSION}-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_LIST_DIR}/packages_config.cmake)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/packages_finish.cmake)
set(CPACK_GRAINJET_STRIP ${CMAKE_STRIP})
set(CPACK_GENERATOR TXZ)

get_directory_property(library DIRECTORY liggghts-plugins DEFINITION LIGGGHTS_LIBRARY)
package_of(liggghts "${library}")
package_of(openfoam "${GRAINJET_FOAM_LIBBIN}/libOpenFOAM.so")
find_program(DPKG_SHLIBDEPS dpkg-shlibdeps)
if(liggghts AND openfoam AND DPKG_SHLIBDEPS)
  list(APPEND CPACK_GENERATOR DEB)
  list(GET liggghts 0 liggghts_name)
  list(GET liggghts 1 liggghts_version)
  list(GET openfoam 0 openfoam_name)
  list(GET openfoam 1 openfoam_version)
  # the upstream version of OpenFOAM fixes its classes
  string(REGEX REPLACE "-[^-]*$" "" openfoam_upstream "${openfoam_version}")
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
  set(CPACK_DEBIAN_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
  # the loader refuses another build of LIGGGHTS than the one that it was compiled for
  string(JOIN ", " CPACK_DEBIAN_PACKAGE_DEPENDS
    "${liggghts_name} (= ${liggghts_version})" liggghts
    "${openfoam_name} (>= ${openfoam_upstream})" "${openfoam_name} (<< ${openfoam_upstream}.)" openfoam
    openmpi-bin python3 python3-matplotlib python3-numpy python3-scipy python3-vtk9
    "python3 (>= 3.11) | python3-tomli")
  set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${debian}/postinst ${debian}/prerm)
  set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
  set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Libraries that drop into the stock programs of OpenFOAM and LIGGGHTS: a
source term that runs LIGGGHTS inside a solver and exchanges momentum with
the grains, contacts of coarse-grained particles, statistics of a plate,
a k-epsilon model for round jets, radial profiles of particles. With cases
that run by one command, and pages.")
endif()
include(CPack)
