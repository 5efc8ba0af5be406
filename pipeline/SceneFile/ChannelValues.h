// The values of one channel of a scene, as measurements read them.
#pragma once

#include "Picture/ImagePlane.h"

#include <cmath>
#include <cstddef>

namespace Drydock
{

/** A channel's values, row by row, or one value for all pixels. */
struct FChannelValues
{
	const FImagePlane* Values = nullptr;
	float Constant = 0.0f;
	int Width = 0;
	/** r.Drydock.NonFinite 1: what is not finite counts as 0. */
	bool bZeroNonFinite = false;

	float Get(int X, int Y) const
	{
		const float Value =
			Values != nullptr
				? Values->Get(static_cast<size_t>(Y) * static_cast<size_t>(Width) + static_cast<size_t>(X))
				: Constant;
		return bZeroNonFinite && !std::isfinite(Value) ? 0.0f : Value;
	}
};

} // namespace Drydock
