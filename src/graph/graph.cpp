#include "graph/graph.h"

#include <algorithm>
#include <utility>

#include "base/check.h"

namespace hm::graph {

PassDeclaration& Pass::declaration() {
    return graph_->declaration_.passes[index_];
}

Pass& Pass::reads(Ref ref) {
    declaration().accesses.push_back({ref, AccessKind::read});
    return *this;
}

Pass& Pass::samples(Ref ref) {
    declaration().accesses.push_back({ref, AccessKind::sample});
    return *this;
}

Ref Pass::writes(Ref ref) {
    declaration().accesses.push_back({ref, AccessKind::write});
    return {ref.resource, ref.version + 1};
}

Ref Pass::updates(Ref ref) {
    declaration().accesses.push_back({ref, AccessKind::read_write});
    return {ref.resource, ref.version + 1};
}

Pass& Pass::keeps() {
    declaration().keep = true;
    return *this;
}

void Pass::records(std::function<void(rhi::Commands&)> record) {
    graph_->records_[index_] = std::move(record);
}

Ref Graph::add(ResourceDeclaration declared, Resource resource) {
    declaration_.resources.push_back(std::move(declared));
    resources_.push_back(std::move(resource));
    return {static_cast<std::uint32_t>(resources_.size() - 1), 0};
}

Ref Graph::import(const rhi::Image& image, rhi::ImageLayout layout) {
    const State state{rhi::kEverything, layout};
    Resource resource;
    resource.image = &image;
    return add({.name = image.info().name, .is_image = true, .before = state, .after = state},
               std::move(resource));
}

Ref Graph::import(const rhi::Buffer& buffer) {
    Resource resource;
    resource.buffer = &buffer;
    return add({.name = buffer.name(), .before = State{}, .after = State{}}, std::move(resource));
}

Ref Graph::image(const rhi::ImageInfo& info) {
    const rhi::MemoryNeeds needs = rhi::memory_needs(*device_, info);
    Resource resource;
    resource.image_info = info;
    return add(
        {.name = info.name, .is_image = true, .bytes = needs.bytes, .alignment = needs.alignment},
        std::move(resource));
}

Ref Graph::buffer(const rhi::BufferInfo& info) {
    Resource resource;
    resource.buffer_info = info;
    return add({.name = info.name}, std::move(resource));
}

Pass Graph::pass(std::string name, PassKind kind) {
    declaration_.passes.push_back({.name = std::move(name), .kind = kind});
    records_.emplace_back();
    return Pass(*this, static_cast<std::uint32_t>(records_.size() - 1));
}

Result<void> Graph::compile() {
    HM_TRY_ASSIGN(plan_, make_plan(declaration_));
    for (const Step& step : plan_.steps)
        HM_CHECK(records_[step.pass], "pass {} records nothing",
                 declaration_.passes[step.pass].name);
    return make_transients();
}

Result<void> Graph::make_transients() {
    rhi::MemoryNeeds heap{.bytes = plan_.heap_bytes};
    for (std::size_t i = 0; i < resources_.size(); ++i) {
        if (!plan_.offsets[i]) continue;
        const rhi::MemoryNeeds needs = rhi::memory_needs(*device_, resources_[i].image_info);
        heap.alignment = std::max(heap.alignment, needs.alignment);
        heap.types &= needs.types;
    }
    if (heap.bytes > 0) {
        HM_TRY_ASSIGN(heap_,
                      rhi::MemoryBlock::create(*device_, name_ + ": transient images", heap));
    }
    for (std::size_t i = 0; i < resources_.size(); ++i) {
        const ResourceDeclaration& declared = declaration_.resources[i];
        Resource& resource = resources_[i];
        if (declared.imported() || !plan_.lifetimes[i]) continue;
        if (declared.is_image) {
            HM_TRY_ASSIGN(resource.own_image, rhi::Image::create_in(*device_, resource.image_info,
                                                                    heap_, *plan_.offsets[i]));
            resource.image = &resource.own_image;
        } else {
            HM_TRY_ASSIGN(resource.own_buffer, rhi::Buffer::create(*device_, resource.buffer_info));
            resource.buffer = &resource.own_buffer;
        }
    }
    return {};
}

void Graph::record(rhi::Commands& commands) const {
    for (const Step& step : plan_.steps) {
        barriers(commands, step.barriers);
        commands.begin_label(declaration_.passes[step.pass].name);
        records_[step.pass](commands);
        commands.end_label();
    }
    barriers(commands, plan_.final_barriers);
}

void Graph::barriers(rhi::Commands& commands, const std::vector<PlannedBarrier>& planned) const {
    std::vector<rhi::Barrier> list;
    for (const PlannedBarrier& barrier : planned)
        list.push_back({.before = barrier.before,
                        .after = barrier.after,
                        .image = resources_[barrier.resource].image,
                        .from = barrier.from,
                        .to = barrier.to});
    commands.barriers(list);
}

const rhi::Image& Graph::image_of(Ref ref) const {
    const rhi::Image* image = resources_[ref.resource].image;
    HM_CHECK(image != nullptr, "{} is not an image, or no pass uses it",
             declaration_.resources[ref.resource].name);
    return *image;
}

const rhi::Buffer& Graph::buffer_of(Ref ref) const {
    const rhi::Buffer* buffer = resources_[ref.resource].buffer;
    HM_CHECK(buffer != nullptr, "{} is not a buffer, or no pass uses it",
             declaration_.resources[ref.resource].name);
    return *buffer;
}

}  // namespace hm::graph
