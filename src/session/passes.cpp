#include "session/passes.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "base/clock.h"

namespace hm {
namespace {

constexpr double kWatchSeconds = 0.1;

// A thread that checks the time, sets `cancel` and reports progress while others render.
class Watcher {
  public:
    Watcher(const PassPlan& plan, const PassHooks& hooks, const RenderCounters& counters,
            const Film& film)
        : plan_(plan),
          hooks_(hooks),
          counters_(counters),
          samples_wanted_(double(plan.end - film.first_sample)),
          pixels_(double(film.sums.size())),
          kept_at_(plan.seconds_before) {
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
    double seconds() const { return plan_.seconds_before + seconds_since(start_); }
    bool stopped() const { return threw_ || hooks_.stop(); }
    // What a hook threw on the watching thread.
    void rethrow() const {
        if (threw_) std::rethrow_exception(thrown_);
    }
    bool timed_out() const { return may_time_out_ && plan_.time && seconds() >= *plan_.time; }
    bool keep_due() const { return plan_.keep_every && seconds() >= kept_at_ + *plan_.keep_every; }

    void let_time_out() { may_time_out_ = true; }
    void go_on() { cancel_ = false; }
    void keep() {
        hooks_.keep(counters_, seconds());
        kept_at_ = seconds();
        cancel_ = false;
    }

  private:
    void run() {
        std::unique_lock lock(mutex_);
        while (!wake_.wait_for(lock, next_wait(), [this] { return done_; })) {
            if (timed_out() || keep_due()) cancel_ = true;
            try {
                hooks_.watch(state());
            } catch (...) {
                thrown_ = std::current_exception();
                threw_ = true;
                return;
            }
        }
    }

    std::chrono::duration<double> next_wait() const {
        double wait = kWatchSeconds;
        const auto end_at = [&](double moment) {
            const double left = moment - seconds();
            if (left > 0) wait = std::min(wait, left);
        };
        if (plan_.time) end_at(*plan_.time);
        if (plan_.keep_every) end_at(kept_at_ + *plan_.keep_every);
        return std::chrono::duration<double>(wait);
    }

    ProgressState state() const {
        ProgressState s;
        s.seconds = seconds();
        s.rays = counters_.rays.load();
        s.samples_per_pixel = double(counters_.samples.load()) / pixels_;
        s.fraction = s.samples_per_pixel / samples_wanted_;
        if (plan_.time) s.fraction = std::max(s.fraction, s.seconds / *plan_.time);
        return s;
    }

    const PassPlan& plan_;
    const PassHooks& hooks_;
    const RenderCounters& counters_;
    const double samples_wanted_;
    const double pixels_;
    const Clock::time_point start_ = Clock::now();
    std::atomic<double> kept_at_;  // in seconds()
    std::atomic<bool> cancel_ = false;
    std::atomic<bool> may_time_out_ = false;
    std::exception_ptr thrown_;  // set before threw_
    std::atomic<bool> threw_ = false;
    std::mutex mutex_;
    std::condition_variable wake_;
    bool done_ = false;
    std::thread thread_;
};

// The number of samples that should take plan.pass_seconds, at most twice that of the last pass.
std::uint32_t next_pass(const PassPlan& plan, std::uint32_t last, double last_seconds) {
    const double fitting = double(last) * plan.pass_seconds / std::max(last_seconds, 1e-9);
    return static_cast<std::uint32_t>(std::clamp(fitting, 1.0, 2.0 * double(last)));
}

// The index up to which every pixel has all samples.
std::uint32_t reached(const Film& film) {
    return film.first_sample + film.fewest_samples();
}

// Synchronises the film and remembers the counters at that time.
class Synced {
  public:
    Synced(Renderer& renderer, RenderCounters& counters)
        : renderer_(renderer), counters_(counters) {
        remember();
    }
    Result<void> sync() {
        HM_TRY(renderer_.sync());
        remember();
        return {};
    }
    bool due(double every) const { return seconds_since(at_) >= every; }
    // Sets the counters to those of the last synchronisation.
    void restore() {
        counters_.samples = samples_;
        counters_.rays = rays_;
        counters_.non_finite = non_finite_;
    }

  private:
    void remember() {
        samples_ = counters_.samples;
        rays_ = counters_.rays;
        non_finite_ = counters_.non_finite;
        at_ = Clock::now();
    }

    Renderer& renderer_;
    RenderCounters& counters_;
    std::uint64_t samples_ = 0, rays_ = 0, non_finite_ = 0;
    Clock::time_point at_;
};

// A pass ends when all pixels have equally many samples; `until` is where the current one ends.
Result<void> draw_passes(Renderer& renderer, const Film& film, RenderCounters& counters,
                         const PassPlan& plan, Watcher& watcher, Synced& synced) {
    std::uint32_t done = reached(film), until = film.first_sample + film.most_samples();
    std::uint32_t count = 1;
    while (done < plan.end) {
        if (done == until && watcher.stopped()) break;
        if (done == until) until = done + std::min(count, plan.end - done);
        if (done > film.first_sample) watcher.let_time_out();
        if (watcher.timed_out()) break;
        const double begin = watcher.seconds();
        HM_TRY(renderer.render(done, until, counters, watcher.cancel()));
        if (watcher.cancel()) {
            watcher.go_on();
            HM_TRY(synced.sync());
            done = reached(film);
        } else {
            count = next_pass(plan, until - done, watcher.seconds() - begin);
            done = until;
        }
        const bool keeps = watcher.keep_due();
        if (keeps || synced.due(plan.sync_every)) HM_TRY(synced.sync());
        if (keeps) watcher.keep();
    }
    return synced.sync();
}

}  // namespace

Result<PassResult> render_passes(Renderer& renderer, const RenderJob& job, Film& film,
                                 RenderCounters& counters, const PassPlan& plan,
                                 const PassHooks& hooks) {
    HM_TRY(renderer.begin(job, film));
    const double held = film.mean_samples();
    Synced synced(renderer, counters);
    Watcher watcher(plan, hooks, counters, film);
    const Result<void> drawn = draw_passes(renderer, film, counters, plan, watcher, synced);
    watcher.rethrow();
    if (drawn) return PassResult{watcher.seconds(), watcher.stopped() && reached(film) < plan.end};
    synced.restore();
    if (film.mean_samples() == held) return tl::unexpected(drawn.error());
    return PassResult{watcher.seconds(), false, drawn.error()};
}

}  // namespace hm
