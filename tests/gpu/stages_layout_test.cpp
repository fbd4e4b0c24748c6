// The ray-tracing stages as they were compiled: payloads are as large as C++ thinks, and the
// structs of their buffers lie as in layout.comp, which layout_test compares with C++.
#include <gtest/gtest.h>

#include "gpu/spirv_layout.h"
#include "gpu/tables.h"
#include "shaders/anyhit_rahit.h"
#include "shaders/closesthit_rchit.h"
#include "shaders/layout_comp.h"
#include "shaders/miss_rmiss.h"
#include "shaders/reference_view_rgen.h"
#include "shaders/shadow_anyhit.h"
#include "shaders/shadow_miss_rmiss.h"
#include "shading/path/types.h"

namespace hm {

namespace {

using Sizes = std::map<std::string, std::size_t>;

TEST(StagesLayout, PayloadsAreContracts) {
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
}

TEST(StagesLayout, StructsLieAsInLayoutComp) {
    const auto expected = test::read_struct_layouts(shaders::layout_comp());
    std::size_t compared = 0;
    for (const auto& spirv : {shaders::reference_view_rgen(), shaders::closesthit_rchit(),
                              shaders::miss_rmiss(), shaders::anyhit_rahit()}) {
        for (const auto& [name, layout] : test::read_struct_layouts(spirv)) {
            const auto known = expected.find(name);
            if (known == expected.end()) continue;
            SCOPED_TRACE(name);
            EXPECT_EQ(layout.offsets, known->second.offsets);
            EXPECT_EQ(layout.matrix_strides, known->second.matrix_strides);
            if (layout.array_stride != 0) {
                EXPECT_EQ(layout.array_stride, known->second.array_stride);
            }
            ++compared;
        }
    }
    EXPECT_GE(compared, 20u);
}

TEST(StagesLayout, TablesOfTheGpu) {
    const auto hit = test::read_struct_layouts(shaders::closesthit_rchit());
    const auto rays = test::read_struct_layouts(shaders::reference_view_rgen());
    const Sizes addresses = {{"vertices", offsetof(GeometryAddresses, vertices)},
                             {"extras", offsetof(GeometryAddresses, extras)},
                             {"triangles", offsetof(GeometryAddresses, triangles)}};
    EXPECT_EQ(hit.at("GeometryAddresses").offsets, addresses);
    EXPECT_EQ(hit.at("GeometryAddresses").array_stride, sizeof(GeometryAddresses));
    const Sizes frame = {{"frame_params", offsetof(FrameData, frame_params)},
                         {"camera", offsetof(FrameData, camera)},
                         {"environment", offsetof(FrameData, environment)}};
    EXPECT_EQ(hit.at("Frame_").offsets, frame);
    const Sizes range = {{"crop_x", offsetof(TraceRange, crop_x)},
                         {"crop_y", offsetof(TraceRange, crop_y)},
                         {"first_row", offsetof(TraceRange, first_row)},
                         {"sample_begin", offsetof(TraceRange, sample_begin)},
                         {"sample_end", offsetof(TraceRange, sample_end)},
                         {"hits", offsetof(TraceRange, hits)},
                         {"noted_begin", offsetof(TraceRange, noted_begin)},
                         {"noted_samples", offsetof(TraceRange, noted_samples)}};
    EXPECT_EQ(rays.at("TraceRange").offsets, range);
    EXPECT_EQ(rays.at("TraceCounters").array_stride, sizeof(TraceCounters));
}

}  // namespace

}  // namespace hm
