// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace smore {

/// How far a mean over the newest samples reaches back: to all that are not older than `duration`,
/// and to so many `samples` at least, however old they are. Time is what physics asks for (an
/// impact has to pass), a number of samples what noise asks for.
struct SampleWindow {
  double duration = 0.0;  ///< [s], not negative
  int samples = 1;        ///< at least 1
};

}  // namespace smore
