// SPDX-License-Identifier: MIT
#pragma once

#include "price/frame_price.h"
#include "studio.h"

/// What a subject costs, drawn to that target with that look. Fails as price::priceFrame() does.
franken::Result<price::FramePrice> priceOf(const Subject& subject, const Options& options,
                                           const franken::Look& look, const franken::SnippetSet& snippets,
                                           const franken::DrawTarget& target);
