# The folders that CGAL takes are projects of their own, which know nothing of the package around them. As parts of
# this one their programs get its options, precompiled headers and tests.

# CGAL's function would run tests in a copy of their folder, and the build tool before each of them. (As a part of
# another project, which may have tests by CGAL's means, this one has none.)
if(PROJECT_IS_TOP_LEVEL)
  function(cgal_add_test name)
    if(BUILD_TESTING AND NOT "NO_EXECUTION" IN_LIST ARGN AND NOT TEST ${name})
      add_test(NAME ${name} COMMAND ${name} WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
      # CGAL_TEST_SUITE: no window is opened
      set_tests_properties(${name} PROPERTIES TIMEOUT 600 ENVIRONMENT CGAL_TEST_SUITE=1)
    endif()
  endfunction()
endif()

# protrusion_add_cgal_folder(test|examples|benchmark)
function(protrusion_add_cgal_folder folder)
  if(NOT PROTRUSION_SEGMENTATION_WITH_TBB)
    set(CMAKE_DISABLE_FIND_PACKAGE_TBB TRUE)
  endif()
  add_subdirectory(${folder}/Protrusion_segmentation)
  get_property(programs DIRECTORY ${folder}/Protrusion_segmentation PROPERTY BUILDSYSTEM_TARGETS)
  foreach(program ${programs})
    get_target_property(type ${program} TYPE)
    if(NOT type STREQUAL "EXECUTABLE")
      continue()
    endif()
    # Several threads of the test's own, without TBB, which the thread sanitizer does not know.
    if(program STREQUAL "test_reentrancy" AND PROTRUSION_SEGMENTATION_SANITIZERS STREQUAL "thread")
      target_link_libraries(${program} PRIVATE protrusion_sanitizers)
      continue()
    endif()
    target_link_libraries(${program} PRIVATE protrusion_program)
    get_target_property(sources ${program} SOURCES)
    if(sources MATCHES "Quality/read_mesh\\.cpp") # which reads as the tools do if it can; the paths are absolute
      target_link_libraries(${program} PRIVATE protrusion_mesh_reader)
    endif()
  endforeach()
endfunction()
