// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <future>
#include <vector>

#include "smore/ros/latest_job.h"

namespace smore {
namespace {

TEST(LatestJob, DoesOfThoseThatWaitTheNewest) {
  std::promise<void> begun, release, done;
  std::vector<int> did;
  LatestJob jobs;
  jobs.give([&, released = release.get_future().share()] {
    begun.set_value();
    released.wait();
    did.push_back(0);
  });
  begun.get_future().wait();
  for (const int i : {1, 2}) {
    jobs.give([&did, i] { did.push_back(i); });
  }
  jobs.give([&] {
    did.push_back(3);
    done.set_value();
  });
  release.set_value();
  done.get_future().wait();
  EXPECT_EQ(did, (std::vector<int>{0, 3}));
}

TEST(LatestJob, BeginsNoneOnceItHasEnded) {
  bool begun = false;
  LatestJob jobs;
  jobs.end();
  jobs.give([&] { begun = true; });
  jobs.end();
  EXPECT_FALSE(begun);
}

}  // namespace
}  // namespace smore
