# What every program of the package (example, test, benchmark) is compiled with. The package itself is
# headers only and asks nothing of this from its users.

find_package(Eigen3 3.3 QUIET)
include(CGAL_Eigen3_support OPTIONAL)
if(PROTRUSION_SEGMENTATION_WITH_TBB)
  find_package(TBB QUIET)
  include(CGAL_TBB_support OPTIONAL)
endif()
find_path(SPECTRA_INCLUDE_DIR Spectra/SymEigsSolver.h)
mark_as_advanced(SPECTRA_INCLUDE_DIR)

add_library(protrusion_program INTERFACE)
target_link_libraries(protrusion_program INTERFACE CGAL::Protrusion_segmentation)
foreach(library CGAL::Eigen3_support CGAL::TBB_support)
  if(TARGET ${library})
    target_link_libraries(protrusion_program INTERFACE ${library})
  endif()
endforeach()
if(PROTRUSION_SEGMENTATION_STRICT_WARNINGS)
  target_compile_options(protrusion_program INTERFACE -Wall -Wextra -Werror)
endif()
if(PROTRUSION_SEGMENTATION_SANITIZERS)
  target_compile_options(protrusion_program INTERFACE
    -fsanitize=${PROTRUSION_SEGMENTATION_SANITIZERS} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  # CGAL's reader of OFF files converts every number to an index, negative ones too, which are refused later.
  target_compile_options(protrusion_program INTERFACE
    $<$<CXX_COMPILER_ID:Clang>:-fno-sanitize=float-cast-overflow>)
  target_link_options(protrusion_program INTERFACE
    -fsanitize=${PROTRUSION_SEGMENTATION_SANITIZERS})
endif()

# protrusion_add_program(NAME SOURCE... [LIBRARIES LIBRARY...])
function(protrusion_add_program name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "LIBRARIES")
  add_executable(${name} ${ARG_UNPARSED_ARGUMENTS})
  target_link_libraries(${name} PRIVATE protrusion_program ${ARG_LIBRARIES})
endfunction()
