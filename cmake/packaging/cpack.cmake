# The Debian packages that scripts/package makes: the tool, and the library with what it needs to be linked, which is
# a gigabyte that nobody wants who draws plans.
set(PLUMBLINE_MAINTAINER "Plumbline maintainers <maintainers@plumbline.invalid>"
    CACHE STRING "Who answers for packages: name and address")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each has its own
set(CPACK_PACKAGE_CONTACT ${PLUMBLINE_MAINTAINER})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL tool library)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/debian.cmake) # what Debian has elsewhere or otherwise
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)

set(CPACK_DEBIAN_TOOL_PACKAGE_NAME plumbline)
set(CPACK_DEBIAN_TOOL_PACKAGE_SECTION science)
set(CPACK_DEBIAN_TOOL_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENT_TOOL_DESCRIPTION
"provably correct planar arrangements of drawings
Reads the lines of a drawing (SVG, DXF, GeoJSON, WKT, CSV, ...) exactly,
decides every crossing, overlap, room, hole and nesting in exact arithmetic,
and writes rooms and noded lines in the formats of CAD and GIS.

Compares the results of float programs, LAR among them, with the exact one,
and names what is wrong with a drawing, in the drawing's own elements.")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libplumbline-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS
    "libcgal-dev, libeigen3-dev, libfmt-dev, libgmp-dev, libmpfr-dev, libpugixml-dev, libtbb-dev, libxxhash-dev, zlib1g-dev, pkg-config")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SUGGESTS plumbline)
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION
"provably correct planar arrangements, C++20 library
Arranges line segments in the plane exactly, on rational coordinates, rounds
the result so that it stays valid, and compares it with other results.

This package has the headers and a static library.")

include(CPack)
