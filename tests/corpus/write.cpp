// Applies edits, embeds buffers and packs bytes.
#include <stdexcept>

#include "corpus/bases.h"
#include "corpus/case.h"
#include "corpus/container.h"
#include "corpus/tree.h"

namespace hm::corpus {
namespace {

constexpr std::string_view kPngMark = "@PNG";

std::string embed_png(std::string text) {
    const std::size_t at = text.find(kPngMark);
    return at == std::string::npos
               ? text
               : text.replace(at, kPngMark.size(), data_uri(tiny_png(), "image/png"));
}

void apply(const Edit& edit, Tree& tree) {
    if (edit.kind == Edit::Kind::set) tree.set(edit.pointer, edit.value);
    if (edit.kind == Edit::Kind::remove) tree.remove(edit.pointer);
}

}  // namespace

std::string make_file(const Case& c) {
    Document base = document(c.base);
    for (const Edit& edit : c.edits)
        if (edit.kind == Edit::Kind::bytes)
            base.buffer.replace(edit.offset, edit.value.size(), edit.value);
    Tree tree = Tree::parse(base.json);
    if (!c.glb && !base.buffer.empty())
        tree.set("/buffers/0/uri", '"' + data_uri(base.buffer) + '"');
    try {
        for (const Edit& edit : c.edits)
            apply(edit, tree);
    } catch (const std::logic_error& error) {
        throw std::logic_error(c.file + ": " + error.what());
    }
    std::string text = embed_png(tree.text());
    if (c.pack) return c.pack(std::move(text), std::move(base.buffer));
    return c.glb ? make_glb(text, base.buffer) : text;
}

}  // namespace hm::corpus
