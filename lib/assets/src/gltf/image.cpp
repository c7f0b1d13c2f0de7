// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>

#include "gltf/accessor.h"
#include "gltf/material.h"
#include "helper_threads.h"
#include "image/image_header.h"

namespace franken::gltf {
namespace {

using Bytes = std::span<const std::uint8_t>;
using Results = std::vector<std::optional<Result<Image>>>;

// Decoding is most of the time that a load takes, and each image is alone: one worker for each core, as far
// as the memory goes that one of them takes. This thread is one of them, and says how far they are.
bool decodeAll(Document& source, const std::vector<Bytes>& encoded, std::size_t maxWorkers,
               Results& results) {
    std::atomic<std::size_t> next = 0;
    const auto decodeOne = [&](std::size_t i) {
        results[i] = decodeImage(encoded[i], source.options.maxImageSize);
    };
    const std::function<void()> work = [&] {
        for (std::size_t i = next++; i < encoded.size() && !source.options.cancel.stop_requested();
             i = next++)
            decodeOne(i);
    };
    auto helpers = startHelpers(std::min(encoded.size(), maxWorkers), work);
    for (std::size_t i = next++; i < encoded.size(); i = next++) {
        const float share = static_cast<float>(i) / static_cast<float>(encoded.size());
        if (!source.proceed(kReadJson + (kReadImages - kReadJson) * share, "images"))
            return false;
        decodeOne(i);
    }
    helpers.clear();
    return source.proceed(kReadImages, "meshes");
}

/// The header's size, and the bytes as they are.
Result<Image> undecoded(Bytes encoded, int maxSize) {
    return readImageHeader(encoded, maxSize).transform([&](const ImageHeader& header) {
        return Image{"", header.width, header.height, {}, {encoded.begin(), encoded.end()}};
    });
}

// What stays is the pixels, or the file's bytes. What decoding takes besides is there once for each worker,
// or for whoever decodes one at a time, and `largest` of them all.
bool chargeImage(Document& source, Bytes encoded, const std::string& where, std::size_t& largest) {
    const Result<ImageHeader> header = readImageHeader(encoded, source.options.maxImageSize);
    if (!header)
        return true; // and decoding says why
    largest = std::max(largest, header->decodingBytes);
    return source.charge(
        1, source.options.images == ImageForm::Pixels ? header->pixelBytes() : encoded.size(), where);
}

} // namespace

bool readImages(Document& source, const std::vector<bool>& used, std::vector<bool>& broken,
                std::vector<Image>& images) {
    std::vector<std::size_t> which;
    std::vector<Bytes> encoded;
    std::size_t largest = 1;
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (!used[i])
            continue;
        if (!source.need(pathOf("images", i)))
            return false;
        which.push_back(i);
        const EncodedImage& image = source.images[i];
        encoded.push_back(image.view == kNone ? Bytes(image.bytes) : viewBytes(source, image.view));
        if (source.error || !chargeImage(source, encoded.back(), pathOf("images", i), largest))
            return false;
    }
    const std::size_t maxWorkers = source.room() / largest;
    if (!source.charge(1, largest, "/images"))
        return false;
    Results results(which.size());
    if (source.options.images == ImageForm::Encoded)
        std::transform(encoded.begin(), encoded.end(), results.begin(),
                       [&](Bytes image) { return undecoded(image, source.options.maxImageSize); });
    else if (!decodeAll(source, encoded, maxWorkers, results))
        return false;

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
