// Animations (glTF 2.0, 3.11, 5.5 to 5.8).
#include <fmt/format.h>

#include "corpus/bases.h"
#include "corpus/reasons.h"
#include "corpus/rules.h"

namespace hm::corpus {
namespace {

void add_sampler_rules(std::vector<Case>& cases) {
    Object sampler(cases, "animation-sampler", "5.8", "/animations/0/samplers/0", Base::moving);
    sampler.required("input");
    sampler.index("input");
    sampler.required("output");
    sampler.index("output");
    sampler.text("interpolation");
    sampler.unlisted("interpolation", "unknown", R"("SMOOTH")", "is LINEAR, STEP or CUBICSPLINE",
                     "is not an interpolation");
    const auto input = [&](const char* slug, const char* rule, Edits edits, const char* message) {
        sampler.rule(slug, rule, std::move(edits), refused(sampler.pointer("input"), message));
    };
    input("input-vector", "input: scalars", {set(sampler.pointer("input"), "6")},
          "key times must be float scalars");
    input("input-integers", "input: floats", {set("/accessors/5/componentType", "5125")},
          "key times must be float scalars");
    sampler.rule("input-order", "input: strictly increasing", {put(260, floats({1, 0}))},
                 warned(sampler.pointer("input"), "key times are not increasing", kRepaired));
    sampler.rule("input-equal", "input: strictly increasing",
                 {put(260, floats({0, 0})), set("/accessors/5/max", "[0]")},
                 warned(sampler.pointer("input"), "several keys at the same time", kRepaired));
    sampler.rule("input-below-zero", "input: not negative",
                 {put(260, floats({-1, 1})), set("/accessors/5/min", "[-1]")},
                 warned("/accessors/5", "negative key times", kRepaired));
    sampler.rule("input-no-limits", "input: has min and max", {drop("/accessors/5/min")},
                 warned("/accessors/5", "min and max are missing", kRepaired));
    const auto output = [&](const char* slug, const char* rule, Edits edits, int channel,
                            const char* message) {
        sampler.rule(slug, rule, std::move(edits),
                     refused(fmt::format("/animations/0/channels/{}/sampler", channel), message));
    };
    output("output-count", "output: one element for each key", {set("/accessors/6/count", "1")}, 0,
           "has 1 elements, expected 2");
    output("output-cubic", "output: three elements for each key of a spline",
           {set("/accessors/9/count", "5")}, 3, "has 5 elements, expected 6");
    output("output-translation", "output: VEC3 for translations",
           {set(sampler.pointer("output"), "7")}, 0, "a type that is invalid for translation");
    output("output-rotation", "output: VEC4 for rotations",
           {set("/animations/0/samplers/1/output", "6")}, 1, "a type that is invalid for rotation");
    output("output-weights", "output: scalars for weights",
           {set("/animations/0/samplers/2/output", "6")}, 2, "a type that is invalid for weights");
    sampler.rule("output-quaternion", "output: rotations have unit length",
                 {put(292, floats({0, 0, 0, 2}))},
                 ignored("quaternions are scaled to unit length"));
    sampler.rule("output-nan", "output: not NaN", {put(268, words({0x7fc00000}))},
                 warned(sampler.pointer(""), "keys with a NaN", kSkipped));
    sampler.common(false);
}

}  // namespace

void add_animation_rules(std::vector<Case>& cases) {
    Object animation(cases, "animation", "5.5", "/animations/0", Base::moving);
    const Expected none = warned("/animations/0", "has no channels", kSkipped);
    animation.required("channels").expect(none);
    animation.objects("channels");
    animation.empty("channels").expect(none);
    const Expected missing = refused("/animations/0/channels/0/sampler", "past the end of the 0");
    animation.required("samplers").expect(missing);
    animation.objects("samplers");
    animation.empty("samplers").expect(missing);
    animation.common();
    add_sampler_rules(cases);

    Object channel(cases, "channel", "5.6", "/animations/0/channels/0", Base::moving);
    channel.required("sampler");
    channel.index("sampler");
    channel.required("target");
    channel.object("target");
    channel.common(false);
    channel.rule("target-twice", "target: each node's property once",
                 {set("/animations/0/channels/3/target/node", "1")},
                 warned("/animations/0/channels/3/target", "has the same target", kSkipped));

    Object target(cases, "channel-target", "5.7", "/animations/0/channels/0/target", Base::moving);
    target.required("path");
    target.text("path");
    target
        .unlisted("path", "unknown", R"("color")", "is translation, rotation, scale or weights", "")
        .expect(warned(target.pointer(""), "its target is unknown", kSkipped));
    target.index("node");
    target.rule("matrix", "node: has no matrix",
                {set("/nodes/1/matrix", "[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]")},
                refused(target.pointer("node"), "a node with a matrix cannot be animated"));
    target.rule("weights-no-mesh", "path: weights only for nodes with morph targets",
                {set("/animations/0/channels/2/target/node", "2")},
                refused("/animations/0/channels/2/target/node", "no mesh with morph targets"));
    target.common(false);
}

}  // namespace hm::corpus
