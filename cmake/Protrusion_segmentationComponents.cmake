# protrusion_segmentation_find_component(NAME)
#
# Looks for a library that some headers of the package need, and defines the target
# CGAL::Protrusion_segmentation_<NAME> if it is there:
#
#   Eigen     for Heat_distance.h (Debian: libeigen3-dev)
#   Spectra   for Diffusion_distance.h, with Eigen (Debian: libspectra-dev)
#   TBB       for computing with several threads (Debian: libtbb-dev)
#
# Sets Protrusion_segmentation_<NAME>_FOUND. CGAL has been found before. The targets are those of CGAL's
# own support modules: by them CGAL knows, too, that the library may be used.

# The methods as a static library, which is compiled once in the project that links
# CGAL::Protrusion_segmentation_compiled in place of CGAL::Protrusion_segmentation, with that project's options.
if(NOT TARGET Protrusion_segmentation_compiled)
  set(protrusion_segmentation_methods minimum_cut_method histogram_method canonical_surface)
  list(TRANSFORM protrusion_segmentation_methods
       REPLACE "(.+)" "${CMAKE_CURRENT_LIST_DIR}/compiled/\\1.cpp")
  set_source_files_properties(${protrusion_segmentation_methods} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  add_library(Protrusion_segmentation_compiled STATIC EXCLUDE_FROM_ALL ${protrusion_segmentation_methods})
  add_library(CGAL::Protrusion_segmentation_compiled ALIAS Protrusion_segmentation_compiled)
  target_link_libraries(Protrusion_segmentation_compiled PUBLIC CGAL::Protrusion_segmentation)
  target_compile_definitions(Protrusion_segmentation_compiled INTERFACE CGAL_PROTRUSION_SEGMENTATION_COMPILED)
  set_target_properties(Protrusion_segmentation_compiled PROPERTIES POSITION_INDEPENDENT_CODE ON)
endif()

macro(protrusion_segmentation_find_component name)
  set(Protrusion_segmentation_${name}_FOUND FALSE)
  set(protrusion_segmentation_needs)
  if("${name}" STREQUAL "Eigen")
    find_package(Eigen3 3.3.7 QUIET)
    include(CGAL_Eigen3_support OPTIONAL)
    set(protrusion_segmentation_needs CGAL::Eigen3_support)
  elseif("${name}" STREQUAL "Spectra")
    protrusion_segmentation_find_component(Eigen)
    set(protrusion_segmentation_needs)
    find_path(SPECTRA_INCLUDE_DIR Spectra/SymEigsSolver.h)
    mark_as_advanced(SPECTRA_INCLUDE_DIR)
    if(SPECTRA_INCLUDE_DIR)
      set(protrusion_segmentation_needs CGAL::Protrusion_segmentation_Eigen)
    endif()
  elseif("${name}" STREQUAL "TBB")
    find_package(TBB QUIET)
    include(CGAL_TBB_support OPTIONAL)
    set(protrusion_segmentation_needs CGAL::TBB_support)
  endif()

  if(protrusion_segmentation_needs AND TARGET ${protrusion_segmentation_needs})
    set(Protrusion_segmentation_${name}_FOUND TRUE)
    if(NOT TARGET CGAL::Protrusion_segmentation_${name})
      add_library(CGAL::Protrusion_segmentation_${name} INTERFACE IMPORTED)
      target_link_libraries(CGAL::Protrusion_segmentation_${name}
        INTERFACE ${protrusion_segmentation_needs})
      if("${name}" STREQUAL "Spectra")
        target_include_directories(CGAL::Protrusion_segmentation_${name} SYSTEM
          INTERFACE ${SPECTRA_INCLUDE_DIR})
      endif()
    endif()
  endif()
endmacro()
