// Accessors and the allowed values of their data (glTF 2.0, 3.6.2, 5.1 to 5.4).
#include <limits>

#include "corpus/bases.h"
#include "corpus/reasons.h"
#include "corpus/rules.h"

namespace hm::corpus {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

void add_bounds(std::vector<Case>& cases) {
    Object accessor(cases, "accessor", "3.6.2", "/accessors/0");
    accessor.rule("past-view", "count: the last element ends within the buffer view",
                  {set("/accessors/0/count", "4")},
                  refused("/accessors/0", "ends at byte 48 of buffer view 0, which has 36"));
    accessor.rule("count-overflow", "count: the last element ends within the buffer view",
                  {set("/accessors/0/count", "4294967294")},
                  refused("/accessors/0", "ends at byte 51539607528 of buffer view 0"));
    accessor.rule("offset-past-view", "byteOffset: within the buffer view",
                  {set("/accessors/0/byteOffset", "36")},
                  refused("/accessors/0", "ends at byte 72 of buffer view 0, which has 36"));
    accessor.rule("offset-overflow", "byteOffset: within the buffer view",
                  {set("/accessors/0/byteOffset", "9007199254740992")},
                  refused("/accessors/0", "of buffer view 0, which has 36"));
    accessor.rule("offset-unaligned", "byteOffset: a multiple of the component's size",
                  {set("/accessors/0/byteOffset", "2"), set("/accessors/0/count", "2")},
                  refused("/accessors/0/byteOffset", "not aligned to 4 bytes"));
    accessor.rule("view-unaligned", "byteOffset of the view: a multiple of the component's size",
                  {set("/bufferViews/3/byteOffset", "95")},
                  refused("/accessors/3/byteOffset", "not aligned to 2 bytes"));
    accessor.rule("offset-no-view", "byteOffset: not without a bufferView",
                  {set("/accessors/6/byteOffset", "4")}, ignored(kUnread));
    accessor.rule("normalized-float", "normalized: not with componentType 5126",
                  {set("/accessors/1/normalized", "true")},
                  warned("/accessors/1/normalized", "only 8-bit and 16-bit", kRepaired));
}

void add_extrema(std::vector<Case>& cases) {
    Object accessor(cases, "accessor", "3.6.2.5", "/accessors/0");
    const Expected wrong = warned("/accessors/0", "min and max do not match the elements",
                                  "the elements themselves are read");
    for (const char* key : {"min", "max"}) {
        accessor.numbers(key, {"0", "0", "0"});
        accessor.empty(key).expect(refused(accessor.pointer(key), "expected 3 numbers, found 0"));
        accessor.required(key).expect(warned("/accessors/0", "min and max are missing", kRepaired));
        accessor.value(key, "wrong", "[0.5,0.5,0.5]", "is that of the data", "").expect(wrong);
    }
}

void add_values(std::vector<Case>& cases) {
    Object accessor(cases, "values", "3.6.2.4", "/accessors/0");
    accessor.rule("nan", "floats: not NaN", {put(4, floats({kNan}))},
                  refused("/accessors/0", "element 0 is NaN"));
    accessor.rule("infinity", "floats: not infinite", {put(12, floats({kInfinity}))},
                  refused("/accessors/0", "element 1 is infinite"));
    accessor.rule("uv-nan", "floats: not NaN", {put(72, floats({kNan}))},
                  warned("/accessors/2", "NaN or infinite texture coordinates", kRepaired));
    accessor.rule("normal-nan", "floats: not NaN", {put(36, floats({kNan}))},
                  warned("/accessors/1", "some normals are zero or not finite", kRepaired));
    accessor.rule("normal-length", "NORMAL: unit length", {put(36, floats({0, 0, 2}))},
                  ignored("vectors are scaled to unit length"));
    accessor.rule("normal-zero", "NORMAL: unit length", {put(36, floats({0, 0, 0}))},
                  warned("/accessors/1", "some normals are zero", kRepaired));
    accessor.rule("tangent-length", "TANGENT: xyz has unit length", {put(116, floats({2, 0, 0}))},
                  ignored("vectors are scaled to unit length"));
    accessor.rule("tangent-sign", "TANGENT: w is 1 or -1", {put(128, floats({0.5f}))},
                  warned("/accessors/5", "a w other than 1 or -1", kRepaired));
    const Edits float_colors{
        set("/accessors/4/bufferView", "5"), set("/accessors/4/componentType", "5126"),
        drop("/accessors/4/normalized"), drop("/meshes/0/primitives/0/attributes/TANGENT")};
    Edits colors = float_colors;
    colors.push_back(put(116, floats({1.5f})));
    accessor.rule("color-above", "COLOR_0: 0 to 1", colors,
                  warned("/accessors/4", "vertex colours outside 0 to 1", kClamped));
    colors.back() = put(116, floats({-0.5f}));
    accessor.rule("color-below", "COLOR_0: 0 to 1", colors,
                  warned("/accessors/4", "vertex colours outside 0 to 1", kClamped));
    accessor.rule("index-past-end", "indices: below the count of vertices", {put(98, shorts({3}))},
                  refused("/meshes/0/primitives/0/indices", "index 3 (element 1 of accessor 3)"));
    accessor.rule("index-restart", "indices: not the largest value of their type",
                  {put(98, shorts({65535}))},
                  refused("/meshes/0/primitives/0/indices", "index 65535"));
}

void add_sparse(std::vector<Case>& cases) {
    Object sparse(cases, "sparse", "5.2", "/accessors/6/sparse");
    sparse.required("count");
    sparse.integer("count");
    sparse.value("count", "zero", "0", "is at least 1", "0 is not between 1 and");
    sparse.value("count", "above", "4", "is not more than the accessor's",
                 "4 is not between 1 and");
    sparse.required("indices");
    sparse.object("indices");
    sparse.required("values");
    sparse.object("values");
    sparse.common(false);

    Object indices(cases, "sparse-indices", "5.3", "/accessors/6/sparse/indices");
    indices.required("bufferView");
    indices.index("bufferView");
    indices.integer("byteOffset");
    indices.value("byteOffset", "past-end", "4", "within the buffer view", "")
        .expect(refused(indices.pointer(""), "1 elements extend past the end of buffer view 6"));
    indices.required("componentType");
    indices.choice("componentType").expect(refused(indices.pointer("componentType"), ""));
    indices.unlisted("componentType", "signed", "5120", "is 5121, 5123 or 5125",
                     "sparse indices must be unsigned integers");
    indices.unlisted("componentType", "float", "5126", "is 5121, 5123 or 5125",
                     "sparse indices must be unsigned integers");
    indices.unlisted("componentType", "unknown", "0", "is 5121, 5123 or 5125",
                     "is not a component type");
    indices.rule("unaligned", "byteOffset: a multiple of the component's size",
                 {set("/accessors/6/sparse/indices/componentType", "5123"),
                  set("/accessors/6/sparse/indices/byteOffset", "1")},
                 refused(indices.pointer("byteOffset"), "not aligned to 2 bytes"));
    indices.rule("value-past-end", "indices: below the accessor's count", {put(164, words({3}))},
                 refused(indices.pointer(""), "past the end of the accessor"));
    indices.rule("not-increasing", "indices: strictly increasing",
                 {set("/accessors/6/sparse/count", "2"), set("/bufferViews/7/byteLength", "24"),
                  put(164, words({0x0001}))},
                 refused(indices.pointer(""), "is not greater than the one before"));
    indices.common(false);

    Object values(cases, "sparse-values", "5.4", "/accessors/6/sparse/values");
    values.required("bufferView");
    values.index("bufferView");
    values.integer("byteOffset");
    values.value("byteOffset", "past-end", "4", "within the buffer view", "")
        .expect(refused(values.pointer(""), "1 elements extend past the end of buffer view 7"));
    values.rule("unaligned", "byteOffset: a multiple of the component's size",
                {set("/bufferViews/7/byteOffset", "169")},
                refused(values.pointer("byteOffset"), "not aligned to 4 bytes"));
    values.rule("nan", "values: not NaN", {put(168, floats({kNan}))},
                refused("/accessors/6", "is NaN"));
    values.common(false);
}

}  // namespace

void add_accessor_rules(std::vector<Case>& cases) {
    Object accessor(cases, "accessor", "5.1", "/accessors/0");
    accessor.index("bufferView");
    accessor.integer("byteOffset");
    accessor.required("componentType");
    accessor.integer("componentType");
    accessor.value("componentType", "unknown", "5124", "is one of the known types",
                   "is not a component type");
    accessor.value("componentType", "double", "5130", "is one of the known types",
                   "is not a component type");
    accessor.flag("normalized");
    accessor.required("count");
    accessor.integer("count");
    accessor.value("count", "zero", "0", "is at least 1", "is not in the range 1 to");
    accessor.required("type");
    accessor.text("type");
    accessor.value("type", "unknown", R"("VEC5")", "is one of the known types",
                   "is not an element type");
    accessor.value("type", "case", R"("vec3")", "is one of the known types",
                   "is not an element type");
    accessor.value("sparse", "type", "[]", "is an object", "expected an object, found an array");
    accessor.common();
    add_bounds(cases);
    add_extrema(cases);
    add_values(cases);
    add_sparse(cases);
}

}  // namespace hm::corpus
