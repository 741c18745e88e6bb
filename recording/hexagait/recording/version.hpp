// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace hexagait::recording {

extern const char* const kVersion;         ///< of the project, such as "0.1.0"
extern const char* const kRevision;        ///< git describe of the tree when this was built
extern const char* const kCompiler;        ///< name and version
extern const char* const kYamlCppVersion;  ///< that was compiled against

}  // namespace hexagait::recording
