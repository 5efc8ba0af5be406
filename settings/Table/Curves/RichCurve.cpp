// Evaluates curves. Source: engine Curves/RichCurve.cpp (behaviour only).
#include "Curves/RichCurve.h"

#include <algorithm>
#include <cmath>

namespace
{

float EvalBetween(const FRichCurveKey& First, const FRichCurveKey& Second, float Time)
{
	const float Length = Second.Time - First.Time;
	if (!(Length > 0.0f) || First.InterpMode == RCIM_Constant)
	{
		return First.Value;
	}
	const float Alpha = (Time - First.Time) / Length;
	if (First.InterpMode != RCIM_Cubic)
	{
		return FMath::Lerp(First.Value, Second.Value, Alpha);
	}
	constexpr float OneThird = 1.0f / 3.0f;
	const float Leave = First.Value + First.LeaveTangent * Length * OneThird;
	const float Arrive = Second.Value - Second.ArriveTangent * Length * OneThird;
	const float A = FMath::Lerp(First.Value, Leave, Alpha);
	const float B = FMath::Lerp(Leave, Arrive, Alpha);
	const float C = FMath::Lerp(Arrive, Second.Value, Alpha);
	return FMath::Lerp(FMath::Lerp(A, B, Alpha), FMath::Lerp(B, C, Alpha), Alpha);
}

} // namespace

void FRichCurve::AutoSetTangents(float Tension)
{
	for (int32 Index = 0; Index < Keys.Num(); ++Index)
	{
		const bool bEnd = Index == 0 || Index + 1 == Keys.Num();
		const float Time = bEnd ? 0.0f : Keys[Index + 1].Time - Keys[Index - 1].Time;
		const float Tangent =
			Time > 0.0f ? (1.0f - Tension) * (Keys[Index + 1].Value - Keys[Index - 1].Value) / Time : 0.0f;
		if (Keys[Index].InterpMode == RCIM_Cubic)
		{
			Keys[Index].ArriveTangent = Keys[Index].LeaveTangent = Tangent;
		}
	}
}

float FRichCurve::Eval(float InTime, float InDefaultValue) const
{
	if (Keys.Num() == 0 || std::isnan(InTime))
	{
		return InDefaultValue;
	}
	const FRichCurveKey* const First = Keys.GetData();
	const FRichCurveKey* const End = First + Keys.Num();
	const FRichCurveKey* const Next =
		std::upper_bound(First, End, InTime, [](float Time, const FRichCurveKey& Key) { return Time < Key.Time; });
	return Next == First ? First->Value : Next == End ? (End - 1)->Value : EvalBetween(*(Next - 1), *Next, InTime);
}
