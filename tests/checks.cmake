# Checks of the project as a whole: its sources, its layers and its installed package.
if(PLUMBLINE_SANITIZE)
  return() # the plain build has made them
endif()

set(scripts ${PROJECT_SOURCE_DIR}/scripts)
add_test(NAME "sources: formatted" COMMAND ${scripts}/format --check)
add_test(NAME "sources: clang-tidy finds nothing" COMMAND ${scripts}/tidy ${PROJECT_BINARY_DIR})
add_test(NAME "scripts: shellcheck finds nothing" COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/shellcheck_test.sh)
add_test(NAME "scripts: --help helps and does nothing else"
         COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/scripts_help_test.sh)
file(GLOB validation_scripts ${PROJECT_SOURCE_DIR}/validation/*/run)
add_test(NAME "validation: --help prints help and does nothing else"
         COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/validation_help_test.sh ${validation_scripts})

get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
add_test(NAME "headers: as C++17 they are refused in one sentence"
         COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/cxx17_test.sh ${CMAKE_CXX_COMPILER} -isystem ${eigen})

set(layering ${CMAKE_CURRENT_SOURCE_DIR}/layering.cmake)
add_test(NAME "layers: no include goes up"
         COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR} -DTIGHT=ON -P ${layering})
add_test(NAME "layers: forbidden includes are found"
         COMMAND ${CMAKE_COMMAND} -DROOT=${CMAKE_CURRENT_SOURCE_DIR}/layering -P ${layering})
set_tests_properties("layers: forbidden includes are found" PROPERTIES
                     PASS_REGULAR_EXPRESSION "18 forbidden includes")

add_test(NAME "catalogue: it has the rules that a finding can have, and no other"
         COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR} -P ${CMAKE_CURRENT_SOURCE_DIR}/catalogue.cmake)

# The page of the report: where npm is, its bundle is made again; where Chromium is too, it is
# opened. scripts/deps --browser installs all of that.
find_program(NODE node)
find_program(NPM npm)
find_program(CHROMIUM chromium)
if(NODE AND NPM)
  add_test(NAME "page: the checked-in bundle is what its sources make"
           COMMAND ${scripts}/bundle --check ${PROJECT_BINARY_DIR})
  set_tests_properties("page: the checked-in bundle is what its sources make" PROPERTIES
                       FIXTURES_SETUP page_modules)
  if(CHROMIUM)
    set(report_page "page: what a reader sees and does in a browser")
    set(rooms_page "page: rooms in a browser")
    set(repair_page "page: a repair in a browser")
    foreach(page report rooms repair)
      add_test(NAME ${${page}_page}
               COMMAND ${NODE} ${CMAKE_CURRENT_SOURCE_DIR}/${page}_browser_test.mjs
                       $<TARGET_FILE:plumbline_cli>
                       ${PROJECT_BINARY_DIR}/report-page/node_modules ${CHROMIUM}
                       ${CMAKE_CURRENT_BINARY_DIR}/${page}_browser)
      set_tests_properties(${${page}_page} PROPERTIES FIXTURES_REQUIRED page_modules TIMEOUT 7200)
    endforeach()
  endif()
endif()

find_program(DOXYGEN doxygen)
if(DOXYGEN)
  add_test(NAME "docs: pages are made of the headers without a warning"
           COMMAND ${scripts}/docs ${CMAKE_CURRENT_BINARY_DIR}/docs)
endif()

# A project that uses the installed package.
set(consumer ${CMAKE_CURRENT_BINARY_DIR}/consumer)
add_custom_target(consumer
  COMMAND ${CMAKE_COMMAND} -DBUILD=${PROJECT_BINARY_DIR} -DSCRATCH=${consumer}
          -DCOMPILER=${CMAKE_CXX_COMPILER} -DLAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}
          -P ${CMAKE_CURRENT_SOURCE_DIR}/consumer/build.cmake
  VERBATIM)
add_dependencies(consumer plumbline plumbline_cli plumbline_verify)
add_dependencies(other_builds consumer)
add_test(NAME "package: an installed copy is found and linked" COMMAND ${consumer}/build/consumer)
add_test(NAME "package: pkg-config finds it, too" COMMAND ${consumer}/build/pkg_config_consumer)
add_test(NAME "package: an installed copy is found and linked, with CGAL"
         COMMAND ${consumer}/build/cgal_consumer)

# The checker as it builds alone.
set(checker ${PROJECT_SOURCE_DIR}/src/checker)
set(checker_alone ${CMAKE_CURRENT_BINARY_DIR}/plumbline-verify-alone)
file(GLOB checker_files CONFIGURE_DEPENDS ${checker}/*)
add_custom_command(OUTPUT ${checker_alone}
                   COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/build_checker_alone.sh ${checker} ${checker_alone}
                           -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
                   DEPENDS ${checker_files} build_checker_alone.sh VERBATIM)
add_custom_target(plumbline_verify_alone DEPENDS ${checker_alone})
add_dependencies(other_builds plumbline_verify_alone)
add_test(NAME "verify: the checker built alone does the same"
         COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/verify_cli_test.sh ${checker_alone}
                 $<TARGET_FILE:plumbline_cli> ${PROJECT_SOURCE_DIR}/validation/cases/certificates)

find_program(CLANG clang++)
if(CLANG)
  set(determinism ${scripts}/determinism --short --in ${CMAKE_CURRENT_BINARY_DIR}/determinism)
  add_custom_target(tool_by_clang COMMAND ${determinism} --compile VERBATIM)
  add_dependencies(other_builds tool_by_clang)
  add_test(NAME "determinism: another compiler's tool, unoptimised, writes the same bytes"
           COMMAND ${determinism} $<TARGET_FILE:plumbline_cli>)
  set_tests_properties("determinism: another compiler's tool, unoptimised, writes the same bytes"
                       PROPERTIES TIMEOUT 7200 COST 1000)
endif()

# The longest start first.
set_tests_properties("sources: clang-tidy finds nothing" PROPERTIES TIMEOUT 7200 COST 1000)
