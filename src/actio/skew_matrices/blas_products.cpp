#include "actio/skew_matrices/blas_products.hpp"

namespace actio::sphere {

PanelThreads::~PanelThreads() {
  {
    std::lock_guard const lock(mutex_);
    over_ = true;
  }
  wake_.notify_all();
  for (auto& thread : threads_) thread.join();
}

void PanelThreads::run(int count, std::function<void(int)> const& work) {
  {
    std::lock_guard const lock(mutex_);
    work_ = &work, count_ = count, next_ = 0, busy_ = static_cast<int>(threads_.size()), ++round_;
  }
  wake_.notify_all();
  for (int k; (k = next_++) < count;) work(k);
  std::unique_lock lock(mutex_);
  done_.wait(lock, [this] { return busy_ == 0; });
}

void PanelThreads::serve() {
  for (long seen = 0;;) {
    std::unique_lock lock(mutex_);
    wake_.wait(lock, [&] { return over_ || round_ != seen; });
    if (over_) return;
    seen = round_;
    auto const& work = *work_;
    int const count = count_;
    lock.unlock();
    for (int k; (k = next_++) < count;) work(k);
    lock.lock();
    if (--busy_ == 0) done_.notify_one();
  }
}

}  // namespace actio::sphere
