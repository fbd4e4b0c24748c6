include(GoogleTest)

# himalaya_test(NAME SOURCES files... LIBS targets... [LABEL unit|stat|gpu|image|corpus] [ONE_PROCESS])
# One GoogleTest binary; each of its tests becomes a ctest entry under the label (default: unit), or
# with ONE_PROCESS all of them become one: for what they share and is slow to make.
# `gpu` tests find lavapipe where scripts/fetch-lavapipe.sh puts it, beside what the system offers.
# What Vulkan's validation layer says and no test has asked for fails the test.
function(himalaya_test name)
  cmake_parse_arguments(T "ONE_PROCESS" "LABEL" "SOURCES;LIBS" ${ARGN})
  if(NOT T_LABEL)
    set(T_LABEL unit)
  endif()
  add_executable(${name} ${T_SOURCES})
  himalaya_compile(${name})
  target_link_libraries(${name} PRIVATE ${T_LIBS} GTest::gtest_main)
  set(source_dir "HIMALAYA_SOURCE_DIR=${PROJECT_SOURCE_DIR}")
  set(lavapipe ${PROJECT_SOURCE_DIR}/build/lavapipe)
  set(drivers "VK_ADD_DRIVER_FILES=${lavapipe}/icd.json")
  set(libraries "LD_LIBRARY_PATH=path_list_prepend:${lavapipe}/lib")
  set(fails FAIL_REGULAR_EXPRESSION "Vulkan validation: ")
  if(T_ONE_PROCESS)
    add_test(NAME ${name} COMMAND ${name})
    set_tests_properties(${name} PROPERTIES LABELS ${T_LABEL} ${fails}
      ENVIRONMENT "${source_dir};${drivers}" ENVIRONMENT_MODIFICATION "${libraries}")
    return()
  endif()
  set(environment ENVIRONMENT "${source_dir}")
  if(T_LABEL STREQUAL gpu)
    set(environment ENVIRONMENT "${drivers}" ENVIRONMENT_MODIFICATION "${libraries}")
  endif()
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS ${T_LABEL} ${fails} ${environment})
endfunction()
