# Installs a build to a scratch prefix and builds the project beside this file against it, unoptimised.
# Usage: cmake -DBUILD=<build folder> -DSCRATCH=<folder to empty> \
#   -DCOMPILER=<c++> -DLAUNCHER=<ccache or nothing> -P build.cmake
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# Installed for one place, put into another one.
file(REMOVE_RECURSE ${SCRATCH})
set(ENV{DESTDIR} ${SCRATCH}/stage)
run(${CMAKE_COMMAND} --install ${BUILD} --prefix /opt/plumbline)
unset(ENV{DESTDIR})
file(RENAME ${SCRATCH}/stage/opt/plumbline ${SCRATCH}/prefix)

# All of it is there.
set(pages plumbline plumbline-arrange plumbline-check plumbline-engines plumbline-eval plumbline-info plumbline-lar
          plumbline-random plumbline-rooms plumbline-verify)
list(TRANSFORM pages REPLACE ".+" "share/man/man1/\\0.1")
set(schemas arrange check diagnosis rooms summary)
list(TRANSFORM schemas REPLACE ".+" "share/plumbline/\\0.schema.json")
foreach(file bin/plumbline bin/plumbline-verify ${pages} ${schemas} share/doc/plumbline/LICENSE
             share/doc/plumbline/notices.txt share/bash-completion/completions/plumbline
             share/zsh/site-functions/_plumbline share/fish/vendor_completions.d/plumbline.fish)
  file(SIZE ${SCRATCH}/prefix/${file} size)
  if(size EQUAL 0)
    message(FATAL_ERROR "${file} is empty")
  endif()
endforeach()

run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${SCRATCH}/build -G Ninja
    -DCMAKE_PREFIX_PATH=${SCRATCH}/prefix -DCMAKE_CXX_COMPILER=${COMPILER}
    -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O0)
run(${CMAKE_COMMAND} --build ${SCRATCH}/build)

# The same without CMake.
file(GLOB_RECURSE pc ${SCRATCH}/prefix/*/plumbline.pc)
cmake_path(GET pc PARENT_PATH pc_dir)
set(ENV{PKG_CONFIG_PATH} ${pc_dir})
execute_process(COMMAND pkg-config --cflags --libs plumbline OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags}")
run(${COMPILER} -std=c++20 ${CMAKE_CURRENT_LIST_DIR}/main.cpp ${flags} -o ${SCRATCH}/build/pkg_config_consumer)
