include(GoogleTest)

# himalaya_test(NAME SOURCES files... LIBS targets... [LABEL unit|stat|gpu|image|corpus])
# One GoogleTest binary; each of its tests becomes a ctest entry under the label (default: unit).
# `gpu` tests find lavapipe where scripts/fetch-lavapipe.sh puts it, beside what the system offers.
function(himalaya_test name)
  cmake_parse_arguments(T "" "LABEL" "SOURCES;LIBS" ${ARGN})
  if(NOT T_LABEL)
    set(T_LABEL unit)
  endif()
  add_executable(${name} ${T_SOURCES})
  himalaya_compile(${name})
  target_link_libraries(${name} PRIVATE ${T_LIBS} GTest::gtest_main)
  set(environment ENVIRONMENT "HIMALAYA_SOURCE_DIR=${PROJECT_SOURCE_DIR}")
  if(T_LABEL STREQUAL gpu)
    set(lavapipe ${PROJECT_SOURCE_DIR}/build/lavapipe)
    set(environment ENVIRONMENT "VK_ADD_DRIVER_FILES=${lavapipe}/icd.json"
      ENVIRONMENT_MODIFICATION "LD_LIBRARY_PATH=path_list_prepend:${lavapipe}/lib")
  endif()
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS ${T_LABEL} ${environment})
endfunction()
