// Builds the cases of the corpus. The schema of a property gives its standard violations; rules
// that the specification states in prose are added one by one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "corpus/case.h"

namespace hm::corpus {

// The cases added by one call, to change their expected outcome.
class Added {
  public:
    Added(std::vector<Case>& cases, std::size_t first) : cases_(cases), first_(first) {}
    Added& expect(const Expected& expected);
    Added& silent(const Silence& reason);  // the validator reports no error

  private:
    std::vector<Case>& cases_;
    std::size_t first_;
};

// One JSON object of a base document.
class Object {
  public:
    // `name` is the prefix of the file names, e.g. "accessor" for `pointer` "/accessors/0".
    Object(std::vector<Case>& cases, std::string name, std::string section, std::string pointer,
           Base base = Base::still)
        : cases_(cases),
          name_(std::move(name)),
          section_(std::move(section)),
          place_(std::move(pointer)),
          base_(base) {}

    // Violations: missing; wrong type; -1 and 0.5; index out of range.
    Added required(std::string_view key);
    Added flag(std::string_view key);
    Added text(std::string_view key);
    Added integer(std::string_view key);
    Added choice(std::string_view key);  // an integer from a list
    Added index(std::string_view key);
    Added number(std::string_view key);
    Added object(std::string_view key);
    // Violations: wrong type, and elements of a wrong type.
    Added objects(std::string_view key);
    Added indices(std::string_view key);
    // Violations: wrong type, an element of a wrong type, one element of `valid` too few or too
    // many.
    Added numbers(std::string_view key, const std::vector<std::string>& valid);
    // "extensions", which every object may have; common() adds "name" too.
    Added extensions();
    Added common(bool has_name = true);

    // `key` with this value; `slug` is the suffix of the file name. By default the file must be
    // rejected with an error at the value. `unlisted` is for values not in a list of allowed ones.
    Added value(std::string_view key, std::string_view slug, std::string_view json,
                std::string_view rule, std::string_view message);
    Added unlisted(std::string_view key, std::string_view slug, std::string_view json,
                   std::string_view rule, std::string_view message);
    Added empty(std::string_view key);  // []
    // Any other change.
    Added rule(std::string_view slug, std::string_view rule, Edits edits, Expected expected);

    std::string pointer(std::string_view key) const;

  private:
    Added wrong_type(std::string_view key, std::string_view json, std::string_view type,
                     std::string_view found);

    std::vector<Case>& cases_;
    std::string name_;
    std::string section_;
    std::string place_;
    Base base_;
};

// The rule tables, by topic.
void add_root_rules(std::vector<Case>& cases);
void add_buffer_rules(std::vector<Case>& cases);
void add_accessor_rules(std::vector<Case>& cases);
void add_mesh_rules(std::vector<Case>& cases);
void add_texture_rules(std::vector<Case>& cases);
void add_material_rules(std::vector<Case>& cases);
void add_camera_rules(std::vector<Case>& cases);
void add_node_rules(std::vector<Case>& cases);
void add_animation_rules(std::vector<Case>& cases);
void add_skin_rules(std::vector<Case>& cases);
void add_light_rules(std::vector<Case>& cases);
void add_extension_rules(std::vector<Case>& cases);
void add_text_rules(std::vector<Case>& cases);
void add_glb_rules(std::vector<Case>& cases);
void add_uri_rules(std::vector<Case>& cases);

// The whole corpus, in a fixed order. Throws std::logic_error if a table has an error.
std::vector<Case> all_cases();
// The valid documents themselves, as .gltf and as .glb.
std::vector<Case> base_cases();

}  // namespace hm::corpus
