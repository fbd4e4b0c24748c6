// What the precompiled header of cmake/Compile.cmake is made with.
