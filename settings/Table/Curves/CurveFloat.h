// Curves as objects. One that settings name stands for the asset's path (SettingObjects.h) and has no keys; code may
// give a curve keys. Source: engine Curves/CurveFloat.h, Curves/CurveLinearColor.h.
#pragma once

#include "CoreMinimal.h"
#include "Curves/RichCurve.h"
#include "UObject/Object.h"

class DRYDOCK_API UCurveFloat : public UObject
{
public:
	FRichCurve FloatCurve;

	/** 0 without keys. */
	float GetFloatValue(float InTime) const
	{
		if (FloatCurve.Keys.IsEmpty())
		{
			Drydock::SayNeutral(
				TEXT("UCurveFloat::GetFloatValue"), TEXT("a curve without keys is 0: no asset is loaded"));
		}
		return FloatCurve.Eval(InTime);
	}
};

class DRYDOCK_API UCurveLinearColor : public UObject
{
public:
	FRichCurve FloatCurves[4]; // red to alpha

	/** Black without keys; alpha is 1 where it has none. */
	FLinearColor GetLinearColorValue(float InTime) const
	{
		if (FloatCurves[0].Keys.IsEmpty())
		{
			Drydock::SayNeutral(TEXT("UCurveLinearColor::GetLinearColorValue"),
				TEXT("a curve without keys is black: no asset is loaded"));
		}
		return FLinearColor(FloatCurves[0].Eval(InTime), FloatCurves[1].Eval(InTime), FloatCurves[2].Eval(InTime),
			FloatCurves[3].Eval(InTime, 1.0f));
	}
};
