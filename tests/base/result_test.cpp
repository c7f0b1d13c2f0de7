// SPDX-License-Identifier: MIT
#include "franken/result.h"

#include <gtest/gtest.h>

#include <memory>

namespace {

using franken::Error;
using franken::Result;

Result<int> half(int number) {
    if (number % 2 != 0)
        return Error{"test.odd", std::to_string(number), "it is odd", ""};
    return number / 2;
}

TEST(Result, AndThenGoesOnWithTheValue) {
    EXPECT_EQ(*half(12).and_then(half), 3);
    EXPECT_EQ(half(6).and_then(half).error().where, "3") << "the second fails";
}

TEST(Result, AndThenKeepsTheFirstErrorAndCallsNothing) {
    bool called = false;
    const Result<int> result = half(7).and_then([&](int) {
        called = true;
        return half(8);
    });
    EXPECT_EQ(result.error().where, "7");
    EXPECT_FALSE(called);
}

TEST(Result, TransformMakesAnotherValueOfIt) {
    EXPECT_EQ(*half(8).transform([](int number) { return std::to_string(number); }), "4");
    EXPECT_EQ(half(1).transform([](int number) { return std::to_string(number); }).error().code, "test.odd");
}

TEST(Result, TransformByAFunctionWithoutAValueIsSuccessAlone) {
    int seen = 0;
    const Result<void> done = half(8).transform([&](int number) { seen = number; });
    EXPECT_TRUE(done);
    EXPECT_EQ(seen, 4);
    EXPECT_FALSE(half(1).transform([&](int number) { seen = number; }));
    EXPECT_EQ(seen, 4);
}

TEST(Result, WhatCannotBeCopiedIsHandedOn) {
    Result<std::unique_ptr<int>> owned = std::make_unique<int>(5);
    const Result<int> value = std::move(owned).transform([](std::unique_ptr<int> number) { return *number; });
    EXPECT_EQ(*value, 5);
}

TEST(Result, VoidGoesOnToo) {
    EXPECT_EQ(*Result<void>().and_then([] { return half(2); }), 1);
    EXPECT_EQ(Result<void>(Error{"test.first", "", "", ""}).and_then([] { return half(2); }).error().code,
              "test.first");
}

} // namespace
