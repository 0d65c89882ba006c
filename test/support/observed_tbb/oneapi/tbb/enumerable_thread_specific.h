#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <thread>

namespace oneapi::tbb {

/** \brief One value per thread, created when the thread first requests it. */
template <typename Value>
class enumerable_thread_specific {
public:
  explicit enumerable_thread_specific(std::function<Value()> make)
  : make_(std::move(make))
  {}

  Value&
  local()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = values_.find(std::this_thread::get_id());
    return found != values_.end()
               ? found->second
               : values_.emplace(std::this_thread::get_id(), make_()).first->second;
  }

  /** \brief Calls use (value) for all values; no thread may request its value
   * meanwhile. */
  template <typename Use>
  void
  combine_each(const Use& use)
  {
    for (auto& [thread, value] : values_)
      use(value);
  }

private:
  std::function<Value()> make_;
  std::mutex mutex_;
  std::map<std::thread::id, Value> values_;
};

} // namespace oneapi::tbb
