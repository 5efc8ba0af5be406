// Small sequences for effects over frames: analytic scenes as a renderer with a jittered camera draws them, one sample
// a pixel. The exact mean of each pixel, which no renderer has, lies beside them.
#pragma once

#include "Scenes/AnalyticScene.h"

#include <string>
#include <vector>

namespace Drydock
{

struct FJitteredScene
{
	const char* Name; // "line"
	const char* Doc;  // what moves
	/** The scene of a frame, from 0 on, in a picture of this size. */
	FAnalyticFrame (*MakeFrame)(FIntPoint Size, int Frame);
	/** The frame at which the camera cuts; -1: none. */
	int CutFrame = -1;
};

/** line, point, occluder, cut, still. */
DRYDOCK_API const std::vector<FJitteredScene>& GetJitteredScenes();

/** The scene of that name, or null. */
DRYDOCK_API const FJitteredScene* FindJitteredScene(const std::string& Name);

/** The jitter of a frame in pixels, -0.5 to 0.5: points of Halton's sequence of bases 2 and 3, which begins again after
 * NumSamples frames. 1: none. */
DRYDOCK_API FVector2D GetHaltonJitter(int Frame, int NumSamples);

struct FJitteredSceneOptions
{
	const FJitteredScene* Scene = nullptr;
	FIntPoint Size = FIntPoint(160, 90);
	int NumFrames = 16;
	int NumSamples = 8; // of the jitter
};

/** Writes into Folder, for each frame from 1 on, NAME.####.exr with one sample a pixel, and NAME.truth.####.exr without
 * jitter and with the exact mean; and NAME.json and NAME.truth.json, which run them. Gives the files' names. Throws
 * FError (exit code 3) when a file cannot be written. */
DRYDOCK_API std::vector<std::string> WriteJitteredScene(
	const FJitteredSceneOptions& Options, const std::string& Folder);

} // namespace Drydock
