// Holds the measurements of an effect, made on request: figures for run.json and pictures to look at.
#pragma once

#include "FinalPostProcessSettings.h"
#include "Picture/ImageFile.h"
#include "RenderTargetPool.h"

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace Drydock
{

/** One figure: a number, a count, or a row of counts. */
struct FFigure
{
	std::string Name;
	std::variant<double, uint64_t, std::vector<uint64_t>> Value;
};

/** Figures that belong together: an object of that name in run.json. */
struct FFigureGroup
{
	std::string Name;
	std::vector<FFigure> Figures;
};

/** A picture that an effect is judged by. */
struct FEffectPicture
{
	std::string Name; // of its member in run.json: "toonShadowBanding"
	std::string File; // without extension: "toon_shadow_banding"
	FImage Image;
	bool bLinear = true; // values, shown as a preview; else ready to look at
};

struct FEffectFigures
{
	std::vector<FFigureGroup> Groups;
	std::vector<FEffectPicture> Pictures;

	/** A number or count of a group; NaN where there is none of that name. */
	DRYDOCK_API double Get(const std::string& Group, const std::string& Figure) const;
};

/** A texture as it was at the end of the frame. */
struct FKeptTexture
{
	TRefCountPtr<IPooledRenderTarget> Texture;
	FIntRect Rect; // of the view
};

/** The inputs of an effect's measurement. */
struct FMeasureInputs
{
	const FFinalPostProcessSettings& Settings;
	float PreExposure = 1.0f;
	std::map<std::string, FKeptTexture> Textures;
};

} // namespace Drydock
