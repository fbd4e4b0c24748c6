// The barriers between passes.
#include "base/check.h"
#include "graph/plan.h"
#include "graph/usage.h"

namespace hm::graph {

namespace {

rhi::Scope operator|(const rhi::Scope& a, const rhi::Scope& b) {
    return {a.stages | b.stages, a.access | b.access};
}

bool covers(const rhi::Scope& a, const rhi::Scope& b) {
    return (a | b) == a;
}

// The state of one resource from step to step.
struct Track {
    rhi::Scope written;  // the last write, or the resource's initial scope
    rhi::Scope readers;  // scopes to which that write has been made visible since
    rhi::ImageLayout layout = rhi::ImageLayout::undefined;
};

struct Use {
    std::uint32_t step = 0;
    AccessKind kind = AccessKind::read;
    Usage usage;
};

// By resource, in the order of the steps.
std::vector<std::vector<Use>> find_uses(const Declaration& declaration,
                                        const std::vector<Step>& steps) {
    std::vector<std::vector<Use>> uses(declaration.resources.size());
    for (std::uint32_t step = 0; step < steps.size(); ++step) {
        const PassDeclaration& pass = declaration.passes[steps[step].pass];
        for (const Access& access : pass.accesses)
            uses[access.ref.resource].push_back(
                {step, access.kind, usage_of(pass.kind, access.kind)});
    }
    return uses;
}

// The combined scope of the reads from `first` on that can share one barrier: up to a write or a
// different layout.
rhi::Scope joint_scope(const std::vector<Use>& uses, std::size_t first) {
    rhi::Scope scope;
    for (std::size_t i = first; i < uses.size(); ++i) {
        if (writes(uses[i].kind) || uses[i].usage.layout != uses[first].usage.layout) break;
        scope = scope | uses[i].usage.scope;
    }
    return scope;
}

// Everything that must complete before the resource changes: its readers, which only need an
// execution dependency, or the write itself if nothing read it.
rhi::Scope before_change(const Track& track) {
    return track.readers.stages != 0 ? rhi::Scope{track.readers.stages, 0} : track.written;
}

// What a transient image must wait for: the previous owners of its memory (aliasing). The first
// owner waits for the work before the graph, which may be an earlier run of the same graph.
rhi::Scope memory_before(const Plan& plan, const Declaration& declaration,
                         const std::vector<std::vector<Use>>& uses, std::uint32_t resource) {
    if (!plan.offsets[resource]) return rhi::kEverything;
    const std::uint64_t begin = *plan.offsets[resource];
    const std::uint64_t end = begin + declaration.resources[resource].bytes;
    rhi::Scope before;
    for (std::uint32_t other = 0; other < uses.size(); ++other) {
        if (!plan.offsets[other] || other == resource) continue;
        const std::uint64_t other_begin = *plan.offsets[other];
        const std::uint64_t other_end = other_begin + declaration.resources[other].bytes;
        if (other_begin >= end || other_end <= begin ||
            plan.lifetimes[other]->last >= plan.lifetimes[resource]->first)
            continue;
        for (const Use& use : uses[other])
            before = before | use.usage.scope;
    }
    return before.stages != 0 ? before : rhi::kEverything;
}

class Planner {
  public:
    Planner(const Declaration& declaration, Plan& plan)
        : declaration_(declaration), plan_(plan), uses_(find_uses(declaration, plan.steps)) {}

    void run() {
        for (std::uint32_t resource = 0; resource < uses_.size(); ++resource)
            follow(resource);
    }

  private:
    void follow(std::uint32_t resource) {
        const ResourceDeclaration& declared = declaration_.resources[resource];
        const std::vector<Use>& uses = uses_[resource];
        if (uses.empty()) return;
        Track track;
        if (declared.imported()) {
            track.written = declared.before->scope;
            track.layout = declared.before->layout;
        } else {
            track.written = memory_before(plan_, declaration_, uses_, resource);
        }
        for (std::size_t i = 0; i < uses.size(); ++i) {
            if (writes(uses[i].kind))
                write(resource, uses[i], track);
            else
                read(resource, uses, i, track);
        }
        if (declared.after) finish(resource, *declared.after, track);
    }

    void read(std::uint32_t resource, const std::vector<Use>& uses, std::size_t i, Track& track) {
        const Use& use = uses[i];
        const bool moves = is_image(resource) && track.layout != use.usage.layout;
        if (!moves && covers(track.readers, use.usage.scope)) return;
        const rhi::Scope joint = joint_scope(uses, i);
        const rhi::Scope before = moves ? before_change(track) : track.written;
        if (moves || before.stages != 0)
            add(use.step, {resource, before, joint, track.layout, use.usage.layout});
        track.readers = moves ? joint : (track.readers | joint);
        track.layout = use.usage.layout;
    }

    void write(std::uint32_t resource, const Use& use, Track& track) {
        const rhi::ImageLayout from = reads(use.kind) ? track.layout : rhi::ImageLayout::undefined;
        const bool moves = is_image(resource) && from != use.usage.layout;
        const rhi::Scope before = before_change(track);
        if (moves || before.stages != 0)
            add(use.step, {resource, before, use.usage.scope, from, use.usage.layout});
        track.written = use.usage.scope;
        track.readers = {};
        track.layout = use.usage.layout;
    }

    void finish(std::uint32_t resource, const State& after, const Track& track) {
        const bool moves = is_image(resource) && track.layout != after.layout;
        // Later work may write, so it waits for readers too.
        const rhi::Scope before =
            moves ? before_change(track) : track.written | rhi::Scope{track.readers.stages, 0};
        if (!moves && covers(track.readers, after.scope)) return;
        plan_.final_barriers.push_back(
            normal({resource, before, after.scope, track.layout, after.layout}));
    }

    bool is_image(std::uint32_t resource) const {
        return declaration_.resources[resource].is_image;
    }

    PlannedBarrier normal(PlannedBarrier barrier) const {
        if (!is_image(barrier.resource)) barrier.from = barrier.to = rhi::ImageLayout::undefined;
        return barrier;
    }

    void add(std::uint32_t step, const PlannedBarrier& barrier) {
        plan_.steps[step].barriers.push_back(normal(barrier));
    }

    const Declaration& declaration_;
    Plan& plan_;
    std::vector<std::vector<Use>> uses_;
};

}  // namespace

void plan_barriers(const Declaration& declaration, Plan& plan) {
    Planner(declaration, plan).run();
}

Result<Plan> make_plan(const Declaration& declaration) {
    HM_TRY_ASSIGN(const std::vector<std::uint32_t> order, order_passes(declaration));
    Plan plan;
    std::vector<bool> runs(declaration.passes.size());
    for (const std::uint32_t pass : order) {
        plan.steps.push_back({pass, {}});
        runs[pass] = true;
    }
    for (std::uint32_t pass = 0; pass < runs.size(); ++pass)
        if (!runs[pass]) plan.culled.push_back(pass);
    place_transients(declaration, plan);
    plan_barriers(declaration, plan);
    return plan;
}

}  // namespace hm::graph
