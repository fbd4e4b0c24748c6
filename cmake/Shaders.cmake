# GLSL compiled, kept from contracting a * b + c, validated and embedded at build time.
#
# himalaya_shader(TARGET FILE [NAME name] [DEFINES A B=1...] [INCLUDES folders...])
# The target's sources may then include "shaders/NAME.h", which declares
#   namespace hm::shaders { std::span<const std::uint32_t> NAME(); }   // the SPIR-V words
# NAME is the file's own with _ for the dot ("miss.rmiss" -> miss_rmiss) unless given. Variants are
# separate calls for one file with other names and DEFINES. FILE includes from src/, from its own
# folder and from INCLUDES.
add_executable(embed_spirv ${PROJECT_SOURCE_DIR}/tools/embed_spirv.cpp)
himalaya_compile(embed_spirv NO_PRECOMPILED_HEADER)
target_include_directories(embed_spirv SYSTEM PRIVATE ${SPIRV_HEADERS})

function(himalaya_shader target file)
  cmake_parse_arguments(S "" "NAME" "DEFINES;INCLUDES" ${ARGN})
  get_filename_component(file ${file} ABSOLUTE)
  set(NAME ${S_NAME})
  if(NOT NAME)
    get_filename_component(NAME ${file} NAME)
    string(REPLACE "." "_" NAME ${NAME})
  endif()
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}_shaders)
  set(spirv ${folder}/${NAME}.spv)
  set(words ${folder}/${NAME}.words.h)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/shader.h.in ${folder}/shaders/${NAME}.h @ONLY)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/shader.cpp.in ${folder}/${NAME}.cpp @ONLY)

  set(compile ${GLSLANG} --quiet -V --target-env vulkan1.3 -I${PROJECT_SOURCE_DIR}/src)
  foreach(include ${S_INCLUDES})
    list(APPEND compile -I${include})
  endforeach()
  foreach(define ${S_DEFINES})
    list(APPEND compile -D${define})
  endforeach()
  add_custom_command(OUTPUT ${spirv} ${words}
    COMMAND ${compile} --depfile ${spirv}.d -o ${spirv} ${file}
    COMMAND embed_spirv ${spirv} ${spirv} ${words}
    COMMAND ${SPIRV_VAL} --target-env vulkan1.3 --scalar-block-layout ${spirv}
    DEPENDS ${file} embed_spirv DEPFILE ${spirv}.d VERBATIM COMMENT "Shader ${NAME}")
  set_source_files_properties(${folder}/${NAME}.cpp PROPERTIES OBJECT_DEPENDS ${words})
  target_sources(${target} PRIVATE ${folder}/${NAME}.cpp)
  target_include_directories(${target} PRIVATE ${folder})
endfunction()
