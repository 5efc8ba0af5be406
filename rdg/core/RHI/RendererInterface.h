// Declares the renderer's public interface: textures that outlive a graph, their description and their interface; the
// module. Source: engine RendererInterface.h.
#pragma once

#include "Delegates/Delegate.h"
#include "Modules/ModuleInterface.h"
#include "RHIResources.h"

/** A texture description with the pool's own spellings. */
struct FPooledRenderTargetDesc : FRHITextureDesc
{
	FPooledRenderTargetDesc() = default;
	FPooledRenderTargetDesc(const FRHITextureDesc& Desc, const TCHAR* InDebugName = TEXT("UnknownTexture"))
		: FRHITextureDesc(Desc)
		, DebugName(InDebugName)
	{
	}

	static FPooledRenderTargetDesc Create2DDesc(FIntPoint Size, EPixelFormat Format, FClearValueBinding ClearValue,
		ETextureCreateFlags Flags, ETextureCreateFlags TargetableFlags,
		bool bForceSeparateTargetAndShaderResource = false, uint16 NumMips = 1)
	{
		return FRHITextureDesc::Create2DDesc(
			Size, Format, ClearValue, Flags, TargetableFlags, bForceSeparateTargetAndShaderResource, NumMips);
	}

	bool Is2DTexture() const { return IsTexture2D(); }
	bool Is3DTexture() const { return IsTexture3D(); }
	bool IsCubemap() const { return IsTextureCube(); }
	bool IsArray() const { return IsTextureArray(); }

	const TCHAR* DebugName = TEXT("UnknownTexture");
};

inline FRHITextureDesc Translate(const FPooledRenderTargetDesc& Desc)
{
	return Desc;
}

/** The engine once had two textures per target; here both are the same. */
struct FSceneRenderTargetItem
{
	bool IsValid() const { return TargetableTexture.IsValid(); }
	FRHITexture* GetRHI() const { return TargetableTexture; }

	FTextureRHIRef TargetableTexture;
	FTextureRHIRef ShaderResourceTexture;
};

/** The ways in which the engine cuts a rectangle into triangles; here it is never cut. */
enum EDrawRectangleFlags : int
{
	EDRF_Default,
	EDRF_UseTriangleOptimization,
	EDRF_UseTesselatedIndexBuffer
};

/** A texture that a graph can register and extract. */
class DRYDOCK_API IPooledRenderTarget
{
public:
	virtual ~IPooledRenderTarget();

	virtual uint32 AddRef() const = 0;
	virtual uint32 Release() = 0;
	virtual uint32 GetRefCount() const = 0;

	/** Whether only the pool holds it. */
	virtual bool IsFree() const = 0;

	/** The pool will hand it out again. */
	virtual bool IsTracked() const = 0;

	virtual const FPooledRenderTargetDesc& GetDesc() const = 0;
	virtual FRHITexture* GetRHI() const = 0;
	virtual void SetDebugName(const TCHAR* Name) = 0;

	/** Bytes of memory. */
	virtual uint32 ComputeMemorySize() const = 0;

	FRHITexture* GetTargetableRHI() const { return GetRHI(); }
	FRHITexture* GetShaderResourceRHI() const { return GetRHI(); }
	FSceneRenderTargetItem GetRenderTargetItem() const { return {GetRHI(), GetRHI()}; }
};

class FGlobalShaderMap;
class FRDGBuilder;
class FRDGTexture;
class FViewInfo;
struct FSceneTextures;
struct FSceneTextureUniformParameters;
template<typename ParameterStructType>
class TRDGUniformBuffer;

DECLARE_MULTICAST_DELEGATE_TwoParams(FOnResolvedSceneColor, FRDGBuilder&, const FSceneTextures&);

/** A view as the delegates of the renderer see it. */
class FPostOpaqueRenderParameters
{
public:
	FIntRect ViewportRect; // of the scene textures
	FMatrix ViewMatrix;
	FMatrix ProjMatrix;
	FRDGTexture* ColorTexture = nullptr; // scene colour: what is drawn into it reaches post-processing
	FRDGTexture* DepthTexture = nullptr;
	FRDGTexture* NormalTexture = nullptr;     // GBufferA
	FRDGTexture* VelocityTexture = nullptr;   // null: the scene has none
	FRDGTexture* SmallDepthTexture = nullptr; // nobody makes it here
	FRDGBuilder* GraphBuilder = nullptr;
	const FViewInfo* View = nullptr;
	TRDGUniformBuffer<FSceneTextureUniformParameters>* SceneTexturesUniformParams = nullptr;
	const FGlobalShaderMap* GlobalShaderMap = nullptr;
	void* Uid = nullptr; // the view's own
};

DECLARE_MULTICAST_DELEGATE_OneParam(FOnPostOpaqueRender, FPostOpaqueRenderParameters&);
using FPostOpaqueRenderDelegate = FOnPostOpaqueRender::FDelegate;

/** The module "Renderer". */
class DRYDOCK_API IRendererModule : public IModuleInterface
{
public:
	/** Called for each view of a frame before GetResolvedSceneColorCallbacks. The scene file holds everything that the
	 * engine draws behind opaque things, too, such as fog and translucency. */
	FDelegateHandle RegisterPostOpaqueRenderDelegate(const FPostOpaqueRenderDelegate& Delegate)
	{
		return PostOpaqueRender.Add(Delegate);
	}
	void RemovePostOpaqueRenderDelegate(FDelegateHandle Handle) { PostOpaqueRender.Remove(Handle); }
	/** Called behind those. */
	FDelegateHandle RegisterOverlayRenderDelegate(const FPostOpaqueRenderDelegate& Delegate)
	{
		return OverlayRender.Add(Delegate);
	}
	void RemoveOverlayRenderDelegate(FDelegateHandle Handle) { OverlayRender.Remove(Handle); }
	/** Ours: the renderer calls both. */
	const FOnPostOpaqueRender& GetPostOpaqueRender() const { return PostOpaqueRender; }
	const FOnPostOpaqueRender& GetOverlayRender() const { return OverlayRender; }

	/** Called in each frame once its scene colour is there, before PrePostProcessPass_RenderThread. */
	FOnResolvedSceneColor& GetResolvedSceneColorCallbacks() { return ResolvedSceneColorCallbacks; }

private:
	FOnPostOpaqueRender PostOpaqueRender;
	FOnPostOpaqueRender OverlayRender;
	FOnResolvedSceneColor ResolvedSceneColorCallbacks;
};
