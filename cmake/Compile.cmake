# Flags every target of the project shares. No fast-math and no contraction: the reference must give
# the same bits for the same build, and agree with the GLSL build of the same files.
set(CMAKE_CXX_FLAGS_RELEASE "-O3")
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O3 -g")

# Off for compilers that are not ours (scripts/kit.sh), and with sanitizers, under which GCC warns of
# what is not so.
option(HIMALAYA_WARNINGS_AS_ERRORS "Fail where the compiler warns" ON)
# Off, a build shows whether every file includes what it uses.
option(HIMALAYA_PRECOMPILED_HEADER "Parse the standard library, fmt and glm once for all files" ON)

# himalaya_compile(TARGET [NO_PRECOMPILED_HEADER] [PRECOMPILE headers...])
# All targets with the common flags share one precompiled header; PRECOMPILE gives a target one of its
# own with more in it.
set(precompiled
  <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <optional> <span>
  <string> <string_view> <unordered_map> <utility> <vector>
  <fmt/format.h> <glm/glm.hpp> <glm/mat4x3.hpp> <tl/expected.hpp>)

function(himalaya_compile target)
  cmake_parse_arguments(C "NO_PRECOMPILED_HEADER" "" "PRECOMPILE" ${ARGN})
  target_include_directories(${target} PUBLIC ${PROJECT_SOURCE_DIR}/src)
  target_compile_definitions(${target} PRIVATE GLM_FORCE_XYZW_ONLY GLM_FORCE_SIZE_T_LENGTH)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wdouble-promotion
    $<$<BOOL:${HIMALAYA_WARNINGS_AS_ERRORS}>:-Werror>
    # GCC's -Wconversion leaves this out in C++.
    $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>
    -fno-math-errno -fno-trapping-math -ffp-contract=off
    # Of programs too, rather than -fPIE: one precompiled header serves all.
    -fPIC)
  if(HIMALAYA_PRECOMPILED_HEADER AND NOT C_NO_PRECOMPILED_HEADER)
    if(C_PRECOMPILE)
      target_precompile_headers(${target} PRIVATE ${precompiled} ${C_PRECOMPILE})
    else()
      target_precompile_headers(${target} REUSE_FROM himalaya_precompiled)
    endif()
    target_link_libraries(${target} PRIVATE fmt::fmt tl::expected glm::glm)
    # Without the first ccache can't tell what a file includes. The others are GCC 12's false alarms
    # about std::string, which it takes for ours when it comes out of a precompiled header.
    target_compile_options(${target} PRIVATE
      "$<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess;-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread;-Wno-restrict>")
  endif()
endfunction()

if(HIMALAYA_PRECOMPILED_HEADER)
  add_library(himalaya_precompiled OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
  himalaya_compile(himalaya_precompiled NO_PRECOMPILED_HEADER)
  target_link_libraries(himalaya_precompiled PRIVATE fmt::fmt tl::expected glm::glm)
  target_precompile_headers(himalaya_precompiled PRIVATE ${precompiled})
endif()
