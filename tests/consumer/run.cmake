# Installs the library from BUILD to a fresh prefix, then configures and builds SOURCE with it and runs
# what it makes: `consumer`, or with DRAWING the programs of examples/library, on that drawing.
get_filename_component(name ${SOURCE} NAME)
set(work ${BUILD}/consumer-${name})
file(REMOVE_RECURSE ${work})

function(run_step)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "failed (${status}): ${ARGN}\n${said}")
  endif()
endfunction()

set(flags)
if(FLAGS)
  set(flags -DCMAKE_CXX_FLAGS=-fsanitize=${FLAGS})
endif()
run_step(${CMAKE_COMMAND} --install ${BUILD} --prefix ${work}/prefix --component library)
# Moved after installing: the package must not remember where it was.
file(RENAME ${work}/prefix ${work}/moved)
run_step(${CMAKE_COMMAND} -S ${SOURCE} -B ${work}/build -G ${GENERATOR}
  -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_PREFIX_PATH=${work}/moved ${flags})
run_step(${CMAKE_COMMAND} --build ${work}/build)
if(DRAWING)
  run_step(${work}/build/first ${DRAWING} ${work}/result.c1.json)
  run_step(${work}/build/field ${work}/result.c1.json)
  run_step(${work}/build/poisson ${work}/result.c1.json)
else()
  run_step(${work}/build/consumer)
endif()
