// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>
#include <system_error>
#include <thread>

#include "gltf_internal.h"

namespace franken::gltf {
namespace {

std::span<const std::uint8_t> encodedBytes(const tinygltf::Model& model, const tinygltf::Image& image) {
    if (image.bufferView < 0)
        return image.image;
    const tinygltf::BufferView& view = model.bufferViews[at(image.bufferView)];
    return std::span(model.buffers[at(view.buffer)].data).subspan(view.byteOffset, view.byteLength);
}

// Decoding is most of the time that a load takes, and each image is alone: one worker for each core.
void decodeAll(const Source& source, const std::vector<int>& which,
               std::vector<std::optional<Result<Image>>>& results) {
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < which.size(); i = next++)
            results[i] = decodeImage(encodedBytes(source.model, source.model.images[at(which[i])]),
                                     source.options.maxImageSize);
    };
    const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
    std::vector<std::jthread> workers;
    try {
        for (std::size_t i = 1; i < std::min(cores, which.size()); ++i)
            workers.emplace_back(work);
    } catch (const std::system_error&) { // no more threads to be had: this one does the rest
    }
    work();
}

} // namespace

void readImages(Source& source, const std::vector<bool>& used, std::vector<bool>& broken,
                std::vector<Image>& images) {
    std::vector<int> which;
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i])
            which.push_back(static_cast<int>(i));
    std::vector<std::optional<Result<Image>>> results(which.size());
    decodeAll(source, which, results);

    images.assign(used.size(), Image{"", 1, 1, {255, 255, 255, 255}});
    broken.assign(used.size(), false);
    for (std::size_t i = 0; i < which.size(); ++i) {
        const std::size_t index = at(which[i]);
        if (*results[i]) {
            images[index] = std::move(**results[i]);
        } else {
            broken[index] = true;
            const std::string& uri = source.model.images[index].uri;
            source.warn(pathOf("images", index),
                        (uri.empty() ? "" : uri + ": ") + toString(results[i]->error()) + ": left out");
        }
    }
    for (std::size_t i = 0; i < images.size(); ++i)
        images[i].name =
            source.model.images[i].name.empty() ? source.model.images[i].uri : source.model.images[i].name;
}

} // namespace franken::gltf
