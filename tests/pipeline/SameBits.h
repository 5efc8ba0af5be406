// Pictures compared bit for bit.
#pragma once

#include <gtest/gtest.h>

#include "Picture/Picture.h"

#include <cstring>

namespace SameBits
{

using Drydock::FImage;

/** The first differing pixel, or that there is none. Bits are compared, so NaN equals itself and -0 is not 0. */
inline testing::AssertionResult AreSameBits(const FImage& Expected, const FImage& Actual)
{
	if (Expected.Width != Actual.Width || Expected.Height != Actual.Height ||
		Expected.NumChannels != Actual.NumChannels)
	{
		return testing::AssertionFailure()
			   << Actual.Width << "x" << Actual.Height << " with " << Actual.NumChannels << " channels, expected "
			   << Expected.Width << "x" << Expected.Height << " with " << Expected.NumChannels;
	}
	for (size_t Index = 0; Index < Expected.Values.size(); ++Index)
	{
		if (std::memcmp(&Expected.Values[Index], &Actual.Values[Index], sizeof(double)) != 0)
		{
			const size_t Pixel = Index / static_cast<size_t>(Expected.NumChannels);
			return testing::AssertionFailure() << "pixel (" << Pixel % static_cast<size_t>(Expected.Width) << ", "
											   << Pixel / static_cast<size_t>(Expected.Width) << "), channel "
											   << Index % static_cast<size_t>(Expected.NumChannels) << ": "
											   << Actual.Values[Index] << ", expected " << Expected.Values[Index];
		}
	}
	return testing::AssertionSuccess();
}

inline testing::AssertionResult AreSameBits(const Drydock::FPicture& Expected, const Drydock::FPicture& Actual)
{
	return AreSameBits(Expected.ToImage(), Actual.ToImage());
}

} // namespace SameBits
