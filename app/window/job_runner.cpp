#include "app/window/job_runner.hpp"

#include <algorithm>

namespace stemwise {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t jobs_kept = 50;

double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }

}  // namespace

struct JobRunner::Job {
  int id = 0;
  JobLane lane = JobLane::person;
  std::string title;
  std::function<void(const Progress&)> work;
  std::function<JobVerdict()> deliver;
  std::atomic<bool> cancelled{false};
  // Below: guarded by the runner's mutex.
  ui::JobView::State state = ui::JobView::State::waiting;
  bool finished = false;   ///< the worker is through with it
  bool delivered = false;
  double fraction = 0.0;
  std::string stage;
  std::string problem;
  std::string outcome;
  Clock::time_point started, ended;
};

JobRunner::JobRunner() {
  for (std::size_t lane = 0; lane < job_lane_count; ++lane) threads_[lane] = std::thread([this, lane] { work_on(lane); });
}

JobRunner::~JobRunner() {
  cancel_all();
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  wake_worker_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

int JobRunner::enqueue(std::string title, JobLane lane, std::function<void(const Progress&)> run, std::function<JobVerdict()> deliver) {
  auto job = std::make_shared<Job>();
  job->lane = lane;
  job->title = std::move(title);
  job->work = std::move(run);
  job->deliver = std::move(deliver);
  {
    const std::lock_guard lock(mutex_);
    job->id = next_id_++;
    waiting_[static_cast<std::size_t>(lane)].push_back(job);
    all_.push_back(job);
    const auto finished = [](const auto& j) { return j->delivered; };
    if (all_.size() > jobs_kept && finished(all_.front())) all_.erase(all_.begin());
  }
  wake_worker_.notify_all();
  return job->id;
}

void JobRunner::work_on(std::size_t lane) {
  while (true) {
    std::shared_ptr<Job> job;
    {
      std::unique_lock lock(mutex_);
      wake_worker_.wait(lock, [&] { return stopping_ || !waiting_[lane].empty(); });
      if (stopping_) return;
      job = waiting_[lane].front();
      waiting_[lane].pop_front();
      job->state = ui::JobView::State::running;
      job->started = Clock::now();
    }
    run(*job);
    announce();
  }
}

void JobRunner::run(Job& job) {
  const Progress progress(
      [this, &job](double fraction, const std::string& text) {
        {
          const std::lock_guard lock(mutex_);
          job.fraction = fraction;
          job.stage = text;
        }
        announce();
      },
      &job.cancelled);
  ui::JobView::State end = ui::JobView::State::done;
  std::string problem;
  try {
    progress.check();
    job.work(progress);
  } catch (const Cancelled&) {
    end = ui::JobView::State::cancelled;
  } catch (const std::bad_alloc&) {
    end = ui::JobView::State::failed;
    problem = "There is not enough memory for this.";
  } catch (const std::exception& e) {
    end = ui::JobView::State::failed;
    problem = std::string("Something went wrong inside Stemwise: ") + e.what();
  }
  job.work = nullptr;  // what it held goes here, not on the thread that draws
  const std::lock_guard lock(mutex_);
  job.state = end;
  job.problem = std::move(problem);
  job.ended = Clock::now();
  job.finished = true;
}

void JobRunner::announce() {
  std::function<void()> wake;
  {
    const std::lock_guard lock(mutex_);
    ++news_count_;
    wake = wake_;
  }
  news_.notify_all();
  if (wake) wake();
}

bool JobRunner::poll() {
  std::vector<std::shared_ptr<Job>> ready;
  {
    const std::lock_guard lock(mutex_);
    news_seen_ = news_count_;
    for (const auto& job : all_) {
      if (job->finished && !job->delivered) ready.push_back(job);
    }
  }
  for (const auto& job : ready) deliver(*job);
  const std::lock_guard lock(mutex_);
  std::erase_if(all_, [](const auto& job) { return job->delivered && job->lane != JobLane::person; });
  return !ready.empty();
}

void JobRunner::deliver(Job& job) {
  JobVerdict verdict{false, job.problem};
  if (job.state == ui::JobView::State::done) verdict = job.deliver();
  const std::lock_guard lock(mutex_);
  job.delivered = true;
  job.outcome = verdict.sentence;
  if (job.state == ui::JobView::State::done && !verdict.good) job.state = ui::JobView::State::failed;
  // Values are let go here, not when the list of jobs forgets it.
  job.deliver = nullptr;
}

void JobRunner::cancel(int id) {
  const std::lock_guard lock(mutex_);
  for (const auto& job : all_) {
    if (job->id == id) job->cancelled = true;
  }
}

void JobRunner::cancel_all() {
  const std::lock_guard lock(mutex_);
  for (const auto& job : all_) job->cancelled = true;
}

void JobRunner::forget_finished() {
  const std::lock_guard lock(mutex_);
  std::erase_if(all_, [](const auto& job) { return job->delivered; });
}

std::vector<ui::JobView> JobRunner::views() const {
  const std::lock_guard lock(mutex_);
  const auto now = Clock::now();
  std::vector<ui::JobView> out;
  for (auto it = all_.rbegin(); it != all_.rend(); ++it) {
    const Job& job = **it;
    if (job.lane != JobLane::person) continue;
    ui::JobView view{job.id, job.title, job.stage, job.fraction, 0.0, std::nullopt, job.state, job.outcome};
    if (job.state != ui::JobView::State::waiting) view.elapsed_s = seconds((job.finished ? job.ended : now) - job.started);
    const bool running = job.state == ui::JobView::State::running;
    // A guess from the share that is done; too early it would only mislead.
    if (running && job.fraction > 0.05 && view.elapsed_s > 1.0) view.left_s = view.elapsed_s * (1.0 - job.fraction) / job.fraction;
    out.push_back(std::move(view));
  }
  return out;
}

bool JobRunner::is_busy(JobLane lane) const {
  const std::lock_guard lock(mutex_);
  return std::any_of(all_.begin(), all_.end(), [&](const auto& job) { return job->lane == lane && !job->delivered; });
}

bool JobRunner::is_busy() const {
  const std::lock_guard lock(mutex_);
  return std::any_of(all_.begin(), all_.end(), [](const auto& job) { return !job->delivered; });
}

void JobRunner::wait_for_news() {
  std::unique_lock lock(mutex_);
  const auto idle = [&] { return std::all_of(all_.begin(), all_.end(), [](const auto& job) { return job->delivered; }); };
  news_.wait(lock, [&] { return news_count_ != news_seen_ || idle(); });
}

void JobRunner::on_news(std::function<void()> wake) {
  const std::lock_guard lock(mutex_);
  wake_ = std::move(wake);
}

}  // namespace stemwise
