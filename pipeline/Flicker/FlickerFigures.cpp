// Computes the figures of flicker from signals.
#include "Flicker/FlickerFigures.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Drydock
{

double FFlickerSignal::GetMean() const
{
	return Light.empty() ? 0.0 : std::accumulate(Light.begin(), Light.end(), 0.0) / static_cast<double>(Light.size());
}

std::optional<double> FFlickerFigures::GetLastError() const
{
	return Frames.empty() ? std::nullopt : Frames.back().Error;
}

double FFlickerFigures::GetMeanJump() const
{
	double Sum = 0.0;
	for (const FFlickerFrame& Frame : Frames)
	{
		Sum += Frame.Jump;
	}
	return Frames.empty() ? 0.0 : Sum / static_cast<double>(Frames.size());
}

const FFlickerFrame* FFlickerFigures::FindWorstJump() const
{
	const auto Worst = std::ranges::max_element(Frames, {}, &FFlickerFrame::Jump);
	return Worst == Frames.end() ? nullptr : &*Worst;
}

const FFlickerFrame* FFlickerFigures::FindWorstPixel() const
{
	const auto Worst = std::ranges::max_element(Frames, {}, &FFlickerFrame::WorstPixel);
	return Worst == Frames.end() ? nullptr : &*Worst;
}

void FFlickerMeter::Add(int Frame, const FFlickerSignal& Signal, const FFlickerSignal* Truth)
{
	FFlickerSignal Own = Signal;
	if (Truth != nullptr)
	{
		std::ranges::transform(Own.Light, Truth->Light, Own.Light.begin(), std::minus());
	}
	if (!Before.empty() && (Before.back().Width != Own.Width || Before.back().Height != Own.Height))
	{
		Before.clear();
		Figures = FFlickerFigures();
	}
	const size_t NumNeeded = Truth != nullptr ? 1 : 2;
	if (Before.size() >= NumNeeded)
	{
		const FFlickerSignal& Last = Before.back();
		const FFlickerSignal& Earlier = Before[Before.size() - NumNeeded];
		const auto GetJump = [&](double Now, double One, double Two)
		{
			return std::abs(Truth != nullptr ? Now - One : 0.5 * (Now - 2.0 * One + Two));
		};
		if (Figures.Where.Values.empty())
		{
			Figures.Where = FImage{Own.Width, Own.Height, 1, std::vector<double>(Own.Light.size(), 0.0)};
		}
		FFlickerFrame Row;
		Row.Frame = Frame;
		Row.Mean = Signal.GetMean();
		Row.MeanOfTruth = Truth != nullptr ? std::optional(Truth->GetMean()) : std::nullopt;
		for (size_t Index = 0; Index < Own.Light.size(); ++Index)
		{
			const double Jump = GetJump(Own.Light[Index], Last.Light[Index], Earlier.Light[Index]);
			Figures.Where.Values[Index] = std::max(Figures.Where.Values[Index], Jump);
			if (Jump > Row.WorstPixel)
			{
				Row.WorstPixel = Jump;
				Row.WorstPlace =
					FIntPoint(static_cast<int32>(Index) % Own.Width, static_cast<int32>(Index) / Own.Width);
			}
		}
		if (Truth != nullptr)
		{
			Row.Error = std::sqrt(std::inner_product(Own.Light.begin(), Own.Light.end(), Own.Light.begin(), 0.0) /
								  static_cast<double>(std::max<size_t>(Own.Light.size(), 1)));
		}
		const double Base = Row.MeanOfTruth.value_or(Row.Mean);
		const double Jump = GetJump(Own.GetMean(), Last.GetMean(), Earlier.GetMean());
		Row.Jump = Base > 0.0 ? 100.0 * Jump / Base : 0.0;
		Figures.Frames.push_back(Row);
	}
	Before.push_back(std::move(Own));
	if (Before.size() > 2)
	{
		Before.erase(Before.begin());
	}
}

} // namespace Drydock
