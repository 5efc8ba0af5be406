// Holds the state of a view that lives on from frame to frame, as passes see it. pipeline/ keeps one for each view.
// Source: engine file ScenePrivate.h (FSceneViewState, FPreviousViewInfo); the names of kept textures and buffers are
// drydock's.
//
// There are two kinds. *History* changes the picture: the frame before is read, what the next one shall know is
// written, so that a frame is a function of its inputs and its history, and a sequence can be taken up again at any
// frame whose history was kept (ViewStateFile.h):
//
//     FRDGBufferRef Last = View.ViewState ? View.ViewState->RegisterLastBuffer(GraphBuilder, TEXT("Mine")) : nullptr;
//     ...
//     View.ViewState->KeepBuffer(GraphBuilder, TEXT("Mine"), Buffer);
//
// Textures and buffers that a frame does not keep are forgotten after it. A *cache* saves time and changes no picture
// (ViewCaches.h). A frame that does not use it lets go of it.
#pragma once

#include "RenderGraphFwd.h"
#include "RenderGraphResourcePool.h"
#include "RendererInterface.h"
#include "SceneView.h"
#include "ViewCaches.h"

#include <map>
#include <optional>
#include <string>

class FRDGBuilder;
struct FScreenPassTexture;

namespace Drydock
{

struct FHistoryTexture
{
	TRefCountPtr<IPooledRenderTarget> Target;
	FIntRect ViewRect; // texels beside it are undefined
};

/** Empty before the first frame. Copies share textures and buffers: nobody writes to them once their frame is over. */
struct FViewHistory
{
	bool bValid = false; // there was a frame
	uint32 FrameNumber = 0;
	std::optional<FSceneViewProjectionData> Projection; // where the camera was, without its jitter
	FVector2D Jitter = FVector2D(0.0, 0.0);             // of that projection, in clip space
	float PreExposure = 1.0f;                           // that the frame's colours were stored with
	std::map<std::string, FHistoryTexture> Textures;
	std::map<std::string, TRefCountPtr<FRDGPooledBuffer>> Buffers;
	bool bHasCaches = false; // the frame left something in a cache
};

/** Name of what an extension returned at SSRInput: the scene colour that next frame's reflections see. */
constexpr const char* CustomSSRInputName = "CustomSSRInput";

/** Name of the buffer with the frame's exposure (PostProcessEyeAdaptation.h): the next frame adapts from it. */
constexpr const char* EyeAdaptationName = "EyeAdaptation";

} // namespace Drydock

/** A view's state during a frame. */
class DRYDOCK_API FSceneViewState : public FSceneViewStateInterface
{
public:
	explicit FSceneViewState(uint32 InKey)
		: Key(InKey)
	{
	}
	uint32 GetViewKey() const override { return Key; }
	float GetLastEyeAdaptationExposure() const override;

	/** A frame begins with what the one before it left. */
	void BeginFrame(Drydock::FViewHistory InLast);

	/** It is over, and its graph has run: what it leaves. */
	Drydock::FViewHistory EndFrame();

	/** A texture that the frame before kept, in this frame's graph; not valid, or null, where that frame kept none of
	 * this name. */
	FScreenPassTexture RegisterLastTexture(FRDGBuilder& GraphBuilder, const TCHAR* Name) const;
	FRDGBufferRef RegisterLastBuffer(FRDGBuilder& GraphBuilder, const TCHAR* Name) const;

	/** Keeps a texture for the next frame. The graph must produce it. A second texture of one name replaces the first.
	 */
	void KeepTexture(FRDGBuilder& GraphBuilder, const TCHAR* Name, const FScreenPassTexture& Texture);
	void KeepBuffer(FRDGBuilder& GraphBuilder, const TCHAR* Name, FRDGBufferRef Buffer);

	const Drydock::FViewHistory& GetLast() const { return Last; }

	/** There is no frame before this one: nothing to adapt or reproject from. */
	bool IsFirstFrame() const { return !Last.bValid; }

	/** Time of this frame's world, in seconds; the difference to the frame before is 0 without a world. */
	float LastRenderTime = 0.0f;
	float LastRenderTimeDelta = 0.0f;

	/** The state that the next frame will find; textures and buffers are there once the graph has run. */
	Drydock::FViewHistory Next;

	/** The cache of this type: what the frame before left in it, or a new one. */
	template<typename T>
	T& FindOrMakeCache()
	{
		return Caches.FindOrMake<T>();
	}

private:
	uint32 Key;
	Drydock::FViewHistory Last;
	Drydock::FViewCaches Caches;
};
