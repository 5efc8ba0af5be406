// Maps the channels of a rendered frame to scene textures, in the formats and encodings of the engine: one table.
// Source: engine DeferredShadingCommon.ush and SceneTextures.cpp (formats, encodings); channels and their units:
// configs/scenes/README.md.
#pragma once

#include "Config/SceneUnits.h"
#include "CoreMinimal.h"
#include "PixelFormat.h"
#include "RHIDefinitions.h"
#include "SceneTextures.h"

#include <array>
#include <optional>
#include <vector>

namespace Drydock
{

/** A channel that a texture is made of; without one in the file its default holds, where there is one. */
struct FScenePackChannel
{
	const char* Name = nullptr; // null: this slot is not used
	std::optional<float> Default;
};

/** Values of one pixel, in the order of the slots. */
using FScenePackValues = std::array<float, 4>;

struct FScenePackContext
{
	float PreExposure = 1.0f;
	FIntPoint ViewSize = FIntPoint(1, 1); // pixels that velocity is relative to
	FSceneUnits Units = {};               // of the file
};

struct FScenePacking
{
	const char* Name; // of the texture
	EPixelFormat Format;
	ETextureCreateFlags Flags;
	void (*SetTexture)(FSceneTextures& SceneTextures, FRDGTextureRef Texture);
	std::array<FScenePackChannel, 4> Channels;
	FLinearColor (*Pack)(const FScenePackValues& Values, const FScenePackContext& Context);
	FLinearColor Outside; // what padding holds: nothing that a frame would
	/** At another resolution than the file's: the mean of the area under a pixel, as colour; otherwise its middle. */
	bool bMeanOfArea = false;
	/** There is such a texture only where the file, or scene.defaults, has one of its channels at least. */
	bool bOptional = false;
};

/** Scene colour first. */
DRYDOCK_API const std::vector<FScenePacking>& GetScenePackings();

/** Null when there is none of this name. */
DRYDOCK_API const FScenePacking* FindScenePacking(const std::string& Texture);

/** The packing of a texture of the file's own channels, one to four, as they stand: 32-bit floats. The strings must
 * outlive it. */
DRYDOCK_API FScenePacking MakeOwnScenePacking(const std::string& Texture, const std::vector<std::string>& Channels);

/** The channels that a value of scene.textures names, without blanks. */
DRYDOCK_API std::vector<std::string> SplitChannelNames(const std::string& Names);

/** Every channel that a scene can have, by the names that passes know. */
DRYDOCK_API const std::vector<std::string>& GetSceneChannelNames();

} // namespace Drydock
