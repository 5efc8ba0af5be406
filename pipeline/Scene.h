// The rendered frame that goes in. Its channels are registered as external textures without memory; after culling, one
// read brings what surviving passes use. Source: drydock (channels and units: configs/scenes/README.md).
#pragma once

#include "Config.h"
#include "ImageFile.h"
#include "RHIResources.h"
#include "RenderGraphFwd.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** In the engine's axes: cm, left-handed, Z up; degrees. */
struct FSceneCamera
{
	FVector Location = FVector(0.0, 0.0, 0.0);
	double Pitch = 0.0;
	double Yaw = 0.0;
	double Roll = 0.0;
	double HorizontalFov = 90.0;
};

struct FSceneChannel
{
	std::string Name; // in the file
	bool bDecoded = false;
};

/** A scene texture that the compiled graph uses, and the first surviving pass that does. */
struct FNeededSceneTexture
{
	std::string Texture;
	std::string Pass;
};

/** Non-finite values found in an image. */
struct FNonFiniteCount
{
	size_t Count = 0;
	int FirstX = 0;
	int FirstY = 0;
};

class DRYDOCK_API FScene
{
public:
	/** Reads the header only. Throws FError: no scene in the config (exit code 2), a file that cannot be read (3),
	 * channel names that do not exist (2). */
	explicit FScene(const FConfig& Config);

	FIntPoint GetExtent() const { return FIntPoint(File.GetWidth(), File.GetHeight()); }

	/** From the header's drydock:camera_json; empty when there is none. */
	const std::optional<FSceneCamera>& GetCamera() const { return Camera; }

	/** Registers scene colour, PF_FloatRGBA; it has no memory until Load. */
	FRDGTextureRef RegisterSceneColor(FRDGBuilder& GraphBuilder);

	/** The registered texture, as the RHI has it; null before. */
	FRHITexture* GetSceneColor() const { return SceneColor; }

	/** Fills the textures named, from one read of the file. Scene colour is multiplied by PreExposure. Throws FError
	 * (exit code 3) when the file lacks a channel or is broken. */
	void Load(const std::vector<FNeededSceneTexture>& Needed, float PreExposure);

	/** What scene colour held that is not finite, before r.Drydock.NonFinite did anything about it. */
	const FNonFiniteCount& GetNonFinite() const { return NonFinite; }

	/** All channels of the file. */
	const std::vector<FSceneChannel>& GetChannels() const { return Channels; }

private:
	/** Where a channel of ours comes from: a plane of the file, or a constant. */
	struct FSource
	{
		int FileChannel = -1;
		float Default = 0.0f;
	};

	void CheckNames(const FConfig& Config) const;
	FSource FindSource(const std::string& Channel, const FNeededSceneTexture& Needed) const;
	void FillSceneColor(const std::vector<FSource>& Sources, float PreExposure);

	const FConfigScene& Config;
	std::string ConfigFile;
	FImageFile File;
	std::optional<FSceneCamera> Camera;
	std::vector<FSceneChannel> Channels;
	TRefCountPtr<FRHITexture> SceneColor;
	FNonFiniteCount NonFinite;
};

} // namespace Drydock
