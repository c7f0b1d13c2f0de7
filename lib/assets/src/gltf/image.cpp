// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>

#include "gltf/accessor.h"
#include "gltf/material.h"
#include "helper_threads.h"
#include "image/image_header.h"

namespace franken::gltf {
namespace {

// Decoding is most of the time that a load takes, and each image is alone: one worker for each core, as far
// as the memory goes that one of them takes.
void decodeAll(const std::vector<std::span<const std::uint8_t>>& encoded, int maxSize, std::size_t maxWorkers,
               std::vector<std::optional<Result<Image>>>& results) {
    std::atomic<std::size_t> next = 0;
    const std::function<void()> work = [&] {
        for (std::size_t i = next++; i < encoded.size(); i = next++)
            results[i] = decodeImage(encoded[i], maxSize);
    };
    const auto helpers = startHelpers(std::min(encoded.size(), maxWorkers), work);
    work();
}

// The pixels stay. What decoding takes besides is there once for each worker, and `largest` of them all.
bool chargePixels(Document& source, std::span<const std::uint8_t> encoded, const std::string& where,
                  std::size_t& largest) {
    const Result<ImageHeader> header = readImageHeader(encoded, source.options.maxImageSize);
    if (!header)
        return true; // and decoding says why
    largest = std::max(largest, header->decodingBytes);
    return source.charge(1, header->pixelBytes(), where);
}

} // namespace

bool readImages(Document& source, const std::vector<bool>& used, std::vector<bool>& broken,
                std::vector<Image>& images) {
    std::vector<std::size_t> which;
    std::vector<std::span<const std::uint8_t>> encoded;
    std::size_t largest = 1;
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (!used[i])
            continue;
        if (!source.need(pathOf("images", i)))
            return false;
        which.push_back(i);
        const EncodedImage& image = source.images[i];
        encoded.push_back(image.view == kNone ? std::span<const std::uint8_t>(image.bytes)
                                              : viewBytes(source, image.view));
        if (source.error || !chargePixels(source, encoded.back(), pathOf("images", i), largest))
            return false;
    }
    const std::size_t maxWorkers = source.room() / largest;
    if (!source.charge(1, largest, "/images"))
        return false;
    std::vector<std::optional<Result<Image>>> results(which.size());
    decodeAll(encoded, source.options.maxImageSize, maxWorkers, results);

    images.assign(used.size(), Image{"", 1, 1, {255, 255, 255, 255}});
    broken.assign(used.size(), false);
    for (std::size_t i = 0; i < which.size(); ++i) {
        const EncodedImage& image = source.images[which[i]];
        if (*results[i]) {
            images[which[i]] = std::move(**results[i]);
            continue;
        }
        broken[which[i]] = true;
        source.warn(kLeftOut, pathOf("images", which[i]),
                    (image.problem.empty() ? toString(results[i]->error()) : image.problem) + ": left out");
    }
    for (std::size_t i = 0; i < images.size(); ++i)
        images[i].name = source.images[i].name;
    return true;
}

} // namespace franken::gltf
