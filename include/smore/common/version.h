// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace smore {

/// Version of the package (package.xml), for files that outlive the program that wrote them.
const char* programVersion();

}  // namespace smore
