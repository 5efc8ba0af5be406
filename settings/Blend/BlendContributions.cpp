// Colour tables, ambient cubemaps and blendables of settings objects, gathered by weight. Source: engine
// FinalPostProcessSettings.h and SceneView.cpp; the descriptions are drydock's.
#include "BlendContributions.h"

#include "SettingObjects.h"
#include "TextTools.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace Drydock
{

namespace
{

bool IsFiniteColor(const FLinearColor& Color)
{
	return std::isfinite(Color.R) && std::isfinite(Color.G) && std::isfinite(Color.B) && std::isfinite(Color.A);
}

/** The sum of two colours, which ends at the largest float. */
FLinearColor AddWithoutOverflow(const FLinearColor& A, const FLinearColor& B)
{
	static constexpr float Largest = std::numeric_limits<float>::max();
	const auto Add = [](float X, float Y)
	{
		return std::clamp(X + Y, -Largest, Largest);
	};
	return FLinearColor(Add(A.R, B.R), Add(A.G, B.G), Add(A.B, B.B), Add(A.A, B.A));
}

std::string Format(const char* Pattern, double A, double B = 0.0, double C = 0.0)
{
	char Buffer[128];
	std::snprintf(Buffer, sizeof(Buffer), Pattern, A, B, C);
	return Buffer;
}

} // namespace

void BlendContributions(FFinalPostProcessSettings& Settings, const FPostProcessSettings& Source, float Weight)
{
	if (Source.bOverride_ColorGradingLUT)
	{
		const float LUTWeight = std::clamp(Source.ColorGradingIntensity, 0.0f, 1.0f) * Weight;
		if (LUTWeight > 0.0f)
		{
			Settings.LerpTo(Source.ColorGradingLUT.Get(), LUTWeight);
		}
	}
	if (Source.bOverride_AmbientCubemap)
	{
		FLinearColor Scale(Weight, Weight, Weight, Weight);
		Scale = Source.bOverride_AmbientCubemapTint ? Scale * Source.AmbientCubemapTint : Scale;
		Scale = Source.bOverride_AmbientCubemapIntensity ? Scale * Source.AmbientCubemapIntensity : Scale;
		if (IsFiniteColor(Scale))
		{
			Settings.AddCubemap(Source.AmbientCubemap.Get(), Scale);
		}
	}
	for (const FWeightedBlendable& Blendable : Source.WeightedBlendables.Array)
	{
		const float BlendableWeight = std::min(Blendable.Weight, 1.0f) * Weight;
		if (Blendable.Object.Get() != nullptr && BlendableWeight > 0.0f)
		{
			Settings.BlendableManager.Blendables.Add(FWeightedBlendable(BlendableWeight, Blendable.Object.Get()));
		}
	}
}

std::string DescribeLUTs(const FFinalPostProcessSettings& Settings)
{
	return JoinText(Settings.ContributingLUTs, ", ",
		[&](const FFinalPostProcessSettings::FLUTEntry& Entry)
		{ return GetObjectPath(Entry.LUT.Get()) + Format(" %.4g %%", 100.0 * static_cast<double>(Entry.Weight)); });
}

std::string DescribeCubemaps(const FFinalPostProcessSettings& Settings)
{
	std::string Text;
	for (const FFinalPostProcessSettings::FCubemapEntry& Entry : Settings.ContributingCubemaps)
	{
		const FLinearColor& Scale = Entry.AmbientCubemapTintMulScaleValue;
		Text += (Text.empty() ? "" : ", ") + GetObjectPath(Entry.AmbientCubemap.Get()) +
				Format(" (%.4g, %.4g, %.4g)", static_cast<double>(Scale.R), static_cast<double>(Scale.G),
					static_cast<double>(Scale.B));
	}
	return Text.empty() ? "None" : Text;
}

} // namespace Drydock

void FFinalPostProcessSettings::LerpTo(UTexture* LUT, float Weight)
{
	if (Weight >= 1.0f)
	{
		ContributingLUTs.Empty();
	}
	FLUTEntry* Found = nullptr;
	for (FLUTEntry& Entry : ContributingLUTs)
	{
		Entry.Weight *= 1.0f - Weight;
		Found = Entry.LUT.Get() == LUT ? &Entry : Found;
	}
	if (Found != nullptr)
	{
		Found->Weight += Weight;
	}
	else
	{
		ContributingLUTs.Add({LUT, std::min(Weight, 1.0f)});
	}
}

void FFinalPostProcessSettings::AddCubemap(UTextureCube* Cubemap, const FLinearColor& TintTimesScale)
{
	if (Cubemap == nullptr)
	{
		return;
	}
	for (FCubemapEntry& Entry : ContributingCubemaps)
	{
		if (Entry.AmbientCubemap.Get() == Cubemap)
		{
			Entry.AmbientCubemapTintMulScaleValue =
				Drydock::AddWithoutOverflow(Entry.AmbientCubemapTintMulScaleValue, TintTimesScale);
			return;
		}
	}
	ContributingCubemaps.Add({TintTimesScale, Cubemap});
}
