// Fills images.
#include "Inspect/InspectPictures.h"

#include "Picture/ImageMetrics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Drydock
{

FImage MakeMask(const FPassFinding& Finding)
{
	FImage Mask{Finding.Size.X, Finding.Size.Y, 1, {}};
	Mask.Values.resize(size_t(Mask.Width) * size_t(Mask.Height));
	for (const std::array<int32_t, 2>& Pixel : Finding.Finding.Pixels)
	{
		Mask.Values[size_t(Pixel[1]) * size_t(Mask.Width) + size_t(Pixel[0])] = 1.0;
	}
	return Mask;
}

FImage MakeValueImage(const FLineValues& Values)
{
	FImage Image{Values.Width, Values.Height, Values.NumChannels, {}};
	Image.Values.assign(Values.Values.begin(), Values.Values.end());
	const size_t NumChannels = size_t(Values.NumChannels);
	for (size_t Pixel = 0; Pixel < Values.bReached.size(); ++Pixel)
	{
		for (size_t c = 0; c < NumChannels && !Values.bReached[Pixel]; ++c)
		{
			Image.Values[Pixel * NumChannels + c] = std::numeric_limits<double>::quiet_NaN();
		}
	}
	return Image;
}

FValueRange FindRange(const FLineValues& Values)
{
	FValueRange Range;
	const size_t NumChannels = size_t(Values.NumChannels);
	bool bAny = false;
	for (size_t Pixel = 0; Pixel < Values.bReached.size(); ++Pixel)
	{
		if (!Values.bReached[Pixel])
		{
			continue;
		}
		++Range.Reached;
		bool bFinite = true;
		for (size_t c = 0; c < NumChannels; ++c)
		{
			const double Value = double(Values.Values[Pixel * NumChannels + c]);
			if (!std::isfinite(Value))
			{
				bFinite = false;
				continue;
			}
			Range.Least = bAny ? std::min(Range.Least, Value) : Value;
			Range.Most = bAny ? std::max(Range.Most, Value) : Value;
			bAny = true;
		}
		Range.NotFinite += !bFinite;
	}
	return Range;
}

FImage MakeStretched(const FLineValues& Values, const FValueRange& Range)
{
	const double Width = Range.Most - Range.Least;
	const size_t NumChannels = size_t(Values.NumChannels);
	FImage Image{Values.Width, Values.Height, 4, {}};
	for (size_t Pixel = 0; Pixel < Values.bReached.size(); ++Pixel)
	{
		double Color[4] = {0, 0, 0, double(Values.bReached[Pixel])};
		bool bFinite = true;
		for (size_t c = 0; c < 3; ++c)
		{
			const bool bThere = NumChannels == 1 || c < NumChannels;
			const double Value = bThere ? double(Values.Values[Pixel * NumChannels + (NumChannels == 1 ? 0 : c)]) : 0;
			bFinite = bFinite && std::isfinite(Value);
			Color[c] = !bThere ? 0 : Width > 0 ? (Value - Range.Least) / Width : 0.5;
		}
		if (Values.bReached[Pixel] && !bFinite)
		{
			Color[0] = Color[2] = 1;
			Color[1] = 0;
		}
		Image.Values.insert(Image.Values.end(), Color, Color + 4);
	}
	return Image;
}

FImage MakeCostImage(const FCostMap& Map)
{
	FImage Image{Map.Width, Map.Height, 2, {}};
	for (size_t Pixel = 0; Pixel < Map.Taps.size(); ++Pixel)
	{
		Image.Values.push_back(double(Map.Taps[Pixel]));
		Image.Values.push_back(double(Map.Operations[Pixel]));
	}
	return Image;
}

FImage MakeCostPreview(const FCostMap& Map)
{
	const uint64_t Most = Map.Operations.empty() ? 0 : *std::max_element(Map.Operations.begin(), Map.Operations.end());
	FImage Image{Map.Width, Map.Height, 3, {}};
	for (const uint64_t Operations : Map.Operations)
	{
		double Color[3];
		GetHeatColor(Most ? double(Operations) / double(Most) : 0, Color);
		Image.Values.insert(Image.Values.end(), Color, Color + 3);
	}
	return Image;
}

} // namespace Drydock
