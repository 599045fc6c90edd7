#pragma once
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/jobs/progress.hpp"
#include "ui/window_status.hpp"

namespace stemwise {

/// Which thread a job runs on: what a person asked for, tables of the current revision, autosave, what forms would do.
enum class JobLane { person, tables, keeper, previews };
inline constexpr std::size_t job_lane_count = 4;

/// What became of a job, said when its result is delivered.
struct JobVerdict {
  bool good = true;
  std::string sentence;
};

/// Long work beside the window. A job gets a snapshot by value, returns a value, and never sees a panel or the project;
/// its result is delivered by `poll`, on the thread that draws.
class JobRunner {
 public:
  JobRunner();
  ~JobRunner();  ///< cancels and waits
  JobRunner(const JobRunner&) = delete;
  JobRunner& operator=(const JobRunner&) = delete;

  /// `work` runs on the lane's thread and may throw Cancelled; `done` gets its value in `poll`.
  template <class Value>
  int start(std::string title, JobLane lane, std::function<Value(const Progress&)> work, std::function<JobVerdict(Value)> done) {
    auto value = std::make_shared<std::optional<Value>>();
    return enqueue(std::move(title), lane, [value, work = std::move(work)](const Progress& progress) { value->emplace(work(progress)); },
                   [value, done = std::move(done)] { return done(std::move(**value)); });
  }

  /// Delivers what is finished. True when something was.
  bool poll();
  void cancel(int id);
  void cancel_all();
  void forget_finished();  ///< the list of the person's jobs begins anew with those that still run
  /// Jobs of the person, newest first.
  std::vector<ui::JobView> views() const;
  bool is_busy(JobLane lane) const;
  bool is_busy() const;
  /// Blocks until a job has news or nothing is under way. For tests and for leaving.
  void wait_for_news();
  /// Called on the worker's thread whenever there is something new to show.
  void on_news(std::function<void()> wake);

 private:
  struct Job;
  int enqueue(std::string title, JobLane lane, std::function<void(const Progress&)> run, std::function<JobVerdict()> deliver);
  void work_on(std::size_t lane);
  void run(Job& job);
  void deliver(Job& job);
  void announce();

  mutable std::mutex mutex_;
  std::condition_variable wake_worker_;
  std::condition_variable news_;
  std::uint64_t news_count_ = 0;
  std::uint64_t news_seen_ = 0;
  std::array<std::deque<std::shared_ptr<Job>>, job_lane_count> waiting_;
  std::vector<std::shared_ptr<Job>> all_;  ///< oldest first; hidden ones go when delivered
  std::function<void()> wake_;
  bool stopping_ = false;
  int next_id_ = 1;
  std::array<std::thread, job_lane_count> threads_;
};

}  // namespace stemwise
