// Wuffs' PNG decoder: C code generated from a language in which nothing can be read or written out
// of bounds. Its one file is header and code; wuffs.cpp compiles the code.
#pragma once

#define WUFFS_CONFIG__MODULES
#define WUFFS_CONFIG__MODULE__ADLER32
#define WUFFS_CONFIG__MODULE__BASE
#define WUFFS_CONFIG__MODULE__CRC32
#define WUFFS_CONFIG__MODULE__DEFLATE
#define WUFFS_CONFIG__MODULE__PNG
#define WUFFS_CONFIG__MODULE__ZLIB
#include <wuffs-unsupported-snapshot.c>
