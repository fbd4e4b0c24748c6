#include "gpu/spirv_layout.h"

#include <algorithm>
#include <spirv_cross/spirv_cross.hpp>
#include <spirv_cross/spirv_parser.hpp>

namespace hm::test {

namespace {

using spirv_cross::Compiler;
using spirv_cross::SPIRType;
using spirv_cross::SPIRVariable;

spirv_cross::ParsedIR parse(std::span<const std::uint32_t> spirv) {
    spirv_cross::Parser parser(spirv.data(), spirv.size());
    parser.parse();
    return std::move(parser.get_parsed_ir());
}

bool is_struct(const SPIRType& type) {
    return type.basetype == SPIRType::Struct && !type.pointer && type.array.empty();
}

StructLayout layout_of(const Compiler& compiler, const SPIRType& type) {
    StructLayout layout;
    for (std::uint32_t i = 0; i < type.member_types.size(); ++i) {
        const std::size_t offset = compiler.type_struct_member_offset(type, i);
        layout.has_gaps = layout.has_gaps || offset != layout.size;
        layout.size = offset + compiler.get_declared_struct_member_size(type, i);
    }
    return layout;
}

// Without explicit layout, which payloads do not have.
std::size_t packed_bytes(const Compiler& compiler, const SPIRType& type) {
    std::size_t bytes = 0;
    for (const spirv_cross::TypeID member : type.member_types)
        bytes += packed_bytes(compiler, compiler.get_type(member));
    if (type.basetype == SPIRType::Boolean) bytes = 4;
    if (type.member_types.empty() && bytes == 0) bytes = type.width / 8;
    bytes *= std::size_t(type.vecsize) * type.columns;
    for (const std::uint32_t count : type.array)
        bytes *= count;
    return bytes;
}

}  // namespace

std::map<std::string, StructLayout> read_structs(std::span<const std::uint32_t> spirv) {
    spirv_cross::ParsedIR ir = parse(spirv);
    std::vector<const SPIRType*> structs;
    std::map<std::uint32_t, std::uint32_t> arrays;  // of a type
    ir.for_each_typed_id<SPIRType>([&](std::uint32_t id, const SPIRType& type) {
        if (is_struct(type)) structs.push_back(&type);
        if (!type.array.empty() && !type.pointer) arrays[type.parent_type] = id;
    });
    const Compiler compiler(ir);
    std::map<std::string, StructLayout> layouts;
    for (const SPIRType* type : structs) {
        if (!compiler.has_member_decoration(type->self, 0, spv::DecorationOffset)) continue;
        StructLayout& layout = layouts[compiler.get_name(type->self)];
        layout = layout_of(compiler, *type);
        const auto array = arrays.find(type->self);
        if (array != arrays.end())
            layout.row_bytes = compiler.get_decoration(array->second, spv::DecorationArrayStride);
    }
    return layouts;
}

std::map<std::string, BlockLayout> read_blocks(std::span<const std::uint32_t> spirv) {
    const Compiler compiler(parse(spirv));
    const spirv_cross::ShaderResources resources = compiler.get_shader_resources();
    std::map<std::string, BlockLayout> blocks;
    for (const auto* list : {&resources.uniform_buffers, &resources.storage_buffers})
        for (const spirv_cross::Resource& resource : *list) {
            const SPIRType& type = compiler.get_type(resource.base_type_id);
            const SPIRType& last = compiler.get_type(type.member_types.back());
            BlockLayout& block = blocks[compiler.get_name(resource.base_type_id)];
            block.set = compiler.get_decoration(resource.id, spv::DecorationDescriptorSet);
            block.binding = compiler.get_decoration(resource.id, spv::DecorationBinding);
            if (!last.array.empty())
                block.row_bytes = compiler.type_struct_member_array_stride(
                    type, std::uint32_t(type.member_types.size() - 1));
        }
    return blocks;
}

std::map<std::string, std::size_t> read_payload_sizes(std::span<const std::uint32_t> spirv) {
    spirv_cross::ParsedIR ir = parse(spirv);
    std::vector<std::uint32_t> pointers;
    ir.for_each_typed_id<SPIRVariable>([&](std::uint32_t, const SPIRVariable& variable) {
        if (variable.storage == spv::StorageClassRayPayloadKHR ||
            variable.storage == spv::StorageClassIncomingRayPayloadKHR)
            pointers.push_back(variable.basetype);
    });
    const Compiler compiler(ir);
    std::map<std::string, std::size_t> sizes;
    for (const std::uint32_t pointer : pointers) {
        const SPIRType& type = compiler.get_type(compiler.get_type(pointer).parent_type);
        sizes[compiler.get_name(type.self)] = packed_bytes(compiler, type);
    }
    return sizes;
}

}  // namespace hm::test
