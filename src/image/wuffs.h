// Wuffs' PNG decoder: C code generated from a memory-safe language. Its single file is both header
// and implementation; wuffs.cpp compiles the implementation.
#pragma once

#define WUFFS_CONFIG__MODULES
#define WUFFS_CONFIG__MODULE__ADLER32
#define WUFFS_CONFIG__MODULE__BASE
#define WUFFS_CONFIG__MODULE__CRC32
#define WUFFS_CONFIG__MODULE__DEFLATE
#define WUFFS_CONFIG__MODULE__PNG
#define WUFFS_CONFIG__MODULE__ZLIB
#include <wuffs-unsupported-snapshot.c>
