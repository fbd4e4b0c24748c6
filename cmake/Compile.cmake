# Flags every target of the project shares. No fast-math and no contraction: the reference must give
# the same bits for the same build, and agree with the GLSL build of the same files.
set(CMAKE_CXX_FLAGS_RELEASE "-O3")
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O3 -g")

# Off for compilers that are not ours (scripts/kit.sh), and with sanitizers, under which GCC warns of
# what is not so.
option(HIMALAYA_WARNINGS_AS_ERRORS "Fail where the compiler warns" ON)

function(himalaya_compile target)
  target_include_directories(${target} PUBLIC ${PROJECT_SOURCE_DIR}/src)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wdouble-promotion
    $<$<BOOL:${HIMALAYA_WARNINGS_AS_ERRORS}>:-Werror>
    # GCC's -Wconversion leaves this out in C++.
    $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>
    -fno-math-errno -fno-trapping-math -ffp-contract=off)
endfunction()
