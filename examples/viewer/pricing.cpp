// SPDX-License-Identifier: MIT
#include "pricing.h"

using namespace franken;

Result<price::FramePrice> priceOf(const Subject& subject, const Options& options, const Look& look,
                                  const SnippetSet& snippets, const DrawTarget& target) {
    const price::FrameContents frame{.scene = subject.scene,
                                     .viewpoint = viewpointOf(subject, aspectOf(target)),
                                     .lighting = subject.lighting,
                                     .look = look,
                                     .skyboxSize = subject.sky ? subject.sky->skybox.size : 0,
                                     .width = target.width,
                                     .height = target.height};
    return price::priceFrame(frame, options.price, price::ProgramCosts::open(), snippets);
}
