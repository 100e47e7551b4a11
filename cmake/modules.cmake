# c1mesh_module(NAME SOURCES … NEEDS …): one stage of the road as an object library. What a module
# NEEDS is all it may include; the finished library gathers the objects of every module.
function(c1mesh_module name)
  cmake_parse_arguments(MODULE "" "" "SOURCES;NEEDS;LIBRARIES" ${ARGN})
  add_library(c1mesh_${name} OBJECT ${MODULE_SOURCES})
  target_include_directories(c1mesh_${name} PUBLIC
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>"
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>")
  target_compile_options(c1mesh_${name} PRIVATE -Wall -Wextra -Wpedantic -Wshadow
    $<$<BOOL:${C1MESH_WARNINGS_AS_ERRORS}>:-Werror>)
  foreach(need IN LISTS MODULE_NEEDS)
    target_link_libraries(c1mesh_${name} PUBLIC c1mesh_${need})
  endforeach()
  target_link_libraries(c1mesh_${name} PUBLIC ${MODULE_LIBRARIES})
  set_property(GLOBAL APPEND PROPERTY C1MESH_MODULES c1mesh_${name})
endfunction()
