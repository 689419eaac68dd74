# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Tests are found by themselves: drop a file into the folder `tests` of what it tests.
#   <part>/tests/test_*.cpp   GoogleTest without LIGGGHTS and OpenFOAM (the headers of physics/)
#   <part>/tests/case_*.py    a case-level test (Python unittest) that drives the real programs
# A case-level test may state in comments how many of the machine's processors it occupies, that it takes
# more than 10 s on a free machine, and where other modules are that those of its part import:
#   # processors: 2
#   # label: long
#   # modules: cases/common
# Labels for `ctest -L <label>`: unit (GoogleTest), fast (unit tests, and case-level ones of up to 10 s), long (the
# others).
# One that cannot run here ends with code 77 after it said why: ctest counts it as skipped.
# A case-level test finds the package grainjet and the modules of the part it tests by PYTHONPATH.

find_package(GTest REQUIRED)
find_package(Python3 REQUIRED COMPONENTS Interpreter)

function(grainjet_find_tests)
  foreach(folder ${ARGN})
    file(GLOB_RECURSE units CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/test_*.cpp)
    foreach(source ${units})
      get_filename_component(name ${source} NAME_WE)
      get_filename_component(part ${source} DIRECTORY)
      get_filename_component(part ${part} DIRECTORY)
      get_filename_component(part ${part} NAME)
      set(target ${part}_${name})
      add_executable(${target} ${source})
      target_compile_options(${target} PRIVATE -Wall -Wextra)
      target_include_directories(${target} PRIVATE ${CMAKE_SOURCE_DIR}/liggghts-plugins)
      target_link_libraries(${target} PRIVATE GTest::gtest_main)
      add_test(NAME ${part}.${name} COMMAND ${target})
      set_tests_properties(${part}.${name} PROPERTIES LABELS "unit;fast")
    endforeach()

    file(GLOB_RECURSE casetests CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/case_*.py)
    foreach(script ${casetests})
      get_filename_component(name ${script} NAME_WE)
      get_filename_component(folder_of_part ${script} DIRECTORY)
      get_filename_component(folder_of_part ${folder_of_part} DIRECTORY)
      get_filename_component(part ${folder_of_part} NAME)
      set(test ${part}.${name})
      add_test(NAME ${test} COMMAND ${Python3_EXECUTABLE} ${script} -v)
      file(STRINGS ${script} line REGEX "^# processors: [0-9]+" LIMIT_COUNT 1)
      string(REGEX MATCH "[0-9]+" processors "${line}")
      if(NOT processors)
        set(processors 1)
      endif()
      file(STRINGS ${script} label REGEX "^# label: [a-z]+$" LIMIT_COUNT 1)
      string(REGEX REPLACE "^# label: " "" label "${label}")
      if(NOT label)
        set(label fast)
      elseif(NOT label STREQUAL "long")
        message(FATAL_ERROR "${script}: the label '${label}' is not one of: long")
      endif()
      # in a fresh folder ctest knows no times: long tests first, or one of them is left for the end, alone
      set(cost 0)
      if(label STREQUAL "long")
        math(EXPR cost "10*${processors}")
      endif()
      set(modules ${CMAKE_SOURCE_DIR}/validation/testing:${folder_of_part})
      file(STRINGS ${script} line REGEX "^# modules: [a-zA-Z/]+$" LIMIT_COUNT 1)
      if(line)
        string(REGEX REPLACE "^# modules: " "" line "${line}")
        string(APPEND modules ":${CMAKE_SOURCE_DIR}/${line}")
      endif()
      set_tests_properties(${test} PROPERTIES LABELS ${label}
        ENVIRONMENT "PYTHONPATH=${modules};PYTHONDONTWRITEBYTECODE=1"
        PROCESSORS ${processors} COST ${cost} TIMEOUT 900 SKIP_RETURN_CODE 77)
    endforeach()
  endforeach()
endfunction()
