// Animations (glTF 2.0, 3.11, 5.5 to 5.8).
#include "corpus/bases.h"
#include "corpus/reasons.h"
#include "corpus/rules.h"

namespace hm::corpus {
namespace {

void add_sampler_rules(std::vector<Case>& cases) {
    Object sampler(cases, "animation-sampler", "5.8", "/animations/0/samplers/0", Base::moving);
    sampler.always(pending("animations"));
    sampler.required("input");
    sampler.index("input");
    sampler.required("output");
    sampler.index("output");
    sampler.text("interpolation");
    sampler.unlisted("interpolation", "unknown", R"("SMOOTH")", "is LINEAR, STEP or CUBICSPLINE",
                     "");
    sampler.rule("input-vector", "input: scalars", {set(sampler.place("input"), "6")}, {});
    sampler.rule("input-integers", "input: floats", {set("/accessors/5/componentType", "5125")},
                 {});
    sampler.rule("input-order", "input: strictly increasing", {put(260, floats({1, 0}))}, {});
    sampler.rule("input-equal", "input: strictly increasing",
                 {put(260, floats({0, 0})), set("/accessors/5/max", "[0]")}, {});
    sampler.rule("input-below-zero", "input: not negative",
                 {put(260, floats({-1, 1})), set("/accessors/5/min", "[-1]")}, {});
    sampler.rule("input-no-limits", "input: has min and max", {drop("/accessors/5/min")}, {});
    sampler.rule("output-count", "output: one element for each key",
                 {set("/accessors/6/count", "1")}, {});
    sampler.rule("output-cubic", "output: three elements for each key of a spline",
                 {set("/accessors/9/count", "5")}, {});
    sampler.rule("output-translation", "output: VEC3 for translations",
                 {set(sampler.place("output"), "7")}, {});
    sampler.rule("output-rotation", "output: VEC4 for rotations",
                 {set("/animations/0/samplers/1/output", "6")}, {});
    sampler.rule("output-weights", "output: scalars for weights",
                 {set("/animations/0/samplers/2/output", "6")}, {});
    sampler.rule("output-quaternion", "output: rotations have unit length",
                 {put(292, floats({0, 0, 0, 2}))}, {});
    sampler.rule("output-nan", "output: not NaN", {put(268, words({0x7fc00000}))}, {});
    sampler.common(false);
}

}  // namespace

void add_animation_rules(std::vector<Case>& cases) {
    Object animation(cases, "animation", "5.5", "/animations/0", Base::moving);
    animation.always(pending("animations"));
    for (const char* key : {"channels", "samplers"}) {
        animation.required(key);
        animation.objects(key);
        animation.empty(key);
    }
    animation.common();
    add_sampler_rules(cases);

    Object channel(cases, "channel", "5.6", "/animations/0/channels/0", Base::moving);
    channel.always(pending("animations"));
    channel.required("sampler");
    channel.index("sampler");
    channel.required("target");
    channel.object("target");
    channel.common(false);
    channel.rule("target-twice", "target: each node's property once",
                 {set("/animations/0/channels/3/target/node", "1")}, {});

    Object target(cases, "channel-target", "5.7", "/animations/0/channels/0/target", Base::moving);
    target.always(pending("animations"));
    target.required("path");
    target.text("path");
    target.unlisted("path", "unknown", R"("color")", "is translation, rotation, scale or weights",
                    "");
    target.index("node");
    target.rule("matrix", "node: has no matrix",
                {set("/nodes/1/matrix", "[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]")}, {});
    target.rule("weights-no-mesh", "path: weights only for nodes with morph targets",
                {set("/animations/0/channels/2/target/node", "2")}, {});
    target.common(false);
}

}  // namespace hm::corpus
