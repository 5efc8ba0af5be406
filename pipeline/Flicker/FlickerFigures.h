// Figures for flicker: by how much light jumps from frame to frame, beyond what the scene itself does.
#pragma once

#include "CoreMinimal.h"
#include "Picture/ImageFile.h"

#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** The light of a picture in one frame: luminances, row by row. */
struct FFlickerSignal
{
	int Width = 0;
	int Height = 0;
	std::vector<double> Light;

	DRYDOCK_API double GetMean() const;
};

/** A frame, against the one before. */
struct FFlickerFrame
{
	int Frame = 0;
	double Mean = 0.0;                 // of the light
	std::optional<double> MeanOfTruth; // not set: without a truth
	std::optional<double> Error;       // root mean square of the difference to the truth, in the unit of the light
	double Jump = 0.0;                 // percent of the mean light
	double WorstPixel = 0.0;           // in the unit of the light
	FIntPoint WorstPlace = FIntPoint(0, 0);
};

/** A picture's figures over the frames. */
struct FFlickerFigures
{
	std::vector<FFlickerFrame> Frames; // those that have a figure
	FImage Where;                      // one channel: the worst of each pixel

	/** The error to the truth in the last frame; not set: without a truth, or without frames. */
	DRYDOCK_API std::optional<double> GetLastError() const;
	/** Mean of the jumps, percent; 0 without frames. */
	DRYDOCK_API double GetMeanJump() const;
	/** The frame of the largest jump; null without frames. */
	DRYDOCK_API const FFlickerFrame* FindWorstJump() const;
	/** The frame with the worst pixel; null without frames. */
	DRYDOCK_API const FFlickerFrame* FindWorstPixel() const;
};

/**
 * Takes a picture's signals frame by frame. With a truth, the same picture of a run without aliasing, the jump of a
 * value is |(v - v before) - (t - t before)|: what the scene itself does does not count. Without one it is
 * |v - 2 v before + v two before| / 2, so that a steady change does not count. The jump of the light is that of its
 * mean, in percent of the mean of the truth, or of the light itself. Pictures that change their size begin anew.
 */
class DRYDOCK_API FFlickerMeter
{
public:
	/** Truth: of the same size, or null. */
	void Add(int Frame, const FFlickerSignal& Signal, const FFlickerSignal* Truth);

	const FFlickerFigures& Get() const { return Figures; }

private:
	std::vector<FFlickerSignal> Before; // the last two signals, less the truth where there is one
	FFlickerFigures Figures;
};

} // namespace Drydock
