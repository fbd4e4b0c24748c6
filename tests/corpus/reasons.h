// Reasons why the loader, or the validator, accepts a file that violates a rule. The texts become
// the headings of docs/gltf-disagreements.md.
#pragma once

namespace hm::corpus {

// Reasons of the loader.
inline constexpr char kUnread[] = "not read: it changes no picture";
inline constexpr char kClamped[] = "clamped to the nearest valid value, with a warning";
inline constexpr char kEmptyIsNone[] = "an empty list means the same as none";
inline constexpr char kRepaired[] = "what is meant is clear, a warning says what is used";
inline constexpr char kSkipped[] = "the part is left out with a warning, the rest is drawn";
inline constexpr char kDecodable[] = "the bytes can be read all the same";

// Reasons of the validator.
inline constexpr char kFloatRange[] =
    "the validator keeps numbers in 64 bits; the renderer works with 32";
inline constexpr char kProseOnly[] = "a rule of the text that the validator does not check";
inline constexpr char kOnlyWarns[] = "the validator has a warning or less for it";
inline constexpr char kListed[] =
    "the validator warns of values outside a list: a later version may add to it";
inline constexpr char kLastKey[] = "the validator keeps the last of equal keys";
inline constexpr char kInPart[] = "the validator checks this extension in part";
inline constexpr char kUnknown[] = "the validator does not know the extension";

}  // namespace hm::corpus
