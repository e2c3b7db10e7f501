include(CMakePackageConfigHelpers)

install(TARGETS Protrusion_segmentation EXPORT Protrusion_segmentationTargets)
install(DIRECTORY include/CGAL DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Protrusion_segmentation)
install(EXPORT Protrusion_segmentationTargets NAMESPACE CGAL:: DESTINATION ${config_folder})
configure_package_config_file(cmake/Protrusion_segmentationConfig.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/Protrusion_segmentationConfig.cmake INSTALL_DESTINATION ${config_folder})
write_basic_package_version_file(
  ${CMAKE_CURRENT_BINARY_DIR}/Protrusion_segmentationConfigVersion.cmake
  COMPATIBILITY SameMajorVersion ARCH_INDEPENDENT)
install(FILES
  cmake/Protrusion_segmentationComponents.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/Protrusion_segmentationConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/Protrusion_segmentationConfigVersion.cmake
  DESTINATION ${config_folder})
install(FILES cmake/compiled/minimum_cut_method.cpp cmake/compiled/histogram_method.cpp cmake/compiled/canonical_surface.cpp
  DESTINATION ${config_folder}/compiled)

set(documentation_folder ${CMAKE_INSTALL_DATAROOTDIR}/doc/protrusion-segmentation)
install(FILES README.md CHANGES.md DESTINATION ${documentation_folder})
install(DIRECTORY examples/Protrusion_segmentation/ DESTINATION ${documentation_folder}/examples)
if(PROTRUSION_SEGMENTATION_BUILD_DOC)
  install(DIRECTORY ${PROJECT_BINARY_DIR}/html COMPONENT doc
    DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/protrusion-segmentation-doc)
endif()

# What Debian's policy wants of every package: its licence and its changes.
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)
if(DEFINED ENV{DEBFULLNAME} AND DEFINED ENV{DEBEMAIL})
  set(CPACK_PACKAGE_CONTACT "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
else()
  set(CPACK_PACKAGE_CONTACT "The Protrusion_segmentation authors <nobody@localhost>")
endif()
find_program(GZIP_PROGRAM gzip)
mark_as_advanced(GZIP_PROGRAM)
if(NOT GZIP_PROGRAM) # as on Windows
  return()
endif()
configure_file(cmake/debian/changelog.in changelog @ONLY)
execute_process(COMMAND ${GZIP_PROGRAM} -9nf changelog WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} COMMAND_ERROR_IS_FATAL ANY)
function(protrusion_install_debian_documents folder)
  install(FILES cmake/debian/copyright ${PROJECT_BINARY_DIR}/changelog.gz DESTINATION ${folder} ${ARGN})
endfunction()
protrusion_install_debian_documents(${documentation_folder})
if(PROTRUSION_SEGMENTATION_BUILD_TOOLS)
  protrusion_install_debian_documents(${CMAKE_INSTALL_DATAROOTDIR}/doc/protrusion-segmentation-tools COMPONENT tools)
endif()
if(TARGET protrusion_segmentation_python AND NOT PROTRUSION_SEGMENTATION_PYTHON_FOLDER STREQUAL ".")
  protrusion_install_debian_documents(${CMAKE_INSTALL_DATAROOTDIR}/doc/python3-protrusion-segmentation
    COMPONENT python EXCLUDE_FROM_ALL)
endif()
if(PROTRUSION_SEGMENTATION_BUILD_DOC)
  protrusion_install_debian_documents(${CMAKE_INSTALL_DATAROOTDIR}/doc/protrusion-segmentation-doc COMPONENT doc)
endif()
