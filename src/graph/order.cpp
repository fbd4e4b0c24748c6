// Which passes run, and in which order.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/check.h"
#include "base/text.h"
#include "graph/plan.h"
#include "graph/usage.h"

namespace hm::graph {

namespace {

using PassIndex = std::uint32_t;

// The writer and the readers of one version of a resource.
struct Version {
    std::optional<PassIndex> writer;
    std::vector<PassIndex> readers;
};

using Versions = std::map<std::pair<std::uint32_t, std::uint32_t>, Version>;  // by Ref

tl::unexpected<Error> wrong(const std::string& pass, std::string message) {
    return fail(ErrorKind::internal, "render graph", pass, std::move(message));
}

Result<Versions> find_versions(const Declaration& declaration) {
    Versions versions;
    for (PassIndex pass = 0; pass < declaration.passes.size(); ++pass) {
        const PassDeclaration& p = declaration.passes[pass];
        std::set<std::uint32_t> seen;
        for (const Access& access : p.accesses) {
            const auto [resource, version] = access.ref;
            HM_CHECK(resource < declaration.resources.size(), "{} uses resource {} of {}", p.name,
                     resource, declaration.resources.size());
            const std::string& name = declaration.resources[resource].name;
            if (!seen.insert(resource).second) return wrong(p.name, "uses " + name + " twice");
            if (reads(access.kind)) versions[{resource, version}].readers.push_back(pass);
            if (!writes(access.kind)) continue;
            Version& next = versions[{resource, version + 1}];
            if (next.writer)
                return wrong(p.name, fmt::format("writes {} over the same version as {}", name,
                                                 declaration.passes[*next.writer].name));
            next.writer = pass;
        }
    }
    return versions;
}

// A version that is read must have been written or imported.
Result<void> check_reads(const Declaration& declaration, const Versions& versions) {
    for (const auto& [ref, version] : versions) {
        const ResourceDeclaration& resource = declaration.resources[ref.first];
        const bool exists = version.writer || (ref.second == 0 && resource.imported());
        if (exists || version.readers.empty()) continue;
        return wrong(
            declaration.passes[version.readers.front()].name,
            fmt::format("reads version {} of {}, which no pass writes", ref.second, resource.name));
    }
    return {};
}

// Passes that are marked `keep` or write an imported resource, and all passes they depend on.
std::vector<bool> find_needed(const Declaration& declaration, const Versions& versions) {
    std::vector<bool> needed(declaration.passes.size());
    std::vector<PassIndex> open;
    const auto need = [&](PassIndex pass) {
        if (!needed[pass]) open.push_back(pass);
        needed[pass] = true;
    };
    for (PassIndex pass = 0; pass < declaration.passes.size(); ++pass) {
        const PassDeclaration& p = declaration.passes[pass];
        bool wanted = p.keep;
        for (const Access& access : p.accesses)
            wanted = wanted ||
                     (writes(access.kind) && declaration.resources[access.ref.resource].imported());
        if (wanted) need(pass);
    }
    while (!open.empty()) {
        const PassIndex pass = open.back();
        open.pop_back();
        for (const Access& access : declaration.passes[pass].accesses) {
            if (!reads(access.kind)) continue;
            const Version& version = versions.at({access.ref.resource, access.ref.version});
            if (version.writer) need(*version.writer);
        }
    }
    return needed;
}

using Edges = std::vector<std::set<PassIndex>>;  // by pass: those that must come before it

Edges find_edges(const Declaration& declaration, const Versions& versions,
                 const std::vector<bool>& needed) {
    Edges before(declaration.passes.size());
    const auto edge = [&](PassIndex first, PassIndex then) {
        if (first != then && needed[first] && needed[then]) before[then].insert(first);
    };
    for (const auto& [ref, version] : versions) {
        if (version.writer)
            for (const PassIndex reader : version.readers)
                edge(*version.writer, reader);
        const auto next = versions.find({ref.first, ref.second + 1});
        if (next == versions.end() || !next->second.writer) continue;
        const PassIndex overwriter = *next->second.writer;
        if (version.writer) edge(*version.writer, overwriter);
        for (const PassIndex reader : version.readers)
            edge(reader, overwriter);
    }
    return before;
}

}  // namespace

Result<std::vector<std::uint32_t>> order_passes(const Declaration& declaration) {
    HM_TRY_ASSIGN(const Versions versions, find_versions(declaration));
    HM_TRY(check_reads(declaration, versions));
    const std::vector<bool> needed = find_needed(declaration, versions);
    Edges before = find_edges(declaration, versions, needed);

    std::set<PassIndex> waiting;
    for (PassIndex pass = 0; pass < needed.size(); ++pass)
        if (needed[pass]) waiting.insert(pass);
    std::vector<PassIndex> order;
    while (!waiting.empty()) {
        // The first pass in declared order whose dependencies have all been scheduled.
        const auto free =
            std::ranges::find_if(waiting, [&](PassIndex pass) { return before[pass].empty(); });
        if (free == waiting.end()) {
            std::vector<std::string> names;
            for (const PassIndex pass : waiting)
                names.push_back(declaration.passes[pass].name);
            return wrong("", "passes wait for each other: " + joined(names, ", "));
        }
        const PassIndex next = *free;
        waiting.erase(free);
        for (std::set<PassIndex>& others : before)
            others.erase(next);
        order.push_back(next);
    }
    return order;
}

}  // namespace hm::graph
