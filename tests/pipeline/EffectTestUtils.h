// Helpers of tests that ask what became of an effect.
#pragma once

#include "Effects/Effects.h"
#include "Run/RunResult.h"

#include <gtest/gtest.h>

#include <string>

namespace Drydock
{

/** The decision on an effect by name; where there is none the test fails. */
inline const FEffectDecision& FindEffect(const std::vector<FEffectDecision>& Effects, const std::string& Name)
{
	static const FEffectDecision None;
	const FEffect* const Effect = FindEffectByName(Name);
	const FEffectDecision* const Found = Effect != nullptr ? FindEffect(Effects, Effect->Id) : nullptr;
	EXPECT_NE(nullptr, Found) << Name;
	return Found != nullptr ? *Found : None;
}

inline const FEffectDecision& FindEffect(const FRunResult& Result, const std::string& Name)
{
	return FindEffect(Result.Effects, Name);
}

/** What the first view's effect was measured to be; where it was not the test fails. */
inline const FEffectFigures& FindFigures(const FRunResult& Result, EEffect Id)
{
	static const FEffectFigures None;
	const auto Found = Result.Figures.find(Id);
	EXPECT_NE(Result.Figures.end(), Found);
	return Found != Result.Figures.end() ? Found->second : None;
}

} // namespace Drydock
