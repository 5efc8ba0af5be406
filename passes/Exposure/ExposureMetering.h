// Reads luminance on the CPU as PostProcessHistogramCommon.ush does on lanes, in double. Source: engine file
// PostProcessHistogramCommon.ush (formulas).
#pragma once

#include "Math/ToInteger.h"
#include "RHITexture.h"
#include "TexelRows.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace Drydock
{

/** Means of the channels of Count texels of a row, as stored; may be negative, infinite or NaN. The texture has memory.
 * Row: what is decoded on the way, kept from call to call. */
inline void ReadMeanColors(
	FRHITexture& Texture, int32 X, int32 Y, int32 Count, std::vector<float>& Row, std::vector<double>& OutMeans)
{
	OutMeans.resize(static_cast<size_t>(Count));
	const FTexelStorageInfo& Info = GetTexelStorageInfo(Texture.GetStorage());
	if (Info.Kind == ETexelKind::Uint || Info.BitsPerChannel > 32)
	{
		for (int32 i = 0; i < Count; ++i)
		{
			const FVector4 Color = Texture.ReadTexelDouble(X + i, Y);
			OutMeans[static_cast<size_t>(i)] = (Color.X + Color.Y + Color.Z) / 3.0;
		}
		return;
	}
	Row.resize(static_cast<size_t>(Count) * 3);
	DecodeTexelRow(Texture.GetStorage(), Texture.GetTexelToRead(X, Y, 0, 0), Count, 3, Row.data());
	for (size_t i = 0; i < OutMeans.size(); ++i)
	{
		OutMeans[i] = (static_cast<double>(Row[3 * i]) + static_cast<double>(Row[3 * i + 1]) +
						  static_cast<double>(Row[3 * i + 2])) /
					  3.0;
	}
}

/** log2 of what a mean that is not NaN counts as: CalculateEyeAdaptationLuminance. */
inline double GetMeteredLogLuminance(double Mean, double OneOverPreExposure, double LuminanceMin)
{
	return std::log2(std::max(std::clamp(Mean, 0.0, 65536.0) * OneOverPreExposure, LuminanceMin));
}

/** Two neighbouring buckets of NumBuckets and how a luminance is shared between them. */
struct FBucketShare
{
	int32 First = 0;
	double FirstWeight = 1.0;
	double SecondWeight = 0.0;
};

/** Shares a luminance between two buckets; there are at least two. Values below the range, and a position that is NaN,
 * count in the first. */
inline FBucketShare ShareBetweenBuckets(double LogLuminance, double Scale, double Bias, int32 NumBuckets)
{
	const double Place = LogLuminance * Scale + Bias;
	const double Position = (Place > 0.0 ? std::min(Place, 1.0) : 0.0) * (NumBuckets - 1);
	FBucketShare Share;
	Share.First = ToIndex(Position, NumBuckets - 1);
	Share.SecondWeight = Position - Share.First;
	Share.FirstWeight = 1.0 - Share.SecondWeight;
	return Share;
}

} // namespace Drydock
