# What the GPU renderer is built from: Vulkan's headers, volk (which opens the loader at run time, so
# nothing links it), the Vulkan Memory Allocator and the shader compiler. Sets HIMALAYA_WITH_VULKAN.
set(HIMALAYA_VULKAN AUTO CACHE STRING "The GPU renderer: ON, OFF, or AUTO where all it needs is found")
set_property(CACHE HIMALAYA_VULKAN PROPERTY STRINGS AUTO ON OFF)

set(HIMALAYA_WITH_VULKAN OFF)
if(NOT HIMALAYA_VULKAN STREQUAL OFF)
  find_path(VULKAN_HEADERS vulkan/vulkan.h)
  find_path(VOLK_HEADER volk.h)
  find_path(VMA_HEADER vk_mem_alloc.h HINTS ${PROJECT_SOURCE_DIR}/build/vma/include)
  find_path(SPIRV_HEADERS spirv/unified1/spirv.hpp11)
  find_program(GLSLANG glslangValidator)
  find_program(SPIRV_VAL spirv-val)
  set(missing "")
  foreach(need "VULKAN_HEADERS:libvulkan-dev" "VOLK_HEADER:libvulkan-volk-dev"
               "VMA_HEADER:scripts/fetch-vma.sh" "SPIRV_HEADERS:spirv-headers" "GLSLANG:glslang-tools"
               "SPIRV_VAL:spirv-tools")
    string(REPLACE ":" ";" need ${need})
    list(GET need 0 variable)
    list(GET need 1 source)
    if(NOT ${variable})
      string(APPEND missing " ${variable} (${source})")
    endif()
  endforeach()
  if(NOT missing)
    set(HIMALAYA_WITH_VULKAN ON)
    message(STATUS "GPU renderer: built")
  elseif(HIMALAYA_VULKAN STREQUAL ON)
    message(FATAL_ERROR "HIMALAYA_VULKAN is ON, but these are not found:${missing}")
  else()
    message(STATUS "GPU renderer: left out, these are not found:${missing}")
  endif()
endif()

if(HIMALAYA_WITH_VULKAN)
  add_library(vulkan_headers INTERFACE)
  target_include_directories(vulkan_headers SYSTEM INTERFACE
    ${VULKAN_HEADERS} ${VOLK_HEADER} ${VMA_HEADER})
  include(Shaders)  # himalaya_shader
endif()
