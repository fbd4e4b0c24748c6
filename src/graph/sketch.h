// Test helpers: builds by hand the declarations that Graph and Pass create.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "graph/plan.h"

namespace hm::graph::test {

class Sketch {
  public:
    Ref image(std::string name, std::uint64_t bytes = 0) {
        return add({.name = std::move(name), .is_image = true, .bytes = bytes});
    }
    Ref buffer(std::string name) { return add({.name = std::move(name)}); }
    Ref imported_image(std::string name, State state) {
        return add({.name = std::move(name), .is_image = true, .before = state, .after = state});
    }
    Ref imported_buffer(std::string name, rhi::Scope before = rhi::kEverything) {
        return add({.name = std::move(name), .before = State{before}});
    }
    std::uint32_t pass(std::string name, PassKind kind, std::vector<Access> accesses) {
        declaration.passes.push_back({std::move(name), kind, std::move(accesses), false});
        return static_cast<std::uint32_t>(declaration.passes.size() - 1);
    }
    Plan plan() const {
        Result<Plan> made = make_plan(declaration);
        if (!made) throw std::runtime_error(made.error().line());
        return std::move(*made);
    }
    std::string error() const {
        const Result<Plan> made = make_plan(declaration);
        return made ? "" : made.error().line();
    }

    Declaration declaration;

  private:
    Ref add(ResourceDeclaration resource) {
        declaration.resources.push_back(std::move(resource));
        return {static_cast<std::uint32_t>(declaration.resources.size() - 1), 0};
    }
};

inline Access read(Ref ref) {
    return {ref, AccessKind::read};
}
inline Access sample(Ref ref) {
    return {ref, AccessKind::sample};
}
inline Access write(Ref ref) {
    return {ref, AccessKind::write};
}
inline Access update(Ref ref) {
    return {ref, AccessKind::read_write};
}
inline Ref next(Ref ref) {
    return {ref.resource, ref.version + 1};
}

}  // namespace hm::graph::test
