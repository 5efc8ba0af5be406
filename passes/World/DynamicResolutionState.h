// The resolution fractions that plugins ask a family for. drydock renders at the resolution it is told: every fraction
// is 1. Source: engine files DynamicResolutionState.h, SceneView.h (ISceneViewFamilyScreenPercentage).
#pragma once

#include "CoreMinimal.h"

namespace DynamicRenderScaling
{

/** The budget that a fraction is counted against; its address is its name. */
struct FBudget
{
};

/** One value per budget. */
template<typename T>
class TMap
{
public:
	void SetAll(const T& Value) { Default = Value; }
	T& operator[](const FBudget&) { return Default; }
	const T& operator[](const FBudget&) const { return Default; }

private:
	T Default{};
};

} // namespace DynamicRenderScaling

inline const DynamicRenderScaling::FBudget GDynamicPrimaryResolutionFraction;

/** Chooses the resolution of a family: 100 %. */
class ISceneViewFamilyScreenPercentage
{
public:
	virtual ~ISceneViewFamilyScreenPercentage() = default;

	virtual DynamicRenderScaling::TMap<float> GetResolutionFractionsUpperBound() const
	{
		DynamicRenderScaling::TMap<float> Fractions;
		Fractions.SetAll(1.0f);
		return Fractions;
	}
	virtual DynamicRenderScaling::TMap<float> GetResolutionFractions_RenderThread() const
	{
		return GetResolutionFractionsUpperBound();
	}
	float GetPrimaryResolutionFractionUpperBound() const { return 1.0f; }
	float GetPrimaryResolutionFraction_RenderThread() const { return 1.0f; }
};
