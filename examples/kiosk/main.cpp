// SPDX-License-Identifier: MIT
#include "franken/file_writer.h"
#include "franken/printable.h"
#include "kiosk/command_line.h"
#include "kiosk/config/example.h"
#include "kiosk/doctor/examine.h"
#include "kiosk/frame_command.h"
#include "kiosk/report/journal.h"

#include <iostream>

namespace kiosk {

namespace {

/// Reports faults; whether there were none.
bool report(const std::vector<franken::Error>& faults) {
    for (const franken::Error& fault : faults)
        std::cerr << franken::printable(fault) << "\n";
    return faults.empty();
}

ExitCode exitCodeOf(const franken::Result<void>& ended, const franken::Log& log) {
    if (ended)
        return ExitCode::Ok;
    log(franken::LogLevel::Error, franken::toString(ended.error()));
    return ExitCode::Device;
}

std::optional<Config> goodConfigOf(const RunOptions& options) {
    ReadConfig read = configOf(options);
    return report(read.faults) ? std::optional(std::move(read.config)) : std::nullopt;
}

ExitCode examine(const Examine& command) {
    const ReadConfig read = readConfig(command.config);
    const Patient patient{Machine(command.root), read.config, command.root == "/"};
    Findings findings = examineAll(patient);
    for (const franken::Error& fault : read.faults)
        findings.push_back({Finding::Kind::Bad, "configuration", franken::toString(fault),
                            "kiosk check " + command.config.string()});
    std::cout << (command.json ? toJson(findings) : toText(findings));
    if (!command.report.empty())
        if (const auto written = franken::writeFile(command.report, reportOf(patient, findings)); !written) {
            report({written.error()});
            return ExitCode::Device;
        }
    return isHealthy(findings) ? ExitCode::Ok : ExitCode::Unhealthy;
}

struct Execute {
    ExitCode operator()(ExitCode code) const { return code; }

    ExitCode operator()(const Run& command) const {
        const std::optional<Config> config = goodConfigOf(command.options);
        if (!config)
            return ExitCode::Refused;
        const franken::Log log = journal();
        const auto kiosk = Kiosk::open(command.options, *config, log);
        return exitCodeOf(kiosk ? (*kiosk)->run() : kiosk.error(), log);
    }

    ExitCode operator()(const DrawFrame& command) const {
        const std::optional<Config> config = goodConfigOf(command.options);
        if (!config)
            return ExitCode::Refused;
        return exitCodeOf(drawFrame(command, *config, journal()), journal());
    }

    ExitCode operator()(const CheckFile& command) const {
        if (!report(readConfig(command.file).faults))
            return ExitCode::Refused;
        std::cout << command.file.string() << " is good\n";
        return ExitCode::Ok;
    }

    ExitCode operator()(const PrintSettings&) const {
        std::cout << exampleConfig();
        return ExitCode::Ok;
    }

    ExitCode operator()(const Examine& command) const { return examine(command); }
};

} // namespace

} // namespace kiosk

int main(int count, char** arguments) {
    return static_cast<int>(std::visit(kiosk::Execute{}, kiosk::parseCommandLine(count, arguments)));
}
