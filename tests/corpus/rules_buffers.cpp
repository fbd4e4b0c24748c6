// Buffers, buffer views and sparse storage (glTF 2.0, 3.6.1, 5.10, 5.11).
#include "corpus/bases.h"
#include "corpus/reasons.h"
#include "corpus/rules.h"

namespace hm::corpus {

void add_buffer_rules(std::vector<Case>& cases) {
    Object buffer(cases, "buffer", "5.10", "/buffers/0");
    buffer.required("byteLength");
    buffer.integer("byteLength");
    buffer.value("byteLength", "zero", "0", "is at least 1", "must not be 0");
    buffer.value("byteLength", "huge", "1e300", "is an integer", "expected an integer from 0");
    buffer.value("byteLength", "too-long", "253", "is not more than the source has",
                 "253 bytes, but only 252 are available");
    buffer.text("uri");
    buffer
        .rule("uri-missing", "uri: only the first buffer of a GLB may lack it while used",
              {drop("/buffers/0/uri")}, refused("/buffers/0", "has neither a uri nor a GLB chunk"))
        .silent("the validator takes a buffer without a source for an extension's");
    buffer.common();

    Object view(cases, "bufferView", "5.11", "/bufferViews/0");
    view.required("buffer");
    view.index("buffer");
    view.integer("byteOffset");
    view.required("byteLength");
    view.integer("byteLength");
    view.value("byteLength", "zero", "0", "is at least 1", "must not be 0");
    view.rule("byteLength-past-end", "byteOffset + byteLength: within the buffer",
              {set("/bufferViews/8/byteLength", "73")},
              refused("/bufferViews/8", "bytes 180 to 253 of a buffer of 252"));
    view.rule("byteOffset-past-end", "byteOffset: within the buffer",
              {set("/bufferViews/0/byteOffset", "9007199254740992")},
              refused("/bufferViews/0", "of a buffer of 252"));
    view.integer("byteStride");
    view.value("byteStride", "small", "3", "is at least 4", "is not a multiple of 4 from 4 to 252");
    view.value("byteStride", "large", "256", "is at most 252",
               "is not a multiple of 4 from 4 to 252");
    view.value("byteStride", "odd", "13", "is a multiple of 4",
               "is not a multiple of 4 from 4 to 252");
    view.value("byteStride", "element", "8", "is not less than an element", "")
        .expect(refused("/accessors/0/bufferView", "its byteStride, 8, is less than"));
    view.choice("target");
    view.unlisted("target", "unknown", "34964", "is 34962 or 34963", "34964 is not a target");
    view.value("target", "differs", "34963", "is 34962 where vertices are stored", "")
        .expect(ignored(kUnread));
    view.rule("target-indices", "target: is 34963 where indices are stored",
              {set("/bufferViews/3/target", "34962")}, ignored(kUnread));
    view.rule("byteStride-indices", "byteStride: only on vertex attributes' views",
              {set("/bufferViews/3/byteStride", "4"), set("/bufferViews/3/byteLength", "10"),
               put(104, shorts({1}))},
              refused("/meshes/0/primitives/0/indices", "has a byteStride"));
    view.rule("byteStride-shared", "byteStride: is set where two accessors share the view",
              {set("/accessors/6/bufferView", "0"), drop("/bufferViews/0/byteStride")},
              ignored(kDecodable));
    view.rule("byteStride-sparse", "byteStride: not on the views of sparse accessors",
              {set("/bufferViews/6/byteStride", "4")},
              refused("/accessors/6/sparse/indices/bufferView", "has a byteStride"));
    view.rule("target-sparse", "target: not on the views of sparse accessors",
              {set("/bufferViews/6/target", "34962")}, ignored(kUnread));
    view.rule("byteStride-image", "byteStride: not on the views of images",
              {set("/bufferViews/8/byteStride", "4")}, ignored(kDecodable));
    view.rule("target-image", "target: not on the views of images",
              {set("/bufferViews/8/target", "34962")}, ignored(kUnread));
    view.common();
}

}  // namespace hm::corpus
