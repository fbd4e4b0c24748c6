// OpenEXR streams in memory.
#pragma once

#include <ImfIO.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "image/codecs.h"

namespace hm {

// OpenEXR treats exceptions of a stream as read errors and rethrows them.
class ExrInput : public Imf::IStream {
  public:
    ExrInput(Bytes bytes, const std::string& name) : IStream(name.c_str()), bytes_(bytes) {}

    bool read(char to[], int count) override {
        const auto size = static_cast<std::size_t>(std::max(count, 0));
        if (at_ > bytes_.size() || size > bytes_.size() - at_)
            throw std::runtime_error("the file is truncated");
        if (size > 0) std::memcpy(to, bytes_.data() + at_, size);
        at_ += size;
        return at_ < bytes_.size();
    }
    std::uint64_t tellg() override { return at_; }
    void seekg(std::uint64_t position) override { at_ = position; }

  private:
    Bytes bytes_;
    std::uint64_t at_ = 0;
};

class ExrOutput : public Imf::OStream {
  public:
    ExrOutput() : OStream("") {}

    void write(const char from[], int count) override {
        const auto size = static_cast<std::size_t>(std::max(count, 0));
        if (bytes.size() < at_ + size) bytes.resize(at_ + size);
        if (size > 0) std::memcpy(bytes.data() + at_, from, size);
        at_ += size;
    }
    std::uint64_t tellp() override { return at_; }
    void seekp(std::uint64_t position) override { at_ = position; }

    std::vector<std::byte> bytes;

  private:
    std::uint64_t at_ = 0;
};

}  // namespace hm
