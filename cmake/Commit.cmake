# Run at each build (cmake -P) with SOURCE and HEADER: writes the commit that is built into HEADER,
# touching it only where that changes.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT commit)
  set(commit unknown)
endif()
file(CONFIGURE OUTPUT ${HEADER} CONTENT "#define HM_COMMIT \"@commit@\"\n" @ONLY)
