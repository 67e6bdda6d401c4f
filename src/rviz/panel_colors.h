// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>

namespace smore {

// Colours that the colour-blind tell apart, after Okabe and Ito (Color universal design, 2008).
// Each comes with a word, too.
const QColor kRightColor(0, 114, 178);     ///< all is well: blue
const QColor kDoubtColor(230, 159, 0);     ///< look at it: orange
const QColor kWrongColor(213, 94, 0);      ///< it is wrong: vermillion
const QColor kSilentColor(120, 120, 120);  ///< nothing is known: grey

}  // namespace smore
