// SPDX-License-Identifier: MIT
#pragma once

#include "picture.h"

/// An error, and what the shell is told of it.
struct Failure {
    franken::Error error;
    ExitCode code;
};

/// From the files that the options name to the picture, as often as asked.
class Session {
public:
    /// The options must outlive it.
    Session(const Options& options, franken::Log log) : m_options(options), m_log(std::move(log)) {}

    /// Writes the names of the programs that the picture needs to stdout, a name a line.
    std::optional<Failure> printPermutations();

    /// Draws what the files hold now, and replaces the picture in one step: where anything fails, the last
    /// good one is still there. The sky is read once.
    std::optional<Failure> draw();

private:
    std::optional<Failure> readSky();
    std::optional<Failure> readSubject(Subject& subject);

    const Options& m_options;
    franken::Log m_log;
    std::optional<franken::BakedSky> m_sky;
};
