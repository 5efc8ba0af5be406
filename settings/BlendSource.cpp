// Source: drydock.
#include "BlendSource.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Drydock
{

namespace
{

constexpr double LargestFloat = std::numeric_limits<float>::max();

double GetLargestComponent(const FSettingValue& Value)
{
	double Largest = 0.0;
	for (const double Component : Value.Components)
	{
		Largest = std::max(Largest, std::fabs(Component));
	}
	return Largest;
}

/** Without the difference of the ends, in double; sums end at the largest float. */
FSettingValue BlendWithoutOverflow(
	const FSettingField& Field, const FSettingValue& From, const FSettingValue& To, double Weight)
{
	FSettingValue Result = From;
	for (size_t Index = 0; Index < std::size(Result.Components); ++Index)
	{
		const double A = From.Components[Index];
		const double B = To.Components[Index];
		Result.Components[Index] = Field.Blend == ESettingBlend::Accumulate
									   ? std::clamp(A + B * Weight, -LargestFloat, LargestFloat)
									   : A * (1.0 - Weight) + B * Weight;
	}
	return Result;
}

} // namespace

bool IsFinite(const FSettingValue& Value)
{
	return std::all_of(std::begin(Value.Components), std::end(Value.Components),
		[](double Component) { return std::isfinite(Component); });
}

bool IsIneffective(const FSettingField& Field, const FSettingValue& Value)
{
	return Field.Blend == ESettingBlend::SetIfNonZero && GetLargestComponent(Value) == 0.0;
}

FOverriddenFields FindOverriddenFields(const FPostProcessSettings& Settings)
{
	FOverriddenFields Found;
	const std::vector<FSettingField>& Fields = GetSettingFields();
	for (uint32 Index = 0; Index < Fields.size(); ++Index)
	{
		if (Fields[Index].IsOverridden(Settings))
		{
			const FSettingValue Value = Fields[Index].Get(Settings);
			(IsFinite(Value) ? Found.Fields : Found.NonFinite).push_back(Index);
			Found.bHuge = Found.bHuge || GetLargestComponent(Value) > 0.5 * LargestFloat;
		}
	}
	return Found;
}

void BlendField(const FSettingField& Field, FPostProcessSettings& Settings, const FPostProcessSettings& Source,
	float Weight, bool bHuge)
{
	Field.SetOverridden(Settings, true);
	if (!bHuge)
	{
		Field.BlendFrom(Settings, Source, Weight);
		return;
	}
	const FSettingValue Before = Field.Get(Settings);
	Field.BlendFrom(Settings, Source, Weight);
	if (!IsFinite(Field.Get(Settings)))
	{
		Field.Set(Settings, BlendWithoutOverflow(Field, Before, Field.Get(Source), static_cast<double>(Weight)));
	}
}

} // namespace Drydock
