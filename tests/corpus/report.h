// Reports about the corpus: the manifest that the validator's results are compared with, and the
// table of files on which a loader and the validator may legitimately disagree.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "corpus/case.h"

namespace hm::corpus {

std::string manifest(const std::vector<Case>& valid, const std::vector<Case>& broken);

// The content of docs/gltf-disagreements.md.
std::string disagreements(const std::vector<Case>& broken);

// Writes the files of all cases into a folder, which is created. False if one can't be written.
bool write_files(const std::vector<Case>& cases, const std::filesystem::path& folder);
bool write_file(const std::filesystem::path& path, const std::string& content);

}  // namespace hm::corpus
