// The Vulkan Memory Allocator, compiled here. It gets its functions from volk's two entry points.
#define VMA_IMPLEMENTATION
#include "rhi/allocator.h"
