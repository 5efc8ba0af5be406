// Compares pictures value by value and graphs pass by pass.
#include "Matrix/MatrixCompare.h"

#include "Text/Fingerprint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace Drydock
{

namespace
{

bool HasPass(const std::vector<FMatrixPass>& Passes, size_t From, const std::string& Name)
{
	return std::any_of(Passes.begin() + static_cast<std::ptrdiff_t>(From), Passes.end(),
		[&Name](const FMatrixPass& Pass) { return Pass.Name == Name; });
}

double GetDistance(double A, double B)
{
	const bool bBothNaN = std::isnan(A) && std::isnan(B);
	if (bBothNaN || A == B)
	{
		return 0.0;
	}
	const double Distance = std::abs(A - B);
	return std::isfinite(Distance) ? Distance : std::numeric_limits<double>::infinity();
}

/** 0.0 and -0.0 are two values. */
bool AreSame(double A, double B)
{
	return (std::isnan(A) && std::isnan(B)) || (A == B && std::signbit(A) == std::signbit(B));
}

/** Describes the difference between two passes of one name; empty: none. */
std::string DescribeChange(const FMatrixPass& Before, const FMatrixPass& Now)
{
	if (Before.bExecuted != Now.bExecuted)
	{
		return Now.bExecuted ? "runs, and was left out before" : "is left out, and ran before";
	}
	if (Before.Shader != Now.Shader)
	{
		return "runs " + (Now.Shader.empty() ? "no shader" : Now.Shader) + ", not " +
			   (Before.Shader.empty() ? "none" : Before.Shader);
	}
	if (Before.Written.size() != Now.Written.size())
	{
		return "writes " + std::to_string(Now.Written.size()) + " textures, not " +
			   std::to_string(Before.Written.size());
	}
	for (size_t Index = 0; Index < Now.Written.size(); ++Index)
	{
		const auto& [NameBefore, FingerprintBefore] = Before.Written[Index];
		const auto& [Name, Fingerprint] = Now.Written[Index];
		if (Name != NameBefore)
		{
			return "writes " + Name + ", not " + NameBefore;
		}
		if (Fingerprint != FingerprintBefore)
		{
			return Now.Written.size() > 1 ? "draws something else to " + Name : "draws something else";
		}
	}
	return "";
}

} // namespace

std::optional<FPictureDifference> ComparePictures(const FImage& Before, const FImage& Now)
{
	FPictureDifference Difference;
	if (Before.Width != Now.Width || Before.Height != Now.Height || Before.NumChannels != Now.NumChannels)
	{
		Difference.bOtherSize = true;
		return Difference;
	}
	for (int Y = 0; Y < Now.Height; ++Y)
	{
		for (int X = 0; X < Now.Width; ++X)
		{
			bool bDiffers = false;
			for (int Channel = 0; Channel < Now.NumChannels; ++Channel)
			{
				const double A = Before.Get(X, Y, Channel);
				const double B = Now.Get(X, Y, Channel);
				bDiffers = bDiffers || !AreSame(A, B);
				Difference.Max = std::max(Difference.Max, GetDistance(A, B));
			}
			if (bDiffers && Difference.NumPixels++ == 0)
			{
				Difference.X = X;
				Difference.Y = Y;
			}
		}
	}
	return Difference.NumPixels > 0 ? std::optional(Difference) : std::nullopt;
}

std::string FingerprintPicture(const FImage& Picture)
{
	const std::array<int, 3> Size = {Picture.Width, Picture.Height, Picture.NumChannels};
	FFingerprint Fingerprint;
	Fingerprint.Add(Size.data(), sizeof(Size));
	for (const double Value : Picture.Values)
	{
		const double Plain = std::isnan(Value) ? std::numeric_limits<double>::quiet_NaN() : Value;
		Fingerprint.Add(&Plain, sizeof(Plain));
	}
	return Fingerprint.Get();
}

std::optional<FPassDifference> FindFirstDifference(
	const std::vector<FMatrixPass>& Before, const std::vector<FMatrixPass>& Now)
{
	for (size_t Index = 0; Index < Now.size() || Index < Before.size(); ++Index)
	{
		if (Index >= Before.size())
		{
			return FPassDifference{Now[Index].Name, "is new"};
		}
		if (Index >= Now.size())
		{
			return FPassDifference{Before[Index].Name, "is gone"};
		}
		const FMatrixPass& Old = Before[Index];
		const FMatrixPass& New = Now[Index];
		if (Old.Name != New.Name)
		{
			const bool bLater = HasPass(Now, Index, Old.Name);
			const bool bEarlier = HasPass(Before, Index, New.Name);
			return bLater     ? FPassDifference{New.Name, "is new"}
				   : bEarlier ? FPassDifference{Old.Name, "is gone"}
							  : FPassDifference{New.Name, "stands in place of " + Old.Name};
		}
		const std::string Change = DescribeChange(Old, New);
		if (!Change.empty())
		{
			return FPassDifference{New.Name, Change};
		}
	}
	return std::nullopt;
}

} // namespace Drydock
