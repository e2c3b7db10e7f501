# Of the sources around this file, as long as there is no release to download.
set(VCPKG_BUILD_TYPE release) # headers only
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS
    -DBUILD_TESTING=OFF
    -DPROTRUSION_SEGMENTATION_BUILD_EXAMPLES=OFF
    -DPROTRUSION_SEGMENTATION_BUILD_PYTHON=OFF
    -DPROTRUSION_SEGMENTATION_BUILD_TOOLS=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME Protrusion_segmentation CONFIG_PATH lib/cmake/Protrusion_segmentation)
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/lib" "${CURRENT_PACKAGES_DIR}/share/doc")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
