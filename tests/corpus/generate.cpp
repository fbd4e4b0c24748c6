// generate_corpus FOLDER [TABLE]: writes the corpus of broken glTF files and its manifest.json into
// a folder, and the table of disagreements into a file.
#include <cstdio>
#include <exception>

#include "corpus/report.h"
#include "corpus/rules.h"

namespace hm::corpus {
namespace {

bool generate(const std::filesystem::path& folder, const char* table) {
    const std::vector<Case> valid = base_cases();
    const std::vector<Case> broken = all_cases();
    if (!write_files(valid, folder) || !write_files(broken, folder)) return false;
    if (!write_file(folder / "manifest.json", manifest(valid, broken))) return false;
    std::printf("%zu broken files, %zu valid ones\n", broken.size(), valid.size());
    return table == nullptr || write_file(table, disagreements(broken));
}

}  // namespace
}  // namespace hm::corpus

int main(int argc, char** argv) {
    if (argc != 2 && argc != 3) {
        std::fprintf(stderr, "usage: generate_corpus FOLDER [TABLE]\n");
        return 2;
    }
    try {
        if (hm::corpus::generate(argv[1], argc == 3 ? argv[2] : nullptr)) return 0;
        std::fprintf(stderr, "generate_corpus: can't write to %s\n", argv[1]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "generate_corpus: %s\n", error.what());
    }
    return 1;
}
