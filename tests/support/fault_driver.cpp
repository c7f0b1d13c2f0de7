// SPDX-License-Identifier: MIT
#include "support/fault_driver.h"

#include <string_view>

namespace franken::test {
namespace {

constexpr GLenum kContextLost = 0x0507;

struct Driver {
    Gl real;
    Fault fault = Fault::None;
    std::size_t at = 0, calls = 0;
    bool owesError = false;

    /// Counts a call; whether it must fail.
    bool fails(std::string_view name) {
        const std::size_t number = calls++;
        switch (fault) {
        case Fault::None:
            return false;
        case Fault::OneCall:
            owesError = owesError || number == at;
            return number == at;
        case Fault::NoNames:
            return number >= at && (name.starts_with("Gen") || name.starts_with("Create")) &&
                   name != "GenerateMipmap";
        case Fault::Dies:
        case Fault::DiesLoudly:
        case Fault::EndlessErrors:
            return number >= at;
        }
        return false;
    }

    GLenum error() {
        if (owesError) {
            owesError = false;
            return GL_OUT_OF_MEMORY;
        }
        return fault == Fault::DiesLoudly      ? kContextLost
               : fault == Fault::EndlessErrors ? GL_INVALID_OPERATION
                                               : 0;
    }
};

Driver driver; // GL's functions carry no context of ours.

template<auto Member>
struct Faulty;

template<typename Return, typename... Arguments, Return (GL_APIENTRY* Gl::*Member)(Arguments...)>
struct Faulty<Member> {
    static inline const char* name = nullptr;
    static Return GL_APIENTRY call(Arguments... arguments) {
        return driver.fails(name) ? Return() : (driver.real.*Member)(arguments...);
    }
};

GLenum GL_APIENTRY getError() {
    const bool fails = driver.fails("GetError");
    return fails || driver.owesError ? driver.error() : driver.real.GetError();
}

} // namespace

Gl faultyDriver(const Gl& real, Fault fault, std::size_t at) {
    driver = {real, fault, at, 0, false};
    Gl table;
#define FRANKEN_FAULTY(function)                                                                             \
    Faulty<& Gl::function>::name = #function;                                                                \
    table.function = Faulty<&Gl::function>::call;
    FRANKEN_GL_FUNCTIONS(FRANKEN_FAULTY)
#undef FRANKEN_FAULTY
    table.GetError = getError;
    return table;
}

std::size_t callsOfFaultyDriver() { return driver.calls; }

} // namespace franken::test
