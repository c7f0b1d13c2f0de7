#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs what uses several threads under ThreadSanitizer: scenes that are read and cancelled, images that are scaled by
# helpers, and models that come step by step. It takes minutes to build, and so is no part of CI. What Mesa does inside
# is not seen: it is compiled without.
set -eu
cd "$(dirname "$0")/.."
cmake --preset tsan >/dev/null
cmake --build build/tsan --target threads_test steps_test gltf_test upload_test
export MESA_SHADER_CACHE_DISABLE=true TSAN_OPTIONS="halt_on_error=1 ${TSAN_OPTIONS:-}"
build/tsan/bin/threads_test
build/tsan/bin/steps_test
build/tsan/bin/upload_test --gtest_filter='Resampled.*:Mipmaps.*'
build/tsan/bin/gltf_test --gtest_filter='GltfProgress.*:GltfCancel.*:GltfEncoded.*:GltfScene.*'
echo "nothing found"
