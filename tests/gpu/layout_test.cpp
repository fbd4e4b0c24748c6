// The path tracer's stages as they were compiled: bindings, structs and payloads lie where C++ puts
// them. Structs are declared once for both languages (shading/structs.h, gpu/tables.h), so members
// come in the same order; where they have no gaps in GLSL and the sizes agree, all offsets do.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "gpu/spirv_layout.h"
#include "gpu/tables.h"
#include "shaders/anyhit_rahit.h"
#include "shaders/bare_trace_rgen.h"
#include "shaders/closesthit_extended.h"
#include "shaders/closesthit_rchit.h"
#include "shaders/miss_rmiss.h"
#include "shaders/reference_view_aovs.h"
#include "shaders/reference_view_record.h"
#include "shaders/reference_view_rgen.h"
#include "shaders/shadow_anyhit.h"
#include "shaders/shadow_miss_rmiss.h"
#include "shading/path/types.h"

namespace hm {

namespace {

using Sizes = std::map<std::string, std::size_t>;

// A member that C++ aligned to more than 4 bytes could leave a gap that GLSL has not.
template <class T>
constexpr std::size_t size_of() {
    static_assert(alignof(T) == 4);
    return sizeof(T);
}
#define HM_SIZE(Struct) \
    { #Struct, size_of < Struct>() }

// Structs that some stage reads from a buffer.
const Sizes kStructs = {
    HM_SIZE(MaterialData),
    HM_SIZE(TextureUse),
    HM_SIZE(Vertex),
    HM_SIZE(VertexExtra),
    HM_SIZE(GeometryData),
    HM_SIZE(InstanceData),
    HM_SIZE(LightData),
    HM_SIZE(AliasEntry),
    HM_SIZE(EmitterTriangle),
    HM_SIZE(CameraData),
    HM_SIZE(EnvironmentData),
    HM_SIZE(LightRange),
    HM_SIZE(RenderParams),
    HM_SIZE(AovParams),
    HM_SIZE(GeometryAddresses),
    HM_SIZE(TraceRange),
    HM_SIZE(AovAddresses),
    HM_SIZE(SampleHit),
    HM_SIZE(TraceCounters),
    HM_SIZE(RecordedRay),
    HM_SIZE(RecordedCounts),
    HM_SIZE(BareRange),
    HM_SIZE(ExtendedMaterialData),
};

const Sizes kTables = {
#define HM_TABLE(number, Type, name) {#name "_table", size_of<Type>()},
#include "shading/tables.inl"
};

const std::map<std::string, std::uint32_t> kBindings = {
    {"FrameValues", kFrameBinding},
    {"GeometryArrays", kGeometryAddressesBinding},
#define HM_TABLE(number, Type, name) {#name "_table", kFirstTableBinding + number},
#include "shading/tables.inl"
};

std::vector<std::span<const std::uint32_t>> modules() {
    return {shaders::reference_view_rgen(), shaders::closesthit_rchit(),
            shaders::miss_rmiss(),          shaders::anyhit_rahit(),
            shaders::reference_view_aovs(), shaders::reference_view_record(),
            shaders::bare_trace_rgen(),     shaders::closesthit_extended()};
}

TEST(Layout, StructsLieAsInCpp) {
    std::set<std::string> seen;
    for (const std::span<const std::uint32_t> module : modules())
        for (const auto& [name, layout] : test::read_structs(module)) {
            const auto known = kStructs.find(name);
            if (known == kStructs.end()) continue;
            SCOPED_TRACE(name);
            seen.insert(name);
            EXPECT_FALSE(layout.has_gaps);
            EXPECT_EQ(layout.size, known->second);
            if (layout.row_bytes != 0) {
                EXPECT_EQ(layout.row_bytes, known->second);
            }
        }
    for (const auto& [name, size] : kStructs)
        EXPECT_TRUE(seen.contains(name)) << name << " is in no buffer";
}

// New structs must be added to kStructs.
TEST(Layout, EveryStructIsCompared) {
    const char* root = std::getenv("HIMALAYA_SOURCE_DIR");
    const std::regex pattern(R"(\nstruct (\w+) \{)");
    for (const char* file : {"/src/shading/structs.h", "/src/gpu/tables.h"}) {
        std::stringstream text;
        text << std::ifstream(std::string(root != nullptr ? root : ".") + file).rdbuf();
        const std::string source = text.str();
        std::size_t found = 0;
        for (std::sregex_iterator it(source.begin(), source.end(), pattern), end; it != end; ++it) {
            const std::string name = (*it)[1];
            EXPECT_TRUE(name == "FrameData" || kStructs.contains(name)) << name;
            ++found;
        }
        EXPECT_GT(found, 0u) << file;
    }
}

TEST(Layout, TablesAreWhereTheyAreBound) {
    std::set<std::string> seen;
    for (const std::span<const std::uint32_t> module : modules())
        for (const auto& [name, block] : test::read_blocks(module)) {
            if (block.set != 0) continue;
            SCOPED_TRACE(name);
            ASSERT_TRUE(kBindings.contains(name));
            seen.insert(name);
            EXPECT_EQ(block.binding, kBindings.at(name));
            if (kTables.contains(name)) {
                EXPECT_EQ(block.row_bytes, kTables.at(name));
            }
        }
    for (const auto& [name, binding] : kBindings)
        EXPECT_TRUE(seen.contains(name)) << "no stage reads " << name;
    const test::StructLayout frame = test::read_structs(shaders::miss_rmiss()).at("FrameValues");
    EXPECT_FALSE(frame.has_gaps);
    EXPECT_EQ(frame.size, sizeof(FrameData));
}

TEST(Layout, PayloadsAreContractsBetweenStages) {
    const Sizes path = {{"PathPayload", sizeof(PathPayload)}};
    const Sizes shadow = {{"ShadowPayload", sizeof(ShadowPayload)}};
    const Sizes both = {{"PathPayload", sizeof(PathPayload)},
                        {"ShadowPayload", sizeof(ShadowPayload)}};
    EXPECT_EQ(test::read_payload_sizes(shaders::reference_view_rgen()), both);
    EXPECT_EQ(test::read_payload_sizes(shaders::closesthit_rchit()), path);
    EXPECT_EQ(test::read_payload_sizes(shaders::miss_rmiss()), path);
    EXPECT_EQ(test::read_payload_sizes(shaders::anyhit_rahit()), path);
    EXPECT_EQ(test::read_payload_sizes(shaders::shadow_anyhit()), shadow);
    EXPECT_EQ(test::read_payload_sizes(shaders::shadow_miss_rmiss()), shadow);
    EXPECT_EQ(offsetof(PathPayload, key), 0u);
    EXPECT_EQ(offsetof(ShadowPayload, key), 0u);
    EXPECT_EQ(offsetof(PathPayload, index), 4u);
    EXPECT_EQ(offsetof(ShadowPayload, index), 4u);
}

}  // namespace

}  // namespace hm
