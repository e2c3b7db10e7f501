# What every program of the package (tool, example, test, benchmark) is compiled with. The package itself is
# headers only and asks nothing of this from its users.

include(${CMAKE_CURRENT_LIST_DIR}/Protrusion_segmentationComponents.cmake)
set(components Eigen Spectra)
if(PROTRUSION_SEGMENTATION_WITH_TBB)
  list(APPEND components TBB)
endif()

add_library(protrusion_program INTERFACE)
# CGAL::Data: a definition if there is a folder data beside or above the project. What shares precompiled headers needs the same.
target_link_libraries(protrusion_program INTERFACE CGAL::Protrusion_segmentation CGAL::Data)
foreach(component ${components})
  protrusion_segmentation_find_component(${component})
  if(Protrusion_segmentation_${component}_FOUND)
    target_link_libraries(protrusion_program INTERFACE CGAL::Protrusion_segmentation_${component})
  endif()
endforeach()
if(PROTRUSION_SEGMENTATION_STRICT_WARNINGS)
  target_compile_options(protrusion_program INTERFACE -Wall -Wextra -Werror)
endif()
# With more memory before it collects garbage, g++ takes a seventh less time.
if(NOT PROTRUSION_SEGMENTATION_LITTLE_MEMORY)
  target_compile_options(protrusion_program INTERFACE
    "$<$<CXX_COMPILER_ID:GNU>:SHELL:--param ggc-min-heapsize=1000000>")
endif()
# The sanitizers, which a program that is not to have the rest takes alone.
add_library(protrusion_sanitizers INTERFACE)
target_link_libraries(protrusion_program INTERFACE protrusion_sanitizers)
if(PROTRUSION_SEGMENTATION_SANITIZERS)
  target_compile_options(protrusion_sanitizers INTERFACE
    -fsanitize=${PROTRUSION_SEGMENTATION_SANITIZERS} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  # CGAL's reader of OFF files converts every number to an index, negative ones too, which are refused later.
  target_compile_options(protrusion_sanitizers INTERFACE
    $<$<CXX_COMPILER_ID:Clang>:-fno-sanitize=float-cast-overflow>
    $<$<CXX_COMPILER_ID:Clang>:-fsanitize-ignorelist=${CMAKE_CURRENT_LIST_DIR}/not_sanitized.txt>)
  target_link_options(protrusion_sanitizers INTERFACE
    -fsanitize=${PROTRUSION_SEGMENTATION_SANITIZERS})
endif()

# The distances that need a library, for programs that link them.
set(protrusion_distances diffusion_distance exact_geodesic_distance heat_distance)
list(TRANSFORM protrusion_distances REPLACE "(.+)" "${CMAKE_CURRENT_LIST_DIR}/compiled/\\1.cpp")

# The methods, distances and test meshes, compiled once for all programs but those that are to have every header as users have it.
if(PROTRUSION_SEGMENTATION_LINK_METHODS)
  target_sources(Protrusion_segmentation_compiled PRIVATE
    ${protrusion_distances} ${CMAKE_CURRENT_LIST_DIR}/compiled_once.cpp)
  target_include_directories(Protrusion_segmentation_compiled PRIVATE
    ${PROJECT_SOURCE_DIR}/test/Protrusion_segmentation/include)
  target_compile_definitions(Protrusion_segmentation_compiled
    INTERFACE CGAL_PROTRUSION_SEGMENTATION_COMPILED_DISTANCES)
  # As much as for users, whatever the tests are compiled with: they run faster, and g++ makes most of the same labels.
  # Eigen's part of the distances takes the compiler several times as long then.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT PROTRUSION_SEGMENTATION_SANITIZERS)
    set_source_files_properties(${protrusion_segmentation_methods} PROPERTIES COMPILE_OPTIONS -O3)
  endif()
  get_target_property(options protrusion_program INTERFACE_LINK_LIBRARIES)
  target_link_libraries(Protrusion_segmentation_compiled PRIVATE ${options})
  get_target_property(options protrusion_program INTERFACE_COMPILE_OPTIONS)
  if(options)
    target_compile_options(Protrusion_segmentation_compiled PRIVATE ${options})
  endif()
  target_link_libraries(protrusion_program INTERFACE Protrusion_segmentation_compiled)
endif()

# protrusion_add_program(NAME SOURCE... [LIBRARIES LIBRARY...])
function(protrusion_add_program name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "LIBRARIES")
  add_executable(${name} ${ARG_UNPARSED_ARGUMENTS})
  target_link_libraries(${name} PRIVATE protrusion_program ${ARG_LIBRARIES})
endfunction()
