// Defines a curve through keys. Source: engine Curves/RichCurve.h: constant beyond its ends, each key's mode from it to
// the next one, cubic as a Bezier piece by the tangents. Features of the engine that are missing: weighted tangents,
// other extrapolations.
#pragma once

#include "CoreMinimal.h"

enum ERichCurveInterpMode : int
{
	RCIM_Linear,
	RCIM_Constant,
	RCIM_Cubic,
	RCIM_None,
};

struct FRichCurveKey
{
	ERichCurveInterpMode InterpMode = RCIM_Linear; // from this key to the next
	float Time = 0.0f;
	float Value = 0.0f;
	float ArriveTangent = 0.0f; // value per time
	float LeaveTangent = 0.0f;
};

struct FRichCurve
{
	TArray<FRichCurveKey> Keys; // of ascending time

	/** Automatic tangents of cubic keys: the slope between both neighbours, times 1 - Tension; 0 at the ends. */
	DRYDOCK_API void AutoSetTangents(float Tension = 0.0f);

	/** DefaultValue without keys, and for a time that is NaN. */
	DRYDOCK_API float Eval(float InTime, float InDefaultValue = 0.0f) const;
};
