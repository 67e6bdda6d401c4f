// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/contact/contact_sensing.h"

namespace smore {

/// The same parameters with as many samples at least in every window as the sensor's noise asks
/// for; without noise they stay as they are. With q(p) the quantile of Maxwell's distribution a
/// window that may err by e holds (q(p) sigma / e)^2 samples:
///
/// | window  | may err by                    | with probability                             |
/// |---------|-------------------------------|----------------------------------------------|
/// | fast    | contact_force - free_force    | that of one false contact in an hour at rest |
/// | release | contact_force - release_force | that of one false release in an hour         |
/// | slow    | free_force                    | 1 %: free space that goes unnoticed          |
///
/// The fast window leaves free_force for what the bias may be off. A line is averaged over as many
/// samples as the slow window: its mean force is then as good as the one that free space is told
/// by. The tare may take ten times as many, so that its error adds little to theirs. A low-pass of
/// the sensor has settled before a line's average begins.
ContactSensingParameters allowForNoise(const ContactSensingParameters& parameters);

}  // namespace smore
