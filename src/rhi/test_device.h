// For GPU tests: a device of any kind with the validation layer, whose messages fail the test.
#pragma once

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "rhi/device.h"
#include "rhi/instance.h"

namespace hm::rhi::test {

// Fails the test with the error's line; for values, not for void.
template <class T>
T value_of(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().line());
    return std::move(*result);
}

inline void expect_ok(const Result<void>& result) {
    EXPECT_TRUE(result.has_value()) << result.error().line();
}

// Sets or unsets an environment variable for the lifetime of this object.
class Variable {
  public:
    Variable(const char* name, const char* value) : name_(name) {
        if (const char* old = std::getenv(name)) old_ = old;
        set(value);
    }
    ~Variable() { set(old_ ? old_->c_str() : nullptr); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

  private:
    void set(const char* value) const {
        if (value != nullptr)
            ::setenv(name_, value, 1);
        else
            ::unsetenv(name_);
    }

    const char* name_;
    std::optional<std::string> old_;
};

// HIMALAYA_VALIDATION=0 disables validation, for machines without the layer.
inline bool validates() {
    const char* wanted = std::getenv("HIMALAYA_VALIDATION");
    return wanted == nullptr || std::string(wanted) != "0";
}

inline std::shared_ptr<Instance> make_instance() {
    // The layer leaks memory. If it were unloaded with the instance, its leaks could not be
    // attributed to it, and tests/leaks.supp could not suppress them by its name.
    if (validates()) ::dlopen("libVkLayer_khronos_validation.so", RTLD_LAZY | RTLD_NODELETE);
    return value_of(Instance::create({.validation = validates()}));
}

// Number HIMALAYA_TEST_DEVICE of the loader's list; otherwise the best device, or the first
// software device if there is no other.
inline PhysicalDevice any_device(const Instance& instance) {
    const std::vector<PhysicalDevice> devices = value_of(instance.devices());
    if (const char* wanted = std::getenv("HIMALAYA_TEST_DEVICE"))
        return value_of(choose_index(devices, static_cast<std::uint32_t>(std::atoi(wanted))));
    if (Result<PhysicalDevice> best = choose_best(devices)) return *best;
    for (const PhysicalDevice& device : devices)
        if (device.usable()) return device;
    throw std::runtime_error(choose_best(devices).error().line() +
                             "; scripts/fetch-lavapipe.sh brings one that runs on the CPU");
}

class DeviceTest : public ::testing::Test {
  protected:
    void SetUp() override {
        instance_ = make_instance();
        device_ = value_of(Device::create(instance_, any_device(*instance_)));
    }

    void TearDown() override {
        if (instance_ == nullptr) return;
        device_.reset();
        for (const Message& message : instance_->messages().take())
            ADD_FAILURE() << message.line();
    }

    Device& device() { return *device_; }
    Instance& instance() { return *instance_; }

  private:
    std::shared_ptr<Instance> instance_;
    std::unique_ptr<Device> device_;
};

}  // namespace hm::rhi::test
