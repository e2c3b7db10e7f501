# `cpack` makes a Debian package of the headers and the examples; one of the command line tools if they are built; one of the
# Python module if that is built; and one of the manuals if PROTRUSION_SEGMENTATION_BUILD_DOC is set.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME protrusion-segmentation)
set(CPACK_PACKAGE_VENDOR "The Protrusion_segmentation authors")
file(READ package_info/Protrusion_segmentation/long_description.txt CPACK_PACKAGE_DESCRIPTION)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_STRIP_FILES ON)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
# What the programs are linked with is found out by dpkg-shlibdeps.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL Unspecified)

# Of all that is installed without a component; the dependencies are what the headers include.
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_NAME protrusion-segmentation)
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_DEPENDS "libcgal-dev (>= 5.5)")
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_RECOMMENDS "g++, cmake, libeigen3-dev, libspectra-dev, libtbb-dev, protrusion-segmentation-tools")
set(CPACK_COMPONENT_UNSPECIFIED_DESCRIPTION "${CPACK_PACKAGE_DESCRIPTION}")

if(PROTRUSION_SEGMENTATION_BUILD_TOOLS)
  list(APPEND CPACK_COMPONENTS_ALL tools)
  set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME protrusion-segmentation-tools)
  set(CPACK_DEBIAN_TOOLS_PACKAGE_SECTION graphics)
  set(CPACK_COMPONENT_TOOLS_DESCRIPTION "${CPACK_PACKAGE_DESCRIPTION}")
endif()

# The module is compiled for one minor version of Python.
if(TARGET protrusion_segmentation_python)
  get_target_property(minor protrusion_segmentation_python PYTHON_MINOR_VERSION)
  math(EXPR next_minor "${minor} + 1")
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-protrusion-segmentation)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.${minor}), python3 (<< 3.${next_minor}), python3-numpy")
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "${CPACK_PACKAGE_DESCRIPTION}")
endif()

if(PROTRUSION_SEGMENTATION_BUILD_DOC)
  list(APPEND CPACK_COMPONENTS_ALL doc)
  set(CPACK_DEBIAN_DOC_PACKAGE_NAME protrusion-segmentation-doc)
  set(CPACK_DEBIAN_DOC_PACKAGE_SECTION doc)
  set(CPACK_DEBIAN_DOC_PACKAGE_ARCHITECTURE all)
  set(CPACK_COMPONENT_DOC_DESCRIPTION "${CPACK_PACKAGE_DESCRIPTION}")
endif()
include(CPack)
