// What the corpus says of itself: the manifest that the validator's run is compared with, and the
// table of files that a loader and the validator may rightly disagree about.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "corpus/case.h"

namespace hm::corpus {

std::string manifest(const std::vector<Case>& valid, const std::vector<Case>& broken);

// docs/gltf-disagreements.md.
std::string disagreements(const std::vector<Case>& broken);

// The files of all cases into a folder, which is created. False where one can't be written.
bool write_files(const std::vector<Case>& cases, const std::filesystem::path& folder);
bool write_file(const std::filesystem::path& path, const std::string& content);

}  // namespace hm::corpus
