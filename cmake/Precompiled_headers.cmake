# Headers that many programs include are compiled once, but with clang++ with every program, as in the folders that
# CGAL takes when each is built alone: there a missing #include shows.

if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU" OR PROTRUSION_SEGMENTATION_LITTLE_MEMORY)
  return()
endif()

set(headers
  <CGAL/Simple_cartesian.h> <CGAL/Surface_mesh.h> <CGAL/boost/graph/Euler_operations.h>
  <CGAL/boost/graph/helpers.h> <CGAL/Named_function_parameters.h> <boost/graph/dijkstra_shortest_paths.hpp>
  <algorithm> <array> <cmath> <filesystem> <fstream> <functional> <iostream> <map> <numeric> <optional>
  <random> <set> <sstream> <string> <vector>
  <CGAL/Protrusion_segmentation/Histogram_method.h> <CGAL/protrusion_segmentation.h> <CGAL/segmentation_metrics.h>
  <CGAL/boost/graph/generators.h>)
if(PROTRUSION_SEGMENTATION_LINK_METHODS)
  list(APPEND headers ${CMAKE_CURRENT_LIST_DIR}/compiled_once.h)
endif()

function(protrusion_precompile set options)
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/precompiled_${set}.cpp CONTENT "")
  add_library(precompiled_${set} OBJECT EXCLUDE_FROM_ALL ${CMAKE_CURRENT_BINARY_DIR}/precompiled_${set}.cpp)
  target_link_libraries(precompiled_${set} PRIVATE protrusion_program)
  target_compile_options(precompiled_${set} PRIVATE -fpch-preprocess ${options}) # ccache demands the first
  target_precompile_headers(precompiled_${set} PRIVATE ${ARGN})
endfunction()

protrusion_precompile(optimized "" ${headers})
protrusion_precompile(unoptimized -O0 ${headers})

# For every target with sources of its own that is compiled as programs are.
function(protrusion_reuse_precompiled_headers folder)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target ${targets})
    get_target_property(type ${target} TYPE)
    get_target_property(libraries ${target} LINK_LIBRARIES)
    # What is linked with Qt, as PCL is through VTK, is compiled in another way, and a header that compiles alone does so
    # without others.
    if(target MATCHES "^(precompiled|test_headers)_" OR libraries MATCHES "Basic_viewer|pcl_" OR
       NOT type MATCHES "EXECUTABLE|STATIC_LIBRARY|OBJECT_LIBRARY" OR
       NOT libraries MATCHES "protrusion_(program|mesh_reader|tool_support)")
      continue()
    endif()
    get_target_property(options ${target} COMPILE_OPTIONS)
    set(headers optimized)
    if("-O0" IN_LIST options)
      set(headers unoptimized)
    endif()
    target_precompile_headers(${target} REUSE_FROM precompiled_${headers})
    target_compile_options(${target} PRIVATE -fpch-preprocess)
  endforeach()
  get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(subfolder ${folders})
    protrusion_reuse_precompiled_headers(${subfolder})
  endforeach()
endfunction()

protrusion_reuse_precompiled_headers(${PROJECT_SOURCE_DIR})
