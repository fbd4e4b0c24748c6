// Containers: JSON text (glTF 2.0, 2.7, 3.1), GLB (4.4) and URIs (2.8).
#include <fmt/format.h>

#include "corpus/bases.h"
#include "corpus/container.h"
#include "corpus/reasons.h"
#include "corpus/rules.h"

namespace hm::corpus {
namespace {

using Pack = std::function<std::string(std::string, std::string)>;

void add_packed(std::vector<Case>& cases, std::string file, std::string rule, std::string section,
                Pack pack, Expected expected, Silence silence = {}) {
    Case c;
    c.glb = file.ends_with(".glb");
    c.file = std::move(file);
    c.rule = std::move(rule);
    c.section = std::move(section);
    c.pack = std::move(pack);
    c.expected = std::move(expected);
    c.validator_silence = std::move(silence);
    cases.push_back(std::move(c));
}

// `text` with the first occurrence of `from` replaced.
Pack replacing(std::string from, std::string to) {
    return [=](std::string text, std::string) {
        return text.replace(text.find(from), from.size(), to);
    };
}

Pack instead(std::string content) {
    return [=](std::string, std::string) { return content; };
}

std::string nested(std::size_t depth) {
    return std::string(depth, '[') + std::string(depth, ']');
}

}  // namespace

void add_text_rules(std::vector<Case>& cases) {
    const auto add = [&](const char* slug, const char* rule, Pack pack, Expected expected,
                         Silence silence = {}) {
        add_packed(cases, fmt::format("json-{}.gltf", slug), rule, "2.7", std::move(pack),
                   std::move(expected), std::move(silence));
    };
    const Expected no_json = refused("", "is not valid JSON");
    add("empty", "is a JSON document", instead(""), refused("", "is empty"));
    add("spaces", "is a JSON document", instead(" \n"), refused("", "is empty"));
    add("text", "is a JSON document", instead("hello"), no_json);
    add("array", "is an object", instead("[]"), refused("", "its JSON is not an object"));
    add("null", "is an object", instead("null"), refused("", "its JSON is not an object"));
    add(
        "cut", "is a whole document",
        [](std::string text, std::string) {
            text.pop_back();
            return text;
        },
        no_json);
    add(
        "trailing", "nothing after the document",
        [](std::string text, std::string) { return text + "}"; }, no_json);
    add("trailing-comma", "RFC 8259", replacing("\"scene\":0", "\"scene\":0,"), no_json);
    add("single-quotes", "RFC 8259", replacing("\"scene\":0", "'scene':0"), no_json);
    add("comment", "RFC 8259", replacing("\"scene\":0", "/**/\"scene\":0"), no_json);
    add("unquoted-key", "RFC 8259", replacing("\"scene\":0", "scene:0"), no_json);
    add("leading-zero", "RFC 8259", replacing("\"scene\":0", "\"scene\":00"), no_json);
    add("plus", "RFC 8259", replacing("\"scene\":0", "\"scene\":+0"), no_json);
    add("nan", "RFC 8259", replacing("\"scene\":0", "\"scene\":NaN"), no_json);
    add("control", "RFC 8259", replacing("\"corpus\"", "\"a\nb\""), no_json);
    add("escape", "RFC 8259", replacing("\"corpus\"", R"("\x41")"), no_json);
    add("surrogate", "RFC 8259", replacing("\"corpus\"", R"("\ud800")"), no_json, kProseOnly);
    add("huge-exponent", "numbers fit a 64-bit float", replacing("\"yfov\":1", "\"yfov\":1e999"),
        no_json);
    add("utf8-cut", "UTF-8", replacing("\"corpus\"", "\"\xc3\""),
        refused("", "is not valid UTF-8"));
    add("utf8-overlong", "UTF-8", replacing("\"corpus\"", "\"\xc0\xaf\""),
        refused("", "is not valid UTF-8"));
    add("utf8-surrogate", "UTF-8", replacing("\"corpus\"", "\"\xed\xa0\x80\""),
        refused("", "is not valid UTF-8"));
    add(
        "byte-order-mark", "no byte order mark",
        [](std::string text, std::string) { return "\xef\xbb\xbf" + text; },
        ignored("RFC 8259, 8.1, lets a reader ignore it"));
    add("utf16", "UTF-8", instead(std::string("\xff\xfe{\0}\0", 6)), refused("", "UTF-16"));
    add("duplicate-key", "keys are unique", replacing("\"scene\":0", R"("scene":0,"scene":0)"),
        refused("/scene", "is repeated in its object"), kLastKey);
    add("duplicate-nested", "keys are unique", replacing("\"yfov\":1", R"("yfov":1,"yfov":2)"),
        refused("/cameras/0/perspective/yfov", "is repeated in its object"), kLastKey);
    add("deep", "nesting has a limit",
        replacing("\"scene\":0", "\"scene\":0,\"extras\":" + nested(2000)),
        refused("", "levels deep"), "the specification gives no limit; this loader's is 256");
    add("deep-open", "is a whole document", instead(std::string(5000, '[')), refused("", ""));
}

void add_glb_rules(std::vector<Case>& cases) {
    const auto add = [&](const char* slug, const char* rule, Pack pack, Expected expected,
                         Silence silence = {}) {
        add_packed(cases, fmt::format("glb-{}.glb", slug), rule, "4.4", std::move(pack),
                   std::move(expected), std::move(silence));
    };
    // Overwrites bytes of a valid GLB at a byte offset.
    const auto patched = [](std::size_t at, std::string bytes) {
        return [=](std::string text, std::string buffer) {
            return make_glb(text, buffer).replace(at, bytes.size(), bytes);
        };
    };
    const auto chunks = [](std::string content) {
        return glb_header(2, 12 + content.size()) + content;
    };
    add("magic", "magic: glTF", patched(0, "glTf"), refused("", "is not valid"));
    add("version-1", "version: 2", patched(4, word(1)),
        refused("byte 4", "GLB version 1", ErrorKind::unsupported));
    add("version-3", "version: 2", patched(4, word(3)),
        refused("byte 4", "GLB version 3", ErrorKind::unsupported));
    add("header-cut", "header: 12 bytes", instead("glTF\2"), refused("byte 5", "truncated"));
    add("length-long", "length: that of the file", patched(8, word(1u << 30)),
        refused("byte 8", "the GLB header gives"));
    add("length-short", "length: that of the file", patched(8, word(8)),
        refused("byte 8", "a length of 8 bytes"));
    add(
        "trailing", "length: that of the file",
        [](std::string text, std::string buffer) { return make_glb(text, buffer) + "more"; },
        warned("", "bytes after the end of the GLB", kRepaired), kOnlyWarns);
    add("no-chunk", "the first chunk is JSON", instead(glb_header(2, 12)),
        refused("byte 12", "the GLB has no JSON chunk"));
    add(
        "chunk-header-cut", "chunks: a header of 8 bytes",
        [=](std::string, std::string) { return chunks(word(0)); },
        refused("byte 12", "a GLB chunk header is truncated"));
    add("chunk-long", "chunkLength: within the file", patched(12, word(0xfffffffc)),
        refused("byte 12", "extends past the end"));
    add(
        "chunk-unaligned", "chunkLength: a multiple of 4",
        [=](std::string text, std::string) {
            text.resize(text.size() / 4 * 4 + 5, ' ');
            return chunks(word(text.size()) + word(kJsonChunk) + text);
        },
        refused("byte 12", "is not a multiple of 4"));
    add(
        "first-binary", "the first chunk is JSON",
        [=](std::string text, std::string buffer) {
            return chunks(chunk(kBinaryChunk, buffer, '\0') + chunk(kJsonChunk, text, ' '));
        },
        refused("byte 12", "the first GLB chunk is not JSON"));
    add(
        "json-empty", "the JSON chunk: a document",
        [=](std::string, std::string) { return chunks(chunk(kJsonChunk, "", ' ')); },
        refused("byte 20", "the GLB has no JSON chunk"));
    add(
        "json-zeros", "the JSON chunk: padded by spaces",
        [=](std::string text, std::string buffer) {
            return chunks(chunk(kJsonChunk, text + std::string(4, '\0'), '\0') +
                          chunk(kBinaryChunk, buffer, '\0'));
        },
        refused("", "is not valid JSON"));
    add(
        "binary-third", "the BIN chunk is the second",
        [=](std::string text, std::string buffer) {
            return chunks(chunk(kJsonChunk, text, ' ') + chunk(0x12345678, "abcd", '\0') +
                          chunk(kBinaryChunk, buffer, '\0'));
        },
        refused("/buffers/0", "has neither a uri nor a GLB chunk"));
    add(
        "binary-short", "the BIN chunk: as long as the buffer",
        [=](std::string text, std::string buffer) { return make_glb(text, buffer.substr(0, 100)); },
        refused("/buffers/0/byteLength", "252 bytes, but only 100 are available"));
    add(
        "binary-long", "the BIN chunk: at most 3 bytes longer than the buffer",
        [=](std::string text, std::string buffer) { return make_glb(text, buffer + "padded"); },
        ignored(kDecodable), kOnlyWarns);
    add(
        "binary-absent", "the BIN chunk: there where a buffer needs it",
        [=](std::string text, std::string) { return chunks(chunk(kJsonChunk, text, ' ')); },
        refused("/buffers/0", "has neither a uri nor a GLB chunk"));
    add(
        "json-twice", "one JSON chunk",
        [=](std::string text, std::string buffer) {
            return chunks(chunk(kJsonChunk, text, ' ') + chunk(kBinaryChunk, buffer, '\0') +
                          chunk(kJsonChunk, text, ' '));
        },
        warned("", "GLB chunk of unknown type", kSkipped));
}

void add_uri_rules(std::vector<Case>& cases) {
    Object buffer(cases, "uri", "2.8", "/buffers/0");
    const auto refuse = [&](const char* slug, const std::string& uri, const char* rule,
                            const char* message) {
        return buffer.value("uri", slug, '"' + uri + '"', rule, message);
    };
    refuse("no-comma", "data:application/octet-stream;base64", "RFC 2397", "without a comma");
    refuse("bad-percent", "data:application/octet-stream,%0", "RFC 2397",
           "not followed by two hexadecimal digits");
    refuse("bad-digit", "data:application/octet-stream;base64,AA!A", "RFC 4648",
           "invalid base64 character");
    refuse("bad-length", "data:application/octet-stream;base64,AAAAA", "RFC 4648",
           "not a multiple of 4");
    refuse("bits-past-end", "data:application/octet-stream;base64,AAB=", "RFC 4648",
           "nonzero padding bits");
    refuse("media-type", data_uri(document(Base::still).buffer, "text/plain"),
           "media type application/octet-stream or application/gltf-buffer", "")
        .expect(ignored(kDecodable));
    refuse("short", "data:application/octet-stream;base64,AAAA", "as long as byteLength", "")
        .expect(refused("/buffers/0/byteLength", "252 bytes, but only 3 are available"));
    refuse("empty", "", "is not empty", "empty URI");
    refuse("http", "http://localhost/a.bin", "is read from beside the file",
           "only relative paths and data URIs are supported");
    refuse("absolute", "/etc/hostname", "is read from beside the file",
           "absolute paths are rejected");
    refuse("parent", "../a.bin", "is read from beside the file", "are rejected");
    refuse("percent", "a%zz.bin", "RFC 3986", "is not followed by two hexadecimal digits");
    refuse("zero-byte", "a%00.bin", "is a path", "the path contains a zero byte");
    refuse("missing-file", "absent.bin", "is read from beside the file", "")
        .expect(refused("/buffers/0/uri", "absent.bin", ErrorKind::unreadable));
}

}  // namespace hm::corpus
