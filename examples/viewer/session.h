// SPDX-License-Identifier: MIT
#pragma once

#include "file_times.h"
#include "franken/orbit_camera.h"
#include "studio.h"

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

    /// Writes the manifest of the picture to stdout.
    std::optional<Failure> printPermutations();

    /// Writes what is in the model's file to stdout.
    std::optional<Failure> printList();

    /// Writes what the options' pixel shows to stdout.
    std::optional<Failure> printPick();

    /// Draws what the files hold now, and replaces the picture in one step: where anything fails, the last
    /// good one is still there. The sky is read again where its files have changed.
    std::optional<Failure> draw();

    /// Adds to the options' manifest, if there is one, what the pictures needed and it has not.
    std::optional<Failure> keepManifest();

private:
    /// Those that pictures are drawn with.
    const franken::SnippetSet& snippets() const {
        return m_snippets ? *m_snippets : franken::SnippetSet::builtIn();
    }

    std::optional<Failure> readSnippets();
    std::optional<Failure> readManifest();
    std::optional<Failure> readSky();
    std::optional<Failure> readModel(Subject& subject);
    std::optional<Failure> readSubject(Subject& subject);
    /// Writes the picture of that number, or puts it into the strip, which is written when it is whole.
    std::optional<Failure> keep(const franken::Image& picture, int number);
    std::optional<Failure> drawFrames(Subject& subject);
    std::optional<Failure> drawTurned(Subject& subject, franken::OrbitCamera& orbit);
    /// Prints what the subject costs on the options' Raspberry Pi.
    std::optional<Failure> printPrice(const Subject& subject);
    franken::Result<Drawn> drawVisibly(Subject& subject);
    franken::Result<Drawn> drawSubject(const Subject& subject);

    const Options& m_options;
    franken::Log m_log;
    std::optional<franken::SnippetSet> m_snippets;  ///< Other ones than the built-in, or with an effect.
    std::shared_ptr<const franken::BakedSky> m_sky; ///< The last good one.
    FileTimes m_skyTimes;                           ///< When it was read.
    std::optional<std::vector<franken::ProgramUse>> m_listed; ///< In the manifest, once it was read.
    std::vector<franken::ProgramUse> m_needed;                ///< By all pictures, each once.
    std::unique_ptr<Studio> m_studio;                         ///< From the first picture on.
    franken::Image m_strip; ///< As far as it has come; empty where none is asked for.
};
