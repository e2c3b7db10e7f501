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

# Where Debian's policy wants them.
set(documentation_folder ${CMAKE_INSTALL_DATAROOTDIR}/doc/protrusion-segmentation)
install(FILES README.md CHANGES.md DESTINATION ${documentation_folder})
install(FILES LICENSE DESTINATION ${documentation_folder} RENAME copyright)
