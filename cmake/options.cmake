option(C1MESH_TESTS "Build the tests" ON)
option(C1MESH_WARNINGS_AS_ERRORS "Treat warnings as errors" OFF)
set(C1MESH_SANITIZE "" CACHE STRING "Sanitizers to compile with, for example address,undefined")
option(C1MESH_TRAP_FLOATS "The program ends with SIGFPE where a NaN or a division by zero arises" OFF)

option(C1MESH_FUZZ "Build the fuzz targets (clang's libFuzzer) instead of the tests" OFF)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
endif()

# Fused multiply-add would make signs and bytes depend on the machine.
add_compile_options(-ffp-contract=off)
if(C1MESH_SANITIZE)
  # A report ends the program, so that it fails the test.
  add_compile_options(-fsanitize=${C1MESH_SANITIZE} -fno-sanitize-recover=all
    -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${C1MESH_SANITIZE})
  if(C1MESH_SANITIZE MATCHES "undefined")
    # A third of the time to build, for what faults by itself: null and misaligned pointers, or what
    # the address sanitizer sees as well.
    add_compile_options(-fno-sanitize=null,alignment,object-size,vptr)
  endif()
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
endif()
if(C1MESH_FUZZ)
  # A report must end the process, or the fuzzer goes on without noticing it.
  add_compile_options(-fsanitize=fuzzer-no-link -fno-sanitize-recover=all)
endif()
