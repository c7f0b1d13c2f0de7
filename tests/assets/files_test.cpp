// SPDX-License-Identifier: MIT
// Each file is loaded by a process of its own, which must neither crash nor be reported by a sanitizer, and
// be done within 2 seconds and 256 MiB.
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <set>

#include <sys/stat.h>

#include "malformed/malformed.h"
#include "malformed/pictures.h"
#include "support/shell.h"

namespace {

namespace fs = std::filesystem;

// Of processor time, so that a busy machine does not count. The limits are a promise for what users run.
// AddressSanitizer makes reading JSON byte by byte four times slower (1.3 s become 5 s), and its shadow takes
// a byte for each eight.
#ifdef __SANITIZE_ADDRESS__
constexpr double kMaxSeconds = 8;
constexpr long kMaxKiB = (256 << 10) / 8 * 9;
#else
constexpr double kMaxSeconds = 2;
constexpr long kMaxKiB = 256 << 10; ///< Resident at the peak.
#endif

/// What load_once says of a file.
struct Outcome {
    std::string code; ///< "ok", the error's code, or empty after a crash.
    int warnings = 0;
    long peakKiB = 0;
    double seconds = 0;
    std::string where;
    std::string error;
};

Outcome loadOnce(const fs::path& file) {
    // AddressSanitizer keeps what was freed, which is not what is measured here.
    const std::string command = "ASAN_OPTIONS=quarantine_size_mb=1 " + std::string(FRANKEN_LOAD_ONCE) + " '" +
                                file.string() + "' 2>&1";
    std::FILE* pipe = popen(command.c_str(), "r");
    if (!pipe)
        return {};
    std::string output;
    char buffer[4096];
    for (std::size_t count = 0; (count = fread(buffer, 1, sizeof buffer, pipe)) > 0;)
        output.append(buffer, count);
    Outcome outcome;
    if (pclose(pipe) != 0) {
        outcome.error = output;
        return outcome;
    }
    std::istringstream line(output);
    std::getline(line, outcome.code, '\t');
    line >> outcome.warnings >> outcome.peakKiB >> outcome.seconds;
    line.ignore();
    std::getline(line, outcome.where, '\t');
    std::getline(line, outcome.error);
    return outcome;
}

/// The worst of many outcomes.
class Tally {
public:
    explicit Tally(std::string what) : m_what(std::move(what)) {}
    ~Tally() {
        std::cout << m_what << ": " << m_count << " files, " << m_refused << " refused; at most "
                  << (m_peak >> 10) << " MiB (" << m_largest << ") and " << m_seconds << " s (" << m_slowest
                  << ")\n";
    }
    void add(const std::string& name, const Outcome& outcome) {
        EXPECT_FALSE(outcome.code.empty()) << name << " crashes: " << outcome.error;
        EXPECT_LE(outcome.seconds, kMaxSeconds) << name;
        EXPECT_LE(outcome.peakKiB, kMaxKiB) << name;
        ++m_count;
        m_refused += outcome.code != "ok";
        if (outcome.peakKiB > m_peak)
            m_peak = outcome.peakKiB, m_largest = name;
        if (outcome.seconds > m_seconds)
            m_seconds = outcome.seconds, m_slowest = name;
    }

private:
    std::string m_what, m_largest, m_slowest;
    int m_count = 0, m_refused = 0;
    long m_peak = 0;
    double m_seconds = 0;
};

/// The test's folder with a folder in it, removed at the end: some files are large.
class Folder {
public:
    Folder() { fs::create_directories(m_path / "folder"); }
    ~Folder() { fs::remove_all(m_path); }
    const fs::path& path() const { return m_path; }
    fs::path write(const std::string& name, const std::string& bytes) const {
        std::ofstream(m_path / name, std::ios::binary) << bytes;
        return m_path / name;
    }

private:
    const fs::path m_path = franken::test::emptyTestFolder();
};

void expectOutcomes(const std::string& group, const std::vector<MalformedFile>& files) {
    const Folder folder;
    Tally tally(group);
    for (const MalformedFile& file : files) {
        for (const auto& [name, bytes] : file.beside)
            folder.write(name, bytes);
        const Outcome outcome = loadOnce(folder.write("model." + file.extension, file.bytes));
        tally.add(file.name, outcome);
        EXPECT_EQ(outcome.code, file.code.empty() ? "ok" : file.code) << file.name << ": " << outcome.error;
        EXPECT_TRUE(outcome.where.ends_with(file.where)) << file.name << ": " << outcome.error;
        for (const auto& [name, bytes] : file.beside)
            fs::remove(folder.path() / name);
    }
}

fs::path shared() { return fs::path(FRANKEN_SOURCE_DIR).parent_path() / "shared" / "assets"; }

std::vector<fs::path> modelsBelow(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb")
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

TEST(MalformedFiles, SoundModelIsSound) {
    const Folder folder;
    for (const bool binary : {false, true}) {
        const Outcome outcome =
            loadOnce(folder.write(binary ? "model.glb" : "model.gltf", soundModel().bytes(binary)));
        EXPECT_EQ(outcome.code, "ok") << outcome.error;
        EXPECT_EQ(outcome.warnings, 0);
    }
}

TEST(MalformedFiles, AreAtLeast120OfDifferentNames) {
    std::set<std::string> names;
    for (const MalformedFile& file : malformedFiles())
        EXPECT_TRUE(names.insert(file.name).second) << file.name;
    EXPECT_GE(names.size(), 120u);
    std::cout << names.size() << " files\n";
}

TEST(MalformedFiles, Containers) { expectOutcomes("containers", malformedContainers()); }
TEST(MalformedFiles, Json) { expectOutcomes("json", malformedJson()); }
TEST(MalformedFiles, Schemas) { expectOutcomes("schemas", malformedSchemas()); }
TEST(MalformedFiles, Data) { expectOutcomes("data", malformedData()); }
TEST(MalformedFiles, Uris) { expectOutcomes("uris", malformedUris()); }
TEST(MalformedFiles, Greedy) { expectOutcomes("greedy", greedyFiles()); }
TEST(MalformedFiles, Skies) { expectOutcomes("skies", malformedSkies()); }

// A broken image is left out, with a warning. Where bits end inside a value, stb_image 2.27 takes zeros for
// the rest, and 2.30 refuses: both will do.
TEST(MalformedFiles, Images) {
    expectOutcomes("images", malformedImages());
    const Folder folder;
    for (const MalformedFile& file : malformedImages()) {
        const Outcome outcome = loadOnce(folder.write("model.glb", file.bytes));
        const bool isSound =
            file.name == "image/jpeg-of-100-scans" || file.name == "image/jpeg-huffman-tables-missing";
        const bool mayBeSound = isSound || file.name == "image/jpeg-bits-end-inside-a-value";
        EXPECT_GE(outcome.warnings, mayBeSound ? 0 : 1) << file.name << ", of the image";
        EXPECT_LE(outcome.warnings, isSound ? 0 : 1) << file.name;
    }
}

// What is no bytes: a name in the model's folder that leads elsewhere.
TEST(MalformedFiles, LinksAndPipes) {
    const Folder folder;
    Tally tally("links");
    const auto expect = [&](const std::string& name, const std::string& code) {
        GltfBuilder file;
        file.setTriangle();
        file.json["buffers"] = {{{"byteLength", 36}, {"uri", name}}};
        const Outcome outcome = loadOnce(folder.write("folder/model.gltf", file.bytes(false)));
        tally.add(name, outcome);
        EXPECT_EQ(outcome.code, code) << name << ": " << outcome.error;
    };
    const fs::path inside = folder.path() / "folder";
    folder.write("outside.bin", std::string(36, '\0'));
    folder.write("folder/real.bin", std::string(36, '\0'));
    fs::create_symlink("real.bin", inside / "link-inside");
    fs::create_symlink("../outside.bin", inside / "link-outside");
    fs::create_symlink(folder.path() / "outside.bin", inside / "link-absolute");
    fs::create_symlink("..", inside / "link-to-parent");
    fs::create_symlink("link-to-itself", inside / "link-to-itself");
    fs::create_symlink("/dev/zero", inside / "link-to-device");
    ASSERT_EQ(mkfifo((inside / "pipe").c_str(), 0600), 0);
    expect("link-inside", "ok");
    for (const char* name : {"link-outside", "link-absolute", "link-to-parent/outside.bin", "link-to-itself",
                             "link-to-device", "pipe"})
        expect(name, "gltf.buffer");
}

TEST(MalformedFiles, FacesOfSkies) {
    Tally tally("faces");
    const char* const names[]{"px", "nx", "py", "ny", "pz", "nz"};
    const auto expect = [&](const std::string& what, const std::string& code, const auto& change) {
        const Folder folder;
        fs::remove(folder.path() / "folder");
        for (const char* name : names)
            folder.write(std::string(name) + ".png", pictures::png(16, 16));
        change(folder);
        const Outcome outcome = loadOnce(folder.path());
        tally.add(what, outcome);
        EXPECT_EQ(outcome.code, code) << what << ": " << outcome.error;
    };
    expect("sound", "ok", [](const Folder&) {});
    expect("missing", "sky.shape", [](const Folder& folder) { fs::remove(folder.path() / "py.png"); });
    expect("twice", "sky.shape", [](const Folder& folder) { folder.write("px.jpg", ""); });
    expect("not-square", "sky.shape",
           [](const Folder& folder) { folder.write("nz.png", pictures::png(16, 8)); });
    expect("of-two-sizes", "sky.shape",
           [](const Folder& folder) { folder.write("nz.png", pictures::png(8, 8)); });
    expect("empty", "image.format", [](const Folder& folder) { folder.write("nz.png", ""); });
    expect("folder", "sky.file", [](const Folder& folder) {
        fs::remove(folder.path() / "nz.png");
        fs::create_directory(folder.path() / "nz.png");
    });
    expect("large", "sky.limit", [&](const Folder& folder) {
        for (const char* name : names)
            folder.write(std::string(name) + ".png", pictures::png(2048, 2048));
    });
}

TEST(FilesByOthers, InvalidOnesAreRefusedOrHarmless) {
    if (!fs::exists(shared() / "invalid"))
        GTEST_SKIP() << "no " << shared() / "invalid";
    Tally tally("invalid files by others");
    for (const fs::path& file : modelsBelow(shared() / "invalid")) {
        const Outcome outcome = loadOnce(file);
        tally.add(file.string(), outcome);
        EXPECT_TRUE(outcome.code == "ok" || outcome.code.starts_with("gltf.")) << outcome.error;
        EXPECT_TRUE(outcome.code == "ok" || outcome.where.starts_with(file.string())) << outcome.error;
    }
}

TEST(FilesByOthers, ValidOnesLoadOrNameTheExtension) {
    if (!fs::exists(shared() / "valid"))
        GTEST_SKIP() << "no " << shared() / "valid";
    Tally tally("valid files by others");
    for (const fs::path& file : modelsBelow(shared() / "valid")) {
        const Outcome outcome = loadOnce(file);
        tally.add(file.string(), outcome);
        const bool isNewer = outcome.code == "gltf.version" && outcome.where.ends_with("/asset/minVersion");
        EXPECT_TRUE(outcome.code == "ok" || outcome.code == "gltf.extension" || isNewer) << outcome.error;
    }
}

} // namespace
