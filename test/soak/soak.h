#pragma once

#include "contract.h"
#include "process_use.h"

#include <cstdlib>
#include <iostream>
#include <string>
#include <thread>

namespace pcl::acmap::test {

/** \brief Number of rounds: ACMAP_SOAK_ROUNDS of the environment, or 20. */
inline unsigned
soakRounds()
{
  const char* wanted = std::getenv("ACMAP_SOAK_ROUNDS");
  return wanted ? static_cast<unsigned>(std::stoul(wanted)) : 20;
}

/** \brief Runs a class many times in this process, with a permanent object and
 * temporary ones, and compares the resources at the end with those after the first
 * rounds. A round is a run, a cancelled run, a run without input, and a rejected call.
 * \a Traits as in \ref ClassContract, but with `setInput (Class&, unsigned round)`. */
template <typename Traits>
class Soak {
public:
  /** \param[in] what prefix of the printed figures */
  void
  check(const std::string& what)
  {
    // One round for each kind of clouds, to fill caches and start threads.
    for (unsigned round = 0; round < 24; ++round)
      turn(round);
    const ProcessUse before = useAfterTheSameRounds();
    const unsigned rounds = soakRounds();
    made_ = 0;
    for (unsigned round = 0; round < rounds; ++round)
      turn(24 + round);
    EXPECT_GE(made_, rounds / 2) << "most rounds should have a result";
    const ProcessUse growth = useAfterTheSameRounds() - before;
    std::cout << what << ", " << rounds << " rounds: " << growth << std::endl;
    EXPECT_LE(growth.allocated, 16 << 10);
    EXPECT_LE(growth.resident, 4 << 20);
    EXPECT_LE(growth.files, 0);
    // Workers are started when they are first needed.
    EXPECT_LE(growth.threads, std::thread::hardware_concurrency());
  }

private:
  using Class = typename Traits::Class;
  using Output = typename Traits::Output;

  /** Runs the same rounds again, so that permanent objects and thread caches have the
   * same content. */
  ProcessUse
  useAfterTheSameRounds()
  {
    turn(0);
    turn(1);
    return currentUse();
  }

  void
  turn(unsigned round)
  {
    Class fresh;
    Class& object = round % 2 == 0 ? fresh : lasting_;
    object.setNumberOfThreads(1 + round % 3);
    Traits::setInput(object, round);
    Output output;
    Traits::run(object, output);
    made_ += Traits::isEmpty(output) ? 0 : 1;
    cancel(object, static_cast<int>(round % 5));
    refuse(round);
  }

  static void
  cancel(Class& object, int allowed_calls)
  {
    int calls = 0;
    object.setProgressCallback(
        [&](double, const std::string&) { return calls++ < allowed_calls; });
    try {
      Output output;
      Traits::run(object, output);
    }
    catch (const CancelledException&) {
      EXPECT_EQ(calls, allowed_calls + 1);
    }
    object.setProgressCallback({});
  }

  static void
  refuse(unsigned round)
  {
    Class object;
    Output output;
    EXPECT_THROW(Traits::run(object, output), InitFailedException);
    const auto calls = Traits::refusedCalls();
    EXPECT_THROW(calls[round % calls.size()].call(object), BadArgumentException);
  }

  Class lasting_;
  unsigned made_ = 0;
};

} // namespace pcl::acmap::test
