# Holds the #include lines of include/ and src/ against the table of layers.
# Usage: cmake -DROOT=<folder that holds include/ and src/> -P layering.cmake
cmake_minimum_required(VERSION 3.25)

# layer(<folder of src, or header> <what else it may include>...)
function(layer name)
  set(may_${name} ${name} ${ARGN} PARENT_SCOPE)
endfunction()
layer(text)                                               # a header of src/error
layer(error       text)
layer(number      error)
layer(iterator)
layer(source      iterator)
layer(geometry    error number iterator source)
layer(lists       error)
layer(affine      error number geometry)                  # headers of src/structure
layer(model       error number geometry affine lists)
layer(structure   error number geometry affine model lists)
layer(read        error number geometry structure)
layer(complex     error number geometry lists model boundary polygons)
layer(boundary    error number geometry complex)         # a second header of src/complex
layer(polygons    error number geometry complex)         # a third one
layer(result      error number geometry lists structure read complex polygons)
layer(arrange     error number geometry structure read complex cgal)
layer(cgal        error number geometry complex arrange) # plumbline/cgal.hpp and CGAL itself
layer(lar         error number geometry complex published) # never arrange, never CGAL
layer(published   error number geometry complex lar) # a second header of src/lar
layer(triangulate error number geometry complex cgal)
layer(round       error number geometry lists complex arrange)
layer(crosscheck  error number geometry structure read complex boundary arrange lar published)
layer(ladder      error number geometry complex arrange)
layer(diagnose    error number geometry complex arrange)
layer(check       ${may_crosscheck} ladder result polygons)
layer(write       text ${may_check} diagnose triangulate round)
layer(certificate error number geometry complex)
layer(report      ${may_write})
layer(plumbline   ${may_report} certificate polygons result)                         # the umbrella header
layer(cli         ${may_plumbline})                      # of these, public headers only
layer(verify)                                            # nothing of the project, and nobody includes it

set(found 0)
file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/include/*.hpp ${ROOT}/src/*.hpp ${ROOT}/src/*.cpp)
foreach(file IN LISTS files)
  string(REGEX REPLACE "^(include/plumbline|src)/([a-z]+).*" "\\2" layer ${file})
  file(STRINGS ${ROOT}/${file} lines REGEX "^[ \t]*#[ \t]*include")
  foreach(line IN LISTS lines)
    set(reason "")
    if(line MATCHES "<CGAL/")
      set(target cgal)
    elseif(line MATCHES "[<\"]plumbline/([a-z]+)[a-z_]*\\.hpp")
      set(target ${CMAKE_MATCH_1})
    elseif(line MATCHES "\"([a-z]+)/")
      set(target ${CMAKE_MATCH_1})
      if(file MATCHES "^include/" OR (layer STREQUAL cli AND NOT target STREQUAL cli))
        set(reason "private header")
      endif()
    elseif(line MATCHES "\"\\.\\./")
      set(reason "path out of the folder")
    else()
      continue() # the standard library, another library, or the file's own folder
    endif()
    if(NOT reason AND NOT target IN_LIST may_${layer})
      set(reason "not for ${layer}")
    endif()
    if(reason)
      math(EXPR found "${found} + 1")
      message("${file}: ${line} (${reason})")
    endif()
  endforeach()
endforeach()
if(found OR NOT files)
  message(FATAL_ERROR "${found} forbidden includes")
endif()
