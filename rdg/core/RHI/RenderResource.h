// Objects that own RHI resources for the length of the program, and the plain textures everyone may sample.
// Source: engine RenderResource.h, RenderUtils.h.
#pragma once

#include "RHICommandList.h"
#include "RHIStaticStates.h"

#include <utility>

class DRYDOCK_API FRenderResource
{
public:
	virtual ~FRenderResource();

	virtual void InitRHI(FRHICommandListBase&) { InitRHI(); }
	virtual void InitRHI() {}
	virtual void ReleaseRHI() {}

	/** Makes the resource's RHI objects unless they exist. */
	void InitResource(FRHICommandListBase& RHICmdList);
	void InitResource() { InitResource(FRHICommandListExecutor::GetImmediateCommandList()); }
	void ReleaseResource();
	bool IsInitialized() const { return bInitialized; }
	virtual FString GetFriendlyName() const { return FString(TEXT("undefined")); }

private:
	bool bInitialized = false;
};

/** At once: one thread plays all parts. */
inline void BeginInitResource(FRenderResource* Resource)
{
	Resource->InitResource();
}
inline void BeginReleaseResource(FRenderResource* Resource)
{
	Resource->ReleaseResource();
}

namespace Drydock
{

DRYDOCK_API void AddGlobalResource(FRenderResource& Resource);
DRYDOCK_API void RemoveGlobalResource(FRenderResource& Resource);

/** Makes those that exist and are not made yet. */
DRYDOCK_API void InitGlobalResources();

} // namespace Drydock

/** A resource that lives as long as its module; made before the first graph after the module was loaded, where the
 * engine makes it when the RHI starts. */
template<typename ResourceType>
class TGlobalResource : public ResourceType
{
public:
	template<typename... ArgumentTypes>
	explicit TGlobalResource(ArgumentTypes&&... Arguments)
		: ResourceType(std::forward<ArgumentTypes>(Arguments)...)
	{
		Drydock::AddGlobalResource(*this);
	}
	~TGlobalResource() override
	{
		Drydock::RemoveGlobalResource(*this);
		this->ReleaseResource();
	}
	TGlobalResource(const TGlobalResource&) = delete;
	TGlobalResource& operator=(const TGlobalResource&) = delete;
};

class DRYDOCK_API FTexture : public FRenderResource
{
public:
	virtual uint32 GetSizeX() const { return TextureRHI.IsValid() ? TextureRHI->GetSizeX() : 0; }
	virtual uint32 GetSizeY() const { return TextureRHI.IsValid() ? TextureRHI->GetSizeY() : 0; }
	FRHITexture* GetTextureRHI() const { return TextureRHI; }
	void ReleaseRHI() override { TextureRHI = nullptr; }

	FTextureRHIRef TextureRHI;
	FSamplerStateRHIRef SamplerStateRHI;
};

class DRYDOCK_API FTextureWithSRV : public FTexture
{
public:
	FShaderResourceViewRHIRef ShaderResourceViewRHI;
};

class DRYDOCK_API FVertexBuffer : public FRenderResource
{
public:
	void ReleaseRHI() override { VertexBufferRHI = nullptr; }
	FBufferRHIRef VertexBufferRHI;
};

class DRYDOCK_API FIndexBuffer : public FRenderResource
{
public:
	void ReleaseRHI() override { IndexBufferRHI = nullptr; }
	FBufferRHIRef IndexBufferRHI;
};

namespace Drydock
{

/** One of the plain textures below; converts to the engine's FTexture*. Made on first use, never freed. */
class DRYDOCK_API FPlainTexture
{
public:
	constexpr FPlainTexture(const TCHAR* InName, uint32 InColor)
		: Name(InName)
		, Color(InColor)
	{
	}

	FTextureWithSRV* Get() const;
	FTextureWithSRV* operator->() const { return Get(); }
	operator FTexture*() const { return Get(); }
	operator FTextureWithSRV*() const { return Get(); }

private:
	const TCHAR* Name;
	uint32 Color; // 0xAARRGGBB
	mutable FTextureWithSRV* Texture = nullptr;
};

} // namespace Drydock

/** 1x1, PF_B8G8R8A8. Black has alpha 255; transparent black 0. */
extern DRYDOCK_API const Drydock::FPlainTexture GWhiteTexture;
extern DRYDOCK_API const Drydock::FPlainTexture GBlackTexture;
extern DRYDOCK_API const Drydock::FPlainTexture GTransparentBlackTexture;
