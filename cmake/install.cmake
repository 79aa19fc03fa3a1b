include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# What `cmake --install` installs: as component `library` what programs are built with, the rest is the tool's. The
# checker, manual pages and completion are installed where they are made.
install(TARGETS plumbline plumbline_cgal EXPORT plumblineTargets COMPONENT library)
if(TARGET plumbline_cli)
  install(TARGETS plumbline_cli RUNTIME COMPONENT tool)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT library)

# For find_package(plumbline).
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/plumbline)
install(EXPORT plumblineTargets NAMESPACE plumbline:: DESTINATION ${config_dir}
        COMPONENT library)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/plumblineConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/plumblineConfigVersion.cmake
              ${PROJECT_SOURCE_DIR}/cmake/plumblineConfig.cmake
              ${PROJECT_SOURCE_DIR}/cmake/dependencies.cmake DESTINATION ${config_dir}
        COMPONENT library)

# For pkg-config. An archive needs what it uses beside it, a shared library has it.
set(PLUMBLINE_REQUIRES gmpxx eigen3)
set(PLUMBLINE_REQUIRES_INSIDE gmp mpfr libxxhash pugixml zlib fmt tbb)
get_target_property(type plumbline TYPE)
if(type STREQUAL STATIC_LIBRARY)
  list(APPEND PLUMBLINE_REQUIRES ${PLUMBLINE_REQUIRES_INSIDE})
  set(PLUMBLINE_REQUIRES_INSIDE "")
endif()
list(JOIN PLUMBLINE_REQUIRES ", " PLUMBLINE_REQUIRES)
list(JOIN PLUMBLINE_REQUIRES_INSIDE ", " PLUMBLINE_REQUIRES_INSIDE)
# From where the file lies, so that all can be moved together.
cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX
           BASE_DIRECTORY ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig OUTPUT_VARIABLE PLUMBLINE_UP)
configure_file(${PROJECT_SOURCE_DIR}/cmake/plumbline.pc.in ${PROJECT_BINARY_DIR}/plumbline.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/plumbline.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
        COMPONENT library)

# JSON schemas, licences, documents.
set(docs ${PROJECT_SOURCE_DIR}/docs)
install(FILES ${docs}/arrange.schema.json ${docs}/check.schema.json ${docs}/diagnosis.schema.json
              ${docs}/repair.schema.json ${docs}/rooms.schema.json ${docs}/summary.schema.json
        DESTINATION ${CMAKE_INSTALL_DATADIR}/plumbline COMPONENT tool)
install(FILES LICENSE CHANGELOG.md src/web/notices.txt ${docs}/json.md ${docs}/formats.md
              ${docs}/certificate.md ${docs}/divergences.md ${docs}/trust.md
        DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT tool)
