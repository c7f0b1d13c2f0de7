// SPDX-License-Identifier: MIT
// What the example programs say to a wrong command line: what was probably meant, in words that nothing can
// forge.
#include "support/shell.h"

namespace franken::test {
namespace {

class CommandLine : public testing::Test {
protected:
    Outcome run(const std::string& command) const { return runIn(m_folder, "timeout 20 " + command); }

    const std::filesystem::path m_folder = emptyTestFolder();
};

struct Mistake {
    const char *command, *says;
};

TEST_F(CommandLine, OffersWhatWasProbablyMeant) {
    for (const auto& [command, says] : {
             Mistake{VIEWER " m.gltf --sieze 3x3", "'--sieze' is no option (did you mean '--size'?)"},
             {VIEWER " --hepl", "did you mean '--help'?"},
             {VIEWER " --verison", "did you mean '--version'?"},
             {VIEWER " m.gltf --skybx=a.hdr", "did you mean '--skybox'?"},
             {VIEWER " m.gltf -O x.png", "did you mean '-o'?"},
             {VIEWER " m.gltf -x", "'-x' is no option (see 'viewer --help')"},
             {VIEWER " m.gltf n.gltf", "'n.gltf' is one argument too many for 'viewer'"},
             {VIEWER " m.gltf --tone-map acse", "did you mean 'aces'?"},
             {VIEWER " m.gltf --backend osmeas", "did you mean 'osmesa'?"},
             {VIEWER " m.gltf --output sgrb", "did you mean 'srgb'?"},
             {VIEWER " m.gltf --memory -1", "'-1' is not a whole number from 1 to 4095"},
             {VIEWER " m.gltf --turntable 1e3", "'1e3' is not a whole number"},
             {VIEWER " m.gltf -o ''", "--output-file: the name is empty"},
             {VIEWER " m.gltf --skybox ''", "--skybox: the name is empty"},
             {VIEWER " ''", "MODEL: the name is empty"},
             {VIEWER, "MODEL is required (see 'viewer --help')"},
             {BAKE " m.hdr --sum", "'--sum' is no option (did you mean '--sun'?)"},
             {BAKE " --verison", "did you mean '--version'?"},
             {BAKE " m.hdr --reflection-sise 64", "did you mean '--reflection-size'?"},
             {BAKE " m.hdr --skybox-size 9999", "'9999' is not a whole number from 0 to 2048"},
             {BAKE " m.hdr n.hdr", "'n.hdr' is one argument too many for 'bake'"},
             {BAKE " m.hdr -o ''", "--output-file: the name is empty"},
         }) {
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.code, 2) << command << outcome.err;
        EXPECT_NE(outcome.err.find(says), std::string::npos) << command << '\n' << outcome.err;
        EXPECT_EQ(outcome.out, "") << command;
    }
    EXPECT_NE(run(VIEWER " -V").out.find("viewer 0."), std::string::npos);
    EXPECT_NE(run(BAKE " --version").out.find("bake 0."), std::string::npos);
}

TEST_F(CommandLine, NothingSteersTheTerminal) {
    const std::string steering = "'a\x1b[31m\xc2\x9b\xe2\x80\xae\xe2\x80\x8b\xff\r\nviewer: error: forged'";
    for (const std::string& command : std::vector<std::string>{
             VIEWER " " + steering, VIEWER " m.gltf " + steering, VIEWER " m.gltf --" + steering,
             VIEWER " m.gltf --size " + steering, VIEWER " m.gltf --tone-map " + steering,
             VIEWER " m.gltf --sun " + steering, VIEWER " m.gltf --memory " + steering,
             VIEWER " m.gltf --skybox " + steering, VIEWER " m.gltf --effect " + steering,
             BAKE " " + steering, BAKE " m.hdr --" + steering, BAKE " m.hdr --skybox-size " + steering,
             BAKE " m.hdr " + steering, MAKE_MODEL " no/" + steering + ".glb"}) {
        const Outcome outcome = run(command);
        EXPECT_NE(outcome.code, 0) << command;
        for (const char* bad :
             {"\x1b", "\xc2\x9b", "\xe2\x80\xae", "\xe2\x80\x8b", "\xff", "\r", "\nviewer: error: forged"})
            EXPECT_EQ(outcome.err.find(bad), std::string::npos) << command << '\n' << outcome.err;
    }
}

} // namespace
} // namespace franken::test
