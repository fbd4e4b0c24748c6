// Reasons why the loader, or the validator, accepts a file that violates a rule. The texts become
// the headings of docs/gltf-disagreements.md.
#pragma once

namespace hm::corpus {

// Reasons of the loader.
inline constexpr char kUnread[] = "not read: it does not affect the picture";
inline constexpr char kClamped[] = "clamped to the nearest valid value, with a warning";
inline constexpr char kEmptyIsNone[] = "an empty list means the same as none";
inline constexpr char kRepaired[] = "the meaning is clear; a warning says what is used instead";
inline constexpr char kSkipped[] = "skipped with a warning; the rest is rendered";
inline constexpr char kDecodable[] = "the data can be decoded anyway";

// Reasons of the validator.
inline constexpr char kFloatRange[] = "the validator uses 64-bit numbers, the renderer 32-bit";
inline constexpr char kProseOnly[] = "a rule stated in prose that the validator does not check";
inline constexpr char kOnlyWarns[] = "the validator reports at most a warning";
inline constexpr char kListed[] =
    "the validator only warns about unlisted values, since later versions may add some";
inline constexpr char kLastKey[] = "the validator uses the last of duplicate keys";
inline constexpr char kInPart[] = "the validator checks this extension only partially";
inline constexpr char kUnknown[] = "the validator does not know the extension";

}  // namespace hm::corpus
