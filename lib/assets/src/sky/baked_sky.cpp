// SPDX-License-Identifier: MIT
#include "franken/baked_sky.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <fstream>
#include <string_view>

#include "sky/sky.h"

namespace franken {
namespace {

constexpr std::string_view kMagic = "FRANKSKY";
constexpr std::uint32_t kVersion = 3;
constexpr float kLargest = 1e12f; ///< Of any number in it: sums and products of a few stay finite.

class Writer {
public:
    void number(std::uint32_t value) {
        for (int byte = 0; byte < 4; ++byte)
            m_bytes.push_back(static_cast<std::uint8_t>(value >> (8 * byte)));
    }
    void real(float value) { number(std::bit_cast<std::uint32_t>(value)); }
    void reals(const Float3& values) {
        for (const float value : values)
            real(value);
    }
    template<typename Bytes>
    void append(const Bytes& bytes) {
        m_bytes.insert(m_bytes.end(), bytes.begin(), bytes.end());
    }
    std::vector<std::uint8_t> take() { return std::move(m_bytes); }

private:
    std::vector<std::uint8_t> m_bytes;
};

/// Reads from front to back. What lies behind the end, or is no sensible number, makes it broken.
class Reader {
public:
    explicit Reader(std::span<const std::uint8_t> bytes) : m_rest(bytes) {}

    std::uint32_t number(std::uint32_t least, std::uint32_t most) {
        const auto bytes = take(4);
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < bytes.size(); ++i)
            value |= std::uint32_t{bytes[i]} << (8 * i);
        m_broken = m_broken || value < least || value > most;
        return m_broken ? least : value;
    }

    float real(float least) {
        const float value = std::bit_cast<float>(number(0, UINT32_MAX));
        m_broken = m_broken || !(value >= least && value <= kLargest);
        return m_broken ? 0 : value;
    }

    Float3 reals(float least) { return {real(least), real(least), real(least)}; }

    Image image(std::uint32_t width, std::uint32_t height) {
        const auto bytes = take(std::size_t{4} * width * height);
        return {"", static_cast<int>(width), static_cast<int>(height), {bytes.begin(), bytes.end()}};
    }

    std::span<const std::uint8_t> take(std::size_t count) {
        m_broken = m_broken || count > m_rest.size();
        if (m_broken)
            return {};
        const auto taken = m_rest.first(count);
        m_rest = m_rest.subspan(count);
        return taken;
    }

    bool broken() const { return m_broken; }
    bool atEnd() const { return m_rest.empty(); }

private:
    std::span<const std::uint8_t> m_rest;
    bool m_broken = false;
};

bool isBaked(std::span<const std::uint8_t> bytes) {
    return bytes.size() >= kMagic.size() && std::equal(kMagic.begin(), kMagic.end(), bytes.begin());
}

void writeSun(Writer& writer, const std::optional<Sun>& sun) {
    const Sun none{.direction = {}, .color = {}};
    writer.number(sun ? 1 : 0);
    writer.reals(sun.value_or(none).direction);
    writer.reals(sun.value_or(none).color);
    writer.real(sun.value_or(none).illuminance);
}

std::optional<Sun> readSun(Reader& reader) {
    const bool shines = reader.number(0, 1) != 0;
    const Float3 direction = reader.reals(-kLargest), color = reader.reals(0);
    const float illuminance = reader.real(0);
    const bool aims = std::any_of(direction.begin(), direction.end(), [](float x) { return x != 0; });
    if (!shines || !aims)
        return std::nullopt;
    return Sun{.direction = direction, .color = color, .illuminance = illuminance, .ofSky = true};
}

Error broken(std::string what) { return {"sky.baked", "", std::move(what), "bake the sky again"}; }

} // namespace

// Opening a pipe would wait for its writer.
bool isBakedSky(const std::filesystem::path& path) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored))
        return false;
    std::array<std::uint8_t, kMagic.size()> head{};
    std::ifstream(path, std::ios::binary).read(reinterpret_cast<char*>(head.data()), head.size());
    return isBaked(head);
}

BakedSky bakeSky(Environment sky, const BakeOptions& options) {
    assert(options.skyboxSize >= 0 && options.skyboxSize <= kMaxSkyWidth / 4);
    BakedSky baked;
    if (options.sun)
        baked.sun = takeSun(sky);
    baked.coefficients = skyCoefficients(sky);
    if (options.skyboxSize > 0)
        baked.skybox = encodeSkybox(sky, options.skyboxSize);
    baked.reflection = {filterReflection(sky, options.reflectionSize, options.progress), reflectionLookup()};
    return baked;
}

std::vector<std::uint8_t> encodeBakedSky(const BakedSky& sky) {
    Writer writer;
    writer.append(kMagic);
    writer.number(kVersion);
    for (const Float3& coefficient : sky.coefficients)
        writer.reals(coefficient);
    writeSun(writer, sky.sun);
    writer.number(static_cast<std::uint32_t>(sky.skybox.size));
    writer.real(sky.skybox.range);
    writer.number(static_cast<std::uint32_t>(sky.reflection.atlas.image.width / 2));
    writer.real(sky.reflection.atlas.range);
    for (const Image& face : sky.skybox.images)
        writer.append(face.rgba);
    writer.append(sky.reflection.atlas.image.rgba);
    writer.append(sky.reflection.lookup.rgba);
    return writer.take();
}

Result<BakedSky> decodeBakedSky(std::span<const std::uint8_t> bytes) {
    if (!isBaked(bytes))
        return broken("this is no baked sky: it does not start with FRANKSKY");
    Reader reader(bytes.subspan(kMagic.size()));
    if (reader.number(0, UINT32_MAX) != kVersion)
        return broken("the file is of another version than " + std::to_string(kVersion));
    BakedSky sky;
    for (Float3& coefficient : sky.coefficients)
        coefficient = reader.reals(-kLargest);
    sky.sun = readSun(reader);
    const std::uint32_t face = reader.number(0, kMaxSkyWidth / 4);
    sky.skybox.size = static_cast<int>(face);
    sky.skybox.range = reader.real(0);
    const std::uint32_t size = reader.number(kMinReflectionSize, kMaxReflectionSize);
    sky.reflection.atlas.range = reader.real(0);
    if (reader.broken())
        return broken("a number in the head of the file is out of range, or the head is cut short");
    for (Image& image : sky.skybox.images)
        image = reader.image(face, face);
    const int height = reflectionHeight(static_cast<int>(size));
    sky.reflection.atlas.image = reader.image(2 * size, static_cast<std::uint32_t>(height));
    sky.reflection.lookup = reader.image(kLookupWidth, kLookupHeight);
    if (reader.broken() || !reader.atEnd())
        return broken("the file is not as long as its sizes say");
    return sky;
}

Result<BakedSky> loadSky(const std::filesystem::path& path, const BakeOptions& options) {
    if (!isBakedSky(path))
        return loadEnvironment(path, options.limits).transform([&options](Environment sky) {
            return bakeSky(std::move(sky), options);
        });
    const auto bytes = readSkyFile(path, options.limits.maxFileBytes);
    if (!bytes)
        return bytes.error();
    Result<BakedSky> sky = decodeBakedSky(*bytes);
    if (sky)
        return sky;
    Error error = sky.error();
    error.where = path.string();
    return error;
}

} // namespace franken
