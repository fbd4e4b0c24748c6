#include "app/cli/passes.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace hm::cli {
namespace {

constexpr std::chrono::milliseconds kWatchInterval{100};

// Looks at the clock and at `stop` beside the rendering threads and sets `cancel`.
class Watcher {
  public:
    Watcher(const PassPlan& plan, const RenderCounters& counters, double pixels,
            const std::function<bool()>& stop,
            const std::function<void(const ProgressState&)>& watch)
        : plan_(plan), counters_(counters), pixels_(pixels), stop_(stop), watch_(watch) {
        thread_ = std::thread([this] { run(); });
    }

    ~Watcher() {
        {
            const std::lock_guard lock(mutex_);
            done_ = true;
        }
        wake_.notify_one();
        thread_.join();
    }

    const std::atomic<bool>& cancel() const { return cancel_; }
    double seconds() const { return seconds_since(start_); }
    void first_pass_done() { may_time_out_ = true; }
    bool interrupted() {
        if (stop_()) interrupted_ = true;
        return interrupted_;
    }

  private:
    void run() {
        std::unique_lock lock(mutex_);
        while (!wake_.wait_for(lock, next_wait(), [this] { return done_; })) {
            if (interrupted() || (may_time_out_ && plan_.time && seconds() >= *plan_.time))
                cancel_ = true;
            watch_(state());
        }
    }

    std::chrono::duration<double> next_wait() const {
        std::chrono::duration<double> wait = kWatchInterval;
        if (plan_.time && seconds() < *plan_.time)
            wait = std::min(wait, std::chrono::duration<double>(*plan_.time - seconds()));
        return wait;
    }

    ProgressState state() const {
        ProgressState s;
        s.seconds = seconds();
        s.rays = counters_.rays.load();
        s.samples_per_pixel = double(counters_.samples.load()) / pixels_;
        s.fraction = s.samples_per_pixel / double(plan_.samples);
        if (plan_.time) s.fraction = std::max(s.fraction, s.seconds / *plan_.time);
        return s;
    }

    const PassPlan& plan_;
    const RenderCounters& counters_;
    const double pixels_;
    const std::function<bool()>& stop_;
    const std::function<void(const ProgressState&)>& watch_;
    const Clock::time_point start_ = Clock::now();
    std::atomic<bool> cancel_ = false;
    std::atomic<bool> may_time_out_ = false;
    std::atomic<bool> interrupted_ = false;
    std::mutex mutex_;
    std::condition_variable wake_;
    bool done_ = false;
    std::thread thread_;
};

// As many samples as should take plan.pass_seconds, at most twice as many as the last pass.
std::uint32_t next_pass(const PassPlan& plan, std::uint32_t last, double last_seconds,
                        std::uint32_t left) {
    const double fitting = double(last) * plan.pass_seconds / std::max(last_seconds, 1e-9);
    const double count = std::clamp(fitting, 1.0, 2.0 * double(last));
    return std::min(static_cast<std::uint32_t>(count), left);
}

}  // namespace

Result<PassResult> render_passes(Renderer& renderer, const RenderJob& job, Film& film,
                                 RenderCounters& counters, const PassPlan& plan,
                                 const std::function<bool()>& stop,
                                 const std::function<void(const ProgressState&)>& watch) {
    HM_TRY(renderer.begin(job, film));
    PassResult result;
    Watcher watcher(plan, counters, double(film.sums.size()), stop, watch);
    std::uint32_t done = 0, count = 1;
    while (done < plan.samples && !watcher.cancel()) {
        const double begin = watcher.seconds();
        HM_TRY(renderer.render(done, done + count, counters, watcher.cancel()));
        watcher.first_pass_done();
        done += count;
        const double seconds = watcher.seconds();
        if (plan.time && seconds >= *plan.time) break;
        count = next_pass(plan, count, seconds - begin, plan.samples - done);
    }
    HM_TRY(renderer.sync());
    result.seconds = watcher.seconds();
    result.interrupted = watcher.interrupted() && watcher.cancel();
    return result;
}

}  // namespace hm::cli
